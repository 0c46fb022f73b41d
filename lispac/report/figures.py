"""Plots as matplotlib Figures, for the report and the window.

Each function draws into the given figure, or into a new one. Styles are set on the artists and not
in the global settings of matplotlib, so that several threads can draw at the same time.
"""

import pickle
from collections.abc import Callable, Mapping, Sequence
from functools import cache, lru_cache, partial
from io import BytesIO
from itertools import pairwise
from math import ceil, floor, log10
from operator import attrgetter
from pathlib import Path

import matplotlib
import numpy as np
from matplotlib import rc_context
from matplotlib.artist import Artist
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.figure import Figure
from matplotlib.ft2font import FT2Font
from matplotlib.ticker import Locator, ScalarFormatter
from matplotlib.transforms import Transform, offset_copy
from numpy.typing import ArrayLike, NDArray

from lispac.language import current_language, degree_signs, gettext, in_language
from lispac.present.angles import CORRELATION_FORMAT
from lispac.present.line_colours import LINE_COLOURS, NEGATIVE_COLOUR, POSITIVE_COLOUR
from lispac.present.survey.survey_data import LineValues, PickedPlane
from lispac.present.tables import unit_text
from lispac.present.targets.sightings import POS_COMPONENTS, SightingValues
from lispac.present.text_format import fixed_number, localised_number
from lispac.present.text_format import title as value_title
from lispac.report.label_placement import Label, Track, draw_labels
from lispac.report.text_width import POINTS_PER_INCH, text_width

Array = NDArray[np.float64]

BEFORE_COLOUR, AFTER_COLOUR = "#5b9bd5", "#7a3e0c"
"""Colours of values with the prior and with the estimated boresight, light and dark in a print
without colours."""
MAIN_COLOUR, OTHER_COLOUR = "#3b75af", "#9c5a1e"
"""Colours of other marks and curves."""
INK_COLOUR, GRID_COLOUR = "#333333", "#dddddd"
"""Colours of texts and curves, and of grid lines."""
TRACK_OFFSET_PT = 1.4
"""Offset of a drawn track to starboard, points, which separates lines in opposite directions."""

TEXT_SIZE, SMALL_TEXT_SIZE = 8.0, 7.0
"""Font sizes of axis labels and of details, points."""
MAX_SIGHTINGS_PER_FIGURE = 26
"""Largest number of sightings in a bar chart, which is then half as high as a page."""
MAX_POS_ERRORS_PER_FIGURE = 22
"""The same in a figure of POS errors, whose rows are lower."""

SIMPLE_STEPS, OTHER_STEPS = (1.0, 2.0, 2.5, 5.0), (1.5, 3.0, 4.0, 6.0, 8.0)
"""Steps of ticks up to powers of ten; the others are used if none of the simple ones fits."""
MIN_TICKS, MAX_TICKS = 3, 6
"""Smallest number of ticks that a short axis has if they fit, and the largest."""
TICK_GAP = 0.3
"""Smallest gap between two tick labels, as a share of their font size."""

MAX_LABEL_LENGTH = 24
"""Largest number of characters of a name in a figure."""

WIDE_FIGURE = 5.2
"""Smallest width of a figure whose legend has several columns, inches; a window may be narrower."""
PLAN_MARGIN = 0.05
"""Space around the site, as a share of its extent."""

MAX_TITLE_SHARE = 0.95
"""Largest share of the width of the figure that a title in one line fills."""
LABELLED_SHARE = 0.7
"""Share of the width of a figure of correlations for the columns, and so for their labels."""
HEADROOM_RATIO = 1.08
"""Ratio of the upper limit of the axes to the highest bar of a histogram."""


