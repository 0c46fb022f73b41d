"""``lispac scenarios``: effect of single changes of the survey on the sigmas."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, print_json

if TYPE_CHECKING:
    from lispac.design.scenarios import ScenarioOutcome

FACTOR_NAMES = (
    "lines", "inclination", "size", "targets", "distance", "height", "repeats", "speed", "POS",
)  # fmt: skip
"""Names of `lispac.design.scenarios.SCENARIOS`."""


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "plan", type=Path, nargs="?", metavar="PLAN",
        help="survey plan to vary (default: one vertical board and six lines, as in Shahraji's "
             "thesis)",
    )  # fmt: skip
    parser.add_argument(
        "--only", nargs="+", choices=FACTOR_NAMES, metavar="SCENARIO",
        help=f"factors to change (default: all): {', '.join(FACTOR_NAMES)}",
    )  # fmt: skip
    parser.add_argument(
        "--output", type=Path, metavar="DIR", help="output folder for tables (CSV) and plots (SVG)"
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print a table for each scenario in both stochastic models; write tables and plots."""
    from lispac.adjustment.result import ANGLES
    from lispac.design.scenarios import SCENARIOS, predict_scenarios, thesis_setting
    from lispac.io.config.plan_file import read_plan
    from lispac.workflow.planning.plan_checks import write_scenarios

    plan = thesis_setting() if arguments.plan is None else read_plan(arguments.plan).plan
    with ConsoleProgress() as progress:
        found = predict_scenarios(plan, tuple(arguments.only or SCENARIOS), progress=progress)
    if arguments.output is not None:
        write_scenarios(arguments.output, found)
    if arguments.json:
        print_json({"outcomes": [_outcome_values(each) for each in found]})
        return
    heads = "".join(f"{angle:>9s}" for angle in ANGLES)
    for scenario in dict.fromkeys(each.scenario for each in found):
        print(
            f"{scenario:30s}{'correlated POS errors':>27s}{'uncorrelated POS errors':>27s}"
            "  1 sigma, deg"
        )
        print(f"{'':30s}{heads}{heads}")
        own = [each for each in found if each.scenario == scenario]
        for case in dict.fromkeys(each.case for each in own):
            by = {each.pos_errors: each for each in own if each.case == case}
            print(f"{case:30s}{_sigma_cells(by['correlated'])}{_sigma_cells(by['independent'])}")
        print()
    if arguments.output is not None:
        print(arguments.output)


def _sigma_cells(each: ScenarioOutcome) -> str:
    import numpy as np

    if not np.isfinite(each.sigma).all():
        return "not determined".rjust(27)
    return "".join(f"{value:9.4f}" for value in np.degrees(each.sigma))


def _outcome_values(each: ScenarioOutcome) -> dict[str, object]:
    import numpy as np

    known = bool(np.isfinite(each.sigma).all())
    return {
        "scenario": each.scenario,
        "case": each.case,
        "pos_errors": each.pos_errors,
        "sigma_deg": np.degrees(each.sigma).tolist() if known else None,
        "points": round(each.points),
    }
