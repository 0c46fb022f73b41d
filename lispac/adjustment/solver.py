"""The least-squares adjustment of mounting and targets (thesis B.3)."""

import time
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.adjustment_problem import FREE_SIGMA, AdjustmentProblem, LinearisedProblem
from lispac.adjustment.blas_threads import single_blas_thread
from lispac.adjustment.blunders import (
    Blunder,
    find_confirmed_blunders,
    find_restorable_blunder,
    worst_blunder,
)
from lispac.adjustment.group_sums import AdjustmentState
from lispac.adjustment.iteration import IterationResult, iterate
from lispac.adjustment.message_parts import mounting_value_name
from lispac.adjustment.noise_estimation import (
    find_displaced_sightings,
    is_point_on_target,
    target_noise_factors,
)
from lispac.adjustment.noise_update import SIGMA_TOLERANCE
from lispac.adjustment.observability import (
    find_undetermined_parameters,
    require_determined,
    require_two_orientations,
)
from lispac.adjustment.observations import Observations
from lispac.adjustment.omitted_parameters import find_contradicted_parameters
from lispac.adjustment.parameters import OPTIONAL_NAMES, Parameter, ParameterEstimate
from lispac.adjustment.result import AdjustmentResult, ContradictedParameter, VarianceComponent
from lispac.adjustment.result_assembly import assemble_result
from lispac.adjustment.sphere_radii import find_radius_discrepancies
from lispac.adjustment.stochastic_model import StochasticModel
from lispac.adjustment.target_shapes import (
    fit_majority_shapes,
    fit_shapes,
    relative_to_origins,
    shapes_relative_to,
    target_centroids,
    with_median_radii,
)
from lispac.adjustment.variance_components import (
    FACTOR_LIMITS,
    estimate_variance_components,
    need_own_offset_sigma,
)
from lispac.errors import AdjustmentError, NotConverged, RankDeficient, TargetDisagrees
from lispac.messages import Message, error, note
from lispac.progress import Progress, no_progress
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

SAMPLE_SIZE = 50_000
"""Points for the approximate solution; if there are more, only the last iterations use all."""

COMPONENT_ROUNDS = 5

MIN_INCREASE = 1.05
"""Factor on a given sigma below which an increase has no relevant effect."""

SHORTER_TIMES = (0.3, 0.1, 0.03)
"""Factors on the correlation times that are tried where the residuals are too large."""

REJECTION_LEVEL = 1e-4
"""Probability that correlation times are shortened though the given ones are right."""

CONTRADICTION_CODES = {
    "range_offset": "adjustment.contradicts_range_offset",
    "scan_angle_offset": "adjustment.contradicts_scan_angle_offset",
    "latency": "adjustment.contradicts_latency",
}
"""Code of the message that the data contradict a given value."""

SIGHTINGS_PER_REJECTION = 3
"""At most one in this number of sightings is rejected."""


