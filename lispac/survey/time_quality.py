"""Quality of times, and coverage of a line by the trajectory."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Message, note, warning
from lispac.untrusted_values import LEAST_AMOUNT

Array = NDArray[np.float64]

COARSEST_HARMLESS = 1e-4
"""Seconds: a vessel at 10 m/s moves by 1 mm in it."""


@dataclass(frozen=True)
class TimeQuality:
    """Quality of times, in the order of the file.

    Attributes
    ----------
    count : int
    duplicates : int
        Times equal to the one before, or nearer to it than the resolution of any clock.
    backward : int
        Times earlier than the one before.
    first_disorder : int or None
        Index of the first such time.
    resolution : float or None, seconds
        Step that 32-bit numbers leave at these values, where the times show that they have gone
        through them.
    """

    count: int
    duplicates: int
    backward: int
    first_disorder: int | None
    resolution: float | None

    def messages(self, file: str) -> tuple[Message, ...]:
        """A warning for each thing that is wrong; ``file`` is the name of the file."""
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
    disorder = np.flatnonzero(~(steps >= LEAST_AMOUNT))
    return TimeQuality(
        len(times),
        int((np.abs(steps) < LEAST_AMOUNT).sum()),
        int((steps <= -LEAST_AMOUNT).sum()),
        int(disorder[0]) + 1 if disorder.size else None,
        _float32_step(times),
    )


def _float32_step(times: Array) -> float | None:
    """Step of 32-bit numbers where times use every one of its values, not a coarser grid.

    Times at whole seconds pass through 32 bits unharmed: all their steps are multiples of a
    second, while 32-bit numbers would resolve finer ones.
    """
    if len(times) < 3 or not np.isfinite(times).all() or np.abs(times).max() > 1e30:
        return None
    if not np.array_equal(times.astype(np.float32).astype(np.float64), times):
        return None
    finest = float(np.spacing(np.float32(np.abs(times).min())))
    coarsest = float(np.spacing(np.float32(np.abs(times).max())))
    steps = np.abs(np.diff(times)) / finest
    if coarsest < COARSEST_HARMLESS or not steps.any() or steps.max() > 2.0**62:
        return None
    common = int(np.gcd.reduce(np.unique(steps.astype(np.int64))))
    return coarsest if common * finest <= coarsest else None


@dataclass(frozen=True)
class TrajectoryCoverage:
    """Coverage of a line by a trajectory.

    Attributes
    ----------
    start, end : float, seconds
        Of the line; not a number where it has no points.
    count : int
        Points of the line.
    outside : int
        Points before or after the trajectory.
    in_gaps : int
        Points in gaps of the trajectory longer than ``longest_gap``.
    gaps : tuple of (float, float), seconds
        Start and end of those gaps that reach into the line's span.
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
        """Part of the points before or after the trajectory."""
        return self.outside / self.count if self.count else 0.0

    @property
    def share_in_gaps(self) -> float:
        """Part of the points in gaps."""
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
        Between two states that may be bridged.
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


SHORT = 2.0
"""Seconds that accuracies may miss at the ends of the trajectory without a message."""


def accuracy_coverage_warning(accuracy_times: Array, track: Array, file: str) -> Message | None:
    """The warning that accuracies do not cover the whole trajectory; None where they do.

    Parameters
    ----------
    accuracy_times, track : ndarray of shape (n,), seconds, increasing
        Times of the accuracies and of the trajectory.
    file : str
        Name of the file of accuracies.
    """
    if max(accuracy_times[0] - track[0], track[-1] - accuracy_times[-1]) <= SHORT:
        return None
    return warning(
        "import.accuracy_too_short", file=file,
        first=float(accuracy_times[0]), last=float(accuracy_times[-1]),
        start=float(track[0]), end=float(track[-1]),
    )  # fmt: skip


def exclusion_notes(covered: TrajectoryCoverage, lost: int, file: str) -> tuple[Message, ...]:
    """Notes on the points of a line that have no pose, and why.

    Parameters
    ----------
    covered : TrajectoryCoverage
        Of all points of the line.
    lost : int
        Points without a pose.
    file : str
        Name of the file of the line.
    """
    found, total = [], covered.count
    if covered.outside:
        found.append(note("import.excluded_outside", file=file, count=covered.outside, total=total))
    if covered.in_gaps:
        found.append(
            note(
                "import.excluded_in_gaps", file=file, count=covered.in_gaps, total=total,
                limit=covered.longest_gap,
            )
        )  # fmt: skip
    if steep := lost - covered.outside - covered.in_gaps:
        found.append(note("import.excluded_steep", file=file, count=steep, total=total))
    return tuple(found)


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
