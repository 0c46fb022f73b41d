"""Time bases: identification, and conversion between them.

Two bases differ by a constant over any survey that no leap second falls into: by the offset of
their zeros, by the leap seconds, and by whole days or weeks where a base starts again at midnight
or on Sunday. So a conversion is one shift in seconds, and of the whole days or weeks those are
taken that bring two files together.
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
GPS_AFTER_TAI = 19.0
"""Seconds that GPS time is behind TAI, at all times."""
GPS_EPOCH = datetime(1980, 1, 6, tzinfo=UTC).timestamp()
"""Unix time of the zero of GPS time, seconds."""
NEAR_START = 60.0
"""Seconds before and after midnight or the end of a week for the detection of a rollover."""

LEAP_DATES = (
    date(1981, 7, 1), date(1982, 7, 1), date(1983, 7, 1), date(1985, 7, 1), date(1988, 1, 1),
    date(1990, 1, 1), date(1991, 1, 1), date(1992, 7, 1), date(1993, 7, 1), date(1994, 7, 1),
    date(1996, 1, 1), date(1997, 7, 1), date(1999, 1, 1), date(2006, 1, 1), date(2009, 1, 1),
    date(2012, 7, 1), date(2015, 7, 1), date(2017, 1, 1),
)  # fmt: skip
"""Days at whose start GPS gained a second on UTC (IERS Bulletin C); none announced after 2017."""

_LEAP_UTC = np.array(
    [datetime(d.year, d.month, d.day, tzinfo=UTC).timestamp() - GPS_EPOCH for d in LEAP_DATES]
)
LEAP_SECONDS_NOW = len(LEAP_DATES)


@dataclass(frozen=True)
class TimeBase:
    """Definition of a time base.

    Attributes
    ----------
    key : str
        As in the project file and at the command line.
    offset : float, seconds
        Continuous time since 1980-01-06 at zero, leap seconds apart.
    period : float or None, seconds
        After which it starts again; None where it never does.
    utc : bool
        Whether it lacks the leap seconds that GPS time counts.
    lowest, highest : float, seconds
        Values a survey can have. Absolute bases: years 2000 to 2045. Periodic ones: one period
        more, for writers that continue through midnight.
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


BASES = (
    TimeBase("gps-week", 0.0, WEEK, False, 0.0, 2 * WEEK),
    TimeBase("gps-day", 0.0, DAY, False, 0.0, 2 * DAY),
    TimeBase("utc-day", 0.0, DAY, True, 0.0, 2 * DAY),
    TimeBase("utc-week", 0.0, WEEK, True, 0.0, 2 * WEEK),
    _absolute_base("gps-adjusted", 1e9, False),
    _absolute_base("gps-full", 0.0, False),
    _absolute_base("unix", -GPS_EPOCH, True),
    _absolute_base("tai", -GPS_EPOCH - GPS_AFTER_TAI, False),
    TimeBase("utc-hour", 0.0, HOUR, True, 0.0, 2 * HOUR),
)
"""All bases, the more usual first."""

KEYS = tuple(base.key for base in BASES)


def base_of_key(key: str) -> TimeBase:
    """The base of that key.

    Raises
    ------
    InputError
        If no time base has that key.
    """
    for base in BASES:
        if base.key == key:
            return base
    raise InputError(error("time.unknown_base", base=key, bases=KEYS))


