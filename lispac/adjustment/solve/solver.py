"""Least-squares solution of mounting and targets in phases (thesis B.3)."""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import Parameter, ParameterEstimate, mounting_value_name
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.model.target_shapes import (
    fit_majority_shapes,
    fit_shapes,
    relative_to_origins,
    shapes_relative_to,
    target_centroids,
    with_median_radii,
)
from lispac.adjustment.model.threads import single_blas_thread
from lispac.adjustment.result import (
    AdjustmentResult,
    ContradictedParameter,
    SigmaGroup,
    VarianceComponent,
)
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem, LinearisedProblem
from lispac.adjustment.solve.determinability import (
    find_undetermined_parameters,
    require_determined,
    require_orientations_kept,
    require_two_orientations,
)
from lispac.adjustment.solve.group_sums import AdjustmentState
from lispac.adjustment.solve.iteration import IterationResult, iterate
from lispac.adjustment.solve.noise_estimation import (
    SIGMA_TOLERANCE,
    is_point_on_target,
    lidar_noise_ratio,
    target_noise_factors,
)
from lispac.adjustment.solve.omitted_parameters import find_contradicted_parameters
from lispac.adjustment.solve.sighting_rejection import (
    iterate_with_majority,
    may_reject_sightings,
    reject_disagreeing_sightings,
)
from lispac.adjustment.solve.solution import Solution
from lispac.adjustment.solve.variance_components import (
    FACTOR_LIMITS,
    MIN_NOISE_FACTOR,
    estimate_variance_components,
    lidar_factor_spread,
    with_lidar_interval,
)
from lispac.computing_time import computing_time
from lispac.errors import NotConverged, RankDeficient, TargetDisagrees
from lispac.messages import Message, error, note
from lispac.progress import Progress, no_progress
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

SAMPLE_SIZE = 50_000
"""Number of points of the sample; with more points, only the last iterations use all."""

MAX_COMPONENT_ROUNDS = 5
"""Largest number of times that the variance components are estimated and applied."""

MIN_SIGMA_INCREASE = 1.05
"""Smallest factor by which a given sigma is increased; smaller ones have no relevant effect."""

CONTRADICTION_CODES = {
    "range_offset": "adjustment.contradicts_range_offset",
    "scan_angle_offset": "adjustment.contradicts_scan_angle_offset",
    "latency": "adjustment.contradicts_latency",
}
"""Code of the message that the data contradict a given value."""


@dataclass(frozen=True, eq=False)
class SolverSettings:
    """Settings of a solution; see the parameters of `lispac.adjustment.least_squares.adjust`.

    Attributes
    ----------
    model : StochasticModel
    parameters : tuple of Parameter
    shapes : ndarray of shape (targets, 4), or None
    noise : mapping of str to float, or None
    components : tuple of {"LiDAR", "POS position", "POS attitude"}
        Groups of errors whose variances are estimated.
    assumed : tuple of {"LiDAR", "POS position", "POS attitude"}
        Groups of errors whose sigmas nobody gave.
    accept_single_orientation : bool
    """

    model: StochasticModel
    parameters: tuple[Parameter, ...] = ()
    shapes: Array | None = None
    noise: Mapping[str, float] | None = None
    components: tuple[SigmaGroup, ...] = ()
    assumed: tuple[SigmaGroup, ...] = ()
    accept_single_orientation: bool = False


