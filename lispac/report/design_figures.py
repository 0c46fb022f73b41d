"""Plots of a design: what one thing changes, and what less effort costs."""

from collections.abc import Sequence

import numpy as np
from matplotlib.figure import Figure

from lispac.adjustment.result import ANGLES
from lispac.adjustment.stochastic import PosErrors
from lispac.design.scenarios import Outcome
from lispac.design.search import Step
from lispac.report.figures import AFTER, BEFORE, INK, SMALL, TEXT, blank, dress

COLOURS = (BEFORE, AFTER, "#228833")
"""Of roll, pitch and yaw; told apart with any colour vision."""

NAMES: dict[PosErrors, str] = {
    "correlated": "POS errors that drift",
    "independent": "every point its own POS error (thesis)",
}


def scenario_figure(found: Sequence[Outcome], figure: Figure | None = None) -> Figure:
    """Sigmas of roll, pitch and yaw for each case of one scenario, in both stochastic models."""
    models = [m for m in NAMES if any(each.pos_errors == m for each in found)]
    cases = list(dict.fromkeys(each.case for each in found))
    figure = blank(figure, (6.3, 0.9 + 1.9 * len(models)))
    panels = figure.subplots(len(models), 1, sharex=True, squeeze=False)[:, 0]
    for axes, model in zip(panels, models, strict=True):
        own = {each.case: np.degrees(each.sigma) for each in found if each.pos_errors == model}
        table = np.array([own[case] for case in cases])
        highest = table[np.isfinite(table)].max(initial=0.0)
        for k, (angle, colour) in enumerate(zip(ANGLES, COLOURS, strict=True)):
            at = np.arange(len(cases)) + 0.27 * (k - 1)
            axes.bar(at, np.where(np.isfinite(table[:, k]), table[:, k], 0.0), 0.25, color=colour,
                     label=angle)  # fmt: skip
        for x in np.flatnonzero(~np.isfinite(table).all(axis=1)):
            axes.text(x, 0.03 * highest, "not determined", rotation=90, fontsize=SMALL, color=INK,
                      ha="center", va="bottom")  # fmt: skip
        dress(axes, "", "1 sigma (deg)")
        axes.set_title(NAMES[model], fontsize=TEXT, color=INK, loc="left")
        axes.set_ylim(0.0, 1.12 * highest if highest > 0 else 1.0)
    turned = max(map(len, cases)) * len(cases) > 70
    panels[-1].set_xticks(
        range(len(cases)), cases, fontsize=SMALL, rotation=30 if turned else 0,
        ha="right" if turned else "center",
    )  # fmt: skip
    figure.legend(*panels[0].get_legend_handles_labels(), loc="outside upper right", ncols=3,
                  fontsize=SMALL, frameon=False)  # fmt: skip
    return figure


def front_figure(front: Sequence[Step], label: str, figure: Figure | None = None) -> Figure:
    """What less time costs: the objective against the minutes of each plan.

    Parameters
    ----------
    label : str
        What the objective is, in words.
    """
    figure = blank(figure, (6.3, 2.8))
    axes = figure.subplots()
    minutes = [step.minutes for step in front]
    values = np.degrees([step.value for step in front])
    axes.plot(minutes, values, "o-", color=BEFORE, markersize=4, linewidth=1.0)
    for step, x, y in zip(front, minutes, values, strict=True):
        said = f"{len(step.plan.targets)} x {len(step.plan.lines)}"
        axes.annotate(said, (x, y), xytext=(4, 4), textcoords="offset points", fontsize=SMALL,
                      color=INK)  # fmt: skip
    dress(axes, "Minutes on site (targets x lines beside each)", f"{label} (deg)")
    axes.set_ylim(0.0, 1.15 * values.max())
    return figure
