"""Offset and angle between two clouds that saw the same plane, with their confidence.

Either cloud gives a plane z = z0 + a u + b v over the frame of both; the difference of the two
has the sum of their covariances. Unlike an angle between normals, which is never negative, its
two turns have a sign, and an interval that holds.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.errors import NotComparable
from lispac.geometry.planes import fit_plane_robustly, plane_axes
from lispac.messages import error

Array = NDArray[np.float64]

UNKNOWNS, ROUNDS = 3, 4
NMAD = 1.4826
"""Standard deviation of normal noise over its median absolute value."""
OUTLIER_LIMIT = 3.5
"""Robust sigmas beyond which a point is an outlier: excluded, and counted."""
FINEST = 1e-9
"""Metres; the smallest noise distinguishable from rounding."""
NEAREST = 1e-4
"""Metres; nearer to the plane all points weigh the same in its first fit."""


@dataclass(frozen=True)
class PlaneOffset:
    """Offset of one cloud's plane from another's, at the middle of the common part.

    Attributes
    ----------
    offset, offset_95 : float, metres
        Positive towards ``facing``, and half the 95 % interval.
    rotation_horizontal_axis, rotation_slope_axis : float, radians
        About the level axis in the plane (one leans to the other) and about the axis up its
        slope.
    rotation_horizontal_axis_95, rotation_slope_axis_95 : float, radians
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
        """Between the two normals, radians, in [0, pi/2]."""
        return float(np.hypot(self.rotation_horizontal_axis, self.rotation_slope_axis))


def plane_offset(compared: Array, reference: Array, facing: Array) -> PlaneOffset:
    """Offset and turns of the compared cloud's plane from the reference's.

    Parameters
    ----------
    compared, reference : ndarrays of shape (n, 3) and (m, 3), metres, same frame
        Of the part that both saw.
    facing : ndarray of shape (3,)
        Direction on whose side the normal is taken.

    Raises
    ------
    NotComparable
        A cloud of fewer than four points, or on one straight line.
    """
    from scipy.special import stdtrit

    both = (compared, reference)
    if min(map(len, both)) <= UNKNOWNS:
        raise NotComparable(error("validation.plane_few_points"))
    # Apart before the calibration, the two would tilt a plane through all of them at once.
    middles = [np.median(points, axis=0) for points in both]
    centred = np.concatenate(
        [points - middle for points, middle in zip(both, middles, strict=True)]
    )
    normal = fit_plane_robustly(centred, NEAREST).facing(facing).normal
    frame = np.vstack((plane_axes(normal), normal))
    middle = np.mean(middles, axis=0)
    fits = [_fit_plane_robustly((points - middle) @ frame.T) for points in both]
    difference = fits[0].values - fits[1].values
    shares = np.array([fit.variances for fit in fits])
    total = shares.sum(axis=0)
    freedom = np.array([[fit.freedom] for fit in fits])
    scattered = np.maximum((shares**2 / freedom).sum(axis=0), np.finfo(float).tiny)
    # Welch 1947, as in `normal_distance`.
    half = stdtrit(np.maximum(total**2 / scattered, 1.0), 0.975) * np.sqrt(total)
    # z grows along the level axis u where the plane turns about the upright one, and the other way.
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
    """Least squares through points (n, 3): u, v, z; outliers excluded.

    Raises
    ------
    NotComparable
        Where the points lie in one row.
    """
    terms = np.column_stack((np.ones(len(placed)), placed[:, :2]))
    z = placed[:, 2]
    kept = np.ones(len(z), dtype=bool)
    for _ in range(ROUNDS):
        values = np.linalg.lstsq(terms[kept], z[kept], rcond=None)[0]
        off = z - terms @ values
        sigma = NMAD * float(np.median(np.abs(off[kept])))
        # Points that are exactly on a plane are off it by rounding alone, and all are kept.
        near = np.abs(off) <= OUTLIER_LIMIT * max(sigma, FINEST)
        if np.array_equal(near, kept) or np.count_nonzero(near) <= UNKNOWNS:
            break
        kept = near
    used = terms[kept]
    values, _, rank, _ = np.linalg.lstsq(used, z[kept], rcond=None)
    if rank < UNKNOWNS:
        raise NotComparable(error("validation.points_in_row"))
    freedom = len(used) - UNKNOWNS
    variance = float(((z[kept] - used @ values) ** 2).sum()) / freedom
    variances = variance * np.diag(np.linalg.inv(used.T @ used))
    return _PlaneFit(np.asarray(values, dtype=np.float64), variances, freedom, len(z) - len(used))
