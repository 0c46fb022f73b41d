"""Distances between lines as a function of height and of range.

The effect of a boresight error grows with the distance from the scanner, and on a tower with
height; the residual distances after a calibration do not (thesis figures 4.24 to 4.26).
"""

from dataclasses import dataclass
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from lispac.untrusted_values import ArrayShape

Array = NDArray[np.float64]

PROFILE_BINS = 12
"""Default number of bins of a profile."""
MIN_DISTANCES_PER_BIN = 30
"""Smallest number of distances in a bin for statistics."""


@dataclass(frozen=True, eq=False)
class DistanceProfile:
    """Statistics of the distances in bins of equal width of a quantity, such as height or range.

    Attributes
    ----------
    edges : ndarray of shape (k + 1,), metres
    n : ndarray of shape (k,), int64
    median_before, median_after, p95_before, p95_after : ndarrays of shape (k,), metres
        Of the unsigned distances; NaN where a bin contains fewer than 30.
    """

    edges: Annotated[Array, ArrayShape("k+1")]
    n: Annotated[NDArray[np.int64], ArrayShape("k")]
    median_before: Annotated[Array, ArrayShape("k")]
    median_after: Annotated[Array, ArrayShape("k")]
    p95_before: Annotated[Array, ArrayShape("k")]
    p95_after: Annotated[Array, ArrayShape("k")]

    @classmethod
    def of(
        cls, against: Array, before: Array, after: Array, bins: int = PROFILE_BINS
    ) -> "DistanceProfile":
        """Bin distances ``before`` and ``after`` by a quantity ``against``; each (n,), metres."""
        low, high = float(against.min()), float(against.max())
        edges = np.linspace(low, high if high > low else low + 1.0, bins + 1)
        bin_of = np.clip(np.searchsorted(edges, against, side="right") - 1, 0, bins - 1)
        statistics = np.full((4, bins), np.nan)
        counts = np.bincount(bin_of, minlength=bins).astype(np.int64)
        for k in np.flatnonzero(counts >= MIN_DISTANCES_PER_BIN):
            in_bin = bin_of == k
            statistics[:2, k] = np.median(before[in_bin]), np.median(after[in_bin])
            statistics[2:, k] = [np.percentile(d[in_bin], 95.0) for d in (before, after)]
        return cls(edges, counts, *statistics)
