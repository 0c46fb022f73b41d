"""Direct georeferencing: LiDAR frame to body frame to local frame (thesis equation 1.1).

In addition to boresight and lever arm, the equation contains offsets that a calibration may
estimate: of the ranges, of the scan angle (thesis 3.4.2) and of the scanner's clock.
"""

import os
from collections.abc import Iterable
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from itertools import permutations, product
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.geometry.rotations import rotation_angles, rotation_derivatives, rotation_matrix
from lispac.progress import Progress, no_progress
from lispac.survey import kernels
from lispac.survey.trajectory import LocalTrajectory, Poses, outside_trajectory_message
from lispac.untrusted_values import ArrayShape

Array = NDArray[np.float64]

POINTS_PER_KERNEL_CALL = 1 << 16  # points per kernel call


LEVER_ARM_NAMES = ("lever_x", "lever_y", "lever_z")
"""Names of the components of the lever arm, metres: forward, left, up."""
MOUNTING_VALUE_NAMES = (
    "roll", "pitch", "yaw", "lever_x", "lever_y", "lever_z", "range_offset", "scan_angle_offset",
    "latency",
)  # fmt: skip
"""Names of the values of a `Mounting`, in the order of `Mounting.values`."""
STEEP_PITCH_RAD = float(np.radians(60.0))
"""Pitch of a boresight from which roll and yaw are hardly separable."""
RIGHT_ANGLE_ROTATIONS = tuple(
    np.array(rotation)
    for rotation in (
        np.eye(3)[list(order)] * np.array(signs)[:, None]
        for order in permutations(range(3))
        for signs in product((1.0, -1.0), repeat=3)
    )
    if np.linalg.det(rotation) > 0
)
"""The 24 rotations by right angles, each of shape (3, 3)."""


def is_steep(boresight: Array) -> bool:
    """Whether the pitch is so near ±90 deg that roll and yaw are hardly separable.

    Parameters
    ----------
    boresight : ndarray of shape (3,), radians; roll, pitch, yaw
    """
    return bool(abs(np.sin(boresight[1])) >= np.sin(STEEP_PITCH_RAD))


