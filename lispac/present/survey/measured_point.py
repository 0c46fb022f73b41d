"""Values of one measured point, which the window shows beside the mouse."""

from collections.abc import Mapping
from dataclasses import dataclass

from lispac.language import N_, gettext
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.present.tables import SECONDS, Fact, Format

AXIS_TITLES = {
    "east": N_("East"), "north": N_("North"), "up": N_("Up"),
    "longitude": N_("Longitude"), "latitude": N_("Latitude"), "height": N_("Height"),
    "easting": N_("Easting"), "northing": N_("Northing"), "X": "X", "Y": "Y", "Z": "Z",
}  # fmt: skip
"""Titles of coordinates by their names."""
LOCAL_UNIT = "local"
"""Unit of coordinates in the local frame, which are shown in the unit of the user."""
METRES = Format("m", 3, is_grouped=False)
UNIT_SIGNS = {"metre": "m", "degree": "°", "foot": "ft", "US survey foot": "ftUS"}
"""Signs of the units of coordinate systems, by their EPSG names."""
DEGREE_DECIMALS = 8
"""Decimals of longitude and latitude; the last one is a millimetre."""


@dataclass(frozen=True)
class Coordinate:
    """One coordinate of a point.

    Attributes
    ----------
    axis : key of `AXIS_TITLES`
    unit : EPSG name of the unit, or `LOCAL_UNIT`
    """

    axis: str
    value: float
    unit: str


@dataclass(frozen=True)
class MeasuredPoint:
    """Values of one point of a line.

    Attributes
    ----------
    coordinates : in the order of the coordinate system
    system : str
        Name of the coordinate system.
    time_s : float
        Time in the time base of the trajectory.
    time_base : Message or None
        Name of this time base; None if it is not known.
    incidence_rad, plane_points : float and int, or None
        Angle between the beam and the normal of the plane fitted to the points of the line around
        the point, and the number of these points; None if they are not on a plane.
    intensity : float or None
        Intensity as in the file.
    """

    line: str
    coordinates: tuple[Coordinate, ...]
    system: str
    time_s: float
    time_base: Message | None
    range_m: float
    incidence_rad: float | None
    plane_points: int | None
    intensity: float | None


def point_facts(point: MeasuredPoint) -> list[Fact]:
    """Names and values, the most important ones first; unknown values are omitted."""
    facts = [
        Fact(gettext("Line"), point.line),
        *map(_coordinate_fact, point.coordinates),
        Fact(gettext("Time"), point.time_s, SECONDS),
        Fact(gettext("Range"), point.range_m, METRES),
    ]
    if point.incidence_rad is not None:
        incidence = gettext(
            "{angle:deg.0}° (plane through {count:n} points)",
            angle=point.incidence_rad, count=point.plane_points,
        )  # fmt: skip
        facts.append(Fact(gettext("Incidence"), incidence))
    facts += _intensity_facts(point)
    facts.append(Fact(gettext("Coordinate system"), point.system))
    if point.time_base is not None:
        facts.append(Fact(gettext("Time base"), message_text(point.time_base)))
    return facts


def brief_point_facts(point: MeasuredPoint) -> list[list[Fact]]:
    """Names and values in a few short lines, for a tooltip; unknown values are omitted."""
    scan = [Fact(gettext("Range"), point.range_m, METRES)]
    if point.incidence_rad is not None:
        angle = gettext("{angle:deg.0}°", angle=point.incidence_rad)
        scan.append(Fact(gettext("Incidence"), angle))
    lines = [
        [*map(_coordinate_fact, point.coordinates)],
        [Fact(gettext("Line"), point.line)],
        scan,
        _intensity_facts(point),
        [Fact(gettext("Time"), point.time_s, SECONDS)],
    ]
    return [line for line in lines if line]


@dataclass(frozen=True)
class CopiedPoint:
    """Coordinates in the copied values of a point.

    Attributes
    ----------
    coordinates : texts of the numbers, by the names of the axes
    system : name of the coordinate system; empty if it was not copied
    """

    coordinates: Mapping[str, str]
    system: str


def copied_point(text: str) -> CopiedPoint | None:
    """Coordinates in a text of copied values, one name and value a row; None if it has none."""
    axes = {gettext(title): axis for axis, title in AXIS_TITLES.items()}
    values = dict(row.strip().split("\t", 1) for row in text.splitlines() if "\t" in row)
    found = {
        axis: value.strip()
        for name, value in values.items()
        if (axis := axes.get(name.partition(" (")[0].strip())) is not None
    }
    system = values.get(gettext("Coordinate system"), "").strip()
    return CopiedPoint(found, system) if len(found) == 3 else None


def _intensity_facts(point: MeasuredPoint) -> list[Fact]:
    if point.intensity is None:
        return []
    decimals = 0 if point.intensity == round(point.intensity) else 3
    return [Fact(gettext("Intensity"), point.intensity, Format("", decimals, is_grouped=False))]


def _coordinate_fact(coordinate: Coordinate) -> Fact:
    title = gettext(AXIS_TITLES[coordinate.axis])
    if coordinate.unit == LOCAL_UNIT:
        return Fact(title, coordinate.value, METRES)
    decimals = DEGREE_DECIMALS if coordinate.unit == "degree" else METRES.decimals
    # A coordinate is always in the unit of its system, which is therefore part of the name.
    name = f"{title} ({UNIT_SIGNS.get(coordinate.unit, coordinate.unit)})"
    return Fact(name, coordinate.value, Format("", decimals, is_grouped=False))
