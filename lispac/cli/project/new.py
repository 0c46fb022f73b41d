"""``lispac new``: create a project from a trajectory and lines."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lispac.cli.argument_types import (
    add_json_option,
    add_triple_option,
    finite_number,
    positive_number,
)
from lispac.cli.console import ConsoleProgress, print_json, print_table
from lispac.cli.former_options import split_reading_option
from lispac.cli.messages import print_messages
from lispac.cli.noise_options import (
    add_divergence_option,
    add_lever_arm_sigma_option,
    add_noise_options,
    add_offset_options,
    noise_and_offset_settings,
)
from lispac.identity import EMPTY_IDENTITY

if TYPE_CHECKING:
    pass


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument("project", type=Path, metavar="PROJECT", help="project folder to create")
    parser.add_argument(
        "lines", type=Path, nargs="+", metavar="LINE",
        help="scan file of one line (LAS, LAZ, E57, PLY, PCD, PCAP, text)",
    )  # fmt: skip
    parser.add_argument(
        "--trajectory", type=Path, required=True, metavar="FILE",
        help="trajectory: SBET, POF; Exail, POSPac or Inertial Explorer text; text with named "
        "columns",
    )  # fmt: skip
    parser.add_argument(
        "--trajectory-accuracy",
        type=Path,
        metavar="FILE",
        help="accuracy of the trajectory: smrmsg file, or a text export of it",
    )
    _add_format_options(parser)
    parser.add_argument(
        "--time-shift", type=finite_number, default=0.0, metavar="SECONDS",
        help="seconds added to the times of the lines to obtain trajectory time (default 0)",
    )  # fmt: skip
    parser.add_argument(
        "--split-by", default="", metavar="ATTRIBUTE",
        help="split each file into lines: one line for each value of an attribute "
             "(point_source_id, scanner_channel, user_data, ...), or, with gap, one line for each "
             "part between gaps in the times",
    )  # fmt: skip
    add_triple_option(
        parser,
        "--lever-arm",
        ("X", "Y", "Z"),
        "lever arm from the POS to the LiDAR: forward, left, up (m)",
        required=True,
    )
    add_triple_option(
        parser, "--boresight", ("ROLL", "PITCH", "YAW"), "prior boresight (deg; default 0 0 0)"
    )
    add_triple_option(
        parser,
        "--origin",
        ("LAT", "LON", "HEIGHT"),
        "origin of the local frame (deg, m; default: mean position of the trajectory)",
    )
    _add_pos_options(parser)
    add_noise_options(parser)
    add_offset_options(parser)
    add_lever_arm_sigma_option(parser)
    add_divergence_option(parser)
    parser.add_argument(
        "--longest-gap", type=positive_number, metavar="SECONDS",
        help="longest gap of the trajectory to interpolate across (s; default 1.5)",
    )  # fmt: skip
    parser.add_argument(
        "--columns",
        metavar="NAMES",
        help="columns of text files with points, from the left, e.g. time,x,y,z,intensity",
    )
    add_json_option(parser)


def _add_pos_options(parser: ArgumentParser) -> None:
    """Add the options of the POS errors."""
    add_triple_option(
        parser,
        "--position-sigma",
        ("N", "E", "D"),
        "sigmas of the position without accuracy file (m; default 0.02 0.02 0.03)",
    )
    add_triple_option(
        parser, "--attitude-sigma", ("ROLL", "PITCH", "HEADING"),
        "sigmas of the attitude without accuracy file (deg; default 0.01 0.01 0.015)",
    )  # fmt: skip
    parser.add_argument(
        "--pos", metavar="NAME[:SOLUTION]",
        help="use the sigmas of an INS/GNSS listed by `lispac sensors`, e.g. apogee:ppk, unless "
             "sigmas are given otherwise; its name is added to the details for the report",
    )  # fmt: skip


def _add_format_options(parser: ArgumentParser) -> None:
    """Add the options for the formats of the input files."""
    for file, what in (
        ("trajectory", "the trajectory"),
        ("accuracy", "the trajectory accuracy"),
        ("line", "the lines"),
    ):  # fmt: skip
        parser.add_argument(
            f"--{file}-format", metavar="KEY", help=f"format of {what} (default: detected)"
        )
        parser.add_argument(
            f"--{file}-option",
            type=split_reading_option,
            action="append",
            default=[],
            metavar="NAME=VALUE",
            help=f"option for reading {what}; `lispac inspect FILE` lists the options",
        )


def run(arguments: Namespace) -> None:
    """Create a project and read its lines once to check them."""
    from lispac.present.survey.survey_data import LINES_TABLE, LineValues
    from lispac.project import LineSource, Reading, Settings
    from lispac.survey.line_source import printable
    from lispac.workflow.project import projects

    columns = tuple(arguments.columns.split(",")) if arguments.columns else ()
    options: dict[str, Any] = {
        "boresight_deg": arguments.boresight,
        "origin_deg_m": arguments.origin,
        "position_sigma": arguments.position_sigma,
        "attitude_sigma_deg": arguments.attitude_sigma,
        "lever_arm_sigma": arguments.lever_arm_sigma,
    }
    triples: dict[str, Any] = {k: tuple(v) for k, v in options.items() if v is not None}
    triples = _pos_settings(arguments.pos) | triples
    settings = Settings(
        lever_arm=tuple(arguments.lever_arm), **triples, **noise_and_offset_settings(arguments)
    )
    named = _sensor_titles(arguments.scanner, arguments.pos)
    if arguments.beam_divergence is not None:
        settings = replace(settings, beam_divergence_mrad=arguments.beam_divergence)
    if arguments.longest_gap is not None:
        settings = replace(settings, longest_gap=arguments.longest_gap)
    reading = Reading(
        arguments.line_format or "", tuple(arguments.line_option), arguments.time_shift
    )
    lines = [LineSource(printable(path.stem), path, columns, reading) for path in arguments.lines]
    with ConsoleProgress() as progress:
        project, survey = projects.new_project(
            arguments.project,
            trajectory=arguments.trajectory,
            lines=lines,
            settings=settings,
            accuracy=arguments.trajectory_accuracy,
            trajectory_reading=Reading(
                arguments.trajectory_format or "", tuple(arguments.trajectory_option)
            ),
            accuracy_reading=Reading(
                arguments.accuracy_format or "", tuple(arguments.accuracy_option)
            ),
            identity=EMPTY_IDENTITY.changed(**named),
            split_by=arguments.split_by,
            progress=progress,
        )
    print_messages([*survey.notes, *survey.messages])
    if arguments.pos is not None and arguments.trajectory_accuracy is not None:
        print(
            f"note: the sigmas of {named['pos']} are not used: {arguments.trajectory_accuracy} "
            "contains the sigmas", file=sys.stderr,
        )  # fmt: skip
    points = {name: len(scan) for name, scan in survey.scans.items()}
    if arguments.json:
        from lispac.cli.json_outputs import NewOutput

        print_json(NewOutput(project.folder, points, tuple(survey.messages)))
        return
    print_table(
        LINES_TABLE,
        [
            LineValues(
                line.name, line.path.name, survey.headings_deg[line.name], points[line.name], ()
            )
            for line in project.lines
        ],
    )
    print(f"project    {project.folder}")


def _pos_settings(word: str | None) -> dict[str, Any]:
    """Sigmas of an INS/GNSS of the library, by name of the setting; empty for None."""
    from lispac.workflow.planning.sensors import read_library, sigma_settings, user_sensors_folder

    if word is None:
        return {}
    return sigma_settings(read_library(user_sensors_folder()).find_pos(word)[1])


def _sensor_titles(scanner: str | None, pos: str | None) -> dict[str, str]:
    """Titles of the sensors with these names in the library, by field of the identity."""
    from lispac.workflow.planning.sensors import read_library, user_sensors_folder

    found = {}
    if scanner is not None:
        found["scanner"] = read_library(user_sensors_folder()).scanner(scanner).title
    if pos is not None:
        found["pos"] = read_library(user_sensors_folder()).find_pos(pos)[0].title
    return found
