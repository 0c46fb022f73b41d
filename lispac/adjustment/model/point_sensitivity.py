"""Derivatives of a georeferenced point by all quantities that it depends on.

They are computed with the condition equations of the adjustment. The displacement of a point along
a direction is its misclosure from a plane with this direction as normal.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.condition_equations import MOUNTING_COLUMNS, POSE_COLUMNS, linearise
from lispac.adjustment.model.observations import Observations, Sighting
from lispac.survey.georeferencing import Mounting
from lispac.survey.trajectory import Poses

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Sensitivity:
    """Derivatives of the displacement of each point along a given direction.

    Attributes
    ----------
    by_mounting : ndarray of shape (n, 9), metres per radian, metre, second
        Derivatives by the values of the mounting, in the order of `Mounting.values`; that by the
        latency is zero if no pose rate was given.
    by_position : ndarray of shape (n, 3), no unit
        Derivatives by the position of the POS: north, west, up.
    by_attitude : ndarray of shape (n, 3), metres per radian
        Derivatives by roll, pitch and heading of the POS.
    by_lidar : ndarray of shape (n, 3), no unit
        Derivatives by x, y, z of the LiDAR.
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
    """Compute the derivatives of georeferenced points along given directions.

    Parameters
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    poses : Poses
        Pose of the POS at each of the n points.
    directions_local : ndarray of shape (n, 3), unit vectors, local frame
        Direction along which the displacement of each point is computed.
    pose_rate : ndarray of shape (n, 6), metres and radians per second, optional
    """
    n = len(points_lidar)
    no_sigma = np.zeros((n, 3))
    rows = linearise(
        Observations(
            points_lidar=np.ascontiguousarray(points_lidar, dtype=np.float64),
            position=np.ascontiguousarray(poses.position),
            attitude=np.ascontiguousarray(poses.attitude),
            sigma_lidar=no_sigma,
            sigma_position=no_sigma,
            sigma_attitude=no_sigma,
            time=np.zeros(n),
            sighting=np.arange(n),
            sightings=tuple(Sighting(str(k), "") for k in range(n)),
            pose_rate=pose_rate,
            latency=mounting.latency,
        ),
        mounting,
        np.column_stack([directions_local, np.zeros(n)]),
    )
    poses_moved = rows.rows[:, POSE_COLUMNS]
    return Sensitivity(
        rows.rows[:, MOUNTING_COLUMNS], poses_moved[:, :3], poses_moved[:, 3:], rows.by_lidar
    )
