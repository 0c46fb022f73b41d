"""Time bases: identification, and conversion between them.

During a survey without a leap second, two time bases differ by a constant: the difference of their
origins, the leap seconds, and whole hours, days or weeks if a base has a rollover. A conversion is
therefore a single shift in seconds. The number of whole periods is chosen so that the times of two
files overlap.
"""

from collections.abc import Iterable
from dataclasses import dataclass
from datetime import UTC, date, datetime

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import error

Array = NDArray[np.float64]

HOUR, DAY, WEEK = 3600.0, 86_400.0, 604_800.0
TAI_MINUS_GPS_S = 19.0
"""Constant difference of TAI minus GPS time."""
GPS_EPOCH = datetime(1980, 1, 6, tzinfo=UTC).timestamp()
"""Unix time of the origin of GPS time, seconds."""
ROLLOVER_MARGIN_S = 60.0
"""Largest time before and after the end of a period for a rollover."""

LEAP_SECOND_DATES = (
    date(1981, 7, 1), date(1982, 7, 1), date(1983, 7, 1), date(1985, 7, 1), date(1988, 1, 1),
    date(1990, 1, 1), date(1991, 1, 1), date(1992, 7, 1), date(1993, 7, 1), date(1994, 7, 1),
    date(1996, 1, 1), date(1997, 7, 1), date(1999, 1, 1), date(2006, 1, 1), date(2009, 1, 1),
    date(2012, 7, 1), date(2015, 7, 1), date(2017, 1, 1),
)  # fmt: skip
"""Dates from which GPS minus UTC is one second larger (IERS Bulletin C); none after 2017."""

_LEAP_SECOND_TIMES_UTC = np.array(
    [
        datetime(d.year, d.month, d.day, tzinfo=UTC).timestamp() - GPS_EPOCH
        for d in LEAP_SECOND_DATES
    ]
)
CURRENT_LEAP_SECONDS = len(LEAP_SECOND_DATES)
"""GPS minus UTC since 2017, seconds."""


@dataclass(frozen=True)
class TimeBase:
    """Definition of a time base.

    Attributes
    ----------
    key : str
        Name in the project file and on the command line.
    offset : float, seconds
        Time since 1980-01-06 at its origin, without leap seconds.
    period : float or None, seconds
        Period of its rollover; None if it has none.
    utc : bool
        Whether leap seconds are not counted, unlike in GPS time.
    lowest, highest : float, seconds
        Possible values in a survey. For absolute bases, years 2000 to 2045; for periodic bases,
        up to two periods, since some files continue the count after the rollover.
    """

    key: str
    offset: float
    period: float | None
    utc: bool
    lowest: float
    highest: float


def _absolute_base(key: str, offset: float, utc: bool) -> TimeBase:
    first = datetime(2000, 1, 1, tzinfo=UTC).timestamp() - GPS_EPOCH
    last = datetime(2045, 1, 1, tzinfo=UTC).timestamp() - GPS_EPOCH
    return TimeBase(key, offset, None, utc, first - offset, last - offset)


TIME_BASES = (
    TimeBase("gps-week", 0.0, WEEK, False, 0.0, 2 * WEEK),
    TimeBase("gps-day", 0.0, DAY, False, 0.0, 2 * DAY),
    TimeBase("utc-day", 0.0, DAY, True, 0.0, 2 * DAY),
    TimeBase("utc-week", 0.0, WEEK, True, 0.0, 2 * WEEK),
    _absolute_base("gps-adjusted", 1e9, False),
    _absolute_base("gps-full", 0.0, False),
    _absolute_base("unix", -GPS_EPOCH, True),
    _absolute_base("tai", -GPS_EPOCH - TAI_MINUS_GPS_S, False),
    TimeBase("utc-hour", 0.0, HOUR, True, 0.0, 2 * HOUR),
)
"""All time bases, the more common ones first."""

TIME_BASE_KEYS = tuple(base.key for base in TIME_BASES)


def base_of_key(key: str) -> TimeBase:
    """Time base with this key.

    Raises
    ------
    InputError
        If no time base has that key.
    """
    for base in TIME_BASES:
        if base.key == key:
            return base
    raise InputError(error("time.unknown_base", base=key, bases=TIME_BASE_KEYS))


