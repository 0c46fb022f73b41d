"""``lispac predict``: predicted standard deviations of a survey plan."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import print_json, print_table
from lispac.cli.messages import console_text


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "plan", type=Path, metavar="PLAN", help="survey plan: TOML file with targets and lines"
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print sigmas, correlations, weaknesses, and the information gain of targets and lines."""
    from lispac.design.objective import PlanObjective
    from lispac.design.plan_search import information_gains
    from lispac.design.prediction import predict as predicted
    from lispac.io.config.plan_file import read_plan
    from lispac.present.planning import design_results
    from lispac.workflow.planning.plan_checks import observability_messages, plan_warnings

    titled = read_plan(arguments.plan)
    plan = titled.plan
    values = design_results.PredictionValues.of(predicted(plan))
    gains = design_results.gain_rows(information_gains(plan, PlanObjective()), values.sigma_deg)
    messages = (*plan_warnings(titled), *observability_messages(plan))
    if arguments.json:
        from lispac.cli.json_outputs import PredictOutput, extended

        without = {row.name: row.without_deg for row in gains}
        print_json(
            extended(
                PredictOutput, values, title=titled.title, largest_sigma_without_deg=without,
                messages=messages,
            )
        )  # fmt: skip
        return
    print(titled.title)
    if values.determined:
        print_table(
            design_results.PREDICTED_SIGMAS_TABLE, design_results.predicted_sigma_rows(values)
        )
        print_table(design_results.PREDICTED_CORRELATIONS_TABLE, [values])
    print_table(*design_results.points_table(plan, values))
    print_table(design_results.GAINS_TABLE, gains)
    for message in messages:
        print(console_text(message))
