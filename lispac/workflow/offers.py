"""What is offered for a line of which points lie outside the trajectory."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Message, error
from lispac.project import Reading
from lispac.survey.source import RESTART
from lispac.survey.time_base import TimeBase, base_of, matches, plausible, sentence
from lispac.survey.time_restart import PERIODS, restart_of
from lispac.survey.time_stated import CLEARLY_MORE, offer

Array = NDArray[np.float64]


def outside(reading: Reading, times: Array, track: Array, file: Path) -> Message | str:
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
        return (
            f"{file}: its points ({first:.1f} to {last:.1f} s) lie outside the trajectory "
            f"({track[0]:.1f} to {track[-1]:.1f} s); check the date and the time base, or leave "
            f"the line out. {sentence(matches(some, track, point_bases=bases))}"
        )
    written = times - reading.time_shift
    inside = ((written >= track[0]) & (written <= track[-1])).any()
    return error(
        "import.shift_not_needed" if inside else "import.shift_wrong", file=str(file),
        shift=reading.time_shift, first=first, last=last, start=float(track[0]),
        end=float(track[-1]),
    )  # fmt: skip


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