def plausible_bases(times: Array) -> tuple[TimeBase, ...]:
    """Bases in which the values of ``times`` are possible, the more common ones first.

    Times below one week are never assumed to be adjusted GPS time, which had such values only in
    September 2011.

    Parameters
    ----------
    times : ndarray of shape (n,), seconds
    """
    times = np.asarray(times, dtype=np.float64)
    if not times.size or not np.isfinite(times).all():
        return ()
    low, high = float(times.min()), float(times.max())

    def possible(base: TimeBase) -> bool:
        if base.key == "gps-adjusted" and low >= 0 and high < WEEK:
            return False
        return base.lowest <= low and high < base.highest

    return tuple(base for base in TIME_BASES if possible(base))


def leap_seconds(utc: Array | float) -> Array:
    """GPS minus UTC, seconds, at ``utc`` (...), seconds of UTC days since 1980-01-06."""
    return np.searchsorted(_LEAP_SECOND_TIMES_UTC, utc, side="right").astype(np.float64)


def leap_seconds_at_gps(gps: Array | float) -> Array:
    """GPS minus UTC, seconds, at ``gps`` (...), GPS seconds since 1980-01-06."""
    starts = _LEAP_SECOND_TIMES_UTC + np.arange(1, len(_LEAP_SECOND_TIMES_UTC) + 1)
    return np.searchsorted(starts, gps, side="right").astype(np.float64)


def to_gps(times: Array, base: TimeBase, near: float | None = None) -> Array:
    """GPS seconds since 1980-01-06 of ``times``, shape (n,).

    Parameters
    ----------
    times : ndarray of shape (n,), seconds in ``base``, with rollovers resolved (`unroll_times`)
    near : float, GPS seconds since 1980-01-06
        For a base with a period: a time within half a period of the first time.

    Raises
    ------
    InputError
        If ``near`` is needed and missing.
    """
    times = np.asarray(times, dtype=np.float64)
    if not times.size:
        return times.copy()
    continuous = times + base.offset
    if base.period is not None:
        if near is None:
            raise InputError(error("time.no_date", base=base.key))
        goal = near - (float(leap_seconds_at_gps(near)) if base.utc else 0.0)
        continuous = continuous + base.period * np.round((goal - continuous[0]) / base.period)
    return continuous + leap_seconds(continuous) if base.utc else continuous


def from_gps(gps: Array, base: TimeBase) -> Array:
    """The inverse of `to_gps`; times continue across a rollover."""
    gps = np.asarray(gps, dtype=np.float64)
    if not gps.size:
        return gps.copy()
    continuous = gps - leap_seconds_at_gps(gps) if base.utc else gps
    values = continuous - base.offset
    if base.period is not None:
        values = values - base.period * np.floor(values.min() / base.period)
    return values


def unroll_times(times: Array) -> tuple[Array, int]:
    """Times with the rollovers at a full hour, midnight or end of the week resolved.

    A step backwards counts as a rollover if it leads from the last minute of an hour, day or week
    to the first minute of the next one.

    Parameters
    ----------
    times : ndarray of shape (n,), seconds

    Returns
    -------
    times : ndarray of shape (n,), seconds
    count : int
        Number of rollovers.
    """
    times = np.asarray(times, dtype=np.float64)
    added, count = np.zeros(len(times)), 0
    for k in np.flatnonzero(np.diff(times) < -HOUR + ROLLOVER_MARGIN_S):
        if period := period_between(float(times[k]), float(times[k + 1])):
            added[k + 1 :] += period
            count += 1
    return (times + added, count) if count else (times, 0)


def period_between(before: float, after: float, leeway: float = ROLLOVER_MARGIN_S) -> float:
    """Period of the rollover between two times, seconds: an hour, a day or a week; 0 if none.

    Parameters
    ----------
    before, after : float, seconds
        Last time before and first time after the rollover.
    leeway : float, seconds
        Largest distance of each of the two from the rollover.
    """
    for period in (DAY, WEEK, HOUR):
        if period - leeway <= before < period and 0 <= after < leeway:
            return period
    return 0.0


