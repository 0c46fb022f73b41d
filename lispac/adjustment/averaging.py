"""Fewer points that say the same: neighbours on a surface averaged into one.

Thinning by selection throws away what the points left out know, so that sigmas grow with the
distance. An average keeps it: its noise is smaller by the root of their number.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.observations import Observations
from lispac.adjustment.shapes import points_local
from lispac.adjustment.stochastic import KNOT_INTERVAL
from lispac.survey.georeferencing import Mounting, to_lidar
from lispac.survey.trajectory import Poses

Array = NDArray[np.float64]


def averaged(
    observations: Observations,
    mounting: Mounting,
    distance: float,
    *,
    longest: float = KNOT_INTERVAL,
) -> Observations:
    """Average the points of each sighting of a plane over squares of side ``distance``.

    The squares lie in the sighting's own plane: cubes would part the points by the sign of their
    noise where a plane runs along their border. Points of one square seen at different times have
    POS errors of their own, so averages reach over a short time only. The points of spheres stay
    as they are: the mean of a curved patch lies inside it.

    Parameters
    ----------
    mounting : Mounting
        Places the points; an average keeps its mean place exactly with it, and to second order in
        the change of the mounting with another one.
    distance : float, metres
        0 leaves all points as they are.
    longest : float, seconds
        Over which points are averaged: the knot interval of the POS error.
    """
    if distance <= 0:
        return observations
    points = points_local(observations, mounting)
    order, start = _cells(observations, points, distance, longest)
    counts = np.diff(np.append(start, len(order)))

    def mean(values: Array) -> Array:
        return np.asarray((np.add.reduceat(values[order], start, axis=0).T / counts).T)

    attitude = observations.attitude[order]
    # A heading that jumps by a full turn inside a cell
    first = np.repeat(attitude[start], counts, axis=0)
    attitude -= 2 * np.pi * np.round((attitude - first) / (2 * np.pi))
    poses = Poses(
        mean(observations.position),
        (np.add.reduceat(attitude, start, axis=0).T / counts).T,
    )
    late = poses
    rate = observations.pose_rate
    missing = mounting.latency - observations.latency
    if rate is not None:
        rate = mean(rate)
        late = Poses(
            poses.position + missing * rate[:, :3],
            poses.attitude + missing * rate[:, 3:],
        )
    return replace(
        observations,
        points_lidar=to_lidar(mean(points), late, mounting),
        position=poses.position,
        attitude=np.ascontiguousarray(poses.attitude),
        pose_rate=rate,
        sigma_lidar=np.sqrt(mean(observations.sigma_lidar**2) / counts[:, None]),
        sigma_position=mean(observations.sigma_position),
        sigma_attitude=mean(observations.sigma_attitude),
        time=mean(observations.time),
        sighting=observations.sighting[order[start]],
    )


def _cells(
    observations: Observations, points: Array, distance: float, longest: float
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """The points ordered by cell, and where each cell begins in that order."""
    across = np.empty((len(points), 2))
    for s in range(len(observations.sightings)):
        own = observations.sighting == s
        directions = np.linalg.eigh(np.cov((points[own] - points[own].mean(axis=0)).T))[1]
        across[own] = points[own] @ directions[:, 1:]
    grid = np.floor(across / distance).astype(np.int64)
    # A point of a sphere has a cell of its own.
    alone = observations.is_sphere[observations.target_of_sighting[observations.sighting]]
    grid[alone, 0] = np.arange(alone.sum())
    key = observations.sighting.astype(np.int64)
    for each in (*grid.T, np.floor(observations.time / longest).astype(np.int64)):
        # Joined one by one and renumbered, so that the numbers stay small.
        each = each - each.min()
        key = np.unique(key * (int(each.max()) + 1) + each, return_inverse=True)[1].reshape(-1)
    order = np.argsort(key, kind="stable")
    start = np.flatnonzero(np.diff(key[order], prepend=-1))
    return order, start