def correlation_figure_of(
    names: Sequence[str],
    correlation: ArrayLike,
    figure: Figure | None = None,
) -> Figure:
    """Correlations between estimated values; names as in `AdjustmentResult.estimated`.

    A new figure has square cells and a title; a given one is filled.
    """
    matrix = np.asarray(correlation)
    side = max(2.8, 0.9 + 0.42 * len(names))
    is_new = figure is None
    figure = blank_figure(figure, (side + 0.6, side))
    axes = figure.add_subplot()
    shades = LinearSegmentedColormap.from_list(
        "correlation", [NEGATIVE_COLOUR, "white", POSITIVE_COLOUR]
    )
    image = axes.imshow(matrix, cmap=shades, vmin=-1, vmax=1, aspect="equal" if is_new else "auto")
    for (row, column), value in np.ndenumerate(matrix):
        axes.text(
            column,
            row,
            CORRELATION_FORMAT.text(value),
            ha="center",
            va="center",
            color=INK_COLOUR,
            fontsize=SMALL_TEXT_SIZE,
        )
    labels = [value_title(name) for name in names]
    axes.set_xticks(range(len(names)), labels)
    column_width = LABELLED_SHARE * float(figure.get_size_inches()[0]) / len(names)
    if max(text_width(label, TEXT_SIZE) for label in labels) > column_width:
        for label in axes.get_xticklabels():
            label.set(rotation=40, ha="right", rotation_mode="anchor")
    axes.set_yticks(range(len(names)), labels)
    axes.tick_params(length=0, labelsize=TEXT_SIZE, colors=INK_COLOUR)
    axes.spines[:].set_visible(False)
    bar = figure.colorbar(image, ax=axes, shrink=0.85, format=LocalisedFormatter())
    bar.ax.tick_params(labelsize=SMALL_TEXT_SIZE, colors=INK_COLOUR)
    if is_new:
        axes.set_title(gettext("Correlation"), fontsize=TEXT_SIZE + 1, color=INK_COLOUR)
    return figure


def line_colour(place: int) -> tuple[float, ...]:
    """Colour of a survey line by its place in the project, for matplotlib."""
    return tuple(part / 255 for part in LINE_COLOURS[place % len(LINE_COLOURS)])


def site_figure(
    tracks: Mapping[str, ArrayLike],
    targets: Mapping[str, Sequence[float]],
    validation: Mapping[str, Sequence[float]],
    figure: Figure | None = None,
    size: tuple[float, float] = (6.3, 3.6),
) -> Figure:
    """Plan view of the tracks of the lines, the targets and the validation planes; north is up.

    Parameters
    ----------
    size : width and height of a new figure, inches
    tracks : north and west, shape (k, 2), metres, by name of the line
    targets, validation : seeds (north, west, up), metres, by name; up is not drawn
    """
    figure = blank_figure(figure, size)
    axes = figure.add_subplot()
    labels: list[Label] = []
    drawn: list[Track] = []
    for k, (name, points) in enumerate(tracks.items()):
        places = np.asarray(points, dtype=float) * [1.0, -1.0]
        track = _draw_track(axes, places[:, ::-1], line_colour(k))
        if track is None:
            north, east = places[0].tolist()
            labels.append(_label(name, (east, north), INK_COLOUR))
        else:
            drawn.append(track)
            labels.append(_label(name, track.points[0], INK_COLOUR, track.offset))
    for seeds, marker, colour, title in (
        (targets, "s", "#bb2222", gettext("target")),
        (validation, "^", "#111111", gettext("validation plane")),
    ):
        _draw_seeds(axes, seeds, marker, colour, title)
        labels += [_label(name, (-seed[1], seed[0]), colour) for name, seed in seeds.items()]
    draw_labels(axes, labels, drawn)
    if tracks or targets or validation:
        # Space for names and arrows; margins would be reduced for the equal scale of both axes
        low, high = axes.dataLim.get_points()
        space = PLAN_MARGIN * (high - low)
        axes.update_datalim([low - space, high + space])
    axes.set_aspect("equal", adjustable="datalim")
    style_axes(axes, gettext("East (m)"), gettext("North (m)"))
    if targets or validation:  # the lines have their names beside them
        figure.legend(
            loc="outside lower center",
            ncols=2,
            fontsize=SMALL_TEXT_SIZE,
            frameon=False,
            labelcolor=INK_COLOUR,
        )
    return figure


def site_figure_of(
    lines: Sequence[LineValues],
    planes: Sequence[PickedPlane],
    size: tuple[float, float] = (6.3, 3.6),
) -> Figure:
    """Draw `site_figure` from the values of a report."""
    return site_figure(
        {line.name: line.track_local_m for line in lines if len(line.track_local_m) > 0},
        {plane.name: plane.seed_local_m for plane in planes if plane.role == "target"},
        {plane.name: plane.seed_local_m for plane in planes if plane.role == "validation"},
        size=size,
    )


