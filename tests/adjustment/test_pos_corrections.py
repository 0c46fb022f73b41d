"""Tests of the corrections of the POS: against dense covariance matrices, and by simulation."""

from dataclasses import replace

import numpy as np
import pytest
import scipy.stats

from lispac.adjustment.diagnostics.pos_correction_estimate import estimate_pos_corrections
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.pos_corrections import (
    MIN_SUPPORTED_SHARE,
    PosCorrections,
)
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.model.target_shapes import (
    fit_shapes,
    points_local,
    relative_to_origins,
    target_centroids,
)
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem, LinearisedProblem
from lispac.adjustment.solve.iteration import iterate
from lispac.geometry.planes import fit_plane, rms_distance
from lispac.progress import no_progress
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    error_free_survey,
    gauss_markov_drift,
    six_courses,
)
from lispac.survey.georeferencing import Mounting
from lispac.value_conversion import decode_value, encode_value
from tests.studies.corrected_trajectories import (
    CORRELATION_TIMES,
    hits,
    rms_ratio,
    study,
)
from tests.support.long_runs import LONG
from tests.support.surveys import disturbed, planar_survey

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
PRIOR = TRUTH.with_boresight(np.zeros(3))
SIGMAS = np.array([0.012, 0.012, 0.02, *np.radians([0.008, 0.008, 0.012])])
MODEL = StochasticModel(surface=0.001, position_time=40.0, attitude_time=90.0)
QUERIES = np.array(
    [-900.0, -50.0, -1e-4, 0.0, 0.33, 0.55, 1.7, 2.4, 30.0, 101.0, 350.0, 503.4, 520.0, 3000.0]
)
"""Times before, within, between and after the sightings of `planar_survey`, seconds."""


@pytest.fixture(scope="module")
def linearised() -> LinearisedProblem:
    """Solution of a small survey with POS errors, whose accuracy grows with time."""
    data = disturbed(planar_survey(TRUTH, points=12), correlated=True, seed=3)
    grown = (1 + data.time / 500)[:, None]
    data = replace(
        data,
        sigma_position=grown * data.sigma_position,
        sigma_attitude=grown * data.sigma_attitude,
    )
    data = relative_to_origins(data, target_centroids(data, PRIOR))
    problem = AdjustmentProblem.of(data, PRIOR, MODEL)
    return iterate(problem, problem.start(PRIOR, fit_shapes(data, PRIOR)), no_progress).linearised


def sigmas_at(time: np.ndarray) -> np.ndarray:
    """Standard deviations of the POS at the query times, shape (n, 6)."""
    return np.clip(1 + time / 500, 0.1, 5.0)[:, None] * SIGMAS


def data_information(linearised: LinearisedProblem) -> tuple[np.ndarray, np.ndarray]:
    """Information of the points on the POS at the knots, without its prior, from dense matrices.

    Returns
    -------
    matrix : ndarray of shape (6 k, 6 k)
        All other unknowns are eliminated.
    vector : ndarray of shape (6 k,)
        Of the corrections themselves, not of changes of the solution.
    """
    normal, knots = linearised.normal, linearised.problem.groups.knots
    assert knots is not None
    count = len(normal.pos_right)
    matrix = np.zeros((count, count))
    for i in range(12):
        matrix[range(i, count), range(count - i)] = normal.band[i, : count - i]
        matrix[range(count - i), range(i, count)] = normal.band[i, : count - i]
    units = np.eye(count).reshape(count, -1, 6)
    matrix -= np.stack([knots.apply_prior_precision(unit).reshape(-1) for unit in units])
    now = linearised.state.pos_corrections
    vector = normal.pos_right + knots.apply_prior_precision(now).reshape(-1)
    solved = np.linalg.solve(normal.matrix, np.column_stack([normal.mixed, normal.right]))
    matrix -= normal.mixed.T @ solved[:, :-1]
    vector -= normal.mixed.T @ solved[:, -1]
    return matrix, vector + matrix @ now.reshape(-1)


