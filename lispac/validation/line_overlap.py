"""Points of a line that can be compared with another line, and the point spacing of the lines.

A point of one line can be compared with another line only where that line also has points. Beyond
the edge of these points, or in a hole (a door, a ladder in front), the distance would be that to
the edge, not to the surface.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Bools = NDArray[np.bool_]
_TRIANGULATED_POINTS = 20_000
"""Largest number of points that are all triangulated. Of more points, some regions are."""
_REGIONS, _POINTS_PER_REGION = 3, 1_500
"""Number of regions of a line with more points, and number of points in each."""
_GAP_SHARE = 0.05
"""Share of the triangles of a region, the largest ones, that may span gaps between the points."""
_MAX_CELLS = 4e6
"""Approximate largest number of cells of a footprint."""
_RIM_CELLS = 3
"""Number of empty cells around the points of a footprint."""


class _Footprint:
    """The region of a plane that a set of points covers, as cells of a grid.

    Points of a LiDAR on a vessel are dense along a profile and sparse across it, so the side of a
    cell has to be the spacing of the profiles. It is determined from the longest sides of the
    triangles in a triangulation of the points, which connects neighbouring profiles. Holes up to
    two cells wide occur by chance and are closed. The outline is accurate to one cell, that is to
    one spacing.

    Parameters
    ----------
    points : ndarray of shape (n, 2), metres, in the plane
    spacing : float or None, metres
        From `_sparse_spacing`; without it, nothing is covered.

    Attributes
    ----------
    cell : float, metres
    """

    def __init__(self, points: Array, spacing: float | None) -> None:
        self._covered = np.zeros((1, 1), dtype=bool)
        self._low, self.cell = np.zeros(2), 1.0
        if spacing is None:
            return
        from scipy.ndimage import binary_closing

        low, high = points.min(axis=0), points.max(axis=0)
        self.cell = max(spacing, float(np.sqrt(np.prod(high - low) / _MAX_CELLS)))
        # The morphological closing needs a rim of empty cells, which also take all points outside.
        self._low = low - _RIM_CELLS * self.cell
        shape = np.floor((high - self._low) / self.cell).astype(np.int64) + 1 + _RIM_CELLS
        occupied = np.zeros(shape, dtype=bool)
        column, row = np.floor((points - self._low) / self.cell).astype(np.int64).T
        occupied[column, row] = True
        self._covered = binary_closing(occupied, structure=np.ones((3, 3), dtype=bool))

    def contains(self, points: Array) -> NDArray[np.bool_]:
        """Whether each of ``points`` (n, 2), metres, lies inside; shape (n,)."""
        cells = np.floor((points - self._low) / self.cell)
        last = np.array(self._covered.shape) - 1
        column, row = np.clip(cells, 0, last).astype(np.int64).T
        inside: NDArray[np.bool_] = self._covered[column, row]
        return inside


class LineOverlap:
    """Masks of the points of one line inside the footprint of another, before and after.

    Parameters
    ----------
    before, after : mapping of line name to ndarray of shape (n, 3), metres, local frame
        The same points in the same order.
    """

    def __init__(self, before: Mapping[str, Array], after: Mapping[str, Array]) -> None:
        flats: list[dict[str, Array]] = []
        for clouds in (before, after):
            origin, axes = _common_plane_frame(list(clouds.values()))
            flats.append({line: (cloud - origin) @ axes.T for line, cloud in clouds.items()})
        # The boresight hardly changes the spacing of the points of one line.
        spacings = {line: _sparse_spacing(points) for line, points in flats[-1].items()}
        self._states = [
            (flat, {line: _Footprint(points, spacings[line]) for line, points in flat.items()})
            for flat in flats
        ]
        self.normal: Array = np.cross(axes[0], axes[1])
        """Normal of the plane after the calibration, shape (3,), of either sign."""

    def of(self, line: str, other: str) -> Bools:
        """Whether each point of ``line`` overlaps ``other`` in both states, shape (n,), bool."""
        masks = [footprints[other].contains(flat[line]) for flat, footprints in self._states]
        both: Bools = masks[0] & masks[1]
        return both

    def spacing(self, *lines: str) -> float:
        """Point spacing of the sparsest line in its sparse direction, metres."""
        return max(self._states[-1][1][line].cell for line in lines)


def _common_plane_frame(patches: list[Array]) -> tuple[Array, Array]:
    """Origin (3,), metres, and axes (2, 3) of a plane parallel to several patches.

    Parameters
    ----------
    patches : list of ndarray of shape (n, 3), metres

    Notes
    -----
    Each patch is first reduced to its own centre: patches that are far apart before the
    calibration would tilt a plane fitted to all points at once.
    """
    origin = np.mean([patch.mean(axis=0) for patch in patches], axis=0)
    scatter = np.zeros((3, 3))
    for patch in patches:
        centred = patch - patch.mean(axis=0)
        scatter += centred.T @ centred / len(patch)
    _, vectors = np.linalg.eigh(scatter)
    return origin, np.ascontiguousarray(vectors[:, [2, 1]].T)


def _sparse_spacing(points: Array) -> float | None:
    """Point spacing of a line in its sparse direction, metres; None without triangles.

    The median of the longest sides of the triangles between the points; for more than
    `_TRIANGULATED_POINTS`, that of the area between the points of some regions.
    """
    if len(points) > _TRIANGULATED_POINTS:
        return _spacing_in_regions(points)
    sides = _longest_sides(points)
    return None if sides is None else float(np.median(sides[0]))


def _spacing_in_regions(points: Array) -> float | None:
    """Median of the longest sides, weighted by the areas of the triangles of some regions, metres.

    Where the scatter of the points is not small against their distance along a profile, most
    triangles connect points of one profile, but most of the area is between the profiles. Holes and
    gaps may have a larger area than the surface; their triangles are few and are excluded.
    """
    sides, areas = [], []
    for k in range(_REGIONS):
        middle = points[(2 * k + 1) * len(points) // (2 * _REGIONS)]
        distance = ((points - middle) ** 2).sum(axis=1)
        near = np.argpartition(distance, _POINTS_PER_REGION)[:_POINTS_PER_REGION]
        found = _longest_sides(points[near])
        if found is not None:
            sides.append(found[0])
            areas.append(found[1])
    if not sides:
        return None
    every, weights = np.concatenate(sides), np.concatenate(areas)
    order = np.argsort(every, kind="stable")[: len(every) - int(_GAP_SHARE * len(every))]
    total = np.cumsum(weights[order])
    return float(every[order][np.searchsorted(total, total[-1] / 2)])


def _longest_sides(points: Array) -> tuple[Array, Array] | None:
    """Longest side and area of each triangle between points, metres; None without triangles."""
    from scipy.spatial import Delaunay, QhullError

    try:
        triangles = Delaunay(points).simplices
    except QhullError:  # fewer than three points, or all on one straight line
        return None
    corners = points[triangles]
    edges = corners - np.roll(corners, 1, axis=1)
    areas = np.abs(edges[:, 0, 0] * edges[:, 1, 1] - edges[:, 0, 1] * edges[:, 1, 0]) / 2
    return np.linalg.norm(edges, axis=2).max(axis=1), areas
