"""Quality of the times of a file, and coverage of a line by the trajectory."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Message, note, warning
from lispac.untrusted_values import MIN_AMOUNT

Array = NDArray[np.float64]

MAX_HARMLESS_TIME_STEP_S = 1e-4
"""Coarsest harmless resolution of times: a vessel at 10 m/s moves by 1 mm."""


@dataclass(frozen=True)
class TimeQuality:
    """Quality of times, in the order of the file.

    Attributes
    ----------
    count : int
    duplicates : int
        Number of times equal to the previous one, or closer to it than any clock resolves.
    backward : int
        Number of times earlier than the previous one.
    first_disorder : int or None
        Index of the first such time.
    resolution : float or None, seconds
        Resolution of 32-bit numbers at these values, if the times were rounded to 32 bits.
    """

    count: int
    duplicates: int
    backward: int
    first_disorder: int | None
    resolution: float | None

    def messages(self, file: str) -> tuple[Message, ...]:
        """Warning for each problem; ``file`` is the name of the file."""
        found = []
        if self.resolution is not None:
            found.append(warning("times.coarse", file=file, step=self.resolution))
        if self.backward:
            found.append(
                warning("times.decreasing", file=file, count=self.backward, total=self.count)
            )
        if self.duplicates:
            found.append(
                warning("times.repeated", file=file, count=self.duplicates, total=self.count)
            )
        return tuple(found)


def assess_times(times: Array) -> TimeQuality:
    """Examine ``times``, shape (n,), seconds, in the order of the file."""
    times = np.asarray(times, dtype=np.float64)
    with np.errstate(over="ignore", invalid="ignore"):
        steps = np.diff(times)
    disorder = np.flatnonzero(~(steps >= MIN_AMOUNT))
    return TimeQuality(
        len(times),
        int((np.abs(steps) < MIN_AMOUNT).sum()),
        int((steps <= -MIN_AMOUNT).sum()),
        int(disorder[0]) + 1 if disorder.size else None,
        _float32_step(times),
    )


def _float32_step(times: Array) -> float | None:
    """Resolution of 32-bit numbers if the times use all their values, not only a coarser grid.

    Times in whole seconds are not affected by rounding to 32 bits: all their steps are multiples of
    one second, although 32-bit numbers would have a finer resolution.
    """
    if len(times) < 3 or not np.isfinite(times).all() or np.abs(times).max() > 1e30:
        return None
    if not np.array_equal(times.astype(np.float32).astype(np.float64), times):
        return None
    finest = float(np.spacing(np.float32(np.abs(times).min())))
    coarsest = float(np.spacing(np.float32(np.abs(times).max())))
    steps = np.abs(np.diff(times)) / finest
    if coarsest < MAX_HARMLESS_TIME_STEP_S or not steps.any() or steps.max() > 2.0**62:
        return None
    common = int(np.gcd.reduce(np.unique(steps.astype(np.int64))))
    return coarsest if common * finest <= coarsest else None


@dataclass(frozen=True)
class TrajectoryCoverage:
    """Coverage of a line by a trajectory.

    Attributes
    ----------
    start, end : float, seconds
        First and last time of the line; NaN if it has no points.
    count : int
        Points of the line.
    outside : int
        Points before or after the trajectory.
    in_gaps : int
        Points in gaps of the trajectory longer than ``longest_gap``.
    gaps : tuple of (float, float), seconds
        Start and end of the gaps that overlap the time span of the line.
    longest_gap : float, seconds
    """

    start: float
    end: float
    count: int
    outside: int
    in_gaps: int
    gaps: tuple[tuple[float, float], ...]
    longest_gap: float

    @property
    def share_outside(self) -> float:
        """Share of the points before or after the trajectory."""
        return self.outside / self.count if self.count else 0.0

    @property
    def share_in_gaps(self) -> float:
        """Share of the points in gaps."""
        return self.in_gaps / self.count if self.count else 0.0

    @property
    def usable(self) -> int:
        """Points that can be georeferenced."""
        return self.count - self.outside - self.in_gaps


def assess_coverage(
    line_times: Array, trajectory_times: Array, longest_gap: float
) -> TrajectoryCoverage:
    """Assess the coverage of a line, or of a part of it (join parts with `join_coverages`).

    Parameters
    ----------
    line_times : ndarray of shape (n,), seconds, in any order; in the trajectory's time base
    trajectory_times : ndarray of shape (m,), seconds, increasing
    longest_gap : float, seconds
        Longest interval between two states over which positions are interpolated.
    """
    times = np.asarray(line_times, dtype=np.float64)
    track = np.asarray(trajectory_times, dtype=np.float64)
    if not times.size:
        return TrajectoryCoverage(np.nan, np.nan, 0, 0, 0, (), longest_gap)
    start, end = float(times.min()), float(times.max())
    if not track.size:
        return TrajectoryCoverage(start, end, len(times), len(times), 0, (), longest_gap)
    wide = np.flatnonzero(np.diff(track) > longest_gap)
    inside = (times >= track[0]) & (times <= track[-1])
    in_gaps = 0
    if wide.size:
        opens, closes = track[wide], track[wide + 1]
        nearest = np.searchsorted(opens, times, side="left") - 1
        in_gaps = int((inside & (nearest >= 0) & (times < closes[nearest])).sum())
    gaps = tuple(
        (float(track[k]), float(track[k + 1]))
        for k in wide
        if track[k] < end and track[k + 1] > start
    )
    return TrajectoryCoverage(
        start, end, len(times), int((~inside).sum()), in_gaps, gaps, longest_gap
    )


MAX_UNCOVERED_TIME_S = 2.0
"""Longest time without accuracies at an end of the trajectory that gives no warning."""


def accuracy_coverage_warning(accuracy_times: Array, track: Array, file: str) -> Message | None:
    """Warning that accuracies do not cover the trajectory, up to short ends; None if they do.

    Parameters
    ----------
    accuracy_times, track : ndarray of shape (n,), seconds, increasing
        Times of the accuracies and of the trajectory.
    file : str
        Name of the file of accuracies.
    """
    if max(accuracy_times[0] - track[0], track[-1] - accuracy_times[-1]) <= MAX_UNCOVERED_TIME_S:
        return None
    return warning(
        "import.accuracy_too_short", file=file,
        first=float(accuracy_times[0]), last=float(accuracy_times[-1]),
        start=float(track[0]), end=float(track[-1]),
    )  # fmt: skip


def exclusion_notes(covered: TrajectoryCoverage, lost: int, file: str) -> tuple[Message, ...]:
    """Notes on the points of a line without a pose, with the reasons.

    Parameters
    ----------
    covered : TrajectoryCoverage
        Coverage of all points of the line.
    lost : int
        Number of points without a pose.
    file : str
        Name of the file of the line.
    """
    notes, total = [], covered.count
    if covered.outside:
        notes.append(note("import.excluded_outside", file=file, count=covered.outside, total=total))
    if covered.in_gaps:
        notes.append(
            note(
                "import.excluded_in_gaps", file=file, count=covered.in_gaps, total=total,
                limit=covered.longest_gap,
            )
        )  # fmt: skip
    if steep := lost - covered.outside - covered.in_gaps:
        notes.append(note("import.excluded_steep", file=file, count=steep, total=total))
    return tuple(notes)


def join_coverages(parts: list[TrajectoryCoverage]) -> TrajectoryCoverage:
    """Coverage of a line read in parts."""
    parts = [part for part in parts if part.count] or parts[:1]
    if not parts:
        return TrajectoryCoverage(np.nan, np.nan, 0, 0, 0, (), np.nan)
    return TrajectoryCoverage(
        min(part.start for part in parts),
        max(part.end for part in parts),
        sum(part.count for part in parts),
        sum(part.outside for part in parts),
        sum(part.in_gaps for part in parts),
        tuple(sorted({gap for part in parts for gap in part.gaps})),
        parts[0].longest_gap,
    )
