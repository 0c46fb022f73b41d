"""Corrections of the POS as a function of time: least-squares collocation of the POS error.

The adjustment estimates the corrections of position and attitude at knots around the sightings. At
any other time they are predicted by the same stochastic model (Moritz 1980, least-squares
collocation). Each component is a Gauss-Markov process ``x(t) = s(t) z(t)``, with the standard
deviation ``s`` of the POS and ``Cov(z(t), z(u)) = exp(-|t - u| / T)``. It is Markov, so that the
neighbouring knots at ``a`` seconds before and ``b`` seconds after ``t`` contain all information:

    w_a = exp(-a/T) (1 - exp(-2b/T)) / (1 - exp(-2(a + b)/T)), w_b likewise
    E z(t) = w_a E z_a + w_b E z_b
    Var z(t) = (w_a, w_b) C (w_a, w_b)' + (1 - exp(-2a/T)) (1 - exp(-2b/T)) / (1 - exp(-2(a + b)/T))

where ``C`` is the covariance of both knots after the adjustment. Before the first and after the
last knot, ``w = exp(-a/T)`` and the last term is ``1 - w^2``: the correction decays to zero, and
its standard deviation returns to that of the POS.
"""

from dataclasses import dataclass
from typing import Annotated

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.stochastic_model import MIN_POS_SIGMA
from lispac.untrusted_values import ArrayShape

Array = NDArray[np.float64]

MAX_DETERMINED_SIGMA_RATIO = 0.995
"""Largest ratio of the sigma of a component after the adjustment to the prior one with which the
data determine the component at all. A component that they determine at no knot is not corrected."""

MIN_SUPPORTED_SHARE = 1e-4
"""Share of the prior variance removed by the data below which a correction is set to zero. The
correction is then about 1 % of the standard deviation of the POS, so that no step is visible."""


