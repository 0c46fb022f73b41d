"""Position, size and orientation of targets, and sections of validation planes, as values."""

from collections.abc import Mapping
from dataclasses import dataclass
from math import degrees

import numpy as np
from numpy.typing import NDArray

from lispac.language import gettext
from lispac.present.angles import floats
from lispac.present.text_format import fixed_number
from lispac.targets.surface_geometry import SurfaceGeometry

Points = tuple[tuple[float, float], ...]


@dataclass(frozen=True)
class SurfaceGeometryValues:
    """Position, size and orientation of a target, as in `SurfaceGeometry`.

    ``centre_local_m`` is north, west, up from the origin of the local frame. The others are None
    for a sphere; ``azimuth_deg`` is also None for a horizontal plane.
    """

    centre_local_m: tuple[float, ...]
    extent_m: tuple[float, ...] | None
    inclination_deg: float | None
    azimuth_deg: float | None

    @classmethod
    def of(cls, geometry: SurfaceGeometry) -> "SurfaceGeometryValues":
        """Values of the geometry of a target."""
        inclination, azimuth = geometry.inclination, geometry.azimuth
        return cls(
            floats(geometry.centre),
            None if geometry.extent is None else floats(geometry.extent),
            None if inclination is None else degrees(inclination),
            None if azimuth is None else degrees(azimuth),
        )

    @property
    def size_text(self) -> str | None:
        """Width and height, metres, in the language in use; None for a sphere."""
        if self.extent_m is None:
            return None
        width, height = (fixed_number(each, 2) for each in self.extent_m)
        return gettext("{width} × {height}", width=width, height=height)


@dataclass(frozen=True)
class LineSection:
    """Points of one line in a section: position along it and distance from the plane, metres."""

    line: str
    place: int
    before_m: Points
    after_m: Points


@dataclass(frozen=True)
class PlaneSection:
    """Points of all lines in a strip across a validation plane, before and after.

    ``axis_title`` is the title of the axis along the section, in English; ``place`` of a line is
    its place in the project, which gives its colour.
    """

    plane: str
    axis_title: str
    lines: tuple[LineSection, ...]


def plane_section(
    plane: str,
    axis_title: str,
    places: Mapping[str, int],
    before: Mapping[str, NDArray[np.float64]],
    after: Mapping[str, NDArray[np.float64]],
) -> PlaneSection:
    """Section of a validation plane from the points (n, 2) of each line before and after."""
    return PlaneSection(
        plane,
        axis_title,
        tuple(
            LineSection(line, places[line], _points(before[line]), _points(after[line]))
            for line in before
        ),
    )


def _points(points: NDArray[np.float64]) -> Points:
    return tuple((float(along), float(distance)) for along, distance in points.round(5))
