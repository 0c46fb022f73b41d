"""What the surveyor knows of a target beforehand, compared with what was found."""

from dataclasses import dataclass
from math import degrees, radians

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import error

Array = NDArray[np.float64]

# The outline is true to about one spacing of the points on each side.
TOLERANCE, SHARE = 0.10, 0.08
# The prior boresight may be off by two degrees on each axis.
TILT = radians(5.0)


@dataclass(frozen=True)
class ExpectedTarget:
    """Size and inclination of a target.

    Attributes
    ----------
    width, height : float, metres
        Level, and up the slope.
    inclination : float, radians, optional
        From level: 0 lies flat, pi/2 stands upright.
    """

    width: float
    height: float
    inclination: float | None = None

    def __post_init__(self) -> None:
        if not (0.0 < self.width < np.inf and 0.0 < self.height < np.inf):
            raise InputError(error("finder.expected_size"))
        if self.inclination is not None and not 0.0 <= self.inclination <= np.pi / 2:
            raise InputError(error("finder.expected_tilt"))


def inclination(normal: Array) -> float:
    """Angle of a plane from level by its normal, shape (3,), radians in [0, pi/2]."""
    return float(np.arctan2(np.hypot(normal[0], normal[1]), abs(normal[2])))


def deviations(expected: ExpectedTarget, extent: Array, normal: Array) -> tuple[str, ...]:
    """How a plane differs from what is expected, in words; empty where it agrees.

    Parameters
    ----------
    extent : ndarray of shape (2,), metres
        Width (level) and height (up the slope).
    normal : ndarray of shape (3,), local frame
    """
    said = []
    sides = (("wide", expected.width, extent[0]), ("high", expected.height, extent[1]))
    for word, should, is_ in sides:
        if abs(is_ - should) > max(TOLERANCE, SHARE * should):
            said.append(
                f"It is {is_:.2f} m {word}, {abs(is_ - should):.2f} m "
                f"{'more' if is_ > should else 'less'} than the {should:.2f} m expected."
            )
    if expected.inclination is not None:
        tilt = inclination(normal)
        off = tilt - expected.inclination
        if abs(off) > TILT:
            said.append(
                f"It is inclined by {degrees(tilt):.1f} deg, "
                f"{abs(degrees(off)):.1f} deg {'more' if off > 0 else 'less'} than the "
                f"{degrees(expected.inclination):.1f} deg expected."
            )
    return tuple(said)
