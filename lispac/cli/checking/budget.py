"""``lispac budget``: effect of every source of error on a point at a distance."""

import math
from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_json_option, number_within, positive_number
from lispac.cli.console import ConsoleProgress, print_json, print_table
from lispac.cli.messages import console_text
from lispac.cli.noise_options import add_divergence_option, add_lever_arm_sigma_option


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--distance", type=positive_number, nargs="+", metavar="M",
        help="distances of the point from the scanner (m; default 10 50 100)",
    )  # fmt: skip
    saved = "as saved in the project, or not included"
    add_lever_arm_sigma_option(parser, saved)
    add_divergence_option(parser, saved)
    parser.add_argument(
        "--incidence", type=number_within(0.0, 85.0), default=45.0, metavar="DEG",
        help="angle between the beam and the normal of the surface, for the beam footprint (deg; "
        "default 45)",
    )  # fmt: skip
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print a table for each direction of the beam."""
    from lispac.adjustment.diagnostics.error_budget import DEFAULT_DISTANCES
    from lispac.present.calibration.error_budget import ErrorBudgetValues, budget_table
    from lispac.workflow.checking.budget import error_budget_of
    from lispac.workflow.project.projects import open_project
    from lispac.workflow.project.survey import load_survey

    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
    divergence = arguments.beam_divergence
    found = ErrorBudgetValues.of(
        error_budget_of(
            project,
            survey,
            arguments.distance or DEFAULT_DISTANCES,
            lever_sigma=arguments.lever_arm_sigma,
            divergence=None if divergence is None else divergence / 1000,
            incidence=math.radians(arguments.incidence),
        )
    )
    if arguments.json:
        print_json(found)
        return
    for beam in found.beams:
        print_table(*budget_table(found, beam))
    for assumption in found.messages:
        print(console_text(assumption))
