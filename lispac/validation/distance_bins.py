"""Bins of distances: fine ones are kept, and so many of them drawn as one as suits the picture.

Before a calibration the distances are ten and twenty times as large as after it. Bins of one width
that show both at once leave two bars of what came after; kept finely, they show it when enlarged
closely.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

Array = NDArray[np.float64]

SHOWN_PERCENTILE = 99.5
"""Histograms end at this percentile of both states; what lies beyond is counted in the last bin."""
NARROWEST = 1e-6
"""Metres; the range of a histogram at the least."""
MIN_BINS, MAX_BINS = 60, 4000
"""Bins across the state with the smaller distances, at the least, and in all, at the most."""
BEYOND = "and beyond"
"""Upper end of the last bin in lists of bins."""
ROUND = (1.0, 2.0, 5.0, 10.0)


def shared_bin_edges(before: Array, after: Array) -> Array:
    """Edges for both histograms, from 0 on, of a round width.

    Parameters
    ----------
    before, after : arrays of shape (n,), metres, not negative

    Returns
    -------
    ndarray of shape (bins + 1,), metres
    """
    tops = [max(float(np.percentile(d, SHOWN_PERCENTILE)), NARROWEST) for d in (before, after)]
    width = max(_round_down_1_2_5(min(tops) / MIN_BINS), _round_up_1_2_5(max(tops) / MAX_BINS))
    number = max(int(np.ceil(max(tops) / width * (1.0 - 1e-9))), 1)
    return np.asarray(width * np.arange(number + 1))


def histogram_counts(distances: Array, edges: Array) -> NDArray[np.int64]:
    """Histogram (bins,) whose last bin also takes what lies beyond.

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
    """Merge neighbouring bins, so that ``shown`` metres hold no more than ``max_bins``.

    Parameters
    ----------
    edges : array of shape (bins + 1,), metres
        Evenly spaced from 0 on.
    counts : array of shape (bins,)

    Returns
    -------
    edges, counts : ndarrays of shape (k + 1,), metres, and (k,)
        The last bin may reach beyond the former ones.
    """
    fine, numbers = np.asarray(edges, dtype=np.float64), np.asarray(counts, dtype=np.int64)
    width = float(fine[-1]) / len(numbers)
    together = max(int(_round_up_1_2_5(shown / width / max_bins * (1.0 - 1e-9))), 1)
    padded = np.zeros(-(-len(numbers) // together) * together, dtype=np.int64)
    padded[: len(numbers)] = numbers
    grouped = padded.reshape(-1, together).sum(axis=1)
    return np.asarray(together * width * np.arange(len(grouped) + 1)), grouped


def _round_up_1_2_5(value: float) -> float:
    """The next of 1, 2, 5, 10, 20 ... that is not below."""
    unit = 10.0 ** np.floor(np.log10(value))
    return float(next(unit * step for step in ROUND if unit * step >= value * (1.0 - 1e-9)))


def _round_down_1_2_5(value: float) -> float:
    """The next of 1, 2, 5, 10, 20 ... that is not above."""
    unit = 10.0 ** np.floor(np.log10(value))
    return float(next(unit * step for step in ROUND[::-1] if unit * step <= value * (1.0 + 1e-9)))
