"""Values of a report from alternative methods."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Message
from lispac.methods import MethodResult

Three = tuple[float, float, float]


@dataclass(frozen=True)
class MethodAnswer:
    """Result of a method; the differences are from the first method, which has none.

    Attributes
    ----------
    boresight_deg, sigma_deg, difference_deg : roll, pitch, yaw
    over_sigma : differences over their sigmas
    probability : chance of differences as large where both are right
    """

    method: str
    lines: int
    surfaces: int
    boresight_deg: Three
    sigma_deg: Three
    difference_deg: Three | None
    over_sigma: Three | None
    probability: float | None
    differ: bool | None
    remarks: tuple[Message, ...]

    @classmethod
    def of(cls, answer: MethodResult) -> "MethodAnswer":
        """The same figures."""
        calibration, against = answer.calibration, answer.against
        return cls(
            answer.method,
            answer.lines,
            answer.surfaces,
            _three(np.degrees(calibration.boresight)),
            _three(np.degrees(calibration.sigma)),
            None if against is None else _three(np.degrees(against.angles)),
            None if against is None else _three(against.significance),
            None if against is None else against.probability,
            None if against is None else against.differ,
            answer.remarks,
        )


def _three(values: NDArray[np.float64]) -> Three:
    roll, pitch, yaw = (float(value) for value in values)
    return roll, pitch, yaw
