"""Audit of one line: statistics of its points, collected chunk by chunk during reading."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

MIN_LINE_PAUSE_S = 5.0
"""Pause above which points may belong to two lines in one file."""
MIN_LONG_GAP_SHARE = 0.5
"""Smallest share of long gaps among the gaps between distinct times, for coarse times."""
MIN_POINTS_PER_COARSE_TIME = 1.5
"""Smallest mean number of first returns with the same time, for coarse times."""


@dataclass(frozen=True)
class LineAudit:
    """Counts and statistics of the points of one line.

    Attributes
    ----------
    read : int
        Number of points in the file.
    not_finite, no_range, too_far, duplicates : int
        Number of excluded points: values that are not finite, returns without range, points beyond
        the largest range, exact copies of other points of the line.
    withheld, of_classes, not_selected : int
        Number of points excluded by the withheld flag, by their class, and by user conditions.
    noise : mapping of str to int
        Number of used points in noise classes, by class.
    first_returns, distinct_times : int
        Number of first returns, and of changes of the time between them.
    time_step : float, seconds
        Typical gap between distinct times if these are coarse; otherwise 0.
    groups : mapping of str to mapping of str to int
        Number of used points by value, for the attributes that distinguish scanners and lines.
    spans : list of [float, float], seconds
        Time spans with points, in the file's time base, rounded to whole seconds; separated by at
        least `MIN_LINE_PAUSE_S`.
    mean_range : float, metres
    sketch : list of int
        The smallest hashes of the points used (bottom-k sketch, Broder 1997).
    repeated : float
        Estimated share of used points that are copies of much earlier points in the file.
    """

    read: int
    not_finite: int = 0
    no_range: int = 0
    too_far: int = 0
    duplicates: int = 0
    withheld: int = 0
    of_classes: int = 0
    not_selected: int = 0
    noise: Mapping[str, int] = field(default_factory=dict)
    first_returns: int = 0
    distinct_times: int = 0
    time_step: float = 0.0
    groups: Mapping[str, Mapping[str, int]] = field(default_factory=dict)
    spans: list[list[float]] = field(default_factory=list)
    mean_range: float = 0.0
    sketch: list[int] = field(default_factory=list)
    repeated: float = 0.0

    @property
    def points_per_time(self) -> float:
        """Mean number of first returns with the same time, no unit."""
        return self.first_returns / max(self.distinct_times, 1)


def shared_point_fraction(one: LineAudit, other: LineAudit) -> float:
    """Estimated share of the smaller line's points that both lines have.

    The estimate uses the bottom-k sketches. Up to the smaller of their two largest hashes, each
    sketch contains all hashes of its line.
    """
    if not one.sketch or not other.sketch:
        return 0.0
    limit = min(_sketch_limit(one.sketch), _sketch_limit(other.sketch))
    first = {value for value in one.sketch if value <= limit}
    second = {value for value in other.sketch if value <= limit}
    fewest = min(len(first), len(second))
    return len(first & second) / fewest if fewest else 0.0


SKETCH_HASHES = 2048
"""Number of hashes in a sketch: shares are accurate to 2 %, and detected from 0.2 % on."""


def _sketch_limit(sketch: list[int]) -> int:
    """Largest hash up to which a sketch is complete."""
    return max(sketch) if len(sketch) >= SKETCH_HASHES else np.iinfo(np.int64).max


def usual_time_step(gaps: NDArray[np.int64], sums: NDArray[np.float64], changes: int) -> float:
    """Typical gap between distinct times, seconds; 0 if most gaps are short.

    Parameters
    ----------
    gaps : ndarray of shape (m,)
        Number of long gaps by length.
    sums : ndarray of shape (m,), seconds
        Their total length.
    changes : int
        Number of changes of the time, the first time included.
    """
    if gaps.sum() < MIN_LONG_GAP_SHARE * max(changes - 1, 1):
        return 0.0
    k = int(gaps.argmax())
    near = slice(max(0, k - 1), k + 2)  # rounding spreads one step over neighbouring bins
    return float(sums[near].sum() / gaps[near].sum())


TIME_GRID_STEPS_S = (1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001)
"""Steps to which times may be rounded, the coarsest first."""
TIME_GRID_TOLERANCE_S = 1e-6
"""Tolerance for multiples of a step: rounding of a time since 1980 in 64 bits."""


def time_grid_step(times: NDArray[np.float64]) -> float:
    """Coarsest step of which all ``times`` (n,), seconds, are multiples; 0 if there is none."""
    for step in TIME_GRID_STEPS_S:
        if np.abs(times - np.round(times / step) * step).max(initial=0.0) <= TIME_GRID_TOLERANCE_S:
            return step
    return 0.0


def time_spans(seconds: NDArray[np.int64]) -> list[list[float]]:
    """Time spans of points, separated by pauses above `MIN_LINE_PAUSE_S`.

    Parameters
    ----------
    seconds : ndarray of shape (n,), int, ascending
        Whole seconds that contain points.
    """
    if not len(seconds):
        return []
    breaks = np.flatnonzero(np.diff(seconds) > MIN_LINE_PAUSE_S)
    starts = seconds[np.r_[0, breaks + 1]]
    ends = seconds[np.r_[breaks, len(seconds) - 1]] + 1
    return [[float(start), float(end)] for start, end in zip(starts, ends, strict=True)]
