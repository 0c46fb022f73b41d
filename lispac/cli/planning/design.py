"""``lispac design``: the best boards and lines for a site."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_json_option, positive_number, whole_number_from
from lispac.cli.console import ConsoleProgress, print_json, print_table
from lispac.cli.messages import console_text
from lispac.cli.planning.worker_options import add_worker_options, cluster_access

CRITERION_NAMES = ("largest", "roll", "pitch", "yaw", "A", "D")
"""Names of `lispac.design.objective.CRITERION_TEXTS`."""


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "site", metavar="SITE",
        help="TOML file with the limits of the site, or the name of a built-in site: quay, "
             "quay-and-tower",
    )  # fmt: skip
    parser.add_argument(
        "--for", dest="criterion", choices=CRITERION_NAMES, default="largest",
        help="criterion to minimise: the largest sigma (default), the sigma of one angle, or the "
             "root mean square of the sigmas (A) or the mean radius of their confidence ellipsoid "
             "(D)",
    )  # fmt: skip
    parser.add_argument(
        "--plans", type=whole_number_from(1), default=10_000, metavar="N",
        help="approximate number of survey plans to evaluate (default 10000)",
    )  # fmt: skip
    parser.add_argument(
        "--pos-factors", type=positive_number, nargs="+", default=[1.0], metavar="F",
        help="factors on the POS sigmas; the criterion is averaged over them (default 1)",
    )  # fmt: skip
    parser.add_argument(
        "--seed", type=int, default=2019, help="seed of the random search (default 2019)"
    )
    add_worker_options(parser)
    parser.add_argument(
        "--output", type=Path, metavar="DIR",
        help="output folder for plan.toml, the field plan (PDF) and the sigmas of shorter surveys",
    )  # fmt: skip
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print the best plan, the sigma without each of its parts, and the sigmas of shorter plans."""
    from lispac.design.objective import CRITERION_TEXTS, PlanObjective
    from lispac.design.plan_choices import thesis_plan
    from lispac.design.plan_search import search
    from lispac.design.prediction import predict
    from lispac.io.config.plan_file import read_site
    from lispac.present.planning import design_results
    from lispac.present.planning.survey_plan import PLANNED_LINES_TABLE, PLANNED_TARGETS_TABLE
    from lispac.present.tables import COUNT
    from lispac.workflow.planning.parallel_map import choose_mapper
    from lispac.workflow.planning.plan_checks import observability_messages, write_design
    from lispac.workflow.planning.simulated_setup import setup_file

    title, site = read_site(setup_file("site", arguments.site, None))
    objective = PlanObjective(arguments.criterion, tuple(arguments.pos_factors))
    with (
        ConsoleProgress() as progress,
        choose_mapper(arguments.workers, cluster_access(arguments)) as mapper,
    ):
        found = search(
            site, objective, plans=arguments.plans, seed=arguments.seed, mapper=mapper,
            progress=progress,
        )  # fmt: skip
    if arguments.output is not None:
        write_design(arguments.output, title, site, found, objective)
    thesis = predict(thesis_plan(site))
    values = design_results.DesignValues.of(found, site.wall, thesis)
    if arguments.json:
        from lispac.cli.json_outputs import DesignOutput, extended

        print_json(extended(DesignOutput, values, title=title))
        return
    print(f"{title}: smallest {CRITERION_TEXTS[objective.criterion]}")
    print_table(
        design_results.PREDICTED_SIGMAS_TABLE,
        design_results.predicted_sigma_rows(
            *map(design_results.PredictionValues.of, (found.prediction, thesis))
        ),
    )
    print_table(PLANNED_TARGETS_TABLE, values.targets)
    print_table(PLANNED_LINES_TABLE, values.lines)
    print_table(
        design_results.with_objective(design_results.GAINS_TABLE, objective.criterion),
        design_results.gain_rows(found.gains, values.sigma_deg),
    )
    print_table(
        design_results.with_objective(design_results.SHORTER_PLANS_TABLE, objective.criterion),
        values.pareto_front,
    )
    plans = f"{COUNT.text(found.evaluated)} survey plans evaluated"
    print(f"{plans}, all that are possible" if found.exact else f"{plans}, out of many more")
    for message in observability_messages(found.plan):
        print(console_text(message))
    if arguments.output is not None:
        print(arguments.output)
