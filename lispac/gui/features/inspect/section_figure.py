"""Figure of a section: all lines before and after the adjustment, exaggerated if required."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from textwrap import fill

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from lispac.gui.appearance import quantities, theme
from lispac.gui.features.inspect.section_titles import ACROSS_TITLE, ALONG_TITLE, LOW_TITLES
from lispac.gui.viewport.base import Array, Colour
from lispac.gui.widgets.ticks import convert_axis_units
from lispac.language import N_, gettext
from lispac.present.checking.validation import PairOffset
from lispac.project import BoresightChoice
from lispac.workflow.checking.survey_sections import SectionPoints

MAX_POINTS = 60_000
"""Largest number of points drawn; larger sets are thinned evenly over all lines."""
FONT_SIZE, SMALL_SIZE = 9, 8
LEGEND_INCHES, AXIS_INCHES = 0.9, 0.8
"""Approximate space for the legend, and for the titles and numbers of an axis."""
CUT_TITLES = {"prior": N_("Before"), "estimated": N_("After")}
CUT_TITLES_WITH_OFFSET = {
    "prior": N_("Before: largest offset {offset} ({lines})"),
    "estimated": N_("After: largest offset {offset} ({lines})"),
}
MIN_TITLE_LENGTH = 14
"""Smallest length after which the title of the vertical axis is wrapped, characters."""
FILLED_QUANTILE = 0.99
"""Share of the points that an enlarged picture contains; single points off the surface may be out
of it."""
MAX_CROP_ALONG = 4.0
"""Largest `_CutView.crop` along a surface, so that the tilts of the lines stay visible."""
VISIBLE_DISTANCE_M, MIN_VISIBLE_SHARE = 0.02, 0.03
"""Distance between lines that the automatic factor shows, metres, and the share of the width of
the picture, enlarged, that is needed for that."""
TICK_INCHES = 0.55, 0.22
"""Approximate space for a number of the horizontal and of the vertical axis."""
OUTSIDE_TEXT = N_("{count:n} of {all:n} lines are out of the picture")
INCHES_PER_CHARACTER = 0.6 * FONT_SIZE / 72.0
"""Approximate width of a character of a title."""
ENLARGED_TITLE = N_("{title}, enlarged {factor:n} times (m)")
SHORT_EXAGGERATION_TEXT = N_("{title}; {factor:n} ×")
SHORT_TITLES_WITH_OFFSET = {
    "prior": N_("Before: offset {offset}"), "estimated": N_("After: offset {offset}"),
}  # fmt: skip
"""Titles in a low figure, in which the cuts are narrow."""


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
    has_long_titles: bool = True,
) -> None:
    """Draw cuts side by side with common limits where their scales are equal.

    Parameters
    ----------
    colours : colour of each line
    titles : English titles of the horizontal and vertical axis
    offsets : largest offset of two lines in the validation, of each cut that has one
    exaggeration : factor across the surface, or of the vertical axis without a plane; None for
        the smallest automatic one, or that of each cut if small distances would not be visible
    starts_at_left : whether the horizontal axis begins with zero at the left, not in the middle
    labelled : whether there is space for large titles of the axes
    has_long_titles : whether there is space for long titles of the cuts side by side
    """
    figure.clear()
    space = _plot_space(figure, len(cuts))
    ratio = space[0] / space[1]
    factors = _exaggerations(cuts) if exaggeration is None else [exaggeration] * len(cuts)
    # The same axes in all cuts, also where one of them needs no exaggeration
    is_natural = all(factor == 1 for factor in factors)
    start = 0.5 * cuts[0].section.width if starts_at_left else 0.0
    views = [
        _CutView.of(cut, factor, start, is_natural=is_natural).widened(ratio)
        for cut, factor in zip(cuts, factors, strict=True)
    ]
    # Cuts with one factor have one range, so that they can be compared
    crops = {view.factor: min(v.crop for v in views if v.factor == view.factor) for view in views}
    views = [replace(view, crop=crops[view.factor]) for view in views]
    title_length = max(MIN_TITLE_LENGTH, int(space[1] / INCHES_PER_CHARACTER))
    is_shared = len({(view.factor, view.crop, view.centre) for view in views}) == 1
    first: Axes | None = None
    for number, view in enumerate(views, start=1):
        shared = first if is_shared else None
        axes = figure.add_subplot(1, len(cuts), number, sharex=shared, sharey=shared)
        first = first or axes
        title = view.title(offsets.get(view.cut.which), short=not has_long_titles)
        _draw_cut(axes, view, colours, title)
        across, upward = view.axis_titles(titles, is_low=not labelled)
        size, pad = (FONT_SIZE, 4.0) if labelled else (SMALL_SIZE, 1.0)
        axes.set_xlabel(across, fontsize=size, color=theme.TEXT, labelpad=pad)
        if number == 1 or not is_shared:
            axes.set_ylabel(
                fill(upward, title_length, break_long_words=False) if labelled else upward,
                fontsize=size,
                color=theme.TEXT,
            )
        convert_axis_units(axes.xaxis, "m", spacing=TICK_INCHES[0])
        convert_axis_units(axes.yaxis, "m", spacing=TICK_INCHES[1])
    lines = [line for line in colours if any(len(cut.points.get(line, ())) for cut in cuts)]
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


def _exaggerations(cuts: Sequence[SectionPoints]) -> list[float]:
    """Automatic factor of each cut: the smallest for all, so that they can be compared.

    Each has its own factor if the smallest would not show small distances between lines.
    """
    factors = [cut.automatic_exaggeration for cut in cuts]
    least, extent = min(factors), min(cuts[0].section.width, cuts[0].section.height)
    is_enough = VISIBLE_DISTANCE_M * least >= MIN_VISIBLE_SHARE * extent
    return [least] * len(cuts) if is_enough else factors


def cut_title(which: BoresightChoice, offset: PairOffset | None, *, short: bool = False) -> str:
    """Title of a cut: before or after, with the largest offset of two lines if it is known."""
    if offset is None:
        return gettext(CUT_TITLES[which])
    titles = SHORT_TITLES_WITH_OFFSET if short else CUT_TITLES_WITH_OFFSET
    amount = quantities.amount(1000 * offset.absolute_m, "mm", 1)
    return gettext(titles[which], offset=amount, lines=offset.lines)


@dataclass(frozen=True, eq=False)
class _CutView:
    """A cut with its exaggeration; a plane is drawn by its distances across and along it.

    Attributes
    ----------
    rotation : ndarray of shape (2, 2)
        Axes of the drawn picture in that of the cut, as columns.
    vertical : whether the vertical axis is exaggerated, instead of the horizontal one
    is_natural : whether the axes are those of the section, instead of along and across a plane
    start : coordinate of the middle of the horizontal axis, metres
    crop : ratio of the height of the section to that of the picture, at least 1
    centre : distance across the plane of the middle of the picture, metres
    """

    cut: SectionPoints
    factor: float
    rotation: Array
    vertical: bool
    is_natural: bool
    start: float = 0.0
    crop: float = 1.0
    centre: float = 0.0

    @classmethod
    def of(cls, cut: SectionPoints, factor: float, start: float, *, is_natural: bool) -> "_CutView":
        if cut.normal is None or is_natural:
            return cls(cut, factor, np.eye(2), True, True, start)
        vertical = bool(abs(cut.normal[1]) > abs(cut.normal[0]))
        across = cut.normal * np.sign(cut.normal[int(vertical)]) / np.linalg.norm(cut.normal)
        along = np.array([across[1], -across[0]]) if vertical else np.array([-across[1], across[0]])
        axes = (along, across) if vertical else (across, along)
        return cls(cut, factor, np.column_stack(axes), vertical, False).centred()

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

    def widened(self, ratio: float) -> "_CutView":
        """View with less height, for a plot wider than high, so that the picture is larger.

        Empty space above and below the lines is left out, or a part of the surface along it.
        """
        if not any(map(len, self.cut.points.values())):
            return self
        if self._is_along_upward:
            return replace(self, crop=max(min(ratio, MAX_CROP_ALONG), 1.0))
        upward = np.concatenate(list(self.cut.points.values())) @ self.rotation[:, 1]
        offsets = np.abs(upward - (self.centre if self.vertical else 0.0))
        filled = float(np.quantile(offsets, FILLED_QUANTILE)) / (0.8 * self.half_extent[1])
        return replace(self, crop=max(min(ratio, 1.0 / max(filled, 1e-6)), 1.0))

    @property
    def _is_along_upward(self) -> bool:
        """Whether the surface is roughly along the vertical axis."""
        normal = self.cut.normal
        if not self.is_natural or normal is None:
            return not self.vertical
        return bool(abs(normal[0]) >= abs(normal[1]))

    @property
    def limits(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Ends of the horizontal and vertical axis, metres."""
        middle = np.array([self.start, 0.0])
        middle[int(self.vertical)] += self.centre
        low, high = (middle - self.half_extent).tolist(), (middle + self.half_extent).tolist()
        return (low[0], high[0]), (low[1], high[1])

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
        half = 0.5 * np.array([self.cut.section.width, self.cut.section.height])
        half[int(self.vertical)] /= self.factor
        half[1] /= self.crop
        return half

    @property
    def aspect(self) -> float:
        """Length of a vertical metre in the picture divided by that of a horizontal one."""
        return self.factor if self.vertical else 1 / self.factor

    def axis_titles(self, titles: tuple[str, str], *, is_low: bool) -> list[str]:
        """Titles of the axes, from the English ones of the picture at true scale."""
        if not self.is_natural:
            across = (ACROSS_TITLE, ALONG_TITLE)
            titles = (across[1], across[0]) if self.vertical else across
        upward = titles[1]
        texts = [gettext(title) for title in titles]
        if self.factor != 1:
            number = int(self.vertical)
            texts[number] = gettext(
                ENLARGED_TITLE,
                title=texts[number].removesuffix(" (m)"),
                factor=round(self.factor),
            )
        if is_low:
            texts[1] = gettext(LOW_TITLES.get(upward, upward))
        return texts

    def title(self, offset: PairOffset | None, *, short: bool) -> str:
        """Title of the cut, with its factor if the axes have no titles."""
        title = cut_title(self.cut.which, offset, short=short)
        if self.factor == 1 or not short:
            return title
        return gettext(SHORT_EXAGGERATION_TEXT, title=title, factor=round(self.factor))


def _plot_space(figure: Figure, count: int) -> tuple[float, float]:
    """Approximate width and height of the space for each of the plots side by side, inches."""
    width, height = figure.get_size_inches()
    across, up = (width - LEGEND_INCHES) / count - AXIS_INCHES, height - AXIS_INCHES
    return max(float(across), 0.1), max(float(up), 0.1)


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
    axes.set_aspect(view.aspect, adjustable="box")
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
