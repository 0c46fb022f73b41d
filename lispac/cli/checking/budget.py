"""``lispac budget``: effect of every source of error on a point at a distance."""

from argparse import ArgumentParser, Namespace
from dataclasses import asdict
from pathlib import Path

from lispac.cli.argument_types import add_json_option, add_triple_option, positive_number
from lispac.cli.console import ConsoleProgress, print_json
from lispac.message_texts import message_text


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--distance", type=positive_number, nargs="+", metavar="M",
        help="distances of the point from the scanner (m; default 10 50 100)",
    )  # fmt: skip
    add_triple_option(
        parser,
        "--lever-arm-sigma",
        ("X", "Y", "Z"),
        "1 sigma of the lever arm (m; default: not included)",
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print a table for each direction of the beam."""
    from lispac.adjustment.error_budget import DISTANCES
    from lispac.report.budget_values import ErrorBudgetValues
    from lispac.report.json_report import english_values
    from lispac.workflow.checking.budget import error_budget_of
    from lispac.workflow.project.projects import open_project
    from lispac.workflow.project.survey import load_survey

    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
    found = ErrorBudgetValues.of(
        error_budget_of(
            project, survey, arguments.distance or DISTANCES, lever_sigma=arguments.lever_arm_sigma
        )
    )
    if arguments.json:
        print_json(asdict(english_values(found)))
        return
    heads = "".join(f"{f'at {distance:g} m':>30s}" for distance in found.distances_m)
    columns = "".join(f"{name:>10s}" for name in ("horiz.", "vertical", "across"))
    for beam in found.beams:
        print(f"{f'beam {beam.beam}':28s}{heads}")
        print(f"{'1 sigma, cm':28s}{columns * len(found.distances_m)}")
        for each in (*beam.sources, beam.before, beam.after):
            cells = "not known".rjust(30)
            if each.at_distance is not None:
                cells = "".join(
                    f"{100 * e.horizontal_m:10.2f}{100 * e.vertical_m:10.2f}"
                    f"{100 * e.across_beam_m:10.2f}"
                    for e in each.at_distance
                )
            print(f"{each.source!s:28s}{cells}")
        print()
    for assumption in found.messages:
        print(message_text(assumption))
