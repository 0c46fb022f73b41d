"""The options of ``lispac estimate``, and those it shares with ``lispac new``."""

import argparse
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from lispac.cli.argument_types import (
    Commands,
    add_command,
    add_json_option,
    add_triple_option,
    finite_number,
    non_negative_number,
    positive_number,
    surface_sigma,
)
from lispac.cli.sensor_options import scanner_noise_settings


def add_noise_options(parser: argparse.ArgumentParser) -> None:
    """Add the options for the LiDAR noise, in one of four forms."""
    noise = parser.add_mutually_exclusive_group()
    noise.add_argument(
        "--lidar-sigma",
        type=positive_number,
        metavar="METRES",
        help="LiDAR noise on each axis, 1 sigma (m; default of a new project 0.005)",
    )
    noise.add_argument(
        "--lidar-sigma-xyz", type=positive_number, nargs=3, metavar=("X", "Y", "Z"),
        help="instead of --lidar-sigma: LiDAR noise along each axis of the scanner, 1 sigma (m)",
    )  # fmt: skip
    noise.add_argument(
        "--lidar-beam-sigma", type=positive_number, nargs=2, metavar=("RANGE", "ANGLE"),
        help="instead of --lidar-sigma: LiDAR noise of the range (m) and of the beam direction "
        "(deg), 1 sigma",
    )  # fmt: skip
    noise.add_argument(
        "--scanner",
        metavar="NAME",
        help="instead of --lidar-sigma: LiDAR noise of a scanner listed by `lispac sensors`",
    )


def add_offset_options(parser: argparse.ArgumentParser) -> None:
    """Add the options for the range offset, scan angle offset and latency."""
    for name, unit, text in (
        ("range-offset", "METRES", "range offset, added to every range (m; default 0)"),
        (
            "scan-angle-offset",
            "DEGREES",
            "scan-angle offset, rotation of every beam about the x axis of the scanner (deg; "
            "default 0)",
        ),
        (
            "latency",
            "SECONDS",
            "latency, added to the time of every point before the trajectory is interpolated (s; "
            "default 0)",
        ),
    ):
        parser.add_argument(f"--{name}", type=finite_number, metavar=unit, help=f"prior {text}")


def noise_and_offset_settings(arguments: argparse.Namespace) -> Mapping[str, Any]:
    """Settings of LiDAR noise and offsets given on the command line."""
    changes: dict[str, Any] = {}
    if arguments.scanner is not None:
        changes = scanner_noise_settings(arguments.scanner)
    noise = {
        "lidar_sigma": arguments.lidar_sigma,
        "lidar_sigma_xyz": arguments.lidar_sigma_xyz and tuple(arguments.lidar_sigma_xyz),
        "lidar_beam_sigma": arguments.lidar_beam_sigma and tuple(arguments.lidar_beam_sigma),
    }
    if any(value is not None for value in noise.values()):
        # One way of stating it takes the place of another.
        changes = {"lidar_sigma_xyz": None, "lidar_beam_sigma": None}
        changes |= {name: value for name, value in noise.items() if value is not None}
    for setting, value in (
        ("range_offset", arguments.range_offset),
        ("scan_angle_offset_deg", arguments.scan_angle_offset),
        ("latency", arguments.latency),
    ):
        if value is not None:
            changes[setting] = value
    return changes


def add_estimate_command(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Add the command and its options."""
    estimate = add_command(
        commands,
        "estimate",
        "estimate the boresight of a project or of plane files; the options are saved in the "
        "project",
    )
    estimate.add_argument("project", type=Path, nargs="?", metavar="PROJECT", help="project folder")
    estimate.add_argument(
        "--subsample",
        type=non_negative_number,
        metavar="METRES",
        help="point spacing (m): closer points are averaged, or with independent POS errors "
        "thinned to one (default 0.10; 0 keeps all points)",
    )
    estimate.add_argument(
        "--pos-errors",
        choices=("independent", "correlated"),
        help="model of the POS errors: correlated between neighbouring points (default), or "
        "independent for each point (classical model; its sigmas are too small)",
    )
    for name, default in (("position", 300), ("attitude", 600)):
        estimate.add_argument(
            f"--{name}-time",
            type=positive_number,
            metavar="SECONDS",
            help=f"correlation time of the {name} error of the POS (s; default {default}); use the "
            "value of the processing report; too short is safer than too long",
        )
    estimate.add_argument(
        "--surface",
        type=surface_sigma,
        metavar="METRES",
        help="surface roughness (m): standard deviation of the offset of a whole sighting from the "
        "common surface of all lines (default auto: estimated from the data)",
    )
    estimate.add_argument(
        "--loss",
        choices=("auto", "none", "huber", "tukey"),
        help="loss function for outliers (default auto: tukey; with independent POS errors none)",
    )
    estimate.add_argument(
        "--estimate",
        action="append",
        metavar="NAME[=SIGMA]",
        help="additional parameter to estimate: lever-x, lever-y, lever-z, range-offset (m), "
        "scan-angle-offset (deg) or latency (s), optionally with the 1 sigma of its prior "
        "value; none estimates no additional parameter (default: as saved in the project)",
    )
    estimate.add_argument(
        "--components",
        action=argparse.BooleanOptionalAction,
        help="estimate the sigmas of LiDAR and POS from the data (variance components)",
    )
    estimate.add_argument(
        "--accept-single-orientation",
        action=argparse.BooleanOptionalAction,
        help="allow targets that all face the same way; the angles are then separated by the "
        "headings of the lines alone",
    )
    estimate.add_argument(
        "--no-cross-checks",
        action="store_true",
        help="do not repeat the adjustment with subsets of the data",
    )
    estimate.add_argument(
        "--planes",
        type=Path,
        nargs="+",
        metavar="FILE",
        help="plane files with 25 columns, instead of a project",
    )
    add_triple_option(estimate, "--lever-arm", ("X", "Y", "Z"), "with --planes: lever arm (m)")
    add_triple_option(
        estimate,
        "--boresight",
        ("R", "P", "Y"),
        "with --planes: prior boresight (deg; default 0 0 0)",
    )
    add_noise_options(estimate)
    add_offset_options(estimate)
    add_json_option(estimate)
