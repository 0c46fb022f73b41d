"""Options of ``lispac quality``."""

import argparse
from pathlib import Path

from lispac.cli.values import Commands, command, json_option, picture_file, positive


def add(commands: "Commands[argparse.ArgumentParser]") -> None:
    """The command."""
    quality = command(
        commands, "quality", "say how well the lines of a survey fit each other, as they are"
    )
    quality.add_argument("project", type=Path, metavar="PROJECT")
    quality.add_argument(
        "--with", dest="which", choices=("prior", "estimated"), default="prior",
        help="boresight that places the lines (default prior: nothing need be calibrated)",
    )  # fmt: skip
    quality.add_argument(
        "--reach", type=positive, default=1.0, metavar="M",
        help="the farthest that lines may be apart (default 1)",
    )  # fmt: skip
    quality.add_argument(
        "--map", type=picture_file, metavar="FILE",
        help="all places from above, coloured by how far the lines are apart: .png, .svg or .pdf",
    )  # fmt: skip
    quality.add_argument(
        "--csv", type=Path, metavar="FILE", help="every place with its difference, as a table"
    )
    json_option(quality)
