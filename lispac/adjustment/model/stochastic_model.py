"""Stochastic model: correlation of the POS errors of the points.

``independent`` is the model of the thesis, in which every point has its own POS error. In reality,
the error of a GNSS/INS solution changes slowly. A target is passed in about a second, so that all
points of a sighting have nearly the same POS error, and neighbouring sightings share part of it.

``correlated`` models this. The three position and three attitude errors are functions of time that
are estimated together with the boresight. Their prior is a first-order Gauss-Markov process (Gelb
1974) with the accuracy of the trajectory as standard deviation.
"""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.robust_loss import LossName

Array = NDArray[np.float64]

PosErrors = Literal["independent", "correlated"]
POS_ERROR_MODELS: tuple[PosErrors, ...] = ("correlated", "independent")


ASSUMED_POSITION_SIGMA: tuple[float, float, float] = (0.02, 0.02, 0.03)
"""Standard deviations of north, east and down if nobody gave them, metres."""
ASSUMED_ATTITUDE_SIGMA_DEG: tuple[float, float, float] = (0.01, 0.01, 0.015)
"""Standard deviations of roll, pitch and heading if nobody gave them, degrees."""
ASSUMED_LIDAR_SIGMA = 0.005
"""Standard deviation of the LiDAR on each axis if nobody gave it, metres."""


@dataclass(frozen=True)
class StochasticModel:
    """Stochastic model with its correlation times and sigmas.

    Position errors of a post-processed GNSS/INS solution change within minutes (multipath,
    satellite geometry), attitude errors more slowly. Correlation times of the processing report
    should be used if available. A time that is too short is safer than one that is too long.

    Attributes
    ----------
    pos_errors : {"correlated", "independent"}
    position_time, attitude_time : float, seconds
        Correlation times of the POS error; only for ``correlated``.
    surface : float or None, metres
        Sigma of the form errors: deviations of a whole sighting from the common shape of its target
        (a bent board, rough ground, range errors that depend on the angle of incidence). Each
        sighting has an offset with this sigma and, on planes, two tilts with this sigma at the
        border. None to estimate the sigma from the data. Only for ``correlated``.
    offset : float or None, metres
        Sigma of the offsets, if it differs from that of the tilts; ``surface`` is then that of the
        tilts.
    loss : {"none", "huber", "tukey"}
        Loss function that weights outliers.
    lever_arm_sigma : tuple of three float, metres, or None
        Sigmas of the given lever arm (forward, left, up), which increase those of the estimated
        values; None if it is assumed exact. Not used for components that are estimated.
    """

    pos_errors: PosErrors = "correlated"
    position_time: float = 300.0
    attitude_time: float = 600.0
    surface: float | None = None
    loss: LossName = "none"
    offset: float | None = None
    lever_arm_sigma: tuple[float, float, float] | None = None

    @property
    def knot_interval(self) -> float:
        """Time between the knots of the POS error, seconds; shorter for short correlation times."""
        fastest = min(self.position_time, self.attitude_time)
        return float(np.clip(fastest / 250, MIN_KNOT_INTERVAL, MAX_KNOT_INTERVAL))

    @property
    def correlated(self) -> bool:
        """Whether points share their POS errors."""
        return self.pos_errors == "correlated"


MIN_KNOT_INTERVAL, MAX_KNOT_INTERVAL = 0.02, 0.15
"""Shortest and longest time between the knots of the POS error, seconds.

Halfway between two knots, a process with a correlation time of 300 s and a sigma of 12 mm deviates
from the linear interpolation by 0.19 mm. This deviation is added to the noise of the points.
"""

MIN_POS_SIGMA = 1e-9
"""Smallest sigma of the POS errors, metres or radians; zero would give an infinite weight."""


