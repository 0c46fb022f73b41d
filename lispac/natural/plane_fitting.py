"""Fit planes to many points with biweight weights (Beaton and Tukey 1974)."""

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


def fit_weighted_planes(
    points: Array, ends: Indices, centre: Array, normal: Array, far: Array
) -> tuple[Array, Array, Array]:
    """Fit planes with weights from the distances to the planes of the previous iteration.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
        Points of all planes, sorted by plane.
    ends : ndarray of shape (k,), int
        Index after the last point of each plane.
    centre, normal : ndarray of shape (k, 3), metres and unit vectors, local frame
        Planes of the previous iteration.
    far : ndarray of shape (k,), metres
        Distance beyond which a point has no weight; if infinite, all points have equal weights.

    Returns
    -------
    centre : ndarray of shape (k, 3), metres, local frame
    variances : ndarray of shape (k, 3), square metres
        Variances of the points along the axes, ascending.
    axes : ndarray of shape (k, 3, 3), unit vectors, local frame
        Principal axes in columns; the first is the normal.
    """
    total, moments = np.empty(len(ends)), np.empty((len(ends), 9))
    _weighted_moments(points, ends, centre, normal, far, total, moments)
    moments /= np.maximum(total, 1e-9)[:, None]
    centre, xx, xy, xz, yy, yz, zz = moments[:, :3], *moments[:, 3:].T
    products = np.stack([xx, xy, xz, xy, yy, yz, xz, yz, zz], axis=1).reshape(-1, 3, 3)
    variances, axes = np.linalg.eigh(products - centre[:, :, None] * centre[:, None, :])
    return np.ascontiguousarray(centre), variances, axes


@njit(nogil=True, cache=True, error_model="numpy")
def _weighted_moments(points, ends, centre, normal, far, total, moments):  # type: ignore[no-untyped-def]
    """Sum the weights, and the weighted coordinates and their products, for each plane.

    Compiled, because array operations on all points for the distances and weights were slower.
    """
    begin = 0
    for k in range(len(ends)):
        cx, cy, cz = centre[k]
        nx, ny, nz = normal[k]
        s = sx = sy = sz = xx = xy = xz = yy = yz = zz = 0.0
        for i in range(begin, ends[k]):
            x, y, z = points[i]
            off = ((x - cx) * nx + (y - cy) * ny + (z - cz) * nz) / far[k]
            w = max(1.0 - off * off, 0.0) ** 2
            wx, wy, wz = w * x, w * y, w * z
            s, sx, sy, sz = s + w, sx + wx, sy + wy, sz + wz
            xx, xy, xz = xx + wx * x, xy + wx * y, xz + wx * z
            yy, yz, zz = yy + wy * y, yz + wy * z, zz + wz * z
        total[k] = s
        moments[k] = (sx, sy, sz, xx, xy, xz, yy, yz, zz)
        begin = ends[k]
