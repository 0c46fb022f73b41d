"""The prior of the POS error at its knots against the process it stands for, by dense matrices."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.model.stochastic_model import PosErrorKnots, StochasticModel
from lispac.simulation.closed_form_survey import THESIS_BOARDS, error_free_survey, six_courses
from lispac.survey.georeferencing import Mounting

MODEL = StochasticModel()
KNOTS = MODEL.knot_interval


@pytest.fixture(scope="module")
def observations():
    """Points of two stretches with nothing between, sigmas that grow evenly."""
    truth = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
    data = error_free_survey(truth, THESIS_BOARDS, six_courses(), 0.4, np.random.default_rng(2))
    half = len(data) // 2
    time = 7.0 * KNOTS + np.linspace(0.0, 9.9 * KNOTS, len(data))
    time[half:] += 40.3 * KNOTS
    grown = 1e-3 * np.arange(1, 7) * (1.0 + time[:, None])
    return replace(data, time=time, sigma_position=grown[:, :3], sigma_attitude=grown[:, 3:])


def test_points_lie_between_their_knots(observations) -> None:
    knots = PosErrorKnots.of(observations, MODEL)
    assert (np.diff(knots.time) >= KNOTS * (1 - 1e-9)).all()
    assert np.diff(knots.time).max() > 30 * KNOTS, "none where no points are"
    before, after = knots.time[knots.left], knots.time[knots.left + 1]
    np.testing.assert_allclose(after - before, KNOTS, rtol=0, atol=1e-9)
    placed = before + knots.fraction * KNOTS
    np.testing.assert_allclose(placed, observations.time, rtol=0, atol=1e-9)
    np.testing.assert_allclose(
        knots.bridge_variance, knots.fraction * (1 - knots.fraction), atol=1e-12
    )


def test_the_precision_is_the_inverse_of_an_exponential_covariance(observations) -> None:
    """Gauss-Markov: ``sigma_i sigma_j exp(-|t_i - t_j| / T)``, whose inverse couples neighbours."""
    knots = PosErrorKnots.of(observations, MODEL)
    apart = np.abs(knots.time[:, None] - knots.time)
    # The sigmas of the cells' middles, between them linear, beyond them those of the nearest
    cells = [np.flatnonzero(knots.left == k) for k in np.unique(knots.left)]
    middles = np.array([observations.time[own].mean() for own in cells])
    within = np.clip(knots.time, middles[0], middles[-1])
    for k in range(6):
        correlation = MODEL.position_time if k < 3 else MODEL.attitude_time
        sigma = 1e-3 * (k + 1) * (1.0 + within)
        covariance = np.outer(sigma, sigma) * np.exp(-apart / correlation)
        beside = knots.precision_beside[:, k]
        precision = (
            np.diag(knots.precision_diagonal[:, k]) + np.diag(beside, 1) + np.diag(beside, -1)
        )
        np.testing.assert_allclose(precision @ covariance, np.eye(len(sigma)), atol=1e-7)
        effects = np.zeros((len(sigma), 6))
        effects[:, k] = np.sin(np.arange(len(sigma)))
        expected = precision @ effects[:, k]
        np.testing.assert_allclose(knots.apply_prior_precision(effects)[:, k], expected, rtol=1e-12)


def test_between_two_knots_the_process_deviates_from_their_chord(observations) -> None:
    """To first order of the interval by ``2 u (1 - u) interval / T`` of its variance."""
    knots = PosErrorKnots.of(observations, MODEL)
    for bridge, correlation in zip(
        knots.bridge_factor, np.repeat([MODEL.position_time, MODEL.attitude_time], 3), strict=True
    ):
        for u in (0.2, 0.5, 0.7):
            weights = np.array([1.0, u - 1.0, -u])  # of the process at u, at the two knots
            at = np.array([u, 0.0, 1.0]) * KNOTS
            covariance = np.exp(-np.abs(at[:, None] - at) / correlation)
            strays = weights @ covariance @ weights
            assert strays == pytest.approx(bridge * u * (1 - u), rel=3 * KNOTS / correlation)


def test_points_in_another_order_keep_their_knots(observations) -> None:
    order = np.random.default_rng(3).permutation(len(observations))
    knots = PosErrorKnots.of(observations, MODEL)
    again = knots.reordered(order)
    for name in ("left", "fraction", "bridge_variance"):
        np.testing.assert_array_equal(getattr(again, name), getattr(knots, name)[order])
    np.testing.assert_array_equal(again.precision_beside, knots.precision_beside)
