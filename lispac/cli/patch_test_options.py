"""Options of ``lispac patchtest``."""

import argparse
from pathlib import Path

from lispac.cli.argument_types import (
    Commands,
    add_command,
    add_json_option,
    split_named_value,
    whole_number_from,
)


def add_patchtest_command(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Add the command ``patchtest``."""
    patchtest = add_command(
        commands,
        "patchtest",
        "estimate the boresight by aligning lines on common objects (patch test)",
    )
    patchtest.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    patchtest.add_argument(
        "--object", type=split_named_value, nargs="+", action="extend", metavar="NAME=N,W,U,A,L,H",
        help="box around an object (a pole, a pillar, an edge): north, west and up of its centre "
             "in the local frame (N, W, U), then its size northwards, westwards and upwards (A, L, "
             "H; m); an optional seventh number rotates the box clockwise (deg)",
    )  # fmt: skip
    patchtest.add_argument(
        "--count", type=whole_number_from(0), metavar="N",
        help="number of objects to detect automatically (default 30; 0 if --object is given)",
    )  # fmt: skip
    patchtest.add_argument(
        "--pairs", choices=("reciprocal", "crossing", "oblique", "same"), nargs="+",
        help="pairs of lines to use: in opposite directions (reciprocal), about at right angles "
             "(crossing), at other angles (oblique) or in the same direction (default: all)",
    )  # fmt: skip
    patchtest.add_argument(
        "--lines", nargs="+", metavar="NAME", help="use only pairs of these lines (default: all)"
    )
    patchtest.add_argument(
        "--save",
        action="store_true",
        help="save the result in the project, beside that of the targets",
    )
    add_json_option(patchtest)
