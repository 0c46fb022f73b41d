"""The options of ``lispac estimate``, and those it shares with ``lispac new``."""

import argparse
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from lispac.cli.sensor_options import scanner_noise
from lispac.cli.values import (
    Commands,
    command,
    finite,
    json_option,
    not_negative,
    positive,
    surface,
    triple,
)


def lidar_noise(parser: argparse.ArgumentParser) -> None:
    """Let a command take the LiDAR noise in one of four ways."""
    noise = parser.add_mutually_exclusive_group()
    noise.add_argument(
        "--lidar-sigma", type=positive, metavar="METRES", help="LiDAR noise on each axis"
    )
    noise.add_argument(
        "--lidar-sigma-xyz", type=positive, nargs=3, metavar=("X", "Y", "Z"),
        help="instead: LiDAR noise along each axis of the scanner (m)",
    )  # fmt: skip
    noise.add_argument(
        "--lidar-beam-sigma", type=positive, nargs=2, metavar=("RANGE", "ANGLE"),
        help="instead: noise of the range (m) and of the direction of the beam (deg)",
    )  # fmt: skip
    noise.add_argument(
        "--scanner", metavar="NAME", help="instead: noise of this scanner of `lispac sensors`"
    )


def offsets(parser: argparse.ArgumentParser) -> None:
    """Add the options for known systematic errors of the scanner."""
    for name, unit, text in (
        ("range-offset", "METRES", "added to every range"),
        ("scan-angle-offset", "DEGREES", "turns every beam about the x axis of the scanner"),
        ("latency", "SECONDS", "added to the time of every point before the trajectory is asked"),
    ):
        parser.add_argument(
            f"--{name}", type=finite, metavar=unit, help=f"prior value (default 0): {text}"
        )


def noise_and_offsets(arguments: argparse.Namespace) -> Mapping[str, Any]:
    """What was given of the LiDAR noise and the offsets, by the names of the settings."""
    given: dict[str, Any] = {}
    if arguments.scanner is not None:
        given = scanner_noise(arguments.scanner)
    noise = {
        "lidar_sigma": arguments.lidar_sigma,
        "lidar_sigma_xyz": arguments.lidar_sigma_xyz and tuple(arguments.lidar_sigma_xyz),
        "lidar_beam_sigma": arguments.lidar_beam_sigma and tuple(arguments.lidar_beam_sigma),
    }
    if any(value is not None for value in noise.values()):
        # One way of stating it takes the place of another.
        given = {"lidar_sigma_xyz": None, "lidar_beam_sigma": None}
        given |= {name: value for name, value in noise.items() if value is not None}
    for setting, value in (
        ("range_offset", arguments.range_offset),
        ("scan_angle_offset_deg", arguments.scan_angle_offset),
        ("latency", arguments.latency),
    ):
        if value is not None:
            given[setting] = value
    return given


def add(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Describe the command and its options."""
    estimate = command(
        commands,
        "estimate",
        "adjust the boresight of a project or of plane files; a project keeps the options given",
    )
    estimate.add_argument("project", type=Path, nargs="?", metavar="PROJECT")
    estimate.add_argument(
        "--subsample",
        type=not_negative,
        metavar="METRES",
        help="points closer than this are averaged; with independent POS errors one of them is "
        "kept (default 0.10; 0 keeps all)",
    )
    estimate.add_argument(
        "--pos-errors",
        choices=("independent", "correlated"),
        help="whether neighbouring points share their POS error (correlated, the default) or each "
        "has its own (independent: the classical model, whose sigmas are too small)",
    )
    for name, default in (("position", 300), ("attitude", 600)):
        estimate.add_argument(
            f"--{name}-time",
            type=positive,
            metavar="SECONDS",
            help=f"correlation time of the {name} error (default {default}; see the processing "
            "report; too short is safer than too long)",
        )
    estimate.add_argument(
        "--surface",
        type=surface,
        metavar="METRES",
        help="sigma by which what one line sees of a target departs from its shape (default auto: "
        "from the data)",
    )
    estimate.add_argument(
        "--loss",
        choices=("auto", "none", "huber", "tukey"),
        help="weights of outliers (default auto: tukey, with independent POS errors none)",
    )
    estimate.add_argument(
        "--estimate",
        action="append",
        metavar="NAME[=SIGMA]",
        help="estimate this too: lever-x, lever-y, lever-z, range-offset (m), scan-angle-offset "
        "(deg), latency (s), with the sigma its value is known to; none switches all off",
    )
    estimate.add_argument(
        "--components",
        action=argparse.BooleanOptionalAction,
        help="take the sigmas of LiDAR and POS from the data",
    )
    estimate.add_argument(
        "--accept-one-facing",
        action=argparse.BooleanOptionalAction,
        help="answer though all targets are planes that face one way, which is refused otherwise: "
        "only the headings of the lines tell the angles apart then",
    )
    estimate.add_argument(
        "--no-cross-checks", action="store_true", help="do not adjust parts of the data too"
    )
    estimate.add_argument("--planes", type=Path, nargs="+", metavar="FILE", help="25-column files")
    triple(estimate, "--lever-arm", ("X", "Y", "Z"), "with --planes (m)")
    triple(estimate, "--boresight", ("R", "P", "Y"), "with --planes: prior (deg), default 0 0 0")
    lidar_noise(estimate)
    offsets(estimate)
    json_option(estimate)
