"""Patches: regions in which two or more lines have the same plane."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.natural.flat_regions import Regions
from lispac.natural.line_planes import MAX_LINE_POINTS, LinePlanes, find_line_planes
from lispac.progress import Progress, no_progress
from lispac.survey.cloud import Cloud, CloudInMemory

Array = NDArray[np.float64]
Indices = NDArray[np.int64]
Flags = NDArray[np.bool_]

MIN_NORMAL_COSINE = np.cos(np.radians(6.0))
"""Smallest cosine between the normals of the planes of two lines on the same patch.

The limit allows for a boresight error of a tenth of a degree and for the noise of a normal that is
fitted to half a metre.
"""
MAX_SIGHTING_POINTS = 3_000
"""Largest number of points of a sighting; more points are thinned evenly."""
MAX_CENTRE_DISTANCE_RATIO = 0.35
"""Largest distance between the centres of the planes of two lines on the same patch.

As a fraction of the reach of the plane with more points. Lines that see different halves of a
region do not observe the same part of the surface.
"""
MAX_ROUGHNESS_SIGMAS, MAX_ROUGHNESS = 1.5, 0.02
"""Largest RMS distance of points from their plane: in LiDAR sigmas, or in metres if larger.

The RMS distance is the LiDAR noise on walls and plates, a few millimetres on asphalt, and two
centimetres on mown grass.
"""
MIN_WIDTH_RATIO = 4.0
"""Smallest ratio of width to roughness; below it, points fill a volume or lie in a single row."""
MIN_WIDTH = 0.1
"""Smallest width as a standard deviation, metres; that of a uniform strip 0.35 m wide."""
MIN_POINT_SHARE = 0.85
"""Smallest share of the line's points in the region that lie on the plane.

The share is lower in a bush or along an edge.
"""
MIN_KURTOSIS, MAX_KURTOSIS = 1.5, 8.0
"""Limits of the kurtosis of the distances: below the first, the points form two layers; above the
second, outliers dominate."""
MIN_WATER_NORMAL_UP = np.cos(np.radians(10.0))
"""Smallest absolute vertical component of the unit normal of a plane that may be water."""
WATER_LEVEL_QUANTILE, MAX_HEIGHT_ABOVE_WATER = 0.01, 1.0
"""Quantile of the heights of all planes taken as the water level, and largest height of a water
plane above this level, metres."""
MIN_WATER_ROUGHNESS_RATIO = 2.0
"""Smallest ratio of the roughness of water to the median roughness of planes that are not level.

