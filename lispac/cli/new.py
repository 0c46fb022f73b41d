"""``lispac new``: a project of a trajectory and lines."""

import math
import sys
from argparse import Namespace
from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path
from typing import Any

from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.estimate_options import noise_and_offset_settings
from lispac.cli.messages import message_values, print_messages
from lispac.cli.sensor_options import pos_sigma_settings, sensor_titles
from lispac.identity import BLANK
from lispac.language import to_plain_text
from lispac.message_texts import message_text
from lispac.project import LineSource, Reading, Settings
from lispac.survey.line_source import printable
from lispac.workflow.project import projects
from lispac.workflow.project.survey import Survey


def new(arguments: Namespace) -> None:
    """Create a project and read its lines once to check them."""
    columns = tuple(arguments.columns.split(",")) if arguments.columns else ()
    options: dict[str, Any] = {
        "boresight_deg": arguments.boresight,
        "origin_deg_m": arguments.origin,
        "position_sigma": arguments.position_sigma,
        "attitude_sigma_deg": arguments.attitude_sigma,
    }
    triples: dict[str, Any] = {k: tuple(v) for k, v in options.items() if v is not None}
    triples = pos_sigma_settings(arguments.pos) | triples
    settings = Settings(
        lever_arm=tuple(arguments.lever_arm), **triples, **noise_and_offset_settings(arguments)
    )
    named = sensor_titles(arguments.scanner, arguments.pos)
    if arguments.longest_gap is not None:
        settings = replace(settings, longest_gap=arguments.longest_gap)
    reading = Reading(
        arguments.line_format or "", tuple(arguments.line_option), arguments.time_shift
    )
    lines = [
        LineSource(name, path, columns, reading) for name, path in _line_names(arguments.lines)
    ]
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
            identity=BLANK.changed(**named),
            split_by=arguments.split_by,
            progress=progress,
        )
    _print_notes(survey)
    if arguments.pos is not None and arguments.trajectory_accuracy is not None:
        print(
            f"note: the sigmas of {named['pos']} are not used: {arguments.trajectory_accuracy} "
            "contains the sigmas", file=sys.stderr,
        )  # fmt: skip
    points = {name: len(scan) for name, scan in survey.scans.items()}
    if arguments.json:
        found = [message_values(each) for each in survey.messages]
        print_json({"project": str(project.folder), "points": points, "messages": found})
        return
    for name, count in points.items():
        heading = math.degrees(survey.heading[name]) % 360
        print(f"{name:20s} {count:12,} points, heading {heading:5.1f} deg")
    print(f"project    {project.folder}")


def _line_names(paths: Iterable[Path]) -> list[tuple[str, Path]]:
    return [(printable(path.stem), path) for path in paths]


def _print_notes(survey: Survey) -> None:
    for note in survey.notes:
        print(f"note: {to_plain_text(message_text(note))}", file=sys.stderr)
    print_messages(survey.messages)
