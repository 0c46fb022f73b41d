"""Camera of the viewport: position, movement by the mouse, and projection.

Coordinates are in the local frame (north, west, up), metres; up is always upwards on the screen.
Pixels are counted from the upper left corner of the widget, x to the right and y downwards.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

VIEW_ANGLE = float(np.radians(30.0))
"""Vertical angle of the field of view, radians."""

ORBIT_ANGLE_PER_PIXEL = float(np.radians(0.35))
"""Rotation per pixel of mouse movement, radians."""

MIN_DISTANCE_M = 0.02
"""Shortest distance from the eye to the focal point."""

PARALLEL_OFFSET_M = 5000.0
"""Distance added for a parallel projection, metres, so that all points are in front of the eye."""


@dataclass(frozen=True)
class ViewportSize:
    """Width and height of a viewport in pixels."""

    width: float
    height: float

    @property
    def pixels_per_tangent(self) -> float:
        """Focal length of the view in pixels."""
        return 0.5 * self.height / float(np.tan(0.5 * VIEW_ANGLE))


@dataclass(frozen=True, eq=False)
class Camera:
    """Position and direction of the camera.

    Attributes
    ----------
    focal : ndarray of shape (3,), metres, local frame
        Point in the middle of the picture.
    azimuth : direction of view, radians clockwise from north
    elevation : angle of the eye above the focal point, radians; pi/2 looks straight down
    distance : distance from the eye to the focal point, metres
        In a parallel projection, it only determines the scale, which is that of the focal point in
        perspective.
    parallel : whether the projection is parallel (orthographic)
    """

    focal: Array
    azimuth: float
    elevation: float
    distance: float
    parallel: bool = False

    @property
    def axes(self) -> Array:
        """Right, up and forward axes of the camera in rows; shape (3, 3), local frame."""
        sin_a, cos_a = np.sin(self.azimuth), np.cos(self.azimuth)
        sin_e, cos_e = np.sin(self.elevation), np.cos(self.elevation)
        return np.array(
            [
                [-sin_a, -cos_a, 0.0],
                [sin_e * cos_a, -sin_e * sin_a, cos_e],
                [cos_e * cos_a, -cos_e * sin_a, -sin_e],
            ]
        )

    @property
    def position(self) -> Array:
        """Position of the camera; shape (3,), metres, local frame."""
        position: Array = self.focal - self.focal_depth * self.axes[2]
        return position

    @property
    def focal_depth(self) -> float:
        """Distance from the camera to the focal point, metres."""
        return self.distance + (PARALLEL_OFFSET_M if self.parallel else 0.0)

    def scale_depth(self, depth: Array | float) -> Array | float:
        """Depth that determines the scale; constant in a parallel projection."""
        return self.distance if self.parallel else depth

    def project(self, points: Array, size: ViewportSize) -> Array:
        """Project points to pixels and depths.

        Parameters
        ----------
        points : ndarray of shape (n, 3), metres, local frame

        Returns
        -------
        ndarray of shape (n, 3)
            x and y in pixels and the depth in metres; x and y are NaN behind the eye.
        """
        rotated = (np.atleast_2d(points) - self.position) @ self.axes.T
        depth = np.where(rotated[:, 2] > 0.0, rotated[:, 2], np.nan)
        scale = size.pixels_per_tangent / self.scale_depth(depth)
        x = 0.5 * size.width + rotated[:, 0] * scale
        y = 0.5 * size.height - rotated[:, 1] * scale
        return np.column_stack([x, y, rotated[:, 2]])

    def ray_slopes(self, x: float, y: float, size: ViewportSize) -> tuple[float, float]:
        """Metres to the right and up, per metre of `scale_depth`, of the ray through a pixel."""
        return (
            (x - 0.5 * size.width) / size.pixels_per_tangent,
            (0.5 * size.height - y) / size.pixels_per_tangent,
        )

    def point_at(self, x: float, y: float, depth: float, size: ViewportSize) -> Array:
        """Point at a depth behind a pixel; shape (3,), metres, local frame."""
        right, up = self.ray_slopes(x, y, size)
        scale_depth = self.scale_depth(depth)
        return self.position + np.array([right * scale_depth, up * scale_depth, depth]) @ self.axes

    def with_focal_depth(self, depth: float) -> "Camera":
        """Camera with the same picture and the focal point at another depth."""
        depth = max(depth, MIN_DISTANCE_M)
        focal = self.position + depth * self.axes[2]
        return replace(self, focal=focal, distance=float(self.scale_depth(depth)))

    def with_projection(self, *, parallel: bool) -> "Camera":
        """Camera with parallel or perspective projection and the same size at the focal point."""
        return replace(self, parallel=parallel)

    def along(self, direction: Array) -> "Camera":
        """Camera that looks at the same focal point along a direction, shape (3,), local frame."""
        north, west, up = direction / np.linalg.norm(direction)
        level = float(np.hypot(north, west))
        azimuth = float(np.arctan2(-west, north)) if level > 1e-6 else self.azimuth
        return replace(self, azimuth=azimuth, elevation=float(np.arctan2(-up, level)))

    def centred(self, point: Array, factor: float, depth: float) -> "Camera":
        """Camera with a point at the centre, at ``factor`` times its ``depth``, metres."""
        return replace(self, focal=point, distance=factor * float(self.scale_depth(depth)))

    def orbited(self, dx: float, dy: float, pivot: Array) -> "Camera":
        """Camera turned about a point by a drag of (dx, dy) pixels."""
        limit = 0.5 * np.pi
        turned = replace(
            self,
            azimuth=float(np.remainder(self.azimuth + dx * ORBIT_ANGLE_PER_PIXEL, 2.0 * np.pi)),
            elevation=float(np.clip(self.elevation + dy * ORBIT_ANGLE_PER_PIXEL, -limit, limit)),
        )
        rotation = turned.axes.T @ self.axes
        return replace(turned, focal=pivot + rotation @ (self.focal - pivot))

    def panned(self, dx: float, dy: float, depth: float, size: ViewportSize) -> "Camera":
        """Camera shifted so that a point at ``depth`` follows the mouse by (dx, dy) pixels."""
        step = self.scale_depth(depth) / size.pixels_per_tangent
        return replace(self, focal=self.focal + step * (np.array([-dx, dy, 0.0]) @ self.axes))

    def zoomed(self, factor: float, fixed_point: Array) -> "Camera":
        """Camera at ``factor`` times the distance to a point, which stays at its pixel."""
        factor = max(factor, MIN_DISTANCE_M / self.distance)
        return replace(
            self,
            focal=fixed_point + factor * (self.focal - fixed_point),
            distance=factor * self.distance,
        )

    def resized(self, former: ViewportSize, size: ViewportSize) -> "Camera":
        """Camera for another size of the picture, whose upper left corner stays in place.

        All points at the focal depth keep their distance in pixels from this corner.
        """
        focal = self.point_at(0.5 * size.width, 0.5 * size.height, self.focal_depth, former)
        distance = max(self.distance * size.height / former.height, MIN_DISTANCE_M)
        return replace(self, focal=focal, distance=distance)

    def revealing(self, points: Array, size: ViewportSize, margin: float) -> "Camera":
        """Camera shifted as little as possible so that points (n, 3) are within the margin, pixels.

        Of points that extend over more than half of the picture, the part around their middle is
        considered. The camera is unchanged if a point is behind the eye.
        """
        spots = self.project(points, size)
        if len(points) == 0 or not np.isfinite(spots).all():
            return self
        low, high = spots[:, :2].min(axis=0), spots[:, :2].max(axis=0)
        extent = np.array([size.width, size.height])
        middle, half = 0.5 * (low + high), np.minimum(0.5 * (high - low), 0.25 * extent)
        shift = np.maximum(margin - (middle - half), 0.0)
        shift += np.minimum(extent - margin - (middle + half), 0.0)
        if not shift.any():
            return self
        return self.panned(*shift.tolist(), float(spots[:, 2].mean()), size)

    def fitted(
        self, points: Array, size: ViewportSize, margin: float = 1.06, bottom: float = 0.0
    ) -> "Camera":
        """Camera with the same direction that shows all of the points (n, 3).

        Parameters
        ----------
        bottom : height of a strip at the bottom of the picture that the points leave free, pixels
        """
        width, height = max(size.width, 1.0), max(size.height, 1.0)
        tangent = np.tan(0.5 * VIEW_ANGLE) * np.array([width / height, 1.0])
        # To the left and right, and below the middle of the picture
        tangents = tangent * [1.0, 1.0 - 2.0 * bottom / height], tangent
        rotated = points @ self.axes.T
        # Perspective shifts the centre of the picture, so it is found by iteration.
        centre = 0.5 * (rotated.min(axis=0) + rotated.max(axis=0))
        # The limits are linear in the points, so the points are processed only once.
        ahead = 0.0 if self.parallel else rotated[:, 2]
        extremes = [
            [float((sign * rotated[:, k] / limits[k] - ahead).max()) for k in (0, 1)]
            for sign, limits in zip((-1, 1), tangents, strict=True)
        ]
        slopes = 1.0 / tangents[0], 1.0 / tangents[1]
        distance = MIN_DISTANCE_M
        for _ in range(6):
            depth = 0.0 if self.parallel else centre[2]
            low = extremes[0] + centre[:2] * slopes[0] + depth
            high = extremes[1] - centre[:2] * slopes[1] + depth
            distance = float(max(low.max(), high.max(), MIN_DISTANCE_M))
            centre[:2] += (high - low) / (slopes[0] + slopes[1])
        return replace(
            self, focal=centre @ self.axes, distance=max(margin * distance, 5.0 * MIN_DISTANCE_M)
        )
