"""Distances and angles between points, as used in surveying."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import error

Array = NDArray[np.float64]


@dataclass(frozen=True)
class PointDistance:
    """Distances, height difference and azimuth from one point to another.

    Attributes
    ----------
    slope, horizontal : metres
    vertical : metres, positive where the second point is higher
    azimuth : radians clockwise from north in [0, 2 pi); 0 if one is vertically above the other
    """

    slope: float
    horizontal: float
    vertical: float
    azimuth: float


def measure_distance(first: Array, second: Array) -> PointDistance:
    """Distance from ``first`` to ``second``, both of shape (3,), metres, North, West, Up."""
    north, west, up = (float(v) for v in np.subtract(second, first))
    horizontal = float(np.hypot(north, west))
    azimuth = float(np.arctan2(-west, north)) % (2 * np.pi) if horizontal else 0.0
    return PointDistance(float(np.hypot(horizontal, up)), horizontal, up, azimuth)


def measure_angle(first: Array, corner: Array, second: Array) -> float:
    """Angle at ``corner`` between the directions to the other two points, radians in [0, pi].

    Parameters
    ----------
    first, corner, second : ndarray of shape (3,), metres, same frame

    Raises
    ------
    InputError
        One of the other points coincides with the corner.
    """
    one, other = np.subtract(first, corner), np.subtract(second, corner)
    if not (one.any() and other.any()):
        raise InputError(error("target.angle_same_points"))
    return float(np.arctan2(np.linalg.norm(np.cross(one, other)), one @ other))
