"""Sensors of the library at the command line: the list, and sigmas by name."""

import argparse
from typing import TYPE_CHECKING, Any

from lispac.cli.values import Commands, command, json_option

if TYPE_CHECKING:
    from lispac.workflow.sensors import Library


def add(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Describe ``lispac sensors``."""
    sensors = command(
        commands,
        "sensors",
        "list scanners and INS/GNSS with their sigmas and the sources of these",
    )
    json_option(sensors)


def pos_option(parser: argparse.ArgumentParser) -> None:
    """Let a command take the sigmas of a POS by its name."""
    parser.add_argument(
        "--pos", metavar="NAME[:SOLUTION]",
        help="use the sigmas of an INS/GNSS listed by `lispac sensors`, e.g. apogee:ppk, unless "
             "sigmas are given otherwise; its name is added to the details for the report",
    )  # fmt: skip


def scanner_noise(name: str) -> dict[str, Any]:
    """LiDAR noise of a scanner of the library, by the names of the settings."""
    from lispac.workflow.sensors import noise_of

    return noise_of(_library().scanner(name))


def pos_sigmas(word: str | None) -> dict[str, Any]:
    """Sigmas of a POS of the library, by the names of the settings; none where none is named."""
    from lispac.workflow.sensors import sigmas_of

    return {} if word is None else sigmas_of(_library().pos_state(word)[1])


def titles(scanner: str | None, pos: str | None) -> dict[str, str]:
    """Titles of what is named, by the fields of the identity."""
    found = {}
    if scanner is not None:
        found["scanner"] = _library().scanner(scanner).title
    if pos is not None:
        found["pos"] = _library().pos_state(pos)[0].title
    return found


def _library() -> "Library":
    from lispac.workflow.sensors import library, own_sensors

    return library(own_sensors())
