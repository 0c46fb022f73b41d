"""``lispac batch``: calibration of many projects, with a table of the results."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from collections.abc import Sequence
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lispac.cli.argument_types import add_json_option
from lispac.cli.console import ConsoleProgress, UsageError, print_json
from lispac.errors import ProjectError
from lispac.messages import error

if TYPE_CHECKING:
    from lispac.workflow.checking.batch import BatchRow


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
    from lispac.workflow.checking.batch import calibrate_each, write_table
    from lispac.workflow.output.report_options import report_options

    if arguments.reports is None and (arguments.report_format or arguments.template):
        raise UsageError("batch: --report-format and --template require --reports DIR.")
    options = report_options(arguments.template)
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
        print_json({"projects": [_row_values(row) for row in rows]})
    else:
        _print_table(rows)
    sys.stdout.flush()
    refused = [row.name for row in rows if row.verdict == "refused"]
    if refused:
        raise ProjectError(
            error("cli.projects_failed", count=len(refused), total=len(rows), names=refused)
        )


def _row_values(row: BatchRow) -> dict[str, Any]:
    return asdict(row) | {"folder": str(row.folder), "messages": list(row.messages)}


def _print_table(rows: Sequence[BatchRow]) -> None:
    from lispac.adjustment.result import ANGLES

    width = max(12, *(len(row.name) for row in rows)) + 2
    angles = "".join(f"{f'{angle}, 1 sigma':>19s}" for angle in ANGLES)
    print(f"{'project':{width}s}{angles} deg{'sigma 0':>9s}{'before':>9s}{'after':>8s} mm  verdict")
    for row in rows:
        cells = " " * 19 * 3
        if row.boresight_deg is not None and row.sigma_deg is not None:
            cells = "".join(
                f"{angle:+11.4f} {sigma:7.4f}"
                for angle, sigma in zip(row.boresight_deg, row.sigma_deg, strict=True)
            )
        rms_mm = [None if v is None else 1000 * v for v in (row.rms_before, row.rms_after)]
        print(
            f"{row.name:{width}s}{cells}    {_number_cell(row.sigma_0, 9, 2)}"
            f"{_number_cell(rms_mm[0], 9, 1)}{_number_cell(rms_mm[1], 8, 1)}     {row.verdict}"
        )
    for row in rows:
        for message in row.messages:
            print(f"{row.name}: {message}")


def _number_cell(value: float | None, width: int, decimals: int) -> str:
    return f"{'-':>{width}s}" if value is None else f"{value:{width}.{decimals}f}"
