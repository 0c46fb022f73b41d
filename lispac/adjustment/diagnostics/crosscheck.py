"""Cross-checks: adjustments of parts of the data, compared with the adjustment of all data."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.result import AdjustmentResult, CrossCheck, CrossChecks
from lispac.adjustment.solve.solver import SolverSettings, estimate
from lispac.errors import AdjustmentError
from lispac.language import gettext_lazy
from lispac.messages import as_message, note
from lispac.progress import Progress, no_progress
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]
MIN_DIFFERENCE_SIGMA_RATIO = 1 / 6
"""Smallest sigma of a difference that is used, as a fraction of the sigma of the whole result.

With it, a difference below half a sigma of the whole result is never significant.
"""

DataPart = tuple[str, str, NDArray[np.bool_]]
"""Kind and name of a part of the data as in `CrossCheck`, and mask of its sightings."""


def cross_checks(
    observations: Observations,
    mounting: Mounting,
    result: AdjustmentResult,
    parameters: tuple[Parameter, ...] = (),
    *,
    progress: Progress = no_progress,
) -> CrossChecks:
    """Adjust again without each line, without each target, and for each half of the survey in time.

    Parameters
    ----------
    mounting : Mounting
        Mounting that was given to the adjustment of ``result``.
    """
    start = mounting.with_boresight(result.boresight)
    observations, result = apply_rejections_and_surfaces(observations, result.with_formal_sigmas)
    result, parameters = _fix_undetermined_parameters(observations, start, result, parameters)
    omitted, halves = [*_leave_one_out_parts(observations)], [*_survey_halves(observations)]
    parts = [*omitted, *halves]
    count = len(omitted) + min(len(halves), 1)  # the comparison of the halves is one check
    found: list[CrossCheck] = []
    for k, (kind, name, keep) in enumerate(parts):
        progress(
            k / len(parts),
            gettext_lazy(
                "Cross-check {number:n} of {count:n}", number=min(k + 1, count), count=count
            ),
        )
        found.append(_cross_check_part(observations, start, result, parameters, kind, name, keep))
    progress(1.0)
    return CrossChecks(tuple(_compare_halves(found)))


def apply_rejections_and_surfaces(
    observations: Observations, result: AdjustmentResult
) -> tuple[Observations, AdjustmentResult]:
    """Apply the rejections and the surface sigmas of the whole adjustment to points and model.

    If noise, surface sigmas and rejections were estimated again from fewer sightings, their changes
    would add to the differences between parts. The noise is taken from
    `AdjustmentResult.noise_factors`.
    """
    kept = np.array(
        [
            s not in result.rejected_sightings and s.target not in result.excluded_targets
            for s in observations.sightings
        ]
    )
    observations = observations.of_sightings(kept)
    if result.model.correlated:
        surface, _, offset = np.maximum(result.surfaces, 1e-5 if result.model.surface != 0 else 0.0)
        model = replace(result.model, surface=float(surface), offset=float(offset))
        result = replace(result, model=model)
    return observations, result


def _fix_undetermined_parameters(
    observations: Observations,
    start: Mounting,
    result: AdjustmentResult,
    parameters: tuple[Parameter, ...],
) -> tuple[AdjustmentResult, tuple[Parameter, ...]]:
    """Result and parameters without the values that the geometry does not determine.

    The given sigma of such a value increases the sigmas of the angles, but it affects all parts in
    the same way. With these sigmas, significant differences between parts would not be detected.
    """
    fixed = {each.name for each in result.parameters if each.value is None}
    free = tuple(each for each in parameters if each.name not in fixed)
    if not any(each.name in fixed and each.prior_sigma is not None for each in result.parameters):
        return result, free
    whole = estimate(observations, start, _settings_of_part(result, free))
    return replace(result, covariance_all=whole.covariance_all, estimated=whole.estimated), free


def _settings_of_part(
    result: AdjustmentResult, parameters: tuple[Parameter, ...]
) -> SolverSettings:
    return SolverSettings(
        result.model, parameters, noise=result.noise_factors, accept_single_orientation=True
    )


def _leave_one_out_parts(observations: Observations) -> Iterator[DataPart]:
    for line in observations.lines:
        yield "line", line, np.array([s.line != line for s in observations.sightings])
    for target in observations.targets:
        yield "target", target, np.array([s.target != target for s in observations.sightings])


def _survey_halves(observations: Observations) -> Iterator[DataPart]:
    """Two halves of the survey: the lines in order of time, divided in the middle."""
    times = observations.mean_by_sighting(observations.time)
    lines_by_time = sorted(
        observations.lines,
        key=lambda line: np.mean(
            [t for t, s in zip(times, observations.sightings, strict=True) if s.line == line]
        ),
    )
    middle = (len(lines_by_time) + 1) // 2
    for name, lines in (("first", lines_by_time[:middle]), ("second", lines_by_time[middle:])):
        yield "half", name, np.array([s.line in lines for s in observations.sightings])


def _cross_check_part(
    observations: Observations, start: Mounting, result: AdjustmentResult,
    parameters: tuple[Parameter, ...], kind: str, name: str, keep: NDArray[np.bool_],
) -> CrossCheck:  # fmt: skip
    keep = keep & _is_target_checked(observations, keep)
    if not keep.any():
        return CrossCheck(kind, name, reason=note("cross_check.no_common_target"))
    try:
        settings = _settings_of_part(result, parameters)
        part = estimate(observations.of_sightings(keep), start, settings)
    except AdjustmentError as failure:
        return CrossCheck(kind, name, reason=as_message(failure.reason))
    difference = part.boresight - result.boresight
    # The variance of the difference is the difference of the variances (Hausman 1978).
    spread = np.sqrt(np.maximum(np.diag(part.covariance - result.covariance), 0))
    floor = MIN_DIFFERENCE_SIGMA_RATIO * result.sigma
    return CrossCheck(
        kind, name, part.boresight, part.sigma, difference, difference / np.maximum(spread, floor)
    )


def _is_target_checked(observations: Observations, keep: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Whether the target of each sighting has at least two of the kept sightings, or control."""
    owners, control = observations.target_of_sighting, observations.control
    counts = np.bincount(owners[keep], minlength=len(observations.targets))
    surveyed = () if control is None else control.targets
    has_control = np.array([target in surveyed for target in observations.targets], dtype=bool)
    return np.asarray((counts >= 2) | has_control)[owners]


def _compare_halves(found: list[CrossCheck]) -> Iterator[CrossCheck]:
    """Compare the two halves with each other, since they have no line in common."""
    halves = [check for check in found if check.kind == "half"]
    yield from (check for check in found if check.kind != "half")
    first, second = halves
    if first.boresight is None or first.sigma is None or second.boresight is None \
            or second.sigma is None:  # fmt: skip
        yield from halves
        return
    difference = first.boresight - second.boresight
    significance = difference / np.hypot(first.sigma, second.sigma)
    for half, sign in ((first, 1), (second, -1)):
        yield CrossCheck(
            "half", half.part, half.boresight, half.sigma, sign * difference, sign * significance
        )