@dataclass(frozen=True)
class TimeMatch:
    """A time base and shift that place point times on the trajectory.

    Attributes
    ----------
    pairs : tuple of (TimeBase, TimeBase)
        Bases of points and trajectory that lead to this shift, the more common ones first.
    shift : float, seconds
        Shift to be added to the point times.
    share : float
        Share of the point times that then lie inside the time span of the trajectory.
    leap_assumed : bool
        Whether the current leap seconds were used because neither file contains the date.
    """

    pairs: tuple[tuple[TimeBase, TimeBase], ...]
    shift: float
    share: float
    leap_assumed: bool = False

    @property
    def points(self) -> TimeBase:
        """Most likely time base of the points."""
        return self.pairs[0][0]

    @property
    def trajectory(self) -> TimeBase:
        """Most likely time base of the trajectory."""
        return self.pairs[0][1]

    def shifted_times(self, times: Array) -> Array:
        """Point times (n,), seconds, in the trajectory's base."""
        return np.asarray(times, dtype=np.float64) + self.shift


def find_time_matches(
    point_times: Array,
    trajectory_times: Array,
    *,
    point_bases: Iterable[TimeBase] | None = None,
    trajectory_bases: Iterable[TimeBase] | None = None,
) -> tuple[TimeMatch, ...]:
    """Find all conversions that bring points into the time span of the trajectory, best first.

    Parameters
    ----------
    point_times : ndarray of shape (n,), seconds
        All times of one line, or a sample.
    trajectory_times : ndarray of shape (m,), seconds, increasing
    point_bases, trajectory_bases : iterable of TimeBase, optional
        Known bases; by default all in which the values are possible.

    Returns
    -------
    tuple of TimeMatch
        Ordered by the share of points inside; of equal shares, no shift comes first, then the more
        common bases. Empty if no conversion brings any point inside.
    """
    points = np.asarray(point_times, dtype=np.float64)
    points = points[np.isfinite(points)]
    track = np.asarray(trajectory_times, dtype=np.float64)
    if not points.size or not track.size:
        return ()
    start, end = float(track.min()), float(track.max())
    centre, goal = float(np.median(points)), (start + end) / 2
    found: dict[int, TimeMatch] = {}
    for own in plausible_bases(points) if point_bases is None else point_bases:
        for other in plausible_bases(track) if trajectory_bases is None else trajectory_bases:
            for shift, assumed in _possible_shifts(own, other, centre, goal):
                inside = (points + shift >= start) & (points + shift <= end)
                share = float(inside.mean())
                key, pair = round(shift * 1000), ((own, other),)
                if key in found:
                    before = found[key]
                    assumed = assumed and before.leap_assumed
                    found[key] = TimeMatch(before.pairs + pair, shift, share, assumed)
                elif share:
                    found[key] = TimeMatch(pair, shift, share, assumed)
    return tuple(sorted(found.values(), key=_match_rank))


def _possible_shifts(
    line_base: TimeBase, other: TimeBase, centre: float, goal: float
) -> list[tuple[float, bool]]:
    """Shifts from one base to another that bring ``centre`` close to ``goal``."""
    leap, assumed = 0.0, False
    if line_base.utc != other.utc:
        if line_base.period is None:
            leap = float(leap_seconds(centre + line_base.offset))
        elif other.period is None:
            leap = float(leap_seconds(goal + other.offset))
        else:
            leap, assumed = float(CURRENT_LEAP_SECONDS), True
    shift = line_base.offset - other.offset + leap * (float(line_base.utc) - float(other.utc))
    periods = [base.period for base in (line_base, other) if base.period is not None]
    if not periods:
        return [(shift, assumed)]
    # A trajectory may be longer than a day, so neighbouring days are tested as well.
    near = round((goal - centre - shift) / min(periods))
    return [(shift + min(periods) * (near + k), assumed) for k in (0, -1, 1)]


def _match_rank(match: TimeMatch) -> tuple[float, bool, int]:
    usual = min(
        TIME_BASE_KEYS.index(own.key) + TIME_BASE_KEYS.index(other.key)
        for own, other in match.pairs
    )
    return -round(match.share, 3), abs(match.shift) > 1e-9, usual


def equally_good_matches(matches: tuple[TimeMatch, ...]) -> tuple[TimeMatch, ...]:
    """Matches that are as good as the first within half a per cent of the points."""
    return tuple(match for match in matches[1:] if match.share >= matches[0].share - 0.005)