@dataclass(frozen=True, eq=False)
class PosCorrections:
    """Corrections of the POS at the knots of the adjustment, with their covariance.

    A correction is added to what the POS reports: true value = reported value + correction.
    Components in this order: metres in the local frame (north, west, up), radians (roll,
    pitch positive bow down, heading clockwise).

    Attributes
    ----------
    time : ndarray of shape (k + 1,), seconds, increasing
        Times of the knots in the time base of the trajectory.
    correction, sigma : ndarray of shape (k + 1, 6), metres and radians
        Correction and its standard deviation after the adjustment; the latter contains the
        uncertainty of mounting, targets and form errors.
    prior_sigma : ndarray of shape (k + 1, 6), metres and radians
        Standard deviation of the POS that the adjustment used.
    covariance_beside : ndarray of shape (k, 6), metres and radians squared
        Covariance of each component between a knot and the next one, after the adjustment.
    position_time, attitude_time : float, seconds
        Correlation times.
    knot_interval : float, seconds
        Interval of the knots within a sighting.
    """

    time: Annotated[Array, ArrayShape("k+1")]
    correction: Annotated[Array, ArrayShape("k+1", 6)]
    sigma: Annotated[Array, ArrayShape("k+1", 6)]
    prior_sigma: Annotated[Array, ArrayShape("k+1", 6)]
    covariance_beside: Annotated[Array, ArrayShape("k", 6)]
    position_time: float
    attitude_time: float
    knot_interval: float

    @property
    def is_sound(self) -> bool:
        """Whether the values, from a project file, are those of an estimate."""
        times = (self.position_time, self.attitude_time, self.knot_interval)
        arrays = (self.time, self.correction, self.sigma, self.prior_sigma, self.covariance_beside)
        return bool(
            min(times) > 0
            and all(np.isfinite(each).all() for each in arrays)
            and (np.diff(self.time) > 0).all()
            and (self.sigma >= 0).all()
            and (self.prior_sigma > 0).all()
        )

    @property
    def correlation_times(self) -> Array:
        """Correlation time of each component, shape (6,), seconds."""
        return np.repeat([self.position_time, self.attitude_time], 3)

    @property
    def determined(self) -> NDArray[np.bool_]:
        """Whether the data determine each component at any knot, shape (6,)."""
        ratios = (self.sigma / self.prior_sigma).min(axis=0)
        return np.asarray(ratios < MAX_DETERMINED_SIGMA_RATIO)

    @property
    def sighted_intervals(self) -> Array:
        """First and last time of each interval with sightings, shape (m, 2), seconds.

        Knots follow each other at `knot_interval` within an interval. It may exceed the times of
        the points by one knot interval at each end.
        """
        ends = np.flatnonzero(np.diff(self.time) > 1.5 * self.knot_interval)
        first, last = np.append(0, ends + 1), np.append(ends, len(self.time) - 1)
        return np.stack([self.time[first], self.time[last]], axis=1)

    def is_sighted(self, time: Array) -> NDArray[np.bool_]:
        """Whether each time (n,), seconds, lies in one of `sighted_intervals`, shape (n,)."""
        first, last = self.sighted_intervals.T
        place = np.searchsorted(first, time, side="right") - 1
        return np.asarray((place >= 0) & (time <= last[np.maximum(place, 0)]))

    def collocate(self, time: Array, prior_sigma: Array) -> tuple[Array, Array]:
        """Conditional mean of the corrections, and their standard deviation, at any times.

        Parameters
        ----------
        time : ndarray of shape (n,), seconds, in the time base of the trajectory
        prior_sigma : ndarray of shape (n, 6), metres and radians
            Standard deviations of the POS at these times, as the adjustment used them.

        Returns
        -------
        correction, sigma : ndarray of shape (n, 6), metres and radians
        """
        z = self.correction / self.prior_sigma
        variance = (self.sigma / self.prior_sigma) ** 2
        beside = self.covariance_beside / (self.prior_sigma[1:] * self.prior_sigma[:-1])
        after = np.searchsorted(self.time, time, side="right")
        last = len(self.time) - 1
        i, j = np.clip(after - 1, 0, last), np.clip(after, 0, last)
        # Infinitely far from the knot that does not exist
        a = np.where(after > 0, time - self.time[i], np.inf)[:, None] / self.correlation_times
        b = np.where(after <= last, self.time[j] - time, np.inf)[:, None] / self.correlation_times
        fresh_a, fresh_b = -np.expm1(-2 * a), -np.expm1(-2 * b)
        fresh = -np.expm1(-2 * (a + b))
        before, behind = np.exp(-a) * fresh_b / fresh, np.exp(-b) * fresh_a / fresh
        crossed = np.zeros_like(before)
        if last > 0:
            inside = (after > 0) & (after <= last)
            crossed[inside] = (before * behind)[inside] * beside[i[inside]]
        mean = before * z[i] + behind * z[j]
        spread = before**2 * variance[i] + behind**2 * variance[j] + 2 * crossed
        spread += fresh_a * fresh_b / fresh
        sigma = np.maximum(prior_sigma, MIN_POS_SIGMA)
        return sigma * mean, sigma * np.sqrt(np.maximum(spread, 0.0))

    def at(self, time: Array, prior_sigma: Array) -> "CorrectionsAtTimes":
        """Corrections at any times; zero where the data do not support them.

        Parameters
        ----------
        time : ndarray of shape (n,), seconds, in the time base of the trajectory
        prior_sigma : ndarray of shape (n, 6), metres and radians
            Standard deviations of the POS at these times, as the adjustment used them.
        """
        correction, sigma = self.collocate(time, prior_sigma)
        prior = np.maximum(prior_sigma, MIN_POS_SIGMA)
        supported = (1 - (sigma / prior) ** 2 >= MIN_SUPPORTED_SHARE) & self.determined
        return CorrectionsAtTimes(
            time,
            np.where(supported, correction, 0.0),
            np.where(supported, sigma, prior),
            prior,
            supported,
            self.is_sighted(time) & supported.any(axis=1),
        )


@dataclass(frozen=True, eq=False)
class CorrectionsAtTimes:
    """Corrections of the POS at chosen times; components and units as in `PosCorrections`.

    Attributes
    ----------
    time : ndarray of shape (n,), seconds
    correction, sigma : ndarray of shape (n, 6), metres and radians
        Correction and its standard deviation; zero and the prior one where it is not supported.
    prior_sigma : ndarray of shape (n, 6), metres and radians
    supported : ndarray of shape (n, 6), bool
        Whether the data support the correction of each component.
    sighted : ndarray of shape (n,), bool
        Whether the time lies in a sighted interval.
    """

    time: Array
    correction: Array
    sigma: Array
    prior_sigma: Array
    supported: NDArray[np.bool_]
    sighted: NDArray[np.bool_]
