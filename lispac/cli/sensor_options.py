"""Sensors of the library at the command line: the list, and sigmas by name."""

import argparse
from typing import TYPE_CHECKING, Any

from lispac.cli.argument_types import Commands, add_command, add_json_option

if TYPE_CHECKING:
    from lispac.workflow.planning.sensors import SensorLibrary


def add_sensors_command(commands: "Commands[argparse.ArgumentParser]") -> None:
    """Add the command ``lispac sensors`` and its options."""
    sensors = add_command(
        commands,
        "sensors",
        "list scanners and INS/GNSS with their sigmas and the source of each value",
    )
    add_json_option(sensors)


def add_pos_option(parser: argparse.ArgumentParser) -> None:
    """Add the option ``--pos`` for the sigmas of a POS by its name."""
    parser.add_argument(
        "--pos", metavar="NAME[:SOLUTION]",
        help="use the sigmas of an INS/GNSS listed by `lispac sensors`, e.g. apogee:ppk, unless "
             "sigmas are given otherwise; its name is added to the details for the report",
    )  # fmt: skip


def scanner_noise_settings(name: str) -> dict[str, Any]:
    """LiDAR noise of a scanner of the library, by the names of the settings."""
    from lispac.workflow.planning.sensors import noise_settings

    return noise_settings(_sensor_library().scanner(name))


def pos_sigma_settings(word: str | None) -> dict[str, Any]:
    """Sigmas of a POS of the library, by the names of the settings; none where none is named."""
    from lispac.workflow.planning.sensors import sigma_settings

    return {} if word is None else sigma_settings(_sensor_library().find_pos(word)[1])


def sensor_titles(scanner: str | None, pos: str | None) -> dict[str, str]:
    """Titles of the named sensors, by the fields of the identity."""
    found = {}
    if scanner is not None:
        found["scanner"] = _sensor_library().scanner(scanner).title
    if pos is not None:
        found["pos"] = _sensor_library().find_pos(pos)[0].title
    return found


def _sensor_library() -> "SensorLibrary":
    from lispac.workflow.planning.sensors import read_library, user_sensors_folder

    return read_library(user_sensors_folder())
