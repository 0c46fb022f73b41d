"""Units in the column titles of points as text: checks, reading options and warnings."""

from collections.abc import Iterator, Mapping
from pathlib import Path

from lispac.errors import InputError
from lispac.io.format_types import Choice
from lispac.io.point_reader_common import SCANNER_UNITS
from lispac.io.text.text_layout import (
    POLAR_COLUMN_NAMES,
    TIME_BASE_OF_COLUMN_NAME,
    RowLayout,
    ambiguous_columns,
    name_without_unit,
)
from lispac.io.units import (
    ANGLE_UNIT_CODES,
    LENGTH_UNIT_NAMES,
    METRES_PER_UNIT,
    UNKNOWN,
    direction_of,
)
from lispac.messages import Action, Level, Message, error, warning
from lispac.survey.crs import METRES_PER_UNIT as SYSTEM_UNITS
from lispac.survey.crs import CoordinateSystem, coordinate_system
from lispac.survey.line_source import printable

TIME_UNIT_OPTIONS = {"s": "second", "ms": "millisecond", "us": "microsecond", "ns": "nanosecond",
              "min": "minute", "h": "hour"}  # fmt: skip
"""Values of the option ``time_unit`` by the code of the unit."""
AXES = ("x", "y", "z")


def header_options(layout: RowLayout) -> dict[str, str]:
    """Options ``time_unit``, ``time_base`` and ``unit`` specified in the column titles."""
    units, found = layout.units(), dict[str, str]()
    if "time" in layout.names:
        title = layout.titles[layout.names.index("time")]
        if base := TIME_BASE_OF_COLUMN_NAME.get(name_without_unit(title)):
            found["time_base"] = base
    if time := TIME_UNIT_OPTIONS.get(units.get("time", "")):
        found["time_unit"] = time
    axis_units = [units.get(axis, "") for axis in AXES]
    if len(set(axis_units)) == 1 and axis_units[0] in METRES_PER_UNIT:
        metres = METRES_PER_UNIT[axis_units[0]]
        found["unit"] = next(name for name, own in SCANNER_UNITS.items() if own == metres)
    return found


def require_one_unit(path: Path, layout: RowLayout) -> None:
    """Refuse coordinates in the scanner frame unless their titles give one unit of length or none.

    Raises
    ------
    InputError
        If the titles of x, y and z have different units, or a unit that is no length.
    """
    units = layout.units()
    axis_units = {axis: units.get(axis, "") for axis in AXES}
    if len(set(axis_units.values())) == 1 and set(axis_units.values()) <= {"", *METRES_PER_UNIT}:
        return
    titles = [layout.titles[layout.names.index(axis)] for axis, unit in axis_units.items() if unit]
    raise InputError(error("text.several_units", file=str(path), titles=tuple(titles)))


def require_degrees(path: Path, layout: RowLayout) -> None:
    """Refuse angles that are not in degrees, longitudes to the west and latitudes to the south.

    Longitudes and latitudes whose direction is ambiguous are also refused.

    Raises
    ------
    InputError
        If a column has another unit, or another or an ambiguous positive direction.
    """
    units = layout.units()
    for axis, negative_direction in (("x", "west"), ("y", "south")):
        if axis not in layout.names:
            continue
        title = layout.titles[layout.names.index(axis)]
        is_other_angle = units.get(axis, "") in ANGLE_UNIT_CODES and units[axis] not in (
            "deg",
            "dms",
        )
        has_other_direction = name_without_unit(title) in GEOGRAPHIC_COLUMN_NAMES and (
            direction_of(title) in (negative_direction, UNKNOWN)
        )
        if is_other_angle or has_other_direction:
            raise InputError(error("text.not_degrees", file=str(path), column=title))


GEOGRAPHIC_COLUMN_NAMES = {"lon", "longitude", "lat", "latitude"}
"""Column names of longitudes and latitudes; lower case, without the unit."""


def require_cartesian(path: Path, layout: RowLayout) -> None:
    """Refuse points with several columns of polar coordinates but not x, y and z.

    Raises
    ------
    InputError
        If the columns have polar coordinates, and x, y or z is missing.
    """
    polar = [title for title in layout.titles if name_without_unit(title) in POLAR_COLUMN_NAMES]
    if len(polar) >= 2 and not set(AXES) <= set(layout.names):
        raise InputError(error("text.polar_coordinates", file=str(path), columns=tuple(polar)))


def column_title_warnings(path: Path, layout: RowLayout, choice: Choice) -> Iterator[Message]:
    """Warnings about column titles: contradicted by an option, with an unknown unit, or ambiguous.

    Parameters
    ----------
    choice : mapping
        Reading options set by the user.
    """
    file = printable(path.name)
    for option, specified in header_options(layout).items():
        unit_option = str(choice.get(option, specified))
        if unit_option not in ("", specified):
            meanings = AXES if option == "unit" else ("time",)
            titles = tuple(layout.titles[layout.names.index(name)] for name in meanings)
            params = {"file": file, "option": option, "stated": titles, "given": unit_option}
            actions = (Action("set_option", {"name": option, "value": specified}),)
            yield Message("text.unit_overridden", Level.WARNING, params, actions=actions)
    if layout.units().get("time") == UNKNOWN:
        column = layout.titles[layout.names.index("time")]
        params = {"file": file, "column": column, "used": "seconds"}
        yield Message("text.unknown_unit", Level.WARNING, params)
    for meaning, titles_of_one in ambiguous_columns(layout.titles).items():
        if meaning in (*AXES, "time"):
            used = layout.titles[layout.names.index(meaning)]
            params = {"file": file, "columns": tuple(titles_of_one), "used": used}
            yield Message("text.two_columns", Level.WARNING, params)


def height_unit_of(units: Mapping[str, str], crs: str) -> str:
    """Value of the option ``height_unit``; empty if the title of the heights gives none.

    It is also empty for units that the option does not have, and for feet of unspecified kind in a
    system in feet, whose feet are then used.

    Parameters
    ----------
    units : mapping of str to str
        Code of the unit of each column, by its meaning.
    """
    unit = units.get("z", "")
    system = _parse_crs(crs)
    if unit not in METRES_PER_UNIT or (
        unit == "ft" and system is not None and "foot" in system.unit
    ):
        return ""
    return next(
        (name for name, metres in SYSTEM_UNITS.items() if metres == METRES_PER_UNIT[unit]), ""
    )


def easting_unit_warnings(units: Mapping[str, str], crs: str, file: str) -> tuple[Message, ...]:
    """Warning if the title of the eastings gives another unit than the coordinate system."""
    unit, system = units.get("x", ""), _parse_crs(crs)
    if unit not in METRES_PER_UNIT or system is None or system.is_geographic:
        return ()
    system_metres = system.metres[0]
    if (unit == "ft" and "foot" in system.unit) or abs(
        METRES_PER_UNIT[unit] / system_metres - 1
    ) < 1e-9:
        return ()
    return (
        warning(
            "points.unit_of_column", file=file, unit=LENGTH_UNIT_NAMES[METRES_PER_UNIT[unit]],
            system=system.name, system_unit=system.unit,
        ),
    )  # fmt: skip


def _parse_crs(crs: str) -> CoordinateSystem | None:
    try:
        return coordinate_system(crs) if crs else None
    except InputError:
        return None  # reported where points are georeferenced
