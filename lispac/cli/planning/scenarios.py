"""``lispac scenarios``: effect of single changes of the survey on the sigmas."""

from argparse import ArgumentParser, Namespace
from dataclasses import replace
from pathlib import Path

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, print_json, print_table

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
    """Print a table for each scenario with both stochastic models; write tables and plots."""
    from lispac.design.scenarios import SCENARIOS, predict_scenarios, thesis_setting
    from lispac.io.config.plan_file import read_plan
    from lispac.present.planning.design_results import SCENARIOS_TABLE, ScenarioValues
    from lispac.workflow.planning.plan_checks import write_scenarios

    plan = thesis_setting() if arguments.plan is None else read_plan(arguments.plan).plan
    with ConsoleProgress() as progress:
        found = predict_scenarios(plan, tuple(arguments.only or SCENARIOS), progress=progress)
    if arguments.output is not None:
        write_scenarios(arguments.output, found)
    values = [ScenarioValues.of(each) for each in found]
    if arguments.json:
        from lispac.cli.json_outputs import ScenariosOutput

        print_json(ScenariosOutput(tuple(values)))
        return
    for scenario in dict.fromkeys(each.scenario for each in values):
        print_table(
            replace(SCENARIOS_TABLE, title=scenario),
            sorted(
                (each for each in values if each.scenario == scenario), key=lambda v: v.pos_errors
            ),
        )
    if arguments.output is not None:
        print(arguments.output)
