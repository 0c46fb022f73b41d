"""Exclude surfaces that are not reliable: leaves, edges, double layers, water.

Leaves fill a volume, and water moves between two lines. The rules use properties of single planes;
other errors are detected by the comparison of the lines and by the tests of the adjustment.
"""

import numpy as np
from numpy.typing import NDArray

from lispac.natural.line_planes import LinePlanes

Flags = NDArray[np.bool_]

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