def estimate(
    observations: Observations,
    mounting: Mounting,
    settings: SolverSettings,
    progress: Progress = no_progress,
) -> AdjustmentResult:
    """Adjust without diagnostics; see `lispac.adjustment.least_squares.adjust`.

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
    return with_agreeing_targets(
        observations,
        lambda some: solve(some, mounting, settings, progress).result(),
        may_exclude=settings.shapes is None,
    )


def with_agreeing_targets(
    observations: Observations,
    adjusted: Callable[[Observations], AdjustmentResult],
    *,
    may_exclude: bool,
) -> AdjustmentResult:
    """Adjust, and exclude targets all of whose points have no weight.

    Parameters
    ----------
    adjusted : callable
        Function that adjusts observations and returns the result.

    Raises
    ------
    AdjustmentError
        The observations cannot be used.
    RankDeficient
        Lines and targets do not determine the boresight; targets excluded before are named.
    TargetDisagrees
        A target disagrees and cannot be excluded, because only two are left or ``may_exclude`` is
        false.
    NotConverged
        The iteration diverges or does not converge.
    """
    started, excluded = computing_time(), list[str]()
    while True:
        some = observations.without_targets(excluded)
        some.require_usable()
        try:
            with single_blas_thread():
                result = adjusted(some)
        except np.linalg.LinAlgError as reason:
            raise NotConverged(error("adjustment.diverged")) from reason
        except TargetDisagrees as reason:
            if not may_exclude or len(observations.targets) - len(excluded) <= 2:
                raise
            excluded.append(reason.target)
        except RankDeficient as failure:
            if not excluded:
                raise
            raise RankDeficient(
                error(
                    "adjustment.refused_after_exclusion", reason=failure.reason,
                    count=len(excluded), total=len(observations.targets), targets=excluded,
                )
            ) from failure  # fmt: skip
        else:
            elapsed = computing_time() - started
            return replace(result, elapsed=elapsed, excluded_targets=tuple(excluded))


def solve(
    observations: Observations,
    mounting: Mounting,
    settings: SolverSettings,
    progress: Progress = no_progress,
) -> Solution:
    """Solve for mounting and targets in phases.

    A sample of the points is adjusted first, without sightings that are displaced by far. Then
    variance components are estimated if requested, and disagreeing sightings are rejected. Control
    is added afterwards, if the survey is determined without it. The last iterations use all points.

    Raises
    ------
    RankDeficient
        A parameter is not determined.
    TargetDisagrees
        No point of a target has any weight, because it disagrees with the others.
    NotConverged
        The iteration does not converge, or makes planes of different orientations parallel.
    LinAlgError
        The iteration diverges.
    """
    model, parameters, noise = settings.model, settings.parameters, settings.noise
    observations = observations.with_own_control
    sampled = _sample_points(observations)
    origins = target_centroids(sampled, mounting)
    sampled = relative_to_origins(sampled, origins)
    # The radii of the spheres are estimated once the boresight is near the solution.
    first = with_median_radii(sampled, mounting)
    fitted = fit_shapes(first, mounting)
    if settings.shapes is not None:
        start = shapes_relative_to(settings.shapes, origins, first.is_sphere)
    elif model.loss != "none":
        start = fit_majority_shapes(first, mounting, fitted)
    else:
        start = fitted
    problem = AdjustmentProblem.of(first, mounting, model, parameters).with_known_noise(noise)
    state = problem.start(mounting, start)
    kept, fixed = _determined_parameters(problem, state)
    problem = _without_control(problem, state, kept)
    control, has_waited = first.control, problem.observations.control is not first.control
    if first is not sampled:
        state = iterate(problem, state, progress).state
        parameters = problem.parameters
        problem = AdjustmentProblem.of(sampled, mounting, model, parameters).with_known_noise(noise)
        if has_waited:
            problem = problem.with_control(None)
        state = problem.start(state.mounting, state.shapes)
    found, rejected = iterate_with_majority(problem, state, progress)
    require_orientations_kept(found.linearised)
    if not settings.accept_single_orientation and control is None:
        with _rejections_named(found.linearised):
            require_two_orientations(found.linearised)
    components: tuple[VarianceComponent, ...] = ()
    factors = np.ones(3)
    if model.correlated and settings.components:
        # With sigmas that are too small, correct sightings would be rejected as blunders.
        found, _, factors = _iterate_variance_components(found, factors, settings, progress)
    if may_reject_sightings(model):
        found = reject_disagreeing_sightings(found, rejected, progress)
    if model.correlated and settings.components:
        found, components, factors = _iterate_variance_components(
            found, factors, settings, progress
        )
    if has_waited:
        problem = found.linearised.problem.with_control(control).with_parameters(kept)
        found = iterate(problem, found.state, progress, earlier=found.path, noise_known=True)
    if not settings.accept_single_orientation and control is not None:
        with _rejections_named(found.linearised):
            require_two_orientations(found.linearised)
    if len(sampled) < len(observations):
        observations = relative_to_origins(observations.with_scaled_sigmas(*factors), origins)
        found = _continue_with_all_points(found, observations, progress)
    with _rejections_named(found.linearised):
        _require_still_determined(found.linearised)
    return Solution(
        found.linearised, found.state, found.path, fitted, origins, fixed, components,
        settings.assumed,
    )  # fmt: skip


def _determined_parameters(
    problem: AdjustmentProblem, state: AdjustmentState
) -> tuple[tuple[Parameter, ...], tuple[ParameterEstimate, ...]]:
    """Parameters to estimate, and those that the geometry does not determine."""
    linearised = problem.linearised(state)
    undetermined = (
        find_undetermined_parameters(linearised)
        if problem.model.correlated
        else _fixed_if_uncorrelated(problem)
    )
    correlated = problem.model.correlated
    fixed = {e.name for e in undetermined if e.prior_sigma is None or not correlated}
    kept = tuple(p for p in problem.parameters if p.name not in fixed)
    if fixed:
        linearised = problem.with_parameters(kept).linearised(state)
    require_determined(linearised)
    return kept, undetermined


def _without_control(
    problem: AdjustmentProblem, state: AdjustmentState, kept: tuple[Parameter, ...]
) -> AdjustmentProblem:
    """Problem of the parameters ``kept``, without the control if it is determined without it.

    Noise, form errors, variance components and rejected sightings are then found without the
    control. Otherwise a wrong control point would increase the sigmas and thereby hide itself, or
    correct sightings would be rejected because of it.
    """
    every = problem.with_parameters(kept)
    if problem.observations.control is None:
        return every
    alone = every.with_control(None)
    try:
        determined, _ = _determined_parameters(alone, state)
    except RankDeficient:
        return every
    return alone.with_parameters(determined)


@contextmanager
def _rejections_named(linearised: LinearisedProblem) -> Iterator[None]:
    """Add the rejected sightings to an error about the geometry of those that are left.

    Raises
    ------
    RankDeficient
        The original error, with the number and the names of the rejected sightings.
    """
    try:
        yield
    except RankDeficient as failure:
        problem = linearised.problem
        sightings = problem.observations.sightings
        rejected = [sightings[s] for s in np.flatnonzero(problem.rejected_sightings)]
        if not rejected:
            raise
        names = [note("item.sighting", target=s.target, line=s.line) for s in rejected]
        raise RankDeficient(
            error(
                "adjustment.refused_after_rejection", reason=failure.reason, count=len(names),
                total=len(sightings), sightings=names,
            )
        ) from failure  # fmt: skip


def _require_still_determined(linearised: LinearisedProblem) -> None:
    """Raise an error if the solution, after rejections, does not determine the angles.

    Raises
    ------
    RankDeficient
        An angle is not determined; if the data contradict a given value, the message names it.
    """
    try:
        require_determined(linearised)
    except RankDeficient as reason:
        wrong = (
            find_contradicted_parameters(linearised, min_angle_change=0.0)
            if linearised.problem.layout.surfaces
            else ()
        )
        if not wrong:
            raise
        raise RankDeficient(_contradicted_value_error(wrong[0])) from reason


def _contradicted_value_error(wrong: ContradictedParameter) -> Message:
    """Error message that the data contradict a given value of the mounting."""
    if wrong.name.startswith("lever_"):
        axis = wrong.name.removeprefix("lever_").upper()
        return error("adjustment.contradicts_lever_arm", axis=axis, change=wrong.change)
    return error(CONTRADICTION_CODES[wrong.name], change=wrong.change)


def _fixed_if_uncorrelated(problem: AdjustmentProblem) -> tuple[ParameterEstimate, ...]:
    """All parameters, fixed at their given values, because independent POS errors bias them."""
    return tuple(
        ParameterEstimate(
            each.name, float(problem.prior.values[each.index]), each.sigma,
            reason=note("parameter.not_classical", parameter=mounting_value_name(each.name)),
        )
        for each in problem.parameters
    )  # fmt: skip


def _sample_points(observations: Observations) -> Observations:
    """Sample of the points for the approximate solution, noise, form errors and blunders."""
    if len(observations) <= SAMPLE_SIZE:
        return observations
    return observations.where(observations.sample(SAMPLE_SIZE / len(observations)))


def _continue_with_all_points(
    near: IterationResult, observations: Observations, progress: Progress
) -> IterationResult:
    """Continue with all points from the solution of a sample."""
    sample = near.linearised.problem
    problem = sample.with_observations(observations)
    if problem.model.correlated and not problem.known_noise:
        sampled, residuals = sample.observations, sample.residuals(near.state)[1]
        mine = None if problem.model.loss == "none" else is_point_on_target(sampled, residuals)
        denser = len(observations) / len(sampled)
        noise = target_noise_factors(sampled, residuals, sample.blocks, mine, denser=denser)
        problem = replace(problem, noise=noise)
    state = problem.resume_state(near.state, sample)
    return iterate(problem, state, progress, earlier=near.path, noise_known=True)


def _iterate_variance_components(
    solution: IterationResult, total: Array, settings: SolverSettings, progress: Progress
) -> tuple[IterationResult, tuple[VarianceComponent, ...], Array]:
    """Adjust again with the estimated variance components until they do not change.

    ``total``, shape (3,), are the factors on the given sigmas already used in ``solution``.
    """
    chosen = settings.components, settings.assumed
    for _ in range(MAX_COMPONENT_ROUNDS):
        found = estimate_variance_components(solution.linearised, *chosen)
        # A sigma is raised if its factor is determined and larger than 1, but lowered only if the
        # factor is significantly smaller, because a sigma that is too large does little harm.
        new_factors = np.array(
            [
                c.factor if (determined and c.factor > MIN_SIGMA_INCREASE) or c.upper < 1 else 1.0
                for c, determined in zip(found.components, found.determined, strict=True)
            ]
        )
        if "LiDAR" in settings.components and "LiDAR" in settings.assumed:
            new_factors[0] = _assumed_lidar_factor(solution.linearised, new_factors[0])
        factors = np.clip(total * new_factors, *FACTOR_LIMITS) / total
        total = total * factors
        if np.abs(np.log(factors)).max() < SIGMA_TOLERANCE:
            break
        problem = solution.linearised.problem.with_scaled_sigmas(*factors)
        problem = problem.with_surface_sigma(
            found.form_error_factor * problem.default_surface_sigmas
        )
        solution = iterate(problem, solution.state, progress, earlier=solution.path)
    else:
        found = estimate_variance_components(solution.linearised, *chosen)
    if "LiDAR" in settings.components and "LiDAR" in settings.assumed and total[0] != 1:
        found = with_lidar_interval(found, solution.linearised)
    return (
        solution,
        tuple(
            VarianceComponent(
                c.name,
                float(t if t in FACTOR_LIMITS else t * c.factor),
                float(t * c.lower),
                float(t * c.upper),
                bool(t != 1),
                float(t),
                bool(determined or t != 1),
            )
            for c, t, determined in zip(found.components, total, found.determined, strict=True)
            if c.name in settings.components
        ),
        total,
    )


def _assumed_lidar_factor(linearised: LinearisedProblem, factor: float) -> float:
    """Factor on an assumed LiDAR sigma, ``factor`` unless the noise of a target was raised.

    The likelihood does not estimate the LiDAR sigma if the residuals already raised the noise.
    Larger noise on all targets, however, shows that the assumed sigma is too small. If all
    residuals are smaller than predicted, only their correlation raised the noise, and the assumed
    sigma is too large.
    """
    noise = linearised.problem.noise
    if noise.max() < MIN_NOISE_FACTOR:
        return factor
    ratio = lidar_noise_ratio(linearised) or 1.0
    is_smaller = ratio * np.exp(1.96 * lidar_factor_spread(linearised)) < 1
    return ratio if is_smaller else max(ratio, 1.0) if noise.min() >= MIN_NOISE_FACTOR else factor
