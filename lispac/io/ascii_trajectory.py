"""Trajectories in any text: the user, or a row of names, says what each column is.

The column names, from the left, are the mapping; the project file keeps them as they are, so that
the next file of the same kind is read without asking.
"""

import re
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.exail import unit_of
from lispac.io.registry import LIKELY, NOT, POSSIBLE, Choice, Finding
from lispac.io.text_table import (
    fields_of,
    first_lines,
    is_clock,
    is_data,
    is_number,
    lines_of,
    number,
)
from lispac.io.trajectory_columns import (
    GRID,
    HEIGHTS,
    HEMISPHERES,
    ROLES,
    SIGMAS,
    Column,
    Conventions,
    Rows,
    role_of,
    trajectory_of,
)
from lispac.io.trajectory_grid import UNSTATED
from lispac.io.trajectory_preview import TextLayout, look_at_text
from lispac.io.trajectory_velocities import velocity_columns
from lispac.survey.trajectory import Trajectory

DEFAULT_COLUMNS = "time latitude longitude height roll pitch heading"
DEFAULTS = {
    "columns": DEFAULT_COLUMNS,
    "separator": "auto",
    "header": "auto",
    "position": "degrees",
    "attitude": "degrees",
    "grid_unit": "",
    "heights": "",
    "roll": "starboard-down",
    "pitch": "bow-up",
    "heading": "true",
    "crs": "",
    "time": "gps-week",
}
_ANGLES = {"degrees": "deg", "radians": "rad", "dms": "dms", "degrees-minutes": "ddmm"}
_LENGTHS = {
    "": UNSTATED,
    "metres": "m",
    "feet": "ft",
    "international-feet": "int-ft",
    "us-survey-feet": "us-ft",
}
LENGTH_CHOICES = tuple(_LENGTHS)
_TIME_UNIT = re.compile(r"[\[(]\s*(ms|us|ns)\s*[\])]|_(ms|us|ns)$", re.IGNORECASE)
_WEST = re.compile(r"[\[(][^\])]*\b(w|west)\b[^\])]*[\])]|_w$|west", re.IGNORECASE)
"""In the name of longitudes that are positive to the west."""
_COMMENT = ("#", "%", "//", ";")


def sniff_ascii(path: Path) -> float:
    """How likely this is a trajectory: a row of names that mean one, or enough numbers a row."""
    lines = first_lines(path, 60)
    names = _header_names(lines)
    data = [fields for line in lines if is_data(fields := _split(line, "auto"))]
    if not data:
        return NOT
    found = {role_of(_bare(name)) for name in names}
    if found.issuperset({"time", "roll", "pitch", "heading"}):
        return LIKELY
    width = len(data[0])
    even = all(len(fields) == width for fields in data[:20])
    numeric = sum(is_number(field) or is_clock(field) for field in data[0])
    return POSSIBLE if even and numeric >= 7 else NOT


def layout_of(path: Path, choice: Choice) -> TextLayout:
    """Columns as the user names them.

    Raises
    ------
    InputError
        Where a name is unknown or given twice.
    """
    chosen = DEFAULTS | dict(choice)
    tokens = [token for token in re.split(r"[\s,;]+", chosen["columns"].strip()) if token]
    separator, header = chosen["separator"], chosen["header"]
    _, sample = next(ascii_rows(path, separator, header), (0, []))
    titles = _header_names(first_lines(path, 60))
    columns: list[Column] = []
    for index, token in enumerate(tokens):
        if token in ("-", "_", "skip"):
            continue
        role = role_of(token) or (token if token in SIGMAS else "")
        if not role:
            raise InputError(
                f"{path}: there is no column called {token!r}; name each column from the left as "
                f"one of {', '.join(sorted(set(ROLES.values())))}, and - for others."
            )
        if any(column.role == role for column in columns):
            raise InputError(f"{path}: two columns are named {token}; name each once.")
        field = sample[index] if index < len(sample) else ""
        title = titles[index] if len(titles) == len(tokens) else ""
        columns.append(Column(role, index, token, _unit(role, field, chosen, title)))

    def rows(path: Path) -> Rows:
        return ascii_rows(path, separator, header)

    velocities = velocity_columns([_bare(name) for name in titles], [unit_of(n) for n in titles])
    return TextLayout(
        tuple(columns), tuple(tokens), separator, rows, {"Header": "generic text"}, (), velocities
    )