def residual_figures_of(sightings: Sequence[SightingValues]) -> list[Figure]:
    """RMS of each sighting before and after the calibration, in parts with the same scales."""
    largest = [
        max((rms(each) for each in sightings), default=0.0)
        for rms in (attrgetter("rms_before_m"), attrgetter("rms_after_m"))
    ]
    figures = []
    for part in _parts_of(sightings):
        labels = [f"{short_name(s.target)}  {short_name(s.line)}" for s in part]
        values = [s.rms_before_m for s in part], [s.rms_after_m for s in part]
        figures.append(_before_after_bars(labels, values, largest))
    return figures


def pos_error_figures_of(sightings: Sequence[SightingValues]) -> list[Figure]:
    """Draw the estimated POS errors with their prior, in parts with one scale."""
    widest = _pos_error_ranges(sightings)
    return [
        _draw_pos_errors(None, part, widest)
        for part in _parts_of(sightings, MAX_POS_ERRORS_PER_FIGURE)
    ]


def pos_error_figure(sightings: Sequence[SightingValues], figure: Figure) -> Figure:
    """Draw `pos_error_figures_of` into one figure."""
    return _draw_pos_errors(figure, sightings, _pos_error_ranges(sightings))


def _pos_error_ranges(sightings: Sequence[SightingValues]) -> Array:
    """Half the width of the panel of each component, millimetres and thousandths of a degree."""
    found = [each.pos_error for each in sightings if each.pos_error is not None]
    error, prior, after = (
        np.abs(rows)
        for rows in (
            [(*e.error_m, *e.error_deg) for e in found],
            [(*e.sigma_m, *e.sigma_deg) for e in found],
            [(*e.sigma_after_m, *e.sigma_after_deg) for e in found],
        )
    )
    widest: Array = 1150 * np.maximum(2 * prior, error + 2 * after).max(axis=0)
    return widest


def pos_errors_height(sightings: int) -> float:
    """Height of a figure in which the names of sightings do not overlap, inches."""
    return 0.75 + 0.17 * sightings


