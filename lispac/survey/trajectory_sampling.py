"""Check whether the states of a trajectory follow the motion of the vessel.

They have to be dense enough for linear interpolation, and none may repeat an earlier position.
"""

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Level, Message
from lispac.survey.trajectory import LocalTrajectory, TrajectoryAccuracy
from lispac.warning_causes import Cause

Array = NDArray[np.float64]

MAX_ERROR_SHARE = 0.1
"""Largest ratio of the interpolation error to the given accuracy."""
AVERAGING_TIME_S = 0.25
"""Averaging time, which removes vibration but not the motion in waves."""
ERROR_QUANTILE = 0.95
"""Quantile over the points of a line of the error that is reported."""
MIN_GAP_RATIO = 3.0
"""Smallest ratio of a gap to the median time between two states."""
SAME_POSITION_M = 1e-6
"""Largest horizontal distance of two states with the same position, metres."""
MIN_STEP_RATIO = 2.0
"""Smallest ratio of the step after a held position to the next one. It is 1 when a vessel at rest
starts to move; after n states with a held position it is n, or infinite if it is held again."""


def interpolation_error(trajectory: LocalTrajectory) -> Array:
    """Error bound of the interpolation between the states, shape (n - 1, 6).

    For an interval dt, the error is at most ``dt^2 / 8`` times the second derivative (de Boor 2001,
    I), which is computed from the second differences of the states. The error of states that were
    inserted from velocities and angular rates is added.

    Parameters
    ----------
    trajectory : LocalTrajectory

    Returns
    -------
    ndarray of shape (n - 1, 6), metres and radians
    """
    # One row per component, which is faster than one per state
    states = np.vstack([trajectory.position.T, trajectory.attitude.T])
    from scipy.ndimage import uniform_filter1d  # imported only when a survey is loaded

    steps = np.diff(trajectory.time)
    slopes = np.diff(states) / steps
    curvature = np.diff(slopes) / (0.5 * (steps[:-1] + steps[1:]))
    # Noise of states and vibration change their sign from state to state and average out
    # over a target; the mean over the window is the error due to the motion.
    width = max(1, round(AVERAGING_TIME_S / float(np.median(steps))))
    smooth = uniform_filter1d(curvature, width, mode="nearest")
    ends = np.abs(np.hstack([smooth[:, :1], smooth, smooth[:, -1:]]))
    straight = (0.5 * (ends[:, :-1] + ends[:, 1:]) * steps**2 / 8).T
    return np.asarray(
        straight if trajectory.curve_error is None else straight + trajectory.curve_error
    )


def interpolation_messages(
    trajectory: LocalTrajectory,
    accuracy: TrajectoryAccuracy,
    times: Mapping[str, Array],
    dense_times: Mapping[str, Callable[[], Array]] | None = None,
) -> tuple[Message, ...]:
    """Messages about lines during which the states are too far apart for the motion.

    Either all of them are, or some gaps are interpolated with an error beyond the given accuracy.

    Parameters
    ----------
    times : mapping of str to ndarray of shape (n,), seconds
        Times of a sample of the points of each line, by its name; intervals without points are
        ignored.
    dense_times : mapping of str to function that returns an ndarray of shape (m,), seconds
        Times of a denser sample, without which short gaps may be missed. The function is called
        only for lines during which the trajectory has gaps.
    """
    if len(trajectory.time) < 3:
        return ()
    errors = interpolation_error(trajectory)
    middle = 0.5 * (trajectory.time[:-1] + trajectory.time[1:])
    steps = np.diff(trajectory.time)
    found = []
    for name, own in times.items():
        own = own[(own >= trajectory.time[0]) & (own < trajectory.time[-1])]
        # Interval of each point
        intervals = np.searchsorted(trajectory.time, own, side="right") - 1
        bridged = steps[intervals] <= trajectory.longest_gap
        own, intervals = own[bridged], intervals[bridged]
        if len(intervals) < 2:
            continue
        # The error has its maximum in the middle of an interval and is zero at the states.
        u = (own - trajectory.time[intervals]) / steps[intervals]
        of_points = errors[intervals] * (4 * u * (1 - u))[:, None]
        error = np.quantile(of_points, ERROR_QUANTILE, axis=0)
        position_sigma, attitude_sigma = (
            values.mean(axis=0) for values in accuracy.at(middle[intervals])
        )
        position, turn = float(error[:3].max()), float(error[3:].max())
        share = max(
            float(np.max(error[:3] / np.maximum(position_sigma, 1e-6))),
            float(np.max(error[3:] / np.maximum(attitude_sigma, 1e-9))),
        )
        if share > MAX_ERROR_SHARE:
            found.append(
                Message(
                    "trajectory.rate_too_low",
                    Level.WARNING,
                    {
                        "line": name,
                        "rate": 1.0 / (trajectory.parts * float(np.median(steps[intervals]))),
                        "shift": position,
                        "turn": turn,
                        "share": share,
                    },
                    Cause.of_line(name),
                )
            )
            continue
        usual_step = float(np.median(steps[intervals]))
        inside = (middle > own.min()) & (middle < own.max())
        if dense_times is not None and _is_gap(trajectory, usual_step)[inside].any():
            own = dense_times[name]()
        message = _gap_message(name, trajectory, accuracy, errors, own, usual_step)
        if message is not None:
            found.append(message)
    return tuple(found)


