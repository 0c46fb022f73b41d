"""Plane fitted to the points of each line in each region of the scene.

All planes are computed at once from sums of coordinates and of their products. The fit is repeated
with weights that exclude points far from the plane.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
from lispac.geometry.point_groups import sort_by_group
from lispac.natural.flat_regions import Regions
from lispac.progress import Progress, no_progress, sub_progress
from lispac.survey.cloud import Cloud

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

MAX_LINE_POINTS = 300_000
"""Largest number of points of a line that are examined."""
MIN_REGION_POINTS = 20
"""Smallest number of points of a line in a region."""
MAX_DISTANCE_SIGMAS, MAX_DISTANCE_LIDAR_SIGMAS = 2.5, 2.0
"""Distance from the plane beyond which a point has no weight.

In standard deviations of the points of the plane, and in LiDAR sigmas; the larger one applies.
"""
FIT_ITERATIONS = 8
"""Number of iterations of the weighted fit."""
WEIGHTED_SIGMA_RATIO = 0.75
"""Ratio of the weighted standard deviation to the true one, for normally distributed noise."""


@dataclass(frozen=True, eq=False)
class LinePlanes:
    """Planes fitted to the points of each line in each region, sorted by region.

    Attributes
    ----------
    region, line : ndarray of shape (k,), int
        Number of the region, and index into the lines.
    begin, end : ndarray of shape (k,), int
        Range of the points of the plane in the ``numbers`` of `find_line_planes`.
    count : ndarray of shape (k,), int
        Number of examined points that lie on the plane.
    share : ndarray of shape (k,)
        Share of the line's points in the region that lie on the plane.
    centre : ndarray of shape (k, 3), metres, local frame
    normal : ndarray of shape (k, 3), unit vectors, local frame
        The component with the largest absolute value is positive.
    max_distance : ndarray of shape (k,), metres
        Largest distance of a point that counts as on the plane.
    roughness : ndarray of shape (k,), metres
        RMS distance of the points from the plane.
    width : ndarray of shape (k,), metres
        Weighted standard deviation of the points along the shorter axis within the plane.
    reach : ndarray of shape (k,), metres
        Distance of the farthest point from the centre.
    kurtosis : ndarray of shape (k,)
        Kurtosis of the distances from the plane: 3 for normal noise, 1 for two thin layers.
    time : ndarray of shape (k,), seconds
        Mean time of the points.
    """

    region: Indices
    line: Indices
    begin: Indices
    end: Indices
    count: Indices
    share: Array
    centre: Array
    normal: Array
    max_distance: Array
    roughness: Array
    width: Array
    reach: Array
    kurtosis: Array
    time: Array

    def __len__(self) -> int:
        return len(self.region)

    def where(self, keep: NDArray[np.bool_]) -> "LinePlanes":
        """Planes for which ``keep``, shape (k,), is true."""
        return LinePlanes(**{name: value[keep] for name, value in vars(self).items()})


def find_line_planes(
    clouds: Mapping[str, Cloud],
    noise: float,
    threshold: float,
    *,
    progress: Progress = no_progress,
) -> tuple[Regions, LinePlanes, Indices]:
    """Find the regions of a scene, and fit a plane to the points of each line in each region.

    Parameters
    ----------
    clouds : mapping of line name to Cloud
        At least one of them has a finite point.
    noise : float, metres
        Sigma of the LiDAR.
    threshold : float, metres
        Largest distance of a point of any line from its region.

    Returns
    -------
    regions : Regions
    planes : LinePlanes
    numbers : ndarray of shape (m,), int
        Indices of the points on the planes in the samples of their lines; see
        ``LinePlanes.begin``.
    """
    points, time, line, sampled = _sampled_points(clouds)
    progress(0.1)
    regions = Regions.of(points, threshold)
    progress(0.5)
    region = regions.at(points)
    on = np.flatnonzero(region >= 0)
    order, ends = sort_by_group(region[on] * len(clouds) + line[on], regions.count * len(clouds))
    counts = np.diff(ends, prepend=0)
    enough = counts >= MIN_REGION_POINTS
    order, keys, counts = order[np.repeat(enough, counts)], np.flatnonzero(enough), counts[enough]
    owner = np.repeat(np.arange(len(counts)), counts)
    order = on[order]
    found, times = points[order], time[order]
    # Coordinates relative to a point of the region: sums of large coordinates would lose digits.
    origin = found[np.cumsum(counts) - counts]
    local = found - origin[owner]
    centre, normal, limit, variances = _fit_densest_planes(
        local, np.cumsum(counts), noise, sub_progress(progress, 0.6, 1.0)
    )
    kept, sums = np.empty(len(local), dtype=np.bool_), np.zeros((len(counts), 5))
    _plane_statistics(local, times, np.cumsum(counts), centre, normal, limit, kept, sums)
    number = sums[:, 0].astype(np.int64)
    divisor = np.maximum(number, 1)
    roughness = np.sqrt(np.maximum(sums[:, 1] / divisor, 1e-12))
    largest = np.take_along_axis(normal, np.abs(normal).argmax(axis=1)[:, None], axis=1)
    ends = np.cumsum(number)
    planes = LinePlanes(
        region=keys // len(clouds),
        line=keys % len(clouds),
        begin=ends - number,
        end=ends,
        count=number,
        share=number / np.maximum(counts, 1),
        centre=centre + origin,
        normal=normal * np.sign(largest),
        max_distance=limit,
        roughness=roughness,
        width=np.sqrt(np.maximum(variances[:, 1], 0.0)),
        reach=sums[:, 3],
        kurtosis=sums[:, 2] / divisor / roughness**4,
        time=sums[:, 4] / divisor,
    )
    return regions, planes, sampled[order[kept]]


def _sampled_points(
    clouds: Mapping[str, Cloud],
) -> tuple[Array, Array, NDArray[np.intp], NDArray[np.intp]]:
    """Finite points of all samples, at most `MAX_LINE_POINTS` of each line.

    Returns
    -------
    points : ndarray of shape (n, 3), metres, local frame
    time : ndarray of shape (n,), seconds
    line : ndarray of shape (n,), int
        Number of the line of each point.
    sampled : ndarray of shape (n,), int
        Index of each point in the sample of its line.
    """
    chosen = [
        np.arange(0, len(c.sample), -(-len(c.sample) // MAX_LINE_POINTS) or 1)
        for c in clouds.values()
    ]
    points = np.concatenate([c.sample[k] for c, k in zip(clouds.values(), chosen, strict=True)])
    time = np.concatenate([c.sample_time[k] for c, k in zip(clouds.values(), chosen, strict=True)])
    line = np.repeat(np.arange(len(chosen)), [len(k) for k in chosen])
    sampled = np.concatenate(chosen)
    finite = np.isfinite(points).all(axis=1)
    return points[finite], time[finite], line[finite], sampled[finite]


def _fit_densest_planes(
    points: Array, ends: NDArray[np.intp], noise: float, progress: Progress
) -> tuple[Array, Array, Array, Array]:
    """Fit a plane to the densest layer of each group of points.

    With the biweight (Beaton and Tukey 1974) a plane converges to the densest layer.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres
        Points of one group after the other, relative to a point of their group.
    ends : ndarray of shape (k,), int
        Index after the last point of each group.
    noise : float, metres

    Returns
    -------
    centre, normal : ndarrays of shape (k, 3)
    limit : ndarray of shape (k,), metres
        Distance from which points have no weight.
    variances : ndarray of shape (k, 3), square metres
        Along the axes of each group, the smallest first.
    """
    centre, normal = np.zeros((len(ends), 3)), np.zeros((len(ends), 3))
    limit = np.full(len(ends), np.inf)
    variances = np.zeros((len(ends), 3))
    for iteration in range(FIT_ITERATIONS):
        progress(iteration / FIT_ITERATIONS)
        centre, variances, axes = fit_weighted_planes(points, ends, centre, normal, limit)
        normal = np.ascontiguousarray(axes[:, :, 0])
        roughness = np.sqrt(np.maximum(variances[:, 0], 1e-12)) / np.where(
            np.isinf(limit), 1.0, WEIGHTED_SIGMA_RATIO
        )
        limit = np.minimum(
            limit, np.maximum(MAX_DISTANCE_SIGMAS * roughness, MAX_DISTANCE_LIDAR_SIGMAS * noise)
        )
    return centre, normal, limit, variances


def fit_weighted_planes(
    points: Array, ends: Indices, centre: Array, normal: Array, far: Array
) -> tuple[Array, Array, Array]:
    """Fit planes with weights from the distances to the planes of the previous iteration.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
        Points of all planes, sorted by plane.
    ends : ndarray of shape (k,), int
        Index after the last point of each plane.
    centre, normal : ndarray of shape (k, 3), metres and unit vectors, local frame
        Planes of the previous iteration.
    far : ndarray of shape (k,), metres
        Distance beyond which a point has no weight; if infinite, all points have equal weights.

    Returns
    -------
    centre : ndarray of shape (k, 3), metres, local frame
    variances : ndarray of shape (k, 3), square metres
        Variances of the points along the axes, ascending.
    axes : ndarray of shape (k, 3, 3), unit vectors, local frame
        Principal axes in columns; the first is the normal.
    """
    total, moments = np.empty(len(ends)), np.empty((len(ends), 9))
    _weighted_moments(points, ends, centre, normal, far, total, moments)
    moments /= np.maximum(total, 1e-9)[:, None]
    centre, xx, xy, xz, yy, yz, zz = moments[:, :3], *moments[:, 3:].T
    products = np.stack([xx, xy, xz, xy, yy, yz, xz, yz, zz], axis=1).reshape(-1, 3, 3)
    variances, axes = np.linalg.eigh(products - centre[:, :, None] * centre[:, None, :])
    return np.ascontiguousarray(centre), variances, axes


@njit(nogil=True, cache=True, error_model="numpy")
def _weighted_moments(points, ends, centre, normal, far, total, moments):  # type: ignore[no-untyped-def]
    """Sum the weights, and the weighted coordinates and their products, for each plane.

    Compiled, because array operations on all points for the distances and weights were slower.
    """
    begin = 0
    for k in range(len(ends)):
        cx, cy, cz = centre[k]
        nx, ny, nz = normal[k]
        s = sx = sy = sz = xx = xy = xz = yy = yz = zz = 0.0
        for i in range(begin, ends[k]):
            x, y, z = points[i]
            off = ((x - cx) * nx + (y - cy) * ny + (z - cz) * nz) / far[k]
            w = max(1.0 - off * off, 0.0) ** 2
            wx, wy, wz = w * x, w * y, w * z
            s, sx, sy, sz = s + w, sx + wx, sy + wy, sz + wz
            xx, xy, xz = xx + wx * x, xy + wx * y, xz + wx * z
            yy, yz, zz = yy + wy * y, yz + wy * z, zz + wz * z
        total[k] = s
        moments[k] = (sx, sy, sz, xx, xy, xz, yy, yz, zz)
        begin = ends[k]


@njit(nogil=True, cache=True, error_model="numpy")
def _plane_statistics(points, times, ends, centre, normal, limit, kept, sums):  # type: ignore[no-untyped-def]
    """Mark the points within ``limit`` of their plane in ``kept``, and write statistics of them.

    The columns of ``sums`` are the number of points, the sums of the second and fourth powers of
    their distances from the plane, their largest distance from the centre, and the sum of times.
    """
    begin = 0
    for k in range(len(ends)):
        for i in range(begin, ends[k]):
            x, y, z = (
                points[i, 0] - centre[k, 0],
                points[i, 1] - centre[k, 1],
                points[i, 2] - centre[k, 2],
            )
            off = x * normal[k, 0] + y * normal[k, 1] + z * normal[k, 2]
            kept[i] = abs(off) < limit[k]
            if kept[i]:
                square = off * off
                sums[k, 0] += 1.0
                sums[k, 1] += square
                sums[k, 2] += square * square
                sums[k, 3] = max(sums[k, 3], np.sqrt(x * x + y * y + z * z))
                sums[k, 4] += times[i]
        begin = ends[k]
