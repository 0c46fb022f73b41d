"""Insert states between those of a trajectory, from velocities and angular rates.

A straight line between two states cuts off the motion between them, by 6 mm and more at 10 Hz in
waves. Where the file has velocities and angular rates, the cubic that has the states and their
derivatives at both ends (Hermite interpolation; de Boor 2001, IV) follows the motion. Its values
are inserted as further states, so close that straight lines between them suffice: whatever
interpolates a trajectory then interpolates alike.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

LIMIT = np.array([1e-4] * 3 + [float(np.radians(1e-4))] * 3)
"""Metres and radians that straight lines between the inserted states may be off by."""
MAX_PARTS = 20
"""Parts that an interval is divided into at most."""
MAX_ERROR_RATIO = 0.5
"""Error of the cubic over that of a straight line, at excluded states, up to which it is used."""
MIN_STATES = 20
"""States that can be excluded, below which nothing is inserted."""
QUANTILE = 0.995
"""Quantile of the intervals, for the number of parts."""


@dataclass(frozen=True, eq=False)
class DenseStates:
    """States with those inserted between them.

    Attributes
    ----------
    time : ndarray of shape (m,), seconds
    states : ndarray of shape (m, 6), metres and radians
    error : ndarray of shape (m - 1, 6), metres and radians, or None
        By how much the cubics may be off; None where nothing was inserted.
    unused : tuple of int
        Components whose derivatives contradict the states, so that they are interpolated linearly.
    parts : int
        Intervals that one interval between given states was divided into.
    """

    time: Array
    states: Array
    error: Array | None = None
    unused: tuple[int, ...] = ()
    parts: int = 1


def insert_states(
    time: Array, states: Array, derivatives: Array, longest_gap: float
) -> DenseStates:
    """Insert states where straight lines between the given ones are off by more than `LIMIT`.

    The derivatives of a component are used where the cubic predicts states that are excluded
    clearly better than a straight line does. Velocities along other axes or with another sign, and
    rates in another unit, do not.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds
    states : ndarray of shape (n, 6), metres and radians
        Angles without jumps by 2 pi.
    derivatives : ndarray of shape (n, 6), metres and radians a second
        Zeros where there are none.
    longest_gap : float, seconds
        Between two states that may be bridged.
    """
    steps = np.diff(time)
    bridged = steps <= longest_gap
    inner = np.flatnonzero(bridged[1:] & bridged[:-1]) + 1
    if len(inner) < MIN_STATES:
        return DenseStates(time, states)
    # Prediction of each inner state from its neighbours, over twice the interval.
    span = time[inner + 1] - time[inner - 1]
    u = ((time[inner] - time[inner - 1]) / span)[:, None]
    ends = states[inner - 1], states[inner + 1]
    slopes = derivatives[inner - 1], derivatives[inner + 1]
    straight = states[inner] - (ends[0] + u * (ends[1] - ends[0]))
    error_cubic = states[inner] - hermite_cubic(u, span[:, None], ends, slopes)
    error_straight = np.abs(straight).mean(axis=0)
    used = np.abs(error_cubic).mean(axis=0) < MAX_ERROR_RATIO * error_straight
    # Of a parabola, the error over one interval is a quarter of that over two.
    needed = np.quantile(np.abs(straight), QUANTILE, axis=0) / 4
    coarse = needed > LIMIT
    unused = tuple(np.flatnonzero(coarse & ~used & derivatives.any(axis=0)).tolist())
    parts = int(np.ceil(np.sqrt(np.max(needed / LIMIT, where=used, initial=0.0))))
    parts = min(parts, MAX_PARTS)
    if parts <= 1:
        return DenseStates(time, states, unused=unused)
    # Of a polynomial of fourth degree, a sixteenth: the excluded states measure the error.
    off = np.zeros_like(states)
    off[inner] = error_cubic / 16 * used
    return _insert_parts(time, states, derivatives, bridged, used, off, parts, unused)


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
    return DenseStates(times, dense, error, unused, parts)


def hermite_cubic(
    u: Array, span: Array, ends: tuple[Array, Array], slopes: tuple[Array, Array]
) -> Array:
    """Cubic through two states with their derivatives.

    Parameters
    ----------
    u : ndarray of shape (n, 1)
        Where between the two, 0 to 1.
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

    Titterton and Weston (2004), 3.6.3; of roll positive starboard down, pitch positive bow up.

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
