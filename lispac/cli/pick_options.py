"""Options of the command that picks targets."""

import argparse
from pathlib import Path

from lispac.cli.values import (
    Commands,
    command,
    finite,
    json_option,
    positive,
    system_options,
    triple,
    whole,
    within,
)
from lispac.targets.settings import RADII, THRESHOLDS


def add(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Describe ``lispac pick``."""
    pick = command(commands, "pick", "find the plane or sphere at a seed, in every line")
    pick.add_argument("project", type=Path, metavar="PROJECT")
    seeds = pick.add_mutually_exclusive_group(required=True)
    seeds.add_argument(
        "--seed", type=finite, nargs=3, metavar=("X", "Y", "Z"),
        help="coordinates: north, west, up (m); with --crs easting or longitude, northing or "
        "latitude, height",
    )  # fmt: skip
    seeds.add_argument(
        "--seeds", type=Path, metavar="FILE",
        help="list of coordinates: text with name, x, y, z and perhaps the role in each row, or "
        "with a row of names above",
    )  # fmt: skip
    pick.add_argument("--name", help="with --seed: name of the target, e.g. T1")
    pick.add_argument(
        "--columns", metavar="NAMES",
        help="with --seeds: its columns from the left, e.g. name,y,x,z,-",
    )  # fmt: skip
    pick.add_argument(
        "--replace", action="store_true",
        help="with --seeds: targets of the same names are picked anew",
    )  # fmt: skip
    pick.add_argument(
        "--role", choices=("target", "validation"),
        help="default target; in a list what it says, else validation where the name begins with V",
    )  # fmt: skip
    system_options(pick, "local")
    pick.add_argument("--shape", choices=("plane", "sphere"), default="plane", help="default plane")
    pick.add_argument(
        "--sphere-radius",
        type=positive,
        metavar="METRES",
        help="with --shape sphere: the radius of the ball, where it is known (otherwise 0.05 to "
        "0.5 m are sought)",
    )
    pick.add_argument("--line", help="with --seed: seek in this line only")
    pick.add_argument(
        "--threshold",
        type=within(*THRESHOLDS),
        metavar="METRES",
        help="RANSAC distance threshold (default 0.01, or 3 LiDAR sigma where larger; for spheres "
        "at least 0.03, or 0.3 of a known radius where that is smaller)",
    )
    pick.add_argument("--radius", type=within(*RADII), metavar="METRES", help="search radius")
    pick.add_argument(
        "--min-points", type=whole(3), metavar="N", default=30,
        help="fewest points of a plane or sphere in a line (default 30)",
    )  # fmt: skip
    pick.add_argument(
        "--max-tilt", type=positive, metavar="DEG", default=15.0,
        help="largest angle between a target's normals in two lines (default 15)",
    )  # fmt: skip
    pick.add_argument(
        "--stop", type=positive, metavar="P", default=0.98,
        help="planes are drawn until one free of outliers is among them with this probability "
        "(default 0.98)",
    )  # fmt: skip
    pick.add_argument(
        "--random-seed", type=whole(0), metavar="N", default=0,
        help="of the draws: the same seed gives the same points (default 0)",
    )  # fmt: skip
    triple(
        pick, "--expected", ("WIDTH", "HEIGHT", "TILT"),
        "size of the plane (m) and its angle from level (deg) to compare with; "
        "1.23 1.22 90 is the usual board",
    )  # fmt: skip
    json_option(pick)
