"""The least-squares adjustment of mounting and targets (thesis B.3)."""

import time
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.adaptation import SCALE_SETTLED
from lispac.adjustment.blas import one_thread
from lispac.adjustment.blunders import Blunder, belonging, plainly_off, worst_blunder
from lispac.adjustment.components import FACTORS, offsets_insist, variance_components
from lispac.adjustment.iteration import Solution, iterate
from lispac.adjustment.message_parts import quantity
from lispac.adjustment.noise import astray, at_target, noise_factors
from lispac.adjustment.observability import require_determined, require_two_facings, unseen
from lispac.adjustment.observations import Observations
from lispac.adjustment.omitted_parameters import contradictions
from lispac.adjustment.parameters import SWITCHED, Estimate, Parameter
from lispac.adjustment.problem import RELEASED, Linearised, Problem
from lispac.adjustment.result import AdjustmentResult, Component, Contradiction
from lispac.adjustment.shapes import (
    about,
    counted_from,
    fit_shapes,
    middles,
    shapes_of_most,
    usual_radii,
)
from lispac.adjustment.sphere_radii import radius_discrepancies
from lispac.adjustment.stochastic import StochasticModel
from lispac.adjustment.summary import summary
from lispac.adjustment.sums import State
from lispac.errors import AdjustmentError, NotConverged, RankDeficient, TargetDisagrees
from lispac.messages import Message, error, note
from lispac.progress import Progress, no_progress
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

MANY = 50_000
"""Points that lead near the answer; where there are more, all of them take the last steps only."""

COMPONENT_ROUNDS = 5

RAISED = 1.05
"""Factor on a given sigma below which an increase has no relevant effect."""

SHORTER_TIMES = (0.3, 0.1, 0.03)
"""Factors on the correlation times that are tried where the residuals are too large."""

REJECTION_LEVEL = 1e-4
"""Probability that correlation times are shortened though the given ones are right."""

CONTRADICTED = {
    "range_offset": "adjustment.contradicts_range_offset",
    "scan_angle_offset": "adjustment.contradicts_scan_angle_offset",
    "latency": "adjustment.contradicts_latency",
}
"""Code of the message that the data contradict a given value."""

MOST_RELEASED = 3
"""At most one in this number of sightings is rejected."""


