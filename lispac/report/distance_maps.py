"""Maps of the distances between two lines on a plane, before and after the calibration.

All maps of a plane have one colour scale, so that before and after can be compared. It is
logarithmic beyond a limit, so that small distances after the calibration are visible beside large
ones before it. The offset of the two lines is given above each map.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import ceil

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize, SymLogNorm
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from lispac.language import N_, gettext
from lispac.present.checking.distance_maps import DistanceMapValues
from lispac.present.checking.validation import ValidationPlane
from lispac.present.text_format import shortest_number, signed_number
from lispac.report.figures import (
    INK_COLOUR,
    SMALL_TEXT_SIZE,
    TEXT_SIZE,
    LocalisedFormatter,
    blank_figure,
    set_fitting_ticks,
    short_name,
    style_axes,
)
from lispac.report.text_width import cut_to_width, largest_fitting_font_size, text_width

Array = NDArray[np.float64]

CAPTION = N_("{plane}: maps of the distances between two lines, before and after the calibration.")
LARGEST_CAPTION = N_(
    "{plane}: maps of {shown:n} of {total:n} pairs of lines, those with the largest offsets after "
    "the calibration."
)
SOME_CAPTION = N_("{plane}: maps of {shown:n} of {total:n} pairs of lines.")
MAP_TITLES = N_("before\n{offset} mm"), N_("after\n{offset} mm")
"""Titles of a map: its state and the offset of the lines."""
BAR_TITLE = N_("Distance (mm)")
"""Title of the colour bar."""
COLOUR_MAP = "RdBu_r"
"""Colour map: red where the first line is nearer to the vessel."""
SCALE_PERCENTILE = 98.0
"""Percentile of the absolute distances at the ends of the colour scale."""
MIN_COLOUR_LIMIT_M = 1e-4
"""Smallest distance at the ends of the colour scale, metres."""
PIXELS_PER_CELL = 10
"""Pixels along the side of a cell; a viewer would blur cells of a single pixel."""
LINEAR_LIMIT_MM = 20.0
"""Distance beyond which the colour scale is logarithmic, millimetres."""
LOG_TICKS_MM = 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0
"""Distances of which the largest on a colour bar has a number, besides the linear limit, mm."""
MAX_BAR_TICKS = 5
"""Largest number of intervals of a colour bar."""
MARGIN_RIGHT, MAP_SPACING = 0.08, 0.24
"""Margin at the right of a pair of maps, and the distance between its maps, inches."""
MARGIN_LEFT, MARGIN_TOP, MARGIN_BOTTOM = 5.0, 5.0, 4.2
"""Margins around a pair of maps, as multiples of the size of the texts in them."""
MIN_MAP_HEIGHT = 0.3
"""Smallest height of the space for a map, inches."""
WIDTH, BAR_WIDTH = 6.3, 0.85
"""Width of a figure of maps, and of the space at its right for the colour bar, inches."""
BAR_THICKNESS, BAR_MARGIN = 0.09, 0.15
"""Thickness of the colour bar and the margins at its ends, inches."""
MIN_HEIGHT, MAX_HEIGHT, MAX_ROW_HEIGHT = 1.3, 4.2, 2.3
"""Smallest height of a figure of maps, for the title of the colour bar, and largest height of a
figure of all maps of a plane and of one row of maps, inches."""
MAX_MAPS_IN_ROW = 2
"""Largest number of pairs of maps in one row."""


def _inches(texts: float) -> float:
    """Length of so many sizes of the texts, inches."""
    return texts * SMALL_TEXT_SIZE / 72.0


def map_figure_of(plane: ValidationPlane) -> Figure:
    """Maps of the signed distances on the plane, before and after, for each mapped pair of lines.

    Both maps of a pair have the same axes, and all maps the same scale and colours.
    """
    return _draw_maps(plane, _largest_maps(plane), MAX_HEIGHT)


def map_row_figure_of(plane: ValidationPlane) -> Figure:
    """Maps of the pairs with the largest offsets after the calibration, in one row."""
    return _draw_maps(plane, _largest_maps(plane, MAX_MAPS_IN_ROW), MAX_ROW_HEIGHT)


def map_caption(plane: ValidationPlane, count: int | None = None) -> str:
    """Caption of up to ``count`` maps of a plane, which says of which pairs of lines they are.

    Results of earlier versions may contain maps of other pairs than those with the largest offsets.
    """
    shown = _largest_maps(plane, count)
    mapped = {(each.line_a, each.line_b) for each in shown}
    others = [
        pair.absolute_offset_m or 0.0
        for pair in plane.pairs
        if (pair.line_a, pair.line_b) not in mapped
    ]
    if not others:
        text = CAPTION
    elif min(abs(_offsets_of(plane, each)[1]) for each in shown) >= max(others):
        text = LARGEST_CAPTION
    else:
        text = SOME_CAPTION
    return gettext(text, plane=plane.name, shown=len(shown), total=len(plane.pairs))


def _largest_maps(plane: ValidationPlane, count: int | None = None) -> list[DistanceMapValues]:
    """Up to ``count`` maps, the largest offset of the two lines after the calibration first."""
    return sorted(plane.maps, key=lambda each: -abs(_offsets_of(plane, each)[1]))[:count]


def _offsets_of(plane: ValidationPlane, values: DistanceMapValues) -> tuple[float, float]:
    """Offset of the two lines of a map before and after, metres, as in the tables.

    The median of the map if its cells, which may be wider, are the only places with distances.
    """
    found = plane.offsets_m(values.line_a, values.line_b)
    return found or (float(np.median(values.before_m)), float(np.median(values.after_m)))


@dataclass(frozen=True, eq=False)
class _Map:
    """Signed distances in the smallest rectangle of cells.

    Attributes
    ----------
    grid : distances (up, across), metres, NaN for cells without distance
    extent : left, right, lower and upper edge, metres
    title : state and offset
    """

    grid: Array
    extent: tuple[float, float, float, float]
    title: str

    @property
    def sides(self) -> Array:
        """Width and height, metres."""
        left, right, low, high = self.extent
        return np.array([right - left, high - low])


def _maps_of(pair: DistanceMapValues, offsets_m: tuple[float, float]) -> tuple[_Map, _Map]:
    """Maps before and after; both have the same cells."""
    columns, rows = (
        np.floor(np.array(each) / pair.cell_m).astype(int) for each in (pair.across_m, pair.up_m)
    )
    left, low = columns.min(), rows.min()
    right, high = columns.max() + 1, rows.max() + 1
    extent = (left * pair.cell_m, right * pair.cell_m, low * pair.cell_m, high * pair.cell_m)

    def of_state(distances_m: Sequence[float], offset_m: float, title: str) -> _Map:
        grid = np.full((high - low, right - left), np.nan)
        grid[rows - low, columns - left] = distances_m
        return _Map(grid, extent, gettext(title, offset=signed_number(1000 * offset_m, 1)))

    before, after = map(of_state, (pair.before_m, pair.after_m), offsets_m, MAP_TITLES)
    return before, after


@dataclass(frozen=True)
class _Arrangement:
    """Places of the pairs of maps in a figure.

    Attributes
    ----------
    columns, rows : numbers of pairs side by side and of their rows
    scale : inches on the paper for each metre
    slot : width of a map with its title, inches
    """

    columns: int
    rows: int
    scale: float
    slot: float


def _arrange(pairs: Sequence[tuple[_Map, _Map]], max_height: float) -> _Arrangement:
    """Arrangement with the largest maps whose titles do not overlap."""
    sides = np.max([before.sides for before, _ in pairs], axis=0)
    titles = [text for pair in pairs for each in pair for text in each.title.split("\n")]
    least = 1.02 * max(text_width(text, SMALL_TEXT_SIZE) for text in titles)
    left, above, below = map(_inches, (MARGIN_LEFT, MARGIN_TOP, MARGIN_BOTTOM))
    found = []
    for columns in range(1, len(pairs) + 1):
        rows = ceil(len(pairs) / columns)
        width = ((WIDTH - BAR_WIDTH) / columns - left - MAP_SPACING - MARGIN_RIGHT) / 2
        height = max_height / rows - above - below
        has_space = width >= least, height >= MIN_MAP_HEIGHT
        scale = float(min(width / sides[0], max(height, MIN_MAP_HEIGHT) / sides[1]))
        slot = min(max(scale * float(sides[0]), least), width)
        found.append((has_space, scale, _Arrangement(columns, rows, scale, slot)))
    return max(found, key=lambda each: each[:2])[-1]


def _draw_maps(
    plane: ValidationPlane, values: Sequence[DistanceMapValues], max_height: float
) -> Figure:
    if not values:
        return _missing_maps(plane.name)
    pairs = [_maps_of(each, _offsets_of(plane, each)) for each in values]
    arrangement = _arrange(pairs, max_height)
    figure, places = _map_axes(pairs, arrangement)
    limit = _colour_limit(pairs)
    pair_width = 2 * arrangement.slot + MAP_SPACING
    for k, (pair, row, each) in enumerate(zip(pairs, places, values, strict=True)):
        for drawn, axes in zip(pair, row, strict=True):
            _draw_map(axes, drawn, limit)
            is_left = axes is row[0]
            is_outer = is_left and k % arrangement.columns == 0
            style_axes(axes, "", gettext(each.axis_titles[1]) if is_outer else "")
            axes.yaxis.label.set_fontsize(SMALL_TEXT_SIZE)
            axes.grid(False)
            for axis in (axes.xaxis, axes.yaxis):
                set_fitting_ticks(axis, shortest_number)
            axes.tick_params(labelsize=SMALL_TEXT_SIZE, labelleft=is_left)
            axes.set_title(drawn.title, fontsize=SMALL_TEXT_SIZE, color=INK_COLOUR, pad=3)
        _draw_pair_texts(figure, row, each, pair_width)
    _draw_colour_bar(figure, places[0][0])
    return figure


def _missing_maps(name: str) -> Figure:
    figure = blank_figure(None, (WIDTH, 1.0))
    axes = figure.add_subplot()
    axes.set_axis_off()
    missing = gettext(
        "{plane}: this result contains no map. Run the validation again.", plane=short_name(name)
    )
    axes.text(
        0.5, 0.5, missing, ha="center", va="center", fontsize=TEXT_SIZE, color=INK_COLOUR,
        transform=axes.transAxes,
    )  # fmt: skip
    return figure


def _map_axes(
    pairs: Sequence[tuple[_Map, _Map]], arrangement: _Arrangement
) -> tuple[Figure, list[tuple[Axes, Axes]]]:
    """Figure as high as its maps, and axes with the shape of each map."""
    shapes = arrangement.scale * np.array([before.sides for before, _ in pairs])
    left, above, below = map(_inches, (MARGIN_LEFT, MARGIN_TOP, MARGIN_BOTTOM))
    high = float(shapes[:, 1].max()) + above + below
    height = max(arrangement.rows * high, MIN_HEIGHT)
    figure = blank_figure(None, (WIDTH, height))
    # Positions are computed here: a layout engine takes a second to measure all texts.
    figure.set_layout_engine("none")
    pitch = (WIDTH - BAR_WIDTH) / arrangement.columns
    used = left + 2 * arrangement.slot + MAP_SPACING
    places = []
    for k, (width, up) in enumerate(shapes):
        row, column = divmod(k, arrangement.columns)
        top = (height + arrangement.rows * high) / 2 - row * high - above
        first = column * pitch + (pitch - used - MARGIN_RIGHT) / 2 + left
        before, after = (
            figure.add_axes((
                (first + state * (arrangement.slot + MAP_SPACING) + (arrangement.slot - width) / 2)
                / WIDTH,
                (top - up) / height,
                width / WIDTH,
                up / height,
            ))
            for state in (0, 1)
        )  # fmt: skip
        places.append((before, after))
    return figure, places


def _draw_map(axes: Axes, drawn: _Map, limit: float) -> None:
    sharp = np.repeat(
        np.repeat(1000 * drawn.grid, PIXELS_PER_CELL, axis=0), PIXELS_PER_CELL, axis=1
    )
    axes.imshow(
        sharp, cmap=COLOUR_MAP, norm=_colour_norm(1000 * limit), origin="lower",
        extent=drawn.extent, aspect="equal", interpolation="none",
    )  # fmt: skip
    axes.set_facecolor("#dddddd")


def _draw_pair_texts(
    figure: Figure, row: tuple[Axes, Axes], values: DistanceMapValues, width: float
) -> None:
    """Draw the names of the lines above both maps, and the label of the axis below them."""
    first, second = (short_name(each) for each in (values.line_a, values.line_b))
    text = f"{first} − {second}"
    if largest_fitting_font_size([text], width, SMALL_TEXT_SIZE) < SMALL_TEXT_SIZE - 1:
        half = width / 2 - 0.1
        text = f"{cut_to_width(first, half)} − {cut_to_width(second, half)}"
    left, right = (axes.get_position(original=True) for axes in row)
    figure.text(
        (left.x0 + right.x1) / 2, left.y1 + _inches(3.7) / figure.get_size_inches()[1], text,
        ha="center", va="bottom", color=INK_COLOUR, fontweight="bold",
        fontsize=largest_fitting_font_size([text], 0.9 * width, SMALL_TEXT_SIZE),
    )  # fmt: skip
    # The labels of two narrow maps would overlap; they have one in common.
    figure.text(
        (left.x0 + right.x1) / 2, left.y0 - _inches(2.4) / figure.get_size_inches()[1],
        gettext(values.axis_titles[0]), ha="center", va="top", color=INK_COLOUR,
        fontsize=SMALL_TEXT_SIZE,
    )  # fmt: skip


def _draw_colour_bar(figure: Figure, axes: Axes) -> None:
    """Draw the colour bar of all maps at the right, in millimetres."""
    _, height = figure.get_size_inches()
    left, length = WIDTH - BAR_WIDTH + 0.1, height - 2 * BAR_MARGIN
    place = left / WIDTH, BAR_MARGIN / height, BAR_THICKNESS / WIDTH, length / height
    bar = figure.colorbar(
        axes.images[0], cax=figure.add_axes(place), extend="both", format=LocalisedFormatter()
    )
    bar.set_label(gettext(BAR_TITLE), fontsize=SMALL_TEXT_SIZE, color=INK_COLOUR, labelpad=2)
    if isinstance(bar.norm, SymLogNorm):
        end = bar.norm.vmax or 0.0
        positive = [LINEAR_LIMIT_MM, *[tick for tick in LOG_TICKS_MM if tick <= end][-1:]]
        bar.set_ticks([*(-tick for tick in reversed(positive)), 0.0, *positive])
        bar.ax.minorticks_off()
    else:
        bar.locator = MaxNLocator(MAX_BAR_TICKS)
        bar.update_ticks()
    bar.ax.tick_params(labelsize=SMALL_TEXT_SIZE, colors=INK_COLOUR)


def _colour_norm(limit: float) -> Normalize:
    """Colour scale up to a distance in millimetres, symmetrical about zero."""
    if limit <= 2 * LINEAR_LIMIT_MM:
        return Normalize(-limit, limit)
    return SymLogNorm(LINEAR_LIMIT_MM, vmin=-limit, vmax=limit)


def _colour_limit(pairs: Sequence[tuple[_Map, _Map]]) -> float:
    """End of the colour scale of all maps, metres."""
    grids = [each.grid for pair in pairs for each in pair]
    largest = max(float(np.nanpercentile(np.abs(grid), SCALE_PERCENTILE)) for grid in grids)
    return max(largest, MIN_COLOUR_LIMIT_M)
