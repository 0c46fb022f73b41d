"""Reading of trajectories in any text format, with columns named by the user or a header row.

The mapping is the list of column names from the left. The project file stores it unchanged, so that
the next file of the same kind can be read without a question to the user.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import islice
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.format_types import (
    IMPOSSIBLE,
    LIKELY,
    POSSIBLE,
    SURE,
    Choice,
    FilePreview,
    FormatOption,
)
from lispac.io.text.text_export import options_in_header
from lispac.io.text.text_table import (
    SEPARATOR_NAMES,
    first_lines,
    is_clock,
    is_data_row,
    is_number,
    numbered_lines,
    parse_number,
    split_fields,
)
from lispac.io.trajectory.trajectory_columns import (
    ATTITUDE_ROLES,
    GRID_ROLES,
    HEIGHT_ROLES,
    HEMISPHERE_ROLES,
    POSITION_ROLES,
    ROLES_BY_COLUMN_NAME,
    SIGMA_ROLES,
    Column,
    Rows,
    TrajectoryConventions,
    role_of,
    trajectory_of,
)
from lispac.io.trajectory.trajectory_options import (
    PITCH_OPTION,
    ROLL_OPTION,
    TIME_OPTION,
    trajectory_format,
)
from lispac.io.trajectory.trajectory_preview import TextLayout, preview_text, sign_assumed_warning
from lispac.io.trajectory.trajectory_projection import UNSPECIFIED_UNIT
from lispac.io.trajectory.trajectory_velocities import velocity_columns
from lispac.io.units import (
    ANGLE_UNIT_CODES,
    UNKNOWN,
    direction_of,
    is_units_row,
    split_title,
    title_unit,
    titles_with_units,
)
from lispac.language import N_
from lispac.messages import Action, Level, Message, Value, error, note, warning
from lispac.survey.line_source import printable
from lispac.survey.trajectory import Trajectory
from lispac.untrusted_values import is_whole_number

COLUMNS_ASSUMED_CODE = "trajectory.columns_assumed"
"""Code of the warning that a file does not name its columns, so that they are assumed."""
DEFAULT_COLUMNS = "time latitude longitude height roll pitch heading"
DEFAULT_OPTIONS = {
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
UNIT_IN_HEADER = "header"
"""Value of a unit option: the unit specified in the title of each column."""
_ANGLE_UNIT_BY_OPTION = {
    "degrees": "deg",
    "radians": "rad",
    "dms": "dms",
    "degrees-minutes": "ddmm",
}
_LENGTH_UNIT_BY_OPTION = {
    "": UNSPECIFIED_UNIT,
    "metres": "m",
    "feet": "ft",
    "international-feet": "int-ft",
    "us-survey-feet": "us-ft",
}
POSITION_CHOICES = (*_ANGLE_UNIT_BY_OPTION, UNIT_IN_HEADER)
ATTITUDE_CHOICES = ("degrees", "radians", UNIT_IN_HEADER)
LENGTH_CHOICES = (*_LENGTH_UNIT_BY_OPTION, UNIT_IN_HEADER)
MAX_HEADER_ROWS = 10**9
_COMMENT_MARKS = ("#", "%", "//", ";")


def sniff_ascii(path: Path) -> float:
    """Likelihood that a text is a trajectory, by its column names or the numbers per row."""
    lines = first_lines(path, 60)
    if options_in_header(lines):
        return SURE
    names = _header_names(lines)
    data = [fields for line in lines if is_data_row(fields := _split_row(line, "auto"))]
    if not data:
        return IMPOSSIBLE
    found = {role_of(_name_without_unit(name)) for name in names}
    if found.issuperset({"time", "roll", "pitch", "heading"}):
        return LIKELY
    width = len(data[0])
    has_equal_widths = all(len(fields) == width for fields in data[:20])
    numeric = sum(is_number(field) or is_clock(field) for field in data[0])
    return POSSIBLE if has_equal_widths and numeric >= 7 else IMPOSSIBLE


def layout_by_choice(path: Path, choice: Choice) -> TextLayout:
    """Text layout with the columns chosen by the user.

    Raises
    ------
    InputError
        If a name is unknown or given twice.
    """
    chosen = DEFAULT_OPTIONS | dict(choice)
    tokens = [token for token in re.split(r"[\s,;]+", chosen["columns"].strip()) if token]
    separator, header = chosen["separator"], chosen["header"]
    _, sample = next(ascii_rows(path, separator, header), (0, []))
    titles = _header_names(first_lines(path, 60))
    columns: list[Column] = []
    for index, token in enumerate(tokens):
        if token in ("-", "_", "skip"):
            continue
        role = role_of(token) or (token if token in SIGMA_ROLES else "")
        if not role:
            known = sorted(set(ROLES_BY_COLUMN_NAME.values()))
            raise InputError(
                error("trajectory.unknown_column", file=str(path), column=token, known=tuple(known))
            )
        if any(column.role == role for column in columns):
            raise InputError(error("text.duplicate_columns", file=str(path), names=(token,)))
        field = sample[index] if index < len(sample) else ""
        title = titles[index] if len(titles) == len(tokens) else ""
        columns.append(Column(role, index, token, _column_unit(role, token, field, chosen, title)))

    def rows(path: Path) -> Rows:
        return ascii_rows(path, separator, header)

    velocities = velocity_columns(
        [_name_without_unit(name) for name in titles], [title_unit(name) for name in titles]
    )
    return TextLayout(
        tuple(columns), tuple(tokens), partial(_split_row, separator=separator), rows,
        {"Header": note("fact.text")}, (), velocities,
    )  # fmt: skip


def ascii_rows(path: Path, separator: str = "auto", header: str = "auto") -> Rows:
    """Split rows of data; comments and rows before the first row of data are skipped.

    Parameters
    ----------
    header : str
        Number of rows to skip at the top; ``auto`` for those before the first that looks like data.

    Raises
    ------
    InputError
        If ``header`` is neither ``auto`` nor a number.
    """
    if header != "auto" and not is_whole_number(header, MAX_HEADER_ROWS):
        raise InputError(error("trajectory.header_rows", file=str(path), value=header))
    skipped = int(header) if header != "auto" else 0
    started = header != "auto"
    for row, line in numbered_lines(path, "text"):
        if row <= skipped or not line.strip() or line.lstrip().startswith(_COMMENT_MARKS):
            continue
        fields = _split_row(line, separator)
        started = started or is_data_row(fields)
        if started:
            yield row, fields


def preview_ascii(path: Path, choice: Choice) -> FilePreview:
    """Detected columns and units, first rows and warnings."""
    path = Path(path)
    # Reading the first line detects a missing, empty or binary file.
    next(numbered_lines(path, "text"), None)
    detected, file_warnings = _detect_options(path, choice)
    found = DEFAULT_OPTIONS | detected | dict(choice)
    layout = layout_by_choice(path, found)
    finding = preview_text(path, layout, _conventions(found), found)
    titles = _header_names(first_lines(path, 60))
    return replace(
        finding,
        choice=found,
        file_warnings=(*file_warnings, *finding.file_warnings),
        messages=(*finding.messages, *_header_messages(path, titles, choice)),
    )


def read_ascii(path: Path, choice: Choice) -> Trajectory:
    """Read the trajectory by the chosen columns and conventions, without detection.

    Raises
    ------
    InputError
        If the file is damaged or a value is not possible.
    """
    path = Path(path)
    layout = layout_by_choice(path, choice)
    column_note = note("assumed.given_columns", columns=layout.names)
    return trajectory_of(
        path,
        layout.rows(path),
        layout.columns,
        _conventions(DEFAULT_OPTIONS | dict(choice)),
        (column_note,),
    )


def _split_row(line: str, separator: str) -> list[str]:
    return [] if line.lstrip().startswith(_COMMENT_MARKS) else split_fields(line, separator)


def _name_without_unit(title: str) -> str:
    """Name of a column without its unit."""
    return split_title(title)[0]


def _header_names(lines: list[str]) -> list[str]:
    """Column titles: the last row before the data with at least three known names.

    Units in a row between the names and the data are appended to the names.
    """
    titles: list[str] = []
    for line in lines:
        if is_data_row(_split_row(line, "auto")):
            break
        bare = line.strip().lstrip("#%/; \t")
        fields = split_fields(bare)
        if sum(bool(role_of(_name_without_unit(name))) for name in fields) >= 3:
            titles = fields
        elif titles and is_units_row(fields) and len(fields) == len(titles):
            titles = titles_with_units(titles, fields)
    return titles


def _column_unit(role: str, token: str, field: str, chosen: dict[str, str], title: str) -> str:
    """Unit of a column from its role, its given name, first value, options and title."""
    if role == "time":
        return "clock" if is_clock(field) else _unit_in_title(title).partition(UNKNOWN)[0] or "s"
    if role == "latitude_hemisphere":
        return "hemisphere"
    if role == "longitude_hemisphere":
        letters = {"".join(c for c in name.lower() if c.isalpha()) for name in (title, token)}
        is_french, is_german = letters & {"eo", "oe"}, letters & {"ow", "wo"}
        return "hemisphere-fr" if is_french else "hemisphere-de" if is_german else "hemisphere"
    if role == "date":
        return "date"
    if role in POSITION_ROLES:
        unit = _angle_unit(chosen["position"], title)
        direction = direction_of(title)
        if direction == UNKNOWN:
            return f"{UNKNOWN}{split_title(title)[1]}"
        is_reversed = (role, direction) in (("longitude", "west"), ("latitude", "south"))
        return f"{unit}-{direction}" if is_reversed and not unit.startswith(UNKNOWN) else unit
    if role.removesuffix("_sd") in ATTITUDE_ROLES:
        return _angle_unit(chosen["attitude"], title)
    if role in GRID_ROLES:
        return _length_unit(chosen["grid_unit"], title)
    return (
        _length_unit(chosen["heights"], title)
        if role in HEIGHT_ROLES
        else _unit_in_title(title) or "m"
    )


def _unit_in_title(title: str) -> str:
    """Unit in a title; an unknown unit is returned with its text."""
    unit = title_unit(title)
    return f"{UNKNOWN}{split_title(title)[1]}" if unit == UNKNOWN else unit


def _angle_unit(option: str, title: str) -> str:
    return (
        (_unit_in_title(title) or "deg")
        if option == UNIT_IN_HEADER
        else _ANGLE_UNIT_BY_OPTION[option]
    )


def _length_unit(option: str, title: str) -> str:
    return _unit_in_title(title) if option == UNIT_IN_HEADER else _LENGTH_UNIT_BY_OPTION[option]


def _conventions(chosen: dict[str, str]) -> TrajectoryConventions:
    return TrajectoryConventions(
        **{name: chosen[name] for name in ("pitch", "roll", "time", "heading", "crs")}
    )


def _detect_options(path: Path, choice: Choice) -> tuple[dict[str, str], list[Message]]:
    """Detect columns, units and time base from the column names and the first values."""
    lines = first_lines(path, 60)
    if own := options_in_header(lines):
        return own, []
    names = _header_names(lines)
    found: dict[str, str] = {}
    file_warnings: list[Message] = []
    file = printable(path.name)
    if names:
        _require_single_angle_columns(path, names)
        found["columns"] = " ".join(_column_roles(names))
        found |= _unit_options(names)
    elif "columns" not in choice:
        file_warnings.append(
            warning(COLUMNS_ASSUMED_CODE, file=file, columns=DEFAULT_COLUMNS.split())
        )
    tokens = (choice.get("columns") or found.get("columns") or DEFAULT_COLUMNS).split()
    separator = choice.get("separator", "auto")
    data = [fields for line in lines if is_data_row(fields := _split_row(line, separator))]
    if names and "columns" not in choice:
        _require_all_columns_named(path, names, lines, separator)
        tokens = _mark_hemisphere_columns(path, tokens, data)
        found["columns"] = " ".join(tokens)
    data = _rows_with_position(path, tokens, data, choice)
    values = {
        role_of(token): column
        for index, token in enumerate(tokens)
        if (column := _column_values(data, index)) is not None
    }
    written = {
        role_of(token): [fields[index] for fields in data if index < len(fields)]
        for index, token in enumerate(tokens)
        if role_of(token) in POSITION_ROLES
    }
    places = written if len(written) == len(POSITION_ROLES) else {}
    file_warnings += _detect_units(values, places, found, choice, file)
    roles = {role_of(token) for token in tokens}
    clocks = "time" in roles and "time" not in values
    if "date" in roles:
        found["time"] = "unix"
    elif clocks:
        found["time"] = "utc-day"
    if (clocks or "date" in roles) and "time" not in choice:
        file_warnings.append(warning("times.utc_assumed", file=file))
    file_warnings += [
        sign_assumed_warning(path, angle, sign)
        for angle, sign in (("roll", "starboard-down"), ("pitch", "bow-up"))
        if angle not in choice
    ]
    return found, file_warnings


def _column_roles(names: list[str]) -> list[str]:
    """Role of each column; the exact name of a role takes precedence over its synonyms."""
    bares = [_name_without_unit(name) for name in names]
    exact = {bare.strip().lower() for bare in bares} & set(ROLES_BY_COLUMN_NAME.values())
    used_roles: set[str] = set()
    tokens = []
    for name, bare in zip(names, bares, strict=True):
        role = role_of(bare)
        if role in HEIGHT_ROLES and title_unit(name) in ANGLE_UNIT_CODES:
            role = ""  # here the elevation is an angle
        is_synonym_of_exact = role in exact and bare.strip().lower() != role
        tokens.append(role if role and role not in used_roles and not is_synonym_of_exact else "-")
        used_roles |= set() if is_synonym_of_exact else {role}
    return tokens


_UNIT_OPTIONS: tuple[tuple[str, tuple[str, ...], dict[str, str]], ...] = (
    ("position", POSITION_ROLES, _ANGLE_UNIT_BY_OPTION),
    ("attitude", ATTITUDE_ROLES, _ANGLE_UNIT_BY_OPTION),
    ("heights", HEIGHT_ROLES, _LENGTH_UNIT_BY_OPTION),
    ("grid_unit", GRID_ROLES, _LENGTH_UNIT_BY_OPTION),
)
"""Options for units: name, roles of the columns, and unit for each value."""


def _unit_options(titles: Sequence[str]) -> dict[str, str]:
    """Unit options for the units specified in the titles."""
    found: dict[str, str] = {}
    for option, roles, units in _UNIT_OPTIONS:
        codes = [
            title_unit(title) for title in titles if role_of(_name_without_unit(title)) in roles
        ]
        if option == "heights":
            codes = [unit for unit in codes if unit not in ANGLE_UNIT_CODES]
        if not any(codes):
            continue
        word = next(
            (word for word, unit in units.items() if set(codes) - {""} == {unit}), UNIT_IN_HEADER
        )
        allowed = ATTITUDE_CHOICES if option == "attitude" else (*units, UNIT_IN_HEADER)
        found[option] = word if word in allowed else UNIT_IN_HEADER
    return found


def _require_single_angle_columns(path: Path, titles: Sequence[str]) -> None:
    """Refuse an angle split into columns of degrees, minutes and seconds.

    Raises
    ------
    InputError
        If several columns contain parts of the same angle.
    """
    parts = {"deg", "min", "sec", "s", "degrees", "minutes", "seconds", "d", "m"}
    for role in POSITION_ROLES:
        titles_of_role = []
        for title in titles:
            spaced = re.sub(r"(?<=[a-z])(?=[A-Z])", " ", title)
            words = re.split(r"[\s_.\[\](){}-]+", spaced.lower().strip(" ])}"))
            bare = [word for word in words if word not in parts]
            if len(bare) < len(words) and role_of("".join(bare)) == role:
                titles_of_role.append(title)
        if len(titles_of_role) > 1:
            raise InputError(
                error(
                    "trajectory.several_columns",
                    file=str(path),
                    role=role,
                    columns=tuple(titles_of_role),
                )
            )


def _require_all_columns_named(
    path: Path, names: Sequence[str], lines: Sequence[str], separator: str
) -> None:
    """Refuse rows with more blank-separated columns than column names.

    Raises
    ------
    InputError
        If a row has more columns than there are names.
    """
    for line in lines:
        fields = _split_row(line, separator)
        between_blanks = separator == "blank" or not any(mark in line for mark in ";,\t")
        if between_blanks and is_data_row(fields) and len(fields) > len(names):
            raise InputError(
                error(
                    "trajectory.unnamed_columns", file=str(path), found=len(fields),
                    named=len(names),
                )
            )  # fmt: skip


def _mark_hemisphere_columns(path: Path, tokens: list[str], data: list[list[str]]) -> list[str]:
    """Find columns of hemisphere letters among the columns without a meaning, by their values.

    Raises
    ------
    InputError
        If the letter O alone does not distinguish east from west.
    """
    found = list(tokens)
    for index, token in enumerate(tokens):
        letters = {row[index].strip().upper() for row in data if index < len(row)}
        if token == "-" and letters == {"O"}:
            raise InputError(error("trajectory.letter_o", file=str(path), column=index + 1))
        if token == "-" and "O" in letters and letters <= {"E", "W", "O"}:
            found[index] = "eo" if "E" in letters else "ow"
        for role, own in zip(HEMISPHERE_ROLES, _HEMISPHERE_WORDS, strict=True):
            if token == "-" and role not in map(role_of, found) and letters and letters <= own:
                found[index] = role
    return found


_HEMISPHERE_WORDS = (
    {"N", "S", "NORTH", "SOUTH", "NORD", "SUD", "SÜD"},
    {"E", "W", "O", "EAST", "WEST", "EST", "OUEST", "OST"},
)
"""Hemisphere letters and words of latitude and of longitude."""
MAX_ROWS_SEARCHED = 200_000
"""Largest number of rows that are searched for the first position."""
SAMPLE_ROWS = 60


def _rows_with_position(
    path: Path, tokens: Sequence[str], data: list[list[str]], choice: Choice
) -> list[list[str]]:
    """Rows with a position; rows of zeros before the first fix are excluded."""
    places = [k for k, token in enumerate(tokens) if role_of(token) in POSITION_ROLES]
    if len(places) < len(POSITION_ROLES):
        return data

    def is_placed(fields: list[str]) -> bool:
        return any(k < len(fields) and not _is_zero(fields[k]) for k in places)

    if not data or is_placed(data[0]):
        return [fields for fields in data if is_placed(fields)]
    rows = ascii_rows(path, choice.get("separator", "auto"), choice.get("header", "auto"))
    found = (fields for _, fields in islice(rows, MAX_ROWS_SEARCHED) if is_placed(fields))
    return list(islice(found, SAMPLE_ROWS)) or data


def _is_zero(field: str) -> bool:
    return is_number(field) and parse_number(field) == 0


def _column_values(data: list[list[str]], index: int) -> NDArray[np.float64] | None:
    """First values of a column; None if they are not numbers."""
    fields = [row[index] for row in data if index < len(row)]
    if not fields or not all(is_number(field) for field in fields):
        return None
    values = np.array([parse_number(field) for field in fields])
    return values if np.isfinite(values).all() else None


def _detect_units(
    values: dict[str, NDArray[np.float64]],
    written: Mapping[str, Sequence[str]],
    units: dict[str, str],
    choice: Choice,
    file: str,
) -> Iterator[Message]:
    """Detect units from the first values, store them in ``units``, and warn about radians.

    Parameters
    ----------
    written : mapping of str to sequence of str
        Fields of latitude and longitude as text.
    """
    if "latitude" in values and "longitude" in values:
        latitude, longitude = np.abs(values["latitude"]), np.abs(values["longitude"])
        largest = float(max(latitude.max(), longitude.max()))
        exceeds_degrees = largest > 360 or min(latitude.max(), longitude.max()) > 90
        minutes = np.concatenate([latitude, longitude]) % 100
        if (exceeds_degrees or _has_padded_degrees(written)) and (minutes < 60).all():
            units.setdefault("position", "degrees-minutes")
        if _is_in_radians("position", largest, units, choice):
            actions = (degrees_action("position"),)
            yield warning("trajectory.position_in_radians", file=file, actions=actions)
    elif not {"latitude", "longitude"} & set(values) and "easting" not in values and written:
        # Degrees in the title do not contradict degrees with hemisphere letters or minutes.
        units["position"] = "degrees-minutes" if _has_padded_degrees(written) else "dms"
    if "heading" in values:
        largest = float(np.abs(values["heading"]).max())
        if _is_in_radians("attitude", largest, units, choice):
            actions = (degrees_action("attitude"),)
            yield warning("trajectory.attitude_in_radians", file=file, actions=actions)


def degrees_action(option: str) -> Action:
    """Action that reads an angle in degrees."""
    return Action("use_degrees", {"name": option, "value": "degrees"})


_PADDED_DEGREES_MINUTES = {
    "latitude": re.compile(r"[NS]?\s*[-+]?\d{4}([.,]\d*)?\s*[NS]?", re.IGNORECASE),
    "longitude": re.compile(r"[EW]?\s*[-+]?\d{5}([.,]\d*)?\s*[EW]?", re.IGNORECASE),
}
"""Patterns of degrees and minutes with leading zeros, as NMEA 0183 prescribes."""


def _has_padded_degrees(written: Mapping[str, Sequence[str]]) -> bool:
    return all(
        form.fullmatch(field.strip())
        for role, form in _PADDED_DEGREES_MINUTES.items()
        for field in written[role]
    )


def _is_in_radians(option: str, largest: float, units: dict[str, str], choice: Choice) -> bool:
    """Detect a missing unit: degrees if a value exceeds 2 pi, else radians; True for radians."""
    if option in units or option in choice:
        return False
    units[option] = "degrees" if largest > 2 * np.pi else "radians"
    return units[option] == "radians"


def _header_messages(path: Path, titles: Sequence[str], choice: Choice) -> Iterator[Message]:
    """Warnings about titles: contradicted by an option, ambiguous, magnetic, unknown unit."""
    file = printable(path.name)
    for option, specified in _unit_options(titles).items():
        given = str(choice.get(option, specified))
        if given == specified or given == "dms" or given in _PRECISE_OPTIONS.get(specified, ()):
            continue
        yield Message(
            "text.unit_overridden", Level.WARNING,
            {"file": file, "option": option, "stated": _titles_with_unit(titles, option),
             "given": given},
            actions=(Action("set_option", {"name": option, "value": specified}),),
        )  # fmt: skip
    roles: dict[str, list[str]] = {}
    for title in titles:
        if role := role_of(_name_without_unit(title)):
            roles.setdefault(role, []).append(title)
    for role, own in roles.items():
        exact = [title for title in own if _name_without_unit(title).strip().lower() == role]
        if len(own) > 1 and len(exact) != 1:
            used = (exact or own)[0]
            yield Message(
                "text.two_columns", Level.WARNING,
                {"file": file, "columns": tuple(own), "used": used},
            )  # fmt: skip
        if role == "heading" and _MAGNETIC_TITLE.search(own[0]):
            params: dict[str, Value] = {"file": file, "column": own[0]}
            yield Message("text.magnetic_heading", Level.WARNING, params)
        if role == "time" and title_unit(own[0]) == UNKNOWN:
            yield Message(
                "text.unknown_unit", Level.WARNING,
                {"file": file, "column": own[0], "used": "seconds"},
            )  # fmt: skip


_MAGNETIC_TITLE = re.compile(r"(?<![a-z])mag", re.IGNORECASE)
_PRECISE_OPTIONS = {"feet": ("international-feet", "us-survey-feet")}
"""Option values that make an imprecise unit in a title precise."""


def _titles_with_unit(titles: Sequence[str], option: str) -> tuple[str, ...]:
    roles = next(own for name, own, _ in _UNIT_OPTIONS if name == option)
    return tuple(
        title
        for title in titles
        if role_of(_name_without_unit(title)) in roles and title_unit(title)
    )


ASCII_FORMAT = trajectory_format(
    note("format.ascii"),
    "ascii-trajectory",
    "trajectory",
    (".txt", ".csv", ".asc", ".pos", ".dat"),
    (
        FormatOption(
            "columns",
            N_(
                "Columns from the left: time, date, latitude, longitude, easting, northing, "
                "height, roll, pitch, heading; - skips a column."
            ),
            (),
            DEFAULT_OPTIONS["columns"],
        ),
        FormatOption("separator", N_("Separator of the columns."), SEPARATOR_NAMES, "auto"),
        FormatOption(
            "header",
            N_("Rows to skip at the beginning. auto: up to the first row of numbers."),
            (),
            "auto",
        ),
        FormatOption(
            "position",
            N_("Unit of latitude and longitude."),
            POSITION_CHOICES,
            "degrees",
        ),
        FormatOption(
            "attitude", N_("Unit of roll, pitch and heading."), ATTITUDE_CHOICES, "degrees"
        ),
        FormatOption(
            "grid_unit",
            N_(
                "Unit of eastings and northings. Empty: that of the coordinate system; feet are "
                "those of the coordinate system where it is in feet."
            ),
            LENGTH_CHOICES,
        ),
        FormatOption(
            "heights",
            N_(
                "Unit of heights. Empty: that of the coordinate system where it has heights, else "
                "metres."
            ),
            LENGTH_CHOICES,
        ),
        PITCH_OPTION,
        ROLL_OPTION,
        FormatOption(
            "heading", N_("North from which the heading counts."), ("true", "grid"), "true"
        ),
        FormatOption("crs", N_("Coordinate system of eastings and northings, such as EPSG:32619.")),
        TIME_OPTION,
    ),
    sniff_ascii,
    preview_ascii,
    read_ascii,
)
