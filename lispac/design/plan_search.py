"""Search for the best plan of a site: boards and lines.

If there are few possible plans, all are evaluated. Otherwise, differential evolution (Storn and
Price 1997, implemented in SciPy) searches among them. The best plans that it finds are improved by
exchanging one board or line at a time for another allowed one, until no exchange reduces the
objective (coordinate exchange: Meyer and Nachtsheim 1995).
"""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.design.objective import PlanObjective
from lispac.design.plan import Plan
from lispac.design.plan_choices import (
    INVALID_PLAN_VALUE,
    DesignSpace,
    PlanChoice,
    have_targets_one_orientation,
)
from lispac.design.prediction import Prediction, predict
from lispac.design.site import Site
from lispac.errors import RankDeficient
from lispac.language import gettext_lazy
from lispac.messages import error
from lispac.progress import Progress, no_progress

Array = NDArray[np.float64]
Mapper = Callable[[Callable[[Any], Any], Iterable[Any]], Iterable[Any]]
"""Function like `map`: calls a function on each value, in any process; results keep their order."""

MAX_EXHAUSTIVE_PLANS = 20_000
"""Largest number of possible plans for which all are evaluated."""

PLANS_PER_GENE = 8
"""Number of plans of a generation per gene."""

IMPROVED_PLAN_COUNT = 2
"""Number of plans of the last generation that are improved by exchanges."""

MIN_RELATIVE_GAIN = 1e-3
"""Smallest relative decrease of the objective for an exchange."""


@dataclass(frozen=True)
class InformationGain:
    """Information gain of a target or line, as the precision of the plan without it.

    Attributes
    ----------
    without : float, radians
        Value of the objective; infinite if an angle would not be determined.
    sigma : tuple of float, radians
        Standard deviations of roll, pitch and yaw; infinite if one would not be determined.
    """

    name: str
    without: float
    sigma: tuple[float, ...]

    @classmethod
    def of(cls, name: str, others: Plan, objective: PlanObjective) -> "InformationGain":
        """Information gain of the part ``name``, from the plan of all other parts."""
        found = predict(others)
        sigma = tuple(map(float, found.sigma))
        return cls(name, objective.of_prediction(others, found), sigma)


@dataclass(frozen=True, eq=False)
class ReductionStep:
    """One plan of a sequence of plans with decreasing effort.

    Attributes
    ----------
    plan : Plan
    minutes : float
        Duration of the survey.
    value : float, radians
        Value of the objective.
    """

    plan: Plan
    minutes: float
    value: float


@dataclass(frozen=True, eq=False)
class DesignResult:
    """Result of the search for a plan.

    Attributes
    ----------
    plan : Plan
        Best plan.
    prediction : Prediction
    value : float, radians
        Value of the objective.
    exact : bool
        Whether all possible plans were evaluated, so that none is better.
    evaluated : int
        Number of evaluations.
    gains : tuple of InformationGain
        Information gain of each target and each line, the largest first.
    front : tuple of ReductionStep
        Plans with successively fewer targets and lines, starting with ``plan``.
    """

    plan: Plan
    prediction: Prediction
    value: float
    exact: bool
    evaluated: int
    gains: tuple[InformationGain, ...]
    front: tuple[ReductionStep, ...]


def search(
    site: Site,
    objective: PlanObjective | None = None,
    *,
    plans: int = 10_000,
    seed: int = 2019,
    start: Plan | None = None,
    mapper: Mapper = map,
    progress: Progress = no_progress,
) -> DesignResult:
    """Find the best plan that a site allows.

    Parameters
    ----------
    plans : int
        Approximate number of plans that the evolution evaluates, if there are too many to evaluate
        all.
    seed : int
        Seed of the random numbers; the same seed gives the same plan with any mapper.
    start : Plan, optional
        Plan of the initial population, if the site allows it; the result is never worse.
    mapper : callable
        `map`, or the map method of a pool of processes.

    Raises
    ------
    RankDeficient
        No plan that the site allows determines the boresight.
    """
    space = DesignSpace(site, objective or PlanObjective())
    counted = _CountingMapper(mapper, progress, min(plans, space.size))
    exact = space.size <= MAX_EXHAUSTIVE_PLANS
    if exact:
        chosen = _best_of_all_choices(space, counted)
    else:
        evolved = _evolve_choices(space, counted, plans, seed, start)
        chosen = min(
            (_improve_by_exchange(space, each, counted) for each in evolved), key=space.value
        )
    plan = space.plan(chosen)
    prediction = predict(plan)
    if not prediction.determined or space.value(chosen) >= INVALID_PLAN_VALUE:
        raise RankDeficient(error("design.no_plan"))
    progress(0.95, gettext_lazy("Computing the information gain"))
    return DesignResult(
        plan,
        prediction,
        space.objective.of(plan),
        exact,
        counted.count,
        information_gains(plan, space.objective),
        _reduce_effort(site, plan, space.objective),
    )


