"""Points of the lines at the objects, prepared for repeated georeferencing.

Only these points, a few hundred per line and object, are georeferenced again when an angle changes.
This is fast enough to update the display while a slider is moved.
"""

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.point_tree import PointTree
from lispac.patchtest.object_boxes import PatchObject
from lispac.progress import Progress, no_progress
from lispac.survey.cloud import Cloud, Line
from lispac.survey.georeferencing import Mounting, place_points
from lispac.survey.trajectory import Poses
from lispac.targets.thinning import thin_points

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

MAX_LINE_POINTS = 400
"""Approximate largest number of points of a line at an object.

More points add little information, because they share one POS error.
"""
MIN_SPACING = 0.03
"""Smallest spacing of these points, metres."""
MIN_LINE_POINTS = 30
"""Smallest number of points of a line that sees an object."""
BOX_MARGIN = 0.3
"""Width of the zone around a box in which points are also taken, metres."""
MAX_NEIGHBOUR_DISTANCE_RATIO = 2.2
"""Largest median distance to the sixth neighbour, in units of the point spacing.

The points of a profiler are close together within a profile, and the profiles are far apart. A
larger distance means that the neighbours lie in a single profile and define no plane.
"""
MAX_POLE_WIDTH_RATIO, MAX_POLE_WIDTH = 0.15, 0.4
"""Largest standard deviation of the points of a pole across its axis.

As a fraction of the standard deviation along the axis, and in metres; both limits apply.
"""
MAX_EXAMINED_RATIO = 30
"""Largest number of points of a line examined near an object, per point that is used."""
ANGLE_STEP = 1e-4
"""Step of the angles for numerical derivatives, radians."""


@dataclass(frozen=True, eq=False)
class ObjectPoints:
    """Points of one object in one line.

    Attributes
    ----------
    object : PatchObject
    line : str
    begin, end : int
        Range of the points in the sample.
    spacing : float, metres
        Spacing of the points.
    inside : ndarray of shape (end - begin,), bool
        Whether each point lies in the object's box. The other points only serve as matches for
        points of other lines.
    time : float, seconds
        Median time of the points.
    heading : float, radians
        Median heading of the vessel at the points.
    view : ndarray of shape (3,), unit vector, local frame
        Direction from the POS of the vessel to the object.
    axis : ndarray of shape (3,), unit vector, local frame, or None
        Axis of the object if it is slender, such as a pole; None otherwise.
    """

    object: PatchObject
    line: str
    begin: int
    end: int
    spacing: float
    inside: Flags
    time: float
    heading: float
    view: Array
    axis: Array | None = None

    @property
    def points(self) -> slice:
        """Range of the points in the sample."""
        return slice(self.begin, self.end)


