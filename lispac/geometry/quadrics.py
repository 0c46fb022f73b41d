"""Least-squares quadrics over small groups of points, for curved surfaces.

The quadric is a height above the plane through the group, as in the local models of CloudCompare.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit

Array = NDArray[np.float64]
Indices = NDArray[np.intp]

TERM_COUNT = 6
"""Number of coefficients of a quadric."""
_MIN_PIVOT = 1e-10
"""Smallest pivot of the normal equations, in scaled coordinates, for a determined quadric."""


@dataclass(frozen=True, eq=False)
class Quadrics:
    """Heights over planes: h = c0 + c1 x + c2 y + c3 x^2 + c4 xy + c5 y^2.

    Attributes
    ----------
    axes : ndarray of shape (n, 3, 3), frame of the points
        Rows: x and y in the plane, then its normal.
    scale : ndarray of shape (n,), metres
        Unit of x, y and h: RMS distance of the points from their centroid.
    coefficients : ndarray of shape (n, 6)
        NaN if the points do not determine a quadric.
    """

    axes: Array
    scale: Array
    coefficients: Array


def local_quadrics(
    points: Array, groups: Indices, counts: Indices, centroids: Array, normals: Array
) -> Quadrics:
    """Fit a quadric to each group of points, over the plane through the group.

    Parameters
    ----------
    points : ndarray of shape (m, 3), metres, any frame
    groups : ndarray of shape (n, k)
        Indices into ``points``.
    counts : ndarray of shape (n,)
        Number of valid entries in each row.
    centroids, normals : ndarrays of shape (n, 3), same frame
        From `local_planes.local_planes`.
    """
    return Quadrics(*_fit_quadrics(points, groups, counts, centroids, normals))


def heights_above(quadrics: Quadrics, offsets: Array, which: Indices) -> Array:
    """Height of each point over its quadric, along the normal of its plane; shape (p,), metres.

    Parameters
    ----------
    offsets : ndarray of shape (p, 3), metres, frame of the quadrics
        From the centroid of the quadric's group.
    which : ndarray of shape (p,)
        Index of the quadric for each point.
    """
    scale = quadrics.scale[which]
    x, y, h = np.einsum("pij,pj->ip", quadrics.axes[which], offsets) / scale
    c = quadrics.coefficients[which].T
    on = c[0] + c[1] * x + c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y
    above: Array = (h - on) * scale
    return above


@njit(nogil=True, cache=True)
def _fit_quadrics(
    points: Array, groups: Indices, counts: Indices, centroids: Array, normals: Array
) -> tuple[Array, Array, Array]:  # pragma: no cover - compiled
    n = groups.shape[0]
    axes = np.full((n, 3, 3), np.nan)
    scales = np.ones(n)
    coefficients = np.full((n, TERM_COUNT), np.nan)
    row = np.empty(TERM_COUNT)
    normal_matrix = np.empty((TERM_COUNT, TERM_COUNT + 1))
    for g in range(n):
        count = counts[g]
        if count < TERM_COUNT or np.isnan(normals[g, 0]):
            continue
        # Any two axes in the plane can be used: the fit does not depend on their orientation.
        least = np.argmin(np.abs(normals[g]))
        x_axis = np.zeros(3)
        x_axis[least] = 1.0
        x_axis -= normals[g, least] * normals[g]
        x_axis /= np.sqrt((x_axis * x_axis).sum())
        axes[g, 0] = x_axis
        axes[g, 1] = np.cross(normals[g], x_axis)
        axes[g, 2] = normals[g]
        total = 0.0
        for j in range(count):
            total += ((points[groups[g, j]] - centroids[g]) ** 2).sum()
        scale = np.sqrt(total / count)
        scales[g] = scale
        normal_matrix[:] = 0.0
        for j in range(count):
            x, y, h = 0.0, 0.0, 0.0
            for axis in range(3):
                off = (points[groups[g, j], axis] - centroids[g, axis]) / scale
                x += off * axes[g, 0, axis]
                y += off * axes[g, 1, axis]
                h += off * axes[g, 2, axis]
            row[0], row[1], row[2], row[3], row[4], row[5] = 1.0, x, y, x * x, x * y, y * y
            for a in range(TERM_COUNT):
                for b in range(TERM_COUNT):
                    normal_matrix[a, b] += row[a] * row[b]
                normal_matrix[a, TERM_COUNT] += row[a] * h
        if _solve_symmetric(normal_matrix):
            coefficients[g] = normal_matrix[:, TERM_COUNT]
    return axes, scales, coefficients


@njit(nogil=True, cache=True)
def _solve_symmetric(system: Array) -> bool:  # pragma: no cover - compiled
    """Solve a symmetric positive definite system (k, k + 1) by Gauss-Jordan elimination.

    The solution replaces the last column. False if the system is singular.
    """
    size = system.shape[0]
    for k in range(size):
        # A small remaining diagonal element shows that the term depends on those before it.
        own = system[k, k]
        if own <= _MIN_PIVOT:
            return False
        for column in range(k, size + 1):
            system[k, column] /= own
        for other in range(size):
            if other != k:
                factor = system[other, k]
                for column in range(k, size + 1):
                    system[other, column] -= factor * system[k, column]
    return True
