"""Fixtures of the tests of the report."""

from functools import lru_cache

import pytest
from matplotlib.figure import Figure

from lispac.report import figures, pdf

POINTS_PER_INCH = 72


@pytest.fixture(scope="session", autouse=True)
def _keep_figures() -> None:
    """Keep all figures that were drawn: most reports of the tests contain the same ones."""
    drawing = figures.render_pictures.__wrapped__
    figures.render_pictures = lru_cache(maxsize=None)(drawing)


def _rectangle(figure: Figure) -> bytes:
    """Return a grey rectangle of the size of a figure, as SVG."""
    width, height = (f"{side:g}" for side in POINTS_PER_INCH * figure.get_size_inches())
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}pt" height="{height}pt" '
        f'viewBox="0 0 {width} {height}"><rect width="100%" height="100%" fill="gray"/></svg>'
    ).encode()


_render_rectangles = lru_cache(maxsize=None)(figures.render_pictures.__wrapped__)


@pytest.fixture
def rectangles(monkeypatch: pytest.MonkeyPatch) -> None:
    """Replace figures by rectangles of their sizes, for tests of what is around the figures.

    Drawing takes most of the time of a report, and the pages depend only on the sizes.
    """
    monkeypatch.setattr(figures, "svg_of", _rectangle)
    monkeypatch.setattr(figures, "render_pictures", _render_rectangles)


@pytest.fixture
def usual_gaps(monkeypatch: pytest.MonkeyPatch) -> None:
    """Typeset each report once instead of with smaller gaps too, for tests of other things."""
    monkeypatch.setattr(pdf, "SECTION_GAPS", pdf.SECTION_GAPS[:1])
