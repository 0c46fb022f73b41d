"""Runs of rows: the points of a region in a line that is ordered by space."""

from collections.abc import Iterator
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit

Runs = NDArray[np.int64]
"""Runs of rows, shape (k, 2): first row and the row after the last, increasing, not adjacent."""


def row_runs(starts: NDArray[np.uint64], octave_runs: Runs) -> Runs:
    """Runs of rows that belong to runs of octaves; adjacent runs are joined.

    Parameters
    ----------
    starts : ndarray of shape (n + 1,)
        First row of each octave, and the number of rows.
    octave_runs : ndarray of shape (k, 2)
        First octave and the octave after the last.

    Returns
    -------
    ndarray of shape (m, 2)
    """
    runs = starts[octave_runs].astype(np.int64)
    if not len(runs):
        return np.zeros((0, 2), np.int64)
    separate = runs[1:, 0] > runs[:-1, 1]
    return np.column_stack([runs[np.append(True, separate), 0], runs[np.append(separate, True), 1]])


def rows_of_runs(runs: Runs) -> NDArray[np.int64]:
    """All rows of all runs.

    Parameters
    ----------
    runs : ndarray of shape (k, 2)

    Returns
    -------
    ndarray of shape (n,), int
    """
    return np.concatenate([np.arange(*run) for run in runs.tolist()] or [np.zeros(0, np.int64)])


def gather_values(values: NDArray[Any], runs: Runs) -> NDArray[Any]:
    """The values of all runs one after the other.

    Parameters
    ----------
    values : ndarray of shape (rows, ...)
    runs : ndarray of shape (k, 2)

    Returns
    -------
    ndarray of shape (n, ...)
    """
    if not len(runs):
        return np.array(values[:0])
    return np.concatenate([values[start:stop] for start, stop in runs.tolist()])


def split_runs(runs: Runs, rows: int) -> Iterator[Runs]:
    """Yield the runs in groups with at most ``rows`` rows each; long runs are divided.

    Parameters
    ----------
    runs : ndarray of shape (k, 2)
    rows : int
    """
    ends = np.cumsum(runs[:, 1] - runs[:, 0])
    starts = ends - (runs[:, 1] - runs[:, 0])
    for low in range(0, int(ends[-1]) if len(runs) else 0, rows):
        first = np.searchsorted(ends, low, side="right")
        last = np.searchsorted(starts, low + rows, side="left")
        group = runs[first:last].copy()
        group[-1, 1] -= max(0, ends[last - 1] - low - rows)
        group[0, 0] += max(0, low - starts[first])
        yield group


@njit(nogil=True, cache=True)
def select_within_sphere(points_local, runs, centre, radius):  # type: ignore[no-untyped-def]
    """Rows and coordinates of the points within a sphere; the points are those of ``runs``."""
    rows, kept = np.empty(len(points_local), np.int64), np.empty_like(points_local)
    count = i = 0
    for k in range(len(runs)):
        for row in range(runs[k, 0], runs[k, 1]):
            x, y, z = points_local[i, 0], points_local[i, 1], points_local[i, 2]
            squared = (x - centre[0]) ** 2 + (y - centre[1]) ** 2 + (z - centre[2]) ** 2
            if squared <= radius * radius:
                rows[count] = row
                kept[count, 0], kept[count, 1], kept[count, 2] = x, y, z
                count += 1
            i += 1
    return rows[:count].copy(), kept[:count].copy()
