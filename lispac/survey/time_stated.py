"""What follows for a line's times from the time bases that are stated."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.survey.time_base import (
    LEAP_SECONDS_NOW,
    Match,
    TimeBase,
    matches,
    plausible,
    rival_matches,
)

Array = NDArray[np.float64]

CLEARLY_MORE = 0.05
"""Part of a line's points that a shift has to bring inside besides those that are, before it is
offered."""


@dataclass(frozen=True)
class Known:
    """What is known of the time base of a file.

    Attributes
    ----------
    base : TimeBase or None
    stated : bool
        Whether the user states it; otherwise it is what the file says or its format takes.
    suggested : bool
        Whether the file does not say it and its values suggest it.
    """

    base: TimeBase | None = None
    stated: bool = False
    suggested: bool = False

    def fits(self, times: Array) -> bool:
        """Whether there is a base that ``times`` (n,), seconds, can be in by their values."""
        return self.base is not None and self.base in plausible(times)

    @property
    def words(self) -> str:
        """Its name, and where it is from."""
        if self.base is None:
            return "not known"
        if self.stated:
            return f"{self.base.name} (stated)"
        where = "as its values suggest" if self.suggested else "as read from the file"
        return f"{self.base.name} ({where})"


def contradiction(times: Array, own: Known) -> str:
    """Why ``times`` cannot be in the base stated for them, without the file; empty where they can.

    Parameters
    ----------
    times : ndarray of shape (n,), seconds
        Of a line, as its file has them.
    """
    if not own.stated or own.base is None or own.fits(times):
        return ""
    fitting = plausible(times)
    hint = (
        f"by their values they are {' or '.join(base.name for base in fitting)}: state "
        f"{' or '.join(base.key for base in fitting)}, or leave it unstated"
        if fitting
        else "they fit no known time base; check which column or record is the time"
    )
    return (
        f"its times from {times.min():,.3f} to {times.max():,.3f} s cannot be {own.base.name}, as "
        f"stated; {hint}."
    )


def following(times: Array, track: Array, own: Known, other: Known) -> tuple[Match, ...] | None:
    """Ways from the line's base to the trajectory's, best first, where something is stated.

    Parameters
    ----------
    times : ndarray of shape (n,), seconds
        Of a line, as its file has them.
    track : ndarray of shape (m,), seconds, increasing
        Of the trajectory.
    own, other : Known
        Of the line and of the trajectory.

    Returns
    -------
    tuple of Match or None
        None where nothing is stated, or one of the two is not known or denied by the times; empty
        where what is stated brings no point inside.
    """
    if own.base is None or other.base is None or not (own.stated or other.stated):
        return None
    if not own.fits(times) or not other.fits(track):
        return None  # what the times deny is not known
    found = matches(times, track, point_bases=(own.base,), trajectory_bases=(other.base,))
    # A header that brings nothing inside is no reason to refuse.
    return found if found or own.stated else None


def following_words(found: tuple[Match, ...], own: Known, other: Known) -> str:
    """What the first way does, in a sentence without the file and without its end."""
    best = found[0]
    told = (
        f"{best.shift:+,.3f} s are added to its times, from {own.words} to the trajectory's "
        f"{other.words}"
    )
    if best.leap_assumed:
        told += f", with the leap seconds of today, {LEAP_SECONDS_NOW} s, as neither tells the date"
    if rivals := rival_matches(found):
        others = " or ".join(f"{match.shift:+,.3f} s" for match in rivals)
        told += f"; {others} would fit as well: make sure of the day"
    return told


def nowhere(own: Known, other: Known, times: Array, track: Array) -> str:
    """That what is stated brings no point onto the trajectory, without the file.

    Parameters
    ----------
    times, track : ndarray of shape (n,), seconds
        Of the line and of the trajectory.
    """
    told = (
        f"in {own.words} none of its points lies within the trajectory, whose times are "
        f"{other.words}"
    )
    others = [] if other.stated or own.base is None else [
        base for base in plausible(track)
        if base is not other.base
        and matches(times, track, point_bases=(own.base,), trajectory_bases=(base,))
    ]  # fmt: skip
    if others:
        names = " or ".join(base.name for base in others)
        options = " or ".join(f"--trajectory-option time={base.key}" for base in others)
        return (
            f"{told}; by their values these could also be {names}, where the points lie inside: "
            f"make sure what the trajectory counts, and state it ({options})."
        )
    return (
        f"{told}; state the time base that the times are in, or give the trajectory of the same "
        "survey."
    )


def bringing_more(found: tuple[Match, ...], share: float) -> Match | None:
    """The best of ``found`` where it brings clearly more inside than the part ``share``."""
    return found[0] if found and found[0].share >= share + CLEARLY_MORE else None


def offer(found: tuple[Match, ...], share: float) -> str:
    """A note on the shift that brings in clearly more than ``share``; empty without one."""
    best = bringing_more(found, share)
    if best is None:
        return ""
    return (
        f"with {best.shift:+,.3f} s added, {100 * best.share:.1f} % of its points lie inside: "
        f"where the scanner wrote {best.points.name} and the trajectory is in "
        f"{best.trajectory.name}, import it again with --time-shift {best.shift:.10g}"
    )
