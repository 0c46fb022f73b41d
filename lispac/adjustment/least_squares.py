"""Least-squares adjustment of mounting and targets, with diagnostics (thesis B.3)."""

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.diagnostics.control_tests import (
    assess_control,
    contradicting_control,
)
from lispac.adjustment.diagnostics.excess_scatter import leave_out_sigma_factors, with_raised_sigmas
from lispac.adjustment.diagnostics.failure_causes import REJECTION_LEVEL, find_failure_causes
from lispac.adjustment.diagnostics.lever_arm_uncertainty import with_lever_arm_effect
from lispac.adjustment.diagnostics.observability import assess_observability
from lispac.adjustment.diagnostics.pos_correction_estimate import estimate_pos_corrections
from lispac.adjustment.diagnostics.possible_causes import find_possible_causes
from lispac.adjustment.diagnostics.reliability import compute_reliability
from lispac.adjustment.diagnostics.sphere_radii import find_radius_discrepancies
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import OPTIONAL_NAMES, Parameter
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import SIGMA_GROUPS, AdjustmentResult, SigmaGroup
from lispac.adjustment.solve.noise_estimation import lidar_noise_ratio
from lispac.adjustment.solve.omitted_parameters import find_contradicted_parameters
from lispac.adjustment.solve.solution import Solution
from lispac.adjustment.solve.solver import SolverSettings, estimate, solve, with_agreeing_targets
from lispac.errors import AdjustmentError, NotConverged
from lispac.language import gettext_lazy
from lispac.messages import as_message, error
from lispac.progress import Progress, no_progress
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

MAX_NOISE_ROUNDS = 4
"""Largest number of times that the LiDAR noise is determined from the residuals."""
NOISE_TOLERANCE = 0.002
"""Relative change of the LiDAR noise below which it has converged."""
MAX_TAIL_FACTOR = 1.1
"""Largest factor on the LiDAR noise for residuals with heavier tails than a normal distribution.

The noise is determined from the smaller residuals, while the chi-square test sums the squares of
all. A larger factor shows errors that are not LiDAR noise.
"""
MIN_NOISE_DIFFERENCE = 0.1
"""Relative difference of the LiDAR noise from the given one below which other errors cause the
residuals."""
CORRELATION_TIME_FACTORS = (0.3, 0.1, 0.03)
"""Factors on the correlation times that are tried if the chi-square test rejects the model."""


