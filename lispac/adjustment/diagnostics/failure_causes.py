"""Search for the error that prevents an adjustment from converging or makes its result wrong.

With a wrong sign of the attitude, a latency, a range offset or a wrong lever arm, the targets may
differ so much from line to line that the adjustment does not converge, or converges far from the
true angles. It is repeated with each of these errors corrected or estimated. If it then converges,
and the residuals pass the global chi-square test (Baarda 1968), this error is a possible cause.
"""

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.diagnostics.possible_causes import PRIOR_ERROR_SIGMAS
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import Parameter, changed_value, has_opposite_sign
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import AdjustmentResult, PossibleCause
from lispac.adjustment.solve.solver import SolverSettings, estimate
from lispac.errors import AdjustmentError
from lispac.language import gettext_lazy
from lispac.messages import Message, note
from lispac.progress import Progress, no_progress, sub_progress, without_steps
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
MAX_RMS_RATIO = 0.25
"""Largest ratio of the RMS distance with the best candidate to that without it and to that with any
other candidate."""


def find_failure_causes(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    *,
    parameters: tuple[Parameter, ...] = (),
    progress: Progress = no_progress,
) -> tuple[Message, ...]:
    """Find errors whose correction makes the adjustment converge and fit, the best fit first.

    Parameters
    ----------
    mounting, model, parameters : as in `adjust`
        The correlated model with the loss of Tukey is used in any case, because independent POS
        errors would explain nearly any residuals.
    """
    found: list[tuple[float, Message]] = []
    steps = _equal_steps(progress, len(WRONG_SIGN_CONVENTIONS) + len(TESTED_PARAMETERS))
    for code, some, also in _candidates(observations, parameters):
        result = _estimate(some, mounting, model, (*parameters, *also), next(steps))
        if result is not None and not result.is_model_rejected(REJECTION_LEVEL):
            message = _value_message(result, also[0].name) if also else note(code)
            found.append((result.variance_factor, message))
    return tuple(message for _, message in sorted(found, key=lambda each: each[0]))


def find_wrong_value(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    result: AdjustmentResult,
    *,
    parameters: tuple[Parameter, ...] = (),
    progress: Progress = no_progress,
) -> PossibleCause | None:
    """Find the value of the mounting whose error explains implausible residuals.

    Parameters
    ----------
    observations : Observations
        Points as they were picked. A selection with the angles of ``result`` may have lost those
        that show the error.
    mounting, model, parameters : as in `find_failure_causes`
    result : AdjustmentResult
        Result without a correction of the value.

    Returns
    -------
    PossibleCause or None
        None unless the residuals with one value, and no other, are much smaller and agree with the
        error model.
    """
    found: list[tuple[float, Parameter, AdjustmentResult]] = []
    steps = _equal_steps(progress, len(TESTED_PARAMETERS))
    for _, _, also in _candidates(observations, parameters):
        if also:
            freed = _estimate(observations, mounting, model, (*parameters, *also), next(steps))
            if freed is not None:
                found.append((freed.rms_after, also[0], freed))
    found.sort(key=lambda each: each[0])
    if not found or found[0][2].is_model_rejected(REJECTION_LEVEL):
        return None
    (best, parameter, freed), others = found[0], [each[0] for each in found[1:]]
    if best > MAX_RMS_RATIO * min([result.rms_after, *others]):
        return None
    (value,) = (each for each in freed.parameters if each.name == parameter.name)
    assert value.value is not None
    assert value.sigma is not None
    size, sigma = value.value - value.prior, value.sigma
    # The Bayes factor of Laplace's approximation, with the prior of the other search
    evidence = (size / sigma) ** 2 + 2 * np.log(sigma / PRIOR_ERROR_SIGMAS[parameter.name])
    return PossibleCause(
        parameter.name, "", "", np.array([size]), np.array([sigma]),
        freed.boresight - result.boresight, float(np.sqrt(result.rms_after**2 - best**2)),
        float(evidence),
    )  # fmt: skip


def _estimate(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    parameters: tuple[Parameter, ...],
    progress: Progress,
) -> AdjustmentResult | None:
    """Result with the correlated model; None if it does not converge or a value is undetermined."""
    model = replace(model, pos_errors="correlated", loss="tukey")
    progress(0.0, gettext_lazy("Searching for a wrong value of the mounting or a wrong sign"))
    with suppress(AdjustmentError, np.linalg.LinAlgError):
        settings = SolverSettings(model, parameters=parameters, accept_single_orientation=True)
        result = estimate(observations, mounting, settings, without_steps(progress))
        if all(each.value is not None for each in result.parameters):
            return result
    return None


def _equal_steps(progress: Progress, most: int) -> Iterator[Progress]:
    """Progress of each of at most ``most`` candidates."""
    for k in range(most):
        yield sub_progress(progress, k / most, (k + 1) / most)


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
    is_opposite = has_opposite_sign(estimate.prior, change, estimate.sigma or 0.0)
    return note(
        "cause.wrong_value",
        change=changed_value(name, change, has_opposite_sign=is_opposite),
        subject=_cause_of_value(name),
    )


def _cause_of_value(name: str) -> Cause:
    """Cause that is the field of the lever arm, or another value of the mounting."""
    return Cause.of_field("lever_arm") if name.startswith("lever_") else Cause.of_parameter(name)
