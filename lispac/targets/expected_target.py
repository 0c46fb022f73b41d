"""Expected size and inclination of a target, compared with the plane that was found."""

from dataclasses import dataclass
from math import radians

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import Message, error, note

Array = NDArray[np.float64]

# Accepted difference of a side from its expected length, in metres or as a fraction of the length,
# whichever is larger. The outline is accurate to about one point spacing on each side.
SIZE_TOLERANCE, RELATIVE_SIZE_TOLERANCE = 0.10, 0.08
# Accepted difference of the inclination, radians. The prior boresight may be wrong by two
# degrees on each axis.
TILT_TOLERANCE = radians(5.0)


@dataclass(frozen=True)
class ExpectedTarget:
    """Size and inclination of a target.

    Attributes
    ----------
    width, height : float, metres
        Along the horizontal direction, and up the slope.
    inclination : float, radians, optional
        Angle from the horizontal: 0 for a horizontal plane, pi/2 for a vertical one.
    """

    width: float
    height: float
    inclination: float | None = None

    def __post_init__(self) -> None:
        if not (0.0 < self.width < np.inf and 0.0 < self.height < np.inf):
            raise InputError(error("finder.expected_size"))
        if self.inclination is not None and not 0.0 <= self.inclination <= np.pi / 2:
            raise InputError(error("finder.expected_tilt"))


def plane_inclination(normal: Array) -> float:
    """Angle between a plane and the horizontal, radians in [0, pi/2]; ``normal`` of shape (3,)."""
    return float(np.arctan2(np.hypot(normal[0], normal[1]), abs(normal[2])))


def deviations_from_expected(
    expected: ExpectedTarget, extent: Array, normal: Array
) -> tuple[Message, ...]:
    """Deviations of a plane from the expected one; empty if it agrees.

    Parameters
    ----------
    extent : ndarray of shape (2,), metres
        Width (level) and height (up the slope).
    normal : ndarray of shape (3,), local frame
    """
    found = []
    sides = (
        ("quality.wider", "quality.narrower", expected.width, float(extent[0])),
        ("quality.higher", "quality.lower", expected.height, float(extent[1])),
    )
    for too_large, too_small, expected_size, size in sides:
        off = size - expected_size
        if abs(off) > max(SIZE_TOLERANCE, RELATIVE_SIZE_TOLERANCE * expected_size):
            code = too_large if off > 0 else too_small
            found.append(note(code, size=size, off=abs(off), expected=expected_size))
    if expected.inclination is not None:
        tilt = plane_inclination(normal)
        off = tilt - expected.inclination
        if abs(off) > TILT_TOLERANCE:
            code = "quality.steeper" if off > 0 else "quality.less_steep"
            found.append(note(code, tilt=tilt, off=abs(off), expected=expected.inclination))
    return tuple(found)
