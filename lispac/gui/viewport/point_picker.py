"""Picking of the front-most point near the cursor, among all points."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.gui.viewport.camera import Camera, ViewportSize

Array = NDArray[np.float64]

PICK_RADII_PX = (2.0, 4.0, 8.0)
"""Search radii around the cursor, pixels, tried in turn.

A point exactly under the cursor takes precedence over the edge of a nearer object some pixels away.
The larger radii are for sparse clouds, in which the cursor may be between the points of a surface.
"""

MIN_SURROUNDING_POINTS = 4
"""Smallest number of points of a surface around the cursor for a click into a gap between them."""

CHUNK_POINTS = 1 << 14
"""Number of points processed at a time; the intermediate results fit in the processor cache."""


CENTRAL_RADII_PX = (3.0, 8.0, 20.0, 40.0)
"""Search radii for the surface in the middle of a picture, pixels."""
MAX_CENTRAL_SAMPLE = 60_000
"""Largest number of points among which the one nearest to the middle is searched for."""


@dataclass(frozen=True)
class PointHit:
    """Picked point: its line, its index there and its depth in metres."""

    line: str
    index: int
    depth: float


def pick_point(
    clouds: Mapping[str, Array],
    camera: Camera,
    x: float,
    y: float,
    size: ViewportSize,
    radii: tuple[float, ...] = PICK_RADII_PX,
) -> PointHit | None:
    """Find the point under a pixel.

    Parameters
    ----------
    clouds : ndarray of shape (n, 3) by line, metres, local frame
    x, y : pixels of the widget
    radii : search radii, pixels, ascending; a larger one is used if a smaller one has no points
    """
    names = list(clouds)
    found = [_points_near_pixel(clouds[name], camera, x, y, size, radii[-1]) for name in names]
    line = np.repeat(np.arange(len(names)), [len(part[0]) for part in found])
    if len(line) == 0:
        return None
    index, pixels, depth = (np.concatenate(parts) for parts in zip(*found, strict=True))
    distance = np.hypot(*pixels.T)

    def front_surface(radius: float) -> NDArray[np.int64]:
        """Points of the front surface within ``radius``, whose depth varies if it is oblique."""
        inside = distance <= radius
        if not inside.any():
            return np.empty(0, np.int64)
        front = depth[inside].min()
        slack = 4.0 * radius * camera.scale_depth(front) / size.pixels_per_tangent
        return np.flatnonzero(inside & (depth <= front + slack))

    candidates = front_surface(radii[-1])
    # Behind the gaps of a sparse surface, another one may be exactly under the cursor.
    if not _surround_cursor(pixels[candidates]):
        candidates = next(filter(len, map(front_surface, radii)), candidates)
    if not len(candidates):
        return None
    best = candidates[np.argmin(distance[candidates])]
    return PointHit(names[line[best]], int(index[best]), float(depth[best]))


def central_point(clouds: Mapping[str, Array], camera: Camera, size: ViewportSize) -> Array | None:
    """Point of the surface in the middle of a picture, or of the one nearest to it, shape (3,).

    It depends on the picture only, so that it is the same until the picture moves. None if no point
    is in the picture.

    Parameters
    ----------
    clouds : ndarray of shape (n, 3) by line, metres, local frame
        Points in random order.
    """
    middle = 0.5 * np.array([size.width, size.height])
    hit = pick_point(clouds, camera, *middle.tolist(), size, CENTRAL_RADII_PX)
    if hit is not None:
        point: Array = clouds[hit.line][hit.index]
        return point
    total = sum(map(len, clouds.values()))
    share = min(1.0, MAX_CENTRAL_SAMPLE / max(total, 1))
    parts = [points[: int(np.ceil(share * len(points)))] for points in clouds.values()]
    sample = np.concatenate([np.empty((0, 3)), *parts])
    offsets = np.abs(camera.project(sample, size)[:, :2] - middle)  # NaN behind the camera
    inside = np.flatnonzero((offsets <= middle).all(axis=1))
    if not len(inside):
        return None
    nearest: Array = sample[inside[np.argmin(np.hypot(*offsets[inside].T))]]
    return nearest


def _surround_cursor(pixels: Array) -> bool:
    """Whether points, by their offsets from the cursor of shape (n, 2), lie on all its sides."""
    if len(pixels) < MIN_SURROUNDING_POINTS:
        return False
    angles = np.sort(np.arctan2(pixels[:, 1], pixels[:, 0]))
    gaps = np.diff(angles, append=angles[0] + 2 * np.pi)
    return bool(gaps.max() < np.pi)


def _points_near_pixel(
    points: Array, camera: Camera, x: float, y: float, size: ViewportSize, radius: float
) -> tuple[NDArray[np.int64], Array, Array]:
    """Index, offset in pixels and depth of the points within ``radius`` pixels."""
    position, axes, focal = camera.position, camera.axes, size.pixels_per_tangent
    right, up = camera.ray_slopes(x, y, size)
    # Signed offsets from the ray are linear functions of a point, so that two products exclude
    # nearly all points.
    if camera.parallel:
        across, lateral = axes.T, np.array([right, up, 0.0]) * camera.distance
    else:
        across = np.column_stack([axes[0] - right * axes[2], axes[1] - up * axes[2], axes[2]])
        lateral = np.zeros(3)
    shift = position @ across + lateral
    indices, pixel_offsets, depths = [], [], []
    for start in range(0, len(points), CHUNK_POINTS):
        offsets = points[start : start + CHUNK_POINTS] @ across - shift
        reach = camera.scale_depth(offsets[:, 2]) * (radius / focal)
        near = np.flatnonzero((np.abs(offsets[:, 0]) <= reach) & (np.abs(offsets[:, 1]) <= reach))
        near = near[offsets[near, 2] > 0.0]
        close = offsets[near]
        pixels = close[:, :2] * np.atleast_1d(focal / camera.scale_depth(close[:, 2]))[:, None]
        inside = np.hypot(*pixels.T) <= radius
        indices.append(near[inside] + start)
        pixel_offsets.append(pixels[inside])
        depths.append(close[inside, 2])
    if not indices:
        return np.empty(0, np.int64), np.empty((0, 2)), np.empty(0)
    return np.concatenate(indices), np.concatenate(pixel_offsets), np.concatenate(depths)