Waves and returns from below the surface make water rough. If all planes are level, their median
roughness is used.
"""


@dataclass(frozen=True, eq=False)
class Patches:
    """Regions in which the planes of two or more lines agree.

    Attributes
    ----------
    regions : Regions
    numbers : ndarray of shape (m,), int
        Indices of the points on the planes, from `find_line_planes`.
    planes : LinePlanes
        Planes that belong to a patch.
    patch : ndarray of shape (k,), int
        Index of the patch of each of these planes, ascending.
    centre, normal : ndarray of shape (patches, 3), metres and unit vectors, local frame
        Means over the planes of each patch, weighted with their numbers of points.
    """

    regions: Regions
    numbers: Indices
    planes: LinePlanes
    patch: Indices
    centre: Array
    normal: Array

    def __len__(self) -> int:
        return len(self.centre)

    def points_on(self, row: int, cloud: Cloud) -> tuple[Indices, int]:
        """Indices of the points on one of the planes, and the factor by which they are thinned.

        Parameters
        ----------
        row : int
            Row of the plane in ``planes``.
        cloud : Cloud
            Line of the plane.
        """
        planes = self.planes
        if isinstance(cloud, CloudInMemory):  # the sample contains all points of the line
            own = self.numbers[planes.begin[row] : planes.end[row]]
            one_in = max(1, -(-len(cloud) // MAX_LINE_POINTS))
        else:
            centre = planes.centre[row]
            near = cloud.within(centre, planes.reach[row], limit=MAX_LINE_POINTS)
            off = np.abs((near.points - centre) @ planes.normal[row])
            mine = self.regions.at(near.points) == planes.region[row]
            own, one_in = near.numbers[mine & (off <= planes.max_distance[row])], near.one_in
        step = -(-len(own) // MAX_SIGHTING_POINTS) or 1
        return own[::step], step * one_in


def find_patches(
    clouds: Mapping[str, Cloud],
    noise: float,
    threshold: float,
    *,
    progress: Progress = no_progress,
) -> Patches:
    """Find all patches of a scene.

    Parameters
    ----------
    clouds : mapping of line name to Cloud
        Georeferenced well enough that the lines nearly agree.
    noise : float, metres
        Sigma of the LiDAR.
    threshold : float, metres
        Largest distance of a point of any line from its region; two lines of a patch may be twice
        as far apart.
    """
    regions, planes, numbers = find_line_planes(clouds, noise, threshold, progress=progress)
    planes = planes.where(is_solid_surface(planes, noise))
    planes = planes.where(~is_water(planes))
    return _patches_of_largest_planes(regions, planes, numbers, threshold)


def _patches_of_largest_planes(
    regions: Regions, planes: LinePlanes, numbers: Indices, threshold: float
) -> Patches:
    """Build patches from the planes that agree with the plane with most points in their region."""
    cells, owner = np.unique(planes.region, return_inverse=True)
    owner = owner.reshape(-1)
    # In this order, the last plane of each region is the one with most points.
    order = np.lexsort((planes.count, owner))
    last = np.append(np.flatnonzero(np.diff(owner[order])), len(order) - 1) if len(order) else order
    lead = order[last][owner] if len(order) else order
    along = (planes.normal * planes.normal[lead]).sum(axis=1)
    relative = planes.centre - planes.centre[lead]
    off = np.abs((relative * planes.normal[lead]).sum(axis=1))
    beside = np.linalg.norm(relative, axis=1)
    agrees = (
        (np.abs(along) >= MIN_NORMAL_COSINE)
        & (off <= 2 * threshold)
        & (beside <= MAX_CENTRE_DISTANCE_RATIO * planes.reach[lead])
    )
    shared = np.bincount(owner[agrees], minlength=len(cells)) >= 2
    keep = agrees & shared[owner]
    facing = planes.normal * np.sign(along)[:, None]
    number = np.cumsum(shared) - 1
    patch = number[owner[keep]]
    kept = planes.where(keep)
    count, weights = int(shared.sum()), kept.count.astype(float)

    def mean(values: Array) -> Array:
        sums = [np.bincount(patch, weights * c, count).astype(float) for c in values.T]
        return np.stack(sums, axis=1)

    centre = mean(kept.centre) / np.bincount(patch, weights, count)[:, None]
    normal = mean(facing[keep])
    normal /= np.linalg.norm(normal, axis=1, keepdims=True)
    return Patches(regions, numbers, kept, patch, centre, normal)


def is_solid_surface(planes: LinePlanes, noise: float) -> Flags:
    """Whether each plane is flat and solid, shape (k,).

    Parameters
    ----------
    noise : float, metres
        Sigma of the LiDAR.
    """
    return np.asarray(
        (planes.roughness <= max(MAX_ROUGHNESS_SIGMAS * noise, MAX_ROUGHNESS))
        & (planes.width >= MIN_WIDTH_RATIO * planes.roughness)
        & (planes.width >= MIN_WIDTH)
        & (planes.share >= MIN_POINT_SHARE)
        & (planes.kurtosis >= MIN_KURTOSIS)
        & (planes.kurtosis <= MAX_KURTOSIS)
    )


def is_water(planes: LinePlanes) -> Flags:
    """Whether each plane may be water, shape (k,): level, among the lowest, and rough.

    A quay or a road is also level, but it is smooth or lies higher. Rough, level ground near
    the water level is also excluded; this is accepted.
    """
    if not len(planes):
        return np.zeros(0, dtype=bool)
    level = np.abs(planes.normal[:, 2]) >= MIN_WATER_NORMAL_UP
    low = (
        planes.centre[:, 2]
        <= np.quantile(planes.centre[:, 2], WATER_LEVEL_QUANTILE) + MAX_HEIGHT_ABOVE_WATER
    )
    usual = np.median(planes.roughness[~level]) if (~level).any() else np.median(planes.roughness)
    return np.asarray(level & low & (planes.roughness > MIN_WATER_ROUGHNESS_RATIO * usual))