def ascii_rows(path: Path, separator: str = "auto", header: str = "auto") -> Rows:
    """Rows of data, split; comments and rows before the first of numbers are passed over.

    Parameters
    ----------
    header : str
        Rows to pass over at the head; ``auto`` up to the first that looks like data.

    Raises
    ------
    InputError
        Where ``header`` is neither ``auto`` nor a number.
    """
    if header != "auto" and not header.isdecimal():
        raise InputError(f"{path}: {header!r} is not a number of header rows; state one, or auto.")
    skipped = int(header) if header != "auto" else 0
    started = header != "auto"
    for row, line in lines_of(path, "text"):
        if row <= skipped or not line.strip() or line.lstrip().startswith(_COMMENT):
            continue
        fields = _split(line, separator)
        started = started or is_data(fields)
        if started:
            yield row, fields


def look_ascii(path: Path, choice: Choice) -> Finding:
    """Detected columns and units, first rows and doubts."""
    path = Path(path)
    # Reading the first line tells a missing, empty or binary file.
    next(lines_of(path, "text"), None)
    detected, doubts = _detected(path, choice)
    found = DEFAULTS | detected | dict(choice)
    layout = layout_of(path, found)
    finding = look_at_text(path, layout, _conventions(found), found)
    return replace(finding, choice=found, doubts=(*doubts, *finding.doubts))


def read_ascii(path: Path, choice: Choice) -> Trajectory:
    """Read the trajectory by the columns and conventions chosen; nothing is detected here.

    Raises
    ------
    InputError
    """
    path = Path(path)
    layout = layout_of(path, choice)
    said = (f"text with the columns {' '.join(layout.names)}",)
    return trajectory_of(
        path, layout.rows(path), layout.columns, _conventions(DEFAULTS | dict(choice)), said
    )


def _split(line: str, separator: str) -> list[str]:
    return [] if line.lstrip().startswith(_COMMENT) else fields_of(line, separator)


def _bare(name: str) -> str:
    """A name without its unit in brackets or parentheses, or after an underscore."""
    return re.sub(r"[\[(].*|_(s|ms|us|ns|deg|rad|m|ft|w)$", "", name, flags=re.IGNORECASE)


def _header_names(lines: list[str]) -> list[str]:
    """Names in the last row before the data that has at least three that mean something."""
    names: list[str] = []
    for line in lines:
        if is_data(_split(line, "auto")):
            break
        bare = line.strip().lstrip("#%/; \t")
        fields = fields_of(bare)
        if sum(bool(role_of(_bare(name))) for name in fields) >= 3:
            names = fields
    return names


def _unit(role: str, field: str, chosen: dict[str, str], title: str) -> str:
    """Unit of a column by its role, first value, the options, and its name in the file."""
    if role == "time":
        mark = _TIME_UNIT.search(title)
        return "clock" if is_clock(field) else (mark[1] or mark[2]).lower() if mark else "s"
    if role in HEMISPHERES:
        return "hemisphere"
    if role == "longitude" and _WEST.search(title):
        return f"{_ANGLES[chosen['position']]}-west"
    if role == "date":
        return "date"
    if role in ("latitude", "longitude"):
        return _ANGLES[chosen["position"]]
    if role.removesuffix("_sd") in ("roll", "pitch", "heading"):
        return _ANGLES[chosen["attitude"]]
    if role in GRID:
        return _LENGTHS[chosen["grid_unit"]]
    return _LENGTHS[chosen["heights"]] if role in HEIGHTS else "m"


def _conventions(chosen: dict[str, str]) -> Conventions:
    return Conventions(
        **{name: chosen[name] for name in ("pitch", "roll", "time", "heading", "crs")}
    )


