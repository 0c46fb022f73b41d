"""Coordinates that are typed or listed: in the local frame, or in a coordinate system."""

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
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


def too_far(point: Array, system: CoordinateSystem | None, trajectory: LocalTrajectory) -> str:
    """What is wrong with coordinates that no target of the survey can have; empty where nothing.

    Parameters
    ----------
    point : ndarray of shape (3,), local frame
        As one of `local_places`.
    """
    distance = float(away(local_places(point, system, trajectory), trajectory)[0])
    if distance <= FARTHEST:
        return ""
    first, second, _ = axes_of(system)
    where = "the local frame" if system is None else system.name
    if not np.isfinite(distance):
        said = f"they lie outside {where}"
    else:
        said = f"in {where} they are {distance / 1000:,.0f} km from the trajectory"
    swapped = local_places(point[[1, 0, 2]], system, trajectory)
    if float(away(swapped, trajectory)[0]) <= FARTHEST:
        return f"{said}; {first} comes first, then {second}: exchange the two"
    if system is None:
        return f"{said}; give metres north, west and up from its origin, or a coordinate system"
    return f"{said}; check the coordinate system and the order of the numbers"


def require_near(
    point: Array, system: CoordinateSystem | None, trajectory: LocalTrajectory, what: str
) -> Array:
    """The place of coordinates in the local frame, shape (3,), metres.

    Parameters
    ----------
    point : ndarray of shape (3,)
        In ``system``; north, west, up in metres where that is None.

    Raises
    ------
    InputError
        Where it is too far away; ``what`` begins the sentence.
    """
    if said := too_far(point, system, trajectory):
        numbers = " ".join(f"{value:g}" if abs(value) < 1e6 else f"{value:.1f}" for value in point)
        raise InputError(f"{what}: the coordinates {numbers} cannot be used: {said}.")
    place: Array = local_places(point, system, trajectory)[0]
    return place
