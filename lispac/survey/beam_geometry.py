"""The shape of a scanner's beams: a plane, a cone or several cones through the optical centre.

The beams of a profiler lie in a plane or on a cone about the axis of its mirror. The beams of each
laser of a spinning scanner lie on a cone about the common axis. Points that are correctly recovered
from a georeferenced cloud lie on these surfaces too, independent of their range noise.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

FITTED_POINT_SHARE = 0.9
"""Share of the points, those with the smallest residuals, used in the fit."""
FIT_ITERATIONS = 3
"""Number of fits; each uses the points with the smallest residuals of the previous one."""
SIGMA_PER_MAD = 1.4826
"""Ratio of the standard deviation of a normal distribution to its median absolute deviation."""


@dataclass(frozen=True, eq=False)
class BeamCone:
    """A plane, a cone or several cones through the optical centre that points lie on.

    A point p lies on a cone where ``axis . p = cosine |p|``; a plane has the cosine 0.

    Attributes
    ----------
    axis : ndarray of shape (3,), no unit, LiDAR frame
    cosines : ndarray of shape (rings,), no unit
        Cosine of the angle between axis and beams; a single one for a plane or one cone.
    residual : float, metres
        Robust standard deviation of the points from the plane or their cone.
    """

    axis: Array
    cosines: Array
    residual: float


def fit_plane(points_lidar: Array) -> BeamCone:
    """Fit a plane through the optical centre by trimmed least squares.

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
        At least ten, none in the optical centre.
    """
    return _fit_beams(points_lidar, None)


def fit_cone(points_lidar: Array) -> BeamCone:
    """Fit a cone with its apex in the optical centre by trimmed least squares.

    For a given axis the best cosine follows in closed form, so that the axis is the eigenvector of
    the smallest eigenvalue of a 3 x 3 matrix (Golub and Van Loan 2013, 8.1).

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
        At least ten, none in the optical centre.
    """
    return _fit_beams(points_lidar, np.zeros(len(points_lidar), dtype=np.int64))


def fit_cones(points_lidar: Array, ring: NDArray[np.int64]) -> BeamCone:
    """Fit one cone per ring, with a common axis and the apex in the optical centre.

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
        At least ten, none in the optical centre.
    ring : ndarray of shape (n,), int
        Number of the laser, from 0.
    """
    return _fit_beams(points_lidar, ring)


def beam_direction_spread(points_lidar: Array) -> float:
    """Spread of the beam directions, radians: standard deviation in the direction of its maximum.

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    """
    directions = points_lidar / np.linalg.norm(points_lidar, axis=1)[:, None]
    return float(np.sqrt(np.linalg.eigvalsh(np.cov(directions.T))[-1]))


def _fit_beams(points_lidar: Array, ring: NDArray[np.int64] | None) -> BeamCone:
    ranges = np.linalg.norm(points_lidar, axis=1)
    kept = np.ones(len(points_lidar), dtype=bool)
    axis, cosines, residuals = np.zeros(3), np.zeros(1), ranges
    laser_of_point = np.zeros(len(points_lidar), dtype=np.int64) if ring is None else ring
    rings = int(laser_of_point.max()) + 1
    for _ in range(FIT_ITERATIONS):
        points, r, laser = points_lidar[kept], ranges[kept], laser_of_point[kept]
        means = np.zeros((rings, 3))
        if ring is not None:
            # The best cosine of each ring for any axis, in closed form
            squares = np.bincount(laser, r**2, rings)
            for k in range(3):
                sums = np.bincount(laser, r * points[:, k], rings)
                means[:, k] = sums / np.where(squares > 0, squares, 1.0)
        offsets = points - r[:, None] * means[laser]
        axis = np.linalg.eigh(offsets.T @ offsets)[1][:, 0]
        cosines = means @ axis
        residuals = np.abs(points_lidar @ axis - cosines[laser_of_point] * ranges)
        kept = residuals <= np.quantile(residuals, FITTED_POINT_SHARE)
    return BeamCone(axis, cosines, float(SIGMA_PER_MAD * np.median(residuals)))
