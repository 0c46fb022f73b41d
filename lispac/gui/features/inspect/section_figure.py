"""Figure of a section: all lines before and after the adjustment, exaggerated if required."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from textwrap import fill

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from lispac.gui.appearance import quantities, theme
from lispac.gui.features.inspect.section_titles import ACROSS_TITLE, ALONG_TITLES, LOW_TITLES
from lispac.gui.viewport.base import Array, Colour
from lispac.gui.widgets.ticks import convert_axis_units
from lispac.language import N_, gettext
from lispac.present.checking.validation import PairOffset
from lispac.project import BoresightChoice
from lispac.workflow.checking.survey_sections import EXAGGERATIONS, SectionPoints

MAX_POINTS = 60_000
"""Largest number of points drawn; larger sets are thinned evenly over all lines."""
FONT_SIZE, SMALL_SIZE = 9, 8
LEGEND_MARK_INCHES = 0.35
"""Approximate width of the mark of a line in the legend, with its margins."""
AXIS_INCHES, LOW_AXIS_INCHES = (0.8, 0.8), (0.6, 0.5)
"""Approximate space beside and above and below a plot, for titles and numbers, and that in a low
figure, whose horizontal axis has its title inside."""
CUT_TITLES = {"prior": N_("Before"), "estimated": N_("After")}
CUT_TITLES_WITH_OFFSET = {
    "prior": N_("Before: largest offset {offset} ({lines})"),
    "estimated": N_("After: largest offset {offset} ({lines})"),
}
SHORT_TITLES_WITH_OFFSET = {
    "prior": N_("Before: {offset} ({lines})"), "estimated": N_("After: {offset} ({lines})"),
}  # fmt: skip
"""Titles where the others do not fit."""
MIN_TITLE_LENGTH = 14
"""Smallest length after which the title of the vertical axis is wrapped, characters."""
FILLED_QUANTILE, FILLED_SHARE = 0.99, 0.8
"""Share of the points that a picture without a plane contains, and that of the picture which they
fill across the surface; single points off the surface may be out of it."""
VISIBLE_DISTANCE_M, MIN_VISIBLE_INCHES = 0.02, 0.12
"""Distance between lines that the automatic factor shows, metres, and its smallest length in the
picture: five times the size of a point."""
TICK_INCHES = 0.55, 0.22
"""Approximate space for a number of the horizontal and of the vertical axis."""
OUTSIDE_TEXT = N_("{count:n} of {all:n} lines are out of the picture")
TITLE_CORNER = 0.35, 0.2
"""Approximate width and height of the title of an axis in a low plot, as shares of the plot."""
INCHES_PER_CHARACTER = 0.6 * FONT_SIZE / 72.0
"""Approximate width of a character of a title."""
ENLARGED_TITLE = N_("{title}, enlarged {factor:n} times (m)")
SHORT_EXAGGERATION_TEXT = N_("{title}; {factor:n} ×")


def draw_section(
    cuts: Sequence[SectionPoints],
    colours: Mapping[str, Colour],
    titles: tuple[str, str],
    offsets: Mapping[BoresightChoice, PairOffset],
    figure: Figure,
    *,
    exaggeration: float | None = None,
    starts_at_left: bool = False,
    labelled: bool = True,
) -> None:
    """Draw cuts side by side with common limits where their scales are equal.

    A picture shows the whole section along the surface, and as much across it as its plot allows.

    Parameters
    ----------
    colours : colour of each line
    titles : English titles of the horizontal and vertical axis
    offsets : largest offset of two lines in the validation, of each cut that has one
    exaggeration : factor across the surface, or of the vertical axis without a plane; None for
        the smallest automatic one, or that of each cut if small distances would not be visible
    starts_at_left : whether the horizontal axis begins with zero at the left, not in the middle
    labelled : whether there is space for large titles of the axes
    """
    figure.clear()
    lines = [line for line in colours if any(len(cut.points.get(line, ())) for cut in cuts)]
    slot = _slot_width(figure, len(cuts), lines)
    margins = AXIS_INCHES if labelled else LOW_AXIS_INCHES
    space = max(slot - margins[0], 0.1), max(float(figure.get_figheight()) - margins[1], 0.1)
    automatic = exaggeration is None
    factors = _exaggerations(cuts, space) if automatic else [exaggeration] * len(cuts)
    # The same axes in all cuts, also where one of them needs no exaggeration
    is_natural = all(factor == 1 for factor in factors)
    start = 0.5 * cuts[0].section.width if starts_at_left else 0.0
    views = [
        _CutView.of(cut, factor, start, is_natural=is_natural)
        for cut, factor in zip(cuts, factors, strict=True)
    ]
    # Cuts with one factor have one scale, so that they can be compared
    scales = {
        view.factor: min(each.scale(space) for each in views if each.factor == view.factor)
        for view in views
    }
    views = [view.scaled(scales[view.factor], space).centred() for view in views]
    title_length = max(MIN_TITLE_LENGTH, int(space[1] / INCHES_PER_CHARACTER))
    is_shared = len({(view.factor, tuple(view.half_extent), view.centre) for view in views}) == 1
    first: Axes | None = None
    for number, view in enumerate(views, start=1):
        shared = first if is_shared else None
        axes = figure.add_subplot(1, len(cuts), number, sharex=shared, sharey=shared)
        first = first or axes
        title = view.title(
            offsets.get(view.cut.which), int(slot / INCHES_PER_CHARACTER), is_low=not labelled
        )
        _draw_cut(axes, view, colours, title)
        across, upward = view.axis_titles(titles, is_low=not labelled)
        size = FONT_SIZE if labelled else SMALL_SIZE
        axes.set_xlabel(across, fontsize=size, color=theme.TEXT)
        if not labelled:
            move_title_inside(axes)
        if number == 1 or not is_shared:
            axes.set_ylabel(
                fill(upward, title_length, break_long_words=False) if labelled else upward,
                fontsize=size,
                color=theme.TEXT,
            )
        convert_axis_units(axes.xaxis, "m", spacing=TICK_INCHES[0])
        convert_axis_units(axes.yaxis, "m", spacing=TICK_INCHES[1])
    if lines:
        marks = [
            Line2D(
                [], [], marker="o", linestyle="none", markersize=5, color=_unit_rgb(colours[line])
            )
            for line in lines
        ]
        legend = figure.legend(
            marks, lines, loc="outside right center", fontsize=SMALL_SIZE, frameon=False,
            labelcolor=theme.TEXT, handletextpad=0.1, borderaxespad=0.2,
        )  # fmt: skip
        for text in legend.get_texts():
            text.set_parse_math(False)


def _exaggerations(cuts: Sequence[SectionPoints], space: tuple[float, float]) -> list[float]:
    """Automatic factor of each cut: the smallest for all, so that they can be compared.

    Each has its own factor if the smallest would not show small distances between lines.

    Parameters
    ----------
    space : width and height of a plot, inches
    """
    proportions = [
        space[int(vertical)] / space[1 - int(vertical)] for vertical in map(_is_across_upward, cuts)
    ]
    # In a low plot, a short picture with the next factor is clearer than one at true scale
    factors = [
        max(cut.automatic_exaggeration(each), min(cut.automatic_exaggeration(), EXAGGERATIONS[1]))
        for cut, each in zip(cuts, proportions, strict=True)
    ]
    least, section = min(factors), cuts[0].section
    inches_per_metre = min(
        space[1 - int(vertical)] / (section.width if vertical else section.height)
        for vertical in map(_is_across_upward, cuts)
    )
    is_enough = VISIBLE_DISTANCE_M * least * inches_per_metre >= MIN_VISIBLE_INCHES
    return [least] * len(cuts) if is_enough else factors


def _is_across_upward(cut: SectionPoints) -> bool:
    """Whether distances across the surface are along the vertical axis."""
    return cut.normal is None or bool(abs(cut.normal[1]) > abs(cut.normal[0]))


def cut_title(which: BoresightChoice, offset: PairOffset | None, length: int) -> str:
    """Title of a cut: before or after, with the largest offset and its lines if known.

    Parameters
    ----------
    length : number of characters of a line of the title; a longer title has two lines
    """
    if offset is None:
        return gettext(CUT_TITLES[which])
    amount = quantities.amount(1000 * offset.absolute_m, "mm", 1)
    for titles in (CUT_TITLES_WITH_OFFSET, SHORT_TITLES_WITH_OFFSET):
        title = gettext(titles[which], offset=amount, lines=offset.lines)
        if len(title) <= length:
            return title
    return fill(title, max(length, 1), break_long_words=False)


@dataclass(frozen=True, eq=False)
class _CutView:
    """A cut with its exaggeration; a plane is drawn by its distances across and along it.

    Attributes
    ----------
    rotation : ndarray of shape (2, 2)
        Axes of the drawn picture in that of the cut, as columns; that across the surface points
        towards the vessel.
    vertical : whether the vertical axis is exaggerated, instead of the horizontal one
    is_natural : whether the axes are those of the section, instead of along and across a plane
    is_reversed : whether the axis across the surface has its larger values at the left or bottom,
        so that the vessel is on the same side as in a picture at true scale
    start : coordinate of the middle of the horizontal axis, metres
    half_across : half of the extent of the picture across the surface, metres
    centre : distance across the plane of the middle of the picture, metres
    """

    cut: SectionPoints
    factor: float
    rotation: Array
    vertical: bool
    is_natural: bool
    is_reversed: bool = False
    start: float = 0.0
    half_across: float = 0.0
    centre: float = 0.0

    @classmethod
    def of(cls, cut: SectionPoints, factor: float, start: float, *, is_natural: bool) -> "_CutView":
        vertical = _is_across_upward(cut)
        if cut.normal is None or is_natural:
            return cls(cut, factor, np.eye(2), vertical, True, start=start)
        across = cut.normal / np.linalg.norm(cut.normal)
        is_reversed = bool(across[int(vertical)] < 0)
        x, y = -across if is_reversed else across
        axes = (np.array([y, -x]), across) if vertical else (across, np.array([-y, x]))
        return cls(cut, factor, np.column_stack(axes), vertical, False, is_reversed)

    @property
    def _across(self) -> dict[str, Array]:
        """Coordinates of the points of each line along the exaggerated axis, shape (n,)."""
        axis = self.rotation[:, int(self.vertical)]
        return {line: points @ axis for line, points in self.cut.points.items() if len(points)}

    def centred(self) -> "_CutView":
        """View in the middle of the lines, or of one of them, if some would be out of it."""
        middles = sorted(float(np.median(values)) for values in self._across.values())
        half = float(self.half_extent[int(self.vertical)])
        if not middles or max(-middles[0], middles[-1]) <= half:
            return self
        has_space = middles[-1] - middles[0] <= 2 * half
        middle = 0.5 * (middles[0] + middles[-1]) if has_space else middles[len(middles) // 2]
        return replace(self, centre=middle)

    @property
    def _extents(self) -> tuple[float, float]:
        """Extents of the section across the surface and along it, metres."""
        width, height = self.cut.section.width, self.cut.section.height
        return (height, width) if self.vertical else (width, height)

    @property
    def _needed_half_width(self) -> float:
        """Half width across the surface that shows all lines, metres."""
        half = 0.5 * self._extents[0]
        needed = None if self.is_natural else self.cut.needed_half_width
        if needed is None:
            points = np.concatenate([np.empty(0), *self._across.values()])
            if not len(points):
                return half
            needed = float(np.quantile(np.abs(points), FILLED_QUANTILE)) / FILLED_SHARE
        return min(needed, half)

    def scale(self, space: tuple[float, float]) -> float:
        """Inches per metre along the surface, with which the whole section is in the plot.

        It is smaller if the lines would not fit across the surface, but a picture enlarged by the
        user is at least as long as it is wide.

        Parameters
        ----------
        space : width and height of the plot, inches
        """
        number = int(self.vertical)
        along = self._extents[1]
        fitting = space[number] / (self.factor * 2.0 * max(self._needed_half_width, 1e-6))
        least = 0.0 if self.factor == 1 else min(space) / along
        return min(space[1 - number] / along, max(fitting, least))

    def scaled(self, scale: float, space: tuple[float, float]) -> "_CutView":
        """View with a scale, which fills the plot across the surface."""
        extent = space[int(self.vertical)] / (self.factor * scale)
        return replace(self, half_across=0.5 * min(extent, self._extents[0]))

    @property
    def limits(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Ends of the horizontal and vertical axis, metres."""
        middle = np.array([self.start, 0.0])
        middle[int(self.vertical)] += self.centre
        ends = np.stack([middle - self.half_extent, middle + self.half_extent])
        if self.is_reversed:
            ends[:, int(self.vertical)] = ends[::-1, int(self.vertical)]
        (left, bottom), (right, top) = ends.tolist()
        return (left, right), (bottom, top)

    def lines_outside(self) -> tuple[int, int]:
        """Number of lines out of the picture across the surface, and of all lines."""
        half, across = float(self.half_extent[int(self.vertical)]), self._across
        offsets = [values - self.centre for values in across.values()]
        # The nearest point of a section between two points; the median of the points on a plane
        nearest = [
            float(np.abs(each).min()) if self.is_natural else abs(float(np.median(each)))
            for each in offsets
        ]
        return sum(distance > half for distance in nearest), len(nearest)

    @property
    def half_extent(self) -> Array:
        """Half of the width and height of the picture, shape (2,), metres."""
        half = np.full(2, 0.5 * self._extents[1])
        half[int(self.vertical)] = self.half_across
        return half

    @property
    def aspect(self) -> float:
        """Length of a vertical metre in the picture divided by that of a horizontal one."""
        return self.factor if self.vertical else 1 / self.factor

    def axis_titles(self, titles: tuple[str, str], *, is_low: bool) -> list[str]:
        """Titles of the axes, from the English ones of the picture at true scale."""
        if not self.is_natural:
            nearest = titles[1 - int(self.vertical)]
            along = ALONG_TITLES.get(nearest, nearest)
            titles = (along, ACROSS_TITLE) if self.vertical else (ACROSS_TITLE, along)
        if is_low:
            return [gettext(LOW_TITLES.get(title, title)) for title in titles]
        texts = [gettext(title) for title in titles]
        if self.factor != 1:
            number = int(self.vertical)
            texts[number] = gettext(
                ENLARGED_TITLE,
                title=texts[number].removesuffix(" (m)"),
                factor=round(self.factor),
            )
        return texts

    def title(self, offset: PairOffset | None, length: int, *, is_low: bool) -> str:
        """Title of the cut, with its factor if the titles of the axes do not contain it.

        Parameters
        ----------
        length : number of characters of a line of the title
        """
        if self.factor == 1 or not is_low:
            return cut_title(self.cut.which, offset, length)
        texts = {"title": "", "factor": round(self.factor)}
        length -= len(gettext(SHORT_EXAGGERATION_TEXT, **texts))
        texts["title"] = cut_title(self.cut.which, offset, length)
        return gettext(SHORT_EXAGGERATION_TEXT, **texts)


