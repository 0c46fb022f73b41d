"""Least-squares plane through each neighbourhood of a cloud."""

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit

Points = NDArray[np.float64]
Indices = NDArray[np.intp]

# Smallest ratio of the second to the largest principal variance of a neighbourhood. Below it, the
# points lie on a straight line, which does not determine a plane.
_MIN_VARIANCE_RATIO = 1e-12
_MAX_SWEEPS = 12  # each of them rotates all three off-diagonal elements to zero


@njit(nogil=True, cache=True)
def _diagonalise(a: NDArray[np.float64], v: NDArray[np.float64]) -> None:
    """Cyclic Jacobi rotations: ``a`` (3, 3, symmetric) becomes diagonal, ``v`` its eigenvectors.

    Golub and Van Loan, Matrix Computations, the chapter on Jacobi methods.

    The rotations are slower than the trigonometric formula, but accurate to rounding even if two
    eigenvalues are nearly equal, as in a square patch of points.
    """
    for i in range(3):
        for j in range(3):
            v[i, j] = 1.0 if i == j else 0.0
    for _ in range(_MAX_SWEEPS):
        off = a[0, 1] ** 2 + a[0, 2] ** 2 + a[1, 2] ** 2
        if off <= 1e-34 * (a[0, 0] ** 2 + a[1, 1] ** 2 + a[2, 2] ** 2):
            return
        for p in range(2):
            for q in range(p + 1, 3):
                if a[p, q] == 0.0:
                    continue
                theta = (a[q, q] - a[p, p]) / (2.0 * a[p, q])
                t = 1.0 / (abs(theta) + np.sqrt(theta * theta + 1.0))
                if theta < 0.0:
                    t = -t
                c = 1.0 / np.sqrt(t * t + 1.0)
                s = t * c
                r = 3 - p - q
                a[p, p] -= t * a[p, q]
                a[q, q] += t * a[p, q]
                a[p, q] = a[q, p] = 0.0
                arp, arq = a[r, p], a[r, q]
                a[r, p] = a[p, r] = c * arp - s * arq
                a[r, q] = a[q, r] = s * arp + c * arq
                for i in range(3):
                    vip, viq = v[i, p], v[i, q]
                    v[i, p] = c * vip - s * viq
                    v[i, q] = s * vip + c * viq


def local_planes(
    points: Points, neighbours: Indices, counts: Indices | None = None
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Least-squares plane through each group of points.

    Parameters
    ----------
    points : ndarray of shape (m, 3), metres, any frame
    neighbours : ndarray of shape (n, k)
        Indices into ``points`` of each group.
    counts : ndarray of shape (n,), optional
        Number of valid entries in each row; all if omitted.

    Returns
    -------
    centroids : ndarray of shape (n, 3), metres, same frame
    normals : ndarray of shape (n, 3), same frame
        Unit vectors of either sign; NaN if the group has fewer than three points, or if all its
        points lie on one straight line or coincide.
    """
    if counts is None:
        counts = np.full(len(neighbours), neighbours.shape[1], dtype=np.intp)
    centroids, normals = local_planes_kernel(points, neighbours, counts)
    return centroids, normals


@njit(nogil=True, cache=True)
def local_planes_kernel(
    points: Points, neighbours: Indices, counts: Indices
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:  # pragma: no cover - compiled
    """Compiled part of the computation; for arguments and results see `local_planes`."""
    n, width = neighbours.shape
    centroids = np.empty((n, 3))
    normals = np.empty((n, 3))
    local = np.empty((width, 3))
    covariance = np.empty((3, 3))
    vectors = np.empty((3, 3))
    for row in range(n):
        k = counts[row]
        # Coordinates relative to one point: sums of large coordinates (UTM) would lose digits.
        first = neighbours[row, 0]
        for axis in range(3):
            total = 0.0
            for j in range(k):
                local[j, axis] = points[neighbours[row, j], axis] - points[first, axis]
                total += local[j, axis]
            mean = total / max(k, 1)
            for j in range(k):
                local[j, axis] -= mean
            centroids[row, axis] = points[first, axis] + mean
        for i in range(3):
            for j in range(i, 3):
                total = 0.0
                for g in range(k):
                    total += local[g, i] * local[g, j]
                covariance[i, j] = covariance[j, i] = total
        _diagonalise(covariance, vectors)
        smallest, largest = 0, 0
        for axis in range(1, 3):
            if covariance[axis, axis] < covariance[smallest, smallest]:
                smallest = axis
            if covariance[axis, axis] >= covariance[largest, largest]:
                largest = axis
        middle = 3 - smallest - largest
        spread = (
            k >= 3
            and covariance[middle, middle] > _MIN_VARIANCE_RATIO * covariance[largest, largest]
        )
        for axis in range(3):
            normals[row, axis] = vectors[axis, smallest] if spread else np.nan
    return centroids, normals


@njit(nogil=True, cache=True)
def planes_of_groups(
    points: Points, ends: Indices
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:  # pragma: no cover - compiled
    """Least-squares plane through each group of points, where the groups have different sizes.

    Parameters
    ----------
    points : ndarray of shape (m, 3), metres, any frame
        Points of one group after the other.
    ends : ndarray of shape (n,), int
        Index after the last point of each group; no group is empty.

    Returns
    -------
    centroids, normals : ndarrays of shape (n, 3)
        As of `local_planes`.
    """
    centroids, normals = np.empty((len(ends), 3)), np.empty((len(ends), 3))
    begin = 0
    for k in range(len(ends)):
        own = np.arange(begin, ends[k]).reshape((1, -1))
        centroid, normal = local_planes_kernel(points, own, np.array([own.size]))
        centroids[k], normals[k] = centroid[0], normal[0]
        begin = ends[k]
    return centroids, normals
