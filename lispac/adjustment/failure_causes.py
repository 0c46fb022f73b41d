"""Search for the error that keeps an adjustment from converging.

A wrong sign of the attitude, a latency or a range offset can make the targets of different lines so
different that no boresight is found. Each candidate is corrected, or estimated, and the adjustment
is repeated. One that converges, and whose residuals pass the global chi-square test (Baarda 1968),
is a possible cause.
"""

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.message_parts import amount_with_unit, mounting_value_name
from lispac.adjustment.observations import Observations
from lispac.adjustment.parameters import Parameter
from lispac.adjustment.result import AdjustmentResult
from lispac.adjustment.solver import REJECTION_LEVEL, adjust, is_model_rejected
from lispac.adjustment.stochastic_model import StochasticModel
from lispac.errors import AdjustmentError, NotConverged
from lispac.language import gettext_lazy
from lispac.messages import Message, error, note
from lispac.progress import Progress, no_progress
from lispac.survey.georeferencing import Mounting

SIGN_CONVENTIONS = {
    "cause.wrong_roll_sign": (-1.0, 1.0, 1.0),
    "cause.wrong_pitch_sign": (1.0, -1.0, 1.0),
    "cause.wrong_roll_pitch_signs": (-1.0, -1.0, 1.0),
}
"""Code of each wrong sign convention, and factors on roll, pitch and heading."""
ESTIMATED_PARAMETERS = ("latency", "range_offset")
"""Values of the mounting that are estimated if they are not already."""


def adjust_or_explain(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    *,
    parameters: tuple[Parameter, ...] = (),
    components: bool = False,
    accept_single_orientation: bool = False,
    diagnostics: bool = True,
    progress: Progress = no_progress,
) -> AdjustmentResult:
    """`adjust`, with the possible causes in the reason where it does not converge.

    Raises
    ------
    AdjustmentError
        If the observations determine no boresight, or the adjustment does not converge.
    RankDeficient
        If a parameter is not determined.
    NotConverged
        With the causes that were found, the one that fits best first.
    """
    try:
        return adjust(
            observations, mounting, model, parameters=parameters, components=components,
            accept_single_orientation=accept_single_orientation, diagnostics=diagnostics,
            progress=progress,
        )  # fmt: skip
    except NotConverged as failure:
        reason = failure.reason
        progress(0.9, gettext_lazy("Searching for the cause"))
        for cause in find_failure_causes(observations, mounting, model, parameters=parameters):
            reason = error("estimate.possible_cause", reason=reason, cause=cause)
        raise NotConverged(reason) from None


def find_failure_causes(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    *,
    parameters: tuple[Parameter, ...] = (),
) -> tuple[Message, ...]:
    """Errors without which the adjustment converges and fits, the best fit first.

    Parameters
    ----------
    mounting, model, parameters : as in `adjust`
        The fit is judged with correlated POS errors: independent ones explain nearly everything.
    """
    model = replace(model, pos_errors="correlated", loss="tukey")
    found: list[tuple[float, Message]] = []
    for code, some, also in _candidates(observations, parameters):
        with suppress(AdjustmentError, np.linalg.LinAlgError):
            result = adjust(
                some, mounting, model, parameters=(*parameters, *also),
                accept_single_orientation=True, diagnostics=False,
            )  # fmt: skip
            determined = all(each.value is not None for each in result.parameters)
            if determined and not is_model_rejected(result, REJECTION_LEVEL):
                message = _value_message(result, also[0].name) if also else note(code)
                found.append((result.variance_factor, message))
    return tuple(message for _, message in sorted(found, key=lambda each: each[0]))


def _candidates(
    observations: Observations, parameters: tuple[Parameter, ...]
) -> Iterator[tuple[str, Observations, tuple[Parameter, ...]]]:
    """Code, corrected observations and further parameters of each candidate."""
    for code, signs in SIGN_CONVENTIONS.items():
        yield code, _with_attitude_signs(observations, np.array(signs)), ()
    for name in ESTIMATED_PARAMETERS:
        if name == "latency" and observations.pose_rate is None:
            continue
        if all(each.name != name for each in parameters):
            yield "", observations, (Parameter(name),)


def _with_attitude_signs(observations: Observations, signs: NDArray[np.float64]) -> Observations:
    rate = observations.pose_rate
    if rate is not None:
        rate = np.column_stack([rate[:, :3], rate[:, 3:] * signs])
    return replace(observations, attitude=observations.attitude * signs, pose_rate=rate)


def _value_message(result: AdjustmentResult, name: str) -> Message:
    """A value of the mounting that is wrong, with the change that was estimated."""
    (estimate,) = (each for each in result.parameters if each.name == name)
    change = (estimate.value or 0.0) - estimate.prior
    return note(
        "cause.wrong_value",
        change=note(
            "cause.larger" if change > 0 else "cause.smaller",
            parameter=mounting_value_name(name),
            amount=amount_with_unit(name, abs(change)),
        ),
    )
