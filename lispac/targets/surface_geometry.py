"""Position, size and orientation of a target, and a section of its points."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.planes import LEVEL_LIMIT_RAD, plane_axes
from lispac.geometry.spheres import fit_sphere
from lispac.targets.cross_section import common_normal

Array = NDArray[np.float64]
SECTION_THICKNESS_M = 0.2
"""Thickness of the strip of points in a section, metres."""
MAX_SECTION_POINTS = 150
"""Largest number of points of a line in a section."""


@dataclass(frozen=True, eq=False)
class SurfaceGeometry:
    """Position, size and orientation of a plane, or the position of a sphere.

    Attributes
    ----------
    centre : ndarray of shape (3,), metres, local frame
        Mean of the middles of the lines on a plane; centre of a sphere.
    normal : ndarray of shape (3,), unit vector, local frame, or None
        Normal towards the vessel; None for a sphere.
    extent : ndarray of shape (2,), metres, or None
        Width (level) and height (up the slope) that the points of all lines span; west and north on
        a horizontal plane; None for a sphere.
    """

    centre: Array
    normal: Array | None = None
    extent: Array | None = None

    @property
    def inclination(self) -> float | None:
        """Angle between plane and horizon, radians in [0, pi/2]; None for a sphere."""
        if self.normal is None:
            return None
        return float(np.arctan2(np.hypot(*self.normal[:2]), abs(self.normal[2])))

    @property
    def is_horizontal(self) -> bool:
        """Whether it is a plane whose normal has no azimuth."""
        inclination = self.inclination
        return inclination is not None and inclination < LEVEL_LIMIT_RAD

    @property
    def azimuth(self) -> float | None:
        """Azimuth of the normal, radians clockwise from north; None if horizontal or a sphere."""
        if self.normal is None or self.is_horizontal:
            return None
        return float(np.arctan2(-self.normal[1], self.normal[0])) % (2.0 * np.pi)


def plane_geometry(groups: Mapping[str, Array], eye: Array) -> SurfaceGeometry:
    """Geometry of a plane from the points (n, 3) of each line.

    Parameters
    ----------
    eye : ndarray of shape (3,), metres, local frame
        Position of the vessel.

    Raises
    ------
    PlaneNotFound
        If the points of a line do not determine a plane.
    """
    centre, normal = _centre(groups), common_normal(groups.values())
    if normal @ (eye - centre) < 0.0:
        normal = -normal
    placed = np.concatenate(list(groups.values())) @ plane_axes(normal, LEVEL_LIMIT_RAD).T
    return SurfaceGeometry(centre, normal, np.ptp(placed, axis=0))


def sphere_geometry(groups: Mapping[str, Array], radius: float | None) -> SurfaceGeometry:
    """Geometry of a sphere of known or unknown radius, metres, from the points of each line.

    Raises
    ------
    SphereNotFound
        If the points do not determine a sphere.
    """
    return SurfaceGeometry(fit_sphere(np.concatenate(list(groups.values())), radius).centre)


def _centre(groups: Mapping[str, Array]) -> Array:
    return np.asarray(np.mean([points.mean(axis=0) for points in groups.values()], axis=0))


def section_axis(geometry: SurfaceGeometry) -> int:
    """Axis of a section along a plane: 0 along its width or 1 up its slope, the longer one."""
    assert geometry.extent is not None
    return int(np.argmax(geometry.extent))


def section_points(groups: Mapping[str, Array], geometry: SurfaceGeometry) -> dict[str, Array]:
    """Points of each line in a strip across the middle of a plane.

    The strip passes through the centre of the given points, so that a common displacement of all
    lines is not visible.

    Parameters
    ----------
    groups : points (n, 3) of each line, metres, local frame
    geometry : SurfaceGeometry
        Gives the direction of the normal and of the axis.

    Returns
    -------
    mapping of line name to ndarray of shape (k, 2), metres
        Position along the `section_axis`, to the right as seen from the vessel or up the slope, on
        a horizontal plane to the east or north; and distance from the centre along the normal,
        positive towards the vessel.
    """
    assert geometry.normal is not None
    centre, axis = _centre(groups), section_axis(geometry)
    axes = plane_axes(geometry.normal, LEVEL_LIMIT_RAD)
    if geometry.is_horizontal:
        axes[0] *= -1.0  # east
    along, across = axes[axis], axes[1 - axis]
    section = {}
    for line, points in groups.items():
        placed = (points - centre) @ np.stack([along, geometry.normal, across], axis=1)
        own = placed[np.abs(placed[:, 2]) <= 0.5 * SECTION_THICKNESS_M, :2]
        own = own[np.argsort(own[:, 0], kind="stable")]
        kept = np.linspace(0, len(own) - 1, min(len(own), MAX_SECTION_POINTS)).round().astype(int)
        section[line] = own[kept]
    return section