def test_corrections_equal_collocation_with_full_covariance_matrices(linearised) -> None:
    """Collocation with the covariances of all knots and times, without inverting any of them."""
    found = estimate_pos_corrections(linearised)
    assert found is not None
    matrix, vector = data_information(linearised)
    knots = len(found.time)
    time = np.concatenate([found.time, QUERIES])
    sigma = np.vstack([found.prior_sigma, sigmas_at(QUERIES)])
    apart = np.abs(time[:, None] - time)
    prior = np.zeros((6 * len(time), 6 * len(time)))
    for k in range(6):
        correlation_time = MODEL.position_time if k < 3 else MODEL.attitude_time
        prior[k::6, k::6] = np.outer(sigma[:, k], sigma[:, k]) * np.exp(-apart / correlation_time)
    own = slice(0, 6 * knots)
    gain = np.linalg.solve(np.eye(6 * knots) + matrix @ prior[own, own], np.eye(6 * knots))
    mean = (prior[:, own] @ gain @ vector).reshape(-1, 6)
    variance = np.diag(prior - prior[:, own] @ gain @ matrix @ prior[own, :]).reshape(-1, 6)
    own_sigma = sigma[:knots]
    np.testing.assert_allclose(found.correction / own_sigma, mean[:knots] / own_sigma, atol=1e-9)
    shares = (found.sigma / own_sigma) ** 2
    np.testing.assert_allclose(shares, variance[:knots] / own_sigma**2, atol=1e-9)
    correction, spread = found.collocate(QUERIES, sigmas_at(QUERIES))
    asked = sigmas_at(QUERIES)
    np.testing.assert_allclose(correction / asked, mean[knots:] / asked, rtol=0, atol=1e-9)
    np.testing.assert_allclose((spread / asked) ** 2, variance[knots:] / asked**2, atol=1e-9)
    assert np.abs(mean / sigma).max() > 0.5, "there is something to compare"


def test_corrections_at_the_knots_are_those_of_the_adjustment(linearised) -> None:
    found = estimate_pos_corrections(linearised)
    assert found is not None
    correction, sigma = found.collocate(found.time, found.prior_sigma)
    np.testing.assert_allclose(correction, linearised.state.pos_corrections, rtol=1e-12)
    np.testing.assert_allclose(sigma, found.sigma, rtol=1e-12)


def test_corrections_decay_and_their_sigma_returns_to_the_prior(linearised) -> None:
    found = estimate_pos_corrections(linearised)
    assert found is not None
    time = found.time[-1] + np.array([0.0, 1.0, 10.0, 40.0, 90.0, 300.0, 2000.0])
    prior = np.tile(found.prior_sigma[-1], (len(time), 1))
    decay = np.exp(-(time - time[0])[:, None] / found.correlation_times)
    correction, sigma = found.collocate(time, prior)
    np.testing.assert_allclose(correction, decay * found.correction[-1], rtol=1e-12)
    removed = 1 - (found.sigma[-1] / prior) ** 2
    np.testing.assert_allclose(1 - (sigma / prior) ** 2, decay**2 * removed, rtol=0, atol=1e-12)
    at = found.at(time, prior)
    assert (at.correction[-1] == 0).all()
    assert (at.sigma[-1] == prior[-1]).all()
    assert not at.supported[-1].any()
    share = 1 - (at.sigma / prior) ** 2
    assert (share[at.supported] >= MIN_SUPPORTED_SHARE).all()
    assert at.sighted[0]
    assert not at.sighted[1:].any()


def test_a_component_that_the_data_do_not_determine_is_not_corrected() -> None:
    """An upright and a leaning board, both facing east, do not determine the north position."""
    data = disturbed(planar_survey(TRUTH), correlated=True, seed=5)
    found = adjust(data, PRIOR, StochasticModel()).pos_corrections
    assert found is not None
    assert found.determined.tolist()[:3] == [False, True, True]
    at = found.at(found.time, found.prior_sigma)
    assert (at.correction[:, 0] == 0).all()
    assert (at.sigma[:, 0] == found.prior_sigma[:, 0]).all()
    np.testing.assert_allclose(at.correction[:, 1], found.correction[:, 1], rtol=1e-12)


def test_a_survey_without_errors_needs_no_corrections() -> None:
    exact = error_free_survey(TRUTH, THESIS_BOARDS, six_courses(), 0.2, np.random.default_rng(1))
    found = adjust(exact, PRIOR, StochasticModel(surface=0.001)).pos_corrections
    assert found is not None
    assert np.abs(found.correction[:, :3]).max() < 1e-9
    assert np.abs(found.correction[:, 3:]).max() < 1e-9


