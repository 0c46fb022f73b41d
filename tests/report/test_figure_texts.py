"""Tests that no text of a figure of the report is cut at the edge, in either language."""

from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from matplotlib.axis import Axis
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text

from lispac.language import LANGUAGES, in_language
from lispac.present.text_format import shortest_number
from lispac.report.distance_maps import map_figure_of, map_row_figure_of
from lispac.report.document import undrawn_document
from lispac.report.figures import set_fitting_ticks, style_axes
from lispac.report.histograms import small_histograms_figure_of
from lispac.report.options import Extent, ReportOptions
from tests.support.long_runs import others_long
from tests.support.report_sample import sample_content, sample_project, undrawn_pictures

DESCENT = 2.0
"""Pixels at 100 dpi: space for descenders below a text of 7 points, which is always included."""


def cut_texts(figure: Figure) -> list[str]:
    """Titles, labels and legends that extend beyond the figure.

    Labels of ticks are left out: matplotlib keeps some outside the axes and does not draw them.
    """
    FigureCanvasAgg(figure).draw()
    ticks = {label for axes in figure.axes for axis in (axes.xaxis, axes.yaxis)
             for label in axis.get_ticklabels(which="both")}  # fmt: skip
    found = []
    for text in set(figure.findobj(Text)) - ticks:
        box = text.get_window_extent()
        low, high = min(box.x0, box.y0), max(box.x1 - figure.bbox.x1, box.y1 - figure.bbox.y1)
        if text.get_visible() and text.get_text().strip() and max(-low, high) > DESCENT:
            found.append(text.get_text())
    return found


@pytest.mark.parametrize("language", others_long(LANGUAGES, lambda language: language == "fr"))
@pytest.mark.parametrize(("extent", "least"), others_long([("full", 6), ("short", 2)]))
def test_no_text_of_a_figure_is_cut(
    language: str, extent: Extent, least: int, tmp_path: Path
) -> None:
    content = sample_content(sample_project(tmp_path))
    with in_language(language):
        document = undrawn_document(content, {}, ReportOptions(extent=extent))
        blocks = [*document.summary, *(b for s in document.sections for b in s.blocks)]
        drawn = [each.draw(*each.values) for each in undrawn_pictures(blocks)]
        figures = [
            each for made in drawn for each in ([made] if isinstance(made, Figure) else made)
        ]
        assert len(figures) >= least
        assert {text for figure in figures for text in cut_texts(figure)} == set()


def shown_labels(axis: Axis) -> list[Text]:
    low, high = sorted(axis.get_view_interval())
    labels = zip(axis.get_ticklocs(), axis.get_ticklabels(), strict=True)
    return [label for value, label in labels if low <= value <= high and label.get_text()]


@pytest.mark.parametrize("size", [(0.35, 0.3), (0.5, 0.4), (0.8, 0.6), (1.2, 0.7)])
@pytest.mark.parametrize("high", [0.9, 1.8, 2.1, 3.3, 8.6, 47.0, 164.0, 660.0])
def test_a_short_axis_has_three_labels_that_do_not_overlap(
    size: tuple[float, float], high: float
) -> None:
    figure = Figure(figsize=(3.0, 3.0))
    axes = figure.add_axes((0.3, 0.3, size[0] / 3.0, size[1] / 3.0))
    axes.set(xlim=(0.0, high), ylim=(0.0, high))
    style_axes(axes, "", "")
    for axis in (axes.xaxis, axes.yaxis):
        set_fitting_ticks(axis, shortest_number)
    FigureCanvasAgg(figure).draw()
    for axis in (axes.xaxis, axes.yaxis):
        labels = shown_labels(axis)
        boxes = [label.get_window_extent() for label in labels]
        assert not any(a.overlaps(b) for a, b in pairwise(boxes))
        # Three numbers like 20 or 0.25 do not fit side by side on the narrowest axis.
        assert len(labels) >= (2 if axis is axes.xaxis and size[0] < 0.5 else 3)
        values = [float(label.get_text()) for label in labels]
        assert np.ptp(np.diff(values)) == pytest.approx(0.0, abs=1e-9 * high)


@pytest.mark.parametrize("extent", ["short", "full"])
def test_small_histograms_and_maps_have_three_ticks_on_each_axis(
    extent: Extent, tmp_path: Path
) -> None:
    content = sample_content(sample_project(tmp_path))
    document = undrawn_document(content, {}, ReportOptions(extent=extent))
    blocks = [b for s in document.sections for b in s.blocks]
    small = [
        each for each in undrawn_pictures(blocks)
        if getattr(each.draw, "func", each.draw)
        in (small_histograms_figure_of, map_figure_of, map_row_figure_of)
    ]  # fmt: skip
    assert small
    for each in small:
        figure = each.draw(*each.values)
        assert isinstance(figure, Figure)
        FigureCanvasAgg(figure).draw()
        for axes in figure.axes:
            if axes.get_xlim() != (0.0, 1.0):  # not a colour bar
                assert min(len(shown_labels(axes.xaxis)), len(axes.get_yticks())) >= 3
