"""Patches: regions in which two or more lines have the same plane."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.natural.flat_regions import Regions
from lispac.natural.line_planes import MAX_LINE_POINTS, LinePlanes, find_line_planes
from lispac.natural.surface_filter import is_solid_surface, is_water
from lispac.progress import Progress, no_progress
from lispac.survey.cloud import Cloud, CloudInMemory

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

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
