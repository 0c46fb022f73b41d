"""The least-squares adjustment of mounting and targets (thesis B.3)."""

import time
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.adaptation import SCALE_SETTLED, differ, with_noise, with_surface
from lispac.adjustment.blas import one_thread
from lispac.adjustment.blunders import Blunder, belonging, plainly_off, worst_blunder
from lispac.adjustment.components import FACTORS, variance_components
from lispac.adjustment.noise import astray, at_target, noise_factors
from lispac.adjustment.observability import require_determined, require_two_facings, unseen
from lispac.adjustment.observations import Observations
from lispac.adjustment.parameters import Estimate, Parameter
from lispac.adjustment.problem import Linearised, Problem
from lispac.adjustment.result import AdjustmentResult, Component
from lispac.adjustment.robust import Loss
from lispac.adjustment.shapes import (
    about,
    counted_from,
    fit_shapes,
    middles,
    shapes_of_most,
    usual_radii,
)
from lispac.adjustment.stochastic import StochasticModel
from lispac.adjustment.summary import summary
from lispac.adjustment.sums import State
from lispac.errors import NotConverged, RankDeficient
from lispac.progress import Progress, no_progress
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

MAX_ITERATIONS = 200
ANGLES_SETTLED, OTHERS_SETTLED = 1e-11, 1e-8
"""Largest change of an angle (rad) and of another unknown (rad, m, s) that is still to come."""

MANY = 50_000
"""Points that lead near the answer; where there are more, all of them take the last steps only."""

NEAR = 1e-5
"""Change of an angle (rad) below which noise, surfaces and strays can be told apart."""

COMPONENT_ROUNDS = 5

RAISED = 1.05
"""Factor on a stated sigma below which raising it would change nothing worth telling."""

PATIENCE, SLACK = 60, np.array([1e3, 1e5])
"""After so many iterations larger changes will do: 1e-6 deg, and 1 mm of a sighting whose points
hesitate between some weight and none."""

NEARLY = 100
"""Times the limits to go: a step that foresees nothing will do, and the sigmas come from it."""

FORESEEN = 10
"""Steps that foresee how the weights will change; where they do not settle, plain ones will."""

FREELY = 10
"""Iterations far from the answer in which the noise may fall again."""

ADAPTATIONS = 12
"""Times that noise and surfaces are taken from the data; a limit between two of their values would
be crossed for ever."""

MOST_RELEASED = 3
"""No more than one sighting in so many is let go of."""


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
    progress: Progress = no_progress,
) -> AdjustmentResult:
    """Find the boresight that makes each target's points, over all lines, one surface.

    Gauss-Helmert model with unit normals kept exactly: a plane moves by two turns of its normal
    and its offset. The products summed over groups of points carry all the points say, so an
    iteration costs one pass over them and a small solve.

    Parameters
    ----------
    mounting : Mounting
        The prior boresight as the starting value; all other values as they are known.
    parameters : tuple of Parameter
        Values of the mounting to estimate besides the boresight. One that the geometry does not
        see is held, and the result says so.
    shapes : ndarray of shape (targets, 4), optional
        Starting planes and spheres; fitted to the points placed with ``mounting`` where not given.
    components : bool
        Whether to take the sigmas of LiDAR and POS from the data (correlated model).
    accept_one_facing : bool
        Whether to answer where all targets are planes that face one way.
    diagnostics : bool
        Whether to work out observability and reliability too.

    Raises
    ------
    AdjustmentError
        Where a sighting has too few points.
    RankDeficient
        Where lines and targets do not determine the boresight, or nothing checks it.
    NotConverged
    """
    started = time.perf_counter()
    observations.require_usable()
    try:
        with one_thread():
            return _adjusted(
                observations, mounting, model, parameters, shapes, components,
                accept_one_facing, diagnostics, progress, started,
            )  # fmt: skip
    except np.linalg.LinAlgError as error:
        raise NotConverged(
            "The adjustment ran away from any answer; check that each target is the same surface "
            "on every line, and the prior boresight."
        ) from error


def _adjusted(
    observations: Observations,
    mounting: Mounting,
    model: StochasticModel,
    parameters: tuple[Parameter, ...],
    shapes: Array | None,
    components: bool,
    accept_one_facing: bool,
    diagnostics: bool,
    progress: Progress,
    started: float,
) -> AdjustmentResult:
    few = _sampled(observations)
    origins = middles(few, mounting)
    few = about(few, origins)
    # The radii of the balls are let go when the boresight is near.
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
        state = _iterate(problem, state, progress).state
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
        solution = _without_blunders(solution, gone, progress)
    if components and model.correlated:
        solution, found, factors = _with_components(solution, factors, progress)
    if len(few) < len(observations):
        observations = about(observations.with_sigmas(*factors), origins)
        solution = _completed(solution, observations, progress)
    return summary(
        solution.linearised, solution.state, fitted, origins,
        path=solution.path, held=held, components=found, diagnostics=diagnostics,
        started=started,
    )  # fmt: skip


@dataclass(frozen=True, eq=False)
class Solution:
    """Where the iterations ended."""

    linearised: Linearised
    state: State
    path: Array


def _seen(problem: Problem, state: State) -> tuple[tuple[Parameter, ...], tuple[Estimate, ...]]:
    """The parameters to estimate, and those the geometry hides; refuse a hopeless boresight."""
    linearised = problem.linearised(state)
    hidden = unseen(linearised)
    held = {estimate.name for estimate in hidden if estimate.prior_sigma is None}
    kept = tuple(p for p in problem.parameters if p.name not in held)
    if held:
        linearised = problem.with_parameters(kept).linearised(state)
    require_determined(linearised)
    return kept, hidden


