"""``lispac history``: the calibrations of each system over the years."""

from __future__ import annotations

import sys
from argparse import ArgumentParser, Namespace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from lispac.cli.argument_types import add_json_option, picture_file
from lispac.cli.console import ConsoleProgress, print_json
from lispac.cli.messages import print_messages
from lispac.message_texts import message_text

if TYPE_CHECKING:
    from lispac.workflow.checking.calibration_history import CalibrationHistory, HistoryEntry


def add_arguments(parser: ArgumentParser) -> None:
    """Add the options."""
    parser.add_argument(
        "folders",
        type=Path,
        nargs="+",
        metavar="FOLDER",
        help="folder to search for projects, including its subfolders",
    )
    parser.add_argument("--vessel", metavar="NAME", help="show only the systems of this vessel")
    parser.add_argument(
        "--picture", type=picture_file, metavar="FILE",
        help="file for the control chart of the system with most calibrations: .png, .svg or .pdf",
    )  # fmt: skip
    add_json_option(parser)


def run(arguments: Namespace) -> None:
    """Print a table for each system and, on request, draw the control chart of the first system."""
    from lispac.workflow.checking.calibration_history import read_histories

    with ConsoleProgress() as progress:
        found, messages = read_histories(
            arguments.folders, vessel=arguments.vessel, progress=progress
        )
    if arguments.picture is not None:
        _draw_chart(arguments, found[0])
    if arguments.json:
        print_json(
            {
                "systems": [_history_values(each) for each in found],
                "messages": list(map(message_text, messages)),
            }
        )
        return
    for each in found:
        _print_calibrations(each)
    sys.stdout.flush()
    print_messages([*messages, *(message for each in found for message in each.messages)])


def _print_calibrations(history: CalibrationHistory) -> None:
    import numpy as np

    from lispac.adjustment.result import ANGLES
    from lispac.workflow.checking.calibration_history import change_message

    width = max(12, *(len(each.charted.calibration.name) for each in history.entries)) + 2
    print(history.system.full_name)
    heads = "".join(f"{f'{angle}, 1 sigma':>20s}" for angle in ANGLES)
    print(f"{'date':12s}{'calibration':{width}s}{heads}  deg")
    for each in history.entries:
        found = each.charted.calibration
        cells = "".join(
            f"{angle:+12.4f} {sigma:7.4f}"
            for angle, sigma in zip(
                np.degrees(found.boresight), np.degrees(found.sigma), strict=True
            )
        )
        print(f"{each.day.isoformat():12s}{found.name:{width}s}{cells}")
    for each in history.entries:
        print(message_text(change_message(each)))
    print()


def _draw_chart(arguments: Namespace, history: CalibrationHistory) -> None:
    from lispac.io.files import atomic_write
    from lispac.report.control_charts import control_chart_figure

    figure = control_chart_figure(
        [each.day for each in history.entries], [each.charted for each in history.entries]
    )
    with atomic_write(arguments.picture) as temporary:
        figure.savefig(temporary, format=arguments.picture.suffix[1:].lower(), dpi=200)


def _history_values(history: CalibrationHistory) -> dict[str, Any]:
    return {
        "system": vars(history.system),
        "calibrations": [_calibration_values(each) for each in history.entries],
        "messages": list(map(message_text, history.messages)),
    }


def _calibration_values(each: HistoryEntry) -> dict[str, Any]:
    import numpy as np

    from lispac.validation.control_chart import control_limits

    charted, reach = each.charted, control_limits(each.charted)
    change = charted.change
    return {
        "day": each.day.isoformat(),
        "name": charted.calibration.name,
        "folder": str(each.project.folder),
        "boresight_deg": np.degrees(charted.calibration.boresight).tolist(),
        "sigma_deg": np.degrees(charted.calibration.sigma).tolist(),
        "series": charted.series,
        "limits_deg": None if reach is None else np.degrees(reach).tolist(),
        "difference_deg": None if change is None else np.degrees(change.angles).tolist(),
        "significance": None if change is None else change.significance.tolist(),
        "probability": None if change is None else change.probability,
        "moved": charted.has_moved,
    }
