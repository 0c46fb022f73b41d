"""Robust losses that limit the influence of outliers.

A point far off its surface (a bird, a mixed echo, a bolt) does not belong to the normal
distribution the other residuals have. Its weight is lowered by how many standard deviations it
lies off, and the adjustment repeated until the weights converge (iteratively reweighted least
squares: Holland and Welsch 1977, whose tuning is taken). The losses are Huber's (1964) and Tukey's
biweight (Beaton and Tukey 1974).
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import kernel

LossName = Literal["none", "huber", "tukey"]
LOSSES: tuple[LossName, ...] = ("none", "huber", "tukey")

_TUNING = {"none": 0.0, "huber": 1.345, "tukey": 4.685}
"""Standard deviations: 95 % efficient where the residuals are normal after all."""


@dataclass(frozen=True)
class Loss:
    """Weight function of the standardised residual.

    ``none`` weights all points alike. ``huber`` lowers the weight of the far ones but never to
    zero. ``tukey`` redescends: points beyond 4.7 standard deviations have no weight.
    """

    name: LossName = "none"

    @property
    def code(self) -> int:
        """Number of the loss in the compiled kernels."""
        return LOSSES.index(self.name)

    @property
    def tuning(self) -> float:
        """Tuning constant in standard deviations."""
        return _TUNING[self.name]

    @property
    def kept(self) -> float:
        """Expected share of the sum of squares of normal residuals that the weights keep."""
        z = np.linspace(-10, 10, 20_001)
        weights = [
            1.0 if self.name == "none" else loss_weight(self.code, self.tuning, v) for v in z
        ]
        density = np.exp(-(z**2) / 2) / np.sqrt(2 * np.pi)
        return float(np.trapezoid(weights * z**2 * density, z))

    @property
    def start(self) -> "Loss":
        """Loss for the first iterations; a redescending one needs a good start."""
        return Loss("huber") if self.name == "tukey" else self


def robust_scale(residuals: NDArray[np.float64]) -> float:
    """Spread of standardised residuals (n,) by their median, at least 1.

    If a surface is rougher than the LiDAR noise, all its points would be outliers.
    """
    return max(1.0, float(np.median(np.abs(residuals))) / 0.6745)


@kernel(inline="always")
def loss_weight(code, tuning, residual):  # type: ignore[no-untyped-def]
    """Weight between 0 and 1 of a standardised residual."""
    size = abs(residual)
    if code == 1:
        return 1.0 if size <= tuning else tuning / size
    if size >= tuning:
        return 0.0
    return (1 - (residual / tuning) ** 2) ** 2


@kernel(inline="always")
def influence_slope(code, tuning, residual):  # type: ignore[no-untyped-def]
    """Derivative of weight times residual by the residual where it is positive."""
    size = abs(residual) / tuning
    if size >= 1:
        return 0.0
    return 1.0 if code == 1 else (1 - size**2) * (1 - 5 * size**2)
