"""Rotations in the angle convention of the program.

Frames are right-handed: the local frame is North-West-Up, the body frame forward-left-up.
Roll is positive port side up, pitch positive bow down, heading and yaw clockwise from above
(thesis equation 4.3; the printed factors of 4.2 contradict it and are wrong).
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def rotation_matrix(roll: float | Array, pitch: float | Array, yaw: float | Array) -> Array:
    """Rotation ``Rz(-yaw) Ry(pitch) Rx(roll)``: body to local, or LiDAR to body.

    Parameters
    ----------
    roll, pitch, yaw : float or ndarray of shape (...), radians

    Returns
    -------
    ndarray of shape (..., 3, 3)
    """
    cr, sr = np.cos(roll), np.sin(roll)
    cp, sp = np.cos(pitch), np.sin(pitch)
    cy, sy = np.cos(yaw), np.sin(yaw)
    # Each iteration needs a few matrices of single angles, for which `numpy.stack` is slow.
    rotation = np.empty((*np.broadcast(cr, cp, cy).shape, 3, 3))
    rotation[..., 0, 0] = cy * cp
    rotation[..., 0, 1] = cr * sy + cy * sp * sr
    rotation[..., 0, 2] = cy * cr * sp - sy * sr
    rotation[..., 1, 0] = -cp * sy
    rotation[..., 1, 1] = cy * cr - sy * sp * sr
    rotation[..., 1, 2] = -cy * sr - cr * sy * sp
    rotation[..., 2, 0] = -sp
    rotation[..., 2, 1] = cp * sr
    rotation[..., 2, 2] = cp * cr
    return rotation


MIN_PITCH_COSINE = 1e-12
"""Cosine of the pitch below which roll and yaw are not separable."""


def rotation_angles(rotation: Array) -> Array:
    """Roll, pitch and yaw of a rotation matrix; the inverse of `rotation_matrix`.

    Parameters
    ----------
    rotation : ndarray of shape (..., 3, 3)

    Returns
    -------
    ndarray of shape (..., 3), radians
        Roll and yaw in (-pi, pi], pitch in [-pi/2, pi/2]. At a pitch of 90 deg, where only the sum
        or the difference of roll and yaw is determined, the roll is 0.
    """
    roll = np.arctan2(rotation[..., 2, 1], rotation[..., 2, 2])
    level = np.hypot(rotation[..., 2, 1], rotation[..., 2, 2])
    pitch = np.arctan2(-rotation[..., 2, 0], level)
    yaw = np.arctan2(-rotation[..., 1, 0], rotation[..., 0, 0])
    singular = level < MIN_PITCH_COSINE
    if np.any(singular):
        roll = np.where(singular, 0.0, roll)
        yaw = np.where(singular, np.arctan2(rotation[..., 0, 1], rotation[..., 1, 1]), yaw)
    return np.stack([roll, pitch, yaw], axis=-1)


def rotation_derivatives(roll: float | Array, pitch: float | Array, yaw: float | Array) -> Array:
    """Partial derivatives of `rotation_matrix` by roll, pitch and yaw.

    Parameters
    ----------
    roll, pitch, yaw : float or ndarray of shape (...), radians

    Returns
    -------
    ndarray of shape (3, ..., 3, 3), per radian
    """
    rotation = rotation_matrix(roll, pitch, yaw)
    found = np.zeros((3, *rotation.shape))
    by_roll, by_pitch, by_yaw = found
    # By roll: R [e_x]x; by yaw: -[e_z]x R; by pitch: R Rx' [e_y]x Rx, whose inner part is a
    # turn about the axis Rx' e_y = (0, cos roll, -sin roll).
    by_roll[..., 1] = rotation[..., 2]
    by_roll[..., 2] = -rotation[..., 1]
    cr, sr = np.cos(roll)[..., None], np.sin(roll)[..., None]
    by_pitch[..., 0] = -sr * rotation[..., 1] - cr * rotation[..., 2]
    by_pitch[..., 1] = sr * rotation[..., 0]
    by_pitch[..., 2] = cr * rotation[..., 0]
    by_yaw[..., 0, :] = rotation[..., 1, :]
    by_yaw[..., 1, :] = -rotation[..., 0, :]
    return found
