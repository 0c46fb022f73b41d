"""Audit of one line: statistics of its points, collected chunk by chunk during reading."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

PASS_GAP = 5.0
"""Seconds without points that may separate two passes in one file."""
COARSE_SHARE = 0.5
"""Share of the gaps between distinct times that have to be coarse to speak of a resolution."""
POINTS_PER_TIME = 1.5
"""First returns with one time, on average, from which times are coarser than the points."""


@dataclass(frozen=True)
class LineAudit:
    """Counts and statistics of the points of one line.

    Attributes
    ----------
    read : int
        Points of the file.
    not_finite, no_range, too_far, duplicates : int
        Excluded: values that are not numbers, returns without range, points beyond the largest
        range, exact copies of other points of the line.
    withheld, of_classes, not_selected : int
        Excluded by the withheld flag, by their class, and by the conditions of the user.
    noise : mapping of str to int
        Points of noise classes that are used, by class.
    first_returns, distinct_times : int
        Points that are first returns, and how often the time changes between them.
    time_step : float, seconds
        Usual gap between distinct times where these are coarse; 0 where they are not.
    groups : mapping of str to mapping of str to int
        Points used, by value of the attributes that distinguish scanners and passes.
    spans : list of [float, float], seconds
        Times in which the line has points, in the file's time base, to whole seconds; separated by
        `PASS_GAP` at least.
    mean_range : float, metres
    sketch : list of int
        The smallest hashes of the points used (bottom-k sketch, Broder 1997).
    repeated : float
        Estimated share of the points used that are copies of points far before them in the file.
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
        """First returns with one time, on average; no unit."""
        return self.first_returns / max(self.distinct_times, 1)


def shared_point_fraction(one: LineAudit, other: LineAudit) -> float:
    """Estimated share of the points of the smaller line that both lines have.

    By the bottom-k sketches: below the smaller of both largest hashes each sketch holds every hash
    of its line.
    """
    if not one.sketch or not other.sketch:
        return 0.0
    limit = min(_sketch_limit(one.sketch), _sketch_limit(other.sketch))
    first = {value for value in one.sketch if value <= limit}
    second = {value for value in other.sketch if value <= limit}
    fewest = min(len(first), len(second))
    return len(first & second) / fewest if fewest else 0.0


SKETCH = 2048
"""Hashes of a sketch: a share of points is estimated to 2 %, one from 0.2 % is detected."""


def _sketch_limit(sketch: list[int]) -> int:
    """Largest hash up to which a sketch is complete."""
    return max(sketch) if len(sketch) >= SKETCH else np.iinfo(np.int64).max


def usual_time_step(gaps: NDArray[np.int64], sums: NDArray[np.float64], changes: int) -> float:
    """Usual gap between distinct times, seconds; 0 where most gaps are short.

    Parameters
    ----------
    gaps : ndarray of shape (m,)
        Number of gaps by length.
    sums : ndarray of shape (m,), seconds
        Their total length.
    changes : int
        Number of gaps of any length.
    """
    if gaps.sum() < COARSE_SHARE * max(changes - 1, 1):
        return 0.0
    k = int(gaps.argmax())
    near = slice(max(0, k - 1), k + 2)  # rounding spreads one step over neighbouring bins
    return float(sums[near].sum() / gaps[near].sum())


GRID_STEPS = (1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005, 0.002, 0.001)
"""Seconds: steps that times are rounded to, the coarsest first."""
GRID_TOLERANCE = 1e-6
"""Seconds by which rounded times may miss a step: what 64 bits leave of a time since 1980."""


def time_grid_step(times: NDArray[np.float64]) -> float:
    """Coarsest step that all ``times`` (n,), seconds, are multiples of; 0 where there is none."""
    for step in GRID_STEPS:
        if np.abs(times - np.round(times / step) * step).max(initial=0.0) <= GRID_TOLERANCE:
            return step
    return 0.0


def time_spans(seconds: NDArray[np.int64]) -> list[list[float]]:
    """Spans of ``seconds`` (n,), ascending whole seconds with points, apart by `PASS_GAP`."""
    if not len(seconds):
        return []
    breaks = np.flatnonzero(np.diff(seconds) > PASS_GAP)
    starts = seconds[np.r_[0, breaks + 1]]
    ends = seconds[np.r_[breaks, len(seconds) - 1]] + 1
    return [[float(start), float(end)] for start, end in zip(starts, ends, strict=True)]
