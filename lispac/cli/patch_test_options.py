"""Options of ``lispac patchtest``."""

import argparse
from pathlib import Path

from lispac.cli.values import Commands, command, json_option, named_value, whole


def add(commands: "Commands[argparse.ArgumentParser]") -> None:
    """The command."""
    patchtest = command(
        commands,
        "patchtest",
        "find the boresight by laying lines onto each other about objects that they share",
    )
    patchtest.add_argument("project", type=Path, metavar="PROJECT")
    patchtest.add_argument(
        "--object", type=named_value, nargs="+", action="extend", metavar="NAME=N,W,U,A,L,H",
        help="boxes about objects (a pole, a pillar, an edge): centre in metres, local frame; "
        "lengths ahead, to the left and upwards; a seventh number turns the box clockwise, in deg",
    )  # fmt: skip
    patchtest.add_argument(
        "--count", type=whole(0), metavar="N",
        help="objects that are looked for besides (default 30; none where --object is given)",
    )  # fmt: skip
    patchtest.add_argument(
        "--pairs", choices=("reciprocal", "crossing", "oblique", "same"), nargs="+",
        help="kinds of pairs of lines (default all)",
    )  # fmt: skip
    patchtest.add_argument(
        "--lines", nargs="+", metavar="NAME", help="pairs of these lines only (default all)"
    )
    patchtest.add_argument(
        "--keep", action="store_true", help="keep the answer beside that of the targets"
    )
    json_option(patchtest)
