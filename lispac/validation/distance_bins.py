"""Fine bins of distances, which are merged for display as the scale of the picture requires.

Distances before a calibration are ten to twenty times as large as after it. With bins wide enough
for both, the distances after the calibration would fill only two bins. Fine bins are therefore
stored, and show these distances when the histogram is enlarged.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

HISTOGRAM_END_PERCENTILE = 99.5
"""Percentile of the state with larger distances where histograms end; the last bin includes larger
distances."""
MIN_HISTOGRAM_RANGE_M = 1e-6
"""Smallest range of a histogram."""
MIN_BINS, MAX_BINS = 60, 4000
"""Smallest number of bins across the state with smaller distances, and largest total number."""
ROUND_STEPS = (1.0, 2.0, 5.0, 10.0)
"""Round numbers of one decade, for the widths of bins."""


def shared_bin_edges(before: Array, after: Array) -> Array:
    """Common edges of both histograms, starting at 0, with a round bin width.

    Parameters
    ----------
    before, after : arrays of shape (n,), metres, not negative

    Returns
    -------
    ndarray of shape (bins + 1,), metres
    """
    tops = [
        max(float(np.percentile(d, HISTOGRAM_END_PERCENTILE)), MIN_HISTOGRAM_RANGE_M)
        for d in (before, after)
    ]
    width = max(_round_down_1_2_5(min(tops) / MIN_BINS), _round_up_1_2_5(max(tops) / MAX_BINS))
    number = max(int(np.ceil(max(tops) / width * (1.0 - 1e-9))), 1)
    return np.asarray(width * np.arange(number + 1))


def histogram_counts(distances: Array, edges: Array) -> NDArray[np.int64]:
    """Histogram, shape (bins,), whose last bin includes larger distances.

    Parameters
    ----------
    distances : ndarray of shape (n,), metres
    edges : ndarray of shape (bins + 1,), metres
    """
    counts, _ = np.histogram(np.minimum(distances, edges[-1]), bins=edges)
    return counts.astype(np.int64)


def merge_bins(
    edges: ArrayLike, counts: ArrayLike, shown: float, max_bins: int
) -> tuple[Array, NDArray[np.int64]]:
    """Merge neighbouring bins so that a range of ``shown`` metres has at most ``max_bins`` bins.

    Parameters
    ----------
    edges : array of shape (bins + 1,), metres
        Evenly spaced from 0 on.
    counts : array of shape (bins,)
    shown : float, metres
        Range that is displayed.

    Returns
    -------
    edges, counts : ndarrays of shape (k + 1,), metres, and (k,)
        The last bin may extend beyond the last edge of the given bins.
    """
    fine_edges, numbers = np.asarray(edges, dtype=np.float64), np.asarray(counts, dtype=np.int64)
    width = float(fine_edges[-1]) / len(numbers)
    bins_per_group = max(int(_round_up_1_2_5(shown / width / max_bins * (1.0 - 1e-9))), 1)
    padded = np.zeros(-(-len(numbers) // bins_per_group) * bins_per_group, dtype=np.int64)
    padded[: len(numbers)] = numbers
    grouped = padded.reshape(-1, bins_per_group).sum(axis=1)
    return np.asarray(bins_per_group * width * np.arange(len(grouped) + 1)), grouped


def _round_up_1_2_5(value: float) -> float:
    """Smallest of the numbers 1, 2, 5, 10, 20 ... that is not below the value."""
    unit = 10.0 ** np.floor(np.log10(value))
    return float(next(unit * step for step in ROUND_STEPS if unit * step >= value * (1.0 - 1e-9)))


def _round_down_1_2_5(value: float) -> float:
    """Largest of the numbers 1, 2, 5, 10, 20 ... that is not above the value."""
    unit = 10.0 ** np.floor(np.log10(value))
    return float(
        next(unit * step for step in ROUND_STEPS[::-1] if unit * step <= value * (1.0 + 1e-9))
    )
