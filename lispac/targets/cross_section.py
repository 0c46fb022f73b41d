"""Cross-sections: the points of all lines in a thin strip, drawn to scale.

A cross-section shows differences between lines. In a section across a board, the points of each
line appear as a stroke. The strokes are offset or tilted as the lines are.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.geometry.planes import fit_plane
from lispac.messages import error
from lispac.survey.cloud import Cloud

Array = NDArray[np.float64]
UP_DIRECTION = np.array([0.0, 0.0, 1.0])

MIN_HORIZONTAL_COMPONENT = np.cos(np.radians(80.0))
"""Horizontal component of a unit normal below which a target is horizontal and has no azimuth."""


@dataclass(frozen=True, eq=False)
class Section:
    """Thin box of points, drawn as a cross-section.

    Attributes
    ----------
    centre : ndarray of shape (3,), metres, local frame
    right, up : ndarray of shape (3,), unit vectors, local frame
        Axes of the picture.
    width, height : metres, of the picture
    thickness : metres, across the picture
    """

    centre: Array
    right: Array
    up: Array
    width: float
    height: float
    thickness: float

    @property
    def across(self) -> Array:
        """Unit vector across the picture, shape (3,)."""
        return np.asarray(np.cross(self.right, self.up))

    def to_section_axes(self, points: Array) -> Array:
        """Picture coordinates of the points inside the strip.

        Parameters
        ----------
        points : ndarray of shape (n, 3), metres, local frame

        Returns
        -------
        ndarray of shape (m, 2), metres, to the right and upwards of the centre
        """
        placed = (points - self.centre) @ np.column_stack([self.right, self.up, self.across])
        half = 0.5 * np.array([self.width, self.height, self.thickness])
        inside = np.all(np.abs(placed) <= half, axis=1)
        return np.asarray(placed[inside, :2])

    def cut_points(self, cloud: Cloud) -> Array:
        """`to_section_axes` for a line, shape (k, 2); only points near the section are read."""
        pieces = max(1, round(self.width / max(self.height, self.thickness)))
        step = self.width / pieces
        radius = 0.5 * float(np.linalg.norm([step, self.height, self.thickness])) * 1.001
        found = []
        for k in range(pieces):
            offset = (k + 0.5) * step - 0.5 * self.width
            points = cloud.within(self.centre + offset * self.right, radius).points
            # Only the last piece includes its far end: each point belongs to exactly one piece.
            along = (points - self.centre) @ self.right - offset
            own = (along >= -0.5 * step) & ((along < 0.5 * step) | (k == pieces - 1))
            found.append(self.to_section_axes(points[own]))
        return np.concatenate(found)


def common_normal(groups: Iterable[Array]) -> Array:
    """Common normal of several groups of points (n, 3), a unit vector (3,), in the local frame.

    A plane is fitted to each group separately, since an offset between the groups would tilt a
    plane through all points.
    """
    normals = np.array([fit_plane(points).normal for points in groups])
    _, axes = np.linalg.eigh(normals.T @ normals)
    return np.asarray(axes[:, 2])


def section_across_target(
    centre: Array,
    normal: Array,
    eye: Array,
    *,
    level: bool = False,
    size: float = 2.0,
    thickness: float = 0.2,
) -> Section:
    """Section perpendicular to a target through its centre.

    Parameters
    ----------
    centre : ndarray of shape (3,), metres, local frame
    normal : ndarray of shape (3,), unit vector, local frame
    eye : ndarray of shape (3,), metres, local frame
        Position from which the target was scanned. This side is on the left of the picture, and at
        the bottom of a horizontal section.
    level : bool
        Whether the section is horizontal and viewed from above, instead of vertical.
    size : float, metres
        Width and height of the picture.
    thickness : float, metres
    """
    ahead = np.array([normal[0], normal[1], 0.0])
    away = np.array([*(centre - eye)[:2], 0.0])
    if np.linalg.norm(ahead) < MIN_HORIZONTAL_COMPONENT:
        ahead = away if np.linalg.norm(away) > 0 else np.array([1.0, 0.0, 0.0])
    ahead = ahead / np.linalg.norm(ahead)
    if ahead @ away < 0:
        ahead = -ahead
    if level:
        return Section(centre, np.cross(ahead, UP_DIRECTION), ahead, size, size, thickness)
    return Section(centre, ahead, UP_DIRECTION, size, size, thickness)


def section_between(
    first: Array, second: Array, *, height: float | None = None, thickness: float = 0.2
) -> Section:
    """Vertical section from one point to another.

    Parameters
    ----------
    first, second : ndarray of shape (3,), metres, local frame
    height : float, metres, optional
        Height of the picture. If omitted, it is equal to the length, and at least 2 m.
    thickness : float, metres

    Raises
    ------
    InputError
        If one point is vertically above the other.
    """
    way = np.array([*(second - first)[:2], 0.0])
    length = float(np.linalg.norm(way))
    if length < 0.01:
        raise InputError(error("target.section_vertical"))
    high = max(length, 2.0) if height is None else height
    return Section(0.5 * (first + second), way / length, UP_DIRECTION, length, high, thickness)
