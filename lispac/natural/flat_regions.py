"""Regions: flat surfaces of a scene, divided into pieces of a few metres.

A flat surface is first grown as far as it extends, and only large surfaces are then divided. Many
small pieces of one surface would not be independent observations, since systematic effects of the
material (glass, paint) are the same all over it.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.radius_search import finite_bounds
from lispac.targets.flat_patches import find_flat_patches, voxel_side

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

MAX_PIECE_SIDE = 4.0
"""Largest side of the pieces into which a surface is divided, metres."""
MIN_VOXEL_SIDE = 0.08
"""Smallest side of the voxels, metres."""
MIN_SURFACE_AREA = 0.2
"""Smallest area of a surface, square metres."""
BITS_PER_AXIS = 21
"""Number of bits of the index along each axis in the key of a voxel."""


@dataclass(frozen=True, eq=False)
class Regions:
    """Assignment of the voxels of the scene to regions.

    Attributes
    ----------
    low : ndarray of shape (3,), metres, local frame
        Lowest corner of the voxel grid.
    voxel : float, metres
        Side of the voxels.
    keys : ndarray of shape (m,), int
        Keys of the voxels that belong to a region, ascending.
    region : ndarray of shape (m,), int
        Number of the region of each of these voxels.
    count : int
        Number of regions.
    """

    low: Array
    voxel: float
    keys: Indices
    region: Indices
    count: int

    @classmethod
    def of(cls, points: Array, threshold: float) -> "Regions":
        """Find the regions of a scene.

        Parameters
        ----------
        points : ndarray of shape (n, 3), metres, local frame
            Points of all lines, finite.
        threshold : float, metres
            Largest distance of a point from its surface.
        """
        low, voxel = finite_bounds(points)[0], max(MIN_VOXEL_SIDE, voxel_side(threshold))
        flat = find_flat_patches(points, threshold, voxel=voxel)
        region = np.full(len(flat.thinned), -1, dtype=np.int64)
        count = 0
        for patch in flat.patches:
            if patch.area < MIN_SURFACE_AREA:
                break
            pieces, number = _split_into_pieces(patch.placed)
            region[patch.indices] = count + pieces
            count += number
        found = np.flatnonzero(region >= 0)
        keys = _voxel_keys(flat.thinned[found], low, voxel)
        keys, first = np.unique(keys, return_index=True)
        return cls(low, voxel, keys, region[found][first], count)

    def at(self, points: Array) -> Indices:
        """Number of the region of each point, shape (n,); -1 for none.

        Parameters
        ----------
        points : ndarray of shape (n, 3), metres, local frame
        """
        if not len(self.keys):
            return np.full(len(points), -1, dtype=np.int64)
        keys = _voxel_keys(points, self.low, self.voxel)
        place = np.minimum(np.searchsorted(self.keys, keys), len(self.keys) - 1)
        return np.where(self.keys[place] == keys, self.region[place], -1)


def _split_into_pieces(along: Array) -> tuple[Indices, int]:
    """Divide a surface into pieces: number of the piece of each point, from 0, and of pieces.

    ``along`` are the coordinates within the surface, shape (n, 2), metres. Each side is divided
    into the smallest number of equal parts that are no longer than
    `MAX_PIECE_SIDE`.
    """
    low, high = finite_bounds(along)
    span = high - low
    pieces = np.maximum(1, np.ceil(span / MAX_PIECE_SIDE)).astype(np.int64)
    if pieces.max() == 1:
        return np.zeros(len(along), dtype=np.int64), 1
    cell = np.minimum(
        ((along - low) / np.maximum(span, 1e-9) * pieces).astype(np.int64), pieces - 1
    )
    filled, piece = np.unique(cell[:, 0] * pieces[1] + cell[:, 1], return_inverse=True)
    return piece.reshape(-1), len(filled)


def _voxel_keys(points: Array, low: Array, voxel: float) -> Indices:
    """Integer key of the voxel of each point; -1 for points outside the grid."""
    place = np.floor((points - low) / voxel)
    with np.errstate(invalid="ignore"):
        inside = ((place >= 0) & (place < 2**BITS_PER_AXIS)).all(axis=1)
    x, y, z = np.where(inside[:, None], place, 0).astype(np.int64).T
    return np.where(inside, (x << 2 * BITS_PER_AXIS) | (y << BITS_PER_AXIS) | z, -1)
