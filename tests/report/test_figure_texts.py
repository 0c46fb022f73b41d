"""Tests that no text of a figure of the report is cut at the edge, in either language."""

from pathlib import Path

import pytest
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.text import Text

from lispac.language import LANGUAGES, in_language
from lispac.report.document import undrawn_document
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
@pytest.mark.parametrize(("extent", "least"), [("short", 2), ("full", 6)])
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
