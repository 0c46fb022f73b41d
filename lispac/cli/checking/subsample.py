"""``lispac subsample``: boresight angles for several point spacings."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_json_option, finite_number
from lispac.cli.console import ConsoleProgress, print_json, print_table


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--distances", type=finite_number, nargs="+", metavar="M",
        help="point spacings to use (m; 0 uses all points; default 0 0.05 0.1 0.15 0.2)",
    )  # fmt: skip
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print one row for each point spacing."""
    from lispac.present.calibration.subsampling import SUBSAMPLING_TABLE
    from lispac.workflow.checking.subsampling import DEFAULT_DISTANCES, subsampling_study
    from lispac.workflow.project.projects import open_project
    from lispac.workflow.project.survey import load_survey

    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        survey = load_survey(project, progress=progress)
        distances = arguments.distances or DEFAULT_DISTANCES
        found = subsampling_study(project, survey, distances, progress=progress)
    if arguments.json:
        from lispac.cli.json_outputs import SubsampleOutput

        print_json(SubsampleOutput(tuple(found)))
    else:
        print_table(SUBSAMPLING_TABLE, found)
