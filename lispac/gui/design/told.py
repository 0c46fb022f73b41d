"""What a plan would give, in numbers and sentences; knows no window."""

from dataclasses import dataclass

import numpy as np

from lispac.design.choices import faces_one_way
from lispac.design.objective import Objective
from lispac.design.plan import Plan
from lispac.design.prediction import Prediction, predict
from lispac.design.search import Worth, worth
from lispac.gui import units
from lispac.io.plan_file import TitledPlan
from lispac.progress import Progress, no_progress
from lispac.workflow.designing import words_of

EMPTY = "Nothing to calibrate with yet: add a target and at least two lines."
UNKNOWN, OPEN = "–", "open"


@dataclass(frozen=True, eq=False)
class Told:
    """What is told while a line is dragged.

    Attributes
    ----------
    prediction : Prediction or None
        None where there is nothing to foretell from.
    refused : whether the adjustment would refuse such a survey
    """

    plan: Plan
    prediction: Prediction | None
    refused: bool

    @classmethod
    def of(cls, plan: Plan) -> "Told":
        """Foretell a plan."""
        if not plan.targets or not plan.lines:
            return cls(plan, None, True)
        found = predict(plan)
        return cls(plan, found, not found.determined or faces_one_way(plan))

    @property
    def sigmas(self) -> tuple[str, str, str]:
        """Of roll, pitch, yaw."""
        if self.prediction is None or not self.prediction.determined:
            return UNKNOWN, UNKNOWN, UNKNOWN
        a, b, c = (sigma_words(float(v)) for v in np.degrees(self.prediction.sigma))
        return a, b, c

    @property
    def correlations(self) -> tuple[str, str, str]:
        """Roll-pitch, roll-yaw, pitch-yaw."""
        if self.prediction is None or not self.prediction.determined:
            return UNKNOWN, UNKNOWN, UNKNOWN
        rows = self.prediction.correlation
        a, b, c = (
            f"{float(v):+.2f}".replace("-", "−") for v in (rows[0, 1], rows[0, 2], rows[1, 2])
        )
        return a, b, c


def sigma_words(degrees: float) -> str:
    """A sigma as it is written, in the unit shown."""
    if not np.isfinite(degrees):
        return OPEN
    return units.figure(degrees, "°", form(degrees))


def form(degrees: float) -> str:
    """How many decimals a sigma has."""
    return ".4f" if degrees < 5.0 else ".2f"


def sentences(plan: Plan, progress: Progress = no_progress) -> tuple[str, ...]:
    """What the geometry of a plan sees, as after an adjustment."""
    return words_of(plan, progress=progress) if plan.targets and plan.lines else (EMPTY,)


def minutes(titled: TitledPlan) -> str:
    """Time on site."""
    plan = titled.plan
    if not plan.lines:
        return "no line yet"
    return f"{plan.duration / 60:.0f} min for {len(plan.lines)} lines, turns included"


def worths(plan: Plan, progress: Progress = no_progress) -> tuple[Worth, ...]:
    """What each target and line is worth; nothing where one is all there is."""
    return worth(plan, Objective(), progress=progress) if plan.targets and plan.lines else ()
