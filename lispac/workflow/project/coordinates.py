"""Typed or listed coordinates, in the local frame or in a coordinate system."""

from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.geometry.frames import north_west_up
from lispac.io.text.seed_file import PointList
from lispac.messages import Message, error, note
from lispac.survey.crs import CoordinateSystem
from lispac.survey.trajectory import LocalTrajectory

Array = NDArray[np.float64]

LocalAxes = Literal["north, west, up", "east, north, up"]
"""Order of coordinates in the local frame: the first one in files, options and scripts, the second
one in the window, as in the report."""
MAX_TARGET_DISTANCE = 5_000.0
"""Largest distance of a target from the trajectory, metres; beyond it a typing error is assumed."""
HEIGHT_UNITS = ((1.0, "metre"), (0.3048, "foot"), (1200 / 3937, "US survey foot"))
"""Lengths in metres of units of heights."""
MAX_TRAJECTORY_STATES = 5_000
"""Approximate number of states of the trajectory that distances are computed from."""


def is_local(system: CoordinateSystem | None) -> bool:
    """Whether coordinates are in the local frame of the project, or in that of a cloud."""
    return system is None or system.frame is not None


def axis_names(
    system: CoordinateSystem | None, local_axes: LocalAxes = "north, west, up"
) -> tuple[str, str, str]:
    """Names of the three coordinates, in their order."""
    if system is None or system.frame is not None:
        first, second, third = local_axes.split(", ")
        return first, second, third
    if system.is_geographic:
        return "longitude", "latitude", "height"
    if system.crs.is_geocentric:
        return "X", "Y", "Z"
    return "easting", "northing", "height"


def axis_units(system: CoordinateSystem) -> tuple[str, str, str]:
    """EPSG names of the units of the three coordinates."""
    height = min(HEIGHT_UNITS, key=lambda unit: abs(unit[0] - system.metres[2]))[1]
    return system.unit, system.unit, height


def to_local_frame(
    points: Array,
    system: CoordinateSystem | None,
    trajectory: LocalTrajectory,
    local_axes: LocalAxes = "north, west, up",
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
    if is_local(system) and local_axes == "east, north, up":
        points = north_west_up(points)
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
    point: Array,
    system: CoordinateSystem | None,
    trajectory: LocalTrajectory,
    name: str | Message,
    local_axes: LocalAxes = "north, west, up",
) -> Message | None:
    """Error that coordinates are too far from the survey for a target; None if they are not.

    Parameters
    ----------
    point : ndarray of shape (3,)
        In ``system``; metres along ``local_axes`` in the local frame if that is None.
    name : str or Message
        Name of the target, file or row with the coordinates.
    """

    def distance_of(point: Array) -> float:
        place = to_local_frame(point, system, trajectory, local_axes)
        return float(distances_from_trajectory(place, trajectory)[0])

    distance = distance_of(point)
    if distance <= MAX_TARGET_DISTANCE:
        return None
    values = " ".join(f"{value:g}" if abs(value) < 1e6 else f"{value:.1f}" for value in point)
    is_swapped = distance_of(point[[1, 0, 2]]) <= MAX_TARGET_DISTANCE
    outside = not np.isfinite(distance)
    if system is None or system.frame is not None:
        axes = tuple(AXIS_NOTES[axis] for axis in axis_names(None, local_axes))
        if is_swapped:
            first, second, _ = axes
            return error(
                "coordinates.swapped_local", name=name, values=values, first=first, second=second
            )
        if outside:
            return error("coordinates.outside_local", name=name, values=values, axes=axes)
        return error(
            "coordinates.too_far_local", name=name, values=values, distance=distance, axes=axes
        )
    if is_swapped:
        return error(
            SWAPPED_AXES_CODES[axis_names(system)[0]], name=name, values=values, system=system.name
        )
    if outside:
        return error("coordinates.outside_system", name=name, values=values, system=system.name)
    return error(
        "coordinates.too_far", name=name, values=values, system=system.name, distance=distance
    )


AXIS_NOTES = {
    "east": note("axis.east"), "north": note("axis.north"), "west": note("axis.west"),
    "up": note("axis.up"),
}  # fmt: skip
"""Names of the axes of the local frame, as parts of a message."""
SWAPPED_AXES_CODES = {
    "longitude": "coordinates.swapped_geographic",
    "X": "coordinates.swapped_geocentric",
    "easting": "coordinates.swapped_projected",
}
"""Code of the error on exchanged coordinates, by the name of the first coordinate."""


def require_near_trajectory(
    point: Array,
    system: CoordinateSystem | None,
    trajectory: LocalTrajectory,
    name: str | Message,
    local_axes: LocalAxes = "north, west, up",
) -> Array:
    """Convert coordinates to the local frame, shape (3,), metres; refuse them if too far away.

    Parameters
    ----------
    point : ndarray of shape (3,)
        In ``system``; metres along ``local_axes`` in the local frame if that is None.
    name : str or Message
        Name of the target, file or row with the coordinates.

    Raises
    ------
    InputError
        If the point is too far from the trajectory.
    """
    if refusal := too_far_message(point, system, trajectory, name, local_axes):
        raise InputError(refusal)
    place: Array = to_local_frame(point, system, trajectory, local_axes)[0]
    return place


def columns_note(points: PointList, system: CoordinateSystem | None) -> Message:
    """Note on the order of the columns of a list of points."""
    axes = dict(zip("xyz", axis_names(system), strict=True))
    columns = tuple(note(_COLUMN_NAME_CODES[axes.get(name, name)]) for name in points.columns)
    code = "assumed.columns_as_named" if points.are_columns_given else "assumed.columns_by_order"
    return note(code, columns=columns)


_COLUMN_NAME_CODES = {
    "name": "list_column.name",
    "role": "list_column.role",
    "plane": "list_column.plane",
    "sigma": "list_column.sigma",
    "sigma x": "list_column.sigma_x",
    "sigma y": "list_column.sigma_y",
    "sigma z": "list_column.sigma_z",
    "-": "list_column.unused",
    "north": "axis.north",
    "west": "axis.west",
    "up": "axis.up",
    "longitude": "axis.longitude",
    "latitude": "axis.latitude",
    "height": "axis.height",
    "X": "axis.x",
    "Y": "axis.y",
    "Z": "axis.z",
    "easting": "axis.easting",
    "northing": "axis.northing",
}
"""Codes of the texts for columns of a list and axes of a coordinate system."""