def _is_gap(trajectory: LocalTrajectory, usual_step: float) -> NDArray[np.bool_]:
    """Whether each interval between two states is a gap that is interpolated, shape (n - 1,)."""
    steps = np.diff(trajectory.time)
    return np.asarray((steps > MIN_GAP_RATIO * usual_step) & (steps <= trajectory.longest_gap))


def _gap_message(
    name: str,
    trajectory: LocalTrajectory,
    accuracy: TrajectoryAccuracy,
    errors: Array,
    own: Array,
    usual_step: float,
) -> Message | None:
    """Warning about the gaps with points of a line and an error beyond the given accuracy."""
    time, steps = trajectory.time, np.diff(trajectory.time)
    own = own[(own >= time[0]) & (own < time[-1])]
    gaps = np.searchsorted(time, own, side="right") - 1
    in_gap = _is_gap(trajectory, usual_step)[gaps]
    own, gaps = own[in_gap], gaps[in_gap]
    u = (own - time[gaps]) / steps[gaps]
    of_gaps = errors[gaps] * (4 * u * (1 - u))[:, None]
    exceeds = (of_gaps > np.hstack(accuracy.at(time[gaps] + 0.5 * steps[gaps]))).any(axis=1)
    if not exceeds.any():
        return None
    return Message(
        "trajectory.gap_interpolated",
        Level.WARNING,
        {
            "line": name,
            "count": len(np.unique(gaps[exceeds])),
            "longest": float(steps[gaps[exceeds]].max()),
            "shift": float(of_gaps[:, :3].max()),
            "turn": float(of_gaps[:, 3:].max()),
        },
        Cause.of_line(name),
    )


def held_position_messages(
    trajectory: LocalTrajectory,
    accuracy: TrajectoryAccuracy,
    times: Mapping[str, Array],
) -> tuple[Message, ...]:
    """Messages about lines on which states repeat a position while the vessel moves.

    A position that is written more often than it is measured, or that is frozen for some time, is
    followed by a step. At the mean speed until the end of the step, the last state with the held
    position is displaced by the part of the step that corresponds to its age. Only displacements
    beyond the given accuracy are reported.

    Parameters
    ----------
    times : mapping of str to ndarray of shape (n,), seconds
        Times of a sample of the points of each line, by its name.
    """
    if len(trajectory.time) < 3:
        return ()
    given = slice(None) if trajectory.given is None else trajectory.given
    time, position = trajectory.time[given], trajectory.position[given, :2]
    distance = np.linalg.norm(np.diff(position, axis=0), axis=1)
    held = distance < SAME_POSITION_M
    # First and last state of each held position, and the state after the step
    last = np.flatnonzero(held[:-1] & ~held[1:]) + 1
    first = np.flatnonzero(held & ~np.concatenate([[False], held[:-1]]))[: len(last)]
    after = last + 1
    step, following = distance[last], np.append(distance, 0.0)[after]
    age = time[last] - time[first]
    shift = step * age / (time[after] - time[first])
    sigma = accuracy.at(time[last])[0][:, :2].max(axis=1)
    moved = (step > MIN_STEP_RATIO * following) & (shift > sigma)
    moved &= time[after] - time[last] <= trajectory.longest_gap
    first, after, age, shift = first[moved], after[moved], age[moved], shift[moved]
    found = []
    for name, own in times.items():
        own = np.sort(own)
        used = np.searchsorted(own, time[after], "right") > np.searchsorted(own, time[first])
        if used.any():
            found.append(
                Message(
                    "trajectory.position_held",
                    Level.WARNING,
                    {
                        "line": name,
                        "longest": float(age[used].max()),
                        "shift": float(shift[used].max()),
                    },
                    Cause.of_line(name),
                )
            )
    return tuple(found)
