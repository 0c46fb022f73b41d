"""Coordinates that are typed or listed: in the local frame, or in a coordinate system."""

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import Message, error
from lispac.survey.crs import CoordinateSystem
from lispac.survey.trajectory import LocalTrajectory

Array = NDArray[np.float64]

FARTHEST = 5_000.0
"""Metres from the trajectory beyond which no LiDAR on a vessel sees: a slip, not a target."""
STATES = 5_000
"""Of the trajectory, that distances are measured to: of an hour about one a second."""


def axes_of(system: CoordinateSystem | None) -> tuple[str, str, str]:
    """What the three coordinates are called, in their order."""
    if system is None:
        return "north", "west", "up"
    if system.is_geographic:
        return "longitude", "latitude", "height"
    if system.crs.is_geocentric:
        return "X", "Y", "Z"
    return "easting", "northing", "height"


def local_places(
    points: Array, system: CoordinateSystem | None, trajectory: LocalTrajectory
) -> Array:
    """Places in the local frame.

    Parameters
    ----------
    points : ndarray of shape (n, 3)
        In the order of `axes_of`; metres in the local frame.

    Returns
    -------
    ndarray of shape (n, 3), metres, local frame; not finite where the system does not reach
    """
    points = np.asarray(points, dtype=float).reshape(-1, 3)
    if system is None:
        return points
    return system.to_local(points, trajectory.frame, strict=False)


def away(places: Array, trajectory: LocalTrajectory) -> Array:
    """How far places are from the trajectory, shape (n,), metres."""
    from scipy.spatial import KDTree

    step = max(1, len(trajectory.position) // STATES)
    distances = np.full(len(places), np.inf)
    inside = np.isfinite(places).all(axis=1)
    if inside.any():
        distances[inside] = KDTree(trajectory.position[::step]).query(places[inside])[0]
    return distances


def too_far(
    point: Array, system: CoordinateSystem | None, trajectory: LocalTrajectory, name: str | Message
) -> Message | None:
    """What is wrong with coordinates that no target of the survey can have; None where nothing.

    Parameters
    ----------
    point : ndarray of shape (3,), local frame
        As one of `local_places`.
    name : str or Message
        Of the target, file or row that has the coordinates.
    """
    distance = float(away(local_places(point, system, trajectory), trajectory)[0])
    if distance <= FARTHEST:
        return None
    values = " ".join(f"{value:g}" if abs(value) < 1e6 else f"{value:.1f}" for value in point)
    swapped = local_places(point[[1, 0, 2]], system, trajectory)
    is_swapped = float(away(swapped, trajectory)[0]) <= FARTHEST
    outside = not np.isfinite(distance)
    if system is None:
        if is_swapped:
            return error("coordinates.swapped_local", name=name, values=values)
        if outside:
            return error("coordinates.outside_local", name=name, values=values)
        return error("coordinates.too_far_local", name=name, values=values, distance=distance)
    if is_swapped:
        return error(SWAPPED[axes_of(system)[0]], name=name, values=values, system=system.name)
    if outside:
        return error("coordinates.outside_system", name=name, values=values, system=system.name)
    return error(
        "coordinates.too_far", name=name, values=values, system=system.name, distance=distance
    )


SWAPPED = {
    "longitude": "coordinates.swapped_geographic",
    "X": "coordinates.swapped_geocentric",
    "easting": "coordinates.swapped_projected",
}
"""Code of the message that the first two coordinates are exchanged, by the first of `axes_of`."""


def require_near(
    point: Array, system: CoordinateSystem | None, trajectory: LocalTrajectory, name: str | Message
) -> Array:
    """The place of coordinates in the local frame, shape (3,), metres.

    Parameters
    ----------
    point : ndarray of shape (3,)
        In ``system``; north, west, up in metres where that is None.
    name : str or Message
        Of the target, file or row that has them.

    Raises
    ------
    InputError
        Where it is too far away.
    """
    if refusal := too_far(point, system, trajectory, name):
        raise InputError(refusal)
    place: Array = local_places(point, system, trajectory)[0]
    return place