def _slot_width(figure: Figure, count: int, lines: Sequence[str]) -> float:
    """Approximate width of a plot side by side with others, with its numbers and title, inches."""
    letters = max(map(len, lines), default=0) * INCHES_PER_CHARACTER * SMALL_SIZE / FONT_SIZE
    legend = LEGEND_MARK_INCHES + letters if lines else 0.0
    return max(float(figure.get_figwidth()) - legend, 0.1) / count


def move_title_inside(axes: Axes) -> None:
    """Move the title of the horizontal axis into the corner of a low plot with fewest points.

    The upper left corner may contain the number of lines that are out of the picture.
    """
    points = np.concatenate([np.empty((0, 2)), *(each.get_xydata() for each in axes.lines)])
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    x, y = (points[:, 0] - left) / (right - left), (points[:, 1] - low) / (high - low)
    width, height = TITLE_CORNER

    def count(at_right: bool, at_top: bool) -> int:
        near_side = x > 1 - width if at_right else x < width
        near_end = y > 1 - height if at_top else y < height
        return int(np.count_nonzero(near_side & near_end))

    corners = ((True, False), (False, False), (True, True))
    at_right, at_top = min(corners, key=lambda corner: count(*corner))
    axes.xaxis.set_label_coords(
        0.99 if at_right else 0.01, 0.95 if at_top else 0.05, transform=axes.transAxes
    )
    axes.xaxis.label.set(
        horizontalalignment="right" if at_right else "left",
        verticalalignment="top" if at_top else "bottom", in_layout=False,
        bbox={"facecolor": theme.PAPER, "alpha": 0.8, "edgecolor": "none", "pad": 1.0},
    )  # fmt: skip


