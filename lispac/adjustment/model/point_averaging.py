"""Average neighbouring points of a plane into one point per cell.

Thinning by selection loses the information of the removed points, so that the sigmas increase with
the point spacing. Averaging keeps it, since the noise of a mean of ``n`` points is smaller by the
square root of ``n``.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.robust_loss import Loss
from lispac.adjustment.model.stochastic_model import MAX_KNOT_INTERVAL
from lispac.adjustment.model.target_shapes import points_local
from lispac.errors import PlaneNotFound
from lispac.geometry.planes import fit_plane_robustly, plane_axes
from lispac.survey.georeferencing import Mounting, to_lidar
from lispac.survey.trajectory import Poses

Array = NDArray[np.float64]

OUTLIER_LIMIT_SIGMAS = Loss("tukey").tuning
"""Distance of an outlier from the plane of its sighting, in standard deviations."""


def average_points_in_cells(
    observations: Observations,
    mounting: Mounting,
    distance: float,
    *,
    longest: float = MAX_KNOT_INTERVAL,
    no_outliers: bool = False,
) -> Observations:
    """Average the points of each sighting of a plane over squares of side ``distance``.

    The squares lie in the plane of the sighting. Cubes would separate points by the sign of their
    noise where the plane coincides with a face of the cubes. Only points measured within a short
    time are averaged, because the POS error changes with time. Points of spheres are not averaged,
    since the mean of points on a curved surface lies inside it.

    Parameters
    ----------
    mounting : Mounting
        Mounting with which the mean positions are computed. The averaged points reproduce them
        exactly with this mounting, and with an error of second order in the change of another one.
    distance : float, metres
        Side of the squares; with 0, the points are not changed.
    longest : float, seconds
        Longest time over which points are averaged, by default the knot interval of the POS error.
    no_outliers : bool
        Exclude outliers from the plane of the sighting, since a loss function cannot detect an
        outlier within an average.

    Returns
    -------
    Observations
        ``excluded_outliers`` includes the number of excluded outliers.
    """
    if distance <= 0:
        return observations
    points = points_local(observations, mounting)
    planes = _sighting_planes(observations, points, distance)
    if no_outliers:
        outlying = _find_outliers(observations, planes)
        if outlying.any():
            fewer = observations.reordered(np.flatnonzero(~outlying))
            fewer = replace(
                fewer, excluded_outliers=observations.excluded_outliers + int(outlying.sum())
            )
            return average_points_in_cells(fewer, mounting, distance, longest=longest)
    order, start = _sort_into_cells(observations, planes, points, distance, longest)
    return _average_cells(observations, mounting, points, order, start)


def _average_cells(
    observations: Observations,
    mounting: Mounting,
    points: Array,
    order: NDArray[np.intp],
    start: NDArray[np.intp],
) -> Observations:
    """Average the points of each cell, from the order of `_sort_into_cells`."""
    counts = np.diff(np.append(start, len(order)))

    def mean(values: Array) -> Array:
        return np.asarray((np.add.reduceat(values[order], start, axis=0).T / counts).T)

    attitude = observations.attitude[order]
    # Remove jumps of the heading by a full turn within a cell
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
        time_separation=_mean_time_separation(observations.time[order], start, counts),
    )


def _mean_time_separation(time: Array, start: NDArray[np.intp], counts: NDArray[np.intp]) -> Array:
    """Mean time between two points of a cell, shape (cells,), seconds.

    The mean includes the pairs of a point with itself. The times of a cell must be in ascending
    order.
    """
    since = time - np.repeat(time[start], counts)
    place = np.arange(len(time)) - np.repeat(start, counts)
    factor = 2 * place + 1 - np.repeat(counts, counts)
    return 2 * np.add.reduceat(factor * since, start) / counts**2


@dataclass(frozen=True, eq=False)
class _SightingPlane:
    """Points of one sighting: indices, coordinates in the fitted plane, and distances from it."""

    own: NDArray[np.intp]
    along: Array
    off: Array


def _sighting_planes(
    observations: Observations, points: Array, distance: float
) -> list[_SightingPlane]:
    found = []
    for s in range(len(observations.sightings)):
        own = np.flatnonzero(observations.sighting == s)
        try:
            plane = fit_plane_robustly(points[own], _given_lidar_sigma(observations, own))
        except PlaneNotFound:  # two points, or all on one straight line: nothing to average
            coordinates = np.zeros((len(own), 2))
            coordinates[:, 0] = 2 * distance * np.arange(len(own))
            found.append(_SightingPlane(own, coordinates, np.zeros(len(own))))
            continue
        along = points[own] @ plane_axes(plane.normal).T
        found.append(_SightingPlane(own, along, plane.distances(points[own])))
    return found


def _given_lidar_sigma(observations: Observations, own: NDArray[np.intp]) -> float:
    return float(observations.sigma_lidar[own].mean(axis=0).max())


def _robust_sigma(off: Array) -> float:
    return float(np.median(np.abs(off))) / 0.6745


def _find_outliers(observations: Observations, planes: list[_SightingPlane]) -> NDArray[np.bool_]:
    """Mask of the outliers: points to which a redescending loss would give no weight."""
    outlying = np.zeros(len(observations), dtype=bool)
    for s, plane in enumerate(planes):
        if observations.is_sphere[observations.target_of_sighting[s]]:
            continue
        spread = max(_robust_sigma(plane.off), _given_lidar_sigma(observations, plane.own))
        outlying[plane.own] = np.abs(plane.off) > OUTLIER_LIMIT_SIGMAS * spread
    return outlying


def _sort_into_cells(
    observations: Observations,
    planes: list[_SightingPlane],
    points: Array,
    distance: float,
    longest: float,
) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
    """Order of the points by cell and time, and the index at which each cell begins."""
    across = np.empty((len(points), 2))
    for plane in planes:
        across[plane.own] = plane.along
    grid = np.floor(across / distance).astype(np.int64)
    # Each point of a sphere has its own cell, so that it is not averaged.
    on_sphere = observations.is_sphere[observations.target_of_sighting[observations.sighting]]
    grid[on_sphere, 0] = np.arange(on_sphere.sum())
    key = observations.sighting.astype(np.int64)
    for each in (*grid.T, np.floor(observations.time / longest).astype(np.int64)):
        # Combine the keys one by one and renumber them, to avoid an overflow.
        each = each - each.min()
        key = np.unique(key * (int(each.max()) + 1) + each, return_inverse=True)[1].reshape(-1)
    order = np.lexsort((observations.time, key))
    start = np.flatnonzero(np.diff(key[order], prepend=-1))
    return order, start
