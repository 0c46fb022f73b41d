"""``lispac history``: the calibrations of each system over the years."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option, picture_file
from lispac.cli.console import ConsoleProgress, print_json, print_table
from lispac.cli.messages import console_text, print_messages

if TYPE_CHECKING:
    from lispac.workflow.checking.calibration_history import CalibrationHistory


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "folders",
        type=Path,
        nargs="+",
        metavar="FOLDER",
        help="folder to search for projects, including its subfolders",
    )
    parser.add_argument("--vessel", metavar="NAME", help="show only the systems of this vessel")
    parser.add_argument(
        "--picture", type=picture_file, metavar="FILE",
        help="file for the control chart of the system with most calibrations: .png, .svg or .pdf",
    )  # fmt: skip
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print a table for each system and, on request, draw the control chart of the first system."""
    from lispac.workflow.checking.calibration_history import read_histories

    with ConsoleProgress() as progress:
        found, messages = read_histories(
            arguments.folders, vessel=arguments.vessel, progress=progress
        )
    if arguments.picture is not None:
        _draw_chart(arguments, found[0])
    if arguments.json:
        from lispac.cli.json_outputs import HistoryOutput

        print_json(HistoryOutput(tuple(found), tuple(messages)))
        return
    for each in found:
        _print_history(each)
    sys.stdout.flush()
    print_messages([*messages, *(message for each in found for message in each.messages)])


def _print_history(history: CalibrationHistory) -> None:
    from lispac.present.calibration.calibrations import CHANGES_TABLE, DATED_CALIBRATIONS_TABLE

    print(f"{history.system.full_name}\n")
    for table in (DATED_CALIBRATIONS_TABLE, CHANGES_TABLE):
        print_table(table, history.calibrations)
    for each in history.calibrations:
        print(console_text(each.message))
    print()


def _draw_chart(arguments: Namespace, history: CalibrationHistory) -> None:
    from lispac.io.files import atomic_write
    from lispac.report.control_charts import control_chart_figure

    figure = control_chart_figure(history.calibrations)
    with atomic_write(arguments.picture) as temporary:
        figure.savefig(temporary, format=arguments.picture.suffix[1:].lower(), dpi=200)
