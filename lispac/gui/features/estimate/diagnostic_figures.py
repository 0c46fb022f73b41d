"""Figures of the diagnostics: convergence, correlations, POS errors, weak directions."""

from textwrap import fill

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from lispac.adjustment.result import AdjustmentResult
from lispac.gui.appearance import theme, units
from lispac.gui.widgets.ticks import FONT_SIZE, SMALL_SIZE, convert_axis_units, style_axes
from lispac.language import N_, degree_signs, gettext
from lispac.present.angles import ANGLE_TITLES
from lispac.present.targets.sightings import sighting_values
from lispac.report.figures import correlation_figure_of, pos_error_figure

ANGLE_MARKERS = ("o", "s", "^")
"""Markers of the angles, which can be distinguished without colours."""
DIRECTION_TITLES = (N_("weakest direction"), N_("middle direction"), N_("strongest direction"))
MIN_DRAWN_DIFFERENCE = 1e-12
"""Smallest difference drawn, in the angle unit shown; smaller ones are rounding errors."""


def draw_convergence(result: AdjustmentResult, figure: Figure) -> None:
    """Draw the difference of each angle from its final value by iteration; 0 is the prior."""
    axes = _new_axes(figure)
    path = np.degrees(np.vstack([result.prior_boresight, result.path]))
    differences = np.abs(path - path[-1]) * units.shown_unit("°").factor
    count, last = np.arange(len(path)), np.degrees(result.angles)
    for k, title in enumerate(ANGLE_TITLES):
        value = units.local_amount(float(last[k]), "°", "+.4f")
        shown = np.where(differences[:-1, k] > MIN_DRAWN_DIFFERENCE, differences[:-1, k], np.nan)
        axes.plot(
            count[:-1],
            shown,
            color=theme.current_scheme().series[k],
            marker=ANGLE_MARKERS[k],
            markersize=4,
            linewidth=1.3,
            label=f"{gettext(title)}  {value}",
        )
    sigma = float(np.degrees(result.sigma.min()))
    sigma *= units.shown_unit("°").factor
    axes.axhline(sigma, color=theme.MUTED, linewidth=1, linestyle="--")
    axes.annotate(
        gettext("smallest σ"), (1, sigma), xycoords=("axes fraction", "data"), xytext=(-4, 3),
        textcoords="offset points", ha="right", fontsize=SMALL_SIZE, color=theme.MUTED,
    )  # fmt: skip
    axes.set_yscale("log")
    axes.set_xlabel(gettext("Iteration"), fontsize=FONT_SIZE)
    axes.set_ylabel(
        gettext("Difference from the final value, {unit}", unit=units.local_sign("°")),
        fontsize=FONT_SIZE,
    )
    axes.xaxis.get_major_locator().set_params(integer=True)
    axes.legend(fontsize=SMALL_SIZE, frameon=False, labelcolor=theme.TEXT, loc="lower left")


def draw_correlations(result: AdjustmentResult, figure: Figure) -> None:
    """Draw the correlations of all estimated values, as in the report."""
    correlation_figure_of(result.estimated, result.correlation_all, figure)


def draw_pos_errors(result: AdjustmentResult, figure: Figure) -> None:
    """Draw the estimated POS error of each sighting as in the report, in the units of the user."""
    tested = [each for each in sighting_values(result) if each.pos_error is not None]
    with degree_signs():
        pos_error_figure(tested, figure)
    for k, axes in enumerate(figure.axes):
        convert_axis_units(axes.xaxis, "mm" if k < 3 else "m°")


NAME_LETTERS = 20
"""Longest line of the name of a direction."""
LEAST_LABELLED_SHARE = 0.12
"""Smallest share of an angle whose bar is wide enough for its number."""


def draw_directions(result: AdjustmentResult, figure: Figure) -> None:
    """Draw the shares of roll, pitch and yaw in the three eigenvectors."""
    observability = result.observability
    assert observability is not None
    axes = _new_axes(figure)
    sigma = np.degrees(observability.eigenvalues**-0.5)
    share = observability.directions**2
    left = np.zeros(3)
    for k, title in enumerate(map(gettext, ANGLE_TITLES)):
        axes.barh(range(3), share[k] * 100, left=left * 100, height=0.6,
                  color=theme.current_scheme().series[k], alpha=0.85, label=title)  # fmt: skip
        for row in range(3):
            if share[k, row] > LEAST_LABELLED_SHARE:
                text = gettext("{share:percent.0} %", share=share[k, row])
                axes.text((left[row] + share[k, row] / 2) * 100, row, text, ha="center",
                          va="center", fontsize=SMALL_SIZE, color=theme.ON_SERIES)  # fmt: skip
        left = left + share[k]
    names = [
        f"{fill(gettext(name), NAME_LETTERS)}\nσ {units.local_amount(value, '°', '.4f')}"
        for name, value in zip(DIRECTION_TITLES, sigma, strict=True)
    ]
    axes.set_yticks(range(3), names)
    axes.invert_yaxis()
    axes.set_xlim(0, 100)
    # Of the figure, since the axes are narrower than these texts
    figure.legend(
        fontsize=SMALL_SIZE, frameon=False, labelcolor=theme.TEXT, ncols=3,
        loc="outside upper center",
    )  # fmt: skip
    figure.supxlabel(
        gettext("Contribution of each angle to the direction, %"),
        fontsize=FONT_SIZE, color=theme.TEXT,
    )  # fmt: skip


def _new_axes(figure: Figure) -> Axes:
    figure.clear()
    axes = figure.add_subplot()
    style_axes(axes)
    return axes
