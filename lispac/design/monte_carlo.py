"""Monte Carlo check of the sigmas: a plan is simulated and adjusted many times.

The simulation is independent of the prediction (`lispac.design.prediction`), except for the number
of points of a sighting. It includes form errors of the boards, LiDAR noise, POS errors correlated
in time, errors of surveyed control, and the motion of the vessel.
"""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations, Sighting
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.model.threads import single_blas_thread
from lispac.adjustment.result import ANGLES
from lispac.adjustment.solve.determinability import ANGLE_CODES
from lispac.design.plan import Plan
from lispac.design.plan_search import Mapper
from lispac.design.prediction import (
    MIN_SIGHTING_POINTS,
    NO_SIGHTINGS_MESSAGE,
    UNDETERMINED_MESSAGE,
    expected_point_count,
    planned_control,
    predict,
)
from lispac.errors import AdjustmentError, Cancelled, LispacError, RankDeficient
from lispac.language import gettext_lazy
from lispac.messages import Message, error, note, warning
from lispac.progress import Progress, no_progress
from lispac.simulation.closed_form_survey import (
    Ball,
    Board,
    SeaMotion,
    add_errors,
    error_free_record,
    observations_of_records,
    scanner_position_abeam,
)

Array = NDArray[np.float64]
CRITICAL_SIGMAS = 3.0
"""Critical value of the tests of coverage and mean error, in standard deviations."""
MIN_SURVEYS = 20
"""Smallest number of surveys for a result; a standard deviation is then uncertain by about 16 %."""


@dataclass(frozen=True, eq=False)
class MonteCarloResult:
    """Results of many simulated surveys of a plan.

    Attributes
    ----------
    errors, sigmas : ndarray of shape (surveys, 3), radians
        Errors and formal sigmas of roll, pitch and yaw in each survey that could be adjusted.
    predicted : ndarray of shape (3,), radians
        Sigmas predicted from the plan.
    correlation : ndarray of shape (3, 3)
        Correlations of the angles predicted from the plan.
    failed : int
        Number of surveys that could not be adjusted.
    """

    errors: Array
    sigmas: Array
    predicted: Array
    correlation: Array
    failed: int

    @property
    def empirical_sigma(self) -> Array:
        """RMS error of the estimated angles, shape (3,), radians."""
        return np.asarray(np.sqrt((self.errors**2).mean(axis=0)))

    @property
    def mean_formal_sigma(self) -> Array:
        """Mean formal sigma of the adjustments, shape (3,), radians."""
        return np.asarray(self.sigmas.mean(axis=0))

    @property
    def interval_coverage(self) -> Array:
        """Share of the 95 % confidence intervals that contain the truth, shape (3,)."""
        return np.asarray((np.abs(self.errors) < 1.96 * self.sigmas).mean(axis=0))

    @property
    def ratio(self) -> Array:
        """``empirical_sigma`` divided by ``predicted``, shape (3,)."""
        return self.empirical_sigma / self.predicted

    @property
    def ratio_sigma(self) -> float:
        """Relative standard deviation of ``empirical_sigma``, no unit, from the sample size."""
        return float(1 / np.sqrt(2 * len(self.errors)))

    @property
    def bias(self) -> Array:
        """Mean error, shape (3,), radians."""
        return np.asarray(self.errors.mean(axis=0))

    @property
    def sigma_bias(self) -> Array:
        """Standard deviation of ``bias``, shape (3,), radians."""
        return self.empirical_sigma / np.sqrt(len(self.errors))

    @property
    def chi_square(self) -> float:
        """Chi-square of errors with the predicted covariance; expectation: ``errors.size``."""
        unit, inverse = self.errors / self.predicted, np.linalg.inv(self.correlation)
        return float(np.einsum("ni,ij,nj->", unit, inverse, unit))

    @property
    def chi_square_bounds(self) -> tuple[float, float]:
        """Bounds of the central 95 % of the distribution of ``chi_square``."""
        from scipy.special import chdtri  # takes the upper tail

        count = self.errors.size
        return float(chdtri(count, 0.975)), float(chdtri(count, 0.025))

    @property
    def messages(self) -> tuple[Message, ...]:
        """Conclusions on the sigmas, the mean errors and chi-square."""
        coverage_sigma = np.sqrt(0.95 * 0.05 / len(self.errors))
        names = [note(ANGLE_CODES[name]) for name in ANGLES]
        found = [
            warning("campaign.sigma_too_small", angle=name, share=float(share))
            for name, share in zip(names, self.interval_coverage, strict=True)
            if share < 0.95 - CRITICAL_SIGMAS * coverage_sigma
        ] or [note("campaign.coverage_agrees", count=len(self.errors))]
        found += [
            warning("campaign.mean_error", angle=name, mean=float(mean))
            for name, mean, sigma in zip(names, self.bias, self.sigma_bias, strict=True)
            if abs(mean) > CRITICAL_SIGMAS * sigma
        ]
        low, high = self.chi_square_bounds
        values: dict[str, Any] = {"value": self.chi_square, "low": low, "high": high}
        if self.chi_square > high:
            found.append(warning("campaign.errors_larger", **values))
        elif self.chi_square < low:
            found.append(note("campaign.errors_smaller", **values))
        else:
            found.append(note("campaign.errors_agree", **values))
        if self.failed:
            found.append(note("campaign.not_adjusted", count=self.failed))
        return tuple(found)