def adjust(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    *,
    parameters: tuple[Parameter, ...] = (),
    shapes: Array | None = None,
    noise: Mapping[str, float] | None = None,
    components: bool | None = False,
    assumed: tuple[SigmaGroup, ...] = (),
    accept_single_orientation: bool = False,
    diagnostics: bool = True,
    test_model: bool = True,
    shorten_times: bool = True,
    progress: Progress = no_progress,
) -> AdjustmentResult:
    """Estimate the boresight with which the points of each target, in all lines, form one surface.

    Gauss-Helmert model. Planes are parametrised by two rotations of the normal and an offset, so
    that normals keep unit length. Each iteration sums the products of the Jacobian rows over groups
    of points in one pass, and solves a small system of equations. A target is excluded if none of
    its points has any weight, because it disagrees with the others; the result names it.

    Parameters
    ----------
    mounting : Mounting
        Prior boresight, used as starting value, and the given values of all other quantities.
    parameters : tuple of Parameter
        Values of the mounting to estimate besides the boresight. A value that the geometry does not
        determine is fixed, and the result reports it.
    shapes : ndarray of shape (targets, 4), optional
        Starting planes and spheres. By default, they are fitted to the points georeferenced with
        ``mounting``.
    noise : mapping of str to float, optional
        Ratio of the noise of each target to the given one (correlated model), from an adjustment of
        more points. By default, it is estimated from the residuals.
    components : bool or None
        Estimate variance components of LiDAR and POS (correlated model); None estimates those of
        the ``assumed`` groups.
    assumed : tuple of {"LiDAR", "POS position", "POS attitude"}
        Groups of errors whose standard deviations nobody gave.
    accept_single_orientation : bool
        Accept targets that are all planes of one orientation.
    diagnostics : bool
        Also compute observability and reliability.
    test_model : bool
        With diagnostics, adapt the stochastic model if the data contradict it: use shorter
        correlation times if the chi-square test rejects the model, and raise the sigmas if results
        without single lines or targets scatter too much (`leave_out_sigma_factors`).
    shorten_times : bool
        Whether to use shorter correlation times, if the model is tested.

    Raises
    ------
    AdjustmentError
        There is no target, a sighting has too few points, or a value is invalid.
    RankDeficient
        Lines and targets do not determine the boresight, or nothing checks it.
    TargetDisagrees
        A target disagrees and cannot be excluded, because only two are left or starting shapes are
        given.
    NotConverged
        The iteration diverges or does not converge.
    """
    estimated = assumed if components is None else SIGMA_GROUPS if components else ()
    settings = SolverSettings(
        model, parameters, shapes, noise, estimated, assumed, accept_single_orientation
    )
    if not diagnostics and model.lever_arm_sigma is None:
        return estimate(observations, mounting, settings, progress)

    def adjust_only(some: Observations) -> AdjustmentResult:
        solution = solve(some, mounting, settings, progress)
        return with_lever_arm_effect(solution.result(), solution.linearised)

    def adjust_and_diagnose(some: Observations) -> AdjustmentResult:
        solution = solve(some, mounting, settings, progress)
        found = _diagnose(solution, raise_sigmas=test_model)
        found = replace(
            found,
            radius_discrepancies=find_radius_discrepancies(some, found.mounting),
            lidar_noise_ratio=_measured_noise_ratio(solution, some, mounting, settings, progress),
        )
        adapts = test_model and shorten_times and model.correlated
        if not (adapts and found.is_model_rejected(REJECTION_LEVEL)):
            return found
        # Wrong control says nothing about the correlation times.
        if any(contradicting_control(found.control, found.control_translations)):
            return found
        if _passes_without_cause(found, some, mounting, settings, progress):
            return found
        return _with_shorter_correlation_times(found, some, mounting, settings, progress)

    return with_agreeing_targets(
        observations,
        adjust_and_diagnose if diagnostics else adjust_only,
        may_exclude=shapes is None,
    )


def _diagnose(solution: Solution, *, raise_sigmas: bool) -> AdjustmentResult:
    """Result with diagnostics.

    With ``raise_sigmas``, the sigmas of the angles are raised if results without parts of the data
    scatter more than predicted (`leave_out_sigma_factors`).
    """
    linearised, correlated = solution.linearised, solution.linearised.problem.model.correlated
    factors = leave_out_sigma_factors(linearised) if raise_sigmas and correlated else None
    has_surfaces = correlated and bool(linearised.normal.layout.surfaces)
    result = solution.result()
    sides = np.array(
        [1 if each.vessel_side is None else each.vessel_side for each in result.targets]
    )
    control, translations = assess_control(linearised, sides)
    result = replace(
        result,
        reliability=compute_reliability(linearised) if has_surfaces else (),
        contradictions=find_contradicted_parameters(linearised) if correlated else (),
        causes=find_possible_causes(linearised),
        control=control,
        control_translations=translations,
        pos_corrections=estimate_pos_corrections(linearised),
    )
    if factors is not None:
        result = with_raised_sigmas(result, factors)
    return _with_observability(result, solution)


def _with_observability(result: AdjustmentResult, solution: Solution) -> AdjustmentResult:
    """Result with the effect of the lever arm, and how well lines and targets determine it."""
    known = with_lever_arm_effect(result, solution.linearised)
    seen = assess_observability(
        solution.linearised,
        angle_sigma_factors=known.angle_sigma_factors,
        covariance=None if known.model.lever_arm_sigma is None else known.covariance,
        added_variance=np.diag(known.lever_arm_covariance)[:3],
        origins=solution.origins,
    )
    return replace(known, observability=seen)


