"""Long work on a plan: search, scenarios and simulated surveys, in the background."""

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
from lispac.gui.design.surveys import Asked
from lispac.progress import Progress
from lispac.workflow.campaign import pool_of
from lispac.workflow.designing import many_surveys

FEW = 600
"""Plans that are looked at sooner than other processes are started."""


class Rated:
    """A mapper that counts what comes back, and a progress that tells the rate."""

    def __init__(self, mapper: Mapper, progress: Progress, rate: str = "{:,.0f} plans/s") -> None:
        self._mapper, self._progress, self._rate = mapper, progress, rate
        self._count, self._began = 0, time.monotonic()

    def map(self, function: Callable[[Any], Any], values: Iterable[Any]) -> Iterator[Any]:
        """The answers in order."""
        for value in self._mapper(function, values):
            self._count += 1
            if self._count % 10 == 0:  # asked for the cancel flag between reports as well
                self._progress(self._fraction)
            yield value

    _fraction = 0.0

    def progress(self, fraction: float, message: str = "") -> None:
        """Tell how far it is, and how many a second."""
        self._fraction = fraction
        elapsed = time.monotonic() - self._began
        known = elapsed > 0.5 and self._count
        rate = f", {self._rate.format(self._count / elapsed)}" if known else ""
        self._progress(fraction, f"{message}{rate}" if message else "")


def best_plan(
    site: Site, objective: Objective, plans: int, start: Plan, progress: Progress
) -> Design:
    """The best plan of a site, on all cores where there are many to look at."""
    workers = 1 if plans * len(objective.pos_factors) <= FEW else os.cpu_count() or 1
    progress(0.0, "Starting the search")
    with pool_of(workers) as mapper:
        rated = Rated(mapper, progress)
        return search(
            site, objective, plans=plans, start=start, mapper=rated.map, progress=rated.progress
        )


def all_scenarios(plan: Plan, progress: Progress) -> tuple[Outcome, ...]:
    """What one thing changes, whichever it is."""
    return outcomes(plan, tuple(SCENARIOS), progress=progress)


def simulated_surveys(plan: Plan, asked: Asked, progress: Progress) -> Scatter:
    """Many surveys of a plan, on all cores; cancelled, those that are finished if enough are."""
    progress(0.0, "Starting the surveys")
    with pool_of(os.cpu_count() or 1, at_once=1) as mapper:
        rated = Rated(mapper, progress, "{:.1f} surveys/s")
        return many_surveys(
            plan, asked.surveys, seed=asked.seed, flatness_known=asked.flatness_known,
            enough=ENOUGH, mapper=rated.map, progress=rated.progress,
        )  # fmt: skip
