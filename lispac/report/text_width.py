"""Width of a text from the advance widths of its letters, without drawing it.

matplotlib measures a text by drawing it, which takes a second for a figure with many panels.
"""

from collections.abc import Sequence
from functools import cache
from pathlib import Path

import matplotlib
from matplotlib.ft2font import FT2Font

MIN_FONT_SIZE = 4.5
"""Smallest font size, points."""
POINTS_PER_INCH = 72.0


def text_width(text: str, size: float) -> float:
    """Width of the widest line of a text, inches, in the default font; ``size`` in points."""
    longest = max(sum(map(_letter_advance, line)) for line in text.split("\n"))
    return size / POINTS_PER_INCH * longest


def largest_fitting_font_size(texts: Sequence[str], width: float, size: float) -> float:
    """Largest font size at which all texts fit in ``width``, from `MIN_FONT_SIZE` to ``size``.

    At `MIN_FONT_SIZE` a text may still be wider.

    Parameters
    ----------
    texts
    width : float, inches
    size : float, points

    Returns
    -------
    float, points
    """
    widest = max(text_width(text, size) for text in texts)
    return max(MIN_FONT_SIZE, min(size, size * width / widest)) if widest else size


def cut_to_width(text: str, width: float) -> str:
    """Text of one line, cut at its end to fit in ``width`` at `MIN_FONT_SIZE`.

    Parameters
    ----------
    text
    width : float, inches
    """
    kept = len(text)
    while (
        kept
        and text_width(shown := text[:kept] + "\u2026" * (kept < len(text)), MIN_FONT_SIZE) > width
    ):
        kept -= 1
    return shown if kept else text[:1]


@cache
def _letter_advance(letter: str) -> float:
    """Advance width of a letter, as a share of the font size."""
    font = _font()
    font.set_size(64.0, POINTS_PER_INCH)
    return float(font.load_char(ord(letter)).linearHoriAdvance) / 65536 / 64.0


def _font() -> FT2Font:
    # A new object for each use, since a font must not be shared by two threads.
    return FT2Font(str(Path(matplotlib.get_data_path()) / "fonts" / "ttf" / "DejaVuSans.ttf"))