def adjust(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    *,
    parameters: tuple[Parameter, ...] = (),
    shapes: Array | None = None,
    noise: Mapping[str, float] | None = None,
    components: bool = False,
    accept_single_orientation: bool = False,
    diagnostics: bool = True,
    test_model: bool = True,
    progress: Progress = no_progress,
) -> AdjustmentResult:
    """Find the boresight that makes each target's points, over all lines, one surface.

    Gauss-Helmert model with unit normals kept exactly: a plane moves by two turns of its normal
    and its offset. The products summed over groups of points carry all the points say, so an
    iteration costs one pass over them and a small solve. A target no point of which agrees with the
    others is excluded, and named in the result.

    Parameters
    ----------
    mounting : Mounting
        The prior boresight as the starting value; all other values as they are known.
    parameters : tuple of Parameter
        Values of the mounting to estimate besides the boresight. One that the geometry does not
        determine is fixed, and the result reports it.
    shapes : ndarray of shape (targets, 4), optional
        Starting planes and spheres; fitted to the points placed with ``mounting`` where not given.
    noise : mapping of str to float, optional
        Noise of each target over the given one (correlated model), as known from an adjustment of
        more of its points; estimated from the residuals where not given.
    components : bool
        Whether to take the sigmas of LiDAR and POS from the data (correlated model).
    accept_single_orientation : bool
        Whether to accept that all targets are planes that face one way.
    diagnostics : bool
        Whether to work out observability and reliability too.
    test_model : bool
        Whether, with diagnostics, the model of the errors follows the data where these contradict
        it: shorter correlation times where the chi-square test asks for them, and sigmas raised
        where results without single lines or targets scatter too much (`leave_out_sigma_factors`).

    Raises
    ------
    AdjustmentError
        Where a sighting has too few points.
    RankDeficient
        Where lines and targets do not determine the boresight, or nothing checks it.
    TargetDisagrees
        Where two targets are left at most, or starting shapes are given.
    NotConverged
        If the iteration diverges or does not converge.
    """
    excluded: list[str] = []
    while True:
        try:
            result = _adjust_all_targets(
                observations.without_targets(excluded), mounting, model, parameters, shapes, noise,
                components, accept_single_orientation, diagnostics, test_model, progress,
            )  # fmt: skip
        except TargetDisagrees as error:
            if shapes is not None or len(observations.targets) - len(excluded) <= 2:
                raise
            excluded.append(error.target)
        else:
            return replace(result, excluded_targets=tuple(excluded)) if excluded else result


def _adjust_all_targets(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    parameters: tuple[Parameter, ...],
    shapes: Array | None,
    noise: Mapping[str, float] | None,
    components: bool,
    accept_single_orientation: bool,
    diagnostics: bool,
    test_model: bool,
    progress: Progress,
) -> AdjustmentResult:
    """`adjust` with all targets.

    Raises
    ------
    AdjustmentError
        If the observations cannot be used.
    RankDeficient
        If a parameter is not determined.
    TargetDisagrees
        If no point of a target agrees with the others.
    NotConverged
        If the iteration diverges or does not converge.
    """
    started = time.perf_counter()
    observations.require_usable()

    def adjusted(
        model: StochasticModel, parameters: tuple[Parameter, ...] = parameters,
        some: Observations = observations, *, diagnostics: bool,
    ) -> AdjustmentResult:  # fmt: skip
        return _solve_adjustment(
            some, mounting, model, parameters, shapes, noise, components, accept_single_orientation,
            diagnostics, test_model, progress, started,
        )  # fmt: skip

    try:
        with single_blas_thread():
            found = adjusted(model, diagnostics=diagnostics)
            if diagnostics:
                radii = find_radius_discrepancies(observations, found.mounting)
                found = replace(found, radius_discrepancies=radii)
            if not (diagnostics and test_model and model.correlated):
                return found
            if not is_model_rejected(found, REJECTION_LEVEL):
                return found
            if _passes_without_cause(found, observations, parameters, adjusted):
                return found
            for factor in SHORTER_TIMES:
                shorter = replace(
                    model, position_time=factor * model.position_time,
                    attitude_time=factor * model.attitude_time,
                )  # fmt: skip
                with suppress(AdjustmentError, np.linalg.LinAlgError):
                    if not is_model_rejected(adjusted(shorter, diagnostics=False)):
                        given = model.position_time, model.attitude_time
                        return replace(
                            adjusted(shorter, diagnostics=True),
                            given_correlation_times=given,
                            radius_discrepancies=radii,
                        )
            return found
    except np.linalg.LinAlgError as reason:
        raise NotConverged(error("adjustment.diverged")) from reason


def is_model_rejected(result: AdjustmentResult, chance: float = 0.025) -> bool:
    """Whether the chi-square test rejects the model.

    Parameters
    ----------
    chance : float
        Probability that those of a right model are.
    """
    from scipy.special import chdtri

    freedom = result.degrees_of_freedom
    return freedom > 0 and bool(result.chi_square.statistic > chdtri(freedom, chance))


