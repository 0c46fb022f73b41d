"""Tests that legends, titles and labels of histograms and plans overlap nothing."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text

from lispac.language import in_language
from lispac.present.checking.absolute import AbsoluteCheckValues
from lispac.report.absolute_figure import reference_distance_figure
from lispac.report.figures import site_figure
from lispac.report.histograms import histogram_figure
from lispac.report.short_report import PLAN_SIZE_INCHES
from lispac.validation.comparison_results import PlaneComparison
from tests.support.long_runs import others_long
from tests.support.report_sample import sample_project
from tests.validation.test_absolute_warnings import check


def overlaps(figure: Figure) -> list[tuple[str, str]]:
    """Return the pairs of texts and legends of a figure that overlap, or exceed the figure."""
    (legend,) = figure.legends
    boxes = {"legend": legend.get_window_extent()}
    for k, axes in enumerate(figure.axes):
        boxes[f"axes {k}"] = axes.bbox
        for name, axis, limits in (
            ("x", axes.xaxis, axes.get_xlim()),
            ("y", axes.yaxis, axes.get_ylim()),
        ):
            shown = [
                tick.label1
                for tick in axis.get_major_ticks()
                if limits[0] <= tick.get_loc() <= limits[1]
            ]
            for label in (axis.label, *shown):
                if label.get_text():
                    boxes[f"{name}{k} {label.get_text()}"] = label.get_window_extent()
        if axes.get_title():
            boxes[f"title {k}"] = axes.title.get_window_extent()
    page = figure.bbox.padded(1)
    outside = [
        (name, "edge") for name, box in boxes.items()
        if not (page.contains(box.x0, box.y0) and page.contains(box.x1, box.y1))
    ]  # fmt: skip
    return outside + [
        (a, b) for a, b in combinations(boxes, 2)
        if a[:2] != b[:2] and boxes[a].padded(-0.5).overlaps(boxes[b].padded(-0.5))
    ]  # fmt: skip


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
    assert overlaps(figure) == []


@pytest.fixture(scope="module")
def comparison(tmp_path_factory: pytest.TempPathFactory) -> PlaneComparison:
    return sample_project(tmp_path_factory.mktemp("legends")).validation[0]


@pytest.mark.parametrize("size", [(6.3, 2.6), (4.2, 2.6), (2.6, 4.5)])
@pytest.mark.parametrize("language", others_long(["en", "fr"], lambda language: language == "fr"))
@pytest.mark.parametrize("share", others_long([False, True]))
def test_the_texts_of_a_histogram_are_complete_and_apart(
    comparison: PlaneComparison, size: tuple[float, float], language: str, share: bool
) -> None:
    figure = Figure(size, layout="constrained")
    canvas = FigureCanvasAgg(figure)
    with in_language(language):
        histogram_figure(comparison, figure, share=share)
        axes = figure.axes[0]
        top = 1000 * float(comparison.bin_edges[-1])
        for low, high in ((0.0, top), (0.0, top / 4), (top / 8, top / 2), (0.0, top / 30)):
            axes.set_xlim(low, high)
            canvas.draw()  # computes the layout, as in the window
            assert overlaps(figure) == []
            for patch in axes.patches:
                values, edges, _ = patch.get_data()
                visible = values[(edges[:-1] < high) & (edges[1:] > low)]
                assert max(visible, default=0.0) <= axes.get_ylim()[1]


def test_names_of_a_site_plan_cover_no_mark_and_no_other_name() -> None:
    north_south, east_west = [(-30.0, 0.0), (30.0, 0.0)], [(0.0, -30.0), (0.0, 30.0)]
    tracks = {
        "L1": north_south, "L2": north_south[::-1], "L3": east_west, "L4": east_west[::-1],
    }  # fmt: skip
    targets = {"T1": (3.0, -8.0, 0.0), "T2": (1.0, -8.5, 0.0), "T3": (-20.0, 0.5, 0.0)}
    planes = {"V1": (2.0, -9.0, 0.0), "V2": (2.5, -6.0, 0.0)}
    figure = site_figure(tracks, targets, planes, size=PLAN_SIZE_INCHES)
    FigureCanvasAgg(figure).draw()
    (axes,) = figure.axes
    names = [text for text in axes.texts if text.get_text()]
    assert {name.get_text() for name in names} == {*tracks, *targets, *planes}
    boxes = [Text.get_window_extent(name) for name in names]
    seeds = [(-west, north) for north, west, _ in (*targets.values(), *planes.values())]
    marks = axes.transData.transform(seeds)
    assert not [(a, b) for k, a in enumerate(boxes) for b in boxes[k + 1 :] if a.overlaps(b)]
    assert not [(box, mark) for box in boxes for mark in marks if box.contains(*mark)]
