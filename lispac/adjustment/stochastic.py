"""How the POS errors of the points belong together.

``independent`` is the thesis: every point has a POS error of its own. An INS does not work like
that: a target is crossed in about a second, and all its points share one POS error, which
neighbouring sightings share in part. ``correlated`` says so: each sighting carries three position
and three attitude errors, drawn from a first-order Gauss-Markov process with the trajectory's
accuracy as its standard deviation.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.observations import Observations

Array = NDArray[np.float64]

PosErrors = Literal["independent", "correlated"]
POS_ERRORS: tuple[PosErrors, ...] = ("correlated", "independent")


@dataclass(frozen=True)
class StochasticModel:
    """Model of the POS errors by name, with its correlation times in seconds.

    The position of a post-processed GNSS/INS solution drifts over minutes (multipath, satellite
    geometry); its attitude more slowly. Where the processing report states correlation times, use
    them; too long a time is safer than too short a one.
    """

    pos_errors: PosErrors = "correlated"
    position_time: float = 300.0
    attitude_time: float = 600.0


def effect_factor(observations: Observations, model: StochasticModel) -> Array:
    """Factor L of the prior covariance ``C = L L'`` of all sightings' POS errors.

    A factor instead of the inverse, because two targets seen at the same instant share their
    error exactly and make C singular.

    Returns
    -------
    ndarray of shape (sightings, 6, sightings * 6)
        POS errors (metres, radians) by independent unit normal variables.
    """
    count = len(observations.sightings)
    time = observations.mean_by_sighting(observations.time)
    apart = np.abs(time[:, None] - time[None, :])
    sigma = np.hstack(
        [
            observations.mean_by_sighting(observations.sigma_position),
            observations.mean_by_sighting(observations.sigma_attitude),
        ]
    )
    factor = np.zeros((count, 6, count, 6))
    for k, correlation_time in enumerate([model.position_time] * 3 + [model.attitude_time] * 3):
        covariance = np.exp(-apart / correlation_time) * np.outer(sigma[:, k], sigma[:, k])
        eigenvalues, vectors = np.linalg.eigh(covariance)
        factor[:, k, :, k] = vectors * np.sqrt(np.clip(eigenvalues, 0, None))
    return factor.reshape(count, 6, count * 6)
