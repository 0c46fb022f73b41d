"""Plan view of the distances between lines."""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from lispac.language import gettext
from lispac.report.figures import (
    INK_COLOUR,
    SMALL_TEXT_SIZE,
    TEXT_SIZE,
    LocalisedFormatter,
    blank_figure,
    style_axes,
)
from lispac.validation.line_differences import LineDifference

COLOUR_MAP = "viridis_r"
"""Colour map: light where lines coincide, dark where they differ; suits any colour vision."""
SCALE_PERCENTILE = 95.0
"""Percentile of the absolute distances at the end of the colour scale."""


def line_difference_map(pairs: Sequence[LineDifference], figure: Figure | None = None) -> Figure:
    """Plan view of the places compared, coloured by the distance between the two lines.

    If several places lie above each other, as on a wall, the largest distance is visible.

    Parameters
    ----------
    pairs : at least one pair, with at least one place
    """
    figure = blank_figure(figure, (6.3, 5.6))
    axes = figure.subplots()
    place = np.concatenate([pair.place for pair in pairs])
    size = 1000 * np.abs(np.concatenate([pair.distance for pair in pairs]))
    order = np.argsort(size)
    end = max(float(np.percentile(size, SCALE_PERCENTILE)), 0.1)
    drawn = axes.scatter(
        -place[order, 1], place[order, 0], c=size[order], s=5, cmap=COLOUR_MAP, vmin=0.0, vmax=end,
        linewidths=0, rasterized=True,
    )  # fmt: skip
    axes.set_aspect("equal", adjustable="datalim")
    style_axes(axes, gettext("East (m)"), gettext("North (m)"))
    bar = figure.colorbar(drawn, ax=axes, extend="max", shrink=0.8, format=LocalisedFormatter())
    bar.set_label(gettext("Distance between two lines (mm)"), fontsize=TEXT_SIZE, color=INK_COLOUR)
    bar.ax.tick_params(labelsize=SMALL_TEXT_SIZE, colors=INK_COLOUR)
    return figure
