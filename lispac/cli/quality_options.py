"""Options of ``lispac quality``."""

import argparse
from pathlib import Path

from lispac.cli.argument_types import (
    Commands,
    add_command,
    add_json_option,
    picture_file,
    positive_number,
)


def add_quality_command(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Add the command ``quality``."""
    quality = add_command(
        commands, "quality", "compare the lines of a survey with each other, without a calibration"
    )
    quality.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    quality.add_argument(
        "--boresight", choices=("prior", "estimated"), default="prior",
        help="boresight used to georeference the lines (default prior: no calibration is needed)",
    )  # fmt: skip
    quality.add_argument(
        "--search-distance", type=positive_number, default=1.0, metavar="M",
        help="largest distance between lines to compare (m; default 1)",
    )  # fmt: skip
    quality.add_argument(
        "--map", type=picture_file, metavar="FILE",
        help="file for a plan view coloured by the distance between the lines: .png, .svg or .pdf",
    )  # fmt: skip
    quality.add_argument(
        "--csv",
        type=Path,
        metavar="FILE",
        help="CSV file for a table of all places with their differences",
    )
    add_json_option(quality)
