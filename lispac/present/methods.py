"""Values in the report from the results of alternative methods."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Message
from lispac.method_comparison import MethodResult

Three = tuple[float, float, float]


@dataclass(frozen=True)
class MethodValues:
    """Result of a method; the differences are this method minus the first, which has none.

    Attributes
    ----------
    boresight_deg, sigma_deg, difference_deg : roll, pitch, yaw
    significance : differences over their sigmas
    probability : chance of differences as large where both are right
    """

    method: str
    lines: int
    surfaces: int
    boresight_deg: Three
    sigma_deg: Three
    difference_deg: Three | None
    significance: Three | None
    probability: float | None
    differ: bool | None
    messages: tuple[Message, ...]

    @classmethod
    def of(cls, result: MethodResult) -> "MethodValues":
        """Values of the result of a method."""
        calibration, against = result.calibration, result.against
        return cls(
            result.method,
            result.lines,
            result.surfaces,
            _triple(np.degrees(calibration.boresight)),
            _triple(np.degrees(calibration.sigma)),
            None if against is None else _triple(np.degrees(against.angles)),
            None if against is None else _triple(against.significance),
            None if against is None else against.probability,
            None if against is None else against.differ,
            result.messages,
        )


def _triple(values: NDArray[np.float64]) -> Three:
    roll, pitch, yaw = (float(value) for value in values)
    return roll, pitch, yaw