def test_corrections_bring_the_lines_of_a_target_onto_one_plane() -> None:
    """Closed loop without LiDAR noise, with POS errors that are linear between the knots."""
    exact = error_free_survey(
        TRUTH, THESIS_BOARDS, six_courses(), 0.05, np.random.default_rng(2), lidar_sigma=2e-5
    )
    generator = np.random.default_rng(3)
    knots = MODEL.knot_interval * np.arange(-100, exact.time.max() / MODEL.knot_interval + 100)
    drifts = []
    for each in (MODEL.position_time, MODEL.attitude_time):
        drawn = gauss_markov_drift(knots, each, generator)
        drifts.append(np.stack([np.interp(exact.time, knots, column) for column in drawn.T], 1))
    data = replace(
        exact,
        position=exact.position + exact.sigma_position * drifts[0],
        attitude=exact.attitude + exact.sigma_attitude * drifts[1],
    )
    result = adjust(data, PRIOR, replace(MODEL, surface=1e-6))
    found = result.pos_corrections
    assert found is not None
    prior = np.hstack([data.sigma_position, data.sigma_attitude])
    correction, _ = found.collocate(data.time, prior)
    corrected = replace(
        data,
        position=data.position + correction[:, :3],
        attitude=data.attitude + correction[:, 3:],
    )

    def largest_distance(observations: Observations) -> float:
        placed = points_local(observations, result.mounting)
        owner = observations.target_of_sighting[observations.sighting]
        return max(
            rms_distance(fit_plane(placed[owner == k]), placed[owner == k]) for k in range(2)
        )

    assert largest_distance(data) > 5e-3
    # The points have a variance of (0.5 mm)^2 for deviations between the knots, and are smoothed
    assert largest_distance(corrected) < 1e-4


def test_times_are_those_of_the_trajectory_if_the_clock_is_late() -> None:
    late = replace(TRUTH, latency=0.25)
    exact = error_free_survey(late, THESIS_BOARDS, six_courses(), 0.1, np.random.default_rng(4))
    found = adjust(exact, replace(PRIOR, latency=0.25), StochasticModel()).pos_corrections
    plain = adjust(exact, PRIOR, StochasticModel(), test_model=False).pos_corrections
    assert found is not None
    assert plain is not None
    np.testing.assert_allclose(found.time, plain.time + 0.25, rtol=0, atol=1e-9)


def test_independent_errors_have_no_corrections() -> None:
    data = disturbed(planar_survey(TRUTH), correlated=False, seed=5)
    assert adjust(data, PRIOR, StochasticModel("independent")).pos_corrections is None


def test_a_single_knot_is_enough() -> None:
    one = np.ones((1, 6))
    found = PosCorrections(
        np.array([5.0]), 0.5 * one, 0.5 * one, one, np.zeros((0, 6)), 10.0, 20.0, 0.15
    )
    correction, sigma = found.collocate(np.array([-5.0, 5.0, 25.0]), np.ones((3, 6)))
    np.testing.assert_allclose(correction[:, 0], 0.5 * np.exp([-1.0, 0.0, -2.0]))
    np.testing.assert_allclose(sigma[1], 0.5)
    np.testing.assert_allclose(found.sighted_intervals, [[5.0, 5.0]])


def test_corrections_are_stored_without_a_loss(linearised) -> None:
    found = estimate_pos_corrections(linearised)
    assert found is not None
    assert found.is_sound
    read = decode_value(encode_value(found), PosCorrections)
    for name, values in vars(found).items():
        np.testing.assert_array_equal(getattr(read, name), values)
    assert not replace(found, time=found.time[::-1]).is_sound


@LONG
def test_corrected_points_are_nearer_to_the_truth_in_ten_surveys() -> None:
    """With short correlation times, so that each survey has many independent errors."""
    results = study(CORRELATION_TIMES[2], 10, workers=1)
    for sighted in (True, False):
        shares = hits(results, sighted=sighted)
        assert ((shares > 0.90) & (shares < 0.99)).all(), shares
    assert rms_ratio(results, sighted=True) < 0.9
    assert rms_ratio(results, sighted=False) < 1.0


@pytest.mark.long
@pytest.mark.timeout(7200)
@pytest.mark.parametrize("times", CORRELATION_TIMES)
def test_coverage_and_gain_in_300_surveys(times: tuple[float, float]) -> None:
    """With long correlation times, a survey has about one independent error of a component."""
    results = study(times, 300)
    bounds = scipy.stats.binom.ppf([0.0005, 0.9995], 300, 0.95) / 300
    if times == CORRELATION_TIMES[2]:
        bounds = np.array([0.93, 0.97])
    for sighted in (True, False):
        shares = hits(results, sighted=sighted)
        print(times, sighted, shares, rms_ratio(results, sighted=sighted))
        assert ((shares >= bounds[0]) & (shares <= bounds[1])).all(), shares
        assert 0.93 < shares.mean() < 0.97, shares
        assert rms_ratio(results, sighted=sighted) < 1.0