def _to_come(change: Array, last: Array) -> Array:
    """How far there still is to go if every change is to the next as the last to this one."""
    rate = np.minimum(change / np.maximum(last, np.finfo(float).tiny), 0.5)
    return np.asarray(change * rate / (1 - rate))


def _sampled(observations: Observations) -> Observations:
    """Some of many points: they lead near the answer, and tell noise, surfaces and blunders."""
    if len(observations) <= MANY:
        return observations
    return observations.where(observations.sample(MANY / len(observations)))


def _completed(near: Solution, observations: Observations, progress: Progress) -> Solution:
    """Go on with all points from where a sample of them has led, and with what it has told."""
    sample = near.linearised.problem
    problem = Problem.of(
        observations, sample.prior, sample.model, sample.parameters, sample.moments
    )
    problem = replace(
        problem, noise=sample.noise, scale=sample.scale, surface_sigma=sample.surface_sigma
    )
    if problem.model.correlated:
        few, residuals = sample.observations, sample.residuals(near.state)[1]
        mine = None if problem.model.loss == "none" else at_target(few, residuals)
        denser = len(observations) / len(few)
        noise = noise_factors(few, residuals, sample.blocks, mine, denser=denser)
        problem = replace(problem, noise=noise)
    state = problem.resumed(near.state, sample)
    return _iterate(problem, state, progress, earlier=near.path, told=True)


def _may_release(model: StochasticModel) -> bool:
    return model.correlated and model.loss != "none" and model.surface != 0


def _led_by_most(
    problem: Problem, start: State, progress: Progress
) -> tuple[Solution, list[Blunder]]:
    """Iterate without the sightings that are metres off; they may be taken back later.

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
            solution = _iterate(without, start, progress)
            plain = plainly_off(solution.linearised, gone)
            if plain == gone:
                return solution, gone
            problem = solution.linearised.problem
            for found in gone:
                problem = found.back_in(problem)
            for found in plain:
                problem = found.out_of(problem)
            return _iterate(problem, solution.state, progress, earlier=solution.path), plain
    return _iterate(problem, start, progress), []


def _without_blunders(solution: Solution, gone: list[Blunder], progress: Progress) -> Solution:
    """Let go of the sightings that agree least, iterate, and again until all agree.

    One blunder may make others look like it: what agrees without it is taken back, and so may be
    what is ``gone`` already.
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
        solution = _iterate(problem, solution.state, progress, earlier=solution.path)


def _iterate(
    problem: Problem,
    state: State,
    progress: Progress,
    earlier: Array | None = None,
    *,
    told: bool = False,
) -> Solution:
    """Iterate; ``told`` says that the sigmas from the data are in the problem already."""
    final = Loss(problem.model.loss)
    if not told:
        problem = problem.with_blocks()
    loss = final if told else final.start
    weighted = final.name != "none"
    settled = told or not (problem.model.correlated or weighted)
    adaptations, steps, nearly = 0, 0, False
    limits = np.array([ANGLES_SETTLED, OTHERS_SETTLED])
    last = np.zeros(2)
    path = [] if earlier is None else list(earlier)
    for iteration in range(1, MAX_ITERATIONS + 1):
        progress(iteration / MAX_ITERATIONS, f"Adjusting: iteration {iteration}")
        # Weights that go with the residuals settle slowly unless the step foresees them.
        foreseen = settled and weighted and not nearly and (told or steps > 0)
        foreseen = foreseen and steps <= FORESEEN
        try:
            linearised = problem.linearised(state, loss, tangent=foreseen)
            state, correction = linearised.step()
        except (RankDeficient, np.linalg.LinAlgError):
            if not foreseen:
                raise
            steps = FORESEEN + 1  # too far off for that
            continue
        path.append(state.mounting.boresight)
        change = np.array([np.abs(correction[:3]).max(), np.abs(correction[3:]).max()])
        if change[0] > NEAR:
            if not settled:  # far from the answer all points are noisy
                problem = with_noise(problem, state, falling=iteration <= FREELY)
        elif not settled:
            adapted = with_surface(with_noise(problem, state), linearised)
            adaptations += 1
            same = adaptations >= ADAPTATIONS or not differ(problem, adapted)
            settled = loss == final and same
            problem, loss = adapted, final
        else:
            steps += 1
            ease = np.array([1.0, 1.0]) if iteration <= PATIENCE else SLACK
            # A pass over many points is dear, so the last one is foretold; few tell it themselves.
            to_come = _to_come(change, last)
            left = to_come if told else change
            nearly = bool((to_come < NEARLY * limits).all())
            if (left < ease * limits).all():
                if foreseen:  # the sigmas come from the weights as they are
                    linearised = problem.linearised(state, loss)
                return Solution(linearised, state, np.array(path))
        last = change
    raise NotConverged(
        f"The adjustment did not settle in {MAX_ITERATIONS} iterations (last change "
        f"{np.degrees(change[0]):.1e} deg of the angles, {change[1]:.1e} m of the rest); check "
        "that each target is the same surface on every line, and the prior boresight."
    )


def _with_components(
    solution: Solution, total: Array, progress: Progress
) -> tuple[Solution, tuple[Component, ...], Array]:
    """Adjust once more with the sigmas that the data tell, until they tell nothing new.

    ``total`` holds the factors on the stated sigmas that are in ``solution`` already.
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
        solution = _iterate(problem, solution.state, progress, earlier=solution.path)
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
            )
            for c, t in zip(final.components, total, strict=True)
        ),
        total,
    )
