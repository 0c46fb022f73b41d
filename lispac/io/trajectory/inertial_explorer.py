"""Reading of text exports of NovAtel Inertial Explorer (Waypoint).

Lines with the project and the settings are followed by a line of column names, a line of units, and
rows of numbers in aligned columns or with a separator. The profile of the export decides which
columns there are:

    Program:     Inertial Explorer Version 8.90
    Datum:       WGS84, (processing datum)

      GPSTime         Latitude        Longitude        H-Ell         Roll        Pitch      Heading
        (sec)       (+/-D M S)       (+/-D M S)          (m)        (Deg)        (Deg)        (Deg)
    486000.00   45 30 00.12345  -73 29 59.87650       10.123    0.1234567    0.1234567   17.1234567

The reader uses these names and units, never the position of a column; an angle in degrees, minutes
and seconds has three fields between blanks. The name of the time gives its base. Signs are those of
NovAtel: roll is a right-handed rotation about the forward axis (positive starboard down), pitch one
about the starboard axis (positive bow up), heading clockwise from north.

Sources: names, units and notation from the files described in ``read_gps_novatel.m`` of the CReSIS
toolbox; signs from the OEM7 documentation of NovAtel (docs.novatel.com, log INSPVAS).
"""

import re
from collections.abc import Sequence
from functools import partial
from pathlib import Path

import numpy as np

from lispac.errors import InputError
from lispac.io.format_types import IMPOSSIBLE, LIKELY, SURE, Choice, Fact, FilePreview
from lispac.io.text.text_table import first_lines, is_data_row, numbered_lines, split_fields
from lispac.io.trajectory.trajectory_columns import (
    POSITION_ROLES,
    Column,
    Rows,
    TrajectoryConventions,
    default_unit,
    role_of,
    unit_assumed_warning,
)
from lispac.io.trajectory.trajectory_options import (
    GRID_SYSTEM_OPTION,
    TIME_OPTION,
    described_text_formats,
)
from lispac.io.trajectory.trajectory_preview import TextLayout, preview_text
from lispac.io.trajectory.trajectory_velocities import velocity_columns
from lispac.io.units import UNKNOWN, parse_unit
from lispac.messages import Message, error, note

_PROGRAM_PATTERN = re.compile(r"Program:\s*(Inertial Explorer.*)", re.IGNORECASE)
_UNIT_PATTERN = re.compile(r"\([^)]*\)")
_FACT_NAMES = {"Program": "Header", "Datum": "Datum"}


def sniff_inertial_explorer(path: Path) -> float:
    """Likelihood of an Inertial Explorer export, by its program line and line of column names."""
    lines = first_lines(path)
    start = _names_line(lines)
    if start is None:
        return IMPOSSIBLE
    if any(_PROGRAM_PATTERN.match(line.strip()) for line in lines[:start]):
        return SURE
    # The name of the height is that of Waypoint, with units in brackets below the names.
    return LIKELY if "H-Ell" in lines[start] and _has_units(lines, start) else IMPOSSIBLE


def inertial_explorer_layout(path: Path) -> TextLayout:
    """Text layout from the line of column names and the line of units.

    Raises
    ------
    InputError
        If there is no line of column names.
    """
    lines = first_lines(path)
    start = _names_line(lines)
    if start is None:
        # Reading the first line detects a missing, empty or binary file.
        next(numbered_lines(path, "Inertial Explorer text"), None)
        raise InputError(error("trajectory.inertial_explorer_header", file=str(path)))
    names, words = _names_and_units(lines, start)
    columns: list[Column] = []
    file_warnings: list[Message] = []
    for index, (name, unit_words) in enumerate(zip(names, words, strict=True)):
        role = role_of(name)
        # The base of the time is in its name, so that dates are not needed.
        if not role or role == "date" or any(column.role == role for column in columns):
            continue
        unit = parse_unit(unit_words) or (UNKNOWN + unit_words if unit_words else "")
        if not unit:
            unit = default_unit(role)
            file_warnings.append(unit_assumed_warning(path, name, unit))
        columns.append(Column(role, index, name, unit))
    facts: dict[str, Fact] = {}
    for line in lines[:start]:
        key, colon, value = line.strip().partition(":")
        if colon and key in _FACT_NAMES and value.strip():
            facts[_FACT_NAMES[key]] = value.strip()
    units = [parse_unit(unit_words) for unit_words in words]
    is_aligned = _is_aligned(lines[start])
    widths = [3 if is_aligned and unit == "dms" else 1 for unit in units]
    return TextLayout(
        tuple(columns), names, partial(_split_row, widths=widths),
        partial(_rows, start=start + 1, widths=widths), facts, tuple(file_warnings),
        velocity_columns(names, units),
    )  # fmt: skip


