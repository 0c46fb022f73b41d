"""All the flat patches of a cloud: local planes grown into each other's neighbourhood.

A coarse search for planes. Each point's plane through its neighbours gives its
direction; regions grow from the flattest points over neighbours that lie on the region's plane and
face as it does (Rabbani, van den Heuvel and Vosselman 2006). Where a patch is needed to the last
point, `lispac.targets.plane_finder` takes it from there.
"""

from dataclasses import dataclass
from math import cos, radians

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
from lispac.geometry.nearest_neighbours import build_tree, local_planes
from lispac.geometry.planes import Plane, extent_in_plane, fit_plane, plane_axes
from lispac.geometry.radius_search import cell_keys, finite_bounds
from lispac.targets import outline

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

# Neighbours whose plane is a point's own: a square of four by four points, less its corners.
NEIGHBOURS = 12
# Most a neighbour's plane may be turned from the region's.
TURN = cos(radians(20.0))
# A voxel must be so many thresholds wide, or noise decides where local planes face.
WIDE = 1.7


@dataclass(frozen=True, eq=False)
class FlatPatch:
    """A flat patch of a thinned cloud.

    Attributes
    ----------
    points : ndarray of shape (n, 3), metres, local frame
        One of each voxel.
    plane : Plane
    centre : ndarray of shape (3,), metres, local frame
        Of the points.
    extent : ndarray of shape (2,), metres
        Width (level) and height (up the slope).
    area : float, square metres
        That the points cover.
    """

    points: Array
    plane: Plane
    centre: Array
    extent: Array
    area: float


@dataclass(frozen=True, eq=False)
class FlatPatches:
    """The patches of a cloud, the largest first, and the patch of each thinned point.

    Attributes
    ----------
    patches : tuple of FlatPatch
    thinned : ndarray of shape (n, 3), metres, local frame
    label : ndarray of shape (n,), int
        Index into ``patches``, -1 for none.
    """

    patches: tuple[FlatPatch, ...]
    thinned: Array
    label: Indices


def voxel_side(threshold: float, finest: float = 0.04) -> float:
    """Side of the voxels that a cloud with such noise may be thinned to, metres."""
    return max(finest, WIDE * threshold)


def find_flat_patches(
    points: Array, threshold: float, *, voxel: float | None = None, least: int = 12
) -> FlatPatches:
    """Find every flat patch.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
        Points with a missing coordinate are passed over.
    threshold : float, metres
        Farthest a point may lie from its patch.
    voxel : float, metres, optional
        Of several points in one voxel the first stands for all; `voxel_side` the threshold where
        not given.
    least : int
        Smallest patch, in thinned points.
    """
    voxel = voxel or voxel_side(threshold)
    thinned = _thin_to_voxels(points, voxel)
    none = np.full(len(thinned), -1, dtype=np.int64)
    if len(thinned) < max(least, NEIGHBOURS):
        return FlatPatches((), thinned, none)
    _, neighbours = build_tree(thinned).query(thinned, NEIGHBOURS, workers=1)
    neighbours = np.ascontiguousarray(neighbours, dtype=np.int64)
    centroids, normals = local_planes(thinned, neighbours)
    uneven = _neighbourhood_rms(thinned, neighbours, centroids, normals)
    order = np.argsort(uneven, kind="stable")
    # NaN, of straight rows of points, comes last and is no beginning.
    order = order[: np.count_nonzero(uneven <= threshold)]
    label, count = _grow_regions(thinned, neighbours, normals, order, threshold, TURN, least)
    patches = [_build_patch(thinned[label == k], voxel) for k in range(count)]
    ranked = sorted(range(count), key=lambda k: -patches[k].area)
    rank = np.empty(count + 1, dtype=np.int64)
    rank[ranked] = np.arange(count)
    rank[-1] = -1
    return FlatPatches(tuple(patches[k] for k in ranked), thinned, rank[label])


def _build_patch(points: Array, voxel: float) -> FlatPatch:
    plane = fit_plane(points)
    placed = points @ plane_axes(plane.normal).T
    # Twice the voxel: a sheet that runs through voxels askew leaves some of them empty.
    area = outline.filled_area(placed, 2.0 * voxel)
    return FlatPatch(points, plane, points.mean(axis=0), extent_in_plane(plane, points), area)


def _thin_to_voxels(points: Array, voxel: float) -> Array:
    """The first point of every voxel."""
    finite = points[np.isfinite(points).all(axis=1)]
    if len(finite) == 0:
        return finite
    key, _ = cell_keys(finite, finite_bounds(finite)[0], voxel)
    _, first = np.unique(key, return_index=True)
    return np.ascontiguousarray(finite[first])


@njit(nogil=True, cache=True)
def _neighbourhood_rms(
    points: Array, neighbours: Indices, centroids: Array, normals: Array
) -> Array:  # pragma: no cover - compiled
    """RMS distance of each neighbourhood to its plane; NaN where it has none."""
    rms = np.empty(len(points))
    for i in range(len(points)):
        total = 0.0
        for j in neighbours[i]:
            off = 0.0
            for k in range(3):
                off += (points[j, k] - centroids[i, k]) * normals[i, k]
            total += off * off
        rms[i] = np.sqrt(total / neighbours.shape[1])
    return rms


@njit(nogil=True, cache=True)
def _grow_regions(
    points: Array,
    neighbours: Indices,
    normals: Array,
    order: Indices,
    threshold: float,
    turn: float,
    least: int,
) -> tuple[Indices, int]:  # pragma: no cover - compiled
    n = len(points)
    label = np.full(n, -1, np.int64)
    tried = np.zeros(n, np.bool_)
    queue = np.empty(n, np.int64)
    normal, centre = np.empty(3), np.empty(3)
    sums, products = np.empty(3), np.empty((3, 3))
    count = 0
    for seed in order:
        if label[seed] >= 0 or tried[seed]:
            continue
        normal[:] = normals[seed]
        centre[:] = points[seed]
        sums[:] = 0.0
        products[:] = 0.0
        label[seed] = count
        queue[0] = seed
        head, tail, refit = 0, 1, NEIGHBOURS
        while head < tail:
            here = queue[head]
            head += 1
            for there in neighbours[here]:
                if label[there] >= 0:
                    continue
                off, along = 0.0, 0.0
                for k in range(3):
                    off += (points[there, k] - centre[k]) * normal[k]
                    along += normals[there, k] * normal[k]
                if abs(off) <= threshold and abs(along) >= turn:
                    label[there] = count
                    queue[tail] = there
                    tail += 1
            # Sums are counted from the seed: at large coordinates they would lose digits.
            for k in range(3):
                a = points[here, k] - points[seed, k]
                sums[k] += a
                for m in range(3):
                    products[k, m] += a * (points[here, m] - points[seed, m])
            if head >= refit:
                mean = sums / head
                scatter = products / head - np.outer(mean, mean)
                _, axes = np.linalg.eigh(scatter)
                normal[:] = axes[:, 0]
                centre[:] = mean + points[seed]
                refit = refit + max(NEIGHBOURS, refit // 2)
        if tail < least:
            for i in range(tail):
                label[queue[i]] = -1
                tried[queue[i]] = True
        else:
            count += 1
    return label, count
