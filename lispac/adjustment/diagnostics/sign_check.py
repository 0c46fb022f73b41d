"""Check of assumed signs of roll and pitch by the residuals of the adjustment.

The residuals with the assumed signs must be about as large as predicted by the variance factor
(Baarda 1968), and those with each opposite sign must be much larger.
"""

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from lispac.adjustment.diagnostics.failure_causes import (
    WRONG_SIGN_CONVENTIONS,
    with_attitude_signs,
)
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.result import AdjustmentResult
from lispac.adjustment.solve.solver import SolverSettings, estimate
from lispac.errors import AdjustmentError
from lispac.messages import Message, note
from lispac.survey.georeferencing import Mounting
from lispac.warning_causes import RESULT_CAUSE

ASSUMED_SIGN_CODES = {
    "sbet.zero_rates", "sbet.signs_not_checked", "trajectory.roll_starboard_down",
    "trajectory.roll_port_down", "trajectory.pitch_bow_up", "trajectory.pitch_bow_down",
}  # fmt: skip
"""Codes of the warnings of the import that a sign of roll or pitch is assumed."""
SIGNS_AGREE_CODE = "adjustment.signs_agree"
"""Code of the note that replaces these warnings."""
MIN_RESIDUAL_RATIO = 2.0
"""Smallest ratio of the residuals with an opposite sign to those with the assumed signs at which
the signs can be distinguished."""
MAX_VARIANCE_FACTOR = 2.0
"""Largest variance factor at which the residuals confirm the signs.

A test at a level of significance would fail with many points because of small errors in the given
standard deviations, which no sign can cause.
"""


def is_sign_assumed(messages: Iterable[Message]) -> bool:
    """True if the messages about the files say that a sign of roll or pitch is assumed."""
    return any(each.code in ASSUMED_SIGN_CODES for each in messages)


def sign_agreement(
    observations: Observations,
    mounting: Mounting,
    result: AdjustmentResult,
    parameters: tuple[Parameter, ...],
) -> Message | None:
    """Note that the residuals agree with the assumed signs only; None if they do not show it.

    The observations are adjusted again with the opposite sign of roll, of pitch and of both. All
    adjustments have the same weights, without a robust loss, so that outliers have the same
    effect on each of them. A sign with which the adjustment does not converge does not agree.

    Parameters
    ----------
    observations : Observations
        Observations with the sigmas of the complete adjustment.
    mounting, parameters : as in `adjust`
    result : AdjustmentResult
        Result of the complete adjustment.
    """
    if not result.model.correlated or result.variance_factor > MAX_VARIANCE_FACTOR:
        return None
    settings = SolverSettings(
        replace(result.model, loss="none"), parameters, accept_single_orientation=True
    )
    factors = []
    for signs in ((1.0, 1.0, 1.0), *WRONG_SIGN_CONVENTIONS.values()):
        some = with_attitude_signs(observations, np.array(signs))
        try:
            factors.append(estimate(some, mounting, settings).variance_factor)
        except (AdjustmentError, np.linalg.LinAlgError):
            factors.append(np.inf)
    assumed, *opposite = np.sqrt(factors)
    if not np.isfinite(assumed) or min(opposite) < MIN_RESIDUAL_RATIO * assumed:
        return None
    ratio = min([each / assumed for each in opposite if np.isfinite(each)] or [MIN_RESIDUAL_RATIO])
    return note(SIGNS_AGREE_CODE, ratio=float(np.floor(ratio)), subject=RESULT_CAUSE)