@dataclass(frozen=True, eq=False)
class PosErrorKnots:
    """POS error as a function of time, linear between knots on a regular grid.

    There are knots only around points. The process is Markov, so that its precision matrix couples
    only neighbouring knots, and the cost is linear in the number of knots.

    Attributes
    ----------
    time : ndarray of shape (k,), seconds, increasing
    left : ndarray of shape (n,), int
        Index of the knot before each point.
    fraction : ndarray of shape (n,), in [0, 1)
        Position of each point between the knot before and the knot after it.
    bridge_variance : ndarray of shape (n,)
        ``u (1 - u)`` of a point at the fraction ``u``; smaller for the mean of points at several
        times, whose deviations from the interpolation partly cancel.
    sigma : ndarray of shape (k, 6), metres and radians
        Standard deviations of the process at the knots.
    precision_diagonal : ndarray of shape (k, 6), per square metre and square radian
        Diagonal of the prior precision matrix.
    precision_beside : ndarray of shape (k - 1, 6)
        Elements of the prior precision matrix between each knot and the next.
    bridge_factor : ndarray of shape (6,)
        The variance of the deviation from the linear interpolation is the product of this factor,
        ``bridge_variance`` and the variance of the process.
    """

    time: Array
    left: NDArray[np.int32]
    fraction: Array
    bridge_variance: Array
    sigma: Array
    precision_diagonal: Array
    precision_beside: Array
    bridge_factor: Array

    @classmethod
    def of(
        cls, observations: Observations, model: StochasticModel, interval: float | None = None
    ) -> "PosErrorKnots":
        """Create the knots and their prior for the points of ``observations``.

        Parameters
        ----------
        interval : float, seconds, optional
            Time between two knots; that of the model by default.
        """
        interval = model.knot_interval if interval is None else interval
        scaled = observations.time / interval
        cell = np.floor(scaled).astype(np.int64)
        # Successive points are mostly in the same cell, so that few numbers are left to sort
        occupied = np.unique(cell[np.flatnonzero(np.diff(cell, prepend=cell[0] - 1))])
        grid = np.unique(np.concatenate([occupied, occupied + 1]))
        time = grid * interval
        left = np.searchsorted(grid, cell).astype(np.int32)  # half the memory
        counts = np.bincount(left, minlength=len(grid))
        filled = counts > 0
        offset = np.bincount(left, observations.time - time[left], len(grid))[filled]
        middle = time[filled] + offset / counts[filled]
        sigma = np.empty((len(grid), 6))
        for k, column in enumerate(
            (*observations.sigma_position.T, *observations.sigma_attitude.T)
        ):
            mean = np.bincount(left, column, len(grid))[filled] / counts[filled]
            sigma[:, k] = np.interp(time, middle, mean)
        sigma = np.maximum(sigma, MIN_POS_SIGMA)
        correlation_time = np.repeat([model.position_time, model.attitude_time], 3)
        step = np.diff(time)[:, None] / correlation_time
        kept = np.exp(-step)  # correlation with the next knot
        fresh = -np.expm1(-2 * step)  # 1 - kept**2, exact for short steps
        fraction = scaled - cell
        bridge_variance = fraction * (1 - fraction)
        if observations.time_separation is not None:
            # Mean covariance of a Brownian bridge over (0, 1): E min(u, v) - E u E v
            bridge_variance = np.maximum(
                bridge_variance - observations.time_separation / (2 * interval), 0.0
            )
        diagonal = np.ones((len(time), 6))
        diagonal[1:] = 1 / fresh
        diagonal[:-1] += kept**2 / fresh
        return cls(
            time,
            left,
            fraction,
            bridge_variance,
            sigma,
            diagonal / sigma**2,
            -kept / fresh / (sigma[:-1] * sigma[1:]),
            2 * interval / correlation_time,
        )

    def reordered(self, order: NDArray[np.int64]) -> "PosErrorKnots":
        """Return the same knots for the points in another order, shape (n,)."""
        return replace(
            self,
            left=self.left[order],
            fraction=self.fraction[order],
            bridge_variance=self.bridge_variance[order],
        )

    def apply_prior_precision(self, values: Array) -> Array:
        """Multiply ``values``, shape (k, 6), by the prior precision matrix."""
        product = self.precision_diagonal * values
        product[:-1] += self.precision_beside * values[1:]
        product[1:] += self.precision_beside * values[:-1]
        return product
