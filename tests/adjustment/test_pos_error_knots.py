"""Tests of the prior of the POS error at its knots, against dense covariance matrices."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.model.stochastic_model import PosErrorKnots, StochasticModel
from lispac.simulation.closed_form_survey import THESIS_BOARDS, error_free_survey, six_courses
from lispac.survey.georeferencing import Mounting

MODEL = StochasticModel()
KNOT_INTERVAL = MODEL.knot_interval


@pytest.fixture(scope="module")
def observations():
    """Return points in two stretches with a gap between them, and linearly growing sigmas."""
    truth = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
    data = error_free_survey(truth, THESIS_BOARDS, six_courses(), 0.4, np.random.default_rng(2))
    half = len(data) // 2
    time = 7.0 * KNOT_INTERVAL + np.linspace(0.0, 9.9 * KNOT_INTERVAL, len(data))
    time[half:] += 40.3 * KNOT_INTERVAL
    grown = 1e-3 * np.arange(1, 7) * (1.0 + time[:, None])
    return replace(data, time=time, sigma_position=grown[:, :3], sigma_attitude=grown[:, 3:])


def test_points_lie_between_their_knots(observations) -> None:
    knots = PosErrorKnots.of(observations, MODEL)
    assert (np.diff(knots.time) >= KNOT_INTERVAL * (1 - 1e-9)).all()
    assert np.diff(knots.time).max() > 30 * KNOT_INTERVAL, "none where no points are"
    before, after = knots.time[knots.left], knots.time[knots.left + 1]
    np.testing.assert_allclose(after - before, KNOT_INTERVAL, rtol=0, atol=1e-9)
    placed = before + knots.fraction * KNOT_INTERVAL
    np.testing.assert_allclose(placed, observations.time, rtol=0, atol=1e-9)
    np.testing.assert_allclose(
        knots.bridge_variance, knots.fraction * (1 - knots.fraction), atol=1e-12
    )


def test_the_precision_is_the_inverse_of_an_exponential_covariance(observations) -> None:
    """Gauss-Markov process: ``sigma_i sigma_j exp(-|t_i - t_j| / T)``; tridiagonal inverse."""
    knots = PosErrorKnots.of(observations, MODEL)
    apart = np.abs(knots.time[:, None] - knots.time)
    # Sigmas of the middles of the cells; linear between them, constant beyond them
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


def test_variance_of_the_process_between_two_knots(observations) -> None:
    """About the chord: ``2 u (1 - u) interval / T`` of the variance, to first order."""
    knots = PosErrorKnots.of(observations, MODEL)
    for bridge, correlation in zip(
        knots.bridge_factor, np.repeat([MODEL.position_time, MODEL.attitude_time], 3), strict=True
    ):
        for u in (0.2, 0.5, 0.7):
            weights = np.array([1.0, u - 1.0, -u])  # weights of the process at u and at both knots
            at = np.array([u, 0.0, 1.0]) * KNOT_INTERVAL
            covariance = np.exp(-np.abs(at[:, None] - at) / correlation)
            variance = weights @ covariance @ weights
            assert variance == pytest.approx(
                bridge * u * (1 - u), rel=3 * KNOT_INTERVAL / correlation
            )


def test_points_in_another_order_keep_their_knots(observations) -> None:
    order = np.random.default_rng(3).permutation(len(observations))
    knots = PosErrorKnots.of(observations, MODEL)
    again = knots.reordered(order)
    for name in ("left", "fraction", "bridge_variance"):
        np.testing.assert_array_equal(getattr(again, name), getattr(knots, name)[order])
    np.testing.assert_array_equal(again.precision_beside, knots.precision_beside)