@dataclass(frozen=True, eq=False)
class Mounting:
    """Position and orientation of the LiDAR in the body frame, and corrections of its data.

    Attributes
    ----------
    lever_arm : ndarray of shape (3,), metres, body
        Position of the optical centre of the LiDAR relative to the POS.
    boresight : ndarray of shape (3,), radians
        Roll, pitch, yaw of the LiDAR frame in the body frame. If ``axes`` is given, it is applied
        to the LiDAR frame first.
    range_offset : float, metres
        Added to every range.
    scan_angle_offset : float, radians
        Rotation of every beam about the x axis of the LiDAR, the axis of a profiler's mirror.
    latency : float, seconds
        Added to the time of every point before the trajectory is interpolated.
    axes : ndarray of shape (3, 3) or None
        Rotation by multiples of 90 deg of the LiDAR axes, applied before the boresight. Roll and
        yaw are not separable at a pitch of 90 deg; with this rotation, the boresight stays small.
    """

    lever_arm: Annotated[Array, ArrayShape(3)]
    boresight: Annotated[Array, ArrayShape(3)]
    range_offset: float = 0.0
    scan_angle_offset: float = 0.0
    latency: float = 0.0
    axes: Annotated[Array, ArrayShape(3, 3)] | None = None

    @classmethod
    def with_nearest_axes(
        cls,
        lever_arm: Array,
        boresight: Array,
        range_offset: float = 0.0,
        scan_angle_offset: float = 0.0,
        latency: float = 0.0,
    ) -> "Mounting":
        """Mounting with separable boresight angles: its axes are rotated if the pitch is steep.

        Parameters
        ----------
        lever_arm : ndarray of shape (3,), metres, body
        boresight : ndarray of shape (3,), radians
            Roll, pitch, yaw of the LiDAR frame in the body frame, of any size.
        range_offset, scan_angle_offset, latency : metres, radians and seconds
        """
        mounting = cls(lever_arm, boresight, range_offset, scan_angle_offset, latency)
        rotation = mounting.rotation_body_lidar
        if not is_steep(mounting.boresight):
            return mounting
        axes = max(RIGHT_ANGLE_ROTATIONS, key=lambda each: float(np.trace(each.T @ rotation)))
        return replace(mounting, boresight=rotation_angles(rotation @ axes.T), axes=axes)

    @property
    def rotation_body_lidar(self) -> Array:
        """Rotation matrix from the LiDAR to the body frame, shape (3, 3)."""
        rotation = rotation_matrix(*self.boresight)
        return rotation if self.axes is None else rotation @ self.axes

    @property
    def rotation_derivatives(self) -> Array:
        """Derivatives of `rotation_body_lidar` by the boresight, shape (3, 3, 3), per radian."""
        derivatives = rotation_derivatives(*self.boresight)
        return derivatives if self.axes is None else derivatives @ self.axes

    @property
    def without_nominal_axes(self) -> "Mounting":
        """Mounting without rotated axes: its boresight is that of the whole rotation."""
        if self.axes is None:
            return self
        return replace(self, boresight=rotation_angles(self.rotation_body_lidar), axes=None)

    @property
    def values(self) -> Array:
        """Values in the order of `MOUNTING_VALUE_NAMES`, shape (9,), radians, metres, seconds."""
        others = (self.range_offset, self.scan_angle_offset, self.latency)
        return np.array([*self.boresight, *self.lever_arm, *others], dtype=float)

    def with_values(self, values: Array) -> "Mounting":
        """The same mounting with other values, shape (9,), in the order of `values`."""
        return replace(Mounting.of_values(values), axes=self.axes)

    @classmethod
    def of_values(cls, values: Array) -> "Mounting":
        """Mounting without rotated axes from its values, shape (9,), in the order of `values`."""
        range_offset, scan_angle_offset, latency = (float(value) for value in values[6:])
        lever_arm, boresight = values[3:6].copy(), values[:3].copy()
        return cls(lever_arm, boresight, range_offset, scan_angle_offset, latency)

    def with_boresight(self, boresight: Array) -> "Mounting":
        """The same mounting with another boresight, shape (3,), radians."""
        return replace(self, boresight=np.asarray(boresight, dtype=float))

    def corrected(self, points_lidar: Array) -> Array:
        """Points corrected for range and scan-angle offset, shape (n, 3), metres, LiDAR frame."""
        if self.range_offset == 0 and self.scan_angle_offset == 0:
            return points_lidar
        ranges = np.linalg.norm(points_lidar, axis=1, keepdims=True)
        return (points_lidar * (1 + self.range_offset / ranges)) @ self.scan_angle_rotation.T

    def raw_points(self, points_lidar: Array) -> Array:
        """Points without range and scan-angle offset, as the scanner measured them.

        The inverse of `corrected`.
        """
        if self.range_offset == 0 and self.scan_angle_offset == 0:
            return points_lidar
        ranges = np.linalg.norm(points_lidar, axis=1, keepdims=True)
        return (points_lidar * (1 - self.range_offset / ranges)) @ self.scan_angle_rotation

    @property
    def scan_angle_rotation(self) -> Array:
        """Rotation matrix of the scan-angle offset, shape (3, 3), no unit, LiDAR frame."""
        return rotation_matrix(self.scan_angle_offset, 0.0, 0.0)


def place_points(points_lidar: Array, poses: Poses, mounting: Mounting) -> Array:
    """Georeference points with known POS states: the reference implementation of the formula.

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    poses : Poses of n points
        At the times of the points plus the latency.

    Returns
    -------
    ndarray of shape (n, 3), metres, local frame
    """
    points_lidar = mounting.corrected(points_lidar)
    points_body = points_lidar @ mounting.rotation_body_lidar.T + mounting.lever_arm
    rotation_local_body = rotation_matrix(*poses.attitude.T)
    return poses.position + np.einsum("nij,nj->ni", rotation_local_body, points_body)


def to_lidar(points_local: Array, poses: Poses, mounting: Mounting) -> Array:
    """Transform points from the local to the LiDAR frame, shape (n, 3), metres."""
    rotation_local_body = rotation_matrix(*poses.attitude.T)
    points_body = np.einsum("nji,nj->ni", rotation_local_body, points_local - poses.position)
    return mounting.raw_points((points_body - mounting.lever_arm) @ mounting.rotation_body_lidar)


def directions_to_lidar(directions_local: Array, poses: Poses, mounting: Mounting) -> Array:
    """Rotate directions from the local frame to the frame of the raw LiDAR points.

    Parameters
    ----------
    directions_local : ndarray of shape (n, 3), vectors of length 1, no unit, local frame
    poses : Poses of n points

    Returns
    -------
    ndarray of shape (n, 3), vectors of length 1, no unit, LiDAR frame
    """
    rotation_local_body = rotation_matrix(*poses.attitude.T)
    directions_body = np.einsum("nji,nj->ni", rotation_local_body, directions_local)
    return np.asarray(directions_body @ mounting.rotation_body_lidar @ mounting.scan_angle_rotation)


