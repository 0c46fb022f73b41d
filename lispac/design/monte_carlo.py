"""Do the sigmas hold? A plan surveyed many times, each survey adjusted like any other."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.blas import one_thread
from lispac.adjustment.result import ANGLES
from lispac.adjustment.solver import adjust
from lispac.adjustment.stochastic import StochasticModel
from lispac.design.plan import Plan
from lispac.design.prediction import UNDETERMINED, predict
from lispac.design.search import Mapper
from lispac.design.simulated_plan import simulated
from lispac.errors import AdjustmentError, LispacError, RankDeficient
from lispac.progress import Progress, no_progress

Array = NDArray[np.float64]

SURE = 3.0
"""Standard deviations of chance beyond which a share of intervals is not by chance."""


@dataclass(frozen=True, eq=False)
class Scatter:
    """What many surveys of a plan gave.

    Attributes
    ----------
    errors, sigmas : ndarray of shape (surveys, 3), radians
        Of roll, pitch, yaw; of the surveys that could be adjusted.
    foretold : ndarray of shape (3,), radians
        Sigmas from the plan alone.
    failed : int
        Surveys that could not be adjusted.
    """

    errors: Array
    sigmas: Array
    foretold: Array
    failed: int

    @property
    def empirical(self) -> Array:
        """Standard deviation of the answers about the truth, shape (3,), radians."""
        return np.asarray(np.sqrt((self.errors**2).mean(axis=0)))

    @property
    def stated(self) -> Array:
        """Mean sigma that the adjustments state, shape (3,), radians."""
        return np.asarray(self.sigmas.mean(axis=0))

    @property
    def hits(self) -> Array:
        """Share of the stated 95 % intervals that hold the truth, shape (3,)."""
        return np.asarray((np.abs(self.errors) < 1.96 * self.sigmas).mean(axis=0))

    @property
    def by_chance(self) -> float:
        """Standard deviation of ``empirical`` over its true value."""
        return float(1 / np.sqrt(2 * len(self.errors)))

    @property
    def words(self) -> tuple[str, ...]:
        """What it comes to, in sentences."""
        chance = np.sqrt(0.95 * 0.05 / len(self.errors))
        said = [
            f"The stated sigma of {angle} is too small: its 95 % interval holds the truth in "
            f"{share:.0%} of the surveys."
            for angle, share in zip(ANGLES, self.hits, strict=True)
            if share < 0.95 - SURE * chance
        ]
        if not said:
            said = [
                f"As far as {len(self.errors):,} surveys can tell, the stated 95 % intervals hold "
                "the truth as often as they should."
            ]
        if self.failed:
            said.append(f"{self.failed} surveys could not be adjusted and are left out.")
        return tuple(said)


def surveyed(
    plan: Plan,
    surveys: int,
    *,
    seed: int = 2027,
    flatness_known: bool = False,
    mapper: Mapper = map,
    progress: Progress = no_progress,
) -> Scatter:
    """Simulate and adjust many surveys of a plan.

    Parameters
    ----------
    seed : int
        Every survey has its own stream of it: the same numbers with any mapper.
    flatness_known : bool
        Whether the adjustment is told how flat the targets are, and does not ask the data.
    mapper : callable
        As of `lispac.design.search.search`.

    Raises
    ------
    RankDeficient
        The plan does not determine the boresight.
    LispacError
        No survey could be adjusted, or one flatness is to be told where targets have their own.
    """
    if flatness_known and any(target.flatness is not None for target in plan.targets):
        raise LispacError(
            "The adjustment can be told one flatness for all targets, and this plan states some of "
            "their own: let it be taken from the data."
        )
    prediction = predict(plan)
    if not prediction.determined:
        raise RankDeficient(UNDETERMINED)
    trial = _Trial(plan, plan.flatness if flatness_known else None, seed)
    found = []
    for answer in mapper(trial, range(surveys)):
        found.append(answer)
        progress(len(found) / surveys, f"Adjusted {len(found):,} of {surveys:,} surveys")
    table = np.array(found)
    table = table[np.isfinite(table).all(axis=(1, 2))]
    if not len(table):
        raise LispacError("None of the simulated surveys could be adjusted; add lines or targets.")
    return Scatter(table[:, 0], table[:, 1], prediction.sigma, surveys - len(table))


@dataclass(frozen=True, eq=False)
class _Trial:
    """One survey by its number: error and sigma, shape (2, 3), not a number where it fails."""

    plan: Plan
    surface: float | None
    seed: int

    def __call__(self, number: int) -> Array:
        stream = np.random.SeedSequence(self.seed, spawn_key=(number,))
        system = self.plan.system
        model = StochasticModel(
            system.pos_errors, system.pos.time_position, system.pos.time_attitude, self.surface
        )
        with one_thread():
            survey = simulated(self.plan, np.random.default_rng(stream))
            try:
                result = adjust(
                    survey, system.mounting.with_boresight(np.zeros(3)), model, diagnostics=False
                )
            except AdjustmentError:
                return np.full((2, 3), np.nan)
        return np.stack([result.boresight - system.mounting.boresight, result.sigma])
