"""Exclude surfaces that are not reliable: leaves, edges, double layers, water.

Leaves fill a volume; water moves between two lines. Both rules use only the points of one plane:
the rest is left to the agreement of lines and the adjustment's own tests.
"""

import numpy as np
from numpy.typing import NDArray

from lispac.natural.line_planes import LinePlanes

Flags = NDArray[np.bool_]

NOISY, ROUGHEST = 1.5, 0.02
"""Most RMS distance of points from their plane: LiDAR sigmas, or metres where that is more.
Walls and plates have their noise, asphalt a few millimetres, mown grass two centimetres."""
FLATTEST = 4.0
"""Least width over roughness: below, points fill a volume, or are a straight row."""
NARROWEST = 0.1
"""Least width, metres: of an even strip 0.35 m wide."""
MIN_SHARE = 0.85
"""Share of the region's points that must lie on the plane: in a bush, along an edge, fewer do."""
MIN_KURTOSIS, MAX_KURTOSIS = 1.5, 8.0
"""Kurtosis of the distances below which there are two layers, and above which outliers dominate."""

LEVEL = np.cos(np.radians(10.0))
"""Least upward part of the normal of water: a wave of a metre is no steeper."""
LOWEST, BAND = 0.01, 1.0
"""Water lies at the height that this share of all planes is below, and in a band of so many metres
above it."""
ROUGHNESS_RATIO = 2.0
"""Times rougher than the surfaces that are not level: waves, and echoes from below the surface."""


def is_solid_surface(planes: LinePlanes, noise: float) -> Flags:
    """Whether each plane is flat and solid, shape (k,).

    Parameters
    ----------
    noise : float, metres
        Sigma of the LiDAR.
    """
    return np.asarray(
        (planes.rough <= max(NOISY * noise, ROUGHEST))
        & (planes.width >= FLATTEST * planes.rough)
        & (planes.width >= NARROWEST)
        & (planes.share >= MIN_SHARE)
        & (planes.peaked >= MIN_KURTOSIS)
        & (planes.peaked <= MAX_KURTOSIS)
    )


def is_water(planes: LinePlanes) -> Flags:
    """Whether each plane may be water, shape (k,): level, among the lowest, and rough.

    A quay or a road is level as well, but smooth, or not the lowest. Rough ground at the foot of
    the scene goes with the water: it is little loss.
    """
    if not len(planes):
        return np.zeros(0, dtype=bool)
    level = np.abs(planes.normal[:, 2]) >= LEVEL
    low = planes.centre[:, 2] <= np.quantile(planes.centre[:, 2], LOWEST) + BAND
    quiet = np.median(planes.rough[~level]) if (~level).any() else np.median(planes.rough)
    return np.asarray(level & low & (planes.rough > ROUGHNESS_RATIO * quiet))
