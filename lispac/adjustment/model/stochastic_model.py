"""Stochastic model: how the POS errors of the points are correlated.

``independent`` is the thesis: every point has a POS error of its own. An INS does not work like
that: a target is crossed in about a second, and all its points share one slowly drifting POS
error, which neighbouring sightings share in part. ``correlated`` models this: three position and
three attitude errors are functions of time, drawn from a first-order Gauss-Markov process
(Gelb 1974) with the trajectory's accuracy as its standard deviation, and are estimated along
with the boresight.
"""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.robust_loss import LossName

Array = NDArray[np.float64]

PosErrors = Literal["independent", "correlated"]
POS_ERRORS: tuple[PosErrors, ...] = ("correlated", "independent")


@dataclass(frozen=True)
class StochasticModel:
    """Stochastic model with its correlation times and sigmas.

    The position of a post-processed GNSS/INS solution drifts over minutes (multipath, satellite
    geometry); its attitude more slowly. Where the processing report gives correlation times, use
    them; too short a time is safer than too long a one.

    Attributes
    ----------
    pos_errors : {"correlated", "independent"}
    position_time, attitude_time : float, seconds
        Correlation times of the POS error; ``correlated`` alone.
    surface : float or None, metres
        How far what one line sees of a target may lie off the shape all lines have in common,
        over the whole sighting: a bent board, rough ground, range errors that depend on how the
        beam falls. Each sighting gets an offset of this sigma and, for planes, two tilts that
        lift its border by as much; None takes the sigma from the data. ``correlated`` alone.
    offset : float or None, metres
        Sigma of the offsets where ``surface`` is that of the tilts alone.
    loss : {"none", "huber", "tukey"}
        Loss function that weights outliers.
    """

    pos_errors: PosErrors = "correlated"
    position_time: float = 300.0
    attitude_time: float = 600.0
    surface: float | None = None
    loss: LossName = "none"
    offset: float | None = None

    @property
    def knot_interval(self) -> float:
        """Seconds between the knots of the POS error: shorter for shorter correlation times."""
        fastest = min(self.position_time, self.attitude_time)
        return float(np.clip(fastest / 250, SHORTEST_INTERVAL, KNOT_INTERVAL))

    @property
    def correlated(self) -> bool:
        """Whether points share their POS errors."""
        return self.pos_errors == "correlated"


SHORTEST_INTERVAL, KNOT_INTERVAL = 0.02, 0.15
"""Seconds between the knots of the POS error. Halfway between two, a process of 300 s and 12 mm
deviates from its chord by 0.19 mm; that much is added to the noise of the points."""

SMALLEST_SIGMA = 1e-9
"""Metres and radians: an accuracy given as zero still needs a finite weight."""


@dataclass(frozen=True, eq=False)
class PosErrorKnots:
    """POS error as a function of time, linear between knots on a regular grid.

    Knots stand only where points are. The process is Markov: its precision couples neighbouring
    knots alone, so that the cost is linear in their number.

    Attributes
    ----------
    time : ndarray of shape (k,), seconds, increasing
    left : ndarray of shape (n,), int
        Knot before each point; the next one is after it.
    fraction : ndarray of shape (n,), in [0, 1)
        Where each point is between its two knots.
    outlying : ndarray of shape (n,)
        ``u (1 - u)`` of a point at the fraction u. A mean of points at several times deviates
        less: they deviate to both sides.
    precision_diagonal : ndarray of shape (k, 6), per square metre and square radian
    precision_beside : ndarray of shape (k - 1, 6)
        Between each knot and the next.
    bridge : ndarray of shape (6,)
        Variance, over that of the process, by which it deviates from the chord between two knots,
        over ``outlying``.
    """

    time: Array
    left: NDArray[np.int64]
    fraction: Array
    outlying: Array
    precision_diagonal: Array
    precision_beside: Array
    bridge: Array

    @classmethod
    def of(cls, observations: Observations, model: StochasticModel) -> "PosErrorKnots":
        """Create the knots and their prior for the points of ``observations``."""
        interval = model.knot_interval
        scaled = observations.time / interval
        cell = np.floor(scaled).astype(np.int64)
        # Neighbouring points are mostly in the same cell: few are left to sort
        occupied = np.unique(cell[np.flatnonzero(np.diff(cell, prepend=cell[0] - 1))])
        grid = np.unique(np.concatenate([occupied, occupied + 1]))
        time = grid * interval
        left = np.searchsorted(grid, cell).astype(np.int64)
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
        sigma = np.maximum(sigma, SMALLEST_SIGMA)
        correlation_time = np.repeat([model.position_time, model.attitude_time], 3)
        step = np.diff(time)[:, None] / correlation_time
        kept = np.exp(-step)  # correlation with the next knot
        fresh = -np.expm1(-2 * step)  # 1 - kept**2, exact for short steps
        fraction = scaled - cell
        outlying = fraction * (1 - fraction)
        if observations.time_separation is not None:
            # Of a Brownian bridge over (0, 1), E min(u, v) - E u E v
            outlying = np.maximum(outlying - observations.time_separation / (2 * interval), 0.0)
        diagonal = np.ones((len(time), 6))
        diagonal[1:] = 1 / fresh
        diagonal[:-1] += kept**2 / fresh
        return cls(
            time,
            left,
            fraction,
            outlying,
            diagonal / sigma**2,
            -kept / fresh / (sigma[:-1] * sigma[1:]),
            2 * interval / correlation_time,
        )

    def reordered(self, order: NDArray[np.int64]) -> "PosErrorKnots":
        """The same knots for the points in another order, shape (n,)."""
        return replace(
            self,
            left=self.left[order],
            fraction=self.fraction[order],
            outlying=self.outlying[order],
        )

    def apply_prior_precision(self, effects: Array) -> Array:
        """Prior precision times ``effects``, both of shape (k, 6)."""
        product = self.precision_diagonal * effects
        product[:-1] += self.precision_beside * effects[1:]
        product[1:] += self.precision_beside * effects[:-1]
        return product
