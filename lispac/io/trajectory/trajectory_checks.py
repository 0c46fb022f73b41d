"""Checks of trajectory values for all formats."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import error
from lispac.survey.time_base import TimeBase, plausible_bases
from lispac.survey.trajectory import DEFAULT_LONGEST_GAP_S

Array = NDArray[np.float64]
Numbers = NDArray[np.int64]

MAX_HEIGHT_M = 1e5
"""Largest accepted height, metres."""

MAX_TURN_RATE = 0.7
"""Largest turn rate of a carrier over one second, radians per second; with a wrong unit of angles,
it is exceeded in any turn."""


def require_time_base(path: Path, time: Array, base: TimeBase) -> None:
    """Refuse a time base that is not possible for the values of ``time`` (n,), seconds.

    Raises
    ------
    InputError
        If the times are not possible in this time base, or in none.
    """
    possible = plausible_bases(time)
    if base in possible:
        return
    start, end = float(time.min()), float(time.max())
    if not possible:
        raise InputError(error("trajectory.no_time_base", file=str(path), start=start, end=end))
    bases = tuple(other.key for other in possible)
    raise InputError(
        error(
            "trajectory.other_time_base", file=str(path), start=start, end=end, base=base.key,
            bases=bases,
        )
    )  # fmt: skip


def require_heights(path: Path, height: Array, numbers: Numbers | None = None) -> None:
    """Refuse heights that are impossible in a survey.

    Parameters
    ----------
    height : ndarray of shape (n,), metres
    numbers : ndarray of shape (n,), int, optional
        Row in the file of each.

    Raises
    ------
    InputError
        If a height is larger than `MAX_HEIGHT_M` in absolute value.
    """
    bad = np.abs(height) > MAX_HEIGHT_M
    if bad.any():
        k = int(np.argmax(bad))
        in_row = numbers is not None
        raise InputError(
            error(
                "trajectory.height_in_row" if in_row else "trajectory.height_in_record",
                file=str(path), number=_row_number(k, numbers), height=float(height[k]),
            )
        )  # fmt: skip


def require_attitude(
    path: Path,
    time: Array,
    attitude: tuple[Array, Array, Array],
    numbers: Numbers | None = None,
) -> None:
    """Refuse impossible angles, radians.

    A heading of more than two full turns is accepted if it is continuous: it is at some time within
    two full turns, and does not change faster than a carrier turns.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds
    attitude : three ndarrays of shape (n,), radians
        Roll, pitch, heading.
    numbers : ndarray of shape (n,), int, optional
        Row in the file of each.

    Raises
    ------
    InputError
        If roll, pitch or heading is outside its limits.
    """
    roll, pitch, heading = attitude
    bad = (np.abs(roll) > np.pi + 1e-6) | (np.abs(pitch) > np.pi / 2 + 1e-6)
    if not _is_continuous_heading(time, heading):
        bad |= np.abs(heading) > 4 * np.pi
    if bad.any():
        k = int(np.argmax(bad))
        in_row = numbers is not None
        raise InputError(
            error(
                "trajectory.attitude_in_row" if in_row else "trajectory.attitude_in_record",
                file=str(path), number=_row_number(k, numbers), roll=float(roll[k]),
                pitch=float(pitch[k]), heading=float(heading[k]),
            )
        )  # fmt: skip


def _row_number(k: int, numbers: Numbers | None) -> int:
    """Number of the row in the file, or of the record, of a state."""
    return int(numbers[k]) if numbers is not None else k + 1


def _is_continuous_heading(time: Array, heading: Array) -> bool:
    """True if a heading beyond two full turns results from continuous turning."""
    size = np.abs(heading)
    if size.max() <= 4 * np.pi:
        return True
    if size.min() > 4 * np.pi or size.max() > 1e6 or time[-1] - time[0] > 1e7:
        return False
    seconds = np.arange(time[0], time[-1], 1.0)
    if len(seconds) < 2:
        return False
    turns = np.abs(np.diff(np.interp(seconds, time, heading)))
    # Across a gap, the heading may change by any amount.
    after = np.minimum(np.searchsorted(time, seconds[1:]), len(time) - 1)
    known = time[after] - time[np.maximum(after - 1, 0)] <= DEFAULT_LONGEST_GAP_S
    return bool((turns[known] < MAX_TURN_RATE).all())
