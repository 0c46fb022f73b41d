"""Points of a line that are comparable with another line, and sparsity of the lines.

A point of one line can be compared with another line only where that line has points too. Beyond
its edge, or in a hole (a door, a ladder in front), a distance would measure the edge and not the
surface.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Bools = NDArray[np.bool_]
# Enough points to know their spacing, and quick to triangulate.
_TRIANGULATED_POINTS = 20_000
_MAX_CELLS = 4e6
_RIM = 3


class _Footprint:
    """The region of a plane that a set of points covers, as cells of a grid.

    Profiles of a vessel LiDAR are dense along and sparse across, so the side of a cell must be
    the sparse spacing: a triangulation of the points reaches from one profile to the next, and
    the longest side of its usual triangle measures that. Holes up to two cells wide are chance
    and get closed; the outline is true to one cell, which is to one spacing of the points.

    Parameters
    ----------
    points : ndarray of shape (n, 2), metres, in the plane

    Attributes
    ----------
    cell : float, metres
    """

    def __init__(self, points: Array) -> None:
        self._covered = np.zeros((1, 1), dtype=bool)
        self._low, self.cell = np.zeros(2), 1.0
        spacing = _sparse_spacing(points)
        if spacing is None:
            return
        from scipy.ndimage import binary_closing

        low, high = points.min(axis=0), points.max(axis=0)
        self.cell = max(spacing, float(np.sqrt(np.prod(high - low) / _MAX_CELLS)))
        # A rim of empty cells gives the closing room, and a home to every point outside.
        self._low = low - _RIM * self.cell
        shape = np.floor((high - self._low) / self.cell).astype(np.int64) + 1 + _RIM
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
    """Which points of one line lie inside another line's footprint in both states.

    Parameters
    ----------
    before, after : mapping of line name to ndarray of shape (n, 3), metres, local frame
        The same points in the same order.
    """

    def __init__(self, before: Mapping[str, Array], after: Mapping[str, Array]) -> None:
        self._states: list[tuple[dict[str, Array], dict[str, _Footprint]]] = []
        for clouds in (before, after):
            origin, axes = _common_plane_frame(list(clouds.values()))
            flat = {line: (cloud - origin) @ axes.T for line, cloud in clouds.items()}
            self._states.append((flat, {line: _Footprint(uv) for line, uv in flat.items()}))
        self.normal: Array = np.cross(axes[0], axes[1])
        """Of the plane after, shape (3,), of either sign."""

    def of(self, line: str, other: str) -> Bools:
        """Mask (n,) over the points of ``line``."""
        masks = [footprints[other].contains(flat[line]) for flat, footprints in self._states]
        both: Bools = masks[0] & masks[1]
        return both

    def spacing(self, *lines: str) -> float:
        """Distance between neighbouring points where they are sparse, of the sparsest, metres."""
        return max(self._states[-1][1][line].cell for line in lines)


def _common_plane_frame(patches: list[Array]) -> tuple[Array, Array]:
    """Origin (3,), metres, and axes (2, 3) of the plane along which several patches lie.

    Parameters
    ----------
    patches : list of ndarray of shape (n, 3), metres

    Notes
    -----
    Each patch is centred on itself first: patches far apart (before the calibration) would tilt
    a plane fitted through all of them at once.
    """
    origin = np.mean([patch.mean(axis=0) for patch in patches], axis=0)
    scatter = np.zeros((3, 3))
    for patch in patches:
        centred = patch - patch.mean(axis=0)
        scatter += centred.T @ centred / len(patch)
    _, vectors = np.linalg.eigh(scatter)
    return origin, np.ascontiguousarray(vectors[:, [2, 1]].T)


def _sparse_spacing(points: Array) -> float | None:
    """Longest side of the usual triangle between the points, metres; None where there is none."""
    from scipy.spatial import Delaunay, QhullError

    step = -(-len(points) // _TRIANGULATED_POINTS)
    outline = points[:: max(step, 1)]
    try:
        triangles = Delaunay(outline).simplices
    except QhullError:  # fewer than three points, or all in one row: they cover no area
        return None
    corners = outline[triangles]
    sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    return float(np.median(sides.max(axis=1)))
