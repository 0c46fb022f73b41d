"""Outline of a flat patch: connected raster cells of points on a plane."""

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
from lispac.geometry.radius_search import cell_keys, finite_bounds

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Flags = NDArray[np.bool_]

# Largest number of cells on each side of a raster; larger areas get larger cells.
MAX_CELLS_PER_SIDE = 1500


def outline_cell_size(placed: Array, votes: Array) -> float:
    """Side of a raster cell with which a patch has no holes.

    The side is three times the mean point spacing where the votes are. Profiles may be several
    times farther apart than the points along them, and their cells still have to touch.

    Parameters
    ----------
    placed : ndarray of shape (n, 2), metres in the plane
    votes : ndarray of shape (n,)
        Weight of each point in choosing the patch.

    Returns
    -------
    float, metres
    """
    middle = np.average(placed, axis=0, weights=votes)
    nearest = min(len(placed), max(30, len(placed) // 4)) - 1
    from_middle = np.partition(np.hypot(*(placed - middle).T), nearest)
    area = np.pi * max(float(from_middle[nearest]), 1e-3) ** 2
    return float(np.clip(3.0 * np.sqrt(area / (nearest + 1)), 0.02, 0.5))


def is_connected(placed: Array, votes: Array, cell: float) -> Flags:
    """Whether each point belongs to the connected patch with most of the votes.

    The points are assigned to raster cells; filled cells that touch, also at a corner, are
    connected.

    Parameters
    ----------
    placed : ndarray of shape (n, 2), metres in the plane
    votes : ndarray of shape (n,)
    cell : float, metres

    Returns
    -------
    ndarray of shape (n,), bool
    """
    low, high = finite_bounds(placed)
    cell_index, shape = cell_keys(placed, low, _limit_cell_count(cell, low, high), 1)
    filled = np.zeros(int(shape[0] * shape[1]), dtype=np.bool_)
    filled[cell_index] = True
    label = _label_components(filled, int(shape[1]))[cell_index]
    winner = np.argmax(np.bincount(label, weights=votes))
    same: Flags = label == winner
    return same


def share_in_cell(placed: Array, chosen: Flags, cell: float) -> Array:
    """Share of chosen points in the raster cell of each point.

    Parameters
    ----------
    placed : ndarray of shape (n, 2), metres in the plane
    chosen : ndarray of shape (n,), bool
    cell : float, metres

    Returns
    -------
    ndarray of shape (n,)
    """
    low, high = finite_bounds(placed)
    cell_index, _ = cell_keys(placed, low, _limit_cell_count(cell, low, high))
    share: Array = (
        np.bincount(cell_index, weights=chosen) / np.maximum(np.bincount(cell_index), 1)
    )[cell_index]
    return share


def is_covered(placed: Array, other: Array, cell: float) -> Flags:
    """Whether each point of ``placed`` has one of ``other`` in its cell or in a neighbouring cell.

    Parameters
    ----------
    placed, other : ndarrays of shape (n, 2) and (m, 2), metres in the same plane
    cell : float, metres

    Returns
    -------
    ndarray of shape (n,), bool
    """
    (low, high), (other_low, other_high) = finite_bounds(placed), finite_bounds(other)
    low, high = np.minimum(low, other_low), np.maximum(high, other_high)
    return _is_near_filled_cell(placed, other, low, high, _limit_cell_count(cell, low, high))


def filled_area(placed: Array, cell: float) -> float:
    """Area of the raster cells that points ``placed`` (n, 2), metres, fill, square metres."""
    return float(filled_areas(placed, np.array([len(placed)]), cell)[0])


@njit(nogil=True, cache=True)
def filled_areas(placed: Array, ends: Indices, cell: float) -> Array:  # pragma: no cover - compiled
    """Area of the raster cells that the points of each patch fill.

    Parameters
    ----------
    placed : ndarray of shape (n, 2), metres in the plane of the patch
        Points of one patch after the other.
    ends : ndarray of shape (k,), int
        Index after the last point of each patch.
    cell : float, metres

    Returns
    -------
    ndarray of shape (k,), square metres
    """
    areas = np.empty(len(ends))
    begin = 0
    for k in range(len(ends)):
        own = placed[begin : ends[k]]
        keys, _ = cell_keys(own, finite_bounds(own)[0], cell)
        keys.sort()
        areas[k] = (1 + np.count_nonzero(np.diff(keys))) * cell * cell if len(keys) else 0.0
        begin = ends[k]
    return areas


def _limit_cell_count(cell: float, low: Array, high: Array) -> float:
    return max(cell, float((high - low).max()) / MAX_CELLS_PER_SIDE)


@njit(nogil=True, cache=True)
def _is_near_filled_cell(
    placed: Array, other: Array, low: Array, high: Array, cell: float
) -> Flags:  # pragma: no cover - compiled
    filled = np.zeros(
        (int((high[0] - low[0]) / cell) + 3, int((high[1] - low[1]) / cell) + 3), np.bool_
    )
    for n in range(other.shape[0]):
        x, y = int((other[n, 0] - low[0]) / cell), int((other[n, 1] - low[1]) / cell)
        filled[x : x + 3, y : y + 3] = True
    found = np.empty(placed.shape[0], np.bool_)
    for n in range(placed.shape[0]):
        x, y = int((placed[n, 0] - low[0]) / cell), int((placed[n, 1] - low[1]) / cell)
        found[n] = filled[x + 1, y + 1]
    return found


@njit(nogil=True, cache=True)
def _label_components(filled: Flags, width: int) -> Indices:  # pragma: no cover - compiled
    # Flood fill over a raster with an empty rim, so that neighbours need no bounds checks.
    label = np.full(filled.size, -1, np.int64)
    stack = np.empty(filled.size, np.int64)
    count = 0
    for start in range(filled.size):
        if not filled[start] or label[start] >= 0:
            continue
        label[start] = count
        stack[0] = start
        top = 1
        while top > 0:
            top -= 1
            here = stack[top]
            for i in (-width, 0, width):
                for j in (-1, 0, 1):
                    there = here + i + j
                    if filled[there] and label[there] < 0:
                        label[there] = count
                        stack[top] = there
                        top += 1
        count += 1
    return label
