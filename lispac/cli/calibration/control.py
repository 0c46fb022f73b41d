"""``lispac control``: surveyed control as observations of the adjustment."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import (
    add_crs_options,
    add_json_option,
    non_negative_number,
    positive_number,
)
from lispac.cli.console import ConsoleProgress, UsageError, opened_project, print_json, print_table
from lispac.cli.messages import console_text, print_messages

if TYPE_CHECKING:
    from lispac.project import Project


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "file", type=Path, nargs="?", metavar="FILE",
        help="list of surveyed points to import: name, x, y, z (north, west, up in the local "
             "frame), and optionally sigma, or sigma_x, sigma_y and sigma_z, and the target in a "
             "column plane; or a static scan (LAS, LAZ, E57, PTS, text). A file of the same name "
             "is replaced; without FILE, the control is listed",
    )  # fmt: skip
    parser.add_argument(
        "--sigma", type=positive_number, default=0.005, metavar="M",
        help="1 sigma of each coordinate of points without a sigma of their own, or of the error "
             "common to all points of a scan (m; default 0.005)",
    )  # fmt: skip
    parser.add_argument(
        "--common-sigma", type=non_negative_number, metavar="M",
        help="1 sigma, on each axis, of a translation that all points of the file share, such as "
             "that of the fixed points (m; default 0; of a scan, as --sigma)",
    )  # fmt: skip
    for option, text in (
        ("--exclude", "exclude these points from the adjustment"),
        ("--use", "use these points again"),
    ):
        parser.add_argument(option, nargs="+", default=[], metavar="POINT", help=text)
    parser.add_argument(
        "--remove",
        nargs="+",
        default=[],
        metavar="FILE",
        help="remove the control of these files, by their names",
    )
    add_crs_options(parser, "as given in the file, otherwise local")
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Import, exclude or remove control, and print the control of the project.

    Raises
    ------
    UsageError
        If a point is to be both used and excluded.
    """
    from lispac.control_points import with_control_use, without_control_file
    from lispac.present.calibration.control import ControlValues
    from lispac.workflow.control.control_assignment import (
        is_assignment_current,
        with_assigned_control,
    )
    from lispac.workflow.control.control_import import import_control
    from lispac.workflow.project.projects import save_project
    from lispac.workflow.project.survey import load_survey

    if both := sorted({*arguments.use} & {*arguments.exclude}):
        raise UsageError(f"control: {both[0]} cannot be both used and excluded.")
    changes = arguments.remove or arguments.exclude or arguments.use or arguments.file
    with opened_project(arguments.project, change=bool(changes)) as project:
        for name in arguments.remove:
            project = project.with_control(without_control_file(project.control, name))
        if arguments.file is not None:
            with ConsoleProgress() as progress:
                survey = load_survey(project, progress=progress)
                project, notes = import_control(
                    project, survey, arguments.file, sigma=arguments.sigma,
                    common_sigma=arguments.common_sigma, crs=arguments.crs,
                    height=arguments.height, trajectory_datum=arguments.trajectory_datum,
                    epoch=arguments.epoch, progress=progress,
                )  # fmt: skip
            print_messages(notes)
        for names, used in ((arguments.use, True), (arguments.exclude, False)):
            if names:
                control = with_control_use(project.control, names, used=used)
                project = project.with_control(control)
        if not is_assignment_current(project):
            project = with_assigned_control(project, load_survey(project))
        if changes:
            save_project(project)
    if arguments.json:
        print_json(ControlValues.of(project))
    else:
        print_control(project)


def print_control(project: Project) -> None:
    """Print the control of a project, and the estimates with and without it."""
    from lispac.present.calibration.control import (
        CONTROL_COMPARISON_TABLE,
        CONTROL_TABLE,
        ControlValues,
    )

    values = ControlValues.of(project)
    if not values.points:
        print("The project has no control.")
        return
    print_table(CONTROL_TABLE, values.points)
    for point in values.points:
        if point.reason is not None:
            print(console_text(point.reason))
    if values.comparison:
        print_table(CONTROL_COMPARISON_TABLE, values.comparison)