def information_gains(
    plan: Plan, objective: PlanObjective, *, progress: Progress = no_progress
) -> tuple[InformationGain, ...]:
    """Information gain of each target and each line, the largest first."""
    found: list[InformationGain] = []
    every = len(plan.targets) + len(plan.lines)
    for k, target in enumerate(plan.targets):
        progress(len(found) / every)
        others = plan.with_targets((*plan.targets[:k], *plan.targets[k + 1 :]))
        found.append(InformationGain.of(target.name, others, objective))
    for k, course in enumerate(plan.courses):
        progress(len(found) / every)
        others = plan.with_lines((*plan.lines[:k], *plan.lines[k + 1 :]))
        found.append(InformationGain.of(course.name, others, objective))
    return tuple(sorted(found, key=lambda each: -each.without))


class _CountingMapper:
    """Mapper that counts the evaluated plans and reports progress."""

    def __init__(self, mapper: Mapper, progress: Progress, expected: int) -> None:
        self.mapper, self.progress, self.expected = mapper, progress, expected
        self.count, self.best = 0, float("inf")

    def __call__(self, function: Callable[[Any], float], values: Iterable[Any]) -> list[float]:
        found = []
        for value in self.mapper(function, values):
            found.append(value)
            self.count += 1
            self.best = min(self.best, value)
            if self.count % 50 == 0:
                done = min(self.count / self.expected, 1.0)
                self.progress(
                    0.9 * done,
                    gettext_lazy(
                        "Evaluated plans: {count:n}, best σ {best:deg.4}°",
                        count=self.count,
                        best=self.best,
                    ),
                )
        return found


def _best_of_all_choices(space: DesignSpace, mapper: Mapper) -> PlanChoice:
    choices = list(space.all())
    values = list(mapper(space.value, choices))
    return choices[int(np.argmin(values))]


@dataclass(frozen=True, eq=False)
class _GeneObjective:
    """Objective value as a function of the genes; a class so that it can be pickled."""

    space: DesignSpace

    def __call__(self, genes: Array) -> float:
        return self.space.value(self.space.choice(genes))


def _evolve_choices(
    space: DesignSpace, mapper: Mapper, plans: int, seed: int, start: Plan | None
) -> list[PlanChoice]:
    """Best choices of the last generation, all different, at most `IMPROVED_PLAN_COUNT`."""
    from scipy.optimize import differential_evolution

    known = None if start is None else space.nearest(start)
    generations = max(plans // (PLANS_PER_GENE * len(space.gene_sizes)) - 1, 1)
    result = differential_evolution(
        _GeneObjective(space),
        [(0, width - 1) for width in space.gene_sizes],
        integrality=True,
        popsize=PLANS_PER_GENE,
        maxiter=generations,
        init="sobol",
        x0=None if known is None else np.array(space.genes(known)),
        seed=seed,
        polish=False,
        updating="deferred",
        workers=mapper,
        tol=0.0,
    )
    best_first = np.argsort(result.population_energies, kind="stable")
    choices = dict.fromkeys(space.choice(result.population[k]) for k in best_first)
    return list(choices)[:IMPROVED_PLAN_COUNT]


def _improve_by_exchange(space: DesignSpace, choice: PlanChoice, mapper: Mapper) -> PlanChoice:
    """Improve a choice by exchanges of one board or line until none helps."""
    value = space.value(choice)
    improved = True
    while improved:
        improved = False
        for which, count in (("lines", len(space.lines)), ("boards", len(space.places))):
            for slot in range(len(getattr(choice, which))):
                kept: tuple[int, ...] = getattr(choice, which)
                others = [
                    replace(choice, **{which: (*kept[:slot], k, *kept[slot + 1 :])})
                    for k in range(count)
                ]
                values = list(mapper(space.value, others))
                best = int(np.argmin(values))
                if values[best] < (1 - MIN_RELATIVE_GAIN) * value:
                    choice, value, improved = others[best], values[best], True
    return choice


def _reduce_effort(site: Site, plan: Plan, objective: PlanObjective) -> tuple[ReductionStep, ...]:
    """Omit lines and boards one by one.

    Each time, the one is omitted that increases the objective least, relative to its value and per
    minute saved.
    """
    steps = [ReductionStep(plan, site.minutes(plan), objective.of(plan))]
    while True:
        now = steps[-1]
        fewer = [
            now.plan.with_lines(lines)
            for k in range(len(now.plan.lines))
            for lines in [(*now.plan.lines[:k], *now.plan.lines[k + 1 :])]
        ]
        fewer += [
            now.plan.with_targets(targets)
            for k, target in enumerate(now.plan.targets)
            if target not in site.natural
            for targets in [(*now.plan.targets[:k], *now.plan.targets[k + 1 :])]
        ]
        found = [
            ReductionStep(p, site.minutes(p), objective.of(p))
            for p in fewer
            if p.targets and p.lines
        ]
        found = [
            s
            for s in found
            if predict(s.plan).determined and not have_targets_one_orientation(s.plan)
        ]
        if not found:
            return tuple(steps)
        steps.append(
            min(found, key=lambda s: np.log(s.value / now.value) / (now.minutes - s.minutes))
        )
