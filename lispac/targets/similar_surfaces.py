"""Similar surfaces near a target, which may be confused with it.

Lines along a wall coincide at any shift along it. If there are two equal boards, it cannot be
determined which of them a line shows, and the wrong one fits equally well.
"""

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.planes import Plane, plane_axes
from lispac.targets import outline
from lispac.targets.flat_patches import find_flat_patches, voxel_side

Array = NDArray[np.float64]

MAX_SIZE_RATIO = 1.6
"""Largest ratio of the sizes of a similar surface and the target, or the inverse ratio."""
MAX_NORMAL_ANGLE = np.radians(10.0)
"""Largest angle between the normals, radians."""


def nearest_similar_surface(
    around: Array, points: Array, plane: Plane, threshold: float, reach: float
) -> float | None:
    """Distance to the nearest surface of similar size and tilt.

    Parameters
    ----------
    around : ndarray of shape (n, 3), metres, local frame
        Points of the line around the sighting.
    points : ndarray of shape (m, 3), metres, local frame
        Points of the sighting.
    plane : Plane, local frame
        Plane through the points of the sighting.
    threshold : float, metres
        Largest distance of a point from its surface.
    reach : float, metres
        Largest distance at which surfaces are considered.

    Returns
    -------
    float, metres, between the centres; None if there is no such surface
    """
    axes = plane_axes(plane.normal)
    cell = voxel_side(threshold)
    own = points @ axes.T
    area = outline.filled_area(own, cell)
    extent = np.ptp(own, axis=0)
    distances = []
    for patch in find_flat_patches(around, threshold).patches:
        alike = np.array([patch.area / area, *(patch.extent / extent)])
        if (alike > MAX_SIZE_RATIO).any() or (alike < 1.0 / MAX_SIZE_RATIO).any():
            continue
        # The sighting itself is among the patches; another surface does not cover its centre.
        beside = np.abs(axes @ (patch.centre - points.mean(axis=0)))
        if patch.plane.tilt_to(plane) <= MAX_NORMAL_ANGLE and (beside > 0.5 * extent).any():
            distances.append(float(np.linalg.norm(patch.centre - points.mean(axis=0))))
    nearest = min(distances, default=np.inf)
    return nearest if nearest <= reach else None
