"""Reading of INSPVA logs of NovAtel receivers in ASCII, also among other logs.

    #INSPVAA,COM1,0,58.5,FINESTEERING,2001,97200.200,00000000,54e2,13386;2001,97200.200000000,
    55.02183281158,-156.71907213033,15.0975,-0.5983,-0.1397,0.1928,3.044402775,-0.986403548,
    308.979276345,INS_SOLUTION_GOOD*2ed757be

The fields after the semicolon are week, seconds of the week, latitude, longitude, ellipsoidal
height, velocities to north, east and up, roll, pitch, azimuth and the status of the solution.
Roll is positive starboard down, pitch positive bow up.
"""

import re
import zlib
from pathlib import Path

from lispac.errors import InputError
from lispac.io.format_types import IMPOSSIBLE, SURE, Choice, FilePreview
from lispac.io.text.text_table import first_lines, numbered_lines
from lispac.io.trajectory.trajectory_columns import (
    Column,
    Rows,
    TrajectoryConventions,
    trajectory_of,
)
from lispac.io.trajectory.trajectory_preview import TextLayout, preview_text
from lispac.messages import error, note
from lispac.survey.trajectory import Trajectory

_LOG = re.compile(r"[#%](INSPVAA|INSPVASA),([^;*]*);([^*]*)\*([0-9a-f]{8})", re.IGNORECASE)
_NAMES = (
    "Week", "Seconds", "Latitude", "Longitude", "Height", "North velocity", "East velocity",
    "Up velocity", "Roll", "Pitch", "Azimuth", "Status",
)  # fmt: skip
_COLUMNS = (
    Column("time", 1, "Seconds", "s"),
    Column("latitude", 2, "Latitude", "deg"),
    Column("longitude", 3, "Longitude", "deg"),
    Column("height", 4, "Height", "m"),
    Column("roll", 8, "Roll", "deg"),
    Column("pitch", 9, "Pitch", "deg"),
    Column("heading", 10, "Azimuth", "deg"),
)
_VELOCITIES = (
    Column("east_velocity", 6, "East velocity", "m"),
    Column("north_velocity", 5, "North velocity", "m"),
)
_WITHOUT_SOLUTION = frozenset({"INS_INACTIVE", "INS_ALIGNING", "WAITING_INITIALPOS"})
_HEADER_NOTE = note("assumed.header_columns", format=note("format.novatel"))


def sniff_novatel(path: Path) -> float:
    """Likelihood of a file with INSPVA logs."""
    return SURE if any(_LOG.search(line) for line in first_lines(path)) else IMPOSSIBLE


def preview_novatel(path: Path, choice: Choice) -> FilePreview:
    """First rows and warnings."""
    layout = TextLayout(_COLUMNS, _NAMES, ",", _rows, {}, velocities=_VELOCITIES)
    return preview_text(path, layout, _conventions(choice), {"time": "gps-week"} | dict(choice))


def read_novatel(path: Path, choice: Choice) -> Trajectory:
    """Read the trajectory.

    Raises
    ------
    InputError
        If the file has no INSPVA log, or one of them is damaged.
    """
    return trajectory_of(path, _rows(path), _COLUMNS, _conventions(choice), (_HEADER_NOTE,))


def _conventions(choice: Choice) -> TrajectoryConventions:
    return TrajectoryConventions(time=choice.get("time", "gps-week"))


def _rows(path: Path) -> Rows:
    """Fields of each log with a solution.

    Raises
    ------
    InputError
        If a log is damaged.
    """
    for row, line in numbered_lines(path, "NovAtel INSPVA"):
        if "INSPVAA," not in line and "INSPVASA," not in line:
            continue
        found = _LOG.search(line)
        fields = found[3].split(",") if found else []
        if not found or len(fields) != len(_NAMES) or not _is_checksum_correct(found):
            raise InputError(error("trajectory.novatel_log", file=str(path), row=row))
        if fields[-1] not in _WITHOUT_SOLUTION:
            yield row, fields


def _is_checksum_correct(found: re.Match[str]) -> bool:
    text = f"{found[1]},{found[2]};{found[3]}".encode()
    return zlib.crc32(text, 0xFFFFFFFF) ^ 0xFFFFFFFF == int(found[4], 16)
