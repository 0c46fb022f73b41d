"""Predicted precision of a plan, as numbers and texts."""

from dataclasses import dataclass

import numpy as np

from lispac.design.choices import faces_one_way
from lispac.design.objective import Objective
from lispac.design.plan import Plan
from lispac.design.prediction import Prediction, predict
from lispac.design.search import InformationGain, worth
from lispac.gui import units
from lispac.io.plan_file import TitledPlan
from lispac.language import N_, Plural, gettext, number
from lispac.messages import Message, note
from lispac.progress import Progress, no_progress
from lispac.workflow.plan_checks import remarks_on

UNKNOWN, OPEN = "–", N_("undetermined")


@dataclass(frozen=True, eq=False)
class PredictedPrecision:
    """Predicted precision, which is shown while a line is dragged.

    Attributes
    ----------
    prediction : Prediction or None
        None where the plan has no target or no line.
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
        return cls(plan, found, not found.determined or faces_one_way(plan))

    @property
    def sigmas(self) -> tuple[str, str, str]:
        """Standard deviations of roll, pitch and yaw as texts."""
        if self.prediction is None or not self.prediction.determined:
            return UNKNOWN, UNKNOWN, UNKNOWN
        a, b, c = (sigma_text(float(v)) for v in np.degrees(self.prediction.sigma))
        return a, b, c

    @property
    def correlations(self) -> tuple[str, str, str]:
        """Correlations roll-pitch, roll-yaw, pitch-yaw as texts."""
        if self.prediction is None or not self.prediction.determined:
            return UNKNOWN, UNKNOWN, UNKNOWN
        rows = self.prediction.correlation
        a, b, c = (
            number(float(v), 2, sign=True).replace("-", "−")
            for v in (rows[0, 1], rows[0, 2], rows[1, 2])
        )
        return a, b, c


def sigma_text(degrees: float) -> str:
    """A standard deviation in the unit and the language of the user."""
    if not np.isfinite(degrees):
        return gettext(OPEN)
    return units.localised(units.figure(degrees, "°", form(degrees)))


def form(degrees: float) -> str:
    """Format of a standard deviation."""
    return ".4f" if degrees < 5.0 else ".2f"


def remarks(plan: Plan, progress: Progress = no_progress) -> tuple[Message, ...]:
    """Observability of the angles, as after an adjustment."""
    if not plan.targets or not plan.lines:
        return (note("plan.empty"),)
    return remarks_on(plan, progress=progress)


def minutes(titled: TitledPlan) -> str:
    """Time on site as a text."""
    plan = titled.plan
    return gettext(
        Plural(
            "Time on site: {minutes:n} min for {count:n} line, turns included",
            "Time on site: {minutes:n} min for {count:n} lines, turns included",
        ),
        minutes=round(plan.duration / 60) if plan.lines else 0,
        count=len(plan.lines),
    )


def worths(plan: Plan, progress: Progress = no_progress) -> tuple[InformationGain, ...]:
    """Information gain of each target and line; empty where there is only one."""
    return worth(plan, Objective(), progress=progress) if plan.targets and plan.lines else ()
