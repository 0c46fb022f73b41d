"""Figures of the visibility of an error by line and inclination (thesis, 3.13 to C.21)."""

from collections.abc import Mapping

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from lispac.language import N_, gettext
from lispac.present.planning.visibility import CRITERIA, systematic_error_label
from lispac.report.figures import (
    INK_COLOUR,
    SMALL_TEXT_SIZE,
    TEXT_SIZE,
    blank_figure,
    line_colour,
    style_axes,
)
from lispac.simulation.thesis_site import HEADINGS_DEG
from lispac.simulation.visibility_study import TYPE_ONE_THRESHOLD, VisibilityStudy

Array = NDArray[np.float64]

ACCEPTED_COLOUR, BEST_COLOUR = "#e3ebf3", "#555555"
CURVE_WIDTHS = (6.0, 2.0, 6.0, 4.2, 2.6, 1.0)
"""Widths of the curves of the lines, points; they differ so that coincident curves are visible."""


SITE_NAMES: Mapping[str, str] = {"terrestrial": N_("terrestrial"), "marine": N_("marine")}
"""Names of the sites within a sentence."""


def _set_y_limits(axes: Axes, values: Array, least: float) -> None:
    low, high = float(values.min()), float(values.max())
    wanting = max(0.0, least - (high - low)) / 2
    low, high = low - wanting, high + wanting
    margin = 0.15 * (high - low)
    axes.set_ylim(low - margin, high + margin)


def visibility_figure(
    study: VisibilityStudy,
    error: str,
    criterion: str,
    figure: Figure | None = None,
) -> Figure:
    """Values of a criterion for one error and all lines, by inclination of the board.

    The inclinations accepted by the type I criterion are shaded; a dashed line marks the best one.
    The vertical axis of the other criteria is scaled to the accepted inclinations, since at others
    the beams may graze the board and give meaningless points.

    Parameters
    ----------
    criterion : str
        Key of `CRITERIA`.
    """
    figure = blank_figure(figure, (6.3, 3.4))
    axes = figure.add_subplot()
    shown = CRITERIA[criterion]
    best = study.best_configuration(error)
    inclinations = np.degrees(study.site.inclinations)
    if best.kept:
        axes.axvspan(
            np.degrees(best.kept[0]) - 5,
            np.degrees(best.kept[-1]) + 5,
            color=ACCEPTED_COLOUR,
            linewidth=0,
        )
    if best.inclination is not None:
        axes.axvline(np.degrees(best.inclination), color=BEST_COLOUR, linewidth=0.9, linestyle="--")
    values = shown.values(study)[study.site.errors.index(error)]
    for k, heading in enumerate(HEADINGS_DEG):
        axes.plot(
            inclinations, values[k], color=line_colour(k), linewidth=CURVE_WIDTHS[k],
            marker="o", markersize=CURVE_WIDTHS[k] + 1.5,
            label=gettext("{heading:n}°", heading=heading),
        )  # fmt: skip
    style_axes(
        axes,
        gettext("Inclination of the board (°; positive: tilted towards the vessel)"),
        gettext(shown.label),
    )
    if criterion == "type-one":
        axes.axhline(TYPE_ONE_THRESHOLD, color=BEST_COLOUR, linewidth=0.6, linestyle=":")
        axes.set_ylim(-0.05, 1.05)
    elif best.kept:
        _set_y_limits(axes, values[:, np.isin(study.site.inclinations, best.kept)], shown.least)
    axes.set_xticks(inclinations[:: 3 if len(inclinations) > 20 else 1])
    axes.set_xlim(inclinations[0] - 5, inclinations[-1] + 5)
    head = gettext(
        "{error}, {site} site. {criterion}",
        error=systematic_error_label(error), site=gettext(SITE_NAMES[study.site.name]),
        criterion=gettext(shown.title),
    )  # fmt: skip
    axes.set_title(head, fontsize=TEXT_SIZE + 1, color=INK_COLOUR, loc="left")
    figure.legend(
        loc="outside lower center",
        ncols=6,
        fontsize=SMALL_TEXT_SIZE,
        frameon=False,
        labelcolor=INK_COLOUR,
    )
    return figure
