"""Clip box, and the plane that divides the picture between two placements of the lines."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.gui.viewport.camera import Camera, ViewportSize

Array = NDArray[np.float64]

CHUNK_POINTS = 1 << 14
"""Number of points processed at a time, whose intermediate results fit in the processor cache."""

MIN_SIDE_M = 0.05
"""Smallest length of a side of a box."""


@dataclass(frozen=True, eq=False)
class Box:
    """Box in any orientation.

    Attributes
    ----------
    centre : ndarray of shape (3,), metres, local frame
    axes : ndarray of shape (3, 3), rows are unit vectors, local frame
    half : ndarray of shape (3,), metres
        Half the lengths along the axes.
    """

    centre: Array
    axes: Array
    half: Array

    @classmethod
    def around(cls, points: Array, ahead: Array, margin: float) -> "Box":
        """Upright box around points.

        Parameters
        ----------
        points : ndarray of shape (n, 3), metres, local frame
        ahead : ndarray of shape (3,), unit vector, local frame
            Two sides are perpendicular to its horizontal direction; to north if it is steep.
        margin : distance of the sides from the points, metres
        """
        level = np.array([ahead[0], ahead[1], 0.0])
        length = np.linalg.norm(level)
        along = level / length if length > 0.2 else np.array([1.0, 0.0, 0.0])
        up = np.array([0.0, 0.0, 1.0])
        axes = np.array([along, np.cross(up, along), up])
        rotated = points @ axes.T
        low, high = rotated.min(axis=0) - margin, rotated.max(axis=0) + margin
        return cls(0.5 * (low + high) @ axes, axes, 0.5 * (high - low))

    def inside(self, points: Array) -> NDArray[np.int64]:
        """Indices of the points (n, 3) in the box."""
        shift, found = self.axes @ self.centre, []
        for start in range(0, len(points), CHUNK_POINTS):
            within = np.abs(points[start : start + CHUNK_POINTS] @ self.axes.T - shift) <= self.half
            # Column by column, since `np.all` along rows of three takes three times as long
            found.append(np.flatnonzero(within[:, 0] & within[:, 1] & within[:, 2]) + start)
        return np.concatenate(found) if found else np.empty(0, np.int64)

    def with_side_moved(self, side: int, metres: float) -> "Box":
        """Box with one side moved outwards; sides are numbered as in `sides`."""
        axis, sign = side // 2, 1.0 if side % 2 else -1.0
        metres = max(metres, MIN_SIDE_M - 2.0 * self.half[axis])
        half = self.half.copy()
        half[axis] += 0.5 * metres
        return replace(self, centre=self.centre + 0.5 * sign * metres * self.axes[axis], half=half)

    def with_lengths(self, lengths: Array) -> "Box":
        """Box with the same centre and other lengths, shape (3,), metres."""
        return replace(self, half=0.5 * np.maximum(lengths, MIN_SIDE_M))

    @property
    def sides(self) -> list[tuple[Array, Array]]:
        """Centre and outward direction of the six sides: negative and positive end of each axis."""
        return [
            (self.centre + sign * self.half[k] * self.axes[k], sign * self.axes[k])
            for k in range(3)
            for sign in (-1.0, 1.0)
        ]

    @property
    def corners(self) -> Array:
        """Corners, shape (8, 3), metres; see `BOX_EDGES`."""
        signs = np.array([(a, b, c) for c in (-1, 1) for a, b in FACE_CORNERS])
        corners: Array = self.centre + (signs * self.half) @ self.axes
        return corners


FACE_CORNERS = ((-1, -1), (1, -1), (1, 1), (-1, 1))
"""Corners of a face in their order around it, in units of half the lengths."""
_FACE_EDGES = [(k, (k + 1) % 4) for k in range(4)]
BOX_EDGES = (
    *_FACE_EDGES,
    *((a + 4, b + 4) for a, b in _FACE_EDGES),
    *((k, k + 4) for k in range(4)),
)
"""Pairs of corners of a box that are joined by an edge."""


def dividing_plane(camera: Camera, x: float, size: ViewportSize) -> tuple[Array, Array]:
    """Point and normal, shape (3,), of the plane that appears as the vertical line at ``x``.

    The normal points to the right side of the picture.
    """
    right, _ = camera.ray_slopes(x, 0.0, size)
    if camera.parallel:
        return camera.position + right * camera.distance * camera.axes[0], camera.axes[0]
    return camera.position, camera.axes[0] - right * camera.axes[2]
