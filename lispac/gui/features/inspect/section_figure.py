"""Figure of a section: all lines at true scale, before and after the adjustment."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D

from lispac.gui.appearance import quantities, theme
from lispac.gui.viewport.base import Array, Colour
from lispac.gui.viewport.overlay import length_text, scale_bar_length
from lispac.gui.widgets.ticks import convert_axis_units
from lispac.language import N_, gettext
from lispac.workflow.checking.survey_sections import SectionPoints

MAX_POINTS = 60_000
"""Largest number of points drawn; larger sets are thinned evenly over all lines."""
FONT_SIZE, SMALL_SIZE = 9, 8
CUT_TITLES = {"prior": N_("Before"), "estimated": N_("After")}
CUT_TITLES_WITH_DISTANCE = {
    "prior": N_("Before: largest distance between lines {distance}"),
    "estimated": N_("After: largest distance between lines {distance}"),
}
SHORT_TITLES_WITH_DISTANCE = {
    "prior": N_("Before: up to {distance}"), "estimated": N_("After: up to {distance}"),
}  # fmt: skip
"""Titles in a low figure, in which the cuts are narrow."""


def draw_section(
    cuts: Sequence[SectionPoints],
    colours: Mapping[str, Colour],
    titles: tuple[str, str],
    figure: Figure,
    *,
    labelled: bool = True,
) -> None:
    """Draw cuts side by side with common limits.

    Parameters
    ----------
    colours : colour of each line
    titles : English titles of the horizontal and vertical axis
    labelled : whether there is space for long titles and titles of the horizontal axes
    """
    figure.clear()
    first: Axes | None = None
    for number, cut in enumerate(cuts, start=1):
        axes = figure.add_subplot(1, len(cuts), number, sharex=first, sharey=first)
        first = first or axes
        _draw_cut(axes, cut, colours, cut_title(cut, short=not labelled))
        if labelled:
            axes.set_xlabel(gettext(titles[0]), fontsize=FONT_SIZE, color=theme.TEXT)
        if number == 1:
            axes.set_ylabel(gettext(titles[1]), fontsize=FONT_SIZE, color=theme.TEXT)
        convert_axis_units(axes.xaxis, "m")
        convert_axis_units(axes.yaxis, "m")
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


def cut_title(cut: SectionPoints, *, short: bool = False) -> str:
    """Title of a cut: before or after, with the largest distance between two lines."""
    if cut.separation is None:
        return gettext(CUT_TITLES[cut.which])
    distance = quantities.amount(1000 * cut.separation, "mm", 0)
    titles = SHORT_TITLES_WITH_DISTANCE if short else CUT_TITLES_WITH_DISTANCE
    return gettext(titles[cut.which], distance=distance)


def _draw_cut(axes: Axes, cut: SectionPoints, colours: Mapping[str, Colour], title: str) -> None:
    axes.set_facecolor(theme.PAPER)
    total = sum(len(points) for points in cut.points.values())
    step = -(-total // MAX_POINTS) or 1
    for line, points in cut.points.items():
        shown = points[::step]
        axes.plot(
            shown[:, 0], shown[:, 1], marker="o", linestyle="none", markersize=1.7,
            markeredgewidth=0, color=_unit_rgb(colours[line]), label=line, gid=line,
        )  # fmt: skip
    half = 0.5 * np.array([cut.section.width, cut.section.height])
    axes.set_xlim(-half[0], half[0])
    axes.set_ylim(-half[1], half[1])
    axes.set_aspect("equal", adjustable="box")
    axes.grid(color=theme.GRID, linewidth=0.6)
    axes.set_axisbelow(True)
    axes.tick_params(labelsize=SMALL_SIZE, colors=theme.TEXT)
    axes.spines[:].set_color(theme.MUTED)
    axes.set_title(title, fontsize=FONT_SIZE, color=theme.TEXT, loc="left")
    if not total:
        axes.text(0.5, 0.5, gettext("No points in the section"), transform=axes.transAxes,
                  ha="center", color=theme.MUTED, fontsize=FONT_SIZE)  # fmt: skip
    _draw_scale_bar(axes, 2 * half)


def _draw_scale_bar(axes: Axes, extent: Array) -> None:
    """Draw a scale bar in the lower left corner."""
    metres = scale_bar_length(1.0, 0.3 * float(extent.min()))
    length = length_text(metres)
    left, low = -0.46 * extent[0], -0.45 * extent[1]
    axes.plot([left, left + metres], [low, low], color=theme.TEXT, linewidth=2.5, gid="bar",
              solid_capstyle="butt")  # fmt: skip
    axes.annotate(
        length, (left, low), xytext=(0, 4), textcoords="offset points",
        fontsize=SMALL_SIZE, color=theme.TEXT,
        bbox={"facecolor": theme.PAPER, "alpha": 0.7, "edgecolor": "none", "pad": 0.5},
    )  # fmt: skip


def _unit_rgb(colour: Colour) -> tuple[float, float, float]:
    red, green, blue = colour
    return red / 255, green / 255, blue / 255