def run_monte_carlo(
    plan: Plan,
    surveys: int,
    *,
    seed: int = 2027,
    flatness_known: bool = False,
    enough: int | None = None,
    mapper: Mapper = map,
    progress: Progress = no_progress,
) -> MonteCarloResult:
    """Simulate and adjust many surveys of a plan.

    Parameters
    ----------
    seed : int
        Seed of the random numbers. Each survey has its own stream, so that the result does not
        depend on the mapper.
    flatness_known : bool
        Use the flatness of the targets in the adjustment instead of estimating it.
    enough : int, optional
        Number of surveys that is enough for a result if ``progress`` cancels the others.
    mapper : callable
        As in `lispac.design.plan_search.search`.

    Raises
    ------
    RankDeficient
        The plan does not determine the boresight.
    LispacError
        No survey could be adjusted, or ``flatness_known`` is set although targets have their own
        flatness.
    Cancelled
        The run was cancelled before ``enough`` surveys were adjusted.
    """
    if flatness_known and any(target.flatness is not None for target in plan.targets):
        raise LispacError(error("design.own_flatness"))
    prediction = predict(plan)
    if not prediction.determined:
        raise RankDeficient(UNDETERMINED_MESSAGE)
    trial = _SurveyTrial(plan, plan.flatness if flatness_known else None, seed)
    found = []
    try:
        for one_result in mapper(trial, range(surveys)):
            found.append(one_result)
            progress(
                len(found) / surveys,
                gettext_lazy(
                    "Adjusted surveys: {count:n} of {total:n}", count=len(found), total=surveys
                ),
            )
    except Cancelled:
        if enough is None or len(found) < enough:
            raise
    table = np.array(found)
    table = table[np.isfinite(table).all(axis=(1, 2))]
    if not len(table):
        raise LispacError(error("design.none_adjusted"))
    return MonteCarloResult(
        table[:, 0], table[:, 1], prediction.sigma, prediction.correlation, len(found) - len(table)
    )


