"""``lispac check``: distances of the lines from a reference."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import (
    add_crs_options,
    add_json_option,
    non_negative_number,
    positive_number,
)
from lispac.cli.console import ConsoleProgress, opened_project, print_json, print_table
from lispac.cli.messages import console_text, print_messages


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--reference", type=Path, required=True, metavar="FILE",
        help="static scan (LAS, LAZ, E57, PTS, text), or a list of check points: name, x, y, z "
             "(north, west, up in the local frame), and optionally sigma and the name of the plane "
             "that contains them",
    )  # fmt: skip
    parser.add_argument(
        "--reference-sigma", type=non_negative_number, default=0.005, metavar="M",
        help="1 sigma of the reference (m): error common to all points of a scan, or sigma of "
             "each check point without a sigma of its own (default 0.005)",
    )  # fmt: skip
    parser.add_argument(
        "--search-distance", type=positive_number, default=1.0, metavar="M",
        help="largest distance between lines and reference (m; default 1)",
    )  # fmt: skip
    add_crs_options(parser, "as given in the reference file, otherwise local")
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Compare the lines with a reference, save the result and print it."""
    from lispac.present.checking.absolute import (
        REFERENCE_DISTANCES_TABLE,
        SURVEYED_POINTS_TABLE,
        AbsoluteCheckValues,
        line_states,
    )
    from lispac.workflow.checking.absolute_check import check_absolute
    from lispac.workflow.project.projects import save_project
    from lispac.workflow.project.survey import load_survey

    with opened_project(arguments.project, change=True) as project:
        with ConsoleProgress() as progress:
            survey = load_survey(project, progress=progress)
            project, notes = check_absolute(
                project, survey, arguments.reference, crs=arguments.crs, height=arguments.height,
                trajectory_datum=arguments.trajectory_datum, epoch=arguments.epoch,
                sigma=arguments.reference_sigma, search_distance=arguments.search_distance,
                progress=progress,
            )  # fmt: skip
        save_project(project)
    assert project.absolute is not None
    found = AbsoluteCheckValues.of(project.absolute)
    print_messages(notes)
    if arguments.json:
        print_json(found)
        return
    print_table(REFERENCE_DISTANCES_TABLE, line_states(found))
    if found.points:
        print_table(SURVEYED_POINTS_TABLE, found.points)
    for message in found.messages:
        print(console_text(message))
    for reason in found.not_compared:
        print(f"not compared: {console_text(reason)}")
