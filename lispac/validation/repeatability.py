"""Test whether calibrations of the same mounting agree (thesis section 4.5.5, table 4.5).

Each calibration has a covariance; calibrations of two surveys are assumed to be independent. Their
differences are tested for each angle and jointly. The effect on a point is given as well: the angle
of the rotation from one mounting to the other, times the distance of the point.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.geometry.rotations import rotation_matrix
from lispac.messages import error

Array = NDArray[np.float64]

SIGNIFICANCE_LEVEL = 0.05
"""Significance level of all tests here: probability of a false alarm."""
NORMAL_QUANTILE_975 = 1.96
"""Half the width of the 95 % interval of a normal variable, in standard deviations."""


@dataclass(frozen=True, eq=False)
class Calibration:
    """A boresight with its covariance.

    Attributes
    ----------
    name : str
    boresight : ndarray of shape (3,), radians; roll, pitch, yaw
    covariance : ndarray of shape (3, 3), radians^2

    Raises
    ------
    InputError
        If an array has another shape, or the covariance is not finite or not positive definite.
    """

    name: str
    boresight: Array
    covariance: Array

    def __post_init__(self) -> None:
        shapes = np.shape(self.boresight), np.shape(self.covariance)
        if shapes != ((3,), (3, 3)) or not np.isfinite(self.covariance).all():
            raise InputError(error("validation.repeatability_values", name=self.name))
        if np.linalg.eigvalsh(self.covariance)[0] <= 0.0:
            raise InputError(error("validation.repeatability_covariance", name=self.name))

    @property
    def sigma(self) -> Array:
        """Standard deviations (3,), radians."""
        return np.asarray(np.sqrt(np.diag(self.covariance)))


@dataclass(frozen=True, eq=False)
class CalibrationDifference:
    """Difference between a calibration and an earlier one.

    Attributes
    ----------
    first, second : str
    angles, sigma : ndarrays of shape (3,), radians
        Second minus first, and the standard deviation of this difference.
    statistic, probability : float
        Joint test of the three angles: chi-square with three degrees of freedom, and the
        probability of a value at least as large for an unchanged mounting.
    turn : float, radians
        Angle of the rotation from one mounting to the other.
    """

    first: str
    second: str
    angles: Array
    sigma: Array
    statistic: float
    probability: float
    turn: float

    @property
    def significance(self) -> Array:
        """Differences divided by their sigmas, shape (3,)."""
        return np.asarray(self.angles / self.sigma)

    @property
    def significant(self) -> tuple[bool, ...]:
        """Whether each of the three angles differs at the 95 % level."""
        return tuple(bool(abs(value) > NORMAL_QUANTILE_975) for value in self.significance)

    @property
    def differ(self) -> bool:
        """Whether the two mountings differ at the 95 % level in the joint test of all angles."""
        return self.probability < SIGNIFICANCE_LEVEL

    def largest_displacement(self, distance: float) -> float:
        """Largest displacement, metres, of a point at a distance, metres, between the mountings."""
        return float(2.0 * np.sin(self.turn / 2.0) * distance)


def compare_calibrations(first: Calibration, second: Calibration) -> CalibrationDifference:
    """Compare two calibrations of one mounting."""
    from scipy.special import chdtrc

    # In [-pi, pi): a yaw of 179 degrees and one of -179 degrees differ by two degrees.
    angles = (second.boresight - first.boresight + np.pi) % (2.0 * np.pi) - np.pi
    covariance = first.covariance + second.covariance
    statistic = float(angles @ np.linalg.solve(covariance, angles))
    between = rotation_matrix(*second.boresight) @ rotation_matrix(*first.boresight).T
    skew = between - between.T
    sine = 0.5 * float(np.linalg.norm([skew[2, 1], skew[0, 2], skew[1, 0]]))
    turn = float(np.arctan2(sine, 0.5 * (np.trace(between) - 1.0)))
    return CalibrationDifference(
        first.name,
        second.name,
        angles,
        np.sqrt(np.diag(covariance)),
        statistic,
        float(chdtrc(3, statistic)),
        turn,
    )


@dataclass(frozen=True, eq=False)
class RepeatedCalibrations:
    """Combination of several calibrations of one mounting.

    Attributes
    ----------
    boresight, sigma : ndarrays of shape (3,), radians
        Weighted mean by the covariances, and its standard deviation.
    spread : ndarray of shape (3,), radians, or None
        Empirical standard deviation of a single calibration about the unweighted mean; None for a
        single calibration.
    statistic, probability : float
        Test whether the scatter agrees with the sigmas: chi-square with 3 (n - 1) degrees of
        freedom, and the probability of a value at least as large.
    """

    boresight: Array
    sigma: Array
    spread: Array | None
    statistic: float
    probability: float

    @property
    def differ(self) -> bool:
        """Whether the calibrations scatter more than their sigmas explain, at the 95 % level."""
        return self.probability < SIGNIFICANCE_LEVEL


def combine_calibrations(calibrations: Sequence[Calibration]) -> RepeatedCalibrations:
    """Combine calibrations of one mounting.

    Raises
    ------
    InputError
        If there are fewer than two calibrations.
    """
    from scipy.special import chdtrc

    if len(calibrations) < 2:
        raise InputError(error("validation.repeatability_few"))
    mean, angles = mean_calibration(calibrations), _unwrapped_angles(calibrations)
    deviations = angles - mean.boresight
    weights = np.array([np.linalg.inv(each.covariance) for each in calibrations])
    statistic = float(np.einsum("ni,nij,nj->", deviations, weights, deviations))
    return RepeatedCalibrations(
        mean.boresight,
        mean.sigma,
        angles.std(axis=0, ddof=1),
        statistic,
        float(chdtrc(3 * (len(calibrations) - 1), statistic)),
    )


def single_calibration(calibration: Calibration) -> RepeatedCalibrations:
    """Combination of a single calibration, used if all others are based on the same lines."""
    return RepeatedCalibrations(calibration.boresight, calibration.sigma, None, 0.0, 1.0)


def mean_calibration(calibrations: Sequence[Calibration], name: str = "mean") -> Calibration:
    """The mean of one or more calibrations of one mounting, weighted by their covariances."""
    weights = np.array([np.linalg.inv(each.covariance) for each in calibrations])
    covariance = np.linalg.inv(weights.sum(axis=0))
    mean = covariance @ np.einsum("nij,nj->i", weights, _unwrapped_angles(calibrations))
    return Calibration(name, mean, covariance)


def _unwrapped_angles(calibrations: Sequence[Calibration]) -> Array:
    """Angles (n, 3), radians, without jumps by 2 pi relative to the first calibration."""
    start = calibrations[0].boresight
    return np.array([
        start + (each.boresight - start + np.pi) % (2.0 * np.pi) - np.pi for each in calibrations
    ])  # fmt: skip