def georeference(
    points_lidar: Array,
    time: Array,
    trajectory: LocalTrajectory,
    mounting: Mounting,
    *,
    progress: Progress = no_progress,
) -> Array:
    """Interpolate the trajectory and georeference points in one pass.

    The result is that of ``place_points(points_lidar, trajectory.at(time), mounting)`` except for
    rounding, but no temporary arrays are needed and all cores are used.

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    time : ndarray of shape (n,), seconds

    Returns
    -------
    ndarray of shape (n, 3), metres, local frame

    Raises
    ------
    InputError
        If a time lies outside the trajectory.
    """
    return Georeferencer.of(trajectory, mounting)(points_lidar, time, progress=progress)


@dataclass(frozen=True, eq=False)
class Georeferencer:
    """Georeferencing of several sets of points with prepared data of the trajectory.

    All cores are used for more than `POINTS_PER_KERNEL_CALL` points.
    """

    trajectory: LocalTrajectory
    mounting: Mounting
    _kernel_arguments: tuple[float, Array, Array, Array, Array]

    @classmethod
    def of(cls, trajectory: LocalTrajectory, mounting: Mounting) -> "Georeferencer":
        """Prepare the data of the trajectory."""
        return cls(trajectory, mounting, kernel_arguments(trajectory, mounting))

    def __call__(
        self, points_lidar: Array, time: Array, *, progress: Progress = no_progress
    ) -> Array:
        """Georeference points; see `georeference`."""
        corrected = self.mounting.corrected(points_lidar)
        points_lidar = np.ascontiguousarray(corrected, dtype=np.float64)
        time = np.ascontiguousarray(time, dtype=np.float64)
        points_local = np.empty_like(points_lidar)

        def run(start: int) -> bool:
            chunk = slice(start, start + POINTS_PER_KERNEL_CALL)
            return bool(
                kernels.georeference_in_place(
                    points_lidar[chunk], time[chunk], *self._kernel_arguments, points_local[chunk]
                )
            )

        starts = range(0, len(time), POINTS_PER_KERNEL_CALL)
        if len(starts) <= 1:
            sound: Iterable[bool] = map(run, starts)
            return self._require_all_inside(points_local, sound, time, len(starts), progress)
        with ThreadPoolExecutor(os.cpu_count()) as pool:
            try:
                sound = pool.map(run, starts)
                return self._require_all_inside(points_local, sound, time, len(starts), progress)
            finally:
                pool.shutdown(cancel_futures=True)

    def _require_all_inside(
        self,
        points_local: Array,
        sound: Iterable[bool],
        time: Array,
        chunks: int,
        progress: Progress,
    ) -> Array:
        for done, inside in enumerate(sound):
            if not inside:
                raise outside_trajectory_error(time + self.mounting.latency, self.trajectory)
            progress((done + 1) / chunks)
        return points_local

    def largest_displacement(self, other: Mounting, reach: float) -> float:
        """Upper bound of the displacement of a point by another mounting, metres.

        Parameters
        ----------
        reach : float, metres
            Distance of the farthest point from the scanner.
        """
        mounting = self.mounting
        ranges = abs(mounting.range_offset - other.range_offset)
        reach += abs(mounting.range_offset) + abs(other.range_offset)
        turn = mounting.rotation_body_lidar - other.rotation_body_lidar
        displacement = float(np.linalg.norm(turn, 2)) * reach + ranges
        displacement += abs(mounting.scan_angle_offset - other.scan_angle_offset) * reach
        displacement += float(np.linalg.norm(mounting.lever_arm - other.lever_arm))
        late = abs(mounting.latency - other.latency)
        if late:
            steps = np.diff(self.trajectory.time)[:, None]
            speed = np.linalg.norm(np.diff(self.trajectory.position, axis=0) / steps, axis=1).max()
            rate = np.abs(np.diff(self.trajectory.attitude, axis=0) / steps).sum(axis=1).max()
            arm = reach + float(np.linalg.norm(mounting.lever_arm))
            displacement += late * float(speed + rate * arm)
        return displacement


def kernel_arguments(
    trajectory: LocalTrajectory, mounting: Mounting
) -> tuple[float, Array, Array, Array, Array]:
    """Latency, knots, states, rotation and lever arm, as used by `lispac.survey.kernels`."""
    return (
        float(mounting.latency),
        *trajectory.knots,
        np.ascontiguousarray(mounting.rotation_body_lidar),
        np.asarray(mounting.lever_arm, dtype=float),
    )


def outside_trajectory_error(time: Array, trajectory: LocalTrajectory) -> InputError:
    """Error that times lie outside the trajectory.

    Parameters
    ----------
    time : ndarray of shape (n,), seconds
    """
    return InputError(outside_trajectory_message(time, trajectory.time))
