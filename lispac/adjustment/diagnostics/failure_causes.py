"""Search for the error that prevents an adjustment from converging.

With a wrong sign of the attitude, a latency, a range offset or a wrong lever arm, the targets may
differ so much from line to line that the adjustment does not converge. It is repeated with each of
these errors corrected or estimated. If it then converges, and the residuals pass the global chi-
square test (Baarda 1968), this error is a possible cause.
"""

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import Parameter, amount_with_unit, mounting_value_name
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import AdjustmentResult
from lispac.adjustment.solve.solver import SolverSettings, estimate
from lispac.errors import AdjustmentError
from lispac.messages import Message, note
from lispac.survey.georeferencing import Mounting
from lispac.warning_causes import Cause

WRONG_SIGN_CONVENTIONS = {
    "cause.wrong_roll_sign": (-1.0, 1.0, 1.0),
    "cause.wrong_pitch_sign": (1.0, -1.0, 1.0),
    "cause.wrong_roll_pitch_signs": (-1.0, -1.0, 1.0),
}
"""Code of each wrong sign convention, and factors on roll, pitch and heading."""
TESTED_PARAMETERS = ("latency", "range_offset", "lever_x", "lever_y", "lever_z")
"""Values of the mounting that are tested as causes by estimating them."""
REJECTION_LEVEL = 1e-4
"""Significance level of the chi-square test: probability that a correct model is rejected."""


def find_failure_causes(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    *,
    parameters: tuple[Parameter, ...] = (),
) -> tuple[Message, ...]:
    """Find errors whose correction makes the adjustment converge and fit, the best fit first.

    Parameters
    ----------
    mounting, model, parameters : as in `adjust`
        The correlated model with the loss of Tukey is used in any case, because independent POS
        errors would explain nearly any residuals.
    """
    model = replace(model, pos_errors="correlated", loss="tukey")
    found: list[tuple[float, Message]] = []
    for code, some, also in _candidates(observations, parameters):
        with suppress(AdjustmentError, np.linalg.LinAlgError):
            settings = SolverSettings(
                model, parameters=(*parameters, *also), accept_single_orientation=True
            )
            result = estimate(some, mounting, settings)
            determined = all(each.value is not None for each in result.parameters)
            if determined and not result.is_model_rejected(REJECTION_LEVEL):
                message = _value_message(result, also[0].name) if also else note(code)
                found.append((result.variance_factor, message))
    return tuple(message for _, message in sorted(found, key=lambda each: each[0]))


def _candidates(
    observations: Observations, parameters: tuple[Parameter, ...]
) -> Iterator[tuple[str, Observations, tuple[Parameter, ...]]]:
    """Code, corrected observations and additional parameters of each candidate."""
    for code, signs in WRONG_SIGN_CONVENTIONS.items():
        yield code, with_attitude_signs(observations, np.array(signs)), ()
    for name in TESTED_PARAMETERS:
        if name == "latency" and observations.pose_rate is None:
            continue
        if all(each.name != name for each in parameters):
            yield "", observations, (Parameter(name),)


def with_attitude_signs(observations: Observations, signs: NDArray[np.float64]) -> Observations:
    """Observations with other signs of the attitude.

    Parameters
    ----------
    signs : ndarray of shape (3,)
        Factors on roll, pitch and heading, 1 or -1.
    """
    rate = observations.pose_rate
    if rate is not None:
        rate = np.column_stack([rate[:, :3], rate[:, 3:] * signs])
    return replace(observations, attitude=observations.attitude * signs, pose_rate=rate)


def _value_message(result: AdjustmentResult, name: str) -> Message:
    """Message that a value of the mounting is wrong, with its estimated change."""
    (estimate,) = (each for each in result.parameters if each.name == name)
    change = (estimate.value or 0.0) - estimate.prior
    return note(
        "cause.wrong_value",
        change=note(
            "cause.larger" if change > 0 else "cause.smaller",
            parameter=mounting_value_name(name),
            amount=amount_with_unit(name, abs(change)),
        ),
        subject=_place_of(name),
    )


def _place_of(name: str) -> Cause:
    """Field of the lever arm, or the switch of another value of the mounting."""
    return Cause.of_field("lever_arm") if name.startswith("lever_") else Cause.of_parameter(name)