def preview_inertial_explorer(path: Path, choice: Choice) -> FilePreview:
    """Header, first rows and warnings."""
    path = Path(path)
    layout = inertial_explorer_layout(path)
    conventions = _conventions(layout, choice)
    return preview_text(path, layout, conventions, {"time": conventions.time} | dict(choice))


def _names_line(lines: list[str]) -> int | None:
    """Index of the line of column names."""
    for index, line in enumerate(lines):
        roles = {role_of(name) for name in split_fields(line)}
        if "time" in roles and len(roles - {""}) >= 5:
            return index
    return None


def _has_units(lines: list[str], start: int) -> bool:
    return start + 1 < len(lines) and lines[start + 1].strip().startswith("(")


def _is_aligned(title: str) -> bool:
    """True if blanks and no separator are between the column names."""
    return not set(title) & set(",;\t")


def _names_and_units(lines: list[str], start: int) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Column names, and the unit of each without its brackets.

    In aligned columns, a unit belongs to the name above it, since some names have no unit.
    """
    title = lines[start]
    names = split_fields(title)
    units_line = lines[start + 1] if _has_units(lines, start) else ""
    if _is_aligned(title):
        units = [""] * len(names)
        spans = [match.span() for match in re.finditer(r"\S+", title)]
        for unit in _UNIT_PATTERN.finditer(units_line):
            first, last = unit.span()
            above = [k for k, (begin, end) in enumerate(spans) if begin < last and first < end]
            if len(above) == 1:
                units[above[0]] = unit[0]
    else:
        units = split_fields(units_line) if units_line else []
        units += [""] * (len(names) - len(units))
    return tuple(names), tuple(unit.strip("() ") for unit in units[: len(names)])


def _split_row(line: str, *, widths: Sequence[int]) -> list[str]:
    """Split a row into its columns; only the first field if the number of fields is not theirs.

    Parameters
    ----------
    widths : sequence of int
        Number of fields of each column: 3 for degrees, minutes and seconds between blanks.
    """
    fields = split_fields(line)
    if len(fields) != sum(widths):
        return fields[:1]
    ends = np.cumsum(widths)
    return [" ".join(fields[end - width : end]) for width, end in zip(widths, ends, strict=True)]


def _rows(path: Path, *, start: int, widths: Sequence[int]) -> Rows:
    """Split the rows of data, which begin after ``start`` lines and the line of units.

    Raises
    ------
    InputError
        If a row does not consist of numbers, or does not have the columns of the header.
    """
    for row, line in numbered_lines(path, "Inertial Explorer text"):
        text = line.strip()
        if row <= start or not text or (row == start + 1 and text.startswith("(")):
            continue
        if not is_data_row(split_fields(line)):
            raise InputError(error("trajectory.not_a_row", file=str(path), row=row, text=text[:40]))
        fields = _split_row(line, widths=widths)
        if len(fields) != len(widths):
            raise InputError(error("trajectory.uneven_row", file=str(path), row=row))
        yield row, fields


def _conventions(layout: TextLayout, choice: Choice) -> TrajectoryConventions:
    columns = {column.role: column for column in layout.columns}
    crs = "" if columns.keys() >= set(POSITION_ROLES) else choice.get("crs", "")
    return TrajectoryConventions(time=choice.get("time", _time_base(columns.get("time"))), crs=crs)


def _time_base(time: Column | None) -> str:
    """Key of the time base of ``GPSTime``, ``UTCTime`` and others, in seconds or as hh:mm:ss."""
    if time is None:
        return "gps-week"
    system = "utc" if time.name.lower().startswith("utc") else "gps"
    return f"{system}-{'day' if time.unit == 'clock' else 'week'}"


INERTIAL_EXPLORER_FORMAT, INERTIAL_EXPLORER_ACCURACY_FORMAT = described_text_formats(
    ("inertial-explorer-text", note("format.inertial_explorer")),
    ("inertial-explorer-sigmas", note("format.inertial_explorer_sigmas")),
    (TIME_OPTION, GRID_SYSTEM_OPTION),
    sniff_inertial_explorer,
    inertial_explorer_layout,
    preview_inertial_explorer,
    _conventions,
    has_time_base=True,  # the name of the time column gives it
)
