"""Maps of the distances between two lines on a plane, before and after the calibration."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from lispac.language import N_, gettext
from lispac.present.text_format import shortest_number
from lispac.present.validation import DistanceMapValues, ValidationPlane
from lispac.report.figures import (
    INK_COLOUR,
    SMALL_TEXT_SIZE,
    TEXT_SIZE,
    LocalisedFormatter,
    blank_figure,
    short_name,
    style_axes,
)
from lispac.report.text_width import cut_to_width, largest_fitting_font_size

Array = NDArray[np.float64]

PANEL_TITLES = N_("before"), N_("after")
BAR_TITLES = N_("Before (mm)"), N_("After (mm)")
"""Titles of the colour bars."""
FINER_BAR_TITLE = N_("After (mm), {factor} × finer")
COARSER_BAR_TITLE = N_("After (mm), {factor} × coarser")
"""Titles of the colour bar after, if the scales differ."""
MAX_COMMON_RATIO = 2.0
"""Largest ratio of the two colour scales for which both states have the larger one."""
COLOUR_MAP = "RdBu_r"
"""Colour map: red where the first line is nearer to the vessel, white where both coincide."""
SCALE_PERCENTILE = 98.0
"""Percentile of the absolute distances at the ends of the colour scale."""
MIN_COLOUR_LIMIT_M = 1e-4
"""Smallest distance at the ends of the colour scale, metres."""
PIXELS_PER_CELL = 10
"""Pixels along the side of a cell; a viewer would blur cells of a single pixel."""
INCHES_PER_BAR_TICK, MIN_BAR_TICKS, MAX_BAR_TICKS = 0.4, 2, 5
"""Width that the number of a tick of a colour bar needs, and the numbers of intervals."""
MIN_PANEL_HEIGHT = 0.5
"""Smallest height of a panel, inches."""
MARGIN_LEFT, MARGIN_RIGHT, COLUMN_SPACING = 0.8, 0.12, 0.34
MARGIN_TOP, MARGIN_TOP_ONE_ROW, ROW_SPACING, MARGIN_BOTTOM = 0.4, 0.8, 0.26, 0.9
"""Margins around and between the panels, inches; the top margin is larger if all pairs are in one
row."""
MAX_TEXT_SHARE = 0.95
"""Largest share of the distance between the centres of two panels that a text may fill."""
INCHES_PER_TICK, MIN_TICKS, MAX_TICKS = 0.3, 2, 4
"""Width that the number of a tick needs, and the numbers of ticks; a narrower map has one tick at
its right end."""
ONE_ROW_RATIO = 1.4
"""Ratio of height to width of a plane above which the maps of all its pairs are in one row."""


@dataclass(frozen=True)
class _Size:
    """Size of a figure of maps.

    Attributes
    ----------
    width : width of the figure, inches
    max_panel_height : largest height of a panel, inches
    max_tall_height : the same if the panels of all pairs are in one row
    """

    width: float
    max_panel_height: float
    max_tall_height: float


FULL_SIZE = _Size(6.3, 1.15, 3.2)
SMALL_SIZE = _Size(3.3, 0.75, 1.3)
ROW_SIZE = _Size(6.3, 1.7, 1.7)
MAX_SMALL_MAPS = 2
"""Largest number of pairs in a figure that is half as wide as a page."""


def map_figure_of(plane: ValidationPlane) -> Figure:
    """Maps of the signed distances on the plane, before and after, for each mapped pair of lines.

    A state with much smaller distances has a finer colour scale, so that they are visible; the
    title of its colour bar says so.
    """
    return _draw_maps(plane.name, plane.maps)


def small_map_figure_of(plane: ValidationPlane) -> Figure:
    """Maps of the pairs with the largest offset and distances after, half a page wide."""
    return _draw_maps(plane.name, _largest_maps(plane), SMALL_SIZE)


def map_row_figure_of(plane: ValidationPlane) -> Figure:
    """The maps of `small_map_figure_of` in one row, as wide as a page."""
    return _draw_maps(plane.name, _largest_maps(plane), ROW_SIZE, in_one_row=True)


def _largest_maps(plane: ValidationPlane) -> list[DistanceMapValues]:
    farthest = max(plane.maps, key=_offset_after, default=None)
    largest = sorted(
        plane.maps, key=lambda each: (each is farthest, _rms_after(each)), reverse=True
    )[:MAX_SMALL_MAPS]
    return [each for each in plane.maps if each in largest]


def _rms_after(values: DistanceMapValues) -> float:
    return float(np.sqrt(np.mean(np.square(values.after_m))))


def _offset_after(values: DistanceMapValues) -> float:
    return float(abs(np.median(values.after_m)))


def _draw_maps(
    name: str,
    maps: Sequence[DistanceMapValues],
    form: _Size = FULL_SIZE,
    *,
    in_one_row: bool = False,
) -> Figure:
    if not maps:
        figure = blank_figure(None, (form.width, 1.0))
        axes = figure.add_subplot()
        axes.set_axis_off()
        missing = gettext(
            "{plane}: this result contains no map. Run the validation again.",
            plane=short_name(name),
        )
        axes.text(
            0.5, 0.5, missing, ha="center", va="center", fontsize=TEXT_SIZE, color=INK_COLOUR,
            transform=axes.transAxes,
        )  # fmt: skip
        return figure
    sides = np.max([_map_size(each) for each in maps], axis=0)
    tall = in_one_row or bool(sides[1] > ONE_ROW_RATIO * sides[0])
    if tall:
        form = replace(form, max_panel_height=form.max_tall_height)
    figure, places = _map_panels(len(maps), sides, tall, form)
    limits = _colour_limits(maps)
    named, size = _fitted_pair_names(maps, tall, figure, places[0][0])
    across, up = gettext("Horizontal (m)"), gettext("Up (m)")
    for k, (pair, row) in enumerate(zip(maps, places, strict=True)):
        for axes, values, end, state in zip(
            row, _cell_grids(pair), limits, PANEL_TITLES, strict=True
        ):
            _draw_map(axes, values, end, pair.cell_m)
            _set_ticks(axes, values.shape, pair.cell_m, figure.get_size_inches())
            # The labels of small panels in one row would overlap; they have one in common.
            last, first = not tall and k == len(maps) - 1, axes is row[0] and not (tall and k)
            style_axes(axes, across if last else "", up if first else "")
            axes.grid(False)
            title = gettext(state) if not k else ""
            if tall:
                title = f"{gettext(state)}\n{named[k]}"
            elif first:
                axes.set_ylabel(f"{named[k]}\n{up}", fontsize=size, color=INK_COLOUR)
            axes.set_title(title, fontsize=size if tall else SMALL_TEXT_SIZE, color=INK_COLOUR)
    for column, title in enumerate(_bar_titles(limits)):
        _draw_colour_bar(figure, [row[column] for row in places], title)
    if tall:
        left, right = (axes.get_position(original=True) for axes in (places[0][0], places[-1][-1]))
        below = left.y0 - 0.24 / figure.get_size_inches()[1]
        figure.text(
            (left.x0 + right.x1) / 2, below, across, ha="center", va="top",
            fontsize=SMALL_TEXT_SIZE, color=INK_COLOUR,
        )  # fmt: skip
    figure.suptitle(
        short_name(name),
        x=0.01,
        y=0.99,
        ha="left",
        va="top",
        fontsize=TEXT_SIZE + 1,
        color=INK_COLOUR,
    )
    return figure


def _fitted_pair_names(
    maps: Sequence[DistanceMapValues], tall: bool, figure: Figure, panel: Axes
) -> tuple[list[str], float]:
    """Name of each pair, and the font size at which no name overlaps its neighbour."""
    box, inches = panel.get_position(original=True), figure.get_size_inches()
    available = (
        box.width * inches[0] + COLUMN_SPACING if tall else box.height * inches[1] + ROW_SPACING
    )
    available *= MAX_TEXT_SHARE
    others = [gettext(state) for state in PANEL_TITLES] if tall else [gettext("Up (m)")]
    for template in (N_("{line}\n− {other}"), N_("{line}\n−\n{other}")):
        named = [
            gettext(
                template,
                line=cut_to_width(short_name(each.line_a), available),
                other=cut_to_width(short_name(each.line_b), available),
            )
            for each in maps
        ]
        if (
            size := largest_fitting_font_size(named, available, SMALL_TEXT_SIZE)
        ) == SMALL_TEXT_SIZE:
            break
    return named, min(size, largest_fitting_font_size(others, available, SMALL_TEXT_SIZE))


def _map_panels(
    pairs: int, sides: Array, tall: bool, form: _Size
) -> tuple[Figure, list[list[Axes]]]:
    """Panels for each pair: one row for each pair, or a single row if the plane is tall."""
    down, along = (1, 2 * pairs) if tall else (pairs, 2)
    wide = (form.width - MARGIN_LEFT - MARGIN_RIGHT - (along - 1) * COLUMN_SPACING) / along
    high = float(np.clip(sides[1] / sides[0] * wide, MIN_PANEL_HEIGHT, form.max_panel_height))
    top = MARGIN_TOP_ONE_ROW if tall else MARGIN_TOP
    size = form.width, top + down * high + (down - 1) * ROW_SPACING + MARGIN_BOTTOM
    figure = blank_figure(None, size)
    # Positions are computed here: a layout engine takes a second to measure all texts.
    figure.set_layout_engine("none")

    def panel(row: int, column: int) -> Axes:
        left = MARGIN_LEFT + column * (wide + COLUMN_SPACING)
        low = size[1] - top - high - row * (high + ROW_SPACING)
        return figure.add_axes(
            (left / form.width, low / size[1], wide / form.width, high / size[1])
        )

    panels = [[panel(row, column) for column in range(along)] for row in range(down)]
    if not tall:
        return figure, panels
    # The panels of one state are adjacent, above their colour bar.
    (one,) = panels
    return figure, [[one[k], one[pairs + k]] for k in range(pairs)]


def _draw_colour_bar(figure: Figure, panels: Sequence[Axes], title: str) -> None:
    """Draw the common colour bar of some panels below them, in millimetres."""
    boxes = [axes.get_position(original=True) for axes in panels]
    left, right = min(box.x0 for box in boxes), max(box.x1 for box in boxes)
    inch = 1 / figure.get_size_inches()[1]
    spare = 0.08 * (right - left)
    place = (left + spare, min(box.y0 for box in boxes) - 0.52 * inch, right - left - 2 * spare)
    bar = figure.colorbar(
        panels[0].images[0], cax=figure.add_axes((*place, 0.09 * inch)), orientation="horizontal",
        extend="both", format=LocalisedFormatter(),
    )  # fmt: skip
    bar.set_label(title, fontsize=SMALL_TEXT_SIZE, color=INK_COLOUR)
    ticks = int(place[2] * figure.get_size_inches()[0] / INCHES_PER_BAR_TICK)
    bar.locator = MaxNLocator(int(np.clip(ticks, MIN_BAR_TICKS, MAX_BAR_TICKS)))
    bar.update_ticks()
    bar.ax.tick_params(labelsize=SMALL_TEXT_SIZE, colors=INK_COLOUR)


def _draw_map(axes: Axes, values: Array, end: float, cell: float) -> None:
    rows, columns = values.shape
    sharp = np.repeat(np.repeat(1000 * values, PIXELS_PER_CELL, axis=0), PIXELS_PER_CELL, axis=1)
    axes.imshow(
        sharp, cmap=COLOUR_MAP, vmin=-1000 * end, vmax=1000 * end, origin="lower",
        extent=(0.0, columns * cell, 0.0, rows * cell), aspect="equal", interpolation="none",
    )  # fmt: skip
    axes.set_facecolor("#eeeeee")


def _set_ticks(axes: Axes, shape: tuple[int, ...], cell: float, inches: Array) -> None:
    """Set as many ticks across as their numbers have space for."""
    rows, columns = shape
    # Equal scales make the map of a narrow plane narrower than its panel.
    box = axes.get_position(original=True)
    width = min(box.width * inches[0], box.height * inches[1] * columns / rows)
    if width >= INCHES_PER_TICK * MIN_TICKS:
        axes.locator_params(axis="x", nbins=min(MAX_TICKS, int(width / INCHES_PER_TICK)))
    else:
        tenths = int(10 * columns * cell)
        axes.set_xticks([tenths / 10 if tenths else columns * cell])


def _cell_grids(pair: DistanceMapValues) -> tuple[Array, Array]:
    """Distances of the cells before and after as grids (up, across), NaN for empty cells."""
    columns, rows = (
        np.floor(np.array(v) / pair.cell_m).astype(int) for v in _cell_coordinates(pair)
    )
    grids = []
    for values in (pair.before_m, pair.after_m):
        grid = np.full((rows.max() + 1, columns.max() + 1), np.nan)
        grid[rows, columns] = values
        grids.append(grid)
    return grids[0], grids[1]


def _cell_coordinates(pair: DistanceMapValues) -> tuple[tuple[float, ...], tuple[float, ...]]:
    return pair.across_m, pair.up_m


def _map_size(pair: DistanceMapValues) -> Array:
    """Width and height of the area covered by a map, metres."""
    return np.array([max(values) + pair.cell_m / 2 for values in _cell_coordinates(pair)])


def _colour_limit(values: Sequence[float]) -> float:
    return max(float(np.percentile(np.abs(values), SCALE_PERCENTILE)), MIN_COLOUR_LIMIT_M)


def _colour_limits(maps: Sequence[DistanceMapValues]) -> tuple[float, float]:
    """Ends of the colour scales before and after, metres; equal unless they differ much."""
    before, after = (
        max(_colour_limit(getattr(each, state)) for each in maps)
        for state in ("before_m", "after_m")
    )
    if max(before, after) <= MAX_COMMON_RATIO * min(before, after):
        return max(before, after), max(before, after)
    return before, after


def _bar_titles(limits: tuple[float, float]) -> list[str]:
    """Titles of the colour bars, with the ratio of the scales if they differ."""
    before, after = limits
    titles = [gettext(title) for title in BAR_TITLES]
    if before != after:
        ratio = before / after
        title = FINER_BAR_TITLE if ratio > 1 else COARSER_BAR_TITLE
        titles[1] = gettext(title, factor=shortest_number(float(f"{max(ratio, 1 / ratio):.2g}")))
    return titles
