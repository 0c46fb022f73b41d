"""Reading of text exports of Applanix POSPac (POS Export Utility).

A title and the settings are followed by a line of column names separated by commas, a line of units
in parentheses, and rows of numbers separated by blanks:

    TIME, DISTANCE, EASTING, NORTHING, ELLIPSOID HEIGHT, LATITUDE, LONGITUDE, ..., HEADING SD
    (time in Sec, distance in Meters, position in Meters, lat, long in Degrees, ...)

The reader uses these names and units, never the position of a column. Signs are Applanix's: roll
positive starboard down, pitch positive bow up.
"""

import re
from pathlib import Path

from lispac.errors import InputError
from lispac.io.format_types import IMPOSSIBLE, LIKELY, SURE, Choice, Fact, FilePreview
from lispac.io.text.text_table import first_lines, is_data_row, numbered_lines, split_fields
from lispac.io.trajectory.trajectory_columns import (
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
from lispac.io.trajectory.trajectory_preview import (
    TextLayout,
    preview_text,
)
from lispac.io.trajectory.trajectory_velocities import velocity_columns
from lispac.io.units import parse_unit
from lispac.messages import Message, error, note

_MANUFACTURER_NAMES = re.compile(r"POS Export Utility|Applanix|POSPac|POSPROC", re.IGNORECASE)
_GROUP_AND_UNIT = re.compile(
    r"([A-Za-z][A-Za-z ,]*?)\s+in\s+([A-Za-z./]+(?:\s+(?:Min\w*|Survey \w+|Feet|Foot))?)", re.I
)
_FACT_NAMES = {
    "Date of Mission": "Date of mission",
    "Mapping frame datum": "Mapping frame",
    "POSPROC SBET file": "Made from",
}


def sniff_pospac(path: Path) -> float:
    """Likelihood of a POSPac export, by its title and line of column names."""
    lines = first_lines(path)
    found = _names_line(lines)
    if found is None:
        return IMPOSSIBLE
    if any(_MANUFACTURER_NAMES.search(line) for line in lines[: found[0]]):
        return SURE
    following = lines[found[0] + 1 : found[0] + 4]
    return LIKELY if any(line.strip().startswith("(time in") for line in following) else IMPOSSIBLE


def pospac_layout(path: Path) -> TextLayout:
    """Text layout from the line of column names and the line of units.

    Raises
    ------
    InputError
        If there is no line of column names, or a column is in degrees and minutes or clock time.
    """
    lines = first_lines(path)
    found = _names_line(lines)
    if found is None:
        # Reading the first line detects a missing, empty or binary file.
        next(numbered_lines(path, "POSPac text"), None)
        raise InputError(error("trajectory.pospac_header", file=str(path)))
    start, names = found
    units_line = next(
        (line for line in lines[start + 1 : start + 5] if line.strip().startswith("(")), ""
    )
    units = _units_by_group(units_line)
    columns: list[Column] = []
    file_warnings: list[Message] = []
    for index, name in enumerate(names):
        role = role_of(name)
        if not role or any(column.role == role for column in columns):
            continue
        unit = units.get(_unit_group(role), "")
        if not unit:
            unit = default_unit(role)
            file_warnings.append(unit_assumed_warning(path, name.lower(), unit))
        if unit in ("dms", "clock"):
            raise InputError(
                error("trajectory.pospac_notation", file=str(path), column=name.lower())
            )
        columns.append(Column(role, index, name, unit))
    facts: dict[str, Fact] = {"Header": note("fact.pospac")}
    for line in lines[:start]:
        key, colon, value = line.strip().partition(":")
        if colon and key.strip() in _FACT_NAMES and value.strip():
            facts[_FACT_NAMES[key.strip()]] = value.strip().rstrip(";").strip()
    velocities = velocity_columns(names, [units.get("velocity", "")] * len(names))
    return TextLayout(
        tuple(columns), names, split_fields, pospac_rows, facts, tuple(file_warnings), velocities
    )


def pospac_rows(path: Path) -> Rows:
    """Split the rows of data; everything up to the line of column names is skipped.

    Raises
    ------
    InputError
        If a row below the column names does not consist of numbers.
    """
    found = _names_line(first_lines(path))
    start = found[0] + 1 if found else 0
    for row, line in numbered_lines(path, "POSPac text"):
        if row <= start or not line.strip():
            continue
        fields = split_fields(line)
        if line.strip().startswith("("):
            continue
        if not is_data_row(fields):
            text = line.strip()[:40]
            raise InputError(error("trajectory.not_a_row", file=str(path), row=row, text=text))
        yield row, fields


def preview_pospac(path: Path, choice: Choice) -> FilePreview:
    """Header, first rows and warnings."""
    path = Path(path)
    layout = pospac_layout(path)
    found = {"crs": "", "time": "gps-week"} | dict(choice)
    return preview_text(path, layout, _conventions(layout, found), found)


def _names_line(lines: list[str]) -> tuple[int, tuple[str, ...]] | None:
    """Index of the line of column names, and the names."""
    for index, line in enumerate(lines):
        if not line.strip().upper().startswith("TIME") or line.count(",") < 4:
            continue
        names = tuple(name.strip() for name in line.split(","))
        if sum(bool(role_of(name)) for name in names) >= 5:
            return index, names
    return None


def _units_by_group(line: str) -> dict[str, str]:
    """Unit of each group of columns, from the line in parentheses."""
    units: dict[str, str] = {}
    for what, unit in _GROUP_AND_UNIT.findall(line):
        words = what.lower()
        key = "m" if unit.lower() == "m" else parse_unit(unit)
        if unit.lower().startswith("sec"):
            key = "s"
        if "position sd" in words:
            units["position_sd"] = key
        elif "orientation" in words:
            units.setdefault("attitude", key)
            if "sd" in words:
                units["attitude_sd"] = key
        elif "lat" in words:
            units["geographic"] = key
        elif "position" in words:
            units["position"] = key
        elif "velocity" in words:
            units["velocity"] = key
        elif "time" in words:
            units["time"] = key
    return units


def _unit_group(role: str) -> str:
    """Group in the line of units to which a column of a role belongs."""
    if role in ("latitude", "longitude"):
        return "geographic"
    if role.removesuffix("_sd") in ("roll", "pitch", "heading"):
        return "attitude_sd" if role.endswith("_sd") else "attitude"
    if role.endswith("_sd"):
        return "position_sd"
    return role if role == "time" else "position"


def _conventions(layout: TextLayout, choice: Choice) -> TrajectoryConventions:
    roles = {column.role for column in layout.columns}
    geographic = roles.issuperset({"latitude", "longitude"})
    return TrajectoryConventions(
        time=choice.get("time", "gps-week"), crs="" if geographic else choice.get("crs", "")
    )


POSPAC_OPTIONS = (TIME_OPTION, GRID_SYSTEM_OPTION)
POSPAC_FORMAT, POSPAC_ACCURACY_FORMAT = described_text_formats(
    ("pospac-text", note("format.pospac")),
    ("pospac-sigmas", note("format.pospac_sigmas")),
    POSPAC_OPTIONS,
    sniff_pospac,
    pospac_layout,
    preview_pospac,
    _conventions,
)
