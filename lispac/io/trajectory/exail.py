"""Reading of text exports of Exail (iXblue) post-processing: APPS and Delph INS.

These exports are made from templates, so that their columns differ; the header describes them.
Comment lines give the name, the meaning and the unit of each column, and the last one all names:

    # latitude: Latitude, decimal degree
    # heading: Heading, degree
    #date   time   latitude   longitude   ellipsoidHeight   heading   roll   pitch

The reader uses these names and units, never the position of a column. The header does not specify
signs; iXblue's convention is roll positive port side up and pitch positive bow down.
"""

import re
from dataclasses import replace
from functools import partial
from pathlib import Path

from lispac.errors import InputError
from lispac.io.format_types import IMPOSSIBLE, LIKELY, SURE, Choice, Fact, FilePreview, FormatOption
from lispac.io.text.text_table import first_lines, is_clock, numbered_lines, split_fields
from lispac.io.trajectory.trajectory_columns import (
    HEMISPHERE_ROLES,
    POSITION_ROLES,
    SIGN_NAMES,
    Column,
    Rows,
    TrajectoryConventions,
    default_unit,
    role_of,
    unit_assumed_warning,
)
from lispac.io.trajectory.trajectory_options import (
    GRID_SYSTEM_OPTION,
    PITCH_OPTION,
    ROLL_OPTION,
    TIME_OPTION,
    described_text_formats,
)
from lispac.io.trajectory.trajectory_preview import (
    TextLayout,
    preview_text,
    sign_assumed_warning,
)
from lispac.io.trajectory.trajectory_velocities import velocity_columns
from lispac.io.units import direction_of, parse_unit
from lispac.messages import error, note, warning
from lispac.survey.line_source import printable

_MANUFACTURER_NAMES = re.compile(r"delph|ixblue|ixsea|exail|\bapps\b", re.IGNORECASE)
_COLUMN_DESCRIPTION = re.compile(r"#\s*(\w+)\s*:\s*(.+)")
_SIGN_PATTERNS = {
    "bow-up": r"(bow|nose) up|up (bow|nose)",
    "bow-down": r"(bow|nose) down|down (bow|nose)",
    "starboard-down": r"port( side)? up|left( side)? up|starboard( side)? down|right( side)? down",
    "port-down": r"starboard( side)? up|right( side)? up|port( side)? down|left( side)? down",
}


def sniff_exail(path: Path) -> float:
    """Likelihood of an Exail export, by the manufacturer and columns named in its comments."""
    comments = [line for line in first_lines(path) if line.startswith("#")]
    if not comments:
        return IMPOSSIBLE
    names = _column_names(comments)
    if len({role_of(name) for name in names} - {""}) < 5:
        return IMPOSSIBLE
    if any(_MANUFACTURER_NAMES.search(line) for line in comments):
        return SURE
    # Only these templates describe one column per line; other files also have a row of names.
    described = sum(_COLUMN_DESCRIPTION.match(line) is not None for line in comments)
    return LIKELY if described >= 5 else IMPOSSIBLE


def exail_layout(path: Path) -> TextLayout:
    """Text layout from the comment lines at the top.

    Raises
    ------
    InputError
        If no comment line names columns.
    """
    lines = first_lines(path)
    comments = [line for line in lines if line.startswith("#")]
    names = _column_names(comments)
    if not names:
        # Reading the first line detects a missing, empty or binary file.
        next(numbered_lines(path, "Exail text"), None)
        raise InputError(error("trajectory.exail_header", file=str(path)))
    described = {
        match[1].lower(): match[2]
        for line in comments
        if (match := _COLUMN_DESCRIPTION.match(line))
    }
    sample = next((line for line in lines if line.strip() and not line.startswith("#")), "")
    separator = "tab" if "\t" in sample else "auto"
    fields = split_fields(sample, separator)
    columns, file_warnings = [], []
    for index, name in enumerate(names):
        role = role_of(name)
        if not role:
            continue
        words = described.get(name.lower(), "")
        if role == "sea_height" and "ellips" in words.lower():
            role = "height"
        unit = "hemisphere" if role in HEMISPHERE_ROLES else parse_unit(words)
        direction = direction_of(f"{name} [{words}]") if role in POSITION_ROLES else ""
        if (role, direction) in (("longitude", "west"), ("latitude", "south")):
            unit = f"{unit or 'deg'}-{direction}"
        if role == "time" and index < len(fields):
            unit = "clock" if is_clock(fields[index]) else unit or "s"
        if not unit:
            unit = default_unit(role)
            file_warnings.append(unit_assumed_warning(path, name, unit))
        columns.append(Column(role, index, name, unit))
    facts: dict[str, Fact] = {"Header": comments[0].lstrip("# ").strip() or note("fact.no_title")}
    signs = {
        column.role: sign
        for column in columns
        if (sign := sign_in_description(described.get(column.name.lower(), "")))
    }
    for angle, sign in signs.items():
        facts[f"Sign of {angle}"] = SIGN_NAMES[sign]
    units = [parse_unit(described.get(name.lower(), "")) for name in names]
    return TextLayout(
        tuple(columns), names, partial(split_fields, separator=separator), exail_rows, facts,
        tuple(file_warnings), velocity_columns(names, units), signs,
    )  # fmt: skip


