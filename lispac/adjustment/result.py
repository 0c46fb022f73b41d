"""What an adjustment gives back."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.observations import Sighting
from lispac.adjustment.stochastic import StochasticModel

Array = NDArray[np.float64]

ANGLES = ("roll", "pitch", "yaw")


@dataclass(frozen=True)
class ChiSquare:
    """Two-sided test of the variance factor against 1 at 95 %."""

    statistic: float
    lower: float
    upper: float

    @property
    def passed(self) -> bool:
        """Whether the statistic lies between its bounds."""
        return self.lower <= self.statistic <= self.upper


@dataclass(frozen=True, eq=False)
class SightingResidual:
    """Distances of one sighting's points to the adjusted plane, metres."""

    sighting: Sighting
    points: int
    rms_before: float
    rms_after: float
    mean_after: float


@dataclass(frozen=True, eq=False)
class TargetResidual:
    """Distances of one target's points, over all lines, to one joint plane, metres.

    Before, the plane is the best one through the points placed with the prior boresight.
    """

    target: str
    points: int
    rms_before: float
    rms_after: float
    plane: Array


@dataclass(frozen=True, eq=False)
class AdjustmentResult:
    """Boresight, its uncertainty, and how well the model fits.

    Attributes
    ----------
    boresight, prior_boresight : ndarray of shape (3,), radians; roll, pitch, yaw
    covariance : ndarray of shape (3, 3), radians squared
        From the stated sigmas; not scaled by the variance factor.
    degrees_of_freedom : int
    elapsed : float, seconds
    """

    boresight: Array
    prior_boresight: Array
    covariance: Array
    model: StochasticModel
    variance_factor: float
    degrees_of_freedom: int
    chi_square: ChiSquare
    iterations: int
    targets: tuple[TargetResidual, ...]
    sightings: tuple[SightingResidual, ...]
    rms_before: float
    rms_after: float
    elapsed: float

    @property
    def points(self) -> int:
        """Number of points that took part."""
        return sum(sighting.points for sighting in self.sightings)

    @property
    def sigma(self) -> Array:
        """Standard deviations of roll, pitch, yaw, shape (3,), radians."""
        return np.asarray(np.sqrt(np.diag(self.covariance)))

    @property
    def correlation(self) -> Array:
        """Correlations between roll, pitch and yaw, shape (3, 3)."""
        return np.asarray(self.covariance / np.outer(self.sigma, self.sigma))
