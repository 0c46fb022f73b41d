"""What the beams meet: rectangles and upright cylinders, each met in closed form."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numba import njit
from numpy.typing import NDArray

Array = NDArray[np.float64]
UP = (0.0, 0.0, 1.0)


@dataclass(frozen=True, eq=False)
class Rectangle:
    """A flat rectangle, seen from both sides.

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
        """Centre, normal, and the two directions divided by half the extent: 12 numbers."""
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
        Where the axis stands.
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
        """Axis, bottom, top and radius: 5 numbers."""
        return np.array([self.north, self.west, self.bottom, self.top, self.radius])

    def distance(self, points_local: Array) -> Array:
        """Signed distance of points to the mantle, shape (n,), metres."""
        offset = points_local[:, :2] - (self.north, self.west)
        return np.asarray(np.hypot(offset[:, 0], offset[:, 1]) - self.radius)


Surface = Rectangle | Cylinder


def upright(
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
        Azimuth its front faces, clockwise from north.
    """
    azimuth = np.radians(facing_deg)
    normal = np.array([np.cos(azimuth), -np.sin(azimuth), 0.0])
    centre = np.array([foot[0], foot[1], (bottom + top) / 2])
    return Rectangle(name, centre, normal, np.cross(UP, normal), width, top - bottom, reflectance)


def tilted(
    name: str,
    centre: tuple[float, float, float],
    width: float,
    height: float,
    facing_deg: float,
    elevation_deg: float,
    reflectance: float = 0.4,
) -> Rectangle:
    """A rectangle of level width whose normal has an azimuth and rises by ``elevation_deg``."""
    azimuth, elevation = np.radians([facing_deg, elevation_deg])
    level = np.array([np.cos(azimuth), -np.sin(azimuth), 0.0])
    normal = np.cos(elevation) * level + np.sin(elevation) * np.array(UP)
    across = np.cross(UP, level)
    return Rectangle(name, np.array(centre), normal, across, width, height, reflectance)


def box(
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
        upright(f"{name}, north face", (north_end, w), bottom, top, depth, 0, reflectance),
        upright(f"{name}, east face", (n, east_end), bottom, top, length, 90, reflectance),
        upright(f"{name}, south face", (south_end, w), bottom, top, depth, 180, reflectance),
        upright(f"{name}, west face", (n, west_end), bottom, top, length, 270, reflectance),
        tilted(f"{name}, top", (n, w, top), length, depth, 270, 90, reflectance),
    ]


@dataclass(frozen=True, eq=False)
class Scene:
    """Surfaces; the nearest one a ray meets hides those behind it."""

    surfaces: tuple[Surface, ...]

    @classmethod
    def of(cls, surfaces: Sequence[Surface]) -> "Scene":
        """Rectangles first, so that one index counts through both kernels' arrays."""
        rectangles = [s for s in surfaces if isinstance(s, Rectangle)]
        cylinders = [s for s in surfaces if isinstance(s, Cylinder)]
        return cls((*rectangles, *cylinders))

    @property
    def names(self) -> tuple[str, ...]:
        """Name of each surface; labels are indices into it."""
        return tuple(surface.name for surface in self.surfaces)

    @property
    def reflectances(self) -> Array:
        """Reflectance of each surface."""
        return np.array([surface.reflectance for surface in self.surfaces])

    def __getitem__(self, name: str) -> Surface:
        return self.surfaces[self.names.index(name)]

    @cached_property
    def rectangles(self) -> Array:
        """Rows of the rectangles, shape (k, 12)."""
        rows = [s.row for s in self.surfaces if isinstance(s, Rectangle)]
        return np.array(rows).reshape(-1, 12)

    @cached_property
    def cylinders(self) -> Array:
        """Rows of the cylinders, shape (m, 5)."""
        rows = [s.row for s in self.surfaces if isinstance(s, Cylinder)]
        return np.array(rows).reshape(-1, 5)

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
        ranges : ndarray of shape (n,), metres; infinite where nothing is met
        labels : ndarray of shape (n,); -1 where nothing is met
        cosines : ndarray of shape (n,)
            Cosine of the angle of incidence.
        """
        ranges, cosines = np.empty(len(origins)), np.empty(len(origins))
        labels = np.empty(len(origins), dtype=np.int16)
        _intersect(
            np.ascontiguousarray(origins), np.ascontiguousarray(directions), max_range,
            self.rectangles, self.cylinders, ranges, labels, cosines,
        )  # fmt: skip
        return ranges, labels, cosines


@njit(nogil=True, cache=True, error_model="numpy")
def heights_above(ox, oy, oz, rectangles, heights):  # type: ignore[no-untyped-def]
    """How far the plane of each rectangle lies along its normal from an origin, into ``heights``.

    All rays that leave from there share it.
    """
    for i in range(len(rectangles)):
        heights[i] = (
            rectangles[i, 3] * (rectangles[i, 0] - ox)
            + rectangles[i, 4] * (rectangles[i, 1] - oy)
            + rectangles[i, 5] * (rectangles[i, 2] - oz)
        )


@njit(nogil=True, cache=True, error_model="numpy")
def nearest_hit(ox, oy, oz, dx, dy, dz, max_range, rectangles, cylinders, heights):  # type: ignore[no-untyped-def]
    """Range, surface index (-1 none) and cosine of incidence of one ray."""
    best, label, cosine = max_range, -1, 0.0
    for i in range(len(rectangles)):
        slope = rectangles[i, 3] * dx + rectangles[i, 4] * dy + rectangles[i, 5] * dz
        # Most are behind the ray or farther than what was met: a product tells it, a quotient takes
        # ten times as long. What is near the limit is left to the quotient.
        height = heights[i] if slope > 0.0 else -heights[i]
        if height <= 0.0 or height > 1.001 * best * abs(slope):
            continue
        t = heights[i] / slope
        if not 0.0 < t < best:
            continue
        x = ox + t * dx - rectangles[i, 0]
        y = oy + t * dy - rectangles[i, 1]
        z = oz + t * dz - rectangles[i, 2]
        if abs(rectangles[i, 6] * x + rectangles[i, 7] * y + rectangles[i, 8] * z) > 1.0:
            continue
        if abs(rectangles[i, 9] * x + rectangles[i, 10] * y + rectangles[i, 11] * z) > 1.0:
            continue
        best, label, cosine = t, i, abs(slope)
    a = dx * dx + dy * dy
    for i in range(len(cylinders)):
        radius = cylinders[i, 4]
        x, y = ox - cylinders[i, 0], oy - cylinders[i, 1]
        b = x * dx + y * dy
        discriminant = b * b - a * (x * x + y * y - radius * radius)
        if a == 0.0 or discriminant <= 0.0:
            continue
        root = np.sqrt(discriminant)
        for t in ((-b - root) / a, (-b + root) / a):
            if 0.0 < t < best and cylinders[i, 2] <= oz + t * dz <= cylinders[i, 3]:
                best, label, cosine = t, len(rectangles) + i, root / radius
    if label < 0:
        best = np.inf
    return best, label, cosine


@njit(nogil=True, cache=True)
def _intersect(origins, directions, max_range, rectangles, cylinders, ranges, labels, cosines):  # type: ignore[no-untyped-def]
    heights = np.empty(len(rectangles))
    for i in range(len(origins)):
        o, d = origins[i], directions[i]
        heights_above(o[0], o[1], o[2], rectangles, heights)
        ranges[i], labels[i], cosines[i] = nearest_hit(
            o[0], o[1], o[2], d[0], d[1], d[2], max_range, rectangles, cylinders, heights
        )