def _parts_of(
    sightings: Sequence[SightingValues], most: int = MAX_SIGHTINGS_PER_FIGURE
) -> list[Sequence[SightingValues]]:
    """Sightings divided evenly into parts of at most ``most``, for figures of half a page.

    A target with few sightings is not divided.
    """
    total = len(sightings)
    count = max(1, -(-total // most))
    first = [0, *(k for k in range(1, total) if sightings[k].target != sightings[k - 1].target)]
    even = [total * k // count for k in range(1, count)]
    ends = [0, *(min(first, key=lambda k: (abs(k - end), k)) for end in even), total]
    if any(not 0 < end - start <= most for start, end in pairwise(ends)):
        ends = [0, *even, total]
    return [sightings[start:end] for start, end in pairwise(ends)]


def _draw_pos_errors(
    figure: Figure | None, sightings: Sequence[SightingValues], widest: Array
) -> Figure:
    """Draw the errors with their 2 sigma and prior 2 sigma intervals.

    Each sighting has a row, and each component of the error a panel, with half the width
    ``widest``, shape (6,), millimetres and thousandths of a degree.
    """
    figure = blank_figure(figure, (6.3, pos_errors_height(len(sightings))))
    panels = figure.subplots(1, 6, sharey=True)
    errors = [each.pos_error for each in sightings if each.pos_error is not None]
    prior, after = (
        1000 * np.array([[*metres, *degrees] for metres, degrees in pairs])
        for pairs in (
            [(e.sigma_m, e.sigma_deg) for e in errors],
            [(e.sigma_after_m, e.sigma_after_deg) for e in errors],
        )
    )
    at = np.arange(len(sightings))
    for axes, component in zip(panels, POS_COMPONENTS, strict=True):
        k, name = component.place, component.title
        # NaN where the data do not determine the error
        values = 1000 * np.array([component.error_of(each) for each in sightings], dtype=float)
        axes.barh(at, 4 * prior[:, k], left=-2 * prior[:, k], height=1.0, color="#e4e7ec")
        beyond = np.abs(values) > 2 * prior[:, k]
        within = np.abs(values) <= 2 * prior[:, k]
        for own, colour in ((within, MAIN_COLOUR), (beyond, "#bb2222")):
            axes.errorbar(
                values[own], at[own], xerr=2 * after[own, k], fmt="o", markersize=2.6,
                color=colour, elinewidth=0.8,
            )  # fmt: skip
        axes.axvline(0, color="#999999", linewidth=0.6)
        axes.set_xlim(-widest[k], widest[k])
        axes.locator_params(axis="x", nbins=3)
        style_axes(axes, unit_text("mm" if k < 3 else "mdeg"), "")
        axes.grid(False)
        axes.set_title(gettext(name), fontsize=TEXT_SIZE, color=INK_COLOUR)
        axes.tick_params(axis="y", length=0)
    panels[0].set_yticks(at, [f"{short_name(s.target)}  {short_name(s.line)}" for s in sightings])
    panels[0].set_ylim(len(sightings) - 0.5, -0.5)
    return figure


def svg_of(figure: Figure) -> bytes:
    """Convert a figure to reproducible SVG with letters as outlines, which require no font."""
    stream = BytesIO()
    with rc_context({"svg.hashsalt": "lispac", "svg.fonttype": "path"}):
        # `savefig` would draw the figure twice and take twice the time.
        FigureCanvasSVG(figure).print_svg(  # type: ignore[no-untyped-call]
            stream, metadata={"Date": None, "Creator": None}
        )
    return stream.getvalue()


def svg_pictures(
    draw: Callable[..., Figure | Sequence[Figure]], *values: object
) -> tuple[bytes, ...]:
    """Figures that ``draw`` creates from values of a report, as SVG, in the language in use.

    Creating a report consists mainly of drawing. The last figures are therefore cached: all formats
    of a report use the same figures, and the next report uses those whose values did not change.
    """
    if isinstance(draw, partial):  # two partial functions of one function are never equal
        function, arguments = draw.func, ((*draw.args, *values), draw.keywords)
    else:
        function, arguments = draw, (values, {})
    return render_pictures(function, pickle.dumps(arguments), current_language())


@lru_cache(maxsize=64)  # enough for the figures of a few reports, which take some megabytes
def render_pictures(
    draw: Callable[..., Figure | Sequence[Figure]], arguments: bytes, language: str
) -> tuple[bytes, ...]:
    """Figures that ``draw`` creates from pickled arguments, as SVG in a language; cached."""
    with in_language(language), degree_signs():
        positional, keywords = pickle.loads(arguments)
        made = draw(*positional, **keywords)
        figures = [made] if isinstance(made, Figure) else made
        return tuple(map(svg_of, figures))


def is_wide(figure: Figure) -> bool:
    """Whether a figure has space for a legend of several columns."""
    return bool(figure.get_size_inches()[0] >= WIDE_FIGURE)


def blank_figure(figure: Figure | None, size: tuple[float, float]) -> Figure:
    """The given figure without its content, or a new one of this size in inches."""
    if figure is None:
        return Figure(figsize=size, layout="constrained")
    figure.clear()
    figure.set_layout_engine("constrained")  # required for legends outside the axes
    return figure


def draw_title_and_legend(
    figure: Figure, title: str, handles: Sequence[Artist], texts: Sequence[str]
) -> None:
    """Draw a title and a legend above the axes, where they cover neither bars nor tick labels."""
    legend = figure.legend(
        handles, texts, loc="outside upper left", ncols=len(texts) if is_wide(figure) else 1,
        fontsize=SMALL_TEXT_SIZE, frameon=False, labelcolor=INK_COLOUR, alignment="left",
        title=_fitted_title(title, float(figure.get_size_inches()[0])),
        title_fontsize=TEXT_SIZE + 1,
    )  # fmt: skip
    legend.get_title().set_color(INK_COLOUR)


def _fitted_title(title: str, width: float) -> str:
    """Title with line breaks after its last or all commas if it is wider than ``width`` inches."""
    for text in (title, ",\n".join(title.rsplit(", ", 1))):
        if text_width(text, TEXT_SIZE + 1) <= MAX_TITLE_SHARE * width:
            return text
    return title.replace(", ", ",\n")


def draw_north_arrow(axes: Axes, *, is_right: bool = False) -> None:
    """Draw an arrow to the north in the upper right corner of a map.

    Parameters
    ----------
    is_right : whether north is at the right and not at the top
    """
    points = ((-14.0, -44.0), (-14.0, -20.0), (-14.0, -12.0))
    tail, tip, letter = (
        offset_copy(
            axes.transAxes,
            axes.get_figure(root=True),
            *(each[::-1] if is_right else each),
            "points",
        )
        for each in points
    )
    corner = 1.0, 1.0
    axes.annotate(
        "", corner, xycoords=tip, xytext=corner, textcoords=tail,
        arrowprops={
            "arrowstyle": "-|>", "color": INK_COLOUR, "lw": 1.3, "shrinkA": 0, "shrinkB": 0,
        },
    )  # fmt: skip
    axes.annotate(
        gettext("N"), corner, xycoords=letter, fontsize=TEXT_SIZE, weight="bold",
        color=INK_COLOUR, ha="center", va="center",
    )  # fmt: skip


def style_axes(axes: Axes, x_label: str, y_label: str) -> None:
    """Set labels, grid, spines and number format common to all figures."""
    axes.set_xlabel(x_label, fontsize=TEXT_SIZE, color=INK_COLOUR)
    axes.set_ylabel(y_label, fontsize=TEXT_SIZE, color=INK_COLOUR)
    axes.tick_params(labelsize=SMALL_TEXT_SIZE, colors=INK_COLOUR, length=3)
    axes.grid(True, color=GRID_COLOUR, linewidth=0.6)
    axes.set_axisbelow(True)
    axes.spines[["top", "right"]].set_visible(False)
    axes.spines[["left", "bottom"]].set_color("#999999")
    for axis in (axes.xaxis, axes.yaxis):
        if isinstance(axis.get_major_formatter(), ScalarFormatter):
            axis.set_major_formatter(LocalisedFormatter())


class FittingLocator(Locator):
    """Locator of as many round tick values as a short axis has space for, three if possible.

    Parameters
    ----------
    ticked : axis of the ticks
    text : function of a value that returns its label
    """

    def __init__(self, ticked: Axis, text: Callable[[float], str]) -> None:
        self._ticked, self._text = ticked, text

    def __call__(self) -> list[float]:
        """Tick values of the visible range."""
        return self.tick_values(*self._ticked.get_view_interval())

    def tick_values(self, vmin: float, vmax: float) -> list[float]:
        """Tick values from ``vmin`` to ``vmax``; simple steps first, the finest that fits."""
        low, high = sorted((vmin, vmax))
        found: list[float] = []
        for factors in (SIMPLE_STEPS, OTHER_STEPS):
            for values in _tick_lists(low, high, factors):
                if len(values) > len(found) and self._fits(values, high - low):
                    found = values
            if len(found) >= MIN_TICKS:
                break
        return found

    def _fits(self, values: Sequence[float], extent: float) -> bool:
        """Whether the labels of equidistant values do not touch."""
        axes, is_horizontal = self._ticked.axes, self._ticked is self._ticked.axes.xaxis
        pixels = axes.bbox.width if is_horizontal else axes.bbox.height
        inches = pixels / axes.figure.dpi * (values[-1] - values[0]) / extent
        gap = SMALL_TEXT_SIZE / POINTS_PER_INCH
        sizes = (
            [text_width(self._text(value), SMALL_TEXT_SIZE) for value in values]
            if is_horizontal
            else [gap] * len(values)
        )
        needed = [(a + b) / 2 + TICK_GAP * gap for a, b in pairwise(sizes)]
        return all(inches / (len(values) - 1) >= each for each in needed)


def set_fitting_ticks(axis: Axis, text: Callable[[float], str]) -> None:
    """Set ticks that fit on a short axis, with labels by ``text``."""
    axis.set_major_locator(FittingLocator(axis, text))
    axis.set_major_formatter(lambda value, _: text(value))


def _tick_lists(low: float, high: float, factors: Sequence[float]) -> list[list[float]]:
    """Multiples of round steps in a range, 2 to `MAX_TICKS` of them."""
    power = floor(log10(high - low)) if high > low else 0
    lists = []
    for step in (factor * 10.0**exponent for exponent in (power - 1, power) for factor in factors):
        first, last = ceil(low / step - 1e-9), floor(high / step + 1e-9)
        if 2 <= last - first + 1 <= MAX_TICKS:
            lists.append([float(f"{k * step:.10g}") for k in range(first, last + 1)])
    return lists


class LocalisedFormatter(ScalarFormatter):
    """Formatter of tick labels with the decimal sign of the language in use and a minus sign."""

    def __call__(self, x: float, pos: int | None = None) -> str:
        """Text of one number."""
        return localised_number(super().__call__(x, pos))

    def format_data_short(self, value: float) -> str:  # type: ignore[override]
        """Text of the value at the mouse pointer."""
        return localised_number(super().format_data_short(value))


@cache
def drawable_characters() -> frozenset[int]:
    """Code points of the characters in the default font of matplotlib."""
    path = Path(matplotlib.get_data_path()) / "fonts" / "ttf" / "DejaVuSans.ttf"
    return frozenset(FT2Font(str(path)).get_charmap())


def _drawable_text(text: str) -> str:
    """Text with the sign of mathematical markup escaped and missing characters replaced."""
    shown = "".join(letter if ord(letter) in drawable_characters() else "\u25a1" for letter in text)
    return shown.replace("$", r"\$")


def short_name(name: str) -> str:
    """Name typed by the user, shortened to `MAX_LABEL_LENGTH` and drawable by matplotlib."""
    return _drawable_text(
        name if len(name) <= MAX_LABEL_LENGTH else name[: MAX_LABEL_LENGTH - 1] + "\u2026"
    )


def _before_after_bars(
    labels: Sequence[str], values: Sequence[Sequence[float]], largest: Sequence[float]
) -> Figure:
    """Bars of each label, in a panel each for before and after.

    Parameters
    ----------
    labels : sequence of n texts
    values : two sequences of n numbers, metres, before and after
    largest : two numbers, metres, which the scales of the panels contain
    """
    figure = blank_figure(None, (6.3, 0.75 + 0.16 * len(labels)))
    panels = figure.subplots(1, 2, sharey=True)
    at = np.arange(len(labels))
    colours = (BEFORE_COLOUR, AFTER_COLOUR)
    titles = gettext("before"), gettext("after")
    for axes, lengths, limit, colour, title in zip(
        panels, values, largest, colours, titles, strict=True
    ):
        bars = axes.barh(at, 1000 * np.asarray(lengths), height=0.7, color=colour)
        axes.bar_label(
            bars,
            fmt=lambda each: fixed_number(each, 1),
            fontsize=SMALL_TEXT_SIZE - 1,
            color=INK_COLOUR,
            padding=2,
        )
        axes.set_title(title, fontsize=TEXT_SIZE, color=INK_COLOUR)
        axes.set_xlim(0.0, max(1150.0 * limit, 1e-3))  # with space for the numbers
        style_axes(axes, gettext("RMS distance (mm)"), "")
        axes.grid(False, axis="y")
        axes.tick_params(axis="y", length=0)
    panels[0].set_yticks(at, labels)
    panels[0].set_ylim(len(labels) - 0.4, -0.6)
    return figure


def _draw_track(axes: Axes, points: Array, colour: tuple[float, ...]) -> Track | None:
    """Draw a track beside its true place, on the starboard side; None without a direction.

    Parameters
    ----------
    points : east and north, shape (k, 2), metres
    """
    east, north = points.T
    course = np.array([east[-1] - east[0], north[-1] - north[0]])
    course /= max(float(np.hypot(*course)), 1e-9)
    starboard = TRACK_OFFSET_PT * np.array([course[1], -course[0]])
    axes.update_datalim(points)
    axes.plot(east, north, color=colour, linewidth=1.6, transform=_moved(axes, starboard))
    if len(points) < 2:
        return None
    # The arrow ends beyond the track, so that it covers no part of a line in opposite direction.
    tip = starboard + 7 * course
    axes.annotate(
        "", (east[-1], north[-1]), xycoords=_moved(axes, tip),
        textcoords="offset points", xytext=(-9 * course[0], -9 * course[1]),
        arrowprops={"arrowstyle": "-|>", "color": colour, "lw": 1.6, "mutation_scale": 9},
    )  # fmt: skip
    offset, arrow = ((float(each[0]), float(each[1])) for each in (starboard, tip))
    return Track(points, offset, arrow)


def _label(
    name: str,
    place: Sequence[float],
    colour: str,
    offset: tuple[float, float] | None = None,
) -> Label:
    """Name of a mark, or of a track with this offset that starts at the place (east, north)."""
    east, north = float(place[0]), float(place[1])
    is_mark = offset is None
    return Label(
        short_name(name), (east, north), colour, SMALL_TEXT_SIZE, offset or (0.0, 0.0), is_mark
    )


def _moved(axes: Axes, offset: Array) -> Transform:
    """Transformation of the data that moves them on paper; offset in points."""
    figure = axes.get_figure(root=True)
    return offset_copy(axes.transData, figure, float(offset[0]), float(offset[1]), units="points")


def _draw_seeds(
    axes: Axes, seeds: Mapping[str, Sequence[float]], marker: str, colour: str, label: str
) -> None:
    if not seeds:
        return
    places = np.array([seed[:2] for seed in seeds.values()])
    axes.plot(
        -places[:, 1], places[:, 0], marker, color=colour, markersize=5, label=label, zorder=3
    )
