"""Conversion of text columns with known meanings and units to a trajectory or its accuracy."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.io.files import require_increasing
from lispac.io.text.text_table import (
    clock_seconds,
    date_seconds,
    degrees_and_minutes,
    degrees_minutes_seconds,
    hemisphere_sign,
    parse_number,
    parse_with_hemisphere,
    read_columns,
)
from lispac.io.trajectory.trajectory_checks import (
    Numbers,
    require_attitude,
    require_heights,
    require_time_base,
)
from lispac.io.trajectory.trajectory_projection import (
    UNSPECIFIED_UNIT,
    LengthUnit,
    TrajectoryProjection,
    projection_of_text,
    unit_of_heights,
)
from lispac.io.units import ANGLE_UNIT_CODES, METRES_PER_UNIT, UNITS, UNKNOWN
from lispac.messages import Level, Message, error, note
from lispac.survey.known_time_base import base_message
from lispac.survey.line_source import printable
from lispac.survey.time_base import GPS_EPOCH, base_of_key, unroll_times
from lispac.survey.trajectory import Trajectory, TrajectoryAccuracy

Array = NDArray[np.float64]

_NOTATION_PARSERS: dict[str, Callable[[str], float]] = {
    "dms": degrees_minutes_seconds,
    "ddmm": degrees_and_minutes,
    "clock": clock_seconds,
    "date": date_seconds,
}
UNIT_PARSERS = {
    code: (_NOTATION_PARSERS.get(code, parse_number), unit.si) for code, unit in UNITS.items()
}
UNIT_PARSERS[UNSPECIFIED_UNIT] = parse_number, 1.0
UNIT_NAMES = {code: unit.name for code, unit in UNITS.items()}
for _unit in ANGLE_UNIT_CODES:
    for _way, _code in (("west", "unit.positive_west"), ("south", "unit.positive_south")):
        UNIT_PARSERS[f"{_unit}-{_way}"] = UNIT_PARSERS[_unit][0], -UNIT_PARSERS[_unit][1]
        UNIT_NAMES[f"{_unit}-{_way}"] = Message(_code, Level.NOTE, {"unit": UNIT_NAMES[_unit]})
UNIT_PARSERS["hemisphere"] = hemisphere_sign, 1.0
UNIT_PARSERS["hemisphere-fr"] = partial(hemisphere_sign, letter_o="W"), 1.0
UNIT_PARSERS["hemisphere-de"] = partial(hemisphere_sign, letter_o="E"), 1.0
"""Parser of each unit, and the factor to radians, metres or seconds.

