"""Time rollover of a line at midnight or end of the week, in any order of points."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Message, note
from lispac.survey.time_base import DAY, HOUR, NEAR_START, WEEK, period_between

Array = NDArray[np.float64]

NONE = "none"
PERIODS: Mapping[str, float] = {"midnight": DAY, "week-end": WEEK, "full-hour": HOUR}
"""Seconds added after a rollover, by the option; 0 for other values."""
KEYS = (NONE, *PERIODS)
PLACES: Mapping[str, Message] = {
    "midnight": note("rollover.midnight"), "week-end": note("rollover.week_end"),
    "full-hour": note("rollover.full_hour"),
}  # fmt: skip
"""Names of the moments of a time rollover."""


def find_rollover(times: Array) -> str:
    """Find the rollover of a line: a key of `PERIODS`, empty where there is none.

    A line is shorter than half a day, and its points may be in any order: so its times start again
    where they lie at both ends of a day or week with more than half of it empty between them, and
    what is missing from the last one before to the first one after is short (`period_between`).

    Parameters
    ----------
    times : ndarray of shape (n,), seconds, in any order
        Of all points, or a sample with the earliest and the latest among them.
    """
    times = np.asarray(times, dtype=np.float64)
    if len(times) < 2 or not np.isfinite(times).all():
        return ""
    low, high = float(times.min()), float(times.max())
    for key, period in PERIODS.items():
        if not 0 <= low < period / 2 <= high < period:
            continue
        after = times < period / 2
        last, first = float(times[after].max()), float(times[~after].min())
        if first - last < period / 2:
            continue
        # A sample need not have the minute about midnight in it.
        leeway = max(NEAR_START, (last + period - first) / 10)
        if period_between(high, low, leeway) == period:
            return key
    return ""


def resolve_rollover(times: Array, rollover: str) -> Array:
    """Times of a line (n,) with the rollover resolved, in any part and order of it.

    Parameters
    ----------
    times : ndarray of shape (n,), seconds, as the file has them
    rollover : str
        As `find_rollover` gives it. What lies in the first half of the day or week is after it.
    """
    period = PERIODS.get(rollover)
    if period is None:
        return times
    return np.where(times < period / 2, times + period, times)


def restore_rollover(times: Array, rollover: str) -> Array:
    """Restore the rollover; the inverse of `resolve_rollover`, exact to the last digit."""
    period = PERIODS.get(rollover)
    if period is None:
        return times
    return np.where(times >= period, times - period, times)


def rollover_note(times: Array, rollover: str, file: str) -> Message:
    """The note on the time rollover of a line and on what is added to its times.

    Parameters
    ----------
    times : ndarray of shape (n,), seconds, with the rollover resolved
    file : str
        Name of the file.
    """
    period, place = PERIODS[rollover], PLACES[rollover]
    before = times[times < period]
    if not len(before):
        return note("import.times_after_restart", file=file, place=place, period=period)
    last = float(before.max())
    return note("import.times_restart", file=file, place=place, period=period, last=last)
