"""Choose few patches that determine the three angles nearly as well as all.

One patch after another is taken, always the one that leaves the angles with the smallest
uncertainty (the determinant of their covariance: D-optimal, Wald 1943), where each line has a POS
error of its own: a second patch that faces the same way on the same lines then adds little.
Limits prevent a single wall, or a single moment of a line, from dominating.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.natural.patches import Patches
from lispac.survey.cloud import Cloud
from lispac.survey.georeferencing import place_points, to_lidar
from lispac.survey.trajectory import Poses, TrajectoryAccuracy

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

PATCH_COUNT = 30
"""Patches that are chosen where there are so many: ten more lower the sigmas by an eighth at most,
as what is left is the POS error, and take half as long again."""
MAX_LINES = 4
"""Sightings of a patch, on the most informative lines; a fifth would be redundant."""
MAX_CANDIDATES = 2_500
"""Patches that are judged, spread evenly over all there are."""
PRIOR_SIGMA = np.radians(3.0)
"""Sigma of the angles before the first patch."""
STEP = 1e-4
"""Radians by which angles are turned to compute how a point moves."""
FLOOR, ROUGHNESS = 0.003, 0.3
"""Common error of a sighting of a patch: metres, and a share of its roughness."""
DIRECTION_CAP, TIME_CAP = 3.0, 3.0
"""Most patches that face one way, and sightings of one moment of a line: times their fair share."""
MOMENT = 3.0
"""Seconds."""


@dataclass(frozen=True, eq=False)
class PatchChoice:
    """The chosen patches.

    Attributes
    ----------
    rows : list of ndarray of shape (sightings,), int
        Of each, among the planes of the patches.
    sigma : ndarray of shape (3,), radians
        Predicted for roll, pitch and yaw.
    """

    rows: list[Indices]
    sigma: Array


@dataclass(frozen=True, eq=False)
class _PatchInformation:
    """Information that each sighting of a patch gives on the angles.

    Attributes
    ----------
    rows : ndarray of shape (patches, MOST_LINES, 3 + 6 lines)
        Weighted derivatives of a sighting's offset by the angles and the POS error of each line,
        each over its sigma, with the free plane eliminated; zero where a patch has no more lines.
    sighting : ndarray of shape (patches, MOST_LINES), int
        Row among the planes, -1 for none.
    """

    rows: Array
    sighting: Indices


def choose_patches(
    patches: Patches,
    clouds: Mapping[str, Cloud],
    accuracy: TrajectoryAccuracy,
    count: int = PATCH_COUNT,
) -> PatchChoice:
    """Choose patches.

    Parameters
    ----------
    clouds : mapping of line name to Cloud
        Those the patches are of.
    accuracy : TrajectoryAccuracy
    count : int
        Most of them.
    """
    if not len(patches):
        return PatchChoice([], np.full(3, PRIOR_SIGMA))
    number = np.unique(np.linspace(0, len(patches) - 1, MAX_CANDIDATES).astype(np.int64))
    information = _patch_information(patches, number, clouds, accuracy)
    facing = _nearest_direction(patches.normal[number])
    moment = np.floor(patches.planes.time / MOMENT).astype(np.int64) * len(clouds)
    moment = np.unique(moment + patches.planes.line, return_inverse=True)[1].reshape(-1)
    of_direction = np.zeros(int(facing.max()) + 1, dtype=np.int64)
    of_moment = np.zeros(int(moment.max()) + 1, dtype=np.int64)
    max_facing = max(4.0, DIRECTION_CAP * count / len(np.unique(facing)))
    max_at_once = max(4.0, TIME_CAP * count * 3 / len(of_moment))
    moments = np.where(information.sighting >= 0, moment[information.sighting], -1)
    open_ = np.ones(len(number), dtype=bool)
    covariance = np.eye(information.rows.shape[2])
    picked: list[Indices] = []
    while len(picked) < count:
        full = np.append(of_moment >= max_at_once, False)
        free = open_ & (of_direction[facing] < max_facing) & ~full[moments].any(axis=1)
        # First one of each direction: where the greedy way alone has a single one in mind, nothing
        # would separate an error of the position from one of the angles.
        unserved = free & (of_direction[facing] == 0)
        some = np.flatnonzero(unserved if unserved.any() else free)
        if not len(some):
            break
        best = some[int(np.argmax(_information_gain(information.rows[some], covariance)))]
        open_[best] = False
        of_direction[facing[best]] += 1
        own = information.sighting[best][information.sighting[best] >= 0]
        of_moment[moment[own]] += 1
        rows = information.rows[best]
        crossed = rows @ covariance
        inner = np.eye(len(rows)) + crossed @ rows.T
        covariance = covariance - crossed.T @ np.linalg.solve(inner, crossed)
        picked.append(np.sort(own))
    return PatchChoice(picked, PRIOR_SIGMA * np.sqrt(np.diag(covariance)[:3]))


def _information_gain(rows: Array, covariance: Array) -> Array:
    """Decrease of the log determinant by each patch, shape (patches,)."""
    crossed = rows @ covariance
    inner = np.eye(rows.shape[1]) + crossed @ np.swapaxes(rows, 1, 2)
    angles = crossed[:, :, :3]
    less = np.swapaxes(angles, 1, 2) @ np.linalg.solve(inner, angles)
    left = np.linalg.det(covariance[:3, :3] - less)
    return np.asarray(-np.log(np.maximum(left, np.finfo(float).tiny)))


def _patch_information(
    patches: Patches, number: Indices, clouds: Mapping[str, Cloud], accuracy: TrajectoryAccuracy
) -> _PatchInformation:
    planes, position = patches.planes, np.full(len(patches), -1)
    position[number] = np.arange(len(number))
    rows = np.flatnonzero(position[patches.patch] >= 0)
    owner = position[patches.patch[rows]]
    derivative = _sighting_derivatives(patches, rows, clouds, accuracy)
    off = np.hypot(FLOOR, ROUGHNESS * planes.rough[rows])
    # Of many lines, the most displaced are the most informative: farthest from the mean first.
    lines, total = len(clouds), np.bincount(owner, minlength=len(number))
    mean = np.stack([np.bincount(owner, c, len(number)) for c in derivative[:, :3].T], axis=1)
    displacement = np.linalg.norm(derivative[:, :3] - (mean / total[:, None])[owner], axis=1) / off
    order = np.lexsort((-displacement, owner))
    rank = np.arange(len(order)) - (np.cumsum(total) - total)[owner[order]]
    order, rank = order[rank < MAX_LINES], rank[rank < MAX_LINES]
    wide = 3 + 6 * lines
    table = np.zeros((len(number), MAX_LINES, wide))
    weight = np.zeros((len(number), MAX_LINES))
    sighting = np.full((len(number), MAX_LINES), -1, dtype=np.int64)
    table[owner[order], rank, :3] = derivative[order, :3]
    columns = 3 + 6 * planes.line[rows[order]][:, None] + np.arange(6)
    table[owner[order][:, None], rank[:, None], columns] = derivative[order, 3:]
    weight[owner[order], rank] = off[order] ** -2
    sighting[owner[order], rank] = rows[order]
    middle = (weight[:, :, None] * table).sum(axis=1) / weight.sum(axis=1)[:, None]
    return _PatchInformation(np.sqrt(weight)[:, :, None] * (table - middle[:, None]), sighting)


def _sighting_derivatives(
    patches: Patches, rows: Indices, clouds: Mapping[str, Cloud], accuracy: TrajectoryAccuracy
) -> Array:
    """Shift of sightings along their normal by a sigma of angles and POS error, (k, 9)."""
    where = next(iter(clouds.values())).place
    mounting, planes = where.mounting, patches.planes
    time, centre = planes.time[rows], planes.centre[rows]
    normal = patches.normal[patches.patch[rows]]
    poses = where.trajectory.at(time + mounting.latency)
    lidar = to_lidar(centre, poses, mounting)
    position, attitude = accuracy.at(time)
    found = np.empty((len(rows), 9))
    for k, axis in enumerate(np.eye(3)):
        turned = place_points(
            lidar, poses, mounting.with_boresight(mounting.boresight + STEP * axis)
        )
        found[:, k] = ((turned - centre) * normal).sum(axis=1) / STEP * PRIOR_SIGMA
        swayed = place_points(lidar, Poses(poses.position, poses.attitude + STEP * axis), mounting)
        moved = ((swayed - centre) * normal).sum(axis=1) / STEP
        found[:, 6 + k] = moved * attitude[:, k]
    found[:, 3:6] = normal * position
    return found


def _nearest_direction(normals: Array) -> Indices:
    """The nearest of thirteen directions: axes, edges and corners of a cube, shape (n,)."""
    axes = np.array(
        [
            (x, y, z)
            for x in (-1, 0, 1)
            for y in (-1, 0, 1)
            for z in (-1, 0, 1)
            if (x, y, z) > (0, 0, 0)
        ],
        dtype=float,
    )
    axes /= np.linalg.norm(axes, axis=1, keepdims=True)
    return np.asarray(np.abs(normals @ axes.T).argmax(axis=1), dtype=np.int64)
