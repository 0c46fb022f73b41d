"""Surfaces similar to a target near it, which may be confused with it.

Lines that lie along one wall meet wherever they are shifted along it. Which of two equal boards a
line shows where another one does cannot be determined, and a wrong one fits as well.
"""

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.planes import Plane, plane_axes
from lispac.targets import outline
from lispac.targets.flat_patches import find_flat_patches, voxel_side

Array = NDArray[np.float64]

MAX_SIZE_RATIO = 1.6
"""Times as large or as small as the target a surface may be."""
MAX_TURN = np.radians(10.0)
"""Most its normal may differ."""


def nearest_similar_surface(
    around: Array, points: Array, plane: Plane, threshold: float, reach: float
) -> float | None:
    """Distance to the nearest surface of similar size and tilt.

    Parameters
    ----------
    around : ndarray of shape (n, 3), metres, local frame
        Points of the line about the sighting.
    points : ndarray of shape (m, 3), metres, local frame
        Of the sighting.
    plane : Plane, local frame
        Through them.
    threshold : float, metres
        Farthest a point may lie from its surface.
    reach : float, metres
        Farthest that such a surface is of interest.

    Returns
    -------
    float, metres, between the centres; None where there is none
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
        # The sighting itself is among them: another one does not lie over its middle.
        beside = np.abs(axes @ (patch.centre - points.mean(axis=0)))
        if patch.plane.tilt_to(plane) <= MAX_TURN and (beside > 0.5 * extent).any():
            distances.append(float(np.linalg.norm(patch.centre - points.mean(axis=0))))
    nearest = min(distances, default=np.inf)
    return nearest if nearest <= reach else None
