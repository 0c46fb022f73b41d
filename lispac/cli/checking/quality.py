"""``lispac quality``: differences between the lines of a survey, without calibration."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from lispac.cli.argument_types import add_json_option, picture_file, positive_number
from lispac.cli.console import ConsoleProgress, print_json, print_table
from lispac.cli.messages import print_messages

if TYPE_CHECKING:
    from lispac.workflow.checking.line_quality import LineQuality


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
    from lispac.present.checking.line_differences import LINE_DIFFERENCES_TABLE
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
        from lispac.cli.json_outputs import QualityOutput

        print_json(QualityOutput(found.which, tuple(found.rows()), found.not_compared))
        return
    title = f"{LINE_DIFFERENCES_TABLE.title}, {found.which} boresight"
    print_table(replace(LINE_DIFFERENCES_TABLE, title=title), found.rows())
    sys.stdout.flush()
    print_messages(found.not_compared)


def _draw_map(result: LineQuality, path: Path) -> None:
    from lispac.io.files import atomic_write
    from lispac.report.line_map import line_difference_map

    figure = line_difference_map(result.pairs)
    with atomic_write(path) as temporary:
        figure.savefig(temporary, format=path.suffix[1:].lower(), dpi=200)


def _write_differences(result: LineQuality, path: Path) -> None:
    from lispac.io.files import atomic_write
    from lispac.present.checking.line_differences import PLACES_CSV, place_rows
    from lispac.present.csv_text import keyed_csv_text

    rows = [row for pair in result.pairs for row in place_rows(pair)]
    with atomic_write(path) as temporary:
        temporary.write_text(keyed_csv_text(PLACES_CSV, rows), encoding="utf-8", newline="")
