"""Variance components estimated by restricted maximum likelihood.

The restricted likelihood (REML: Patterson and Thompson 1971) is that of the residuals, and does not
depend on the unknowns. It is computed for any sigmas from the sums of the adjustment, without
another pass over the points.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
import scipy
from numpy.typing import NDArray

from lispac.adjustment.result import SIGMA_GROUPS, SigmaGroup, VarianceComponent
from lispac.adjustment.solve.adjustment_problem import (
    ALL_COMPONENTS,
    OFFSET_COMPONENT,
    TILT_COMPONENTS,
    AdjustmentProblem,
    LinearisedProblem,
)
from lispac.adjustment.solve.banded_cholesky import cholesky_factor, forward_substitution

Array = NDArray[np.float64]

MIN_SURFACE_SIGMA, MAX_SURFACE_SIGMA = 1e-5, 0.3  # metres


MIN_LIKELIHOOD_GAIN = 10.0
"""Smallest gain in twice the log likelihood for a separate sigma of the offsets.

By chance, it is exceeded about once in 1000.
"""
ADDED_GAIN_IF_REJECTED = 5.0
"""Additional gain required if sightings were rejected.

Jumps of single sightings are about a dozen times more common, exp(5 / 2), than displaced boards.
"""


def most_likely_surface_sigma(
    linearised: LinearisedProblem, directions: slice = ALL_COMPONENTS
) -> float:
    """Most likely sigma of the deviations of sightings from the shapes of their targets, metres.

    Parameters
    ----------
    directions : slice
        Tilts (0, 1) and/or offset (2) whose sigma is estimated; the sigmas of the others are fixed.
    """
    alike = np.zeros_like(linearised.problem.surface_sigma, dtype=bool)
    alike[:, directions] = True
    return _maximise_surface_likelihood(linearised, alike & ~linearised.problem.rejected)[0]


def is_separate_offset_sigma_needed(linearised: LinearisedProblem) -> bool:
    """Whether the offsets need a sigma different from that of the tilts.

    This is the case for boards that are displaced between lines but not bent. The most displaced
    sightings may have been rejected, and are used again with a separate sigma. The likelihood must
    be clearly larger than with the rejection, since a single jump is more common, and clearly
    larger than with a common sigma.
    """
    problem = linearised.problem
    every = np.repeat(~problem.rejected[:, :1], 3, axis=1)
    own = every & (np.arange(3) == 2)
    gain = _maximise_surface_likelihood(linearised, own)[1]
    min_gain = (
        MIN_LIKELIHOOD_GAIN + ADDED_GAIN_IF_REJECTED
        if problem.rejected_sightings.any()
        else MIN_LIKELIHOOD_GAIN
    )
    return (
        gain > min_gain
        and gain - _maximise_surface_likelihood(linearised, every)[1] > MIN_LIKELIHOOD_GAIN
    )


def _maximise_surface_likelihood(
    linearised: LinearisedProblem, alike: NDArray[np.bool_]
) -> tuple[float, float]:
    """Most likely sigma of some departures, metres, and the gain in twice the log likelihood.

    Parameters
    ----------
    alike : ndarray of shape (sightings, 3)
        Whether each deviation has this sigma.
    """
    import scipy.optimize  # slow to import, and not needed by programs that do not adjust

    now = linearised.problem.surface_sigma
    deviance = _surface_likelihood(linearised)
    found = scipy.optimize.minimize_scalar(
        lambda log_sigma: deviance(np.where(alike, np.exp(log_sigma), now)),
        bounds=(np.log(MIN_SURFACE_SIGMA), np.log(MAX_SURFACE_SIGMA)),
        method="bounded",
    )
    return float(np.exp(found.x)), deviance(now) - float(found.fun)


def _surface_likelihood(linearised: LinearisedProblem) -> Callable[[Array], float]:
    """Minus twice the restricted log likelihood as a function of the sigmas of all departures."""
    problem, normal = linearised.problem, linearised.normal
    places = np.arange(normal.layout.surfaces[0].start, normal.layout.size)
    departures, used = linearised.departures.reshape(-1), problem.surface_sigma.reshape(-1)
    reduced, right = normal.reduced_matrix.copy(), normal.reduced_right_side.copy()
    reduced[places, places] -= used**-2.0
    right[places] += departures * used**-2.0
    scale = np.ones(len(reduced))
    others = slice(0, -len(places))
    scale[others] = 1 / np.sqrt(np.diag(reduced)[others])
    reduced, right = reduced * np.outer(scale, scale), right * scale

    def deviance(sigmas: Array) -> float:
        sigma = sigmas.reshape(-1)
        precision = sigma**-2.0
        matrix, right_side = reduced.copy(), right.copy()
        matrix[places, places] += precision
        right_side[places] -= departures * precision
        factor = np.linalg.cholesky(matrix)
        explained = scipy.linalg.solve_triangular(factor, right_side, lower=True)
        return float(
            2 * np.log(np.diag(factor)).sum()
            + 2 * np.log(sigma).sum()
            + departures**2 @ precision
            - explained @ explained
        )

    return deviance


def reestimate_surface_sigma(
    problem: AdjustmentProblem, linearised: LinearisedProblem
) -> AdjustmentProblem:
    """Return the problem with surface sigmas estimated from the data where none were given."""
    if not problem.model.correlated or problem.model.surface is not None:
        return problem
    if not problem.own_offsets:
        return problem.with_surface_sigma(most_likely_surface_sigma(linearised))
    tilts, offsets = (
        most_likely_surface_sigma(linearised, some) for some in (TILT_COMPONENTS, OFFSET_COMPONENT)
    )
    return problem.with_surface_sigma(np.array([tilts, tilts, offsets]))


FACTOR_LIMITS = (0.1, 10.0)
"""Smallest and largest accepted factor on a given sigma."""


MAX_FACTOR_RATIO = 100.0
"""Largest ratio of a factor, or a limit of its interval, to 1; beyond, it is not determined."""

MIN_NOISE_FACTOR = 1.1
"""Noise factor of a target from which on the factor on the LiDAR sigma is not estimated.

