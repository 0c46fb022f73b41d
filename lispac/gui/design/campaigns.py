"""Long computations on a plan: search, scenarios and simulated surveys."""

import os
import time
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from lispac.design.monte_carlo import ENOUGH, Scatter
from lispac.design.objective import Objective
from lispac.design.plan import Plan
from lispac.design.scenarios import (
    SCENARIOS,
    Outcome,
    outcomes,
)
from lispac.design.search import Design, Mapper, search
from lispac.design.site import Site
from lispac.gui.design.surveys import SimulationRequest
from lispac.language import N_, gettext_lazy
from lispac.progress import Progress, Step
from lispac.workflow.campaign import pool_of
from lispac.workflow.plan_checks import many_surveys

FEW = 600
"""Plans that are examined sooner than other processes are started."""


class CountingMapper:
    """A mapper that counts its results, and a progress that shows their rate."""

    def __init__(self, mapper: Mapper, progress: Progress, rate: str) -> None:
        self._mapper, self._progress, self._rate = mapper, progress, rate
        self._count, self._began = 0, time.monotonic()

    def map(self, function: Callable[[Any], Any], values: Iterable[Any]) -> Iterator[Any]:
        """Results in order."""
        for value in self._mapper(function, values):
            self._count += 1
            if self._count % 10 == 0:  # the cancel flag is read between reports as well
                self._progress(self._fraction)
            yield value

    _fraction = 0.0

    def progress(self, fraction: float, step: Step | None = None) -> None:
        """Report the progress with the rate."""
        self._fraction = fraction
        elapsed = time.monotonic() - self._began
        known = elapsed > 0.5 and self._count
        if step is not None and known:
            rate = gettext_lazy(self._rate, rate=self._count / elapsed)
            step = gettext_lazy("{step}, {rate}", step=step, rate=rate)
        self._progress(fraction, step)


def best_plan(
    site: Site, objective: Objective, plans: int, start: Plan, progress: Progress
) -> Design:
    """The best plan of a site, on all cores if there are many plans."""
    workers = 1 if plans * len(objective.pos_factors) <= FEW else os.cpu_count() or 1
    progress(0.0, gettext_lazy("Starting the search for the best survey plan"))
    with pool_of(workers) as mapper:
        rated = CountingMapper(mapper, progress, N_("{rate:x} survey plans/s"))
        return search(
            site, objective, plans=plans, start=start, mapper=rated.map, progress=rated.progress
        )


def all_scenarios(plan: Plan, progress: Progress) -> tuple[Outcome, ...]:
    """What one thing changes, whichever it is."""
    return outcomes(plan, tuple(SCENARIOS), progress=progress)


def simulated_surveys(plan: Plan, asked: SimulationRequest, progress: Progress) -> Scatter:
    """Many surveys of a plan, on all cores; cancelled, those that are finished if enough are."""
    progress(0.0, gettext_lazy("Starting the simulated surveys"))
    with pool_of(os.cpu_count() or 1, at_once=1) as mapper:
        rated = CountingMapper(mapper, progress, N_("{rate:x.1} simulated surveys/s"))
        return many_surveys(
            plan, asked.surveys, seed=asked.seed, flatness_known=asked.flatness_known,
            enough=ENOUGH, mapper=rated.map, progress=rated.progress,
        )  # fmt: skip
