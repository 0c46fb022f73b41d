"""Options of the command that picks targets."""

import argparse
from pathlib import Path

from lispac.cli.argument_types import (
    Commands,
    add_command,
    add_crs_options,
    add_json_option,
    add_triple_option,
    finite_number,
    number_within,
    positive_number,
    whole_number_from,
)
from lispac.targets.finder_settings import RADII, THRESHOLDS


def add_pick_command(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Add the command ``lispac pick`` and its options."""
    pick = add_command(commands, "pick", "find the plane or sphere at a seed point in every line")
    pick.add_argument("project", type=Path, metavar="PROJECT", help="project folder")
    seeds = pick.add_mutually_exclusive_group(required=True)
    seeds.add_argument(
        "--seed", type=finite_number, nargs=3, metavar=("X", "Y", "Z"),
        help="coordinates of the seed: north, west, up (m); with --crs easting or longitude, "
             "northing or latitude, height",
    )  # fmt: skip
    seeds.add_argument(
        "--seeds", type=Path, metavar="FILE",
        help="list of seeds: text file with name, x, y, z and optionally the role in each row, or "
             "with a header row",
    )  # fmt: skip
    pick.add_argument("--name", help="with --seed: name of the target, e.g. T1")
    pick.add_argument(
        "--columns", metavar="NAMES",
        help="with --seeds: columns of the list from the left, e.g. name,y,x,z,- (- skips a "
             "column)",
    )  # fmt: skip
    pick.add_argument(
        "--replace", action="store_true",
        help="with --seeds: replace existing targets of the same names",
    )  # fmt: skip
    pick.add_argument(
        "--role", choices=("target", "validation"),
        help="role of the target (default target; in a list as given there, otherwise validation "
             "if the name begins with V)",
    )  # fmt: skip
    add_crs_options(pick, "local")
    pick.add_argument(
        "--shape",
        choices=("plane", "sphere"),
        default="plane",
        help="shape of the target (default plane)",
    )
    pick.add_argument(
        "--sphere-radius",
        type=positive_number,
        metavar="METRES",
        help="with --shape sphere: radius of the sphere (m), if known (default: estimated between "
        "0.05 and 0.5 m)",
    )
    pick.add_argument("--line", help="with --seed: search in this line only")
    pick.add_argument(
        "--threshold",
        type=number_within(*THRESHOLDS),
        metavar="METRES",
        help="RANSAC distance threshold (m; default 0.01, or 3 LiDAR sigma if larger; for spheres "
        "at least 0.03, or 0.3 of a known radius if smaller)",
    )
    pick.add_argument(
        "--radius",
        type=number_within(*RADII),
        metavar="METRES",
        help="search radius about the seed (m; default 2 for targets, 4 to 20 for validation "
        "planes)",
    )
    pick.add_argument(
        "--min-points", type=whole_number_from(3), metavar="N", default=30,
        help="minimum number of points of a plane or sphere in a line (default 30)",
    )  # fmt: skip
    pick.add_argument(
        "--max-tilt", type=positive_number, metavar="DEG", default=15.0,
        help="largest angle between a target's normals in two lines (deg; default 15)",
    )  # fmt: skip
    pick.add_argument(
        "--stop", type=positive_number, metavar="P", default=0.98,
        help="RANSAC confidence: probability that at least one sample is free of outliers "
             "(default 0.98)",
    )  # fmt: skip
    pick.add_argument(
        "--random-seed", type=whole_number_from(0), metavar="N", default=0,
        help="seed of the random samples: the same seed gives the same points (default 0)",
    )  # fmt: skip
    add_triple_option(
        pick, "--expected", ("WIDTH", "HEIGHT", "TILT"),
        "expected width and height of the plane (m) and its inclination (deg; 0 level, 90 "
        "vertical), for comparison; 1.23 1.22 90 is the usual board",
    )  # fmt: skip
    add_json_option(pick)
