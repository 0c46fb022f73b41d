"""How the distances between lines change with height and with range.

A boresight error grows with the distance from the scanner, and on a tower with height; what is
left after a calibration does not (thesis figures 4.24 to 4.26).
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

BINS = 12
FEWEST = 30
"""Distances in a bin below which its figures say nothing; it has none then."""


@dataclass(frozen=True, eq=False)
class Profile:
    """Distances in equal steps of a quantity.

    Attributes
    ----------
    edges : ndarray of shape (k + 1,), metres
    n : ndarray of shape (k,), int64
    median_before, median_after, p95_before, p95_after : ndarrays of shape (k,), metres
        Of the unsigned distances; NaN where a bin holds fewer than 30.
    """

    edges: Array
    n: NDArray[np.int64]
    median_before: Array
    median_after: Array
    p95_before: Array
    p95_after: Array

    @classmethod
    def of(cls, against: Array, before: Array, after: Array, bins: int = BINS) -> "Profile":
        """Bin distances ``before`` and ``after`` by a quantity ``against``; each (n,), metres."""
        low, high = float(against.min()), float(against.max())
        edges = np.linspace(low, high if high > low else low + 1.0, bins + 1)
        at = np.clip(np.searchsorted(edges, against, side="right") - 1, 0, bins - 1)
        figures = np.full((4, bins), np.nan)
        counts = np.bincount(at, minlength=bins).astype(np.int64)
        for k in np.flatnonzero(counts >= FEWEST):
            here = at == k
            figures[:2, k] = np.median(before[here]), np.median(after[here])
            figures[2:, k] = [np.percentile(d[here], 95.0) for d in (before, after)]
        return cls(edges, counts, *figures)

    def to_dict(self) -> dict[str, Any]:
        """Plain numbers, for JSON; None where there is none."""
        return {
            name: [None if isinstance(v, float) and np.isnan(v) else v for v in value.tolist()]
            for name, value in vars(self).items()
        }

    @classmethod
    def from_dict(cls, data: dict[str, Any]) -> "Profile":
        """The inverse of `to_dict`."""
        figures = ("median_before", "median_after", "p95_before", "p95_after")
        return cls(
            np.array(data["edges"], dtype=np.float64),
            np.array(data["n"], dtype=np.int64),
            *(np.array(data[name], dtype=np.float64) for name in figures),
        )
