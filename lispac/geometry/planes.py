"""Planes: type, least-squares fit, and directions and sizes within a plane."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.errors import PlaneNotFound
from lispac.messages import error

Array = NDArray[np.float64]

# Smallest ratio of the second to the largest principal standard deviation of points of a plane;
# below it, they lie on one straight line. For spheres, the same limit holds for the smallest one.
MIN_SPREAD_RATIO = 1e-6

LEVEL_LIMIT_RAD = np.radians(10.0)
"""Inclination below which a plane is horizontal and its axes are west and north."""
ROBUST_ITERATIONS = 12  # of `fit_plane_robustly`


@dataclass(frozen=True, eq=False)
class Plane:
    """The points X with ``normal . X + d = 0``.

    Attributes
    ----------
    normal : ndarray of shape (3,), unit vector, any frame
    d : float, metres
    """

    normal: Array
    d: float

    def distances(self, points: Array) -> Array:
        """Signed distance of each point, positive on the side to which the normal points.

        Parameters
        ----------
        points : ndarray of shape (..., 3), metres, in the plane's frame

        Returns
        -------
        ndarray of shape (...), metres
        """
        signed: Array = points @ self.normal + self.d
        return signed

    def flipped(self) -> "Plane":
        """The same plane with its normal reversed."""
        return Plane(-self.normal, -self.d)

    def facing(self, direction: Array) -> "Plane":
        """The same plane, with its normal towards ``direction``, shape (3,), in its frame."""
        return self if float(self.normal @ direction) >= 0.0 else self.flipped()

    def tilt_to(self, other: "Plane") -> float:
        """Angle between the two planes, radians in [0, pi/2]."""
        along = abs(float(self.normal @ other.normal))
        across = float(np.linalg.norm(np.cross(self.normal, other.normal)))
        return float(np.arctan2(across, along))


def plane_through(point: Array, normal: Array) -> Plane:
    """Plane through ``point``, perpendicular to ``normal``, both of shape (3,), same frame."""
    unit = normal / np.linalg.norm(normal)
    return Plane(unit, -float(unit @ point))


def fit_plane(points: Array, weights: Array | None = None) -> Plane:
    """Fit a plane by least squares of the orthogonal distances (Pearson 1901).

    The normal's largest component is positive, so that equal points give equal planes.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, any frame
    weights : ndarray of shape (n,), optional
        Not negative; all equal if omitted.

    Raises
    ------
    PlaneNotFound
        Fewer than three points, all on one straight line, or coordinates that are not finite.
    """
    if len(points) < 3:
        raise PlaneNotFound(error("target.plane_few_points", count=len(points)))
    # Centred coordinates: products of UTM coordinates would not resolve millimetres.
    if weights is None:
        centre = points.mean(axis=0)
        centred = points - centre
        scatter = centred.T @ centred
    else:
        centre, scatter = _weighted_scatter(points, weights, np.empty((2, *points.shape)))
    return _plane_of(centre, scatter)


def _weighted_scatter(points: Array, weights: Array, work: Array) -> tuple[Array, Array]:
    """Weighted centre (3,) of points (n, 3), metres, and the matrix of their scatter around it.

    Parameters
    ----------
    work : ndarray of shape (2, n, 3)
        Memory for intermediate values: for many points, new memory takes longer than the values.
    """
    centred, weighted = work
    centre = weights @ points / weights.sum()
    for axis in range(3):  # NumPy is slow on rows of three
        np.subtract(points[:, axis], centre[axis], out=centred[:, axis])
        np.multiply(centred[:, axis], weights, out=weighted[:, axis])
    return centre, weighted.T @ centred


def _plane_of(centre: Array, scatter: Array) -> Plane:
    """Plane through the centre of points, from the matrix of their scatter around it.

    Raises
    ------
    PlaneNotFound
        The points are on one straight line, or their coordinates are not finite.
    """
    if not np.all(np.isfinite(scatter)):
        raise PlaneNotFound(error("target.plane_not_finite"))
    spread, axes = np.linalg.eigh(scatter)
    if spread[1] <= spread[2] * MIN_SPREAD_RATIO**2:
        raise PlaneNotFound(error("target.plane_on_line"))
    normal = axes[:, 0]
    normal = normal * np.sign(normal[np.argmax(np.abs(normal))])
    return plane_through(centre, normal)


def fit_plane_robustly(points: Array, nearest: float) -> Plane:
    """Fit a plane by the least sum of distances, which tolerates about one third of outliers.

    Reweighted least squares with weights from the distances (Schlossmacher 1973), with a fixed
    number of iterations: the result is an initial value and need not be converged.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, any frame
    nearest : float, metres
        Points nearer to the plane than this have equal weights.

    Raises
    ------
    PlaneNotFound
        Fewer than three points, all on one straight line, or coordinates that are not finite.
    """
    plane, work = fit_plane(points), np.empty((2, *points.shape))
    for _ in range(ROBUST_ITERATIONS):
        weights = np.abs(plane.distances(points))
        np.divide(nearest, np.maximum(weights, nearest, out=weights), out=weights)
        plane = _plane_of(*_weighted_scatter(points, weights, work))
    return plane


def rms_distance(plane: Plane, points: Array) -> float:
    """Root mean square distance of points (n, 3) to a plane in their frame, metres."""
    return float(np.sqrt(np.mean(plane.distances(points) ** 2)))


def plane_axes(normal: Array, level_limit: float = 1e-3) -> Array:
    """Two unit vectors in the plane: the horizontal one and the one up the slope.

    If the plane is horizontal, the axes are west and north.

    Parameters
    ----------
    normal : ndarray of shape (3,), unit vector in the local frame
    level_limit : float, radians
        Inclination below which a plane is horizontal.

    Returns
    -------
    ndarray of shape (2, 3)
        Rows: horizontal (direction of the width), and up the slope (direction of the height).
    """
    level = np.array([-normal[1], normal[0], 0.0])
    flat = float(np.hypot(normal[0], normal[1])) < np.sin(level_limit)
    if flat:
        level = np.array([0.0, 1.0, 0.0]) - normal[1] * normal
    level = level / np.linalg.norm(level)
    # The cross product, upwards unless the plane is horizontal; `numpy.cross` is slow.
    slope = np.array(
        [
            normal[1] * level[2] - normal[2] * level[1],
            normal[2] * level[0] - normal[0] * level[2],
            normal[0] * level[1] - normal[1] * level[0],
        ]
    )
    if flat and slope[0] < 0.0:
        slope = -slope
    return np.stack([level, slope])


def extent_in_plane(plane: Plane, points: Array) -> Array:
    """Width (level) and height (up the slope) that points (n, 3) span on a plane in their frame.

    Returns
    -------
    ndarray of shape (2,), metres
    """
    # Rows instead of columns: NumPy finds the extremes of contiguous numbers much faster.
    span: Array = np.ptp(plane_axes(plane.normal) @ points.T, axis=1)
    return span
