"""Comparison of predicted sigmas with the errors of many simulated surveys.

    python -m tests.studies.prediction_study [SURVEYS]

Every survey has all points that the scanner would measure, boards with form errors, LiDAR noise and
drifting POS errors, on a rolling vessel, and is adjusted like any other. `lispac campaign` does the
same with any plan.
"""

import sys

from lispac.design.monte_carlo import MonteCarloResult, run_monte_carlo
from lispac.design.plan import Plan, line_pattern
from lispac.present.planning.design_results import SimulationValues
from lispac.simulation.closed_form_survey import Board
from lispac.workflow.planning.process_pool import process_pool_mapper

BOARDS = (
    Board("T1", (0.8, -15.0, 5.0), (0.0, 1.0, 0.0)),
    Board("T2", (-0.8, -15.0, 5.0), (0.0, 1.0, 1.0)),
)
PLAN = Plan(BOARDS, line_pattern(), (0.0, -15.0, 5.0))


def compared(
    plan: Plan, surveys: int, *, flatness_known: bool, workers: int = 2
) -> MonteCarloResult:
    """Simulate surveys of a plan; with ``flatness_known`` the flatness of the boards is given."""
    with process_pool_mapper(workers) as mapper:
        return run_monte_carlo(plan, surveys, flatness_known=flatness_known, mapper=mapper)


if __name__ == "__main__":
    number = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
    for flatness_known in (True, False):
        print("flatness stated" if flatness_known else "flatness from the data")
        print(SimulationValues.of(compared(PLAN, number, flatness_known=flatness_known)))
