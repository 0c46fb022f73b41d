"""``lispac batch``: calibration of many projects, with a table of the results."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, UsageError, print_json, print_table
from lispac.cli.messages import console_text
from lispac.errors import ProjectError
from lispac.messages import error

if TYPE_CHECKING:
    from lispac.present.calibration.batch import BatchRow


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "folders",
        type=Path,
        nargs="+",
        metavar="FOLDER",
        help="folder to search for projects, including its subfolders",
    )
    parser.add_argument(
        "--output", type=Path, metavar="TABLE", help="CSV file for the table of results"
    )
    parser.add_argument(
        "--save", action="store_true",
        help="save the results in the projects (default: the projects are not changed)",
    )  # fmt: skip
    parser.add_argument(
        "--reports",
        type=Path,
        metavar="DIR",
        help="write the report of each project to this folder",
    )
    parser.add_argument(
        "--report-format",
        choices=("pdf", "html", "json", "zip"),
        help="format of the reports (default pdf)",
    )
    parser.add_argument(
        "--template",
        type=Path,
        metavar="FILE",
        help="template of the reports; see `lispac report --help`",
    )
    parser.add_argument(
        "--full", action="store_true", help="write full reports instead of short ones"
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Calibrate all projects, then print and write the table of results.

    Raises
    ------
    UsageError
        If options cannot be combined.
    ProjectError
        If a project could not be calibrated; the exit code is then 1.
    """
    from lispac.present.calibration.batch import BATCH_TABLE
    from lispac.workflow.output.batch import calibrate_each, write_table
    from lispac.workflow.output.report_options import report_options

    if arguments.reports is None and (
        arguments.report_format or arguments.template or arguments.full
    ):
        raise UsageError("batch: --report-format, --template and --full require --reports DIR.")
    options = report_options(arguments.template, extent="full" if arguments.full else "")
    rows: list[BatchRow] = []
    with ConsoleProgress() as progress:
        for row in calibrate_each(
            *arguments.folders, save=arguments.save, reports=arguments.reports,
            form=arguments.report_format or "pdf", options=options, progress=progress,
        ):  # fmt: skip
            rows.append(row)
            if arguments.output is not None:  # keeps finished rows after an interruption
                write_table(rows, arguments.output)
    if arguments.json:
        from lispac.cli.json_outputs import BatchOutput

        print_json(BatchOutput(tuple(rows)))
    else:
        print_table(BATCH_TABLE, rows)
        for row in rows:
            for message in row.messages:
                print(f"{row.name}: {console_text(message)}")
    sys.stdout.flush()
    refused = [row.name for row in rows if row.verdict == "refused"]
    if refused:
        raise ProjectError(
            error("cli.projects_failed", count=len(refused), total=len(rows), names=refused)
        )
