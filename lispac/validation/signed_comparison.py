"""Signed distances of two lines on one plane with one boresight, with confidence."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from lispac.errors import NotComparable
from lispac.validation.comparison_results import SignedStatistics
from lispac.validation.normal_distance import distances_along_normal
from lispac.validation.plane_offset import PlaneOffset, plane_offset

Array = NDArray[np.float64]

CORES = 200
"""Places of each line that distances along the normal are measured at."""
WIDE = 4.0
"""Diameter of a cylinder in spacings of the sparser line: a dozen points of it."""
SMOOTH = 2.0
"""Diameter of the sphere that a normal comes from, in diameters of the cylinder."""


def signed_distance_statistics(
    a: Array, b: Array, *, facing: Array, spacing: float, reach: float
) -> SignedStatistics | None:
    """Distances of the first line from the second along the normal, from places of both.

    Parameters
    ----------
    a, b : ndarrays of shape (n, 3) and (m, 3), metres, local frame
        Of the part that both lines saw.
    facing : ndarray of shape (3,)
        Towards the vessel.
    spacing : float, metres
        Of the sparser line's points, where they are sparse.
    reach : float, metres
        The farthest that the two lines are apart.

    Returns
    -------
    SignedStatistics, or None where no place has enough points of both lines
    """
    diameter = WIDE * spacing
    parts = []
    for compared, reference, sign in ((a, b, 1.0), (b, a, -1.0)):
        step = -(-len(reference) // CORES)
        try:
            found = distances_along_normal(
                compared, reference, reference[::step], facing=facing,
                normal_scale=SMOOTH * diameter, diameter=diameter, depth=reach + diameter,
            )  # fmt: skip
        except NotComparable:
            continue
        parts.append(replace(found, distance=sign * found.distance))
    return SignedStatistics.of(parts) if parts else None


def plane_offset_between_lines(a: Array, b: Array, facing: Array) -> PlaneOffset | None:
    """Offset of the first line's plane from the second's; None where one has no plane.

    Parameters
    ----------
    a, b : ndarray of shape (n, 3) and (m, 3), metres, same frame
        Points of the two lines.
    facing : ndarray of shape (3,)
        Towards the vessel.
    """
    try:
        return plane_offset(a, b, facing)
    except NotComparable:
        return None