def plausible_bases(times: Array) -> tuple[TimeBase, ...]:
    """Bases that ``times`` can be in by their values alone, the more usual first.

    Below one week, times are not taken for adjusted GPS time, which had such values in September
    2011 alone.

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

    return tuple(base for base in BASES if possible(base))


def leap_seconds(utc: Array | float) -> Array:
    """GPS minus UTC, seconds, at ``utc`` (...), seconds of UTC days since 1980-01-06."""
    return np.searchsorted(_LEAP_UTC, utc, side="right").astype(np.float64)


def leap_seconds_at_gps(gps: Array | float) -> Array:
    """GPS minus UTC, seconds, at ``gps`` (...), GPS seconds since 1980-01-06."""
    starts = _LEAP_UTC + np.arange(1, len(_LEAP_UTC) + 1)
    return np.searchsorted(starts, gps, side="right").astype(np.float64)


def to_gps(times: Array, base: TimeBase, near: float | None = None) -> Array:
    """GPS seconds since 1980-01-06 of ``times``, shape (n,).

    Parameters
    ----------
    times : ndarray of shape (n,), seconds in ``base``; wraps already unrolled (`unroll_times`)
    near : float, GPS seconds since 1980-01-06
        For a base that starts again every day or week: a time within half a period of the first.

    Raises
    ------
    InputError
        Where ``near`` is needed and missing.
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
    """Times with the rollover at midnight or end of the week resolved.

    A step back counts as a new start where it is a whole day or week but for a step ahead of at
    most a minute, from the last minute before to the first one after it.

    Parameters
    ----------
    times : ndarray of shape (n,), seconds

    Returns
    -------
    times : ndarray of shape (n,), seconds
    count : int
        Starts found.
    """
    times = np.asarray(times, dtype=np.float64)
    added, count = np.zeros(len(times)), 0
    for k in np.flatnonzero(np.diff(times) < -HOUR + NEAR_START):
        if period := period_between(float(times[k]), float(times[k + 1])):
            added[k + 1 :] += period
            count += 1
    return (times + added, count) if count else (times, 0)


def period_between(before: float, after: float, leeway: float = NEAR_START) -> float:
    """Seconds, a day or a week, that start again between two times; 0 where none does.

    Parameters
    ----------
    before, after : float, seconds
        The last time before and the first one after.
    leeway : float, seconds
        That each of the two may be from the start.
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
        Bases of points and trajectory that lead to this shift, the more usual first.
    shift : float, seconds
        To be added to the point times.
    share : float
        Part of the point times that then lies inside the trajectory's span.
    leap_assumed : bool
        Whether the current leap seconds were used because neither file contains the date.
    """

    pairs: tuple[tuple[TimeBase, TimeBase], ...]
    shift: float
    share: float
    leap_assumed: bool = False

    @property
    def points(self) -> TimeBase:
        """The likeliest base of the points."""
        return self.pairs[0][0]

    @property
    def trajectory(self) -> TimeBase:
        """The likeliest base of the trajectory."""
        return self.pairs[0][1]

    def applied(self, times: Array) -> Array:
        """Point times (n,), seconds, in the trajectory's base."""
        return np.asarray(times, dtype=np.float64) + self.shift


def find_time_matches(
    point_times: Array,
    trajectory_times: Array,
    *,
    point_bases: Iterable[TimeBase] | None = None,
    trajectory_bases: Iterable[TimeBase] | None = None,
) -> tuple[TimeMatch, ...]:
    """All conversions that bring points onto the trajectory, best first.

    Parameters
    ----------
    point_times : ndarray of shape (n,), seconds
        Of one line, all or a sample.
    trajectory_times : ndarray of shape (m,), seconds, increasing
    point_bases, trajectory_bases : iterable of TimeBase, optional
        Where the base is given; otherwise all that the values allow.

    Returns
    -------
    tuple of Match
        By the share inside; among equal ones no shift comes first, then the more usual bases.
        Empty where nothing brings one point inside.
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
    """Shifts from one base to another that bring ``centre`` next to ``goal``."""
    leap, assumed = 0.0, False
    if line_base.utc != other.utc:
        if line_base.period is None:
            leap = float(leap_seconds(centre + line_base.offset))
        elif other.period is None:
            leap = float(leap_seconds(goal + other.offset))
        else:
            leap, assumed = float(LEAP_SECONDS_NOW), True
    shift = line_base.offset - other.offset + leap * (float(line_base.utc) - float(other.utc))
    periods = [base.period for base in (line_base, other) if base.period is not None]
    if not periods:
        return [(shift, assumed)]
    # A trajectory may be longer than a day: the neighbouring days are tried too.
    near = round((goal - centre - shift) / min(periods))
    return [(shift + min(periods) * (near + k), assumed) for k in (0, -1, 1)]


def _match_rank(match: TimeMatch) -> tuple[float, bool, int]:
    usual = min(KEYS.index(own.key) + KEYS.index(other.key) for own, other in match.pairs)
    return -round(match.share, 3), abs(match.shift) > 1e-9, usual


def equally_good_matches(matches: tuple[TimeMatch, ...]) -> tuple[TimeMatch, ...]:
    """Matches as good as the first, to half a per cent of the points."""
    return tuple(match for match in matches[1:] if match.share >= matches[0].share - 0.005)
