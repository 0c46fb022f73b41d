"""Rejection of sightings that disagree with the others, and their restoration.

The adjustment is repeated with the tests of `lispac.adjustment.solve.blunders` until all remaining
sightings agree.
"""

from contextlib import suppress
from dataclasses import replace

import numpy as np

from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem
from lispac.adjustment.solve.blunders import (
    Blunder,
    find_confirmed_blunders,
    find_restorable_blunder,
    worst_blunder,
)
from lispac.adjustment.solve.group_sums import AdjustmentState
from lispac.adjustment.solve.iteration import IterationResult, iterate
from lispac.adjustment.solve.noise_estimation import find_displaced_sightings
from lispac.adjustment.solve.omitted_parameters import find_contradicted_parameters
from lispac.adjustment.solve.variance_components import is_separate_offset_sigma_needed
from lispac.errors import NotConverged, RankDeficient
from lispac.progress import Progress

MIN_SIGHTINGS_PER_REJECTION = 3
"""Smallest number of sightings for each one that may be rejected."""


def may_reject_sightings(model: StochasticModel) -> bool:
    """Whether disagreeing sightings are rejected with this model."""
    return model.correlated and model.loss != "none" and model.surface != 0


def iterate_with_majority(
    problem: AdjustmentProblem, start: AdjustmentState, progress: Progress
) -> tuple[IterationResult, list[Blunder]]:
    """Iterate without the sightings that are displaced by far; they may be restored later.

    In the adjustment, they would displace all other sightings through the common POS errors.
    """
    observations, off = problem.observations, np.zeros(0, dtype=np.int64)
    if may_reject_sightings(problem.model):
        off = find_displaced_sightings(observations, problem.residuals(start)[1])
    spheres = observations.is_sphere[observations.target_of_sighting]
    rejected = [Blunder("shift" if spheres[s] else "surface", (int(s),)) for s in off]
    if 0 < len(rejected) <= len(observations.sightings) // MIN_SIGHTINGS_PER_REJECTION:
        without = problem
        for blunder in rejected:
            without = blunder.reject_in(without)
        with suppress(RankDeficient, NotConverged):  # then iterate with all sightings
            solution = iterate(without, start, progress)
            confirmed = find_confirmed_blunders(solution.linearised, rejected)
            if confirmed == rejected:
                return solution, rejected
            problem = solution.linearised.problem
            for blunder in rejected:
                problem = blunder.restore_in(problem)
            for blunder in confirmed:
                problem = blunder.reject_in(problem)
            return iterate(problem, solution.state, progress, earlier=solution.path), confirmed
    return iterate(problem, start, progress), []


def reject_disagreeing_sightings(
    start: IterationResult, rejected: list[Blunder], progress: Progress
) -> IterationResult:
    """Reject disagreeing sightings, and estimate a separate sigma of the offsets if needed.

    The separate sigma is needed for boards that are displaced between lines but not bent, which
    would otherwise be rejected one by one. It is not used if a wrong value of the mounting explains
    the displacements.
    """
    solution = _reject_unexplained_sightings(start, rejected, progress)
    linearised = solution.linearised
    if linearised.problem.model.surface is not None or not is_separate_offset_sigma_needed(
        linearised
    ):
        return solution
    if find_contradicted_parameters(linearised, min_angle_change=0.0):
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

    With a wrong lever arm, correct sightings of whole lines disagree. If freeing the contradicted
    values avoids more rejections than there are values, only those sightings are rejected that
    still disagree then. The values themselves remain fixed; the result lists the contradictions.
    """
    after = _reject_blunders(solution, rejected, progress)
    problem = solution.linearised.problem
    count = _count_rejected_sightings(after)
    if count <= _count_rejected_sightings(solution):
        return after
    fewest, rejected_then = count, None
    tried: list[tuple[str, ...]] = [()]
    for reference in (solution, after):
        # In the order in which they were found, the most significant first.
        names = tuple(
            each.name
            for each in find_contradicted_parameters(reference.linearised, min_angle_change=0.0)
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
            rejected_then = explained.linearised.problem.rejected
    if rejected_then is None:
        return after
    usual = problem.default_surface_sigmas
    problem = replace(problem, rejected=rejected_then).with_surface_sigma(usual)
    return iterate(problem, solution.state, progress, earlier=solution.path)


def _reject_blunders(
    solution: IterationResult, rejected: list[Blunder], progress: Progress
) -> IterationResult:
    """Reject the worst sighting and iterate until all remaining sightings agree.

    A blunder may make other sightings look like blunders. Rejected sightings, including those in
    ``rejected``, are restored if they agree once the blunder is removed.
    """
    limit = len(solution.linearised.problem.observations.sightings) // MIN_SIGHTINGS_PER_REJECTION
    rejected = list(rejected)
    untested: set[Blunder] = set()
    while True:
        linearised = solution.linearised
        if (restorable := find_restorable_blunder(linearised, rejected)) is not None:
            rejected.remove(restorable)
            untested.add(restorable)
            problem = restorable.restore_in(linearised.problem)
        else:
            worst = worst_blunder(linearised, untested)
            if worst is None or sum(len(b.sightings) for b in [*rejected, worst]) > limit:
                return solution
            rejected.append(worst)
            problem = worst.reject_in(linearised.problem)
        solution = iterate(problem, solution.state, progress, earlier=solution.path)


def _count_rejected_sightings(solution: IterationResult) -> int:
    """Number of rejected sightings."""
    return int(solution.linearised.problem.rejected_sightings.sum())
