"""Tests that legends of histograms do not overlap the bars."""

from dataclasses import replace

import numpy as np
import pytest
from matplotlib.axes import Axes
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.patches import StepPatch

from lispac.present.absolute import AbsoluteCheckValues
from lispac.report.absolute_figure import reference_distance_figure
from lispac.report.histograms import histogram_figure
from lispac.validation.comparison_results import PlaneComparison
from tests.support.report_sample import sample_project
from tests.validation.test_absolute_warnings import check


def covered(axes: Axes) -> list[float]:
    """Return by how many pixels bars overlap the texts of the legend."""
    legend = axes.get_legend()
    assert legend is not None
    boxes = [text.get_window_extent() for text in legend.get_texts()]
    boxes += [handle.get_window_extent() for handle in legend.get_patches()]
    left, low = min(box.x0 for box in boxes), min(box.y0 for box in boxes)
    right = min(max(box.x1 for box in boxes), axes.bbox.x1)
    left = max(left, axes.bbox.x0)  # bars are clipped at the end of the axes
    assert low < axes.bbox.y1
    found = []
    for patch in (p for p in axes.patches if isinstance(p, StepPatch)):
        values, edges, _ = patch.get_data()
        across = axes.transData.transform(np.column_stack([edges, np.zeros(len(edges))]))[:, 0]
        up = axes.transData.transform(np.column_stack([edges[:-1], values]))[:, 1]
        under = (across[:-1] < right) & (across[1:] > left) & (up > low)
        found += (up[under] - low).tolist()
    return found


@pytest.mark.parametrize("peak", [5, 30, 45, 59])
def test_the_legend_of_reference_distances_covers_no_bar(peak: int) -> None:
    counts = np.full(60, 20)
    counts[peak] = 4000
    found = replace(
        AbsoluteCheckValues.of(check({})), bin_edges_m=tuple(np.linspace(-0.4, 0.2, 61)),
        counts_before=tuple(np.full(60, 300)), counts_after=tuple(counts),
    )  # fmt: skip
    figure = reference_distance_figure(found)
    FigureCanvasAgg(figure).draw()
    assert covered(figure.axes[0]) == []


@pytest.fixture(scope="module")
def comparison(tmp_path_factory: pytest.TempPathFactory) -> PlaneComparison:
    return sample_project(tmp_path_factory.mktemp("legends")).validation[0]


@pytest.mark.parametrize("size", [(6.3, 2.5), (4.5, 2.6)])
@pytest.mark.parametrize("share", [False, True])
def test_the_legend_covers_no_bar_after_zooming(
    comparison: PlaneComparison, size: tuple[float, float], share: bool
) -> None:
    figure = Figure(size, layout="constrained")
    canvas = FigureCanvasAgg(figure)
    histogram_figure(comparison, figure, share=share)
    figure.set_size_inches(size)
    axes = figure.axes[0]
    top = 1000 * float(comparison.bin_edges[-1])
    for low, high in ((0.0, top), (0.0, top / 4), (top / 8, top / 2), (0.0, top / 30)):
        canvas.draw()  # computes the layout, as in the window
        axes.set_xlim(low, high)
        canvas.draw()
        assert covered(axes) == []