The noise estimated from the residuals then already replaces the given LiDAR sigma.
"""

MIN_SEPARATING_LINES = 3
"""Smallest number of lines with which position errors and form errors can be separated."""

DEVIANCE_TOLERANCE = 1e-3
"""Change of the deviance at which its minimum is found; a factor of one sigma changes it by 1."""

LOG_FACTOR_STEP = 1e-4
"""Step of the logarithm of a factor for the numerical derivatives of the deviance."""

LOG_FACTOR_GRID = np.log([0.2, 1.0, 5.0])
"""Logarithms of the factors on the sigmas of POS and form errors at which the search begins."""

LIKELIHOOD_RATIO_LIMIT = 3.84
"""Difference of the deviances from which on a factor differs significantly from 1, at 95 %."""

MAX_LOG_SIGMA = 0.6
"""Largest standard deviation of the logarithm of a determined factor, with the others fixed."""


@dataclass(frozen=True)
class MaximumLikelihood:
    """Factors at the maximum of the likelihood.

    Attributes
    ----------
    components : tuple of VarianceComponent
        Factors on the sigmas of LiDAR, POS position and POS attitude; 1 for groups that are not
        estimated.
    determined : tuple of bool
        Whether the data determine each factor.
    form_error_factor : float
        Factor on the sigma of the form errors.
    """

    components: tuple[VarianceComponent, ...]
    determined: tuple[bool, ...]
    form_error_factor: float


def estimate_variance_components(
    linearised: LinearisedProblem,
    groups: Sequence[SigmaGroup] = SIGMA_GROUPS,
    assumed: Sequence[SigmaGroup] = (),
) -> MaximumLikelihood:
    """Most likely factors on the sigmas of LiDAR, POS position, POS attitude and form errors.

    If the sigma of the form errors is not given, it is estimated together with the others. Position
    errors and form errors both shift a sighting, and only the correlation between neighbouring
    sightings separates them, so that the intervals are wide with few sightings. The factor on the
    LiDAR sigma remains 1 if the noise of a target was already raised from the residuals.

    Parameters
    ----------
    groups : sequence of {"LiDAR", "POS position", "POS attitude"}
        Groups whose factors are estimated; those of the others are 1.
    assumed : sequence of {"LiDAR", "POS position", "POS attitude"}
        Groups whose sigmas nobody gave. The points of any number of lines determine an assumed
        LiDAR sigma.
    """
    problem, likelihood = linearised.problem, _RestrictedLikelihood(linearised)
    free = np.array([*(group in groups for group in SIGMA_GROUPS), True])
    free[0] &= bool(problem.noise.max() < MIN_NOISE_FACTOR)
    free[3] = problem.model.surface is None
    if not free[:3].any():
        return _undetermined_factors()
    enough = len(problem.observations.lines) >= MIN_SEPARATING_LINES
    usual = float(problem.default_surface_sigmas.max()) if free[3] else 1.0
    bounds = [
        *[(np.log(FACTOR_LIMITS[0]), np.log(FACTOR_LIMITS[1]))] * len(SIGMA_GROUPS),
        (np.log(MIN_SURFACE_SIGMA / usual), np.log(MAX_SURFACE_SIGMA / usual)),
    ]
    found, least = _most_likely_factors(likelihood, free, bounds)
    curvature = _likelihood_curvature(
        lambda some: likelihood(_with_values(np.zeros(4), free, some)), found[free]
    )
    curvature /= 2
    spread, alone = np.full(4, np.inf), np.full(4, np.inf)
    spread[free] = np.sqrt(np.diag(np.linalg.inv(curvature)))
    alone[free] = 1 / np.sqrt(np.diag(curvature))
    reach = np.log(MAX_FACTOR_RATIO)
    intervals = np.clip(
        [found[:3], found[:3] - 1.96 * spread[:3], found[:3] + 1.96 * spread[:3]], -reach, reach
    )
    for k in np.flatnonzero((intervals[1] > 0) | (intervals[2] < 0)):
        fixed = free & (np.arange(4) != k)
        if _most_likely_factors(likelihood, fixed, bounds)[1] - least < LIKELIHOOD_RATIO_LIMIT:
            intervals[1, k], intervals[2, k] = min(intervals[1, k], 0), max(intervals[2, k], 0)
    return MaximumLikelihood(
        tuple(
            VarianceComponent(name, *np.exp(column).tolist())
            for name, column in zip(SIGMA_GROUPS, intervals.T, strict=True)
        ),
        tuple(
            bool(spread < MAX_LOG_SIGMA) and (enough or (group == "LiDAR" and group in assumed))
            for group, spread in zip(SIGMA_GROUPS, alone[:3], strict=True)
        ),
        float(np.exp(found[3])),
    )


def _most_likely_factors(
    likelihood: Callable[[Array], float],
    free: NDArray[np.bool_],
    bounds: Sequence[tuple[float, float]],
) -> tuple[Array, float]:
    """Logarithms of the factors, shape (4,), at the minimum of the deviance, and the minimum.

    The logarithms of factors that are not ``free`` are 0.
    """
    import scipy.optimize

    if not free.any():
        return np.zeros(4), likelihood(np.zeros(4))

    def minimise(start: Array) -> tuple[Array, float]:
        best = scipy.optimize.minimize(
            lambda some: likelihood(_with_values(np.zeros(4), free, some)), start[free],
            method="SLSQP",
            bounds=[bound for bound, is_free in zip(bounds, free, strict=True) if is_free],
            options={"ftol": DEVIANCE_TOLERANCE, "eps": LOG_FACTOR_STEP},
        )  # fmt: skip
        return _with_values(np.zeros(4), free, best.x), float(best.fun)

    # Errors of POS and of form can explain the same residuals, so that there are several minima.
    nearest = minimise(np.zeros(4))
    steps = [
        np.clip(LOG_FACTOR_GRID, *bound) if is_free else np.zeros(1)
        for bound, is_free in zip(bounds[1:], free[1:], strict=True)
    ]
    grid = [np.array([nearest[0][0], *values]) for values in product(*steps)]
    return min(nearest, minimise(min(grid, key=likelihood)), key=lambda found: found[1])


def _with_values(array: Array, places: NDArray[np.bool_], values: Array) -> Array:
    """The array with other values at some places, in place."""
    array[places] = values
    return array


def with_lidar_interval(
    found: MaximumLikelihood, linearised: LinearisedProblem
) -> MaximumLikelihood:
    """Factors with an interval of a LiDAR sigma whose factor is no longer estimated.

    If the noise of a target is raised, the likelihood gives no interval.
    """
    lidar, *others = found.components
    if lidar.upper < MAX_FACTOR_RATIO * (1 - 1e-9):
        return found
    spread = lidar_factor_spread(linearised)
    lower, upper = np.exp([-1.96 * spread, 1.96 * spread]).tolist()
    return replace(found, components=(replace(lidar, lower=lower, upper=upper), *others))


def lidar_factor_spread(linearised: LinearisedProblem) -> float:
    """Standard deviation of the logarithm of a LiDAR factor from the size of the residuals.

    The standard deviation of ``n`` independent residuals has a relative standard deviation of
    ``1 / sqrt(2 n)``; the noise of the targets contains the correlation of the residuals, which
    reduces ``n``.
    """
    problem = linearised.problem
    return float(problem.noise.max()) / float(np.sqrt(2 * len(problem.observations)))


def _undetermined_factors() -> MaximumLikelihood:
    """Factors of 1 that the data do not determine."""
    components = (
        VarianceComponent(group, 1.0, 1 / MAX_FACTOR_RATIO, MAX_FACTOR_RATIO)
        for group in SIGMA_GROUPS
    )
    return MaximumLikelihood(tuple(components), (False,) * len(SIGMA_GROUPS), 1.0)


def _likelihood_curvature(
    likelihood: Callable[[Array], float], centre: Array, step: float = 0.1
) -> Array:
    """Matrix of second derivatives of the likelihood, with eigenvalues of at least 1e-3."""
    middle, steps = likelihood(centre), step * np.eye(len(centre))
    there = np.array([likelihood(centre + h) for h in steps])
    curvature = np.empty((len(centre), len(centre)))
    for j, step_j in enumerate(steps):
        curvature[j, j] = there[j] - 2 * middle + likelihood(centre - step_j)
        for k in range(j):
            both = likelihood(centre + step_j + steps[k])
            curvature[j, k] = curvature[k, j] = both - there[j] - there[k] + middle
    values, directions = np.linalg.eigh(curvature / step**2)
    return np.asarray((directions * np.maximum(values, 1e-3)) @ directions.T)


class _RestrictedLikelihood:
    """Minus twice the restricted log likelihood as a function of the logarithms of the factors.

    The factors are on the sigmas of LiDAR, POS position, POS attitude, and of the form errors of
    sightings that are not rejected.
    """

    def __init__(self, linearised: LinearisedProblem) -> None:
        problem, self.normal = linearised.problem, linearised.normal
        knots, pos_corrections = problem.groups.knots, linearised.state.pos_corrections
        assert knots is not None
        # A loss also reduces the weights of large residuals that follow the normal distribution.
        self.points = len(problem.observations) * linearised.loss.expected_square_share
        self.knots = len(knots.time)
        self.kind = np.tile([1, 1, 1, 2, 2, 2], self.knots)
        self.own = knots.precision_diagonal.reshape(-1)
        self.beside = knots.precision_beside.reshape(-1)
        weighted = knots.apply_prior_precision(pos_corrections)
        self.prior_pos_right = weighted.reshape(-1)
        self.prior_quadratic = [0.0] + [
            float((weighted * pos_corrections)[:, part].sum()) for part in (slice(3), slice(3, 6))
        ]
        self.band = self.normal.band.copy()
        self.band[0] -= self.own
        self.band[6, : len(self.beside)] -= self.beside
        self.pos_right = self.normal.pos_right + self.prior_pos_right
        # Priors of parameters and of rejected surfaces are not scaled.
        self.diagonal = np.zeros(len(self.normal.matrix))
        self.prior_right = np.zeros(len(self.normal.matrix))
        self.fixed_quadratic = self.surface_quadratic = 0.0
        self.surfaces = np.zeros(len(self.normal.matrix))
        self.used = 0
        if problem.layout.surfaces:
            places = np.arange(problem.layout.surfaces[0].start, problem.layout.size)
            used = ~problem.rejected.reshape(-1)
            self.surfaces[places] = used
            self.used = int(used.sum())
            self.diagonal[places] = problem.surface_sigma.reshape(-1) ** -2.0
            departures = linearised.departures.reshape(-1)
            self.prior_right[places] = -departures * self.diagonal[places]
            squares = departures**2 * self.diagonal[places]
            self.surface_quadratic = float(squares[used].sum())
            self.fixed_quadratic += float(squares[~used].sum())
        off = linearised.state.mounting.values - problem.prior.values
        for parameter in problem.parameters:
            if parameter.sigma is not None:
                k = int(np.searchsorted(problem.active, parameter.index))
                self.diagonal[k] = parameter.sigma**-2
                self.prior_right[k] = -off[parameter.index] * self.diagonal[k]
                self.fixed_quadratic += float(off[parameter.index] ** 2 * self.diagonal[k])
        self.control = linearised.control
        if self.control is not None:
            self.prior_right += self.control.right
            self.fixed_quadratic += self.control.quadratic

    def __call__(self, given: Array) -> float:
        log_factors, log_form_factor = (
            np.array(given[:3]),
            float(given[3]) if len(given) > 3 else 0.0,
        )
        normal, precision_factors, form_precision_factor = (
            self.normal,
            np.exp(-2 * log_factors),
            np.exp(-2 * log_form_factor),
        )
        band = self.band * precision_factors[0]
        band[0] += self.own * precision_factors[self.kind]
        band[6, : len(self.beside)] += (
            self.beside * precision_factors[self.kind[: len(self.beside)]]
        )
        pos_right = (
            self.pos_right * precision_factors[0]
            - self.prior_pos_right * precision_factors[self.kind]
        )
        mixed = normal.mixed * precision_factors[0]
        prior = np.where(self.surfaces > 0, form_precision_factor, 1.0)
        matrix = normal.matrix * precision_factors[0]
        places = np.arange(len(matrix))
        matrix[places, places] += self.diagonal * (prior - precision_factors[0])
        if self.control is not None:  # not scaled
            matrix += self.control.matrix * (1 - precision_factors[0])
        right = (normal.right - self.prior_right) * precision_factors[0] + self.prior_right * prior
        factor = cholesky_factor(band)
        halved, halved_pull = (
            forward_substitution(factor, mixed.T),
            forward_substitution(factor, pos_right),
        )
        reduced = matrix - halved.T @ halved
        scale = 1 / np.sqrt(np.diag(reduced))
        lower = np.linalg.cholesky(reduced * np.outer(scale, scale))
        explained = scipy.linalg.solve_triangular(
            lower, (right - halved.T @ halved_pull) * scale, lower=True
        )
        fixed = self.fixed_quadratic + self.surface_quadratic
        data = normal.quadratic - sum(self.prior_quadratic) - fixed
        quadratic = (
            data * precision_factors[0]
            + float(np.dot(self.prior_quadratic, precision_factors))
            + self.fixed_quadratic
            + self.surface_quadratic * form_precision_factor
            - float(halved_pull @ halved_pull)
            - float(explained @ explained)
        )
        determinants = 2 * np.log(factor[0]).sum() + 2 * np.log(np.diag(lower) / scale).sum()
        counts = np.array([self.points, 3 * self.knots, 3 * self.knots])
        return float(
            2 * counts @ log_factors + 2 * self.used * log_form_factor + determinants + quadratic
        )
