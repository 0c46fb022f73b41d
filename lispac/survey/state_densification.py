"""Insertion of states into a trajectory, computed from velocities and angular rates.

The error of linear interpolation between states is 6 mm and more at 10 Hz in waves. If the file has
velocities and angular rates, cubic Hermite interpolation (de Boor 2001, IV), which uses the states
and their derivatives at both ends, follows the motion. Its values are inserted as additional
states, so close together that linear interpolation between them is sufficient. All functions can
then use linear interpolation.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Places = NDArray[np.int64] | slice

MAX_INTERPOLATION_ERROR = np.array([1e-4] * 3 + [float(np.radians(1e-4))] * 3)
"""Largest error of linear interpolation between the inserted states, metres and radians."""
MAX_PARTS = 20
"""Largest number of parts into which an interval is divided."""
MAX_ERROR_RATIO = 0.5
"""Largest ratio of the errors of cubic and linear interpolation for which the cubic is used."""
MIN_TEST_STATES = 20
"""Smallest number of test states; with fewer, no states are inserted."""
ERROR_QUANTILE = 0.995
"""Quantile of the intervals that determines the number of parts."""


@dataclass(frozen=True, eq=False)
class DenseStates:
    """States of a trajectory with the inserted ones.

    Attributes
    ----------
    time : ndarray of shape (m,), seconds
    states : ndarray of shape (m, 6), metres and radians
    error : ndarray of shape (m - 1, 6), metres and radians, or None
        Estimated error of the cubics; None if no states were inserted.
    unused : tuple of int
        Components whose derivatives contradict the states; they are interpolated linearly.
    parts : int
        Number of intervals into which each interval between given states, except gaps, was divided.
    given : ndarray of shape (n,), int, or None
        Indices of the given states; None if no states were inserted.
    """

    time: Array
    states: Array
    error: Array | None = None
    unused: tuple[int, ...] = ()
    parts: int = 1
    given: NDArray[np.int64] | None = None


def insert_states(
    time: Array, states: Array, find_derivatives: Callable[[], Array], longest_gap: float
) -> DenseStates:
    """Insert states if linear interpolation has errors above `MAX_INTERPOLATION_ERROR`.

    The derivatives of a component are used only if the cubic predicts omitted states clearly better
    than a straight line. This is not the case for velocities along other axes or with another sign,
    or for rates in another unit.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds
    states : ndarray of shape (n, 6), metres and radians
        Angles without jumps by 2 pi.
    find_derivatives : callable
        Function that returns the derivatives of the states, shape (n, 6), metres and radians a
        second, with zeros for components without derivatives. It is called only if linear
        interpolation is too coarse.
    longest_gap : float, seconds
        Longest interval between two states over which positions are interpolated.
    """
    steps = np.diff(time)
    bridged = steps <= longest_gap
    inner = np.flatnonzero(bridged[1:] & bridged[:-1]) + 1
    if len(inner) < MIN_TEST_STATES:
        return DenseStates(time, states)
    before, at, after = _neighbours(inner, len(time))
    # Prediction of each inner state from its neighbours, over twice the interval.
    span = time[after] - time[before]
    u = ((time[at] - time[before]) / span)[:, None]
    ends = states[before], states[after]
    straight = states[at] - (ends[0] + u * (ends[1] - ends[0]))
    error_straight = np.abs(straight)
    # For a parabola, the error over one interval is a quarter of that over two.
    needed = np.quantile(error_straight, ERROR_QUANTILE, axis=0) / 4
    coarse = needed > MAX_INTERPOLATION_ERROR
    if not coarse.any():
        return DenseStates(time, states)
    derivatives = find_derivatives()
    slopes = derivatives[before], derivatives[after]
    error_cubic = states[at] - hermite_cubic(u, span[:, None], ends, slopes)
    used = np.abs(error_cubic).mean(axis=0) < MAX_ERROR_RATIO * error_straight.mean(axis=0)
    unused = tuple(np.flatnonzero(coarse & ~used & derivatives.any(axis=0)).tolist())
    parts = int(np.ceil(np.sqrt(np.max(needed / MAX_INTERPOLATION_ERROR, where=used, initial=0.0))))
    parts = min(parts, MAX_PARTS)
    if parts <= 1:
        return DenseStates(time, states, unused=unused)
    # For a polynomial of fourth degree, a sixteenth; the omitted states give the error.
    cubic_errors = np.zeros_like(states)
    cubic_errors[at] = error_cubic / 16 * used
    return _insert_parts(time, states, derivatives, bridged, used, cubic_errors, parts, unused)


def _neighbours(inner: NDArray[np.int64], count: int) -> tuple[Places, Places, Places]:
    """Places of the states before inner ones, of these and of those after, of ``count`` states."""
    if len(inner) == count - 2:  # slices are several times faster than the same indices
        return slice(None, -2), slice(1, -1), slice(2, None)
    return inner - 1, inner, inner + 1


def _insert_parts(
    time: Array, states: Array, derivatives: Array, bridged: NDArray[np.bool_],
    used: NDArray[np.bool_], off: Array, parts: int, unused: tuple[int, ...],
) -> DenseStates:  # fmt: skip
    counts = np.where(bridged, parts, 1)
    first = np.repeat(np.arange(len(counts)), counts)
    place = np.arange(len(first)) - np.repeat(np.cumsum(counts) - counts, counts)
    u = (place / np.repeat(counts, counts))[:, None]
    span = np.diff(time)[first][:, None]
    ends, slopes = (states[first], states[first + 1]), (derivatives[first], derivatives[first + 1])
    cubic = hermite_cubic(u, span, ends, slopes)
    straight = ends[0] + u * (ends[1] - ends[0])
    dense = np.vstack([np.where(used, cubic, straight), states[-1:]])
    own = np.flatnonzero(place == 0)
    dense[own] = states[first[own]]
    times = np.append(time[first] + u[:, 0] * span[:, 0], time[-1])
    times[own] = time[first[own]]
    error = np.repeat(np.maximum(np.abs(off[:-1]), np.abs(off[1:])), counts, axis=0)
    return DenseStates(times, dense, error, unused, parts, np.append(own, len(times) - 1))


def hermite_cubic(
    u: Array, span: Array, ends: tuple[Array, Array], slopes: tuple[Array, Array]
) -> Array:
    """Cubic through two states with their derivatives.

    Parameters
    ----------
    u : ndarray of shape (n, 1)
        Position between the two states, 0 to 1.
    span : ndarray of shape (n, 1), seconds
    ends : two ndarrays of shape (n, m)
        States.
    slopes : two ndarrays of shape (n, m), a second
        Their derivatives.

    Returns
    -------
    ndarray of shape (n, m)
    """
    v = 1 - u
    return np.asarray(
        (1 + 2 * u) * v**2 * ends[0]
        + (3 - 2 * u) * u**2 * ends[1]
        + span * (u * v**2 * slopes[0] - u**2 * v * slopes[1])
    )


def attitude_rates(attitude: Array, body_rates: Array) -> Array:
    """Derivatives of roll, pitch and heading from angular rates about the body axes.

    Titterton and Weston (2004), 3.6.3, for roll positive starboard down and pitch positive bow up.

    Parameters
    ----------
    attitude : ndarray of shape (n, 3), radians
        Roll, pitch, heading.
    body_rates : ndarray of shape (n, 3), radians a second
        About the axes forward, starboard, down.

    Returns
    -------
    ndarray of shape (n, 3), radians a second
    """
    roll, pitch, _ = attitude.T
    forward, starboard, down = body_rates.T
    sin, cos = np.sin(roll), np.cos(roll)
    turn = (sin * starboard + cos * down) / np.maximum(np.cos(pitch), 1e-3)
    return np.stack([forward + np.sin(pitch) * turn, cos * starboard - sin * down, turn], axis=1)


def body_rates(attitude: Array, attitude_rate: Array) -> Array:
    """Angular rates about the axes forward, starboard, down; the inverse of `attitude_rates`.

    Parameters
    ----------
    attitude : ndarray of shape (n, 3), radians
        Roll, pitch (positive bow up), heading.
    attitude_rate : ndarray of shape (n, 3), radians a second
        Their derivatives.

    Returns
    -------
    ndarray of shape (n, 3), radians a second
    """
    roll, pitch, _ = attitude.T
    roll_rate, pitch_rate, turn = attitude_rate.T
    sin, cos = np.sin(roll), np.cos(roll)
    level = np.cos(pitch) * turn
    return np.stack(
        [
            roll_rate - np.sin(pitch) * turn,
            cos * pitch_rate + sin * level,
            cos * level - sin * pitch_rate,
        ],
        axis=1,
    )
