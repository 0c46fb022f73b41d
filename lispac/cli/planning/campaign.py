"""``lispac campaign``: many simulated surveys of a plan, to check its predicted sigmas."""

from argparse import ArgumentParser, Namespace
from dataclasses import replace
from pathlib import Path

from lispac.cli.argument_types import add_json_option, whole_number_from
from lispac.cli.console import ConsoleProgress, print_json, print_table
from lispac.cli.planning.worker_options import add_worker_options, cluster_access


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "plan", type=Path, metavar="PLAN", help="survey plan: TOML file with targets and lines"
    )
    parser.add_argument(
        "--surveys", type=whole_number_from(2), default=200, metavar="N",
        help="number of surveys to simulate and adjust (default 200)",
    )  # fmt: skip
    parser.add_argument(
        "--seed",
        type=whole_number_from(0),
        default=2027,
        help="seed of the random numbers (default 2027)",
    )
    parser.add_argument(
        "--flatness-known", action="store_true",
        help="give the form error of the targets to the adjustment (default: estimated from the "
             "data, as lispac estimate does)",
    )  # fmt: skip
    add_worker_options(parser)
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print the scatter of the simulated results, and the formal and predicted sigmas."""
    from lispac.io.config.plan_file import read_plan
    from lispac.present.planning.design_results import ANGLES_BY_ROW_TABLE, SimulationValues
    from lispac.workflow.planning.parallel_map import choose_mapper
    from lispac.workflow.planning.plan_checks import result_heading, simulate_surveys

    titled = read_plan(arguments.plan)
    with (
        ConsoleProgress() as progress,
        choose_mapper(arguments.workers, cluster_access(arguments)) as mapper,
    ):
        found = simulate_surveys(
            titled.plan, arguments.surveys, seed=arguments.seed,
            flatness_known=arguments.flatness_known, mapper=mapper, progress=progress,
        )  # fmt: skip
    values = SimulationValues.of(found)
    if arguments.json:
        from lispac.cli.json_outputs import CampaignOutput, extended

        print_json(
            extended(
                CampaignOutput, values, title=titled.title, surveys=arguments.surveys,
                seed=arguments.seed,
            )
        )  # fmt: skip
        return
    heading = result_heading(titled.title, found, arguments.surveys)
    print_table(replace(ANGLES_BY_ROW_TABLE, title=heading), values.rows)
    for sentence in values.summary_texts:
        print(sentence)
