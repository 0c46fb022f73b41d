"""Patches: regions in which two or more lines show the same plane."""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.natural.flat_regions import Regions
from lispac.natural.line_planes import LINE_POINTS, LinePlanes, find_line_planes
from lispac.natural.surface_filter import is_solid_surface, is_water
from lispac.progress import Progress, no_progress
from lispac.survey.cloud import Cloud, CloudInMemory

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

COSINE = np.cos(np.radians(6.0))
"""Least cosine between normals of one plane: what a boresight off by a tenth of a degree and the
noise of half a metre leave."""
MAX_POINTS = 3_000
"""Points of a sighting: a fair sample of where there are more."""
BESIDE = 0.35
"""Farthest that the middles of two lines' points may be apart, of their reach: two halves of a
region are different pieces of a surface."""


@dataclass(frozen=True, eq=False)
class Patches:
    """Regions in which two or more lines agree.

    Attributes
    ----------
    regions : Regions
    numbers : ndarray of shape (m,), int
        From `find_line_planes`.
    planes : LinePlanes
        Of what belongs to a patch alone.
    patch : ndarray of shape (k,), int
        The patch of each of these planes, ascending.
    centre, normal : ndarray of shape (patches, 3), metres and unit vectors, local frame
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
        """Indices of the points on one of the planes, and the number of points examined.

        Parameters
        ----------
        row : int
        cloud : Cloud
            Of the plane's line.
        """
        planes = self.planes
        if isinstance(cloud, CloudInMemory):  # the sample is the line
            own = self.numbers[planes.begin[row] : planes.end[row]]
            one_in = max(1, -(-len(cloud) // LINE_POINTS))
        else:
            centre = planes.centre[row]
            near = cloud.within(centre, planes.reach[row], limit=LINE_POINTS)
            off = np.abs((near.points - centre) @ planes.normal[row])
            mine = self.regions.at(near.points) == planes.region[row]
            own, one_in = near.numbers[mine & (off <= planes.far[row])], near.one_in
        step = -(-len(own) // MAX_POINTS) or 1
        return own[::step], step * one_in


def find_patches(
    clouds: Mapping[str, Cloud],
    noise: float,
    threshold: float,
    *,
    progress: Progress = no_progress,
) -> Patches:
    """Find every patch.

    Parameters
    ----------
    clouds : mapping of line name to Cloud
        Placed so that they nearly meet.
    noise : float, metres
        Sigma of the LiDAR.
    threshold : float, metres
        Farthest that a line may be off what all lines have in common.
    """
    regions, planes, numbers = find_line_planes(clouds, noise, threshold, progress=progress)
    planes = planes.where(is_solid_surface(planes, noise))
    planes = planes.where(~is_water(planes))
    return _agrees_with_largest_line(regions, planes, numbers, threshold)


def _agrees_with_largest_line(
    regions: Regions, planes: LinePlanes, numbers: Indices, threshold: float
) -> Patches:
    """Whether each plane agrees with the line that has most points of its region."""
    cells, owner = np.unique(planes.region, return_inverse=True)
    owner = owner.reshape(-1)
    # The last in this order of each region is the one with most points.
    order = np.lexsort((planes.count, owner))
    last = np.append(np.flatnonzero(np.diff(owner[order])), len(order) - 1) if len(order) else order
    lead = order[last][owner] if len(order) else order
    along = (planes.normal * planes.normal[lead]).sum(axis=1)
    relative = planes.centre - planes.centre[lead]
    off = np.abs((relative * planes.normal[lead]).sum(axis=1))
    beside = np.linalg.norm(relative, axis=1)
    alike = (
        (np.abs(along) >= COSINE) & (off <= 2 * threshold) & (beside <= BESIDE * planes.reach[lead])
    )
    shared = np.bincount(owner[alike], minlength=len(cells)) >= 2
    keep = alike & shared[owner]
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
