"""Long computations on a plan: search, scenarios and simulated surveys."""

import os
import time
from collections.abc import Callable, Iterable, Iterator
from typing import Any

from lispac.design.monte_carlo import MIN_SURVEYS, MonteCarloResult
from lispac.design.objective import PlanObjective
from lispac.design.plan import Plan
from lispac.design.plan_search import DesignResult, Mapper, search
from lispac.design.scenarios import (
    SCENARIOS,
    ScenarioOutcome,
    predict_scenarios,
)
from lispac.design.site import Site
from lispac.gui.features.design.surveys import SimulationRequest
from lispac.language import N_, gettext_lazy
from lispac.progress import Progress, Step
from lispac.workflow.planning.parallel_map import process_pool_mapper
from lispac.workflow.planning.plan_checks import simulate_surveys

MAX_SERIAL_PLANS = 600
"""Plans that are examined sooner than other processes are started."""


class CountingMapper:
    """Mapper that counts its results and reports their rate with the progress."""

    def __init__(self, mapper: Mapper, progress: Progress, rate: str) -> None:
        self._mapper, self._progress, self._rate = mapper, progress, rate
        self._count, self._began = 0, time.monotonic()

    def map(self, function: Callable[[Any], Any], values: Iterable[Any]) -> Iterator[Any]:
        """Apply a function to values and yield the results in order."""
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


def find_best_plan(
    site: Site, objective: PlanObjective, plans: int, start: Plan, progress: Progress
) -> DesignResult:
    """Search for the best plan of a site, on all cores if there are many plans."""
    workers = 1 if plans * len(objective.pos_factors) <= MAX_SERIAL_PLANS else os.cpu_count() or 1
    progress(0.0, gettext_lazy("Starting the search for the best survey plan"))
    with process_pool_mapper(workers) as mapper:
        rated = CountingMapper(mapper, progress, N_("{rate:x} survey plans evaluated/s"))
        return search(
            site, objective, plans=plans, start=start, mapper=rated.map, progress=rated.progress
        )


def compute_scenarios(plan: Plan, progress: Progress) -> tuple[ScenarioOutcome, ...]:
    """Outcomes of all scenarios, each of which changes one thing of the plan."""
    return predict_scenarios(plan, tuple(SCENARIOS), progress=progress)


def run_survey_simulation(
    plan: Plan, request: SimulationRequest, progress: Progress
) -> MonteCarloResult:
    """Simulate surveys of a plan on all cores; cancelling keeps the finished ones."""
    progress(0.0, gettext_lazy("Starting the simulated surveys"))
    with process_pool_mapper(os.cpu_count() or 1, at_once=1) as mapper:
        rated = CountingMapper(mapper, progress, N_("{rate:x.1} simulated surveys/s"))
        return simulate_surveys(
            plan, request.surveys, seed=request.seed, flatness_known=request.flatness_known,
            enough=MIN_SURVEYS, mapper=rated.map, progress=rated.progress,
        )  # fmt: skip
