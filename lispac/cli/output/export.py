"""``lispac export``: targets and the trajectory for other programs."""

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import Any

from lispac.cli.argument_types import add_crs_options, add_json_option
from lispac.cli.console import ConsoleProgress, UsageError, print_json
from lispac.cli.messages import print_messages

EXPORT_FORMATS = {
    "targets": ("laz", "las", "csv"),
    "trajectory": ("sbet", "text"),
    "planes": ("text",),
}
"""Formats of each kind of export, the default first."""


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--what",
        choices=("targets", "planes", "trajectory"),
        required=True,
        help="data to export: points of the targets, plane files, or the trajectory",
    )
    parser.add_argument(
        "--output",
        type=Path,
        required=True,
        metavar="PATH",
        help="output folder; for the trajectory the output file",
    )
    parser.add_argument(
        "--format", choices=("laz", "las", "csv", "sbet", "text"),
        help="targets: laz (default), las or csv; trajectory: sbet (default) or text; planes are "
             "always text with 25 columns",
    )  # fmt: skip
    parser.add_argument(
        "--boresight",
        choices=("prior", "estimated"),
        default="estimated",
        help="boresight to use (default estimated)",
    )
    parser.add_argument(
        "--targets", nargs="+", metavar="NAME", help="export only these targets (default: all)"
    )
    add_crs_options(parser, "local")
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Write the requested data and print the names of the files.

    Raises
    ------
    UsageError
        If options cannot be combined.
    """
    from lispac.workflow.output.data_export import (
        SBET_ZEROS_NOTE,
        export_planes,
        export_targets,
        export_trajectory,
        trajectory_datum_note,
    )
    from lispac.workflow.project.output_crs import LOCAL_FRAME, output_system_of
    from lispac.workflow.project.projects import open_project
    from lispac.workflow.project.survey import load_survey

    what: str = arguments.what
    form: Any = arguments.format or EXPORT_FORMATS[what][0]
    if form not in EXPORT_FORMATS[what]:
        raise UsageError(f"export {what}: --format is one of {', '.join(EXPORT_FORMATS[what])}")
    on_map = (arguments.crs, arguments.height, arguments.trajectory_datum, arguments.epoch)
    if what != "targets" and any(value not in ("", None) for value in on_map):
        raise UsageError(
            f"export {what}: a coordinate system cannot be selected; "
            + ("the angles of plane files refer to the local frame" if what == "planes" else
               "the trajectory is written in latitude, longitude and height")
        )  # fmt: skip
    if what == "trajectory" and arguments.targets:
        raise UsageError("export trajectory: --targets applies to targets only; omit it")
    project = open_project(arguments.project)
    with ConsoleProgress() as progress:
        if what == "trajectory":
            paths = [export_trajectory(project, arguments.output, form)]
            notes = [trajectory_datum_note(project)]
            print_messages([*notes, SBET_ZEROS_NOTE] if form == "sbet" else notes)
        else:
            survey = load_survey(project, progress=progress)
            names = arguments.targets or ()
            if what == "planes":
                paths = export_planes(
                    project, survey, arguments.output, arguments.boresight, names=names,
                    progress=progress,
                )  # fmt: skip
            else:
                system = output_system_of(
                    project, survey.trajectory, arguments.crs or LOCAL_FRAME, arguments.height,
                    arguments.trajectory_datum, arguments.epoch,
                )  # fmt: skip
                paths = export_targets(
                    project, survey, arguments.output, arguments.boresight, system=system,
                    ending=form, names=names, progress=progress,
                )  # fmt: skip
                print_messages(() if system is None else system.assumptions)
    if arguments.json:
        from lispac.cli.json_outputs import ExportOutput

        print_json(ExportOutput(tuple(paths)))
        return
    for path in paths:
        print(path)
