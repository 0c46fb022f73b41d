"""Trajectory: position and attitude of the POS, and their accuracy."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.geometry.frames import LocalFrame
from lispac.geometry.rotations import rotation_angles, rotation_matrix
from lispac.messages import Level, Message, error
from lispac.survey.state_densification import insert_states

Array = NDArray[np.float64]

DEFAULT_LONGEST_GAP_S = 1.5
"""Default for the longest interval between two states over which positions are interpolated; text
exports have states at 1 Hz."""
RATE_CONVERSION_STEP_S = 1e-4
"""Time step for the conversion of angular rates to another frame."""
STATE_COMPONENTS = ("north", "west", "up", "roll", "pitch", "heading")
"""Names of the components of a state in a local frame."""
MAX_PITCH_RAD = float(np.radians(80.0))
"""Pitch beyond which roll and heading change too fast for interpolation; at 90 deg they are not
separable."""


@dataclass(frozen=True, eq=False)
class Trajectory:
    """POS states in geographic coordinates, attitude in the program's convention.

    Attributes
    ----------
    time : ndarray of shape (n,), seconds, strictly increasing
    latitude : ndarray of shape (n,), radians
    longitude : ndarray of shape (n,), radians
        Without jumps by 2 pi and with a mean between -pi and pi; values of a trajectory across the
        antimeridian may exceed these limits.
    height : ndarray of shape (n,), metres above the ellipsoid
    attitude : ndarray of shape (n, 3), radians
        Roll, pitch (positive bow down), heading (clockwise from true north at the vessel).
    assumptions : tuple of Message
        Assumptions of the reader.
    messages : tuple of Message
        Warnings and notes about the states.
    velocity : ndarray of shape (n, 3), metres a second, or None
        Towards north, west, up, if the file contains it.
    attitude_rate : ndarray of shape (n, 3), radians a second, or None
        Derivatives of ``attitude``, if the file contains angular rates.
    """

    time: Array
    latitude: Array
    longitude: Array
    height: Array
    attitude: Array
    assumptions: tuple[Message, ...] = ()
    messages: tuple[Message, ...] = ()
    velocity: Array | None = None
    attitude_rate: Array | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "longitude", continuous_longitude(self.longitude))

    @property
    def longitude_within_half_turn(self) -> Array:
        """Longitudes from -pi to pi, shape (n,), radians, as in files."""
        turns = np.round(self.longitude / (2 * np.pi))
        return np.asarray(self.longitude - 2 * np.pi * turns)

    def with_positions_only(self) -> "Trajectory":
        """Trajectory without states that have no position, whose latitude and longitude are 0.

        Raises
        ------
        InputError
            If no state has a position.
        """
        placed = (self.latitude != 0) | (self.longitude_within_half_turn != 0)
        if placed.all():
            return self
        count = int(np.count_nonzero(~placed))
        if count == len(placed):
            raise InputError(error("survey.trajectory_without_position"))
        return replace(
            self, time=self.time[placed], latitude=self.latitude[placed],
            longitude=self.longitude[placed], height=self.height[placed],
            attitude=self.attitude[placed],
            velocity=None if self.velocity is None else self.velocity[placed],
            attitude_rate=None if self.attitude_rate is None else self.attitude_rate[placed],
            messages=(
                *self.messages, Message("trajectory.no_position", Level.NOTE, {"count": count})
            ),
        )  # fmt: skip

    def corrected(self, corrections: Array, frame: LocalFrame) -> "Trajectory":
        """Trajectory with corrections of position and attitude in a local frame.

        States without corrections are unchanged to the last digit, and so are velocities and rates.

        Parameters
        ----------
        corrections : ndarray of shape (n, 6), metres and radians
            Added to north, west, up, roll, pitch and heading in the local frame.
        frame : LocalFrame
        """
        own = corrections.any(axis=1)
        if not own.any():
            return self
        place = self.latitude[own], self.longitude[own], self.height[own]
        rotation = frame.rotation_local_level(*place[:2])
        attitude = rotation_angles(rotation @ rotation_matrix(*self.attitude[own].T))
        moved = frame.to_geodetic(frame.to_local(*place) + corrections[own, :3])
        turned = np.swapaxes(frame.rotation_local_level(*moved[:2]), -1, -2) @ rotation_matrix(
            *(attitude + corrections[own, 3:]).T
        )
        latitude, longitude, height, attitudes = (
            np.array(each) for each in (self.latitude, self.longitude, self.height, self.attitude)
        )
        latitude[own], height[own] = moved[0], moved[2]
        longitude[own] = _turned_near(moved[1], longitude[own])
        attitudes[own] = _turned_near(rotation_angles(turned), attitudes[own])
        return replace(
            self, latitude=latitude, longitude=longitude, height=height, attitude=attitudes
        )

    def mean_frame(self) -> LocalFrame:
        """Local frame at the mean of the trajectory (thesis equation 1.5)."""
        return LocalFrame(
            float(self.latitude.mean()), float(self.longitude.mean()), float(self.height.mean())
        )


def _turned_near(angles: Array, near: Array) -> Array:
    """Angles plus multiples of 2 pi, so that they differ by at most pi from ``near``, radians."""
    return near + (np.remainder(angles - near + np.pi, 2 * np.pi) - np.pi)


def continuous_longitude(longitude: Array) -> Array:
    """Longitudes without jumps by 2 pi, with their mean between -pi and pi, shape (n,), radians.

    Parameters
    ----------
    longitude : ndarray of shape (n,), radians
        From -pi to pi or from 0 to 2 pi, in order along a path.
    """
    unwrapped = np.unwrap(longitude)
    turns = np.round(np.mean(unwrapped) / (2 * np.pi)) if len(unwrapped) else 0.0
    return np.asarray(unwrapped - 2 * np.pi * turns if turns else unwrapped)


@dataclass(frozen=True, eq=False)
class TrajectoryAccuracy:
    """Standard deviations of the POS over time.

    Attributes
    ----------
    time : ndarray of shape (n,), seconds, strictly increasing
    position : ndarray of shape (n, 3), metres; north, east, down
    attitude : ndarray of shape (n, 3), radians; roll, pitch, heading
    """

    time: Array
    position: Array
    attitude: Array

    @classmethod
    def constant(cls, position: Array, attitude: Array) -> "TrajectoryAccuracy":
        """Accuracy with the same sigmas at all times.

        Parameters
        ----------
        position : ndarray of shape (3,), metres
            North, east, down.
        attitude : ndarray of shape (3,), radians
            Roll, pitch, heading.
        """
        return cls(np.zeros(1), np.atleast_2d(position), np.atleast_2d(attitude))

    def at(self, time: Array) -> tuple[Array, Array]:
        """Position (metres) and attitude (radians) sigmas, each of shape (n, 3), at ``time``.

        Parameters
        ----------
        time : ndarray of shape (n,), seconds
        """
        return interpolate(time, self.time, self.position), interpolate(
            time, self.time, self.attitude
        )


@dataclass(frozen=True, eq=False)
class Poses:
    """POS states at chosen times, in the local frame.

    Attributes
    ----------
    position : ndarray of shape (n, 3), metres, local
    attitude : ndarray of shape (n, 3), radians; roll, pitch, heading against the local frame
    """

    position: Array
    attitude: Array


@dataclass(frozen=True, eq=False)
class LocalTrajectory:
    """Trajectory in a local frame, prepared for interpolation.

    Attributes
    ----------
    frame : LocalFrame
    time : ndarray of shape (n,), seconds, strictly increasing
    position : ndarray of shape (n, 3), metres, local
    attitude : ndarray of shape (n, 3), radians
        Roll, pitch, heading relative to the axes of the local frame, without jumps by 2 pi.
    longest_gap : float, seconds
        Longest interval between two states over which positions are interpolated.
    messages : tuple of Message
        Warnings and notes about the states.
    curve_error : ndarray of shape (n - 1, 6), metres and radians, or None
        Estimated error of the states that were inserted between those of the file.
    parts : int
        Number of intervals into which each interval of the file was divided.
    given : ndarray of shape (m,), int, or None
        Indices of the states of the file; None if no states were inserted.
    """

    frame: LocalFrame
    time: Array
    position: Array
    attitude: Array
    longest_gap: float = DEFAULT_LONGEST_GAP_S
    messages: tuple[Message, ...] = ()
    curve_error: Array | None = None
    parts: int = 1
    given: NDArray[np.int64] | None = None

    @classmethod
    def of(
        cls, trajectory: Trajectory, frame: LocalFrame, longest_gap: float = DEFAULT_LONGEST_GAP_S
    ) -> "LocalTrajectory":
        """Convert positions and attitudes of a trajectory to a local frame.

        If the trajectory has velocities and angular rates, and linear interpolation between its
        states is too coarse for the motion, states are inserted (`insert_states`).

        Raises
        ------
        InputError
            If the pitch exceeds `MAX_PITCH_RAD` in more than half of the states.
        """
        position = frame.to_local(trajectory.latitude, trajectory.longitude, trajectory.height)
        rotation_level_body = rotation_matrix(*trajectory.attitude.T)
        rotation_local_level = frame.rotation_local_level(trajectory.latitude, trajectory.longitude)
        attitude = rotation_angles(rotation_local_level @ rotation_level_body)
        if (np.abs(attitude[:, 1]) > MAX_PITCH_RAD).mean() > 0.5:
            raise InputError(error("survey.trajectory_steep", limit=float(MAX_PITCH_RAD)))
        attitude = np.unwrap(attitude, axis=0)
        if trajectory.velocity is None and trajectory.attitude_rate is None:
            return cls(frame, trajectory.time, position, attitude, longest_gap, trajectory.messages)

        def find_derivatives() -> Array:
            return _derivatives(trajectory, rotation_local_level, attitude)

        states = np.hstack([position, attitude])
        dense = insert_states(trajectory.time, states, find_derivatives, longest_gap)
        messages = trajectory.messages
        if dense.unused:
            names = tuple(STATE_COMPONENTS[k] for k in dense.unused)
            messages += (Message("trajectory.rates_not_used", Level.NOTE, {"names": names}),)
        return cls(
            frame, dense.time, dense.states[:, :3], dense.states[:, 3:], longest_gap, messages,
            dense.error, dense.parts, dense.given,
        )  # fmt: skip

    def corrected(self, corrections: Array) -> "LocalTrajectory":
        """Trajectory with corrections of its states.

        Parameters
        ----------
        corrections : ndarray of shape (n, 6), metres and radians
            Added to north, west, up, roll, pitch and heading.
        """
        return replace(
            self,
            position=self.position + corrections[:, :3],
            attitude=self.attitude + corrections[:, 3:],
        )

    @cached_property
    def knots(self) -> tuple[Array, Array]:
        """Times (n,), and positions and attitudes in one array (n, 6), for compiled functions.

        They are computed once, since all lines and mountings use them.
        """
        return (
            np.ascontiguousarray(self.time, dtype=np.float64),
            np.ascontiguousarray(np.hstack([self.position, self.attitude])),
        )

    @cached_property
    def has_gaps(self) -> bool:
        """Whether there are intervals in which positions are not interpolated."""
        return bool(self._gap_intervals.any())

    @cached_property
    def _gap_intervals(self) -> NDArray[np.bool_]:
        """Whether each interval between states is too long or has too steep a pitch, (n - 1,)."""
        steep = np.abs(self.attitude[:, 1]) > MAX_PITCH_RAD
        return np.asarray((np.diff(self.time) > self.longest_gap) | steep[:-1] | steep[1:])

    def covers(self, time: Array) -> NDArray[np.bool_]:
        """Whether each time has a pose: inside, not in a gap, and without a steep pitch.

        Parameters
        ----------
        time : ndarray of shape (n,), seconds

        Returns
        -------
        ndarray of shape (n,), bool
        """
        inside = (time >= self.time[0]) & (time <= self.time[-1])
        if self.has_gaps:
            last = len(self.time) - 2
            behind = np.searchsorted(self.time, time)
            out = np.flatnonzero(self._gap_intervals[np.clip(behind - 1, 0, last)])
            # At a state itself, only the interval after it has to be valid.
            at = np.minimum(behind[out], last)
            inside[out] &= (self.time[at] == time[out]) & ~self._gap_intervals[at]
        return np.asarray(inside)

    def rate_at(self, time: Array) -> Array:
        """Time derivative of position and attitude, shape (n, 6), metres and radians per second.

        ``time`` has to lie inside the trajectory, as for `at`.
        """
        states = np.hstack([self.position, self.attitude])
        return interpolate(time, self.time, np.gradient(states, self.time, axis=0))

    def at(self, time: Array) -> Poses:
        """Linear interpolation to ``time`` (thesis B.1).

        Parameters
        ----------
        time : ndarray of shape (n,), seconds

        Raises
        ------
        InputError
            If the earliest or the latest time has no pose, see `covers`.
        """
        if len(time) and not self.covers(np.array([np.min(time), np.max(time)])).all():
            raise InputError(outside_trajectory_message(time, self.time))
        return Poses(
            interpolate(time, self.time, self.position),
            interpolate(time, self.time, self.attitude),
        )


def _derivatives(trajectory: Trajectory, rotation_local_level: Array, attitude: Array) -> Array:
    """Derivatives of position and attitude in a local frame, shape (n, 6), by time.

    Parameters
    ----------
    rotation_local_level : ndarray of shape (n, 3, 3)
    attitude : ndarray of shape (n, 3), radians
        Attitude in the local frame.

    Returns
    -------
    ndarray of shape (n, 6), metres and radians a second
        Zeros for what the trajectory does not contain.
    """
    derivatives = np.zeros((len(attitude), 6))
    if trajectory.velocity is not None:
        velocity = trajectory.velocity[:, :, None]
        derivatives[:, :3] = (rotation_local_level @ velocity)[:, :, 0]
    if trajectory.attitude_rate is not None:
        ahead = rotation_matrix(
            *(trajectory.attitude + RATE_CONVERSION_STEP_S * trajectory.attitude_rate).T
        )
        turned = rotation_angles(rotation_local_level @ ahead) - attitude
        derivatives[:, 3:] = (
            np.remainder(turned + np.pi, 2 * np.pi) - np.pi
        ) / RATE_CONVERSION_STEP_S
    return derivatives


def interpolate(time: Array, known_time: Array, values: Array) -> Array:
    """Linear interpolation of columns, shape (n, k), with the end values outside.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds
    known_time : ndarray of shape (m,), seconds, increasing
    values : ndarray of shape (m, k)
        Values at the known times.
    """
    if len(time) and len(known_time) > 2:  # of long trajectories, most times need a small part
        first, last = np.searchsorted(known_time, [np.min(time), np.max(time)])
        part = slice(max(int(first) - 1, 0), int(last) + 2)
        known_time, values = known_time[part], values[part]
    return np.stack([np.interp(time, known_time, column) for column in values.T], axis=-1)


def outside_trajectory_message(time: Array, known: Array) -> Message:
    """Message that points lie outside the time span of the trajectory.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds
        Times of the points.
    known : ndarray of shape (m,), seconds, increasing
        Times of the states.
    """
    return error(
        "survey.outside_trajectory",
        first=float(np.min(time)),
        last=float(np.max(time)),
        start=float(known[0]),
        end=float(known[-1]),
    )
