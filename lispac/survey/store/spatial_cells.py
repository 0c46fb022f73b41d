"""Spatial order of the points of a line: cubic cells along Morton's curve (1966).

Neighbouring cells are mostly close together in the file, so that a region consists of a few runs of
points. The points of a cell are divided into octaves by a hash of their number: the last octave
contains half of the points, the one before it a quarter, and so on. The beginning of a cell is
therefore a uniform random sample of it. Within an octave, the points are in the order of the file,
usually that of time, so that the trajectory is read in sequence.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit

Array = NDArray[np.float64]
Keys = NDArray[np.uint64]

BITS_PER_AXIS = 16
"""Bits of the number of a cell along each axis."""
HALF_GRID_CELLS = 1 << (BITS_PER_AXIS - 1)
"""Number of cells along each axis on either side of the origin."""
OCTAVE_BITS = 4
"""Bits of the number of an octave in its cell."""
MAX_HALVINGS = (1 << OCTAVE_BITS) - 1
"""Largest number of halvings of a sample."""
CELL_SIDES_M = (0.5, 1.0, 2.0, 4.0, 8.0, 16.0)
"""Possible edge lengths of a cell. With the smallest one, the cells extend 16 km from the origin;
points farther away belong to the outermost cells."""
MIN_MEAN_POINTS_PER_CELL = 64
"""Smallest mean number of points in the occupied cells, unless the largest cells have fewer."""


def choose_cell_side(points_local: Array) -> float:
    """Edge length of the cells, metres, for a line with these first points, shape (n, 3)."""
    for side in CELL_SIDES_M:
        cells = np.unique(order_keys(points_local, np.zeros(len(points_local), np.int64), side))
        if len(cells) * MIN_MEAN_POINTS_PER_CELL <= len(points_local):
            return side
    return CELL_SIDES_M[-1]


def order_keys(points_local: Array, numbers: NDArray[Any], side: float) -> Keys:
    """Sort keys of points: cell, then octave.

    Parameters
    ----------
    points_local : ndarray of shape (n, 3), metres, local frame
    numbers : ndarray of shape (n,)
        Numbers of the points in the line.
    side : float, metres
        Edge length of the cells.

    Returns
    -------
    ndarray of shape (n,)
        Points are ordered by key and, for equal keys, by number.
    """
    keys = np.empty(len(points_local), np.uint64)
    _fill_order_keys(points_local, numbers.astype(np.uint64), side, keys)
    return keys


def is_octave_in_sample(octaves: Keys, halvings: int) -> NDArray[np.bool_]:
    """Mask of the octaves that belong to a sample of a half, a quarter, ... of the points.

    Parameters
    ----------
    octaves : ndarray of shape (n,)
        Keys, or numbers of the octaves in their cells.
    halvings : int
        One for a half, two for a quarter.

    Returns
    -------
    ndarray of shape (n,), bool
    """
    last = (1 << OCTAVE_BITS) - 1
    return np.asarray((octaves & np.uint64(last)) <= np.uint64(max(0, last - halvings)))


def is_number_in_sample(numbers: NDArray[Any], halvings: int) -> NDArray[np.bool_]:
    """Mask of the points that belong to a sample of a half, a quarter, ... of a line.

    The sample is that of `is_octave_in_sample`, so that a line in memory and a line on disk have
    the same one.

    Parameters
    ----------
    numbers : ndarray of shape (n,), int
        Numbers of the points in the line.
    halvings : int
        One for a half, two for a quarter.

    Returns
    -------
    ndarray of shape (n,), bool
    """
    octaves = np.empty(len(numbers), np.uint64)
    _fill_octaves(numbers.astype(np.uint64), octaves)
    return is_octave_in_sample(octaves, halvings)


def is_in_coarse_sample(numbers: NDArray[Any], points: int, count: int) -> NDArray[np.bool_]:
    """Mask of the points in a uniform random sample of at most ``count`` out of ``points``.

    Points are selected by the hash that also determines the octaves, so that those of a cell are at
    its beginning. The expected size is five standard deviations below ``count``.

    Parameters
    ----------
    numbers : ndarray of shape (n,), int
        Numbers of the points in the line.

    Returns
    -------
    ndarray of shape (n,), bool
    """
    if points <= count:
        return np.ones(len(numbers), bool)
    share = max(0.0, count - 5 * count**0.5) / points
    return _splitmix_hashes(numbers.astype(np.uint64)) < np.uint64(share * 2.0**64)


@njit(nogil=True, cache=True)
def corners_and_reach(points_lidar, points_local):  # type: ignore[no-untyped-def]
    """Smallest and largest local coordinates, and largest range from the scanner, metres."""
    low, high, farthest = np.full(3, np.inf), np.full(3, -np.inf), 0.0
    for i in range(len(points_lidar)):
        squared = 0.0
        for axis in range(3):
            value = points_local[i, axis]
            low[axis], high[axis] = min(low[axis], value), max(high[axis], value)
            squared += points_lidar[i, axis] ** 2
        farthest = max(farthest, squared)
    return low, high, np.sqrt(farthest)


@njit(nogil=True, cache=True, inline="always")
def _splitmix_hash(number):  # type: ignore[no-untyped-def]
    """Hash of a number: the finaliser of splitmix64 (Stafford's mix 13)."""
    z = number + np.uint64(0x9E3779B97F4A7C15)
    z = (z ^ (z >> np.uint64(30))) * np.uint64(0xBF58476D1CE4E5B9)
    z = (z ^ (z >> np.uint64(27))) * np.uint64(0x94D049BB133111EB)
    return z ^ (z >> np.uint64(31))


@njit(nogil=True, cache=True)
def _splitmix_hashes(numbers):  # type: ignore[no-untyped-def]
    hashes = np.empty(len(numbers), np.uint64)
    for i in range(len(numbers)):
        hashes[i] = _splitmix_hash(numbers[i])
    return hashes


@njit(nogil=True, cache=True, inline="always")
def _octave_of_number(number):  # type: ignore[no-untyped-def]
    """Number of the octave of a point in its cell; half of the points are in the last octave."""
    octave, hashed = np.uint64((1 << OCTAVE_BITS) - 1), _splitmix_hash(number)
    while octave > 0 and not hashed >> np.uint64(63):
        hashed <<= np.uint64(1)
        octave -= np.uint64(1)
    return octave


@njit(nogil=True, cache=True)
def _fill_octaves(numbers, octaves):  # type: ignore[no-untyped-def]
    for i in range(len(numbers)):
        octaves[i] = _octave_of_number(numbers[i])


@njit(nogil=True, cache=True, inline="always")
def _spread_bits(value):  # type: ignore[no-untyped-def]
    """Sixteen bits, each followed by two empty ones."""
    v = np.uint64(value)
    v = (v | (v << np.uint64(16))) & np.uint64(0x0000FF0000FF)
    v = (v | (v << np.uint64(8))) & np.uint64(0x00F00F00F00F)
    v = (v | (v << np.uint64(4))) & np.uint64(0x0C30C30C30C3)
    return (v | (v << np.uint64(2))) & np.uint64(0x249249249249)


@njit(nogil=True, cache=True)
def _fill_order_keys(points_local, numbers, side, keys):  # type: ignore[no-untyped-def]
    last = float(2 * HALF_GRID_CELLS - 1)
    for i in range(len(keys)):
        key = np.uint64(0)
        for axis in range(3):
            cell = min(max(np.floor(points_local[i, axis] / side) + HALF_GRID_CELLS, 0.0), last)
            key |= _spread_bits(int(cell)) << np.uint64(axis)
        keys[i] = key << np.uint64(OCTAVE_BITS) | _octave_of_number(numbers[i])


def stable_order(keys: Keys) -> NDArray[np.intp]:
    """Order (n,) that sorts ``keys`` (n,); points with equal keys keep their order."""
    return np.argsort(keys, kind="stable")


@njit(nogil=True, cache=True)
def octave_runs_in_sphere(octaves, side, centre, radius):  # type: ignore[no-untyped-def]
    """Cells that a sphere intersects, as runs of indices into the sorted ``octaves``, (k, 2)."""
    runs = np.empty((64, 2), np.int64)
    count = 0
    # The outermost cells also contain the points outside the grid. Moving these points and the
    # centre to the nearest position in the grid does not increase their distance.
    edge = HALF_GRID_CELLS * side
    x = min(max(centre[0], -edge), edge)
    y = min(max(centre[1], -edge), edge)
    z = min(max(centre[2], -edge), edge)
    stack = np.empty((8 * (BITS_PER_AXIS + 1), 2), np.int64)  # first cell of a cube, and its level
    depth = 1
    stack[0, 0], stack[0, 1] = 0, BITS_PER_AXIS
    while depth:
        depth -= 1
        corner, level = stack[depth]
        first = np.searchsorted(octaves, np.uint64(corner) << np.uint64(OCTAVE_BITS))
        behind = np.uint64(corner + (1 << (3 * level))) << np.uint64(OCTAVE_BITS)
        last = np.searchsorted(octaves, behind)
        if first == last:
            continue
        width = side * (1 << level)
        gap, span = 0.0, 0.0
        for axis in range(3):
            number = 0
            for bit in range(BITS_PER_AXIS):
                number |= ((corner >> (3 * bit + axis)) & 1) << bit
            low = (number - HALF_GRID_CELLS) * side
            at = x if axis == 0 else (y if axis == 1 else z)
            gap += max(low - at, at - low - width, 0.0) ** 2
            span += max(at - low, low + width - at) ** 2
        if gap > radius * radius:
            continue
        if level == 0 or span <= radius * radius:
            if count and runs[count - 1, 1] == first:
                runs[count - 1, 1] = last
                continue
            if count == len(runs):
                larger = np.empty((2 * count, 2), np.int64)
                larger[:count] = runs
                runs = larger
            runs[count, 0], runs[count, 1] = first, last
            count += 1
            continue
        for child in range(7, -1, -1):  # the first child is on top of the stack
            stack[depth, 0] = corner + (child << (3 * (level - 1)))
            stack[depth, 1] = level - 1
            depth += 1
    return runs[:count].copy()
