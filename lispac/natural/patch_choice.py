"""Choose a few patches that determine the three angles nearly as well as all patches.

The patches are chosen one by one. Each time, the patch is chosen that minimises the determinant of
the predicted covariance of the angles (D-optimality, Wald 1943). The prediction includes a POS
error for each line, so that a second patch with the same orientation on the same lines adds little.
The number of patches of one direction is limited, and so is the number of sightings in one time
interval of a line.
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

MAX_PATCHES = 30
"""Largest number of patches that are chosen.

Ten more reduce the sigmas by an eighth at most, because the POS errors remain, and increase the
computing time by half.
"""
MAX_SIGHTINGS_PER_PATCH = 4
"""Largest number of sightings of a patch; those of the most informative lines are used."""
MAX_CANDIDATES = 2_500
"""Largest number of patches that are compared, taken at equal intervals from all patches."""
PRIOR_ANGLE_SIGMA = np.radians(3.0)
"""Sigma of the angles before the first patch, radians."""
ANGLE_STEP = 1e-4
"""Step of the angles for numerical derivatives, radians."""
MIN_SIGHTING_ERROR, ROUGHNESS_SHARE = 0.003, 0.3
"""Error common to the points of a sighting: constant part, metres, and share of the roughness.

The two parts are combined as the root of the sum of their squares.
"""
MAX_DIRECTION_RATIO, MAX_INTERVAL_RATIO = 3.0, 3.0
"""Limits of the patches of one direction, and of the sightings in one time interval of a line.

As multiples of the number that an equal distribution would give, with three sightings for each
patch. Four are always allowed.
"""
TIME_INTERVAL = 3.0
"""Length of the intervals into which the time of a line is divided, seconds."""


@dataclass(frozen=True, eq=False)
class PatchChoice:
    """Chosen patches, and the precision predicted with them.

    Attributes
    ----------
    rows : list of ndarray of shape (sightings,), int
        Rows of the sightings of each chosen patch in `Patches.planes`.
    sigma : ndarray of shape (3,), radians
        Predicted sigmas of roll, pitch and yaw.
    """

    rows: list[Indices]
    sigma: Array


@dataclass(frozen=True, eq=False)
class _PatchInformation:
    """Linearised observations of each sighting of a patch.

    Attributes
    ----------
    rows : ndarray of shape (patches, MAX_LINES, 3 + 6 lines)
        Weighted derivatives of the offset of a sighting by the angles and by the POS errors of each
        line, in units of their sigmas. The unknown offset of the plane is eliminated. Unused rows
        of patches with fewer lines are zero.
    sighting : ndarray of shape (patches, MAX_LINES), int
        Row in `Patches.planes`, -1 for none.
    """

    rows: Array
    sighting: Indices


def choose_patches(
    patches: Patches,
    clouds: Mapping[str, Cloud],
    accuracy: TrajectoryAccuracy,
    count: int = MAX_PATCHES,
) -> PatchChoice:
    """Choose the patches that together determine the angles best.

    Parameters
    ----------
    clouds : mapping of line name to Cloud
        Lines in which the patches were found.
    accuracy : TrajectoryAccuracy
    count : int
        Largest number of patches.
    """
    if not len(patches):
        return PatchChoice([], np.full(3, PRIOR_ANGLE_SIGMA))
    number = np.unique(np.linspace(0, len(patches) - 1, MAX_CANDIDATES).astype(np.int64))
    information = _patch_information(patches, number, clouds, accuracy)
    direction = _nearest_direction(patches.normal[number])
    interval = np.floor(patches.planes.time / TIME_INTERVAL).astype(np.int64) * len(clouds)
    interval = np.unique(interval + patches.planes.line, return_inverse=True)[1].reshape(-1)
    chosen_in_direction = np.zeros(int(direction.max()) + 1, dtype=np.int64)
    chosen_in_interval = np.zeros(int(interval.max()) + 1, dtype=np.int64)
    max_per_direction = max(4.0, MAX_DIRECTION_RATIO * count / len(np.unique(direction)))
    max_per_interval = max(4.0, MAX_INTERVAL_RATIO * count * 3 / len(chosen_in_interval))
    intervals = np.where(information.sighting >= 0, interval[information.sighting], -1)
    available = np.ones(len(number), dtype=bool)
    covariance = np.eye(information.rows.shape[2])
    picked: list[Indices] = []
    while len(picked) < count:
        full = np.append(chosen_in_interval >= max_per_interval, False)
        allowed = (
            available
            & (chosen_in_direction[direction] < max_per_direction)
            & ~full[intervals].any(axis=1)
        )
        # One patch of each direction comes first: a purely greedy choice may use a single
        # direction, which cannot separate position errors from errors of the angles.
        first = allowed & (chosen_in_direction[direction] == 0)
        candidates = np.flatnonzero(first if first.any() else allowed)
        if not len(candidates):
            break
        gain = _information_gain(information.rows[candidates], covariance)
        best = candidates[int(np.argmax(gain))]
        available[best] = False
        chosen_in_direction[direction[best]] += 1
        own = information.sighting[best][information.sighting[best] >= 0]
        chosen_in_interval[interval[own]] += 1
        rows = information.rows[best]
        crossed = rows @ covariance
        inner = np.eye(len(rows)) + crossed @ rows.T
        covariance = covariance - crossed.T @ np.linalg.solve(inner, crossed)
        picked.append(np.sort(own))
    return PatchChoice(picked, PRIOR_ANGLE_SIGMA * np.sqrt(np.diag(covariance)[:3]))


def _information_gain(rows: Array, covariance: Array) -> Array:
    """Negative log determinant of the angles' covariance after adding each patch, (patches,)."""
    crossed = rows @ covariance
    inner = np.eye(rows.shape[1]) + crossed @ np.swapaxes(rows, 1, 2)
    angles = crossed[:, :, :3]
    reduction = np.swapaxes(angles, 1, 2) @ np.linalg.solve(inner, angles)
    determinant = np.linalg.det(covariance[:3, :3] - reduction)
    return np.asarray(-np.log(np.maximum(determinant, np.finfo(float).tiny)))


