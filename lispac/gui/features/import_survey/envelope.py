"""Envelope of a long time series, with as many points as a screen can show."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

DEFAULT_BINS = 1500
"""Intervals of the envelope; more than an axis has pixels."""


def envelope(
    time: Array, values: Array, *, bins: int = DEFAULT_BINS, longest_gap: float = np.inf
) -> tuple[Array, Array]:
    """Smallest and largest value of each time interval, with NaN at gaps.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds, increasing
    values : ndarray of shape (n,)
    longest_gap : float, seconds
        Longer gaps break the line.

    Returns
    -------
    time, values : ndarray of shape (m,)
    """
    breaks = np.flatnonzero(np.diff(time) > longest_gap) + 1
    if len(time) > 4 * bins:
        edges = np.linspace(time[0], time[-1], bins + 1)
        starts = np.unique(np.concatenate([np.searchsorted(time, edges[:-1]), breaks]))
        starts = starts[starts < len(time)]
        low = np.minimum.reduceat(values, starts)
        high = np.maximum.reduceat(values, starts)
        ends = np.append(starts[1:], len(time)) - 1
        time_out = np.stack([time[starts], time[ends]], axis=1).ravel()
        values_out = np.stack([low, high], axis=1).ravel()
        places = 2 * np.searchsorted(starts, breaks)
    else:
        time_out, values_out, places = time, values, breaks
    if len(places):
        time_out = np.insert(time_out, places, time_out[places])
        values_out = np.insert(values_out, places, np.nan)
    return time_out, values_out
