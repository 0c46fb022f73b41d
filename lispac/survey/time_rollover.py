"""Time rollover of a line at a full hour, midnight or end of the week, in any order of points."""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Message, note
from lispac.survey.time_base import DAY, HOUR, ROLLOVER_MARGIN_S, WEEK, period_between

Array = NDArray[np.float64]

NO_ROLLOVER = "none"
"""Value of the option for a line without a rollover."""
ROLLOVER_PERIODS_S: Mapping[str, float] = {"midnight": DAY, "week-end": WEEK, "full-hour": HOUR}
"""Period that is added to times after a rollover, by the value of the option."""
ROLLOVER_KEYS = (NO_ROLLOVER, *ROLLOVER_PERIODS_S)
ROLLOVER_NAMES: Mapping[str, Message] = {
    "midnight": note("rollover.midnight"), "week-end": note("rollover.week_end"),
    "full-hour": note("rollover.full_hour"),
}  # fmt: skip
"""Names of the moments of a time rollover."""


def find_rollover(times: Array) -> str:
    """Find the rollover of a line: a key of `ROLLOVER_PERIODS_S`, or empty if there is none.

    Points may be in any order, and a line is shorter than half a period. There is a rollover if the
    times lie at both ends of a day, week or hour, with at least half of it empty in between, and if
    the times before and after the rollover are near to it (`period_between`).

    Parameters
    ----------
    times : ndarray of shape (n,), seconds, in any order
        Times of all points, or of a sample that includes the earliest and the latest one.
    """
    times = np.asarray(times, dtype=np.float64)
    if len(times) < 2 or not np.isfinite(times).all():
        return ""
    low, high = float(times.min()), float(times.max())
    for key, period in ROLLOVER_PERIODS_S.items():
        if not 0 <= low < period / 2 <= high < period:
            continue
        after = times < period / 2
        last, first = float(times[after].max()), float(times[~after].min())
        if first - last < period / 2:
            continue
        # A sample may have no times within a minute of midnight.
        leeway = max(ROLLOVER_MARGIN_S, (last + period - first) / 10)
        if period_between(high, low, leeway) == period:
            return key
    return ""


def resolve_rollover(times: Array, rollover: str) -> Array:
    """Times of a line, or of any part of it, with the rollover resolved, shape (n,).

    Parameters
    ----------
    times : ndarray of shape (n,), seconds, as the file has them
    rollover : str
        Result of `find_rollover`. Times in the first half of the period are after it.
    """
    period = ROLLOVER_PERIODS_S.get(rollover)
    if period is None:
        return times
    return np.where(times < period / 2, times + period, times)


def restore_rollover(times: Array, rollover: str) -> Array:
    """Restore the rollover; the inverse of `resolve_rollover`, except for rounding."""
    period = ROLLOVER_PERIODS_S.get(rollover)
    if period is None:
        return times
    return np.where(times >= period, times - period, times)


def rollover_note(times: Array, rollover: str, file: str) -> Message:
    """Note on the time rollover of a line and on the period added to its times.

    Parameters
    ----------
    times : ndarray of shape (n,), seconds, with the rollover resolved
    file : str
        Name of the file.
    """
    period, place = ROLLOVER_PERIODS_S[rollover], ROLLOVER_NAMES[rollover]
    before = times[times < period]
    if not len(before):
        return note("import.times_after_restart", file=file, place=place, period=period)
    last = float(before.max())
    return note("import.times_restart", file=file, place=place, period=period, last=last)
