"""Options of the command that simulates surveys."""

import argparse
from pathlib import Path

from lispac.cli.argument_types import (
    Commands,
    add_command,
    add_json_option,
    add_triple_option,
    finite_number,
    positive_number,
    whole_number_from,
)


def add_simulate_command(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Add the command ``lispac simulate`` and its options."""
    simulate = add_command(
        commands,
        "simulate",
        "simulate a survey of a scene and write it as a project with known true values",
    )
    simulate.add_argument(
        "scene",
        nargs="?",
        metavar="SCENE",
        help="name of a scene (see --list), or TOML file with a scene or a survey plan",
    )
    simulate.add_argument("--output", type=Path, metavar="DIR", help="project folder to create")
    simulate.add_argument(
        "--list", action="store_true", help="list scenes, vessels and scanners and exit"
    )
    simulate.add_argument(
        "--seed", type=whole_number_from(0), default=2019, metavar="N",
        help="seed of the random numbers: the same seed gives the same survey (default 2019)",
    )  # fmt: skip
    for kind in ("vessel", "scanner"):
        simulate.add_argument(
            f"--{kind}",
            metavar="NAME",
            help=f"{kind} to use instead of that of the scene: name or TOML file",
        )
    simulate.add_argument(
        "--trajectory",
        type=Path,
        metavar="SBET",
        help="SBET file to use as the true motion (default: simulated)",
    )
    simulate.add_argument(
        "--points-per-second", type=positive_number, metavar="N",
        help="pulses per second over the full rotation of the scanner (default: from the scene or "
             "scanner)",
    )  # fmt: skip
    add_triple_option(
        simulate, "--boresight", ("ROLL", "PITCH", "YAW"),
        "true boresight (deg; default: that of the vessel)",
    )  # fmt: skip
    add_triple_option(
        simulate,
        "--lever-arm-error",
        ("X", "Y", "Z"),
        "true lever arm minus the lever arm written to the project (m)",
    )
    simulate.add_argument(
        "--range-offset",
        type=finite_number,
        metavar="M",
        help="true range offset: value to be added to every measured range (m)",
    )
    simulate.add_argument(
        "--scan-angle-offset", type=finite_number, metavar="DEG",
        help="true scan-angle offset: rotation of every beam about the x axis of the LiDAR (deg)",
    )  # fmt: skip
    simulate.add_argument(
        "--latency",
        type=finite_number,
        metavar="S",
        help="true latency: value to be added to every recorded time (s)",
    )
    simulate.add_argument(
        "--no-noise",
        action="store_true",
        help="simulate the scanner without noise and without mixed echoes",
    )
    simulate.add_argument(
        "--no-pos-errors", action="store_true", help="simulate the POS without errors"
    )
    add_json_option(simulate)