def _measured_noise_ratio(
    solution: Solution,
    observations: Observations,
    mounting: Mounting,
    settings: SolverSettings,
    progress: Progress,
) -> float | None:
    """Ratio of the LiDAR noise in the residuals to the given one; None without a difference.

    With a wrong noise, the POS errors are not estimated well. The ratio is therefore determined
    again with the noise found. With the noise given by the ratio, the residuals pass the chi-square
    test, unless they contain other errors.
    """
    result, total = solution.result(), 1.0
    if result.chi_square.outcome == "passed" or any(
        c.applied and (c.name == "LiDAR" or not settings.assumed) for c in result.components
    ):
        return None
    for _ in range(MAX_NOISE_ROUNDS):
        ratio = lidar_noise_ratio(solution.linearised)
        if ratio is None:
            return None
        total *= ratio
        if abs(np.log(ratio)) < NOISE_TOLERANCE:
            break
        try:
            scaled = observations.with_scaled_sigmas(total, 1.0, 1.0)
            solution = solve(scaled, mounting, settings, progress)
        except (AdjustmentError, np.linalg.LinAlgError):
            break
    tails = np.sqrt(solution.result().variance_factor)
    if abs(np.log(tails)) < np.log(MAX_TAIL_FACTOR):
        total *= float(tails)
    return total if abs(np.log(total)) > MIN_NOISE_DIFFERENCE else None


def _with_shorter_correlation_times(
    found: AdjustmentResult,
    observations: Observations,
    mounting: Mounting,
    settings: SolverSettings,
    progress: Progress,
) -> AdjustmentResult:
    """Result with the longest correlation times that pass the test; ``found`` if none pass."""
    given = settings.model.position_time, settings.model.attitude_time
    for factor in CORRELATION_TIME_FACTORS:
        model = replace(
            settings.model, position_time=factor * given[0], attitude_time=factor * given[1]
        )
        with suppress(AdjustmentError, np.linalg.LinAlgError):
            solution = solve(observations, mounting, replace(settings, model=model), progress)
            if not solution.result().is_model_rejected():
                return replace(
                    _diagnose(solution, raise_sigmas=True),
                    given_correlation_times=given,
                    sigma_at_given_times=found.sigma,
                    radius_discrepancies=found.radius_discrepancies,
                )
    return found


def _passes_without_cause(
    found: AdjustmentResult,
    observations: Observations,
    mounting: Mounting,
    settings: SolverSettings,
    progress: Progress,
) -> bool:
    """Whether the chi-square test passes once the probable causes of the residuals are removed.

    Shorter correlation times are then not tried: times of a second or two would explain nearly any
    residuals, even those of a line with a time error.
    """
    causes = [group[0] for group in found.causes or () if len(group) == 1]
    values = [Parameter(each.kind) for each in causes if each.kind in OPTIONAL_NAMES]
    lines = {each.line for each in causes if each.kind not in OPTIONAL_NAMES and not each.target}
    places = {(each.target, each.line) for each in causes if each.target}
    if not causes:
        return False
    kept = np.array(
        [s.line not in lines and (s.target, s.line) not in places for s in observations.sightings]
    )
    with suppress(AdjustmentError, np.linalg.LinAlgError):
        freed = replace(settings, parameters=(*settings.parameters, *values))
        without = solve(observations.of_sightings(kept), mounting, freed, progress).result()
        return not without.is_model_rejected()
    return False


def adjust_or_explain(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    *,
    parameters: tuple[Parameter, ...] = (),
    components: bool | None = False,
    assumed: tuple[SigmaGroup, ...] = (),
    accept_single_orientation: bool = False,
    diagnostics: bool = True,
    shorten_times: bool = True,
    progress: Progress = no_progress,
) -> AdjustmentResult:
    """Call `adjust`, and add the possible causes to the error if it does not converge.

    Raises
    ------
    AdjustmentError
        The observations do not determine the boresight, or the adjustment does not converge.
    RankDeficient
        A parameter is not determined.
    NotConverged
        The adjustment does not converge; the reason includes possible causes, the best one first.
    """
    try:
        return adjust(
            observations, mounting, model, parameters=parameters, components=components,
            assumed=assumed, accept_single_orientation=accept_single_orientation,
            diagnostics=diagnostics, shorten_times=shorten_times, progress=progress,
        )  # fmt: skip
    except NotConverged as failure:
        reason = as_message(failure.reason)
        progress(0.9, gettext_lazy("Searching for the cause"))
        for cause in find_failure_causes(
            observations, mounting, model, parameters=parameters, progress=progress
        ):
            reason = error(
                "estimate.possible_cause", reason=reason, cause=cause,
                subject=reason.subject or cause.subject,
            )  # fmt: skip
        raise NotConverged(reason) from None
