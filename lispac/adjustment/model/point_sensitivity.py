"""Derivatives of a georeferenced point by all quantities that it depends on.

The derivatives are those of the adjustment: a plane through the point, whose normal is the
given direction, has the point's move along it as its misclosure.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.condition_equations import CALIBRATION, POSE, linearise
from lispac.adjustment.model.observations import Observations, Sighting
from lispac.survey.georeferencing import Mounting
from lispac.survey.trajectory import Poses

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Sensitivity:
    """Derivatives of the positions of points along one direction each.

    Attributes
    ----------
    by_mounting : ndarray of shape (n, 9), metres per radian, metre, second
        By the values of the mounting, in the order of `Mounting.values`; by the latency only where
        the pose's rate was given.
    by_position : ndarray of shape (n, 3), no unit
        By north, west, up.
    by_attitude : ndarray of shape (n, 3), metres per radian
        By roll, pitch, heading of the POS.
    by_lidar : ndarray of shape (n, 3), no unit
        By the LiDAR's x, y, z.
    """

    by_mounting: Array
    by_position: Array
    by_attitude: Array
    by_lidar: Array


def sensitivity(
    points_lidar: Array,
    poses: Poses,
    mounting: Mounting,
    directions_local: Array,
    *,
    pose_rate: Array | None = None,
) -> Sensitivity:
    """Derivatives of georeferenced points.

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    poses : Poses
        Of the POS when they were measured, n of them.
    directions_local : ndarray of shape (n, 3), unit vectors, local frame
        Along which the move of each point is computed.
    pose_rate : ndarray of shape (n, 6), metres and radians per second, optional
    """
    n = len(points_lidar)
    nothing = np.zeros((n, 3))
    rows = linearise(
        Observations(
            points_lidar=np.ascontiguousarray(points_lidar, dtype=np.float64),
            position=np.ascontiguousarray(poses.position),
            attitude=np.ascontiguousarray(poses.attitude),
            sigma_lidar=nothing,
            sigma_position=nothing,
            sigma_attitude=nothing,
            time=np.zeros(n),
            sighting=np.arange(n),
            sightings=tuple(Sighting(str(k), "") for k in range(n)),
            pose_rate=pose_rate,
            latency=mounting.latency,
        ),
        mounting,
        np.column_stack([directions_local, np.zeros(n)]),
    )
    poses_moved = rows.rows[:, POSE]
    return Sensitivity(
        rows.rows[:, CALIBRATION], poses_moved[:, :3], poses_moved[:, 3:], rows.by_lidar
    )
