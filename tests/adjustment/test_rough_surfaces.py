"""Tests of the noise of rough surfaces, whose neighbouring points have correlated errors."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.diagnostics.crosscheck import cross_checks
from lispac.adjustment.diagnostics.excess_scatter import sigmas_without
from lispac.adjustment.diagnostics.solved_equations import SolvedEquations
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.model.target_shapes import points_local
from lispac.adjustment.result import AdjustmentResult
from tests.adjustment.test_robustness import PRIOR, TRUTH, survey

MODEL = StochasticModel(loss="tukey")
ROUGHNESS, HALF_WAVELENGTH = 0.06, 0.25
"""RMS of the roughness and about half its wavelength, metres; points are 0.15 m apart."""


def rough_survey(seed: int) -> Observations:
    """Return a survey of boards covered with cloth whose roughness differs on each line."""
    data, chance = survey(seed, 0.15), np.random.default_rng([5, seed])
    points, off = points_local(data, TRUTH), np.zeros(len(data))
    for s in range(len(data.sightings)):
        own = data.sighting == s
        for _ in range(12):
            wave = chance.normal(0, np.pi / HALF_WAVELENGTH / np.sqrt(3), 3)
            off[own] += ROUGHNESS / np.sqrt(6) * np.sin(points[own] @ wave + chance.uniform(0, 7))
    beams = data.points_lidar / np.linalg.norm(data.points_lidar, axis=1)[:, None]
    return replace(data, points_lidar=data.points_lidar + off[:, None] * beams)


@pytest.fixture(scope="module")
def rough() -> tuple[Observations, AdjustmentResult]:
    data = rough_survey(0)
    return data, adjust(data, PRIOR, MODEL, diagnostics=False)


def test_equations_at_the_solution_have_its_covariance(
    rough: tuple[Observations, AdjustmentResult],
) -> None:
    data, result = rough
    assert min(result.noise_factors.values()) > 5
    solved = SolvedEquations.of(result, data, PRIOR)
    assert solved is not None
    np.testing.assert_allclose(
        solved.linearised.normal.covariance[:3, :3], result.covariance, rtol=1e-3, atol=1e-12
    )
    np.testing.assert_allclose(
        solved.linearised.state.mounting.boresight, result.boresight, atol=1e-3 * result.sigma.min()
    )


def test_known_noise_is_not_estimated_again(rough: tuple[Observations, AdjustmentResult]) -> None:
    data, result = rough
    again = adjust(data, PRIOR, MODEL, noise=result.noise_factors, diagnostics=False)
    assert again.noise_factors == result.noise_factors
    np.testing.assert_allclose(again.sigma, result.sigma, rtol=0.01)


def test_cross_checks_use_the_noise_of_the_whole_survey(
    rough: tuple[Observations, AdjustmentResult],
) -> None:
    """Sigmas without a line equal those of the equations of all lines without its points."""
    data, result = rough
    solved = SolvedEquations.of(result, data, PRIOR)
    assert solved is not None
    for check in cross_checks(data, PRIOR, result).parts:
        if check.kind != "line":
            continue
        omitted = np.array([each.line == check.part for each in data.sightings])
        expected = sigmas_without(solved.linearised, omitted)
        assert check.sigma == pytest.approx(expected, rel=0.05)


@pytest.mark.long
def test_sigmas_are_realistic_on_rough_surfaces() -> None:
    """Over 60 surveys the normalised errors had an RMS of 0.94, 1.03 and 0.90."""
    over = []
    for seed in range(60):
        result = adjust(rough_survey(seed), PRIOR, MODEL, diagnostics=False)
        over.append((result.boresight - TRUTH.boresight) / result.sigma)
    rms = np.sqrt(np.mean(np.square(over), axis=0))
    assert ((rms > 0.8) & (rms < 1.2)).all(), rms
