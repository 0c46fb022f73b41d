"""Further models of POS errors: white noise, GNSS outage, jumps, and combinations.

A model draws errors and gives the variances that the POS would report for them. Times are relative
to the first sample of the trajectory.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
SigmaTriple = tuple[float, float, float]
"""Sigmas of three errors: north, east and up, or roll, pitch and heading."""
NORTH_EAST_UP_TO_LOCAL = np.array([1.0, -1.0, 1.0])
"""Factors that convert north, east, up to north, west, up."""


class PosErrors(Protocol):
    """Interface of models of POS errors."""

    def draw(
        self, count: int, interval: float, generator: np.random.Generator
    ) -> tuple[Array, Array]:
        """Draw the errors during a survey.

        Returns
        -------
        position : ndarray of shape (count, 3), metres, local (north, west, up)
        attitude : ndarray of shape (count, 3), radians; roll, pitch, heading
        """

    def variance(self, count: int, interval: float) -> Array:
        """Variances of the errors as the POS reports them, (count, 6), metres and radians squared.

        North, east, up, roll, pitch, heading.
        """


@dataclass(frozen=True)
class WhiteNoise:
    """White noise: errors without correlation in time.

    Attributes
    ----------
    sigma_position : tuple of float, metres; north, east, up
    sigma_attitude : tuple of float, radians; roll, pitch, heading
    """

    sigma_position: SigmaTriple
    sigma_attitude: SigmaTriple

    def draw(
        self, count: int, interval: float, generator: np.random.Generator
    ) -> tuple[Array, Array]:
        """Draw errors; see `PosErrors.draw`."""
        sigma = np.array([*self.sigma_position, *self.sigma_attitude])
        errors = sigma * generator.standard_normal((count, 6))
        return errors[:, :3] * NORTH_EAST_UP_TO_LOCAL, errors[:, 3:]

    def variance(self, count: int, interval: float) -> Array:
        """Variances of the errors; see `PosErrors.variance`."""
        return np.tile(np.square([*self.sigma_position, *self.sigma_attitude]), (count, 1))


@dataclass(frozen=True)
class GnssOutage:
    """Inertial drift during a GNSS outage.

    Errors of the acceleration are white noise. The velocity error is a random walk, the position
    error its integral, so that its sigma grows with time to the power 3/2. The attitude error is a
    random walk. In a smoothed trajectory (forward and backward processing), position, velocity
    and attitude have no error at the end of the outage. The sigma of the position is then largest
    in the middle of the outage: one eighth of the sigma at the end without smoothing.

    Attributes
    ----------
    start, duration : float, seconds
    sigma_position : tuple of float, metres; north, east, up
    sigma_attitude : tuple of float, radians; roll, pitch, heading
        Standard deviations at the end of the outage without smoothing.
    smoothed : bool
    """

    start: float
    duration: float
    sigma_position: SigmaTriple
    sigma_attitude: SigmaTriple
    smoothed: bool = True

    def draw(
        self, count: int, interval: float, generator: np.random.Generator
    ) -> tuple[Array, Array]:
        """Draw errors; see `PosErrors.draw`."""
        t = np.arange(count) * interval - self.start
        inside = np.flatnonzero((t > 0) & (t <= self.duration))
        drift = np.zeros((count, 6))
        if len(inside):
            # The end of the outage, where the smoothed errors are zero, is added as a knot.
            steps = np.diff(np.concatenate([[0.0], t[inside], [self.duration]]))
            position, velocity = _integrated_walk(steps, generator)
            walk = np.cumsum(
                np.sqrt(steps)[:, None] * generator.standard_normal((len(steps), 3)), 0
            )
            if self.smoothed:
                position, walk = self._smooth(position, velocity, walk, np.cumsum(steps))
            drift[inside, :3] = position[:-1] * np.sqrt(3 / self.duration**3) * self.sigma_position
            drift[inside, 3:] = walk[:-1] / np.sqrt(self.duration) * self.sigma_attitude
        return drift[:, :3] * NORTH_EAST_UP_TO_LOCAL, drift[:, 3:]

    def _smooth(
        self, position: Array, velocity: Array, walk: Array, t: Array
    ) -> tuple[Array, Array]:
        """Errors under the condition that position, velocity and attitude are exact at the end."""
        whole = self.duration
        at_end = np.array([[whole**3 / 3, whole**2 / 2], [whole**2 / 2, whole]])
        with_end = np.stack([t**2 * (3 * whole - t) / 6, t**2 / 2], axis=1)
        gain = with_end @ np.linalg.inv(at_end)
        return (
            position - gain @ np.stack([position[-1], velocity[-1]]),
            walk - (t / whole)[:, None] * walk[-1],
        )

    def variance(self, count: int, interval: float) -> Array:
        """Variances of the errors; see `PosErrors.variance`."""
        t = np.arange(count) * interval - self.start
        u = np.where((t > 0) & (t <= self.duration), t / self.duration, 0.0)[:, None]
        position, attitude = u**3, u
        if self.smoothed:
            position, attitude = u**3 * (1 - u) ** 3, u * (1 - u)
        return np.hstack(
            [position * np.square(self.sigma_position), attitude * np.square(self.sigma_attitude)]
        )


def _integrated_walk(steps: Array, generator: np.random.Generator) -> tuple[Array, Array]:
    """Integrals of random walks and the walks, unit density, exact at the knots, shape (n, 3)."""
    first, second = generator.standard_normal((2, len(steps), 3))
    h = steps[:, None]
    increment = np.sqrt(h) * first
    velocity = np.cumsum(increment, axis=0)
    # Integral within a step: half of its increment times the step, and an independent part
    within = h * increment / 2 + np.sqrt(h**3 / 12) * second
    before = velocity - increment
    return np.cumsum(h * before + within, axis=0), velocity


@dataclass(frozen=True)
class StepErrors:
    """Errors that jump and then stay constant, as with a wrong GNSS fix.

    Each jump draws a new error; there is none before the first jump. The variances that the POS
    reports do not include these errors.

    Attributes
    ----------
    sigma_position : tuple of float, metres; north, east, up
    sigma_attitude : tuple of float, radians; roll, pitch, heading
    at : tuple of float, seconds
        Times of jumps.
    per_hour : float
        Mean number of additional jumps per hour, at random times.
    """

    sigma_position: SigmaTriple
    sigma_attitude: SigmaTriple
    at: tuple[float, ...] = ()
    per_hour: float = 0.0

    def draw(
        self, count: int, interval: float, generator: np.random.Generator
    ) -> tuple[Array, Array]:
        """Draw errors; see `PosErrors.draw`."""
        span = count * interval
        extra = generator.poisson(self.per_hour * span / 3600)
        times = np.sort(np.concatenate([self.at, generator.uniform(0, span, extra)]))
        sigma = np.array([*self.sigma_position, *self.sigma_attitude])
        levels = np.vstack([np.zeros(6), sigma * generator.standard_normal((len(times), 6))])
        errors = levels[np.searchsorted(times, np.arange(count) * interval, side="right")]
        return errors[:, :3] * NORTH_EAST_UP_TO_LOCAL, errors[:, 3:]

    def variance(self, count: int, interval: float) -> Array:
        """Variances of the errors; see `PosErrors.variance`."""
        return np.zeros((count, 6))


@dataclass(frozen=True)
class CombinedModel:
    """Sum of several independent models.

    Attributes
    ----------
    parts : tuple of PosErrors
    """

    parts: tuple[PosErrors, ...]

    def draw(
        self, count: int, interval: float, generator: np.random.Generator
    ) -> tuple[Array, Array]:
        """Draw errors; see `PosErrors.draw`."""
        streams = generator.spawn(len(self.parts))
        position, attitude = np.zeros((count, 3)), np.zeros((count, 3))
        for part, stream in zip(self.parts, streams, strict=True):
            part_position, part_attitude = part.draw(count, interval, stream)
            position += part_position
            attitude += part_attitude
        return position, attitude

    def variance(self, count: int, interval: float) -> Array:
        """Variances of the errors; see `PosErrors.variance`."""
        total = np.zeros((count, 6))
        for part in self.parts:
            total += part.variance(count, interval)
        return total


def combine_models(parts: Sequence[PosErrors]) -> PosErrors:
    """Combine models into one; a single model is returned unchanged."""
    return parts[0] if len(parts) == 1 else CombinedModel(tuple(parts))
