"""Predicted precision of a plan, as numbers and texts."""

from dataclasses import dataclass

import numpy as np

from lispac.design.objective import PlanObjective
from lispac.design.plan import Plan
from lispac.design.plan_choices import have_targets_one_orientation
from lispac.design.plan_search import InformationGain, information_gains
from lispac.design.prediction import Prediction, predict
from lispac.gui.appearance import units
from lispac.io.config.plan_file import TitledPlan
from lispac.language import N_, Plural, gettext, number
from lispac.messages import Message, note
from lispac.progress import Progress, no_progress
from lispac.workflow.planning.plan_checks import observability_messages

NO_VALUE, UNDETERMINED = "–", N_("undetermined")


@dataclass(frozen=True, eq=False)
class PredictedPrecision:
    """Predicted precision, which is also shown while a line is dragged.

    Attributes
    ----------
    prediction : Prediction or None
        Prediction; None if the plan has no target or no line.
    refused : whether the adjustment would refuse such a survey
    """

    plan: Plan
    prediction: Prediction | None
    refused: bool

    @classmethod
    def of(cls, plan: Plan) -> "PredictedPrecision":
        """Predict the precision of a plan."""
        if not plan.targets or not plan.lines:
            return cls(plan, None, True)
        found = predict(plan)
        return cls(plan, found, not found.determined or have_targets_one_orientation(plan))

    @property
    def sigmas(self) -> tuple[str, str, str]:
        """Standard deviations of roll, pitch and yaw as texts."""
        if self.prediction is None or not self.prediction.determined:
            return NO_VALUE, NO_VALUE, NO_VALUE
        a, b, c = (sigma_text(float(v)) for v in np.degrees(self.prediction.sigma))
        return a, b, c

    @property
    def correlations(self) -> tuple[str, str, str]:
        """Correlations roll-pitch, roll-yaw, pitch-yaw as texts."""
        if self.prediction is None or not self.prediction.determined:
            return NO_VALUE, NO_VALUE, NO_VALUE
        rows = self.prediction.correlation
        a, b, c = (
            number(float(v), 2, sign=True).replace("-", "−")
            for v in (rows[0, 1], rows[0, 2], rows[1, 2])
        )
        return a, b, c


def sigma_text(degrees: float) -> str:
    """Text of a standard deviation in the unit and the language of the user."""
    if not np.isfinite(degrees):
        return gettext(UNDETERMINED)
    return units.localised(units.figure(degrees, "°", sigma_format(degrees)))


def sigma_format(degrees: float) -> str:
    """Format of a standard deviation in degrees."""
    return ".4f" if degrees < 5.0 else ".2f"


def plan_messages(plan: Plan, progress: Progress = no_progress) -> tuple[Message, ...]:
    """Messages on the observability of the angles, as after an adjustment."""
    if not plan.targets or not plan.lines:
        return (note("plan.empty"),)
    return observability_messages(plan, progress=progress)


def time_on_site_text(titled: TitledPlan) -> str:
    """Text of the time on site."""
    plan = titled.plan
    return gettext(
        Plural(
            "Time on site: {minutes:n} min for {count:n} line, turns included",
            "Time on site: {minutes:n} min for {count:n} lines, turns included",
        ),
        minutes=round(plan.duration / 60) if plan.lines else 0,
        count=len(plan.lines),
    )


def plan_information_gains(
    plan: Plan, progress: Progress = no_progress
) -> tuple[InformationGain, ...]:
    """Information gain of each target and line; empty if the plan lacks targets or lines."""
    return (
        information_gains(plan, PlanObjective(), progress=progress)
        if plan.targets and plan.lines
        else ()
    )
