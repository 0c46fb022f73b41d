"""Proposed time shifts for a line with points outside the trajectory."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Level, Message, Value, note
from lispac.project import LineSource, Reading
from lispac.survey.known_time_base import MIN_SHARE_GAIN, base_message, shift_note
from lispac.survey.line_source import TIME_ROLLOVER_OPTION, printable
from lispac.survey.time_base import (
    TimeBase,
    base_of_key,
    equally_good_matches,
    find_time_matches,
    plausible_bases,
)
from lispac.survey.time_rollover import (
    NO_ROLLOVER,
    ROLLOVER_NAMES,
    ROLLOVER_PERIODS_S,
    find_rollover,
)

Array = NDArray[np.float64]


def outside_trajectory_message(reading: Reading, times: Array, track: Array, file: Path) -> Message:
    """Error that a line has no point on the trajectory, with the suggested action.

    Parameters
    ----------
    reading : Reading
        Reading options of the line.
    times : ndarray of shape (n,), seconds
        Times of the line, with the time shift and rollover of ``reading`` applied.
    track : ndarray of shape (m,), seconds, increasing
        Times of the trajectory.
    file : Path
        File of the line.
    """
    first, last = float(times.min()), float(times.max())
    start, end = float(track[0]), float(track[-1])
    span: dict[str, Value] = {
        "file": str(file), "first": first, "last": last, "start": start, "end": end,
    }  # fmt: skip
    if reading.time_shift:
        written = times - reading.time_shift
        inside = ((written >= track[0]) & (written <= track[-1])).any()
        code = "import.shift_not_needed" if inside else "import.shift_wrong"
        return Message(code, Level.ERROR, {**span, "shift": reading.time_shift})
    some, bases = times[:: max(1, len(times) // 1000)], _known_time_bases(reading, times)
    found = find_time_matches(some, track, point_bases=bases)
    if found and abs(found[0].shift) > 1e-9:
        best = found[0]
        span |= {
            "shift": best.shift, "share": best.share, "points": base_message(best.points),
            "trajectory": base_message(best.trajectory),
        }  # fmt: skip
        rivals = tuple(
            note("import.shift_from", shift=match.shift, base=base_message(match.points))
            for match in equally_good_matches(found)[:3]
        )
        if rivals:
            span["shifts"] = rivals
        code = "import.outside_with_shifts" if rivals else "import.outside_with_shift"
        return Message(code, Level.ERROR, span)
    code = "import.nowhere_on_trajectory"
    if last < start:
        code, span["distance"] = "import.before_trajectory", start - last
    elif first > end:
        code, span["distance"] = "import.after_trajectory", first - end
    return Message(code, Level.ERROR, span)


def _known_time_bases(reading: Reading, times: Array) -> tuple[TimeBase, ...] | None:
    """Time base of a line, from the file or the user, if its times are possible in it."""
    key = dict(reading.options).get("time_base", "")
    return (base_of_key(key),) if key and base_of_key(key) in plausible_bases(times) else None


def shift_gain_note(line: LineSource, times: Array, track: Array) -> Message | None:
    """Note on a change that would bring clearly more points onto the trajectory, or None.

    The change is a time shift, or another setting of the time rollover.

    Parameters
    ----------
    line : LineSource
    times : ndarray of shape (n,), seconds
        All times of the line or a sample, with its time shift and rollover applied.
    track : ndarray of shape (m,), seconds, increasing
        Times of the trajectory.
    """
    if not len(times):
        return None
    reading, file = line.reading, printable(line.path.name)
    if not reading.time_rollover and (found := find_rollover(reading.to_file_time(times))):
        return note(
            "import.restart_found",
            file=file,
            place=ROLLOVER_NAMES[found],
            option=f"{TIME_ROLLOVER_OPTION}={found}",
        )
    inside = (times >= track[0]) & (times <= track[-1])
    if (
        reading.time_rollover in ROLLOVER_PERIODS_S
    ):  # the times of the trajectory may have been sorted
        written = reading.to_file_time(times) + reading.time_shift
        share = float(((written >= track[0]) & (written <= track[-1])).mean())
        if share >= float(inside.mean()) + MIN_SHARE_GAIN:
            return note(
                "import.restart_not_needed",
                file=file,
                share=share,
                option=f"{TIME_ROLLOVER_OPTION}={NO_ROLLOVER}",
            )
    if reading.time_shift:
        return None
    return shift_note(find_time_matches(times, track), float(inside.mean()), file)
