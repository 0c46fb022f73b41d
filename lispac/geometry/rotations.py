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
    roll, pitch, yaw = np.broadcast_arrays(roll, pitch, yaw)
    cr, sr = np.cos(roll), np.sin(roll)
    cp, sp = np.cos(pitch), np.sin(pitch)
    cy, sy = np.cos(yaw), np.sin(yaw)
    rows = (
        (cy * cp, cr * sy + cy * sp * sr, cy * cr * sp - sy * sr),
        (-cp * sy, cy * cr - sy * sp * sr, -cy * sr - cr * sy * sp),
        (-sp, cp * sr, cp * cr),
    )
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


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
    roll, pitch, yaw = np.broadcast_arrays(roll, pitch, yaw)
    rotation = rotation_matrix(roll, pitch, yaw)
    # By roll: R [e_x]x; by yaw: -[e_z]x R; by pitch: R Rx' [e_y]x Rx, whose inner part is a
    # turn about the axis Rx' e_y = (0, cos roll, -sin roll).
    by_roll = np.stack(
        [np.zeros_like(rotation[..., 0]), rotation[..., 2], -rotation[..., 1]], axis=-1
    )
    cr, sr = np.cos(roll)[..., None], np.sin(roll)[..., None]
    by_pitch = np.stack(
        [
            -sr * rotation[..., 1] - cr * rotation[..., 2],
            sr * rotation[..., 0],
            cr * rotation[..., 0],
        ],
        axis=-1,
    )
    by_yaw = np.stack(
        [rotation[..., 1, :], -rotation[..., 0, :], np.zeros_like(rotation[..., 2, :])], axis=-2
    )
    return np.stack([by_roll, by_pitch, by_yaw])
