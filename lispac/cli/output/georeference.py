"""``lispac georeference``: georeferenced point clouds of the lines."""

from argparse import ArgumentParser, Namespace
from pathlib import Path

from lispac.cli.argument_types import add_crs_options, add_json_option
from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.messages import print_messages


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument("--output", type=Path, required=True, metavar="DIR", help="output folder")
    parser.add_argument(
        "--boresight",
        choices=("prior", "estimated"),
        default="estimated",
        help="boresight to use (default estimated)",
    )
    parser.add_argument(
        "--trajectory",
        choices=("given", "corrected"),
        default="given",
        help="trajectory to use: given (default), or corrected by the adjustment",
    )
    add_crs_options(parser, "that of the lines if they are georeferenced")
    parser.add_argument(
        "--lines", nargs="+", metavar="NAME", help="use only these lines (default: all)"
    )
    parser.add_argument(
        "--format", choices=("laz", "las"), default="laz", help="file format (default laz)"
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Write the lines as LAS or LAZ with all their attributes."""
    from lispac.workflow.output.georeferencing import georeference_project
    from lispac.workflow.project.projects import open_project

    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        written = georeference_project(
            project,
            arguments.output,
            arguments.boresight,
            system=arguments.crs,
            height=arguments.height,
            trajectory_datum=arguments.trajectory_datum,
            epoch=arguments.epoch,
            lines=arguments.lines or (),
            ending=arguments.format,
            trajectory_choice=arguments.trajectory,
            progress=progress,
        )
    found = dict.fromkeys(each for done in written for each in done.notes)
    print_messages(found)
    if arguments.json:
        from lispac.cli.json_outputs import GeoreferencedLineOutput, GeoreferenceOutput

        lines = tuple(
            GeoreferencedLineOutput(done.path, done.points, done.outside, done.in_gaps)
            for done in written
        )
        print_json(GeoreferenceOutput(lines, tuple(found)))
        return
    from lispac.present.tables import COUNT

    for done in written:
        print(f"{done.path}  {COUNT.text(done.points)} points")
