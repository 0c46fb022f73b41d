"""Values of single points of a project's lines: coordinates, time, range, incidence, intensity."""

import numpy as np
from numpy.typing import NDArray

from lispac.errors import PlaneNotFound
from lispac.geometry.frames import east_north_up
from lispac.geometry.planes import extent_in_plane, fit_plane, rms_distance
from lispac.language import gettext
from lispac.present.survey.measured_point import LOCAL_UNIT, Coordinate, MeasuredPoint
from lispac.project import Project
from lispac.survey.cloud import Cloud
from lispac.survey.crs import CoordinateSystem
from lispac.survey.known_time_base import base_message
from lispac.survey.time_base import base_of_key
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.importing.given_time_bases import time_base_of_trajectory
from lispac.workflow.importing.line_chunks import LineChunks
from lispac.workflow.project.coordinates import axis_names, axis_units, is_local

Array = NDArray[np.float64]

PLANE_RADIUS_M = 0.3
"""Radius around a point within which the plane for its angle of incidence is fitted."""
MIN_PLANE_POINTS, MAX_PLANE_RMS_M, MIN_EXTENT_M = 12, 0.03, 0.1
"""Smallest number of points of this plane, largest RMS of their distances, and smallest extent in
each direction. Otherwise, the surface is not considered a plane."""


MAX_PLANE_POINTS = 5_000
"""Approximate largest number of points of this plane, which are enough for its normal."""


class PointReader:
    """Reads the values of points; keeps what is common to all points of a project."""

    def __init__(self, project: Project, trajectory: LocalTrajectory) -> None:
        self._trajectory = trajectory
        self._lines = {line.name: line for line in project.lines}
        self._systems: dict[str, CoordinateSystem | None] = {}
        key = time_base_of_trajectory(project)
        self._time_base = base_message(base_of_key(key)) if key else None

    def values(self, line: str, cloud: Cloud, index: int, near: Array) -> MeasuredPoint:
        """Values of one point.

        The coordinates are in the coordinate system of the line's file, or east, north and up in
        the local frame of the project if it has none.

        Parameters
        ----------
        index : int
            Index of the point in the sample of ``cloud``.
        near : ndarray of shape (n, 3), metres, local frame
            Drawn points of the line within `PLANE_RADIUS_M`. If they are too few for a plane, as in
            an overview, all points of the line are used.
        """
        place = cloud.sample[index].astype(np.float64)
        points_lidar, time = cloud.sample_lidar(np.array([index]))
        # The scanner itself has no position in `place` if there is a range offset
        beam = place - cloud.place(0.5 * points_lidar, time)[0]
        if len(near) < MIN_PLANE_POINTS:
            near = cloud.within(place, PLANE_RADIUS_M, limit=MAX_PLANE_POINTS).points
        intensity, incidence = cloud.sample_intensity, incidence_angle(near, beam)
        system = self._system(line)
        return MeasuredPoint(
            line=line,
            coordinates=self._coordinates(place, system),
            system=gettext("local frame") if system is None else system.name,
            time_s=float(time[0]),
            time_base=self._time_base,
            range_m=float(np.linalg.norm(points_lidar[0])),
            incidence_rad=incidence,
            plane_points=None if incidence is None else len(near),
            intensity=None if intensity is None else float(intensity[index]),
        )

    def _system(self, line: str) -> CoordinateSystem | None:
        if line not in self._systems:
            system = LineChunks.of(self._lines[line]).system
            # A cloud in another local frame has positions in that of the project.
            self._systems[line] = None if is_local(system) else system
        return self._systems[line]

    def _coordinates(self, place: Array, system: CoordinateSystem | None) -> tuple[Coordinate, ...]:
        if system is None:
            values, units = east_north_up(place), (LOCAL_UNIT,) * 3
        else:
            values = system.from_local(place[None], self._trajectory.frame, strict=False)[0]
            units = axis_units(system)
        axes = axis_names(system, "east, north, up")
        return tuple(
            Coordinate(axis, float(value), unit)
            for axis, value, unit in zip(axes, values, units, strict=True)
        )


def incidence_angle(near: Array, beam: Array) -> float | None:
    """Angle between a beam and the normal of a plane, radians; None if there is no plane.

    Parameters
    ----------
    near : ndarray of shape (n, 3), metres, local frame
        Points through which the plane is fitted.
    beam : ndarray of shape (3,), local frame
    """
    if len(near) < MIN_PLANE_POINTS:
        return None
    try:
        plane = fit_plane(near)
    except PlaneNotFound:
        return None
    extent = float(extent_in_plane(plane, near).min())
    if rms_distance(plane, near) > MAX_PLANE_RMS_M or extent < MIN_EXTENT_M:
        return None
    cosine = abs(float(beam @ plane.normal)) / float(np.linalg.norm(beam))
    return float(np.arccos(min(cosine, 1.0)))
