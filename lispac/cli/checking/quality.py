"""``lispac quality``: differences between the lines of a survey, without calibration."""

from __future__ import annotations

import csv
import sys
from argparse import ArgumentParser, Namespace
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option, picture_file, positive_number
from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.messages import print_messages
from lispac.present.json_values import json_values
from lispac.untrusted_values import as_csv_cell

if TYPE_CHECKING:
    from lispac.workflow.checking.line_quality import DifferenceStatistics, LineQuality

COLUMN_TITLES = ("places", "median", "RMSD", "robust", "95 %", "largest")
"""Titles of the columns with numbers in the printed table."""
CSV_COLUMN_NAMES = (
    "first", "second", "north_m", "west_m", "up_m", "difference_m", "interval_95_m", "upward",
)  # fmt: skip
"""Titles of the columns of the CSV file."""


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    parser.add_argument(
        "--boresight", choices=("prior", "estimated"), default="prior",
        help="boresight used to georeference the lines (default prior: no calibration is needed)",
    )  # fmt: skip
    parser.add_argument(
        "--search-distance", type=positive_number, default=1.0, metavar="M",
        help="largest distance between lines to compare (m; default 1)",
    )  # fmt: skip
    parser.add_argument(
        "--map", type=picture_file, metavar="FILE",
        help="file for a plan view coloured by the distance between the lines: .png, .svg or .pdf",
    )  # fmt: skip
    parser.add_argument(
        "--csv",
        type=Path,
        metavar="FILE",
        help="CSV file for a table of all places with their differences",
    )
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print the differences between lines by orientation of the surface; draw and list them."""
    from lispac.progress import sub_progress
    from lispac.workflow.checking.line_quality import line_quality
    from lispac.workflow.project.projects import open_project
    from lispac.workflow.project.survey import load_survey

    with ConsoleProgress() as progress:
        project = open_project(arguments.project)
        survey = load_survey(project, progress=sub_progress(progress, 0.0, 0.3))
        found = line_quality(
            project, survey, which=arguments.boresight, search_distance=arguments.search_distance,
            progress=sub_progress(progress, 0.3, 1.0),
        )  # fmt: skip
    if arguments.map is not None:
        _draw_map(found, arguments.map)
    if arguments.csv is not None:
        _write_differences(found, arguments.csv)
    if arguments.json:
        print_json(
            {
                "boresight": found.which,
                "differences": [
                    {"first": one, "second": other, "facing": facing}
                    | _statistics_in_metres(figures)
                    for one, other, facing, figures in found.rows()
                ],
                "not_compared": json_values(found.not_compared),
            }
        )
        return
    _print_differences(found)
    sys.stdout.flush()
    print_messages(found.not_compared)


def _statistics_in_metres(figures: DifferenceStatistics) -> dict[str, float | None]:
    shared = {"places", "significant"}
    return {k if k in shared else f"{k}_m": v for k, v in asdict(figures).items()}


def _print_differences(result: LineQuality) -> None:
    rows = result.rows()
    width = max(10, *(len(name) for row in rows for name in row[:2])) + 2
    print(
        f"Differences between lines along the normal of flat places, {result.which} boresight, mm"
    )
    heads = "".join(f"{head:>9s}" for head in COLUMN_TITLES)
    print(f"{'first':{width}s}{'second':{width}s}{'facing':9s}{heads}")
    for one, other, facing, each in rows:
        sizes = (each.rmsd, each.robust_sigma, each.p95, each.largest)
        cells = _millimetre_cell(each.median, "+") + "".join(
            _millimetre_cell(size) for size in sizes
        )
        print(f"{one:{width}s}{other:{width}s}{facing:9s}{each.places:9d}{cells}")


def _millimetre_cell(value: float | None, sign: str = "") -> str:
    return f"{'-':>9s}" if value is None else f"{1000 * value:{sign}9.1f}"


def _draw_map(result: LineQuality, path: Path) -> None:
    from lispac.io.files import atomic_write
    from lispac.report.line_map import line_difference_map

    figure = line_difference_map(result.pairs)
    with atomic_write(path) as temporary:
        figure.savefig(temporary, format=path.suffix[1:].lower(), dpi=200)


def _write_differences(result: LineQuality, path: Path) -> None:
    import numpy as np

    from lispac.io.files import atomic_write

    with atomic_write(path) as temporary, temporary.open("w", encoding="utf-8") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(CSV_COLUMN_NAMES)
        for pair in result.pairs:
            table = np.column_stack(
                [pair.place, pair.distance, pair.half_width, np.abs(pair.normal[:, 2])]
            )
            for row in table:
                values = [f"{value:.4f}" for value in row]
                writer.writerow([as_csv_cell(pair.first), as_csv_cell(pair.second), *values])
