"""Offset and rotations between two clouds of the same plane, with confidence intervals.

A plane z = z0 + a u + b v is fitted to each cloud in a common frame. The covariance of the
difference of the two is the sum of their covariances. Unlike the angle between the normals, which
is never negative, the two rotations have a sign and a valid confidence interval.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.errors import NotComparable
from lispac.geometry.planes import LEVEL_LIMIT_RAD, fit_plane_robustly, plane_axes
from lispac.messages import error

Array = NDArray[np.float64]

UNKNOWN_COUNT, MAX_FIT_ITERATIONS = 3, 4
"""Number of parameters of a plane, and largest number of fits without outliers."""
SIGMA_PER_MAD = 1.4826
"""Ratio of the standard deviation of normal noise to its median absolute deviation."""
OUTLIER_LIMIT_SIGMAS = 3.5
"""Number of robust sigmas beyond which a point is excluded and counted as an outlier."""
MIN_NOISE_M = 1e-9
"""Smallest noise that can be distinguished from rounding."""
EQUAL_WEIGHT_DISTANCE_M = 1e-4
"""Distance from the plane within which all points have the same weight in the first fit."""


@dataclass(frozen=True)
class PlaneOffset:
    """Offset and rotations from the plane of one cloud to that of another, at their common centre.

    Attributes
    ----------
    offset, offset_95 : float, metres
        Offset, positive towards ``facing``, and half its 95 % interval.
    rotation_horizontal_axis, rotation_slope_axis : float, radians
        Rotations about the horizontal axis in the plane and about the axis up its slope; on a
        horizontal plane, about west and north.
    rotation_horizontal_axis_95, rotation_slope_axis_95 : float, radians
        Half their 95 % intervals.
    outliers : int
        Number of excluded outliers of both clouds.
    """

    offset: float
    offset_95: float
    rotation_horizontal_axis: float
    rotation_horizontal_axis_95: float
    rotation_slope_axis: float
    rotation_slope_axis_95: float
    outliers: int

    @property
    def angle(self) -> float:
        """Angle between the two normals, radians; an approximation for small angles."""
        return float(np.hypot(self.rotation_horizontal_axis, self.rotation_slope_axis))


def plane_offset(compared: Array, reference: Array, facing: Array) -> PlaneOffset:
    """Offset and rotations from the plane of the reference to that of the compared cloud.

    Parameters
    ----------
    compared, reference : ndarrays of shape (n, 3) and (m, 3), metres, same frame
        Points of the common part.
    facing : ndarray of shape (3,)
        Direction towards which the normal is oriented.

    Raises
    ------
    NotComparable
        If a cloud has fewer than four points, or its points lie on one straight line.
    """
    from scipy.special import stdtrit

    both = (compared, reference)
    if min(map(len, both)) <= UNKNOWN_COUNT:
        raise NotComparable(error("validation.plane_few_points"))
    # Each cloud is centred, because their offset before the calibration would tilt a common plane.
    middles = [np.median(points, axis=0) for points in both]
    centred = np.concatenate(
        [points - middle for points, middle in zip(both, middles, strict=True)]
    )
    normal = fit_plane_robustly(centred, EQUAL_WEIGHT_DISTANCE_M).facing(facing).normal
    frame = np.vstack((plane_axes(normal, LEVEL_LIMIT_RAD), normal))
    middle = np.mean(middles, axis=0)
    fits = [_fit_plane_robustly((points - middle) @ frame.T) for points in both]
    difference = fits[0].values - fits[1].values
    shares = np.array([fit.variances for fit in fits])
    total = shares.sum(axis=0)
    freedom = np.array([[fit.freedom] for fit in fits])
    scattered = np.maximum((shares**2 / freedom).sum(axis=0), np.finfo(float).tiny)
    # Welch 1947, as in `normal_distance`.
    half = stdtrit(np.maximum(total**2 / scattered, 1.0), 0.975) * np.sqrt(total)
    # The slope along the horizontal axis u is a rotation about the slope axis, and vice versa.
    return PlaneOffset(
        offset=float(difference[0]),
        offset_95=float(half[0]),
        rotation_horizontal_axis=float(np.arctan(difference[2])),
        rotation_horizontal_axis_95=float(half[2]),
        rotation_slope_axis=float(np.arctan(difference[1])),
        rotation_slope_axis_95=float(half[1]),
        outliers=sum(fit.outliers for fit in fits),
    )


@dataclass(frozen=True, eq=False)
class _PlaneFit:
    values: Array
    variances: Array
    freedom: int
    outliers: int


def _fit_plane_robustly(placed: Array) -> _PlaneFit:
    """Fit z as a linear function of u and v to points (n, 3) by least squares without outliers.

    Raises
    ------
    NotComparable
        If the points lie on one straight line.
    """
    terms = np.column_stack((np.ones(len(placed)), placed[:, :2]))
    z = placed[:, 2]
    kept = np.ones(len(z), dtype=bool)
    for _ in range(MAX_FIT_ITERATIONS):
        values = np.linalg.lstsq(terms[kept], z[kept], rcond=None)[0]
        residuals = z - terms @ values
        sigma = SIGMA_PER_MAD * float(np.median(np.abs(residuals[kept])))
        # Residuals of points exactly on a plane are rounding errors; all points are kept.
        is_inlier = np.abs(residuals) <= OUTLIER_LIMIT_SIGMAS * max(sigma, MIN_NOISE_M)
        if np.array_equal(is_inlier, kept) or np.count_nonzero(is_inlier) <= UNKNOWN_COUNT:
            break
        kept = is_inlier
    used = terms[kept]
    values, _, rank, _ = np.linalg.lstsq(used, z[kept], rcond=None)
    if rank < UNKNOWN_COUNT:
        raise NotComparable(error("validation.points_in_row"))
    freedom = len(used) - UNKNOWN_COUNT
    variance = float(((z[kept] - used @ values) ** 2).sum()) / freedom
    variances = variance * np.diag(np.linalg.inv(used.T @ used))
    return _PlaneFit(np.asarray(values, dtype=np.float64), variances, freedom, len(z) - len(used))
