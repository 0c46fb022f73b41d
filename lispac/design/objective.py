"""Objective of a plan: one number computed from the covariance of the three angles.

A- and D-optimality are defined as in optimal design (Atkinson and Donev 1992), but converted to an
angle in radians.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.design.plan import Plan
from lispac.design.prediction import Prediction, predict
from lispac.language import N_

Array = NDArray[np.float64]

Criterion = Literal["largest", "roll", "pitch", "yaw", "A", "D"]
CRITERION_TEXTS: dict[Criterion, str] = {
    "largest": N_("largest of the three standard deviations"),
    "roll": N_("standard deviation of roll"),
    "pitch": N_("standard deviation of pitch"),
    "yaw": N_("standard deviation of yaw"),
    "A": N_("root mean square of the three standard deviations (A-optimality)"),
    "D": N_("mean radius of the confidence ellipsoid (D-optimality)"),
}
"""Description of each criterion."""

PRIOR_ANGLE_SIGMA = np.radians(10.0)
"""Sigma of the angles before the survey, radians.

With it, the objective of a plan that does not determine all angles is finite, so that a search can
compare such plans.
"""

CRITERION_FUNCTIONS: dict[Criterion, Callable[[Array], float]] = {
    "largest": lambda covariance: float(np.sqrt(np.diag(covariance).max())),
    "roll": lambda covariance: float(np.sqrt(covariance[0, 0])),
    "pitch": lambda covariance: float(np.sqrt(covariance[1, 1])),
    "yaw": lambda covariance: float(np.sqrt(covariance[2, 2])),
    "A": lambda covariance: float(np.sqrt(np.trace(covariance) / 3)),
    "D": lambda covariance: float(np.linalg.det(covariance) ** (1 / 6)),
}
"""Function that computes the value of each criterion from the covariance of the angles."""


@dataclass(frozen=True)
class PlanObjective:
    """Objective function of the search for a plan, to be minimised.

    Attributes
    ----------
    criterion : {"largest", "roll", "pitch", "yaw", "A", "D"}
    pos_factors : tuple of float
        Factors applied to the given POS sigmas. The objective is the mean over all factors, since
        the accuracy of the POS on the day of the survey is not known.
    """

    criterion: Criterion = "largest"
    pos_factors: tuple[float, ...] = (1.0,)

    def of(self, plan: Plan) -> float:
        """Objective value of a plan, radians."""
        return self._mean_over_pos_factors(plan, None)

    def of_prediction(self, plan: Plan, found: Prediction) -> float:
        """Objective value of a predicted plan, radians; infinite if an angle is undetermined."""
        return self._mean_over_pos_factors(plan, found) if found.determined else float("inf")

    def _mean_over_pos_factors(self, plan: Plan, nominal: Prediction | None) -> float:
        found = [
            nominal
            if nominal is not None and factor == 1.0
            else predict(_scale_pos_errors(plan, factor))
            for factor in self.pos_factors
        ]
        return float(np.mean([self.value_of_prediction(each) for each in found]))

    def value_of_prediction(self, prediction: Prediction) -> float:
        """Value of the criterion, radians; the largest sigma if not all angles are determined."""
        covariance = np.linalg.inv(prediction.information + np.eye(3) / PRIOR_ANGLE_SIGMA**2)
        criterion: Criterion = self.criterion if prediction.determined else "largest"
        return CRITERION_FUNCTIONS[criterion](covariance)


def _scale_pos_errors(plan: Plan, factor: float) -> Plan:
    return plan if factor == 1.0 else replace(plan, system=plan.system.with_pos_scaled(factor))
