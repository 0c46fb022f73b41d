"""The shape of a scanner's beams: a plane or a cone through the optical centre.

The beams of a profiler lie in a plane or on a cone about the axis of its mirror; points that were
recovered rightly from a georeferenced cloud lie there as well, whatever their noise in range.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

KEPT = 0.9
"""Share of the points, with the smallest misfits, that the fit goes by."""
ROUNDS = 3
"""Fits, each to the points kept by the one before."""
NORMAL = 1.4826
"""Standard deviation of a normal distribution over its median absolute deviation."""


@dataclass(frozen=True, eq=False)
class BeamCone:
    """A plane or cone through the optical centre that the points of a profiler lie on.

    A point p lies on it where ``axis . p = cosine |p|``; a plane has the cosine 0.

    Attributes
    ----------
    axis : ndarray of shape (3,), no unit, LiDAR frame
    cosine : float, no unit
        Of the angle between axis and beams.
    misfit : float, metres
        Robust standard deviation of the points from the plane or cone.
    """

    axis: Array
    cosine: float
    misfit: float


def fit_plane(points_lidar: Array) -> BeamCone:
    """Fit a plane through the optical centre by trimmed least squares.

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
        At least ten, none in the optical centre.
    """
    return _fitted(points_lidar, cone=False)


def fit_cone(points_lidar: Array) -> BeamCone:
    """Fit a cone with its apex in the optical centre by trimmed least squares.

    For a given axis the best cosine follows in closed form, so that the axis is the eigenvector of
    the smallest eigenvalue of a 3 x 3 matrix (Golub and Van Loan 2013, 8.1).

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
        At least ten, none in the optical centre.
    """
    return _fitted(points_lidar, cone=True)


def arc_of(points_lidar: Array) -> float:
    """Extent of the beam directions, radians: the standard deviation where it is largest.

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    """
    directions = points_lidar / np.linalg.norm(points_lidar, axis=1)[:, None]
    return float(np.sqrt(np.linalg.eigvalsh(np.cov(directions.T))[-1]))


def _fitted(points_lidar: Array, *, cone: bool) -> BeamCone:
    ranges = np.linalg.norm(points_lidar, axis=1)
    kept = np.ones(len(points_lidar), dtype=bool)
    axis, cosine, misfits = np.zeros(3), 0.0, ranges
    for _ in range(ROUNDS):
        points, r = points_lidar[kept], ranges[kept]
        mean = (r @ points) / (r @ r) if cone else np.zeros(3)
        off = points - np.outer(r, mean)
        axis = np.linalg.eigh(off.T @ off)[1][:, 0]
        cosine = float(mean @ axis)
        misfits = np.abs(points_lidar @ axis - cosine * ranges)
        kept = misfits <= np.quantile(misfits, KEPT)
    return BeamCone(axis, cosine, float(NORMAL * np.median(misfits)))
