"""Fast search for the points of a cloud inside a sphere.

There are two methods with the same result. `points_within` reads the whole cloud without
preparation and takes about two milliseconds for a million points. `PointGrid` sorts the cloud into
cells once and then reads only the cells that the sphere intersects, which is faster for clouds of
some millions of points or more.
"""

import os
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Cells = tuple[Array, Indices, Indices, Array, float, Indices]

# Smallest number of points for each thread.
MIN_POINTS_PER_THREAD = 250_000


def points_within(points: Array, centre: Array, radius: float) -> Indices:
    """Indices of the finite points within ``radius`` of ``centre``, ascending.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, same frame
    centre : ndarray of shape (3,), metres, same frame
    radius : float, metres

    Returns
    -------
    ndarray of shape (m,), int64
    """
    x, y, z = (float(c) for c in centre)
    workers = min(os.cpu_count() or 1, max(1, len(points) // MIN_POINTS_PER_THREAD))
    if workers == 1:
        return _scan_within_radius(points, x, y, z, radius, 0)
    edges = np.linspace(0, len(points), workers + 1).astype(int)
    with ThreadPoolExecutor(workers) as pool:
        found = pool.map(
            lambda i: _scan_within_radius(
                points[edges[i] : edges[i + 1]], x, y, z, radius, edges[i]
            ),
            range(workers),
        )
        return np.concatenate(list(found))


def nearest_point(points: Array, centre: Array) -> tuple[int, float]:
    """Index and distance of the finite point nearest to ``centre``; (-1, inf) if there is none.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, same frame
    centre : ndarray of shape (3,), metres, same frame
    """
    x, y, z = (float(c) for c in centre)
    index, squared = _nearest_finite_point(points, x, y, z)
    return int(index), float(np.sqrt(squared))


class PointGrid:
    """A cloud sorted into cubic cells, for many sphere queries.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres
        Not copied; the array must not change afterwards.
    cell : float, metres
        Side of a cell; increased if a large cloud would need too many cells.

    Attributes
    ----------
    cells : tuple
        Argument of `gather_within_radius`: points, start of each cell in the order, order of the
        points, lowest corner, side of the cells, and number of cells along each axis.
    """

    def __init__(self, points: Array, cell: float = 1.0) -> None:
        self.points = points
        low, high = finite_bounds(points)
        if not np.all(low <= high):  # no finite point at all
            low, high = np.zeros(3), np.zeros(3)
        limit = max(2**20, 2 * len(points))
        shape = _cell_counts(low, high, cell)
        while float(np.prod(shape.astype(float))) > limit:
            cell *= 1.5
            shape = _cell_counts(low, high, cell)
        starts, order = _sort_into_cells(points, low, cell, shape)
        self.cells: Cells = (points, starts, order, low, cell, shape)

    def within(self, centre: Array, radius: float) -> Indices:
        """Indices of the points within a radius, as `points_within`, from the prepared cells."""
        found = gather_within_radius(self.cells, np.asarray(centre, dtype=np.float64), radius)
        found.sort()
        return found


def _cell_counts(low: Array, high: Array, cell: float) -> Indices:
    return np.floor((high - low) / cell).astype(np.int64) + 1


@njit(nogil=True, cache=True)
def _scan_within_radius(
    points: Array, x: float, y: float, z: float, radius: float, first: int
) -> Indices:  # pragma: no cover - compiled
    limit = radius * radius
    found = np.empty(1024, np.int64)
    count = 0
    for i in range(points.shape[0]):
        dx = points[i, 0] - x
        if abs(dx) > radius:
            continue
        dy = points[i, 1] - y
        dz = points[i, 2] - z
        if dx * dx + dy * dy + dz * dz <= limit:
            if count == found.size:
                larger = np.empty(2 * count, np.int64)
                larger[:count] = found
                found = larger
            found[count] = first + i
            count += 1
    return found[:count].copy()


@njit(nogil=True, cache=True)
def _nearest_finite_point(
    points: Array, x: float, y: float, z: float
) -> tuple[int, float]:  # pragma: no cover - compiled
    best = np.inf
    index = -1
    for i in range(points.shape[0]):
        dx = points[i, 0] - x
        dy = points[i, 1] - y
        dz = points[i, 2] - z
        squared = dx * dx + dy * dy + dz * dz
        if squared < best:
            best = squared
            index = i
    return index, best


@njit(nogil=True, cache=True)
def finite_bounds(points: Array) -> tuple[Array, Array]:  # pragma: no cover - compiled
    """Lowest and highest coordinates of the finite points of (n, k), each of shape (k,).

    NumPy's minimum along the first axis takes ten times as long. Without a finite point, the lowest
    coordinates are infinity and the highest minus infinity.
    """
    low = np.full(points.shape[1], np.inf)
    high = np.full(points.shape[1], -np.inf)
    for i in range(points.shape[0]):
        total = 0.0
        for k in range(points.shape[1]):
            total += points[i, k]
        if np.isfinite(total):
            for k in range(points.shape[1]):
                low[k] = min(low[k], points[i, k])
                high[k] = max(high[k], points[i, k])
    return low, high


@njit(nogil=True, cache=True)
def cell_keys(
    points: Array, low: Array, cell: float, rim: int = 0
) -> tuple[Indices, Indices]:  # pragma: no cover - compiled
    """Number of the cell of each point, and number of cells along each axis.

    Cells are numbered in the order of the first coordinate, then of the second, and so on.

    Parameters
    ----------
    points : ndarray of shape (n, k), metres
    low : ndarray of shape (k,), metres
        Lower bound of the coordinates of all points.
    cell : float, metres
    rim : int
        Number of empty cells before the first and after the last along each axis.

    Returns
    -------
    keys : ndarray of shape (n,), int64
    shape : ndarray of shape (k,), int64
    """
    n, axes = points.shape
    shape = np.zeros(axes, np.int64)
    for i in range(n):
        for k in range(axes):
            shape[k] = max(shape[k], int((points[i, k] - low[k]) / cell))
    shape += 1 + 2 * rim
    keys = np.empty(n, np.int64)
    for i in range(n):
        key = 0
        for k in range(axes):
            key = key * shape[k] + int((points[i, k] - low[k]) / cell) + rim
        keys[i] = key
    return keys, shape


@njit(nogil=True, cache=True)
def _sort_into_cells(
    points: Array, low: Array, cell: float, shape: Indices
) -> tuple[Indices, Indices]:  # pragma: no cover - compiled
    # A counting sort in two passes: a million points take some tens of milliseconds.
    starts = np.zeros(shape[0] * shape[1] * shape[2] + 1, np.int64)
    key = np.empty(points.shape[0], np.int64)
    for i in range(points.shape[0]):
        if np.isfinite(points[i, 0] + points[i, 1] + points[i, 2]):
            kx = int((points[i, 0] - low[0]) / cell)
            ky = int((points[i, 1] - low[1]) / cell)
            kz = int((points[i, 2] - low[2]) / cell)
            key[i] = (kx * shape[1] + ky) * shape[2] + kz
            starts[key[i] + 1] += 1
        else:
            key[i] = -1
    for k in range(1, starts.size):
        starts[k] += starts[k - 1]
    place = starts[:-1].copy()
    order = np.empty(starts[-1], np.int64)
    for i in range(points.shape[0]):
        if key[i] >= 0:
            order[place[key[i]]] = i
            place[key[i]] += 1
    return starts, order


@njit(nogil=True, cache=True)
def gather_within_radius(
    cells: Cells, centre: Array, radius: float
) -> Indices:  # pragma: no cover - compiled
    """Unordered indices of the points in a sphere, as `PointGrid.within`, for compiled loops."""
    points, starts, order, low, cell, shape = cells
    limit = radius * radius
    first = np.empty(3, np.int64)
    last = np.empty(3, np.int64)
    for k in range(3):
        first[k] = max(0, int(np.floor((centre[k] - radius - low[k]) / cell)))
        last[k] = min(shape[k] - 1, int(np.floor((centre[k] + radius - low[k]) / cell)))
    found = np.empty(1024, np.int64)
    count = 0
    for kx in range(first[0], last[0] + 1):
        for ky in range(first[1], last[1] + 1):
            row = (kx * shape[1] + ky) * shape[2]
            if first[2] > last[2]:
                continue
            for j in range(starts[row + first[2]], starts[row + last[2] + 1]):
                i = order[j]
                dx = points[i, 0] - centre[0]
                dy = points[i, 1] - centre[1]
                dz = points[i, 2] - centre[2]
                if dx * dx + dy * dy + dz * dz <= limit:
                    if count == found.size:
                        larger = np.empty(2 * count, np.int64)
                        larger[:count] = found
                        found = larger
                    found[count] = i
                    count += 1
    return found[:count].copy()
