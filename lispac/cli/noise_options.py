"""Options for LiDAR noise, offsets and the error budget, shared by several commands."""

from argparse import ArgumentParser, Namespace
from collections.abc import Mapping
from typing import Any

from lispac.cli.argument_types import add_triple_option, finite_number, positive_number


def add_noise_options(parser: ArgumentParser) -> None:
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


def add_offset_options(parser: ArgumentParser, kind: str = "prior", default: str = "0") -> None:
    """Add the options for the range offset, scan angle offset and latency.

    Parameters
    ----------
    kind : str
        Which values they are, for the help: ``prior`` or ``true``.
    default : str
        What applies without the option, for the help.
    """
    for name, unit, short_unit, text in (
        ("range-offset", "METRES", "m", "range offset, added to every range"),
        ("scan-angle-offset", "DEGREES", "deg",
         "scan-angle offset, rotation of every beam about the x axis of the scanner"),
        ("latency", "SECONDS", "s",
         "latency, added to the time of every point before the trajectory is interpolated"),
    ):  # fmt: skip
        parser.add_argument(
            f"--{name}", type=finite_number, metavar=unit,
            help=f"{kind} {text} ({short_unit}; default {default})",
        )  # fmt: skip


def add_lever_arm_sigma_option(parser: ArgumentParser, default: str = "assumed exact") -> None:
    """Add the option for the standard deviations of the lever arm.

    Parameters
    ----------
    default : str
        What applies without the option, for the help.
    """
    add_triple_option(
        parser, "--lever-arm-sigma", ("X", "Y", "Z"),
        f"1 sigma of the lever arm (m; default: {default})",
    )  # fmt: skip


def add_divergence_option(
    parser: ArgumentParser, default: str = "that of --scanner, or not included"
) -> None:
    """Add the option for the beam divergence.

    Parameters
    ----------
    default : str
        What applies without the option, for the help.
    """
    parser.add_argument(
        "--beam-divergence", type=positive_number, metavar="MRAD",
        help="full angle of the beam divergence for the error budget (mrad; default: "
        f"{default})",
    )  # fmt: skip


def noise_and_offset_settings(arguments: Namespace) -> Mapping[str, Any]:
    """Settings of LiDAR noise and offsets given on the command line."""
    changes: dict[str, Any] = {}
    if arguments.scanner is not None:
        from lispac.workflow.planning.sensors import (
            noise_settings,
            read_library,
            user_sensors_folder,
        )

        changes = noise_settings(read_library(user_sensors_folder()).scanner(arguments.scanner))
    noise = {
        "lidar_sigma": arguments.lidar_sigma,
        "lidar_sigma_xyz": arguments.lidar_sigma_xyz and tuple(arguments.lidar_sigma_xyz),
        "lidar_beam_sigma": arguments.lidar_beam_sigma and tuple(arguments.lidar_beam_sigma),
    }
    if any(value is not None for value in noise.values()):
        # One form of the LiDAR noise replaces another.
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