For eastings, northings and heights, the coordinate system may change the factor. The letter O means
*ouest* in French and *Ost* in German."""

_COLUMN_NAMES = {
    "time": "time gpstime utctime corrtime timestamp seconds sec tow sow gpstow secondsofweek "
    "timesec zeit temps",
    "date": "date day",
    "latitude": "latitude lat breite latitudes lats",
    "longitude": "longitude lon long lng laenge länge longitudew lonw longitudewest lonwest "
    "westlongitude",
    "latitude_hemisphere": "latitudehemisphere ns northsouth lathemisphere lathemi latdir latns",
    "longitude_hemisphere": "longitudehemisphere ew eastwest lonhemisphere lonhemi londir lonew we "
    "eo oe estouest ow wo ostwest",
    "height": "height ellipsoidheight ellipsoidalheight hell hgt heightell h z ellht höhe hoehe "
    "hauteur altitudeellipsoid ellipsoidaltitude ellipsoidalaltitude altitudeellipsoidal",
    "sea_height": "seaheight altitude alt elevation orthoheight orthometricheight msl orthheight "
    "hmsl",
    "roll": "roll roulis",
    "pitch": "pitch tangage",
    "heading": "heading yaw azimuth hdg trueheading cap",
    "easting": "easting east x e",
    "northing": "northing north y n",
    "north_sd": "northsd northingsd latitudesd latsd sdnorth latitudestd northstd",
    "east_sd": "eastsd eastingsd longitudesd lonsd longsd sdeast longitudestd eaststd",
    "height_sd": "heightsd sdheigh altitudesd ellipsoidheightsd upsd downsd sdheight heightstd "
    "altitudestd",
    "roll_sd": "rollsd sdroll rollstd",
    "pitch_sd": "pitchsd sdpitch pitchstd",
    "heading_sd": "headingsd sdheading hdngsd headingstd yawsd",
}
ROLES_BY_COLUMN_NAME = {
    name: role for role, names in _COLUMN_NAMES.items() for name in names.split()
}
"""Role of a column by its name in lower case, with only letters and digits."""

POSITION_ROLES = ("latitude", "longitude")
HEMISPHERE_ROLES = ("latitude_hemisphere", "longitude_hemisphere")
GRID_ROLES = ("easting", "northing")
HEIGHT_ROLES = ("height", "sea_height")
_NO_FACTORS: Mapping[str, float] = {}
ATTITUDE_ROLES = ("roll", "pitch", "heading")
SIGMA_ROLES = ("north_sd", "east_sd", "height_sd", "roll_sd", "pitch_sd", "heading_sd")


def role_of(name: str) -> str:
    """Role of a column called ``name``; empty if the program does not use it."""
    return ROLES_BY_COLUMN_NAME.get("".join(c for c in name.lower() if c.isalnum()), "")


@dataclass(frozen=True)
class Column:
    """One column of a file: meaning, index, name and unit."""

    role: str
    index: int
    name: str
    unit: str


def default_unit(role: str) -> str:
    """Unit assumed for a column without a unit in the header."""
    if role in ("time", "date"):
        return {"time": "s", "date": "date"}[role]
    if role in (*GRID_ROLES, *HEIGHT_ROLES):
        return UNSPECIFIED_UNIT
    angles = ("latitude", "longitude", "roll", "pitch", "heading")
    return "deg" if role.removesuffix("_sd") in angles else "m"


def unit_assumed_warning(path: Path, name: str, unit: str) -> Message:
    """Warning that a header gives no unit for a column, so that ``unit`` is assumed."""
    return Message(
        _UNIT_ASSUMED_CODES[unit], Level.WARNING, {"file": printable(path.name), "column": name}
    )


_UNIT_ASSUMED_CODES = {
    "s": "trajectory.seconds_assumed", "date": "trajectory.dates_assumed",
    "deg": "trajectory.degrees_assumed", "m": "trajectory.metres_assumed",
    UNSPECIFIED_UNIT: "trajectory.unit_of_system_assumed",
}  # fmt: skip
"""Code of the warning by the unit that is assumed (`default_unit`)."""


@dataclass(frozen=True)
class TrajectoryConventions:
    """Reading options for the conventions that a text trajectory does not specify."""

    pitch: str = "bow-up"
    roll: str = "starboard-down"
    time: str = "gps-week"
    heading: str = "true"
    crs: str = ""

    def assumptions(self) -> tuple[Message, ...]:
        """Notes on the assumed conventions."""
        return (
            note("assumed.time_base", base=base_message(base_of_key(self.time))),
            sign_note(self.roll),
            sign_note(self.pitch),
            note("assumed.heading_true" if self.heading == "true" else "assumed.heading_grid"),
        )


SIGN_NAMES = {
    "starboard-down": note("sign.roll_starboard_down"),
    "port-down": note("sign.roll_port_down"),
    "bow-up": note("sign.pitch_bow_up"),
    "bow-down": note("sign.pitch_bow_down"),
}
"""Names of the signs of roll and pitch, by the values of their options."""
_SIGN_NOTE_CODES = {
    "starboard-down": "assumed.roll_starboard_down",
    "port-down": "assumed.roll_port_down",
    "bow-up": "assumed.pitch_bow_up",
    "bow-down": "assumed.pitch_bow_down",
}


def sign_note(sign: str) -> Message:
    """Note on the assumed sign of roll or pitch, by the value of its option."""
    return note(_SIGN_NOTE_CODES[sign])


Rows = Iterator[tuple[int, list[str]]]


def trajectory_of(
    path: Path,
    rows: Rows,
    columns: Sequence[Column],
    conventions: TrajectoryConventions,
    assumptions: tuple[Message, ...],
) -> Trajectory:
    """Read a trajectory from rows of fields.

    Raises
    ------
    InputError
        If a column is missing, a row cannot be read, or the values are not possible.
    """
    chosen = _choose_columns(path, columns, conventions)
    _require_known_units(path, chosen)
    grid = _chosen_grid(path, chosen, conventions)
    lengths = _length_units(path, chosen, grid)
    factors = {role: length.metres for role, length in lengths.items()}
    values, numbers = _read_values(path, rows, chosen, factors)
    _apply_hemispheres(path, values, numbers)
    time, notes = _times_and_notes(path, values, conventions)
    if len(time) < 2:
        raise InputError(error("trajectory.one_row", file=str(path)))
    require_increasing(time, path, "text", numbers)
    convergence = 0.0 * time
    if grid is None:
        latitude, longitude = values["latitude"], values["longitude"]
        unit = _find_column(path, chosen, "latitude").unit
        _require_on_earth(path, latitude, longitude, numbers, unit)
    else:
        latitude, longitude, convergence = grid.to_geodetic(
            path, values["easting"], values["northing"]
        )
        notes += (note("assumed.grid_positions", system=conventions.crs),)
    height = values["height"] if "height" in values else values["sea_height"]
    require_heights(path, height, numbers)
    if "height" not in values:
        notes += (note("assumed.heights_above_sea"),)
    roll, pitch, heading = (values[role] for role in ATTITUDE_ROLES)
    require_attitude(path, time, (roll, pitch, heading), numbers)
    attitude = np.stack(
        [
            -roll if conventions.roll == "port-down" else roll,
            -pitch if conventions.pitch == "bow-up" else pitch,
            heading + convergence if conventions.heading == "grid" else heading,
        ],
        axis=1,
    )
    notes = assumptions + conventions.assumptions() + notes + _unit_notes(chosen, lengths)
    return Trajectory(time, latitude, longitude, height, attitude, notes)


def _unit_notes(
    columns: Sequence[Column], lengths: Mapping[str, LengthUnit]
) -> tuple[Message, ...]:
    """Notes on the units of the columns; ``lengths`` are by role."""
    return tuple(
        note(
            "assumed.column_unit", column=column.name,
            unit=lengths[column.role].name if column.role in lengths else UNIT_NAMES[column.unit],
        )
        for column in columns
        if column.role not in ("time", "date", *HEMISPHERE_ROLES)
    )  # fmt: skip


def accuracy_of(
    path: Path, rows: Rows, columns: Sequence[Column], conventions: TrajectoryConventions
) -> TrajectoryAccuracy:
    """Read standard deviations from rows of fields.

    Raises
    ------
    InputError
        If a column is missing, or a standard deviation is negative or not a number.
    """
    chosen = [
        _find_column(path, columns, "time"),
        *(_find_column(path, columns, role) for role in SIGMA_ROLES),
    ]
    chosen += [column for column in columns if column.role == "date"]
    _require_known_units(path, chosen)
    for column in chosen[1:7]:
        _require_unit_kind(
            path, column, "an angle" if column.role in SIGMA_ROLES[3:] else "a length"
        )
    values, numbers = _read_values(path, rows, chosen)
    time, _ = _times_and_notes(path, values, conventions)
    require_increasing(time, path, "text", numbers)
    for role in SIGMA_ROLES:
        if (values[role] < 0).any():
            row = int(numbers[int(np.argmax(values[role] < 0))])
            raise InputError(error("trajectory.negative_sigma", file=str(path), row=row))
    table = [values[role] for role in SIGMA_ROLES]
    return TrajectoryAccuracy(time, np.stack(table[:3], axis=1), np.stack(table[3:], axis=1))


def is_complete(columns: Sequence[Column]) -> bool:
    """True if the columns contain all values of a trajectory."""
    roles = {column.role for column in columns}
    return (
        roles.issuperset(("time", *ATTITUDE_ROLES))
        and not roles.isdisjoint(HEIGHT_ROLES)
        and (roles.issuperset(POSITION_ROLES) or roles.issuperset(GRID_ROLES))
    )


def _find_column(path: Path, columns: Sequence[Column], role: str) -> Column:
    for column in columns:
        if column.role == role:
            return column
    raise InputError(error("trajectory.no_column", file=str(path), column=role))


def _choose_columns(
    path: Path, columns: Sequence[Column], conventions: TrajectoryConventions
) -> list[Column]:
    if not is_complete(columns):
        raise InputError(missing_columns(path, columns))
    roles = {column.role for column in columns}
    place = GRID_ROLES if conventions.crs and roles.issuperset(GRID_ROLES) else POSITION_ROLES
    if not roles.issuperset(place):
        raise InputError(error("trajectory.no_system", file=str(path)))
    if conventions.heading == "grid" and place is POSITION_ROLES:
        raise InputError(error("trajectory.grid_heading", file=str(path)))
    height = "height" if "height" in roles else "sea_height"
    chosen = [
        _find_column(path, columns, role) for role in ("time", *place, height, *ATTITUDE_ROLES)
    ]
    optional_roles = ("date", *(HEMISPHERE_ROLES if place is POSITION_ROLES else ()))
    return chosen + [column for column in columns if column.role in optional_roles]


def missing_columns(path: Path, columns: Sequence[Column]) -> Message:
    """Message about missing columns of a trajectory."""
    file, names = str(path), tuple(column.name for column in columns)
    if not names:
        return error("trajectory.no_columns", file=file)
    roles = {column.role for column in columns}
    has_height = not roles.isdisjoint(HEIGHT_ROLES)
    has_position = roles.issuperset(POSITION_ROLES) or roles.issuperset(GRID_ROLES)
    missing = tuple(
        role
        for role in ("time", *POSITION_ROLES, "height", *ATTITUDE_ROLES)
        if not (role in roles or (role in HEIGHT_ROLES and has_height))
        and not (role in POSITION_ROLES and has_position)
    )
    if has_position:
        return error("trajectory.columns_missing", file=file, names=names, missing=missing)
    return error("trajectory.position_missing", file=file, names=names, missing=missing)


def map_warnings(
    path: Path, columns: Sequence[Column], conventions: TrajectoryConventions, read: Trajectory
) -> tuple[Message, ...]:
    """Warnings about the units of eastings, northings and heights, and the area of the system.

    Raises
    ------
    InputError
        If the positions are outside the coordinate system.
    """
    chosen = _choose_columns(path, columns, conventions)
    grid = _chosen_grid(path, chosen, conventions)
    lengths = _length_units(path, chosen, grid)
    # One warning is enough for easting and northing.
    lengths.pop("northing", None)
    file_warnings = [length.reported for length in lengths.values()]
    if grid is not None:
        file_warnings.append(grid.place_warning(path, read.latitude, read.longitude))
    return tuple(reported for reported in file_warnings if reported is not None)


def _chosen_grid(
    path: Path, chosen: Sequence[Column], conventions: TrajectoryConventions
) -> TrajectoryProjection | None:
    on_map = any(column.role in GRID_ROLES for column in chosen)
    return projection_of_text(path, conventions.crs) if on_map else None


def _length_units(
    path: Path, chosen: Sequence[Column], grid: TrajectoryProjection | None
) -> dict[str, LengthUnit]:
    """Units of eastings, northings and heights by role.

    Raises
    ------
    InputError
        If a unit does not suit the quantity in the column.
    """
    lengths: dict[str, LengthUnit] = {}
    for column in chosen:
        if column.role not in ("time", "date", *HEMISPHERE_ROLES):
            is_angle = column.role in (*POSITION_ROLES, *ATTITUDE_ROLES)
            _require_unit_kind(path, column, "an angle" if is_angle else "a length")
        if column.role in GRID_ROLES and grid is not None:
            lengths[column.role] = grid.unit(column.name, column.unit, path)
        elif column.role in HEIGHT_ROLES:
            lengths[column.role] = unit_of_heights(column.name, column.unit, grid, path)
    return lengths


def _require_unit_kind(path: Path, column: Column, kind: Literal["an angle", "a length"]) -> None:
    """Refuse a unit that does not suit the quantity in the column.

    Raises
    ------
    InputError
        If the unit of the column is of another kind.
    """
    if kind == "an angle":
        fits = column.unit.removesuffix("-west").removesuffix("-south") in ANGLE_UNIT_CODES
    else:
        fits = column.unit in (UNSPECIFIED_UNIT, *METRES_PER_UNIT)
    if not fits:
        code = "trajectory.not_an_angle" if kind == "an angle" else "trajectory.not_a_length"
        raise InputError(error(code, file=str(path), column=column.name, unit=column.unit))


def _require_known_units(path: Path, columns: Sequence[Column]) -> None:
    """Refuse columns with an unknown or ambiguous unit in the header.

    Raises
    ------
    InputError
        If a unit is unknown, or a title is ambiguous.
    """
    for column in columns:
        if column.unit.startswith(UNKNOWN):
            unit, file = column.unit[len(UNKNOWN) :].strip(), str(path)
            raise InputError(
                error("trajectory.unknown_unit", file=file, column=column.name, unit=unit)
                if unit
                else error("trajectory.ambiguous_title", file=file, column=column.name)
            )


def _read_values(
    path: Path, rows: Rows, columns: Sequence[Column], factors: Mapping[str, float] = _NO_FACTORS
) -> tuple[dict[str, Array], Numbers]:
    """Read values by role in radians, metres and seconds; ``factors`` override those of units.

    Raises
    ------
    InputError
        If a row cannot be read, or signs contradict the direction in a title.
    """
    parsers = [(column.index, _field_parser(column), column.name) for column in columns]
    table, numbers = read_columns(path, rows, parsers)
    for column, own in zip(columns, table, strict=True):
        if column.unit.endswith(("-west", "-south")) and (own < 0).all():
            is_west = column.unit.endswith("-west")
            code = "trajectory.negative_west" if is_west else "trajectory.negative_south"
            raise InputError(error(code, file=str(path), column=column.name))
    with np.errstate(over="ignore"):
        values = {
            column.role: values * factors.get(column.role, UNIT_PARSERS[column.unit][1])
            for column, values in zip(columns, table, strict=True)
        }
    return values, numbers


def _field_parser(column: Column) -> Callable[[str], float]:
    """Parser for a column, which refuses hemisphere letters of the other coordinate."""
    parse = UNIT_PARSERS[column.unit][0]
    if column.role not in POSITION_ROLES or parse is parse_number:
        return parse
    return partial(
        parse_with_hemisphere, parse, letters="NS" if column.role == "latitude" else "EW"
    )


def _apply_hemispheres(path: Path, values: dict[str, Array], numbers: Numbers) -> None:
    """Apply the sign of the hemisphere to latitudes and longitudes, if a column contains it.

    Raises
    ------
    InputError
        If a value has both a sign and a hemisphere.
    """
    for role, place in zip(HEMISPHERE_ROLES, POSITION_ROLES, strict=True):
        sign = values.pop(role, None)
        if sign is None:
            continue
        has_both = values[place] < 0
        if has_both.any():
            row = int(numbers[int(np.argmax(has_both))])
            raise InputError(
                error("trajectory.sign_and_hemisphere", file=str(path), row=row, role=place)
            )
        values[place] = values[place] * sign


def _times_and_notes(
    path: Path, values: Mapping[str, Array], conventions: TrajectoryConventions
) -> tuple[Array, tuple[Message, ...]]:
    base = base_of_key(conventions.time)
    time = values["time"]
    if "date" in values:
        if base.period is not None or base.key == "gps-adjusted":
            raise InputError(error("trajectory.dates", file=str(path), base=base.key))
        calendar = values["date"] + time
        code = "assumed.dates_utc" if base.utc else "assumed.dates_gps"
        return (calendar if base.utc else calendar - GPS_EPOCH), (note(code),)
    time, starts = unroll_times(time)
    require_time_base(path, time, base)
    return time, (note("assumed.time_rollover", count=starts),) if starts else ()


def _require_on_earth(
    path: Path, latitude: Array, longitude: Array, numbers: Numbers, unit: str
) -> None:
    bad = (np.abs(latitude) > np.pi / 2) | (np.abs(longitude) > 2 * np.pi)
    if not bad.any():
        return
    k = int(np.argmax(bad))
    lat, lon = float(latitude[k]), float(longitude[k])
    if abs(lat) <= np.pi and np.abs(longitude).max() <= np.pi / 2:
        code = "trajectory.exchanged_position"
    elif unit == "rad" and np.abs(np.radians(latitude)).max() <= np.pi / 2:
        code = "trajectory.position_in_degrees"
    else:
        code = "trajectory.not_on_earth"
    raise InputError(error(code, file=str(path), row=int(numbers[k]), latitude=lat, longitude=lon))