def _draw_cut(axes: Axes, view: _CutView, colours: Mapping[str, Colour], title: str) -> None:
    axes.set_facecolor(theme.PAPER)
    total = sum(len(points) for points in view.cut.points.values())
    step = -(-total // MAX_POINTS) or 1
    for line, points in view.cut.points.items():
        shown = points[::step] @ view.rotation + [view.start, 0.0]
        axes.plot(
            shown[:, 0], shown[:, 1], marker="o", linestyle="none", markersize=1.7,
            markeredgewidth=0, color=_unit_rgb(colours[line]), label=line, gid=line,
        )  # fmt: skip
    across, upward = view.limits
    axes.set_xlim(*across)
    axes.set_ylim(*upward)
    axes.set_aspect(view.aspect, adjustable="box", anchor="W")
    axes.grid(color=theme.GRID, linewidth=0.6)
    axes.set_axisbelow(True)
    axes.tick_params(labelsize=SMALL_SIZE, colors=theme.TEXT)
    axes.spines[:].set_color(theme.MUTED)
    axes.set_title(title, fontsize=FONT_SIZE, color=theme.TEXT, loc="left")
    if not total:
        axes.text(0.5, 0.5, gettext("No points in the section"), transform=axes.transAxes,
                  ha="center", color=theme.MUTED, fontsize=FONT_SIZE)  # fmt: skip
    outside, count = view.lines_outside()
    if outside:
        axes.annotate(
            gettext(OUTSIDE_TEXT, count=outside, all=count), (0.0, 1.0), xytext=(3, -3),
            xycoords="axes fraction", textcoords="offset points", va="top", fontsize=SMALL_SIZE,
            color=theme.TEXT, gid="outside",
            bbox={"facecolor": theme.PAPER, "alpha": 0.85, "edgecolor": "none", "pad": 1.0},
        )  # fmt: skip


def _unit_rgb(colour: Colour) -> tuple[float, float, float]:
    red, green, blue = colour
    return red / 255, green / 255, blue / 255
