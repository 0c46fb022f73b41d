"""Plots of a survey design: scenarios, precision by time on site, errors of simulations."""

from collections.abc import Mapping, Sequence

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from lispac.adjustment.result import ANGLES
from lispac.design.monte_carlo import MonteCarloResult
from lispac.design.plan_search import ReductionStep
from lispac.design.scenarios import ScenarioOutcome
from lispac.language import N_, gettext
from lispac.present.calibration.settings import POS_ERROR_MODEL_NAMES
from lispac.present.text_format import fixed_number, parameter_name
from lispac.report.figures import (
    INK_COLOUR,
    MAIN_COLOUR,
    OTHER_COLOUR,
    SMALL_TEXT_SIZE,
    TEXT_SIZE,
    blank_figure,
    style_axes,
)

MAX_DRAWN_SIGMAS = 4.0
"""Limit of the horizontal axis, in predicted sigmas; the outer bins include larger errors."""

EXPLANATION_TEXT = N_(
    "Above each plot: standard deviation of the errors / predicted sigma, ± 1 sigma. Curve: "
    "expected distribution"
)
RATIO_TITLES: Mapping[str, str] = {
    "roll": N_("roll: {ratio} ± {interval}"),
    "pitch": N_("pitch: {ratio} ± {interval}"),
    "yaw": N_("yaw: {ratio} ± {interval}"),
}
"""Titles of the plots: ratio of the scatter to the predicted sigma, and the sigma of the ratio."""

ANGLE_COLOURS = (MAIN_COLOUR, OTHER_COLOUR, "#228833")
"""Colours of roll, pitch and yaw; distinguishable with any colour vision."""


def scenario_figure(outcomes: Sequence[ScenarioOutcome], figure: Figure | None = None) -> Figure:
    """Sigmas of roll, pitch and yaw for each case of one scenario, in both stochastic models."""
    models = [m for m in POS_ERROR_MODEL_NAMES if any(each.pos_errors == m for each in outcomes)]
    labels = {each.case: str(each.label) for each in outcomes}
    figure = blank_figure(figure, (6.3, 0.9 + 1.9 * len(models)))
    panels = figure.subplots(len(models), 1, sharex=True, squeeze=False)[:, 0]
    for axes, model in zip(panels, models, strict=True):
        own = {each.case: np.degrees(each.sigma) for each in outcomes if each.pos_errors == model}
        table = np.array([own[case] for case in labels])
        highest = table[np.isfinite(table)].max(initial=0.0)
        for k, (angle, colour) in enumerate(zip(ANGLES, ANGLE_COLOURS, strict=True)):
            at = np.arange(len(labels)) + 0.27 * (k - 1)
            axes.bar(at, np.where(np.isfinite(table[:, k]), table[:, k], 0.0), 0.25, color=colour,
                     label=parameter_name(angle))  # fmt: skip
        for x in np.flatnonzero(~np.isfinite(table).all(axis=1)):
            axes.text(x, 0.03 * highest, gettext("not determined"), rotation=90,
                      fontsize=SMALL_TEXT_SIZE, color=INK_COLOUR, ha="center",
                      va="bottom")  # fmt: skip
        style_axes(axes, "", gettext("1 sigma (°)"))
        axes.set_title(
            gettext(POS_ERROR_MODEL_NAMES[model]), fontsize=TEXT_SIZE, color=INK_COLOUR, loc="left"
        )
        axes.set_ylim(0.0, 1.12 * highest if highest > 0 else 1.0)
    turned = max(map(len, labels.values())) * len(labels) > 70
    panels[-1].set_xticks(
        range(len(labels)), list(labels.values()), fontsize=SMALL_TEXT_SIZE,
        rotation=30 if turned else 0,
        ha="right" if turned else "center",
    )  # fmt: skip
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside upper right", ncols=3,
                  fontsize=SMALL_TEXT_SIZE, frameon=False)  # fmt: skip
    return figure


def pareto_front_figure(
    front: Sequence[ReductionStep], label: str, figure: Figure | None = None
) -> Figure:
    """Objective of each plan over its time on site, minutes.

    Parameters
    ----------
    label : str
        Name of the objective.
    """
    figure = blank_figure(figure, (6.3, 2.8))
    axes = figure.subplots()
    minutes = [step.minutes for step in front]
    values = np.degrees([step.value for step in front])
    axes.plot(minutes, values, "o-", color=MAIN_COLOUR, markersize=4, linewidth=1.0)
    for step, x, y in zip(front, minutes, values, strict=True):
        size = f"{len(step.plan.targets)} × {len(step.plan.lines)}"
        axes.annotate(size, (x, y), xytext=(4, 4), textcoords="offset points",
                      fontsize=SMALL_TEXT_SIZE, color=INK_COLOUR)  # fmt: skip
    quantity = gettext("{quantity} (°)", quantity=gettext(label))
    style_axes(axes, gettext("Minutes on site (labels: targets × lines)"), quantity)
    axes.set_ylim(0.0, 1.15 * values.max())
    return figure


def simulated_errors_figure(result: MonteCarloResult, figure: Figure | None = None) -> Figure:
    """Errors of roll, pitch and yaw over their predicted sigmas, with the expected distribution."""
    figure = blank_figure(figure, (6.3, 2.6))
    panels = figure.subplots(1, len(ANGLES), sharex=True, sharey=True)
    unit = np.clip(result.errors / result.predicted, -MAX_DRAWN_SIGMAS, MAX_DRAWN_SIGMAS)
    count = len(unit)
    edges = np.linspace(
        -MAX_DRAWN_SIGMAS, MAX_DRAWN_SIGMAS, int(np.clip(2 * round(np.sqrt(count)), 8, 40)) + 1
    )
    at = np.linspace(-MAX_DRAWN_SIGMAS, MAX_DRAWN_SIGMAS, 161)
    expected = np.exp(-(at**2) / 2) / np.sqrt(2 * np.pi) * count * (edges[1] - edges[0])
    for k, (axes, angle) in enumerate(zip(panels, ANGLES, strict=True)):
        axes.hist(unit[:, k], edges, color=ANGLE_COLOURS[k], alpha=0.75)
        axes.plot(at, expected, color=INK_COLOUR, linewidth=1.0)
        style_axes(
            axes,
            gettext("error / predicted sigma") if k == 1 else "",
            gettext("number of surveys") if k == 0 else "",
        )
        ratio = result.ratio[k]
        title = gettext(
            RATIO_TITLES[angle],
            ratio=fixed_number(ratio, 2),
            interval=fixed_number(ratio * result.ratio_sigma, 2),
        )
        axes.set_title(title, fontsize=TEXT_SIZE, color=INK_COLOUR, loc="left")
    panels[0].yaxis.set_major_locator(MaxNLocator(nbins=8, integer=True))
    figure.suptitle(gettext(EXPLANATION_TEXT), fontsize=SMALL_TEXT_SIZE, color=INK_COLOUR)
    return figure
