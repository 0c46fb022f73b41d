"""Units in the names of columns of points as text, against those of the coordinate system."""

import re
from collections.abc import Sequence

from lispac.errors import InputError
from lispac.io.exail import unit_of
from lispac.io.text_layout import Layout, names_of
from lispac.io.trajectory_grid import LENGTH_WORDS, LENGTHS
from lispac.survey.crs import UNITS, CoordinateSystem, coordinate_system

_MARK = re.compile(r"[\[(](.+)[\])]\s*$|_(m|ft)$")


def units_in(lines: Sequence[str], layout: Layout) -> dict[str, str]:
    """Unit in the name of each column, as `unit_of` has it; without those that name none."""
    if not layout.names:
        return {}
    for line in lines:
        fields = names_of(line, layout.separator, len(layout.names))
        if fields and layout.meant(fields) == layout.names:
            marks = [_MARK.search(field) for field in fields]
            found = [unit_of(mark[1] or mark[2]) if mark else "" for mark in marks]
            return {
                name: unit
                for name, unit in zip(layout.names, found, strict=True)
                if unit in LENGTHS
            }
    return {}


TIME_UNITS = {"s": "second", "sec": "second", "ms": "millisecond", "msec": "millisecond",
              "us": "microsecond", "usec": "microsecond", "µs": "microsecond", "ns": "nanosecond",
              "nsec": "nanosecond"}  # fmt: skip
"""Units of time in the names of columns, as the option ``time_unit`` has them."""
LENGTH_UNITS = {"m": "metre", "mm": "millimetre", "ft": "foot", "us-ft": "us-survey-foot",
                "us ft": "us-survey-foot", "int-ft": "foot"}  # fmt: skip
"""Units of length in the names of columns, as the option ``unit`` has them."""
_UNIT = re.compile(r"[\[(]\s*([^\])]+?)\s*[\])]\s*$|_(ms|us|ns|mm|ft|m|s)$", re.IGNORECASE)


def header_units(lines: Sequence[str], layout: Layout) -> dict[str, str]:
    """Options ``time_unit`` and ``unit`` that the names of the columns state."""
    marks = _marks(lines, layout)
    found: dict[str, str] = {}
    if time := TIME_UNITS.get(marks.get("time", "").lower()):
        found["time_unit"] = time
    stated = {axis: marks[axis].lower() for axis in "xyz" if marks.get(axis)}
    if len(set(stated.values())) == 1 and len(stated) == len("xyz"):
        unit = next(iter(stated.values()))
        if unit in LENGTH_UNITS:
            found["unit"] = LENGTH_UNITS[unit]
    return found


def _marks(lines: Sequence[str], layout: Layout) -> dict[str, str]:
    """What stands as the unit in the name of each column, by the column's meaning."""
    for line in lines if layout.names else ():
        fields = names_of(line, layout.separator, len(layout.names))
        if fields and layout.meant(fields) == layout.names:
            found = [_UNIT.search(field) for field in fields]
            return {
                name: mark[1] or mark[2]
                for name, mark in zip(layout.names, found, strict=True)
                if mark
            }
    return {}


def height_unit_of(units: dict[str, str], crs: str) -> str:
    """Option for the unit of heights; empty where the names say nothing that the system does not.

    Plain feet are those of a system in feet.
    """
    unit = units.get("z", "")
    system = _system(crs)
    if not unit or (unit == "ft" and system is not None and "foot" in system.unit):
        return ""
    return next(name for name, metres in UNITS.items() if metres == LENGTHS[unit])


def unit_doubts(units: dict[str, str], crs: str) -> tuple[str, ...]:
    """A sentence where eastings by their name are in another unit than the system's."""
    unit, system = units.get("x", ""), _system(crs)
    if not unit or system is None or system.is_geographic:
        return ()
    own = system.metres[0]
    if (unit == "ft" and "foot" in system.unit) or abs(LENGTHS[unit] / own - 1) < 1e-9:
        return ()
    said = LENGTH_WORDS[LENGTHS[unit]]
    return (
        f"By the name of its column x is in {said}, but {system.name} is in {system.unit}: give "
        "the code of the same system in the unit of the file, or export in that of the system.",
    )


def _system(crs: str) -> CoordinateSystem | None:
    try:
        return coordinate_system(crs) if crs else None
    except InputError:
        return None  # said where points are brought to the earth
