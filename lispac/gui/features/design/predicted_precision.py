"""Predicted precision of a plan, as numbers and texts."""

from dataclasses import dataclass

from lispac.design.objective import PlanObjective
from lispac.design.plan import Plan
from lispac.design.plan_choices import have_targets_one_orientation
from lispac.design.plan_search import InformationGain, information_gains
from lispac.design.prediction import predict
from lispac.gui.widgets.result_tables import local_number
from lispac.io.config.plan_file import TitledPlan
from lispac.language import Plural, gettext
from lispac.messages import Message, note
from lispac.present.planning import NOTHING_PREDICTED, PredictionValues
from lispac.present.tables import DEGREES
from lispac.present.text_format import UNKNOWN_TEXT
from lispac.progress import Progress, no_progress
from lispac.workflow.planning.plan_checks import observability_messages


@dataclass(frozen=True, eq=False)
class PredictedPrecision:
    """Predicted precision, which is also shown while a line is dragged.

    Attributes
    ----------
    refused : whether the adjustment would refuse such a survey
    """

    plan: Plan
    prediction: PredictionValues
    refused: bool

    @classmethod
    def of(cls, plan: Plan) -> "PredictedPrecision":
        """Predict the precision of a plan."""
        if not plan.targets or not plan.lines:
            return cls(plan, NOTHING_PREDICTED, True)
        found = PredictionValues.of(predict(plan))
        return cls(plan, found, not found.determined or have_targets_one_orientation(plan))

    @property
    def sigmas(self) -> tuple[str, ...]:
        """Standard deviations of roll, pitch and yaw as texts, in the unit of the user."""
        sigma = self.prediction.sigma_deg
        if sigma is None:
            return (UNKNOWN_TEXT,) * 3
        return tuple(local_number(value, DEGREES) for value in sigma)

    @property
    def largest_deg(self) -> float | None:
        """Largest of the standard deviations; None if they are not determined."""
        return None if self.prediction.sigma_deg is None else max(self.prediction.sigma_deg)


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