def adjust(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    *,
    parameters: tuple[Parameter, ...] = (),
    shapes: Array | None = None,
    components: bool = False,
    accept_one_facing: bool = False,
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
    components : bool
        Whether to take the sigmas of LiDAR and POS from the data (correlated model).
    accept_one_facing : bool
        Whether to answer where all targets are planes that face one way.
    diagnostics : bool
        Whether to work out observability and reliability too.
    test_model : bool
        Whether, with diagnostics, the model of the errors follows the data where these contradict
        it: shorter correlation times where the chi-square test asks for them, and sigmas raised
        where answers without single lines or targets scatter too much (`raised_by_parts`).

    Raises
    ------
    AdjustmentError
        Where a sighting has too few points.
    RankDeficient
        Where lines and targets do not determine the boresight, or nothing checks it.
    TargetDisagrees
        Where two targets are left at most, or starting shapes are given.
    NotConverged
    """
    excluded: list[str] = []
    while True:
        try:
            result = _adjust(
                observations.without_targets(excluded), mounting, model, parameters, shapes,
                components, accept_one_facing, diagnostics, test_model, progress,
            )  # fmt: skip
        except TargetDisagrees as error:
            if shapes is not None or len(observations.targets) - len(excluded) <= 2:
                raise
            excluded.append(error.target)
        else:
            return replace(result, excluded_targets=tuple(excluded)) if excluded else result


def _adjust(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    parameters: tuple[Parameter, ...],
    shapes: Array | None,
    components: bool,
    accept_one_facing: bool,
    diagnostics: bool,
    test_model: bool,
    progress: Progress,
) -> AdjustmentResult:
    """`adjust` with all targets.

    Raises
    ------
    AdjustmentError
    RankDeficient
    TargetDisagrees
    NotConverged
    """
    started = time.perf_counter()
    observations.require_usable()

    def adjusted(
        model: StochasticModel, parameters: tuple[Parameter, ...] = parameters,
        some: Observations = observations, *, diagnostics: bool,
    ) -> AdjustmentResult:  # fmt: skip
        return _adjusted(
            some, mounting, model, parameters, shapes, components, accept_one_facing, diagnostics,
            test_model, progress, started,
        )  # fmt: skip

    try:
        with one_thread():
            found = adjusted(model, diagnostics=diagnostics)
            if diagnostics:
                radii = radius_discrepancies(observations, found.mounting)
                found = replace(found, radius_discrepancies=radii)
            if not (diagnostics and test_model and model.correlated):
                return found
            if not _is_rejected(found, REJECTION_LEVEL):
                return found
            if _is_explained(found, observations, parameters, adjusted):
                return found
            for factor in SHORTER_TIMES:
                shorter = replace(
                    model, position_time=factor * model.position_time,
                    attitude_time=factor * model.attitude_time,
                )  # fmt: skip
                with suppress(AdjustmentError, np.linalg.LinAlgError):
                    if not _is_rejected(adjusted(shorter, diagnostics=False)):
                        stated = model.position_time, model.attitude_time
                        return replace(
                            adjusted(shorter, diagnostics=True),
                            stated_times=stated,
                            radius_discrepancies=radii,
                        )
            return found
    except np.linalg.LinAlgError as reason:
        raise NotConverged(error("adjustment.diverged")) from reason


def _is_rejected(result: AdjustmentResult, chance: float = 0.025) -> bool:
    """Whether the residuals are too large for the model, by the chi-square test.

    Parameters
    ----------
    chance : float
        Probability that those of a right model are.
    """
    from scipy.special import chdtri

    freedom = result.degrees_of_freedom
    return freedom > 0 and bool(result.chi_square.statistic > chdtri(freedom, chance))


def _is_explained(
    found: AdjustmentResult,
    observations: Observations,
    parameters: tuple[Parameter, ...],
    adjusted: Callable[..., AdjustmentResult],
) -> bool:
    """Whether the residuals pass the test without the error that the result names as their cause.

    Correlation times as short as a second or two explain nearly everything, a late line as well.
    """
    causes = [group[0] for group in found.causes or () if len(group) == 1]
    values = [Parameter(each.kind) for each in causes if each.kind in SWITCHED]
    lines = {each.line for each in causes if each.kind not in SWITCHED and not each.target}
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
        return not _is_rejected(without)
    return False


def _adjusted(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    parameters: tuple[Parameter, ...],
    shapes: Array | None,
    components: bool,
    accept_one_facing: bool,
    diagnostics: bool,
    test_model: bool,
    progress: Progress,
    started: float,
) -> AdjustmentResult:
    few = _sampled(observations)
    origins = middles(few, mounting)
    few = about(few, origins)
    # The radii of the balls are estimated once the boresight is near the solution.
    first = usual_radii(few, mounting)
    fitted = fit_shapes(first, mounting)
    if shapes is not None:
        start = counted_from(shapes, origins, first.is_sphere)
    elif model.loss != "none":
        start = shapes_of_most(first, mounting, fitted)
    else:
        start = fitted
    problem = Problem.of(first, mounting, model, parameters)
    state = problem.start(mounting, start)
    kept, held = _seen(problem, state)
    problem = problem.with_parameters(kept)
    if first is not few:
        state = iterate(problem, state, progress).state
        problem = Problem.of(few, mounting, model, kept)
        state = problem.start(state.mounting, state.shapes)
    solution, gone = _led_by_most(problem, state, progress)
    if not accept_one_facing:
        require_two_facings(solution.linearised)
    found: tuple[Component, ...] = ()
    factors = np.ones(3)
    if components and model.correlated:
        # Sigmas that are too small would make blunders of sightings that are none.
        solution, _, factors = _with_components(solution, factors, progress)
    if _may_release(model):
        solution = _agreeing(solution, gone, progress)
    if components and model.correlated:
        solution, found, factors = _with_components(solution, factors, progress)
    if len(few) < len(observations):
        observations = about(observations.with_sigmas(*factors), origins)
        solution = _completed(solution, observations, progress)
    _require_determined_still(solution.linearised)
    return summary(
        solution.linearised, solution.state, fitted, origins,
        path=solution.path, held=held, components=found, diagnostics=diagnostics,
        raise_sigmas=test_model, started=started,
    )  # fmt: skip


def _seen(problem: Problem, state: State) -> tuple[tuple[Parameter, ...], tuple[Estimate, ...]]:
    """The parameters to estimate, and those the geometry hides; refuse a hopeless boresight."""
    linearised = problem.linearised(state)
    hidden = unseen(linearised) if problem.model.correlated else _not_in_thesis_mode(problem)
    correlated = problem.model.correlated
    held = {e.name for e in hidden if e.prior_sigma is None or not correlated}
    kept = tuple(p for p in problem.parameters if p.name not in held)
    if held:
        linearised = problem.with_parameters(kept).linearised(state)
    require_determined(linearised)
    return kept, hidden


def _require_determined_still(linearised: Linearised) -> None:
    """Check that the angles are still determined after rejections, with estimated form errors.

    Raises
    ------
    RankDeficient
    """
    try:
        require_determined(linearised)
    except RankDeficient as reason:
        wrong = contradictions(linearised, least=0.0) if linearised.problem.layout.surfaces else ()
        if not wrong:
            raise
        raise RankDeficient(_contradicted(wrong[0])) from reason


def _contradicted(wrong: Contradiction) -> Message:
    """The message that the data contradict a given value of the mounting."""
    if wrong.name.startswith("lever_"):
        axis = wrong.name.removeprefix("lever_").upper()
        return error("adjustment.contradicts_lever_arm", axis=axis, change=wrong.change)
    return error(CONTRADICTED[wrong.name], change=wrong.change)


def _not_in_thesis_mode(problem: Problem) -> tuple[Estimate, ...]:
    """All are fixed: independent POS errors would give them wrong values with small sigmas."""
    return tuple(
        Estimate(
            each.name, float(problem.prior.values[each.index]), each.sigma,
            reason=note("parameter.not_classical", parameter=quantity(each.name)),
        )
        for each in problem.parameters
    )  # fmt: skip


def _sampled(observations: Observations) -> Observations:
    """A sample of the points: start values, noise, form errors and blunders are found with it."""
    if len(observations) <= MANY:
        return observations
    return observations.where(observations.sample(MANY / len(observations)))


def _completed(near: Solution, observations: Observations, progress: Progress) -> Solution:
    """Continue with all points from the solution of a sample, with its noise and form errors."""
    sample = near.linearised.problem
    problem = Problem.of(
        observations, sample.prior, sample.model, sample.parameters, sample.moments
    )
    problem = replace(
        problem,
        noise=sample.noise,
        scale=sample.scale,
        surface_sigma=sample.surface_sigma,
        own_offsets=sample.own_offsets,
    )
    if problem.model.correlated:
        few, residuals = sample.observations, sample.residuals(near.state)[1]
        mine = None if problem.model.loss == "none" else at_target(few, residuals)
        denser = len(observations) / len(few)
        noise = noise_factors(few, residuals, sample.blocks, mine, denser=denser)
        problem = replace(problem, noise=noise)
    state = problem.resumed(near.state, sample)
    return iterate(problem, state, progress, earlier=near.path, told=True)


def _may_release(model: StochasticModel) -> bool:
    return model.correlated and model.loss != "none" and model.surface != 0


def _led_by_most(
    problem: Problem, start: State, progress: Progress
) -> tuple[Solution, list[Blunder]]:
    """Iterate without the sightings that deviate by metres; they may be restored later.

    Held to their targets they would pull the whole of all others along: a shared POS error yields.
    """
    observations, off = problem.observations, np.zeros(0, dtype=np.int64)
    if _may_release(problem.model):
        off = astray(observations, problem.residuals(start)[1])
    balls = observations.is_sphere[observations.target_of_sighting]
    gone = [Blunder("shift" if balls[s] else "surface", (int(s),)) for s in off]
    if 0 < len(gone) <= len(observations.sightings) // MOST_RELEASED:
        without = problem
        for found in gone:
            without = found.out_of(without)
        with suppress(RankDeficient, NotConverged):  # then they are needed after all
            solution = iterate(without, start, progress)
            plain = plainly_off(solution.linearised, gone)
            if plain == gone:
                return solution, gone
            problem = solution.linearised.problem
            for found in gone:
                problem = found.back_in(problem)
            for found in plain:
                problem = found.out_of(problem)
            return iterate(problem, solution.state, progress, earlier=solution.path), plain
    return iterate(problem, start, progress), []


def _let_go(solution: Solution) -> int:
    """Number of rejected sightings."""
    return int((~solution.linearised.problem.held).sum())


def _agreeing(start: Solution, gone: list[Blunder], progress: Progress) -> Solution:
    """Reject blunders; use a separate sigma of the offsets if the data require it.

    Boards that are displaced between lines, but not warped, would be rejected one after the other;
    so would boards displaced by a wrong mounting parameter.
    """
    solution = _explained(start, gone, progress)
    here = solution.linearised
    if here.problem.model.surface is not None or not offsets_insist(here):
        return solution
    if contradictions(here, least=0.0):
        return solution
    problem = replace(start.linearised.problem, own_offsets=True)
    try:
        other = iterate(problem, start.state, progress, earlier=solution.path)
        return _explained(other, gone, progress)
    except (RankDeficient, NotConverged):
        return solution


def _explained(solution: Solution, gone: list[Blunder], progress: Progress) -> Solution:
    """Reject blunders that a wrong mounting parameter does not explain.

    With a wrong given lever arm, good sightings of whole lines disagree. If freeing contradicted
    parameters saves more rejections than there are parameters, only the other sightings are
    rejected. The parameters are not estimated; the result lists the contradictions.
    """
    released = _without_blunders(solution, gone, progress)
    problem = solution.linearised.problem
    count = _let_go(released)
    if count <= _let_go(solution):
        return released
    fewest, surfaces = count, None
    tried: list[tuple[str, ...]] = [()]
    for judged in (solution, released):
        # In the order they were found: what explains most comes first.
        names = tuple(each.name for each in contradictions(judged.linearised, least=0.0))
        if names in tried:
            continue
        tried.append(names)
        wider = problem.with_parameters((*problem.parameters, *map(Parameter, names)))
        try:
            let_go = iterate(wider, solution.state, progress, earlier=solution.path)
            explained = _without_blunders(let_go, gone, progress)
        except (RankDeficient, NotConverged):
            continue
        if _let_go(explained) + len(names) < fewest:
            fewest = _let_go(explained) + len(names)
            surfaces = explained.linearised.problem.surface_sigma
    if surfaces is None:
        return released
    surfaces = np.where(surfaces >= RELEASED, RELEASED, problem.usual_surface)
    problem = replace(problem, surface_sigma=surfaces)
    return iterate(problem, solution.state, progress, earlier=solution.path)


def _without_blunders(solution: Solution, gone: list[Blunder], progress: Progress) -> Solution:
    """Reject the least consistent sightings one at a time, and iterate, until all agree.

    A blunder may make other sightings appear as blunders: these are restored if they agree without
    it; this includes the sightings in ``gone``.
    """
    most = len(solution.linearised.problem.observations.sightings) // MOST_RELEASED
    gone = list(gone)
    spared: set[Blunder] = set()
    while True:
        here = solution.linearised
        if (back := belonging(here, gone)) is not None:
            gone.remove(back)
            spared.add(back)
            problem = back.back_in(here.problem)
        else:
            worst = worst_blunder(here, spared)
            if worst is None or sum(len(b.sightings) for b in [*gone, worst]) > most:
                return solution
            gone.append(worst)
            problem = worst.out_of(here.problem)
        solution = iterate(problem, solution.state, progress, earlier=solution.path)


def _with_components(
    solution: Solution, total: Array, progress: Progress
) -> tuple[Solution, tuple[Component, ...], Array]:
    """Repeat the adjustment with the sigmas estimated from the data, until these converge.

    ``total`` holds the factors on the given sigmas that are in ``solution`` already.
    """
    for _ in range(COMPONENT_ROUNDS):
        found = variance_components(solution.linearised)
        # A sigma is raised on suspicion, lowered on evidence: too large a one costs little.
        news = np.array(
            [
                c.factor if (told and c.factor > RAISED) or c.upper < 1 else 1.0
                for c, told in zip(found.components, found.told, strict=True)
            ]
        )
        factors = np.clip(total * news, *FACTORS) / total
        total = total * factors
        if np.abs(np.log(factors)).max() < SCALE_SETTLED:
            break
        problem = solution.linearised.problem.with_sigmas(*factors)
        problem = problem.with_surface(found.rough * problem.usual_surface)
        solution = iterate(problem, solution.state, progress, earlier=solution.path)
    final = variance_components(solution.linearised)
    return (
        solution,
        tuple(
            Component(
                c.name,
                float(t if t in FACTORS else t * c.factor),
                float(t * c.lower),
                float(t * c.upper),
                bool(t != 1),
                float(t),
            )
            for c, t in zip(final.components, total, strict=True)
        ),
        total,
    )
