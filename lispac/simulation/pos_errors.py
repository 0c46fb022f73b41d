"""POS errors that are correlated in time, as in a post-processed trajectory.

Each error is a first-order Gauss-Markov process (Gelb 1974), drawn with its exact recursion.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def gauss_markov(
    count: int,
    interval: float,
    sigma: float,
    correlation_time: float,
    generator: np.random.Generator,
) -> Array:
    """Draw a stationary first-order Gauss-Markov process.

    The autocovariance is ``sigma**2 exp(-|lag| / correlation_time)`` from the first sample on.

    Parameters
    ----------
    count : int
        Number of samples.
    interval : float, seconds between samples
    sigma : float, unit of the result
    correlation_time : float, seconds

    Returns
    -------
    ndarray of shape (count,)
    """
    from scipy.signal import lfilter  # slow import, not needed without errors

    memory = np.exp(-interval / correlation_time)
    drive = sigma * generator.standard_normal(count)
    # The first sample has the stationary variance; the noise of the others maintains it.
    drive[1:] *= np.sqrt(1 - memory**2)
    return np.asarray(lfilter([1.0], [1.0, -memory], drive))


@dataclass(frozen=True)
class PosErrorModel:
    """Standard deviations and correlation times of a POS.

    Attributes
    ----------
    sigma_position : tuple of float, metres; north, east, up
    sigma_attitude : tuple of float, radians; roll, pitch, heading
    time_position, time_attitude : float, seconds
        Correlation times.
    """

    sigma_position: tuple[float, float, float]
    sigma_attitude: tuple[float, float, float]
    time_position: float = 300.0
    time_attitude: float = 600.0

    def draw(
        self, count: int, interval: float, generator: np.random.Generator
    ) -> tuple[Array, Array]:
        """Draw the errors during a survey.

        Returns
        -------
        position : ndarray of shape (count, 3), metres, local (north, west, up)
        attitude : ndarray of shape (count, 3), radians; roll, pitch, heading
        """
        streams = generator.spawn(6)
        position = [
            gauss_markov(count, interval, sigma, self.time_position, stream)
            for sigma, stream in zip(self.sigma_position, streams[:3], strict=True)
        ]
        attitude = [
            gauss_markov(count, interval, sigma, self.time_attitude, stream)
            for sigma, stream in zip(self.sigma_attitude, streams[3:], strict=True)
        ]
        return np.stack(position, axis=1) * (1.0, -1.0, 1.0), np.stack(attitude, axis=1)

    def variance(self, count: int, interval: float) -> Array:
        """Variances that the POS reports, shape (count, 6), metres and radians squared.

        North, east, up, roll, pitch, heading.
        """
        return np.tile(np.square([*self.sigma_position, *self.sigma_attitude]), (count, 1))


HYDROGRAPHIC_INS = PosErrorModel(
    sigma_position=(0.012, 0.012, 0.020),
    sigma_attitude=(np.radians(0.008), np.radians(0.008), np.radians(0.012)),
)
"""POS of the built-in survey: an INS for hydrography with post-processed GNSS."""
