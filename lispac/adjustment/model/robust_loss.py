"""Robust losses that limit the influence of outliers.

Points far from their surface (a bird, a mixed echo, a bolt) do not follow the normal distribution
of the other residuals. Their weight decreases with the standardised residual, and the adjustment is
repeated until the weights converge (iteratively reweighted least squares: Holland and Welsch 1977,
whose tuning constants are used). The losses are Huber's (1964) and Tukey's biweight (Beaton and
Tukey 1974).
"""

from dataclasses import dataclass
from functools import cache
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import kernel

LossName = Literal["none", "huber", "tukey"]
LOSS_NAMES: tuple[LossName, ...] = ("none", "huber", "tukey")

_TUNING_CONSTANTS = {"none": 0.0, "huber": 1.345, "tukey": 4.685}
"""Tuning constants in standard deviations, for 95 % efficiency with normal residuals."""


@dataclass(frozen=True)
class Loss:
    """Weight function of the standardised residual.

    ``none`` gives all points the same weight. ``huber`` reduces the weight of distant points, but
    never to zero. ``tukey`` is redescending: points beyond 4.7 standard deviations have no weight.
    """

    name: LossName = "none"

    @property
    def code(self) -> int:
        """Number of the loss in the compiled kernels."""
        return LOSS_NAMES.index(self.name)

    @property
    def tuning(self) -> float:
        """Tuning constant in standard deviations."""
        return _TUNING_CONSTANTS[self.name]

    @property
    def expected_square_share(self) -> float:
        """Expected ratio of the weighted to the unweighted sum of squares of normal residuals."""
        return _expected_square_share(self)

    @property
    def start(self) -> "Loss":
        """Loss for the first iterations, since a redescending loss needs good starting values."""
        return Loss("huber") if self.name == "tukey" else self


@cache
def _expected_square_share(loss: Loss) -> float:
    z = np.linspace(-10, 10, 20_001)
    weights = [1.0 if loss.name == "none" else loss_weight(loss.code, loss.tuning, v) for v in z]
    density = np.exp(-(z**2) / 2) / np.sqrt(2 * np.pi)
    return float(np.trapezoid(weights * z**2 * density, z))


def robust_scale(residuals: NDArray[np.float64]) -> float:
    """Scale of standardised residuals (n,) from the median of their absolute values, at least 1.

    Without this scale, most points of a surface rougher than the LiDAR noise would be outliers.
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
    """Derivative of weight times residual by the residual."""
    size = abs(residual) / tuning
    if size >= 1:
        return 0.0
    return 1.0 if code == 1 else (1 - size**2) * (1 - 5 * size**2)
