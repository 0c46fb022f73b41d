"""What is offered for a line of which points lie outside the trajectory."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Message, error, note
from lispac.project import Reading
from lispac.survey.source import RESTART
from lispac.survey.time_base import (
    LEAP_SECONDS_NOW,
    Match,
    TimeBase,
    base_of,
    matches,
    plausible,
    rival_matches,
)
from lispac.survey.time_restart import PERIODS, restart_of
from lispac.survey.time_stated import CLEARLY_MORE, base_message, offer

Array = NDArray[np.float64]

NO_SHIFT = 1e-9
"""Seconds below which a shift is none."""
MAX_RIVALS = 3
"""Other shifts that are named."""


def outside(reading: Reading, times: Array, track: Array, file: Path) -> Message:
    """That a line has no point on the trajectory and what to do.

    Parameters
    ----------
    reading : Reading
        Of the line.
    times : ndarray of shape (n,), seconds
        Of the line, as it is read.
    track : ndarray of shape (m,), seconds, increasing
        Of the trajectory.
    file : Path
        Of the line.
    """
    first, last = float(times.min()), float(times.max())
    if not reading.time_shift:
        some, bases = times[:: max(1, len(times) // 1000)], _bases(reading, times)
        return error(
            "import.line_outside", file=str(file), first=first, last=last, start=float(track[0]),
            end=float(track[-1]), fit=fit_message(matches(some, track, point_bases=bases)),
        )  # fmt: skip
    written = times - reading.time_shift
    inside = ((written >= track[0]) & (written <= track[-1])).any()
    return error(
        "import.shift_not_needed" if inside else "import.shift_wrong", file=str(file),
        shift=reading.time_shift, first=first, last=last, start=float(track[0]),
        end=float(track[-1]),
    )  # fmt: skip


def fit_message(found: tuple[Match, ...]) -> Message:
    """How the times of the points fit the trajectory, and whether another shift fits as well."""
    if not found:
        return note("time_fit.none")
    best, rivals = found[0], rival_matches(found)
    params: dict[str, Any] = {"share": float(best.share)}
    if abs(best.shift) < NO_SHIFT:
        fit = note("time_fit.as_is", **params)
    else:
        params |= {
            "points": base_message(best.points), "trajectory": base_message(best.trajectory),
            "shift": float(best.shift),
        }  # fmt: skip
        fit = (
            note("time_fit.shifted_leap", leap_seconds=float(LEAP_SECONDS_NOW), **params)
            if best.leap_assumed
            else note("time_fit.shifted", **params)
        )
    if not rivals:
        return fit
    others = tuple(
        note("time_fit.rival", shift=float(match.shift - best.shift),
             points=base_message(match.points))
        for match in rivals[:MAX_RIVALS]
    )  # fmt: skip
    if len({match.points.key for match in (best, *rivals)}) > 1:
        return note("time_fit.ambiguous_base", fit=fit, rivals=others)
    return note("time_fit.ambiguous", fit=fit, rivals=others)


def _bases(reading: Reading, times: Array) -> tuple[TimeBase, ...] | None:
    """What the times of a line count, where the file or the user states it and they can be that."""
    key = dict(reading.options).get("time_base", "")
    return (base_of(key),) if key and base_of(key) in plausible(times) else None


def offered(reading: Reading, times: Array, track: Array) -> str:
    """What would bring in clearly more of a line's points, without the file; empty for nothing.

    Parameters
    ----------
    reading : Reading
        Of the line.
    times : ndarray of shape (n,), seconds
        Of the line, as it is read: all or a sample.
    track : ndarray of shape (m,), seconds, increasing
        Of the trajectory.
    """
    if not len(times):
        return ""
    if not reading.restart and (found := restart_of(reading.moved_back(times))):
        return f"its times restart within it: import it again with --line-option {RESTART}={found}"
    inside = (times >= track[0]) & (times <= track[-1])
    if reading.restart in PERIODS:  # the trajectory may have been sorted instead of counted on
        written = reading.moved_back(times) + reading.time_shift
        share = float(((written >= track[0]) & (written <= track[-1])).mean())
        if share >= float(inside.mean()) + CLEARLY_MORE:
            return (
                f"not counted on, {100 * share:.1f} % of its points lie inside: where the "
                f"trajectory's times restart too, import it again with --line-option {RESTART}=none"
            )
    if reading.time_shift:
        return ""
    return offer(matches(times, track), float(inside.mean()))
