"""Typed or listed coordinates, in the local frame or in a coordinate system."""

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import Message, error
from lispac.survey.crs import CoordinateSystem
from lispac.survey.trajectory import LocalTrajectory

Array = NDArray[np.float64]

MAX_TARGET_DISTANCE = 5_000.0
"""Largest distance of a target from the trajectory, metres; beyond it a typing error is assumed."""
MAX_TRAJECTORY_STATES = 5_000
"""Approximate number of states of the trajectory that distances are computed from."""


def axis_names(system: CoordinateSystem | None) -> tuple[str, str, str]:
    """Names of the three coordinates, in their order."""
    if system is None:
        return "north", "west", "up"
    if system.is_geographic:
        return "longitude", "latitude", "height"
    if system.crs.is_geocentric:
        return "X", "Y", "Z"
    return "easting", "northing", "height"


def to_local_frame(
    points: Array, system: CoordinateSystem | None, trajectory: LocalTrajectory
) -> Array:
    """Convert coordinates in a coordinate system to the local frame.

    Parameters
    ----------
    points : ndarray of shape (n, 3)
        In the order of `axis_names`; metres in the local frame.

    Returns
    -------
    ndarray of shape (n, 3), metres, local frame; not finite outside the coordinate system
    """
    points = np.asarray(points, dtype=float).reshape(-1, 3)
    if system is None:
        return points
    return system.to_local(points, trajectory.frame, strict=False)


def distances_from_trajectory(places: Array, trajectory: LocalTrajectory) -> Array:
    """Distances of places from the trajectory, shape (n,), metres."""
    from scipy.spatial import KDTree

    step = max(1, len(trajectory.position) // MAX_TRAJECTORY_STATES)
    distances = np.full(len(places), np.inf)
    inside = np.isfinite(places).all(axis=1)
    if inside.any():
        distances[inside] = KDTree(trajectory.position[::step]).query(places[inside])[0]
    return distances


def too_far_message(
    point: Array, system: CoordinateSystem | None, trajectory: LocalTrajectory, name: str | Message
) -> Message | None:
    """Error that coordinates are too far from the survey for a target; None if they are not.

    Parameters
    ----------
    point : ndarray of shape (3,)
        In ``system``; north, west, up in metres if that is None.
    name : str or Message
        Name of the target, file or row with the coordinates.
    """
    distance = float(
        distances_from_trajectory(to_local_frame(point, system, trajectory), trajectory)[0]
    )
    if distance <= MAX_TARGET_DISTANCE:
        return None
    values = " ".join(f"{value:g}" if abs(value) < 1e6 else f"{value:.1f}" for value in point)
    swapped = to_local_frame(point[[1, 0, 2]], system, trajectory)
    is_swapped = float(distances_from_trajectory(swapped, trajectory)[0]) <= MAX_TARGET_DISTANCE
    outside = not np.isfinite(distance)
    if system is None:
        if is_swapped:
            return error("coordinates.swapped_local", name=name, values=values)
        if outside:
            return error("coordinates.outside_local", name=name, values=values)
        return error("coordinates.too_far_local", name=name, values=values, distance=distance)
    if is_swapped:
        return error(
            SWAPPED_AXES_CODES[axis_names(system)[0]], name=name, values=values, system=system.name
        )
    if outside:
        return error("coordinates.outside_system", name=name, values=values, system=system.name)
    return error(
        "coordinates.too_far", name=name, values=values, system=system.name, distance=distance
    )


SWAPPED_AXES_CODES = {
    "longitude": "coordinates.swapped_geographic",
    "X": "coordinates.swapped_geocentric",
    "easting": "coordinates.swapped_projected",
}
"""Code of the error on exchanged coordinates, by the name of the first coordinate."""


def require_near_trajectory(
    point: Array, system: CoordinateSystem | None, trajectory: LocalTrajectory, name: str | Message
) -> Array:
    """Convert coordinates to the local frame, shape (3,), metres; refuse them if too far away.

    Parameters
    ----------
    point : ndarray of shape (3,)
        In ``system``; north, west, up in metres if that is None.
    name : str or Message
        Name of the target, file or row with the coordinates.

    Raises
    ------
    InputError
        If the point is too far from the trajectory.
    """
    if refusal := too_far_message(point, system, trajectory, name):
        raise InputError(refusal)
    place: Array = to_local_frame(point, system, trajectory)[0]
    return place
