"""Coarse search for all flat patches of a cloud by region growing.

A plane through the neighbours of each point gives its normal. Regions grow from the flattest points
to neighbours that lie on the plane of the region and have a similar normal (Rabbani, van den Heuvel
and Vosselman 2006). `lispac.targets.plane_finder` then determines all points of a patch.
"""

from dataclasses import dataclass
from functools import cached_property
from math import cos, radians

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
from lispac.errors import PlaneNotFound
from lispac.geometry.local_planes import local_planes, planes_of_groups
from lispac.geometry.planes import Plane, extent_in_plane, plane_axes
from lispac.geometry.point_groups import sort_by_group
from lispac.geometry.point_tree import PointTree
from lispac.geometry.radius_search import cell_keys, finite_bounds
from lispac.messages import error
from lispac.targets import outline

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

# Number of points from which a normal is computed: a square of four by four without its corners.
NEIGHBOURS_PER_NORMAL = 12
# Smallest cosine of the angle between the normals of a neighbour and of the region.
MIN_NORMAL_COSINE = cos(radians(20.0))
# Smallest side of a voxel, in thresholds. In smaller voxels, noise dominates the normals.
MIN_VOXEL_THRESHOLDS = 1.7


@dataclass(frozen=True, eq=False)
class FlatPatch:
    """A flat patch of a thinned cloud.

    Attributes
    ----------
    points : ndarray of shape (n, 3), metres, local frame
        One point in each voxel.
    indices : ndarray of shape (n,), int
        Indices of the points in the thinned cloud, ascending.
    plane : Plane
    placed : ndarray of shape (n, 2), metres
        Coordinates of the points within the plane, along `plane_axes`.
    area : float, square metres
        Area covered by the points.
    """

    points: Array
    indices: Indices
    plane: Plane
    placed: Array
    area: float

    @cached_property
    def centre(self) -> Array:
        """Mean of the points, shape (3,), metres, local frame."""
        return np.asarray(self.points.mean(axis=0))

    @property
    def extent(self) -> Array:
        """Width (level) and height (up the slope), shape (2,), metres."""
        return extent_in_plane(self.plane, self.points)


@dataclass(frozen=True, eq=False)
class FlatPatches:
    """Patches of a cloud, the largest first, and the patch of each point of the thinned cloud.

    Attributes
    ----------
    patches : tuple of FlatPatch
    thinned : ndarray of shape (n, 3), metres, local frame
    label : ndarray of shape (n,), int
        Index into ``patches``; -1 for points outside any patch.
    """

    patches: tuple[FlatPatch, ...]
    thinned: Array
    label: Indices


def voxel_side(threshold: float, finest: float = 0.04) -> float:
    """Side of the voxels for thinning a cloud, metres, at least ``finest``.

    Parameters
    ----------
    threshold, finest : float, metres
        Largest distance of a point from its patch, and smallest side of a voxel.
    """
    return max(finest, MIN_VOXEL_THRESHOLDS * threshold)


def find_flat_patches(
    points: Array, threshold: float, *, voxel: float | None = None, min_points: int = 12
) -> FlatPatches:
    """Find every flat patch.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
        Points with a coordinate that is not finite are ignored.
    threshold : float, metres
        Largest distance of a point from its patch.
    voxel : float, metres, optional
        Side of the voxels; the first point in each voxel is used. If omitted, `voxel_side` of the
        threshold.
    min_points : int
        Smallest number of points of the thinned cloud in a patch.
    """
    voxel = voxel or voxel_side(threshold)
    thinned = _thin_to_voxels(points, voxel)
    none = np.full(len(thinned), -1, dtype=np.int64)
    if len(thinned) < max(min_points, NEIGHBOURS_PER_NORMAL):
        return FlatPatches((), thinned, none)
    tree = PointTree(thinned)
    neighbours = tree.order[tree.neighbours(thinned, NEIGHBOURS_PER_NORMAL)[1]]
    centroids, normals = local_planes(thinned, neighbours)
    uneven = _neighbourhood_rms(thinned, neighbours, centroids, normals)
    order = np.argsort(uneven, kind="stable")
    # Points on a straight line have NaN, which is sorted last; they do not start a region.
    order = order[: np.count_nonzero(uneven <= threshold)]
    label, count = _grow_regions(
        thinned, neighbours, normals, order, threshold, MIN_NORMAL_COSINE, min_points
    )
    patches = _build_patches(thinned, label, count, voxel)
    ranked = sorted(range(count), key=lambda k: -patches[k].area)
    rank = np.empty(count + 1, dtype=np.int64)
    rank[ranked] = np.arange(count)
    rank[-1] = -1
    return FlatPatches(tuple(patches[k] for k in ranked), thinned, rank[label])


def _build_patches(thinned: Array, label: Indices, count: int, voxel: float) -> list[FlatPatch]:
    """Patches from the label of each point, all at once: a scene has thousands of them.

    Raises
    ------
    PlaneNotFound
        All points of a patch are on one straight line.
    """
    order, ends = sort_by_group(label, count)
    points = thinned[order]
    centres, normals = planes_of_groups(points, ends)
    if np.isnan(normals).any():
        raise PlaneNotFound(error("target.plane_on_line"))
    # As in `fit_plane`
    largest = np.take_along_axis(normals, np.abs(normals).argmax(axis=1)[:, None], axis=1)
    normals *= np.sign(largest)
    placed = np.empty((len(points), 2))
    starts = np.append(0, ends)
    ranges = [slice(*each) for each in zip(starts[:-1].tolist(), ends.tolist(), strict=True)]
    for own, normal in zip(ranges, normals, strict=True):
        np.matmul(points[own], plane_axes(normal).T, out=placed[own])
    # Twice the voxel: an oblique surface leaves some of the voxels empty.
    areas = outline.filled_areas(placed, ends, 2.0 * voxel).tolist()
    offsets = -(normals * centres).sum(axis=1)
    planes = map(Plane, normals, offsets.tolist())
    return [
        FlatPatch(points[own], order[own], plane, placed[own], area)
        for own, plane, area in zip(ranges, planes, areas, strict=True)
    ]


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
    """RMS distance of each neighbourhood from its plane; NaN where it has no plane."""
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
    min_cosine: float,
    min_points: int,
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
        head, tail, refit = 0, 1, NEIGHBOURS_PER_NORMAL
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
                if abs(off) <= threshold and abs(along) >= min_cosine:
                    label[there] = count
                    queue[tail] = there
                    tail += 1
            # Sums are relative to the seed: with large coordinates they would lose digits.
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
                refit = refit + max(NEIGHBOURS_PER_NORMAL, refit // 2)
        if tail < min_points:
            for i in range(tail):
                label[queue[i]] = -1
                tried[queue[i]] = True
        else:
            count += 1
    return label, count
