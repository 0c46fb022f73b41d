"""Space for a legend inside a histogram, so that it covers no bar."""

from collections.abc import Sequence

import numpy as np
from matplotlib.axes import Axes
from numpy.typing import NDArray

from lispac.report.text_width import POINTS_PER_INCH, text_width

Array = NDArray[np.float64]

HANDLE_WIDTH, ROW_HEIGHT, MARGINS_HEIGHT = 4.5, 1.35, 2.5
"""Width of a legend without its text, height of a row, and sum of the margins above and below, in
font sizes."""
AXES_POSITION = {"left": 0.09, "right": 0.99, "bottom": 0.17, "top": 0.9}
"""Assumed position of the axes in the figure until the figure is laid out."""
HEADROOM_RATIO = 1.08
"""Smallest ratio of the upper limit of the axes to the highest bar."""
MAX_LEGEND_SHARE = 0.6
"""Largest share of the height of the axes that is kept free; a taller legend covers bars."""


def top_below_legend(
    axes: Axes, edges: Array, heights: Array, words: Sequence[str], size: float
) -> float:
    """Upper limit of the axes at which no bar reaches a legend at the upper right.

    Parameters
    ----------
    axes : axes with their final horizontal limits
    edges, heights : ndarrays of shape (k + 1,) and (k,)
        Edges and heights of the bars; the highest bars of several histograms.
    words : texts of the legend, one for each histogram
    size : font size of the legend, points
    """
    low, high = sorted(axes.get_xlim())
    visible = (edges[:-1] < high) & (edges[1:] > low)
    highest = float(heights[visible].max(initial=0.0))
    if not words:
        return HEADROOM_RATIO * highest or 1.0
    figure = axes.get_figure(root=True)
    box, em = axes.get_position(), size / POINTS_PER_INCH
    assert figure is not None
    across, up = figure.get_size_inches() * (box.width, box.height)
    wide = max(text_width(text, size) for text in words) + HANDLE_WIDTH * em
    lines = sum(text.count("\n") + 1 for text in words)
    tall = min((ROW_HEIGHT * lines + MARGINS_HEIGHT) * em / up, MAX_LEGEND_SHARE)
    left = high - min(wide / across, 1.0) * (high - low)
    below_legend = float(heights[visible & (edges[1:] > left)].max(initial=0.0))
    return max(HEADROOM_RATIO * highest, below_legend / (1.0 - tall)) or 1.0
