"""Surfaces of a scene: rectangles, upright cylinders, spheres, and triangle meshes."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from lispac.simulation.meshes import Mesh, MeshCaster
from lispac.simulation.ray_casting import cast_rays

Array = NDArray[np.float64]
UP = (0.0, 0.0, 1.0)


@dataclass(frozen=True, eq=False)
class Rectangle:
    """A flat rectangle, visible from both sides.

    Attributes
    ----------
    name : str
    centre : ndarray of shape (3,), metres, local
    normal : ndarray of shape (3,), unit vector, local
    across : ndarray of shape (3,), unit vector, local
        Direction of the width; the height runs along ``normal x across``.
    width, height : float, metres
    reflectance : float, in [0, 1]
    """

    name: str
    centre: Array
    normal: Array
    across: Array
    width: float
    height: float
    reflectance: float = 0.4

    @property
    def row(self) -> Array:
        """Centre, normal, and the two directions divided by half the extent, shape (12,)."""
        along = np.cross(self.normal, self.across)
        return np.concatenate(
            [self.centre, self.normal, self.across / (self.width / 2), along / (self.height / 2)]
        )

    def distance(self, points_local: Array) -> Array:
        """Signed distance of points to the plane, shape (n,), metres."""
        return np.asarray((points_local - self.centre) @ self.normal)


@dataclass(frozen=True, eq=False)
class Cylinder:
    """An upright cylinder without caps, for masts, bollards and fenders.

    Attributes
    ----------
    name : str
    north, west : float, metres, local
        Position of the axis.
    bottom, top : float, metres, local
    radius : float, metres
    reflectance : float, in [0, 1]
    """

    name: str
    north: float
    west: float
    bottom: float
    top: float
    radius: float
    reflectance: float = 0.3

    @property
    def row(self) -> Array:
        """Axis, bottom, top and radius, shape (5,), metres."""
        return np.array([self.north, self.west, self.bottom, self.top, self.radius])

    def distance(self, points_local: Array) -> Array:
        """Signed distance of points to the lateral surface, shape (n,), metres."""
        offset = points_local[:, :2] - (self.north, self.west)
        return np.asarray(np.hypot(offset[:, 0], offset[:, 1]) - self.radius)


@dataclass(frozen=True, eq=False)
class Sphere:
    """A sphere, visible from outside and from inside.

    Attributes
    ----------
    name : str
    centre : ndarray of shape (3,), metres, local
    radius : float, metres
    reflectance : float, in [0, 1]
    """

    name: str
    centre: Array
    radius: float
    reflectance: float = 0.4

    @property
    def row(self) -> Array:
        """Centre and radius, shape (4,), metres."""
        return np.array([*self.centre, self.radius])

    def distance(self, points_local: Array) -> Array:
        """Signed distance of points to the sphere, shape (n,), metres; positive outside."""
        return np.asarray(np.linalg.norm(points_local - self.centre, axis=1) - self.radius)


Surface = Rectangle | Cylinder | Sphere | Mesh


def upright_rectangle(
    name: str,
    foot: tuple[float, float],
    bottom: float,
    top: float,
    width: float,
    facing_deg: float,
    reflectance: float = 0.4,
) -> Rectangle:
    """A vertical rectangle facing an azimuth.

    Parameters
    ----------
    foot : pair of float, metres, local
        North and **west** of the middle of its lower edge.
    bottom, top, width : float, metres
    facing_deg : float
        Azimuth of its normal, clockwise from north.
    """
    azimuth = np.radians(facing_deg)
    normal = np.array([np.cos(azimuth), -np.sin(azimuth), 0.0])
    centre = np.array([foot[0], foot[1], (bottom + top) / 2])
    return Rectangle(name, centre, normal, np.cross(UP, normal), width, top - bottom, reflectance)


def tilted_rectangle(
    name: str,
    centre: tuple[float, float, float],
    width: float,
    height: float,
    facing_deg: float,
    elevation_deg: float,
    reflectance: float = 0.4,
) -> Rectangle:
    """A rectangle with a horizontal width and a normal with given azimuth and elevation.

    Parameters
    ----------
    centre : tuple of float, metres, local
    width, height : float, metres
    facing_deg, elevation_deg : float, degrees
        Azimuth of the normal, and its angle above the horizontal.
    """
    azimuth, elevation = np.radians([facing_deg, elevation_deg])
    level = np.array([np.cos(azimuth), -np.sin(azimuth), 0.0])
    normal = np.cos(elevation) * level + np.sin(elevation) * np.array(UP)
    across = np.cross(UP, level)
    return Rectangle(name, np.array(centre), normal, across, width, height, reflectance)


def box_faces(
    name: str,
    north: tuple[float, float],
    west: tuple[float, float],
    bottom: float,
    top: float,
    reflectance: float = 0.4,
) -> list[Rectangle]:
    """The four walls and the roof of a box along the axes of the local frame."""
    (south_end, north_end), (east_end, west_end) = sorted(north), sorted(west)
    length, depth = north_end - south_end, west_end - east_end
    n, w = (south_end + north_end) / 2, (east_end + west_end) / 2
    return [
        upright_rectangle(
            f"{name}, north face", (north_end, w), bottom, top, depth, 0, reflectance
        ),
        upright_rectangle(
            f"{name}, east face", (n, east_end), bottom, top, length, 90, reflectance
        ),
        upright_rectangle(
            f"{name}, south face", (south_end, w), bottom, top, depth, 180, reflectance
        ),
        upright_rectangle(
            f"{name}, west face", (n, west_end), bottom, top, length, 270, reflectance
        ),
        tilted_rectangle(f"{name}, top", (n, w, top), length, depth, 270, 90, reflectance),
    ]


@dataclass(frozen=True, eq=False)
class Scene:
    """Surfaces of a scene; the nearest surface on a ray occludes those behind it."""

    surfaces: tuple[Surface, ...]

    @classmethod
    def of(cls, surfaces: Sequence[Surface]) -> "Scene":
        """Scene of surfaces sorted by kind, so that one index runs through all arrays."""
        return cls(tuple(s for kind in (Rectangle, Cylinder, Sphere, Mesh) for s in surfaces
                         if isinstance(s, kind)))  # fmt: skip

    @property
    def names(self) -> tuple[str, ...]:
        """Name of each surface; labels are indices into it."""
        return tuple(surface.name for surface in self.surfaces)

    @property
    def reflectances(self) -> Array:
        """Reflectance of each surface, shape (surfaces,)."""
        return np.array([surface.reflectance for surface in self.surfaces])

    def __getitem__(self, name: str) -> Surface:
        return self.surfaces[self.names.index(name)]

    @cached_property
    def rectangles(self) -> Array:
        """Rows of the rectangles, shape (k, 12)."""
        return self._rows(Rectangle, 12)

    @cached_property
    def cylinders(self) -> Array:
        """Rows of the cylinders, shape (m, 5)."""
        return self._rows(Cylinder, 5)

    @cached_property
    def spheres(self) -> Array:
        """Rows of the spheres, shape (m, 4)."""
        return self._rows(Sphere, 4)

    @cached_property
    def meshes(self) -> MeshCaster | None:
        """Caster of the meshes; None if there are none."""
        found = [surface for surface in self.surfaces if isinstance(surface, Mesh)]
        return MeshCaster.of(found) if found else None

    def _rows(self, kind: type[Rectangle] | type[Cylinder] | type[Sphere], columns: int) -> Array:
        rows = [surface.row for surface in self.surfaces if isinstance(surface, kind)]
        return np.array(rows).reshape(-1, columns)

    def intersect(
        self, origins: Array, directions: Array, max_range: float = np.inf
    ) -> tuple[Array, NDArray[np.int16], Array]:
        """Nearest surface along each ray.

        Parameters
        ----------
        origins, directions : ndarray of shape (n, 3), metres and unit vectors, local
        max_range : float, metres

        Returns
        -------
        ranges : ndarray of shape (n,), metres; infinite where nothing is hit
        labels : ndarray of shape (n,); -1 where nothing is hit
        cosines : ndarray of shape (n,)
            Cosine of the angle of incidence.
        """
        ranges, cosines = np.empty(len(origins)), np.empty(len(origins))
        labels = np.empty(len(origins), dtype=np.int16)
        cast_rays(
            np.ascontiguousarray(origins), np.ascontiguousarray(directions), max_range,
            self.rectangles, self.cylinders, self.spheres, ranges, labels, cosines,
        )  # fmt: skip
        if self.meshes is not None:
            far, number, cosine = self.meshes.intersect(origins, directions, max_range)
            nearer = far < ranges
            first_mesh = len(self.rectangles) + len(self.cylinders) + len(self.spheres)
            ranges[nearer], cosines[nearer] = far[nearer], cosine[nearer]
            labels[nearer] = first_mesh + number[nearer]
        return ranges, labels, cosines