def sign_in_description(words: str) -> str:
    """Sign in a description (``positive bow down``), as an option value; empty if there is none."""
    if "positive" not in words.lower() and "+" not in words:
        return ""
    return next(
        (sign for sign, form in _SIGN_PATTERNS.items() if re.search(form, words.lower())), ""
    )


def exail_rows(path: Path) -> Rows:
    """Split the rows of data into columns."""
    separator = ""
    for row, line in numbered_lines(path, "Exail text"):
        if not line.strip() or line.startswith("#"):
            continue
        separator = separator or ("tab" if "\t" in line else "auto")
        yield row, split_fields(line, separator)


def preview_exail(path: Path, choice: Choice) -> FilePreview:
    """Header, first rows, detected options and warnings."""
    path = Path(path)
    layout = exail_layout(path)
    found = _detect_options(layout) | dict(choice)
    finding = preview_text(path, layout, _conventions(layout, found), found)
    file_warnings = list(finding.file_warnings)
    for angle in ("roll", "pitch"):
        if angle not in layout.signs and angle not in choice:
            file_warnings.append(sign_assumed_warning(path, angle, found[angle]))
    if any(column.unit == "clock" for column in layout.columns) and "time" not in choice:
        file_warnings.append(warning("times.utc_assumed", file=printable(path.name)))
    return replace(finding, choice=found, file_warnings=tuple(file_warnings))


def _column_names(comments: list[str]) -> tuple[str, ...]:
    """Column names in the last comment line with at least three known names."""
    for line in reversed(comments):
        names = split_fields(line.lstrip("# \t"), "tab" if "\t" in line.strip() else "auto")
        if sum(bool(role_of(name)) for name in names) >= 3:
            return tuple(names)
    return ()


def _detect_options(layout: TextLayout) -> dict[str, str]:
    roles = {column.role: column for column in layout.columns}
    time = "gps-week"
    if "date" in roles:
        time = "unix"
    elif "time" in roles and roles["time"].unit == "clock":
        time = "utc-day"
    return {
        "pitch": layout.signs.get("pitch", "bow-down"),
        "roll": layout.signs.get("roll", "starboard-down"),
        "time": time,
    }


def _conventions(layout: TextLayout, choice: Choice) -> TrajectoryConventions:
    geographic = {column.role for column in layout.columns}.issuperset(POSITION_ROLES)
    return TrajectoryConventions(
        pitch=choice["pitch"],
        roll=choice["roll"],
        time=choice["time"],
        crs="" if geographic else choice.get("crs", ""),
    )


EXAIL_OPTIONS = (
    FormatOption(PITCH_OPTION.name, PITCH_OPTION.meaning, PITCH_OPTION.choices, "bow-down"),
    ROLL_OPTION,
    FormatOption(TIME_OPTION.name, TIME_OPTION.meaning, TIME_OPTION.choices, "unix"),
    GRID_SYSTEM_OPTION,
)
EXAIL_FORMAT, EXAIL_ACCURACY_FORMAT = described_text_formats(
    ("exail-text", note("format.exail")),
    ("exail-sigmas", note("format.exail_sigmas")),
    EXAIL_OPTIONS,
    sniff_exail,
    exail_layout,
    preview_exail,
    lambda layout, choice: _conventions(layout, _detect_options(layout) | dict(choice)),
    has_time_base=True,  # the exports contain dates, or are in UTC
)
