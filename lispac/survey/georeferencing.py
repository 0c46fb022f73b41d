"""Direct georeferencing: LiDAR frame to body frame to local frame (thesis equation 1.1)."""

import os
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass

import numpy as np
from numba import njit
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.geometry.rotations import rotation_matrix
from lispac.progress import Progress, no_progress
from lispac.survey.trajectory import LocalTrajectory, Poses

Array = NDArray[np.float64]

CHUNK = 1 << 19  # points per kernel call: progress and cancel about every 20 ms


@dataclass(frozen=True, eq=False)
class Mounting:
    """How the LiDAR sits in the body frame.

    Attributes
    ----------
    lever_arm : ndarray of shape (3,), metres, body
        Optical centre of the LiDAR seen from the POS.
    boresight : ndarray of shape (3,), radians
        Roll, pitch, yaw of the LiDAR frame in the body frame.
    """

    lever_arm: Array
    boresight: Array

    @property
    def rotation_body_lidar(self) -> Array:
        """Rotation matrix from the LiDAR to the body frame, shape (3, 3)."""
        return rotation_matrix(*self.boresight)

    def with_boresight(self, boresight: Array) -> "Mounting":
        """The same lever arm with another boresight."""
        return Mounting(self.lever_arm, np.asarray(boresight, dtype=float))


def place(points_lidar: Array, poses: Poses, mounting: Mounting) -> Array:
    """Georeference points whose POS states are known one by one: the reference formula.

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    poses : Poses of n points

    Returns
    -------
    ndarray of shape (n, 3), metres, local frame
    """
    points_body = points_lidar @ mounting.rotation_body_lidar.T + mounting.lever_arm
    rotation_local_body = rotation_matrix(*poses.attitude.T)
    return poses.position + np.einsum("nij,nj->ni", rotation_local_body, points_body)


def to_lidar(points_local: Array, poses: Poses, mounting: Mounting) -> Array:
    """The exact inverse of `place`: local frame back to the LiDAR frame, shape (n, 3), metres."""
    rotation_local_body = rotation_matrix(*poses.attitude.T)
    points_body = np.einsum("nji,nj->ni", rotation_local_body, points_local - poses.position)
    return (points_body - mounting.lever_arm) @ mounting.rotation_body_lidar


def georeference(
    points_lidar: Array,
    time: Array,
    trajectory: LocalTrajectory,
    mounting: Mounting,
    *,
    progress: Progress = no_progress,
) -> Array:
    """Interpolate the trajectory and georeference in one pass over the points.

    Same numbers as ``place(points_lidar, trajectory.at(time), mounting)`` to rounding, without
    its temporaries, on all cores.

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
        Where a time lies outside the trajectory.
    """
    points_lidar = np.ascontiguousarray(points_lidar, dtype=np.float64)
    time = np.ascontiguousarray(time, dtype=np.float64)
    points_local = np.empty_like(points_lidar)
    states = np.ascontiguousarray(np.hstack([trajectory.position, trajectory.attitude]))
    knots = np.ascontiguousarray(trajectory.time)
    rotation, lever_arm = mounting.rotation_body_lidar, np.asarray(mounting.lever_arm, dtype=float)

    def run(start: int) -> bool:
        chunk = slice(start, start + CHUNK)
        return bool(
            _georeference(
                points_lidar[chunk], time[chunk], knots, states, rotation, lever_arm,
                points_local[chunk],
            )
        )  # fmt: skip

    starts = range(0, len(time), CHUNK)
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for done, inside in enumerate(pool.map(run, starts)):
            if not inside:
                pool.shutdown(cancel_futures=True)
                raise InputError(
                    f"Points from {np.min(time):.3f} to {np.max(time):.3f} s lie outside the "
                    f"trajectory ({knots[0]:.3f} to {knots[-1]:.3f} s): "
                    "check that both use the same time base."
                )
            progress((done + 1) / len(starts))
    return points_local


@njit(nogil=True, cache=True)
def _georeference(points_lidar, time, knots, states, rotation, lever_arm, points_local):  # type: ignore[no-untyped-def]
    last = len(knots) - 2
    k = 0
    for i in range(len(time)):
        t = time[i]
        if not (knots[0] <= t <= knots[-1]):
            return False
        # Times mostly increase, so the interval of the last point or the next one holds; a
        # jump is found by bisection.
        if not (knots[k] <= t <= knots[k + 1]):
            if k < last and knots[k + 1] <= t <= knots[k + 2]:
                k += 1
            else:
                k = min(max(np.searchsorted(knots, t) - 1, 0), last)
        u = (t - knots[k]) / (knots[k + 1] - knots[k])
        low, high = states[k], states[k + 1]
        roll = low[3] + u * (high[3] - low[3])
        pitch = low[4] + u * (high[4] - low[4])
        heading = low[5] + u * (high[5] - low[5])
        x, y, z = points_lidar[i, 0], points_lidar[i, 1], points_lidar[i, 2]
        bx = rotation[0, 0] * x + rotation[0, 1] * y + rotation[0, 2] * z + lever_arm[0]
        by = rotation[1, 0] * x + rotation[1, 1] * y + rotation[1, 2] * z + lever_arm[1]
        bz = rotation[2, 0] * x + rotation[2, 1] * y + rotation[2, 2] * z + lever_arm[2]
        # Rx(roll), Ry(pitch), Rz(-heading), one after the other
        c, s = np.cos(roll), np.sin(roll)
        by, bz = c * by - s * bz, s * by + c * bz
        c, s = np.cos(pitch), np.sin(pitch)
        bx, bz = c * bx + s * bz, -s * bx + c * bz
        c, s = np.cos(heading), np.sin(heading)
        bx, by = c * bx + s * by, -s * bx + c * by
        points_local[i, 0] = low[0] + u * (high[0] - low[0]) + bx
        points_local[i, 1] = low[1] + u * (high[1] - low[1]) + by
        points_local[i, 2] = low[2] + u * (high[2] - low[2]) + bz
    return True
