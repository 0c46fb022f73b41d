"""Plane of each line in each region of the scene.

Sums of products give a plane without reading its points one by one; a second and a third pass
exclude the points far from it.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.natural.flat_regions import Regions
from lispac.natural.plane_fitting import fit_weighted_planes
from lispac.progress import Progress, no_progress
from lispac.survey.cloud import Cloud

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

LINE_POINTS = 300_000
"""Points of a line that are examined: enough to find its planes."""
MIN_POINTS = 20
"""Points of a line that a region must hold."""
OUTLIER_SIGMAS, LIDAR_SIGMAS = 2.5, 2.0
"""Standard deviations of its plane's points, and LiDAR sigmas, that a point without weight lies
off: the larger of both."""
ITERATIONS = 8
SHRUNK = 0.75
"""Standard deviation of normal noise estimated with these weights, over the true one."""


@dataclass(frozen=True, eq=False)
class LinePlanes:
    """Planes fitted to the points of single lines in each region, one row each, sorted by region.

    Attributes
    ----------
    region, line : ndarray of shape (k,), int
        Number of the region, and index into the lines.
    begin, end : ndarray of shape (k,), int
        Where its points stand in the numbers that `find_line_planes` gives.
    count : ndarray of shape (k,), int
        Points on the plane, of those that are examined.
    share : ndarray of shape (k,)
        Of the points in the region's voxels that are on the plane.
    centre : ndarray of shape (k, 3), metres, local frame
    normal : ndarray of shape (k, 3), unit vectors, local frame
        Their largest components are positive.
    far : ndarray of shape (k,), metres
        Farthest that a point on it lies off.
    rough : ndarray of shape (k,), metres
        RMS distance of the points from the plane.
    width : ndarray of shape (k,), metres
        Standard deviation of the points along the shorter axis within the plane.
    reach : ndarray of shape (k,), metres
        Distance of the farthest point from the centre.
    peaked : ndarray of shape (k,)
        Kurtosis of the distances: 3 of normal noise, 1 of two layers.
    time : ndarray of shape (k,), seconds
        In the mean.
    """

    region: Indices
    line: Indices
    begin: Indices
    end: Indices
    count: Indices
    share: Array
    centre: Array
    normal: Array
    far: Array
    rough: Array
    width: Array
    reach: Array
    peaked: Array
    time: Array

    def __len__(self) -> int:
        return len(self.region)

    def where(self, keep: NDArray[np.bool_]) -> "LinePlanes":
        """Some of the planes, ``keep`` of shape (k,)."""
        return LinePlanes(**{name: value[keep] for name, value in vars(self).items()})


def find_line_planes(
    clouds: Mapping[str, Cloud],
    noise: float,
    threshold: float,
    *,
    progress: Progress = no_progress,
) -> tuple[Regions, LinePlanes, Indices]:
    """The regions of a scene, the planes that all lines see of them, and the points on these.

    Parameters
    ----------
    clouds : mapping of line name to Cloud
        At least one of them with a finite point.
    noise : float, metres
        Sigma of the LiDAR.
    threshold : float, metres
        Farthest a point of any line may lie from its region.

    Returns
    -------
    regions : Regions
    planes : LinePlanes
    numbers : ndarray of shape (m,), int
        Places of the points in the samples of their lines.
    """
    chosen = [
        np.arange(0, len(c.sample), -(-len(c.sample) // LINE_POINTS) or 1) for c in clouds.values()
    ]
    points = np.concatenate([c.sample[k] for c, k in zip(clouds.values(), chosen, strict=True)])
    time = np.concatenate([c.sample_time[k] for c, k in zip(clouds.values(), chosen, strict=True)])
    line = np.repeat(np.arange(len(chosen)), [len(k) for k in chosen])
    sampled = np.concatenate(chosen)
    finite = np.isfinite(points).all(axis=1)
    points, time, line, sampled = points[finite], time[finite], line[finite], sampled[finite]
    progress(0.1)
    regions = Regions.of(points, threshold)
    progress(0.5)
    region = regions.at(points)
    on = np.flatnonzero(region >= 0)
    both = region[on] * len(chosen) + line[on]
    order = np.argsort(both, kind="stable")
    start = np.flatnonzero(np.diff(both[order], prepend=-1))
    counts = np.diff(np.append(start, len(order)))
    enough = counts >= MIN_POINTS
    order, keys = order[np.repeat(enough, counts)], both[order][start[enough]]
    counts = counts[enough]
    owner = np.repeat(np.arange(len(counts)), counts)
    order = on[order]
    found, times = points[order], time[order]
    # Sums count from a point of the region: at large coordinates they would lose digits.
    origin = found[np.cumsum(counts) - counts]
    local = found - origin[owner]
    # With the biweight (Beaton and Tukey 1974) a plane converges to the densest layer.
    centre, normal = np.zeros((len(counts), 3)), np.zeros((len(counts), 3))
    far = np.full(len(counts), np.inf)
    for iteration in range(ITERATIONS):
        progress(0.6 + 0.4 * iteration / ITERATIONS)
        centre, variances, axes = fit_weighted_planes(local, np.cumsum(counts), centre, normal, far)
        normal = np.ascontiguousarray(axes[:, :, 0])
        rough = np.sqrt(np.maximum(variances[:, 0], 1e-12)) / np.where(np.isinf(far), 1.0, SHRUNK)
        far = np.minimum(far, np.maximum(OUTLIER_SIGMAS * rough, LIDAR_SIGMAS * noise))
    relative = local - centre[owner]
    off = (relative * normal[owner]).sum(axis=1)
    kept = np.abs(off) < far[owner]
    number = np.bincount(owner[kept], minlength=len(counts))
    some = np.maximum(number, 1)
    rough = np.sqrt(np.maximum(np.bincount(owner[kept], off[kept] ** 2, len(counts)) / some, 1e-12))
    fourth = np.bincount(owner[kept], off[kept] ** 4, len(counts)) / some
    reach = np.zeros(len(counts))
    np.maximum.at(reach, owner[kept], np.linalg.norm(relative[kept], axis=1))
    ahead = np.take_along_axis(normal, np.abs(normal).argmax(axis=1)[:, None], axis=1)
    ends = np.cumsum(number)
    planes = LinePlanes(
        region=keys // len(chosen),
        line=keys % len(chosen),
        begin=ends - number,
        end=ends,
        count=number,
        share=number / np.maximum(counts, 1),
        centre=centre + origin,
        normal=normal * np.sign(ahead),
        far=far,
        rough=rough,
        width=np.sqrt(np.maximum(variances[:, 1], 0.0)),
        reach=reach,
        peaked=fourth / rough**4,
        time=np.bincount(owner[kept], times[kept], len(counts)) / some,
    )
    return regions, planes, sampled[order[kept]]