def _patch_information(
    patches: Patches, number: Indices, clouds: Mapping[str, Cloud], accuracy: TrajectoryAccuracy
) -> _PatchInformation:
    planes, position = patches.planes, np.full(len(patches), -1)
    position[number] = np.arange(len(number))
    rows = np.flatnonzero(position[patches.patch] >= 0)
    owner = position[patches.patch[rows]]
    derivative = _sighting_derivatives(patches, rows, clouds, accuracy)
    off = np.hypot(MIN_SIGHTING_ERROR, ROUGHNESS_SHARE * planes.roughness[rows])
    # Lines whose derivatives by the angles differ most from the mean are the most informative.
    lines, total = len(clouds), np.bincount(owner, minlength=len(number))
    mean = np.stack([np.bincount(owner, c, len(number)) for c in derivative[:, :3].T], axis=1)
    displacement = np.linalg.norm(derivative[:, :3] - (mean / total[:, None])[owner], axis=1) / off
    order = np.lexsort((-displacement, owner))
    rank = np.arange(len(order)) - (np.cumsum(total) - total)[owner[order]]
    order, rank = order[rank < MAX_SIGHTINGS_PER_PATCH], rank[rank < MAX_SIGHTINGS_PER_PATCH]
    column_count = 3 + 6 * lines
    table = np.zeros((len(number), MAX_SIGHTINGS_PER_PATCH, column_count))
    weight = np.zeros((len(number), MAX_SIGHTINGS_PER_PATCH))
    sighting = np.full((len(number), MAX_SIGHTINGS_PER_PATCH), -1, dtype=np.int64)
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
    """Derivatives of the offset of sightings along their normals, shape (k, 9), metres.

    For a change of roll, pitch and yaw, of the position and of the attitude by one sigma each.
    """
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
            lidar, poses, mounting.with_boresight(mounting.boresight + ANGLE_STEP * axis)
        )
        found[:, k] = ((turned - centre) * normal).sum(axis=1) / ANGLE_STEP * PRIOR_ANGLE_SIGMA
        displaced = place_points(
            lidar, Poses(poses.position, poses.attitude + ANGLE_STEP * axis), mounting
        )
        moved = ((displaced - centre) * normal).sum(axis=1) / ANGLE_STEP
        found[:, 6 + k] = moved * attitude[:, k]
    found[:, 3:6] = normal * position
    return found


def _nearest_direction(normals: Array) -> Indices:
    """Index of the nearest of thirteen directions for each normal, shape (n,).

    The directions point to the faces, edges and corners of a cube; opposite ones are the same.
    """
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