def _passes_without_cause(
    found: AdjustmentResult,
    observations: Observations,
    parameters: tuple[Parameter, ...],
    adjusted: Callable[..., AdjustmentResult],
) -> bool:
    """Whether the residuals pass the test without the error named as their cause.

    Correlation times as short as a second or two explain nearly everything, a late line as well.
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
        without = adjusted(
            found.model, (*parameters, *values), observations.of_sightings(kept), diagnostics=False
        )
        return not is_model_rejected(without)
    return False


def _solve_adjustment(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    parameters: tuple[Parameter, ...],
    shapes: Array | None,
    noise: Mapping[str, float] | None,
    components: bool,
    accept_single_orientation: bool,
    diagnostics: bool,
    test_model: bool,
    progress: Progress,
    started: float,
) -> AdjustmentResult:
    sampled = _sample_points(observations)
    origins = target_centroids(sampled, mounting)
    sampled = relative_to_origins(sampled, origins)
    # The radii of the balls are estimated once the boresight is near the solution.
    first = with_median_radii(sampled, mounting)
    fitted = fit_shapes(first, mounting)
    if shapes is not None:
        start = shapes_relative_to(shapes, origins, first.is_sphere)
    elif model.loss != "none":
        start = fit_majority_shapes(first, mounting, fitted)
    else:
        start = fitted
    problem = AdjustmentProblem.of(first, mounting, model, parameters).with_known_noise(noise)
    state = problem.start(mounting, start)
    kept, fixed = _determined_parameters(problem, state)
    problem = problem.with_parameters(kept)
    if first is not sampled:
        state = iterate(problem, state, progress).state
        problem = AdjustmentProblem.of(sampled, mounting, model, kept).with_known_noise(noise)
        state = problem.start(state.mounting, state.shapes)
    solution, rejected = _iterate_with_majority(problem, state, progress)
    if not accept_single_orientation:
        require_two_orientations(solution.linearised)
    found: tuple[VarianceComponent, ...] = ()
    factors = np.ones(3)
    if components and model.correlated:
        # Sigmas that are too small would make blunders of sightings that are none.
        solution, _, factors = _iterate_variance_components(solution, factors, progress)
    if _may_reject_sightings(model):
        solution = _reject_disagreeing_sightings(solution, rejected, progress)
    if components and model.correlated:
        solution, found, factors = _iterate_variance_components(solution, factors, progress)
    if len(sampled) < len(observations):
        observations = relative_to_origins(observations.with_sigmas(*factors), origins)
        solution = _continue_with_all_points(solution, observations, progress)
    _require_still_determined(solution.linearised)
    return assemble_result(
        solution.linearised, solution.state, fitted, origins,
        path=solution.path, fixed=fixed, components=found, diagnostics=diagnostics,
        raise_sigmas=test_model, started=started,
    )  # fmt: skip


def _determined_parameters(
    problem: AdjustmentProblem, state: AdjustmentState
) -> tuple[tuple[Parameter, ...], tuple[ParameterEstimate, ...]]:
    """The parameters to estimate, and those the geometry does not determine."""
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


def _require_still_determined(linearised: LinearisedProblem) -> None:
    """Refuse what remains after rejection of sightings and with estimated surface sigmas.

    Raises
    ------
    RankDeficient
        If a parameter is no longer determined, or a given value contradicts the targets.
    """
    try:
        require_determined(linearised)
    except RankDeficient as reason:
        wrong = (
            find_contradicted_parameters(linearised, least=0.0)
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
    """Parameters that independent POS errors would bias, fixed at their given values."""
    return tuple(
        ParameterEstimate(
            each.name, float(problem.prior.values[each.index]), each.sigma,
            reason=note("parameter.not_classical", parameter=mounting_value_name(each.name)),
        )
        for each in problem.parameters
    )  # fmt: skip


def _sample_points(observations: Observations) -> Observations:
    """Sample of many points for approximate solution, noise, surfaces and blunders."""
    if len(observations) <= SAMPLE_SIZE:
        return observations
    return observations.where(observations.sample(SAMPLE_SIZE / len(observations)))


def _continue_with_all_points(
    near: IterationResult, observations: Observations, progress: Progress
) -> IterationResult:
    """Continue with all points from the solution of a sample."""
    sample = near.linearised.problem
    problem = AdjustmentProblem.of(
        observations, sample.prior, sample.model, sample.parameters, sample.moments
    )
    problem = replace(
        problem,
        noise=sample.noise,
        scale=sample.scale,
        surface_sigma=sample.surface_sigma,
        own_offsets=sample.own_offsets,
        known_noise=sample.known_noise,
    )
    if problem.model.correlated and not problem.known_noise:
        sampled, residuals = sample.observations, sample.residuals(near.state)[1]
        mine = None if problem.model.loss == "none" else is_point_on_target(sampled, residuals)
        denser = len(observations) / len(sampled)
        noise = target_noise_factors(sampled, residuals, sample.blocks, mine, denser=denser)
        problem = replace(problem, noise=noise)
    state = problem.resume_state(near.state, sample)
    return iterate(problem, state, progress, earlier=near.path, noise_known=True)


def _may_reject_sightings(model: StochasticModel) -> bool:
    return model.correlated and model.loss != "none" and model.surface != 0


def _iterate_with_majority(
    problem: AdjustmentProblem, start: AdjustmentState, progress: Progress
) -> tuple[IterationResult, list[Blunder]]:
    """Iterate without sightings that are metres off; they may be restored later.

    Tied to their targets they would displace all others, through the POS error that they share.
    """
    observations, off = problem.observations, np.zeros(0, dtype=np.int64)
    if _may_reject_sightings(problem.model):
        off = find_displaced_sightings(observations, problem.residuals(start)[1])
    balls = observations.is_sphere[observations.target_of_sighting]
    rejected = [Blunder("shift" if balls[s] else "surface", (int(s),)) for s in off]
    if 0 < len(rejected) <= len(observations.sightings) // SIGHTINGS_PER_REJECTION:
        without = problem
        for found in rejected:
            without = found.reject_in(without)
        with suppress(RankDeficient, NotConverged):  # then they are needed after all
            solution = iterate(without, start, progress)
            plain = find_confirmed_blunders(solution.linearised, rejected)
            if plain == rejected:
                return solution, rejected
            problem = solution.linearised.problem
            for found in rejected:
                problem = found.restore_in(problem)
            for found in plain:
                problem = found.reject_in(problem)
            return iterate(problem, solution.state, progress, earlier=solution.path), plain
    return iterate(problem, start, progress), []


def _count_rejected_sightings(solution: IterationResult) -> int:
    """Number of rejected sightings."""
    return int((~solution.linearised.problem.is_sighting_tied).sum())


def _reject_disagreeing_sightings(
    start: IterationResult, rejected: list[Blunder], progress: Progress
) -> IterationResult:
    """Reject disagreeing sightings, with a sigma of the offsets of their own where needed.

    Boards that are displaced between lines, but not warped, would be rejected one after the other;
    so would boards displaced by a wrong mounting parameter.
    """
    solution = _reject_unexplained_sightings(start, rejected, progress)
    here = solution.linearised
    if here.problem.model.surface is not None or not need_own_offset_sigma(here):
        return solution
    if find_contradicted_parameters(here, least=0.0):
        return solution
    problem = replace(start.linearised.problem, own_offsets=True)
    try:
        other = iterate(problem, start.state, progress, earlier=solution.path)
        return _reject_unexplained_sightings(other, rejected, progress)
    except (RankDeficient, NotConverged):
        return solution


def _reject_unexplained_sightings(
    solution: IterationResult, rejected: list[Blunder], progress: Progress
) -> IterationResult:
    """Reject disagreeing sightings unless a wrong value of the mounting explains them.

    With a wrong given lever arm, good sightings of whole lines disagree. If freeing contradicted
    parameters saves more rejections than there are parameters, only the other sightings are
    rejected. The parameters are not estimated; the result lists the contradictions.
    """
    after = _reject_blunders(solution, rejected, progress)
    problem = solution.linearised.problem
    count = _count_rejected_sightings(after)
    if count <= _count_rejected_sightings(solution):
        return after
    fewest, surfaces = count, None
    tried: list[tuple[str, ...]] = [()]
    for judged in (solution, after):
        # In the order they were found: what explains most comes first.
        names = tuple(
            each.name for each in find_contradicted_parameters(judged.linearised, least=0.0)
        )
        if names in tried:
            continue
        tried.append(names)
        wider = problem.with_parameters((*problem.parameters, *map(Parameter, names)))
        try:
            freed = iterate(wider, solution.state, progress, earlier=solution.path)
            explained = _reject_blunders(freed, rejected, progress)
        except (RankDeficient, NotConverged):
            continue
        if _count_rejected_sightings(explained) + len(names) < fewest:
            fewest = _count_rejected_sightings(explained) + len(names)
            surfaces = explained.linearised.problem.surface_sigma
    if surfaces is None:
        return after
    surfaces = np.where(surfaces >= FREE_SIGMA, FREE_SIGMA, problem.default_surface_sigmas)
    problem = replace(problem, surface_sigma=surfaces)
    return iterate(problem, solution.state, progress, earlier=solution.path)


def _reject_blunders(
    solution: IterationResult, rejected: list[Blunder], progress: Progress
) -> IterationResult:
    """Reject the sightings that agree least and iterate until all agree.

    A blunder may make other sightings appear as blunders: these are restored if they agree without
    it; this includes the sightings in ``rejected``.
    """
    limit = len(solution.linearised.problem.observations.sightings) // SIGHTINGS_PER_REJECTION
    rejected = list(rejected)
    spared: set[Blunder] = set()
    while True:
        here = solution.linearised
        if (back := find_restorable_blunder(here, rejected)) is not None:
            rejected.remove(back)
            spared.add(back)
            problem = back.restore_in(here.problem)
        else:
            worst = worst_blunder(here, spared)
            if worst is None or sum(len(b.sightings) for b in [*rejected, worst]) > limit:
                return solution
            rejected.append(worst)
            problem = worst.reject_in(here.problem)
        solution = iterate(problem, solution.state, progress, earlier=solution.path)


def _iterate_variance_components(
    solution: IterationResult, total: Array, progress: Progress
) -> tuple[IterationResult, tuple[VarianceComponent, ...], Array]:
    """Adjust again with the estimated variance components until they do not change.

    ``total`` holds the factors on the given sigmas that are in ``solution`` already.
    """
    for _ in range(COMPONENT_ROUNDS):
        found = estimate_variance_components(solution.linearised)
        # A sigma is raised on suspicion, lowered on evidence: too large a one costs little.
        news = np.array(
            [
                c.factor if (determined and c.factor > MIN_INCREASE) or c.upper < 1 else 1.0
                for c, determined in zip(found.components, found.determined, strict=True)
            ]
        )
        factors = np.clip(total * news, *FACTOR_LIMITS) / total
        total = total * factors
        if np.abs(np.log(factors)).max() < SIGMA_TOLERANCE:
            break
        problem = solution.linearised.problem.with_sigmas(*factors)
        problem = problem.with_surface_sigma(found.rough * problem.default_surface_sigmas)
        solution = iterate(problem, solution.state, progress, earlier=solution.path)
    final = estimate_variance_components(solution.linearised)
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
            )
            for c, t in zip(final.components, total, strict=True)
        ),
        total,
    )
