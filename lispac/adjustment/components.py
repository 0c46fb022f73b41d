"""How large the errors really are, from the data: variance components by restricted likelihood.

The restricted likelihood (REML: Patterson and Thompson 1971) is that of the residuals alone,
whatever the unknowns are. The sums the adjustment has made anyway give it for any sigmas, without
another look at the points.
"""

import numpy as np
import scipy.linalg
import scipy.optimize
from numpy.typing import NDArray

from lispac.adjustment.problem import RELEASED, Linearised
from lispac.adjustment.result import Component

Array = NDArray[np.float64]

SMALLEST_SURFACE, LARGEST_SURFACE = 1e-5, 0.3  # metres


def surface_sigma(linearised: Linearised) -> float:
    """Most likely sigma of how the sightings depart from their target's shape, metres."""
    problem, normal = linearised.problem, linearised.normal
    sigma = problem.surface_sigma.reshape(-1)
    held = sigma < RELEASED
    places = np.arange(normal.layout.surfaces[0].start, normal.layout.size)[held]
    departures, used = linearised.departures.reshape(-1)[held], sigma[held]
    reduced, right = normal.reduced.copy(), normal.reduced_right.copy()
    reduced[places, places] -= used**-2.0
    right[places] += departures * used**-2.0
    scale = np.ones(len(reduced))
    others = slice(0, -len(sigma))
    scale[others] = 1 / np.sqrt(np.diag(reduced)[others])
    reduced, right = reduced * np.outer(scale, scale), right * scale

    def unlikeliness(log_sigma: float) -> float:
        precision = np.exp(-2 * log_sigma)
        matrix, pull = reduced.copy(), right.copy()
        matrix[places, places] += precision
        pull[places] -= departures * precision
        factor = np.linalg.cholesky(matrix)
        explained = scipy.linalg.solve_triangular(factor, pull, lower=True)
        return float(
            2 * np.log(np.diag(factor)).sum()
            + 2 * log_sigma * len(places)
            + departures @ departures * precision
            - explained @ explained
        )

    bounds = (np.log(SMALLEST_SURFACE), np.log(LARGEST_SURFACE))
    found = scipy.optimize.minimize_scalar(unlikeliness, bounds=bounds, method="bounded")
    return float(np.exp(found.x))


NAMES = ("LiDAR", "POS position", "POS attitude")
FACTORS = (0.1, 10.0)
"""Smallest and largest factor on a stated sigma that is believed."""


def variance_components(linearised: Linearised) -> tuple[Component, ...]:
    """Most likely factors on the sigmas of LiDAR, POS position and POS attitude.

    With few sightings the data say little of the POS; the intervals tell.
    """
    bounds = [(np.log(FACTORS[0]), np.log(FACTORS[1]))] * len(NAMES)
    likelihood = _Likelihood(linearised)
    found = scipy.optimize.minimize(
        likelihood, np.zeros(len(NAMES)), method="Nelder-Mead", bounds=bounds,
        options={"xatol": 0.005, "fatol": 0.005},
    )  # fmt: skip
    spread = np.sqrt(2 / np.maximum(_curvature(likelihood, found.x), 1e-3))
    reach = np.log(100.0)  # beyond, the data tell nothing
    return tuple(
        Component(name, *np.exp(np.clip([x, x - 1.96 * s, x + 1.96 * s], -reach, reach)).tolist())
        for name, x, s in zip(NAMES, found.x, spread, strict=True)
    )


def _curvature(likelihood: "_Likelihood", at: Array, step: float = 0.1) -> Array:
    """Second derivative along each axis, all other factors held, shape (3,)."""
    middle = likelihood(at)
    return np.array(
        [likelihood(at + h) - 2 * middle + likelihood(at - h) for h in step * np.eye(len(at))]
    ) / (step**2)


class _Likelihood:
    """Minus twice the restricted log likelihood by the logarithms of the three factors."""

    def __init__(self, linearised: Linearised) -> None:
        problem, self.normal = linearised.problem, linearised.normal
        knots, effects = problem.groups.knots, linearised.state.effects
        assert knots is not None
        # A loss takes weight from the large residuals of a normal distribution too.
        self.points = len(problem.observations) * linearised.loss.kept
        self.knots = len(knots.time)
        self.kind = np.tile([1, 1, 1, 2, 2, 2], self.knots)
        self.own = knots.precision_diagonal.reshape(-1)
        self.beside = knots.precision_beside.reshape(-1)
        weighted = knots.weighted(effects)
        self.prior_pull = weighted.reshape(-1)
        self.prior_quadratic = [0.0] + [
            float((weighted * effects)[:, part].sum()) for part in (slice(3), slice(3, 6))
        ]
        self.band = self.normal.band.copy()
        self.band[0] -= self.own
        self.band[6, : len(self.beside)] -= self.beside
        self.pull = self.normal.pull + self.prior_pull
        # Priors of surfaces and parameters stay as they are.
        self.diagonal = np.zeros(len(self.normal.matrix))
        self.prior_right = np.zeros(len(self.normal.matrix))
        self.fixed_quadratic = 0.0
        if problem.layout.surfaces:
            places = np.arange(problem.layout.surfaces[0].start, problem.layout.size)
            self.diagonal[places] = problem.surface_sigma.reshape(-1) ** -2.0
            departures = linearised.departures.reshape(-1)
            self.prior_right[places] = -departures * self.diagonal[places]
            self.fixed_quadratic += float((departures**2 * self.diagonal[places]).sum())
        off = linearised.state.mounting.values - problem.prior.values
        for parameter in problem.parameters:
            if parameter.sigma is not None:
                k = int(np.searchsorted(problem.active, parameter.index))
                self.diagonal[k] = parameter.sigma**-2
                self.prior_right[k] = -off[parameter.index] * self.diagonal[k]
                self.fixed_quadratic += float(off[parameter.index] ** 2 * self.diagonal[k])

    def __call__(self, log_factors: Array) -> float:
        normal, trust = self.normal, np.exp(-2 * log_factors)
        band = self.band * trust[0]
        band[0] += self.own * trust[self.kind]
        band[6, : len(self.beside)] += self.beside * trust[self.kind[: len(self.beside)]]
        pull = self.pull * trust[0] - self.prior_pull * trust[self.kind]
        mixed = normal.mixed * trust[0]
        prior = np.diag(self.diagonal)
        matrix = (normal.matrix - prior) * trust[0] + prior
        right = (normal.right - self.prior_right) * trust[0] + self.prior_right
        factor = scipy.linalg.cholesky_banded(band, lower=True)
        solved = scipy.linalg.cho_solve_banded((factor, True), np.column_stack([mixed.T, pull]))
        reduced = matrix - mixed @ solved[:, :-1]
        scale = 1 / np.sqrt(np.diag(reduced))
        lower = np.linalg.cholesky(reduced * np.outer(scale, scale))
        explained = scipy.linalg.solve_triangular(
            lower, (right - mixed @ solved[:, -1]) * scale, lower=True
        )
        data = normal.quadratic - sum(self.prior_quadratic) - self.fixed_quadratic
        quadratic = (
            data * trust[0]
            + float(np.dot(self.prior_quadratic, trust))
            + self.fixed_quadratic
            - float(pull @ solved[:, -1])
            - float(explained @ explained)
        )
        determinants = 2 * np.log(factor[0]).sum() + 2 * np.log(np.diag(lower) / scale).sum()
        counts = np.array([self.points, 3 * self.knots, 3 * self.knots])
        return float(2 * counts @ log_factors + determinants + quadratic)
