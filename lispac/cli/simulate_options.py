"""Options of the command that simulates surveys."""

import argparse
from pathlib import Path

from lispac.cli.values import Commands, command, finite, json_option, positive, triple, whole


def add(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Describe ``lispac simulate``."""
    simulate = command(
        commands, "simulate", "simulate a survey of a scene and write it as a project, with truth"
    )
    simulate.add_argument(
        "scene",
        nargs="?",
        metavar="SCENE",
        help="name of a scene (see --list), or a TOML file: a scene or a plan",
    )
    simulate.add_argument("--output", type=Path, metavar="DIR", help="project folder to make")
    simulate.add_argument(
        "--list", action="store_true", help="list scenes, vessels and scanners, and stop"
    )
    simulate.add_argument(
        "--seed", type=whole(0), default=2019, metavar="N",
        help="the same seed gives the same survey (default 2019)",
    )  # fmt: skip
    for kind in ("vessel", "scanner"):
        simulate.add_argument(
            f"--{kind}", metavar="NAME", help=f"another {kind} than the scene's: a name, or a file"
        )
    simulate.add_argument(
        "--trajectory", type=Path, metavar="SBET", help="take this trajectory for the true motion"
    )
    simulate.add_argument(
        "--points-per-second", type=positive, metavar="N",
        help="pulses of the scanner over its whole turn (default: as scene or scanner says)",
    )  # fmt: skip
    triple(
        simulate, "--boresight", ("ROLL", "PITCH", "YAW"),
        "true boresight (deg; default: the vessel's)",
    )  # fmt: skip
    triple(
        simulate, "--lever-error", ("X", "Y", "Z"), "true lever arm less the one written down (m)"
    )
    simulate.add_argument(
        "--range-offset", type=finite, metavar="M", help="what has to be added to every range (m)"
    )
    simulate.add_argument(
        "--scan-angle-offset", type=finite, metavar="DEG",
        help="turn of every beam about the x axis of the LiDAR (deg)",
    )  # fmt: skip
    simulate.add_argument(
        "--latency", type=finite, metavar="S", help="what has to be added to every time (s)"
    )
    simulate.add_argument(
        "--no-noise", action="store_true", help="the scanner has no noise and no mixed echoes"
    )
    simulate.add_argument("--no-pos-errors", action="store_true", help="the POS does not err")
    json_option(simulate)