@dataclass(frozen=True, eq=False)
class _SurveyTrial:
    """Function that simulates and adjusts the survey with a given number.

    It returns the errors and the formal sigmas, shape (2, 3), radians; NaN if the adjustment fails.
    """

    plan: Plan
    surface: float | None
    seed: int

    def __call__(self, number: int) -> Array:
        stream = np.random.SeedSequence(self.seed, spawn_key=(number,))
        system = self.plan.system
        sigma = system.lever_arm_sigma
        model = StochasticModel(
            system.pos_errors, system.pos.time_position, system.pos.time_attitude, self.surface,
            lever_arm_sigma=sigma if any(sigma) else None,
        )  # fmt: skip
        with single_blas_thread():
            generator = np.random.default_rng(stream)
            survey = simulate_plan(self.plan, generator)
            prior = system.mounting.with_boresight(np.zeros(3))
            if any(sigma):
                errors = np.array(sigma) * generator.standard_normal(3)
                prior = replace(prior, lever_arm=prior.lever_arm + errors)
            try:
                result = adjust(survey, prior, model, diagnostics=False)
            except AdjustmentError:
                return np.full((2, 3), np.nan)
        return np.stack([result.boresight - system.mounting.boresight, result.sigma])


def simulate_plan(
    plan: Plan, generator: np.random.Generator, *, perfect: bool = False, calm: bool = False
) -> Observations:
    """Simulate one survey of a plan as observations of the adjustment.

    Parameters
    ----------
    perfect : bool
        Simulate targets, control, scanner and POS without errors.
    calm : bool
        Simulate a vessel without sea motion: it stays level and on its lines.

    Raises
    ------
    RankDeficient
        No target is visible on any line.
    """
    system, rows, sightings = plan.system, [], []
    sea = SeaMotion.draw(generator)
    if calm:
        sea = replace(sea, sigma=0.0 * sea.sigma)
    for target in plan.targets:
        flatness = plan.flatness if target.flatness is None else target.flatness
        for course in plan.courses:
            scanner = scanner_position_abeam(system.mounting, target, course)
            count = expected_point_count(system, target, course, scanner)
            if count < MIN_SIGHTING_POINTS:
                continue
            off = (0.0 if perfect else flatness) * generator.standard_normal(3)
            points = _simulate_target_points(target, count, off, generator, scanner)
            rows.append(error_free_record(system.mounting, course, sea, points))
            sightings.append(Sighting(target.name, course.name))
    if not rows:
        raise RankDeficient(NO_SIGHTINGS_MESSAGE)
    exact = observations_of_records(
        rows, sightings, plan.targets, system.pos, system.scanner.range_sigma
    )
    sigma = exact.sigma_lidar.copy()
    ranges = np.linalg.norm(exact.points_lidar, axis=1)
    sigma[:, 1:] = system.scanner.angle_sigma * ranges[:, None]
    exact = replace(exact, sigma_lidar=sigma, beam_sigmas=True)
    names = {sighting.target for sighting in sightings}
    surveyed = [target for target in plan.targets if target.name in names]
    if perfect:
        return replace(exact, control=planned_control(surveyed))
    observed = add_errors(exact, system.pos, generator)
    return replace(observed, control=planned_control(surveyed, generator))


def _simulate_target_points(
    target: Board | Ball, count: float, off: Array, generator: np.random.Generator, scanner: Array
) -> Array:
    """Simulate the points of one sighting, one at random in each cell of a regular grid.

    Parameters
    ----------
    off : ndarray of shape (3,), metres
        Form error of the target in this line: tilts about two axes, as displacements at the edge,
        and a shift along the normal. For a ball, only the last one is used: it changes the radius.

    Returns
    -------
    ndarray of shape (about ``count``, 3), metres, local
    """
    # The visible part of a ball is a disc inscribed in the square of the grid.
    side = round(np.sqrt(count * 4 / np.pi if isinstance(target, Ball) else count))
    fields = np.stack(np.divmod(np.arange(side**2), side))
    u, v = 2 * (fields + generator.uniform(0, 1, fields.shape)) / side - 1
    if isinstance(target, Ball):
        points = target.cap(target.visible_radius * u, target.visible_radius * v, scanner)
        return points + off[2] * (points - np.array(target.centre)) / target.radius
    points = target.points_on_board(u * target.width / 2, v * target.height / 2)
    return np.asarray(points + (u * off[0] + v * off[1] + off[2])[:, None] * target.facing)
