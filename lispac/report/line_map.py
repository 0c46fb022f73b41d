"""Plan view of the distances between lines."""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure
from numpy.typing import NDArray

from lispac.language import gettext
from lispac.report.figures import (
    INK_COLOUR,
    SMALL_TEXT_SIZE,
    TEXT_SIZE,
    LocalisedFormatter,
    blank_figure,
    draw_north_arrow,
    style_axes,
)
from lispac.validation.line_differences import LineDifference

Array = NDArray[np.float64]

COLOUR_MAP = "viridis_r"
"""Colour map: light where lines coincide, dark where they differ; suits any colour vision."""
SCALE_PERCENTILE = 95.0
"""Percentile of the absolute distances at the end of the colour scale."""


def line_difference_map(
    pairs: Sequence[LineDifference],
    figure: Figure | None = None,
    *,
    shown: Sequence[LineDifference] | None = None,
    title: str = "",
) -> Figure:
    """Plan view of the places compared, coloured by the distance between the two lines.

    If several places lie above each other, as on a wall, the largest distance is visible. A site
    that is longer from north to south than the figure is high has north at the right. An arrow
    points to the north.

    Parameters
    ----------
    pairs : at least one pair, with at least one place; they determine extent and colour scale
    shown : the part of them that is drawn; all by default
    """
    figure = blank_figure(figure, (6.3, 5.6))
    axes = figure.subplots()
    all_places, all_sizes = _places_and_sizes(pairs)
    place, size = (all_places, all_sizes) if shown is None else _places_and_sizes(shown)
    order = np.argsort(size)
    end = max(float(np.percentile(all_sizes, SCALE_PERCENTILE)), 0.1)
    across, upward, titles = 1, 0, (gettext("East (m)"), gettext("North (m)"))
    sign = -1.0
    if _is_turned(all_places, figure):
        across, upward, titles = 0, 1, (gettext("North (m)"), gettext("West (m)"))
        sign = 1.0
    drawn = axes.scatter(
        sign * place[order, across], place[order, upward], c=size[order], s=5, cmap=COLOUR_MAP,
        vmin=0.0, vmax=end, linewidths=0, rasterized=True,
    )  # fmt: skip
    axes.update_datalim(np.column_stack([sign * all_places[:, across], all_places[:, upward]]))
    axes.autoscale_view()
    axes.set_aspect("equal", adjustable="datalim")
    style_axes(axes, *titles)
    draw_north_arrow(axes, is_right=across == 0)
    if title:
        axes.set_title(title, fontsize=TEXT_SIZE, color=INK_COLOUR, loc="left", parse_math=False)
    bar = figure.colorbar(drawn, ax=axes, extend="max", shrink=0.8, format=LocalisedFormatter())
    bar.set_label(gettext("Distance between two lines (mm)"), fontsize=TEXT_SIZE, color=INK_COLOUR)
    bar.ax.tick_params(labelsize=SMALL_TEXT_SIZE, colors=INK_COLOUR)
    return figure


def _places_and_sizes(pairs: Sequence[LineDifference]) -> tuple[Array, Array]:
    """Places of some pairs, shape (n, 3), metres, and absolute distances, shape (n,), mm."""
    size = 1000 * np.abs(np.concatenate([pair.distance for pair in pairs]))
    return np.concatenate([pair.place for pair in pairs]), size


def _is_turned(place: Array, figure: Figure) -> bool:
    """Whether the map is larger with north at the right than at the top."""
    north, west = (max(float(np.ptp(place[:, axis])), 1e-9) for axis in (0, 1))
    width, height = figure.get_size_inches()
    return bool(min(width / north, height / west) > min(width / west, height / north))