def _detected(path: Path, choice: Choice) -> tuple[dict[str, str], list[str]]:
    """Columns, units and time base by a row of names and by the first values."""
    lines = first_lines(path, 60)
    names = _header_names(lines)
    found: dict[str, str] = {}
    doubts: list[str] = []
    if names:
        found["columns"] = " ".join(_tokens(names))
        for option, meant, units in (
            ("position", {"latitude"}, _ANGLES),
            ("attitude", {"roll", "heading"}, _ANGLES),
            ("heights", set(HEIGHTS), _LENGTHS),
            ("grid_unit", set(GRID), _LENGTHS),
        ):
            stated = {unit_of(name) for name in names if role_of(_bare(name)) in meant} - {""}
            word = next((word for word, unit in units.items() if stated == {unit}), "")
            if word:
                found[option] = word
    elif "columns" not in choice:
        doubts.append(
            f"No row names the columns; {DEFAULT_COLUMNS} is taken: state the columns if they "
            "differ."
        )
    tokens = (choice.get("columns") or found.get("columns") or DEFAULT_COLUMNS).split()
    separator = choice.get("separator", "auto")
    data = [fields for line in lines if is_data(fields := _split(line, separator))]
    if names and "columns" not in choice:
        tokens = _hemispheres(tokens, data)
        found["columns"] = " ".join(tokens)
    values = {
        role_of(token): column
        for index, token in enumerate(tokens)
        if (column := _values(data, index)) is not None
    }
    _detect_units(values, found, choice, doubts)
    roles = {role_of(token) for token in tokens}
    clocks = "time" in roles and "time" not in values
    if "date" in roles:
        found["time"] = "unix"
    elif clocks:
        found["time"] = "utc-day"
    if (clocks or "date" in roles) and "time" not in choice:
        doubts.append("The file does not say whether its times are UTC; UTC is taken.")
    for option, words in (("roll", "starboard down"), ("pitch", "bow up")):
        if option not in choice:
            doubts.append(f"The file does not say the sign of {option}; positive {words} is taken.")
    return found, doubts


def _tokens(names: list[str]) -> list[str]:
    """Role of each column; the exact name of a role goes before its synonyms."""
    bares = [_bare(name) for name in names]
    exact = {bare.strip().lower() for bare in bares} & set(ROLES.values())
    taken: set[str] = set()
    tokens = []
    for bare in bares:
        role = role_of(bare)
        waits = role in exact and bare.strip().lower() != role
        tokens.append(role if role and role not in taken and not waits else "-")
        taken |= set() if waits else {role}
    return tokens


def _hemispheres(tokens: list[str], data: list[list[str]]) -> list[str]:
    """Columns without a meaning whose values are letters of hemispheres, by their values."""
    found = list(tokens)
    for index, token in enumerate(tokens):
        letters = {row[index].strip().upper() for row in data if index < len(row)}
        for role, own in zip(HEMISPHERES, ({"N", "S"}, {"E", "W"}), strict=True):
            if token == "-" and role not in found and letters and letters <= own:
                found[index] = role
    return found


def _values(data: list[list[str]], index: int) -> NDArray[np.float64] | None:
    """First values of a column; None where they are not numbers."""
    fields = [row[index] for row in data if index < len(row)]
    if not fields or not all(is_number(field) for field in fields):
        return None
    values = np.array([number(field) for field in fields])
    return values if np.isfinite(values).all() else None


def _detect_units(
    values: dict[str, NDArray[np.float64]],
    found: dict[str, str],
    choice: Choice,
    doubts: list[str],
) -> None:
    if "latitude" in values and "longitude" in values:
        largest = max(np.abs(values["latitude"]).max(), np.abs(values["longitude"]).max())
        both = np.concatenate([values["latitude"], values["longitude"]])
        if largest > 360 and (np.abs(both) % 100 < 60).all():
            found.setdefault("position", "degrees-minutes")
        _settle("position", largest, found, choice, doubts)
    elif {"latitude", "longitude"} & set(values) == set() and "easting" not in values:
        found.setdefault("position", "dms")
    if "heading" in values:
        _settle("attitude", np.abs(values["heading"]).max(), found, choice, doubts)


def _settle(
    option: str, largest: float, found: dict[str, str], choice: Choice, doubts: list[str]
) -> None:
    """Degrees where values exceed a full circle in radians, else radians, which is said."""
    if option in found or option in choice:
        return
    found[option] = "degrees" if largest > 2 * np.pi else "radians"
    if found[option] == "radians":
        doubts.append(
            f"The first values of {option} stay within a full circle of radians, so radians are "
            "taken; state degrees if they are."
        )