@dataclass(frozen=True, eq=False)
class ObjectSample:
    """Points of all lines at some objects, in the LiDAR frame, with their poses.

    Attributes
    ----------
    observed : tuple of ObjectPoints
        Sorted by object.
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    poses : Poses
        Pose of the vessel at each of the n points.
    mounting : Mounting
        Lever arm and offsets, and the boresight with which the points were selected.
    """

    observed: tuple[ObjectPoints, ...]
    points_lidar: Array
    poses: Poses
    mounting: Mounting

    @classmethod
    def of(
        cls,
        objects: Sequence[PatchObject],
        clouds: Mapping[str, Cloud],
        lines: Mapping[str, Line],
        *,
        margin: float = BOX_MARGIN,
        limit: int = MAX_LINE_POINTS,
        progress: Progress = no_progress,
    ) -> "ObjectSample":
        """Select the points of all lines in and around the boxes of objects.

        The selection is made once, with the current georeferencing. The same points are used for
        every other boresight, even if they then lie outside the box.

        Parameters
        ----------
        clouds : mapping of line name to Cloud
            Georeferenced well enough that each box contains its object in all lines.
        lines : mapping of line name to Line
            The same lines in the LiDAR frame.
        margin : float, metres
            Width of the zone around a box in which points are taken as matches for other lines.
        limit : int
            Approximate largest number of points of a line at an object.
        """
        observed: list[ObjectPoints] = []
        lidar: list[Array] = []
        position: list[Array] = []
        attitude: list[Array] = []
        begin = 0
        for k, each in enumerate(objects):
            progress(k / len(objects))
            near, radius = {}, each.box.reach + 2 * margin
            for line, cloud in clouds.items():
                region = cloud.within(each.box.centre, radius, limit=MAX_EXAMINED_RATIO * limit)
                own = each.box.inside(region.points, margin)
                if np.count_nonzero(own) >= MIN_LINE_POINTS:
                    near[line] = (region.numbers[own], region.points[own])
            if len(near) < 2:
                continue
            groups = [points for _, points in near.values()]
            axis = _pole_axis([points[each.box.inside(points)] for points in groups])
            spacing = _choose_point_spacing(groups, limit, even=axis is None)
            for line, (numbers, points) in near.items():
                rows = thin_points(points, spacing)
                kept, inside = numbers[rows], each.box.inside(points[rows])
                where = clouds[line].place
                points_lidar, time = lines[line].take(kept)
                poses = where.trajectory.at(time + where.mounting.latency)
                middle = float(np.median(time))
                heading = float(np.median(poses.attitude[:, 2]))
                end = begin + len(kept)
                view = each.box.centre - poses.position.mean(axis=0)
                view /= np.linalg.norm(view)
                observed.append(
                    ObjectPoints(
                        each, line, begin, end, spacing, inside, middle, heading, view, axis
                    )
                )
                lidar.append(points_lidar)
                position.append(poses.position)
                attitude.append(poses.attitude)
                begin = end
        nothing = np.empty((0, 3))
        return cls(
            tuple(observed),
            np.concatenate([nothing, *lidar]),
            Poses(np.concatenate([nothing, *position]), np.concatenate([nothing, *attitude])),
            next(iter(clouds.values())).place.mounting,
        )

    def placed_points(self, boresight: Array) -> Array:
        """Georeference all points with a boresight, shape (n, 3), metres, local frame.

        Parameters
        ----------
        boresight : ndarray of shape (3,), radians
        """
        return place_points(self.points_lidar, self.poses, self.mounting.with_boresight(boresight))

    def boresight_derivatives(self, boresight: Array) -> Array:
        """Derivatives of the points by each angle, shape (3, n, 3), metres per radian, local frame.

        Parameters
        ----------
        boresight : ndarray of shape (3,), radians
        """
        placed = self.placed_points(boresight)
        return np.stack(
            [
                (self.placed_points(boresight + ANGLE_STEP * k) - placed) / ANGLE_STEP
                for k in np.eye(3)
            ]
        )

    def pos_error_derivatives(self, boresight: Array) -> Array:
        """Derivatives by the roll, pitch and heading of the POS, as in `boresight_derivatives`.

        Parameters
        ----------
        boresight : ndarray of shape (3,), radians
        """
        mounting, poses = self.mounting.with_boresight(boresight), self.poses
        placed = place_points(self.points_lidar, poses, mounting)
        return np.stack(
            [
                (
                    place_points(
                        self.points_lidar,
                        Poses(poses.position, poses.attitude + ANGLE_STEP * k),
                        mounting,
                    )
                    - placed
                )
                / ANGLE_STEP
                for k in np.eye(3)
            ]
        )

    def joined_with(self, other: "ObjectSample") -> "ObjectSample":
        """Sample with the points of other objects appended."""
        begin = len(self.points_lidar)
        shifted = [replace(e, begin=e.begin + begin, end=e.end + begin) for e in other.observed]
        poses = Poses(
            np.concatenate([self.poses.position, other.poses.position]),
            np.concatenate([self.poses.attitude, other.poses.attitude]),
        )
        points = np.concatenate([self.points_lidar, other.points_lidar])
        return ObjectSample((*self.observed, *shifted), points, poses, self.mounting)

    def of_objects(self, names: Collection[str]) -> "ObjectSample":
        """Sample restricted to the objects with these names."""
        kept = [each for each in self.observed if each.object.name in names]
        rows = np.concatenate([np.arange(e.begin, e.end) for e in kept] or [np.empty(0, int)])
        shifted, begin = [], 0
        for each in kept:
            end = begin + each.end - each.begin
            shifted.append(replace(each, begin=begin, end=end))
            begin = end
        poses = Poses(self.poses.position[rows], self.poses.attitude[rows])
        return ObjectSample(tuple(shifted), self.points_lidar[rows], poses, self.mounting)


def _pole_axis(groups: Sequence[Array]) -> Array | None:
    """Common axis of the point groups if most of them are slender like a pole; None otherwise."""
    axes = []
    for points in groups:
        if len(points) < MIN_LINE_POINTS:
            continue
        variances, directions = np.linalg.eigh(np.cov(points.T))
        long, wide = np.sqrt(variances[2]), np.sqrt(max(variances[1], 0.0))
        if wide <= min(MAX_POLE_WIDTH_RATIO * long, MAX_POLE_WIDTH):
            axes.append(directions[:, 2])
    if 2 * len(axes) <= len(groups):
        return None
    _, directions = np.linalg.eigh(np.transpose(axes) @ np.array(axes))
    return np.asarray(directions[:, 2])


def _choose_point_spacing(groups: Sequence[Array], limit: int, *, even: bool) -> float:
    """Choose a point spacing that leaves at most about ``limit`` points in each line.

    With ``even`` the spacing is also increased until the points are evenly spaced in all
    directions; for poles it is not. It is not increased if a line would then have fewer than
    `MIN_LINE_POINTS` points.
    """
    spacing = MIN_SPACING
    kept = [points[thin_points(points, spacing)] for points in groups]
    while True:
        most_points = max(len(points) for points in kept)
        uneven = (
            even
            and max(_sixth_neighbour_distance(points) for points in kept)
            > MAX_NEIGHBOUR_DISTANCE_RATIO * spacing
        )
        wider = spacing * max(1.25 if uneven else 1.1, np.sqrt(most_points / limit))
        if most_points <= limit and not uneven:
            return float(spacing)
        thinned = [points[thin_points(points, wider)] for points in groups]
        if min(len(points) for points in thinned) < MIN_LINE_POINTS:
            return float(spacing)
        spacing, kept = wider, thinned


def _sixth_neighbour_distance(points: Array) -> float:
    if len(points) < 8:
        return 0.0
    return float(np.median(PointTree(points).neighbours(points, 7)[0][:, -1]))
