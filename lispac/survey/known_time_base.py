"""Time conversion of a line where the time bases are given."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Message, error, note
from lispac.survey.time_base import (
    CURRENT_LEAP_SECONDS,
    TimeBase,
    TimeMatch,
    equally_good_matches,
    find_time_matches,
    plausible_bases,
)

Array = NDArray[np.float64]

MIN_SHARE_GAIN = 0.05
"""Smallest additional share of a line's points that a time shift has to bring inside the trajectory
to be suggested."""


BASE_NAME_CODES = {
    "gps-week": "time_base.gps_week",
    "gps-day": "time_base.gps_day",
    "utc-day": "time_base.utc_day",
    "utc-week": "time_base.utc_week",
    "gps-adjusted": "time_base.gps_adjusted",
    "gps-full": "time_base.gps_full",
    "unix": "time_base.unix",
    "tai": "time_base.tai",
    "utc-hour": "time_base.utc_hour",
}
"""Message code of the name of each time base, by its key."""


def base_message(base: TimeBase) -> Message:
    """Name of a time base, as a part of other messages."""
    return note(BASE_NAME_CODES[base.key])


@dataclass(frozen=True)
class KnownTimeBase:
    """Known time base of a file, and where it comes from.

    Attributes
    ----------
    base : TimeBase or None
    is_given : bool
        Whether the user has given it; otherwise it comes from the file or its format.
    suggested : bool
        Whether it is detected from the values, not given in the file.
    by_format : bool
        Whether the format of a line defines it, so that it is as certain as a given one.
    """

    base: TimeBase | None = None
    is_given: bool = False
    suggested: bool = False
    by_format: bool = False

    def fits(self, times: Array) -> bool:
        """Whether the base is known and ``times`` (n,), seconds, are possible in it."""
        return self.base is not None and self.base in plausible_bases(times)

    @property
    def message(self) -> Message:
        """Name of the base and its source, as part of other messages."""
        if self.base is None:
            return note("time_base.unknown")
        name = base_message(self.base)
        if self.is_given:
            return note("time_base.given", base=name)
        if self.suggested:
            return note("time_base.suggested", base=name)
        return note("time_base.of_file", base=name)


def time_base_error(times: Array, line_base: KnownTimeBase, file: str) -> Message | None:
    """Error that ``times`` are impossible in the given base; None if they are possible.

    Parameters
    ----------
    times : ndarray of shape (n,), seconds
        Of a line, as its file has them.
    file : str
        Name or path of the file.
    """
    if not line_base.is_given or line_base.base is None or line_base.fits(times):
        return None
    first, last, base = float(times.min()), float(times.max()), base_message(line_base.base)
    fitting = [each.key for each in plausible_bases(times)]
    if not fitting:
        return error("time_base.no_base_possible", file=file, first=first, last=last, base=base)
    return error(
        "time_base.not_possible", file=file, first=first, last=last, base=base, keys=fitting
    )


def matches_of_known_bases(
    times: Array, track: Array, line_base: KnownTimeBase, other: KnownTimeBase
) -> tuple[TimeMatch, ...] | None:
    """Conversions from the known base of a line to that of the trajectory, the best first.

    Parameters
    ----------
    times : ndarray of shape (n,), seconds
        Of a line, as its file has them.
    track : ndarray of shape (m,), seconds, increasing
        Of the trajectory.
    line_base, other : KnownTimeBase
        Of the line and of the trajectory.

    Returns
    -------
    tuple of TimeMatch or None
        None if neither base is given by the user or defined by the format of the line, or one of
        the two is unknown or contradicted by the times, or the base in the header of the line
        brings no point inside the trajectory. Empty if the base that the user gave for the line
        brings no point inside.
    """
    is_certain = line_base.is_given or line_base.by_format or other.is_given
    if line_base.base is None or other.base is None or not is_certain:
        return None
    if not line_base.fits(times) or not other.fits(track):
        return None  # a base in which the times are impossible does not count as known
    found = find_time_matches(
        times, track, point_bases=(line_base.base,), trajectory_bases=(other.base,)
    )
    # If the base in a header brings no point inside, all bases are tried instead.
    return found if found or line_base.is_given else None


def known_base_notes(
    matches: tuple[TimeMatch, ...], line_base: KnownTimeBase, other: KnownTimeBase, file: str
) -> tuple[Message, ...]:
    """Notes on the time shift that follows from the time bases of line and trajectory.

    Parameters
    ----------
    file : str
        Name of the file of the line.
    """
    best = matches[0]
    messages = [
        note(
            "import.shift_follows", file=file, shift=best.shift, base=line_base.message,
            trajectory_base=other.message,
        )
    ]  # fmt: skip
    if best.leap_assumed:
        messages.append(note("import.leap_seconds_assumed", file=file, leap=CURRENT_LEAP_SECONDS))
    if rivals := equally_good_matches(matches):
        shifts = tuple(note("import.shift", shift=match.shift) for match in rivals)
        messages.append(note("import.other_shifts_fit", file=file, shifts=shifts))
    return tuple(messages)


def no_overlap_error(
    line_base: KnownTimeBase, other: KnownTimeBase, times: Array, track: Array, file: str
) -> Message:
    """Error that no point lies within the trajectory in the given time bases.

    Parameters
    ----------
    times, track : ndarray of shape (n,), seconds
        Of the line and of the trajectory.
    file : str
        Path of the file of the line.
    """
    other_bases = [] if other.is_given or line_base.base is None else [
        base for base in plausible_bases(track)
        if base is not other.base
        and find_time_matches(times, track, point_bases=(line_base.base,), trajectory_bases=(base,))
    ]  # fmt: skip
    if other_bases:
        options = [f"--trajectory-option time={base.key}" for base in other_bases]
        return error(
            "time_base.other_trajectory_base", file=file, base=line_base.message,
            trajectory_base=other.message, options=options,
        )  # fmt: skip
    return error(
        "time_base.no_overlap", file=file, base=line_base.message, trajectory_base=other.message
    )


def clearly_better_match(matches: tuple[TimeMatch, ...], share: float) -> TimeMatch | None:
    """Best match if its share of points inside is clearly larger than ``share``."""
    return matches[0] if matches and matches[0].share >= share + MIN_SHARE_GAIN else None


def shift_note(matches: tuple[TimeMatch, ...], share: float, file: str) -> Message | None:
    """Note on a shift that brings clearly more points inside than ``share``; None without one."""
    best = clearly_better_match(matches, share)
    if best is None:
        return None
    return note(
        "import.shift_possible", file=file, shift=best.shift, share=best.share,
        points=base_message(best.points), trajectory=base_message(best.trajectory),
    )  # fmt: skip
