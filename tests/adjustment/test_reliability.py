"""Tests of redundancy, test statistics and detectable biases against dense matrices."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.special import chdtri, ndtri

from lispac.adjustment.diagnostics.crosscheck import cross_checks
from lispac.adjustment.diagnostics.reliability import (
    CRITICAL_VALUE,
    NONCENTRALITY,
    _group_covariances,
    _point_reliability,
    compute_reliability,
    sighting_tests,
)
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.condition_equations import lidar_variance
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.model.target_shapes import fit_shapes, relative_to_origins, target_centroids
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem
from lispac.adjustment.solve.blunders import Blunder
from lispac.adjustment.solve.iteration import iterate
from lispac.adjustment.solve.variance_components import estimate_variance_components
from lispac.present.targets.sightings import sighting_values
from lispac.progress import no_progress
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting
from tests.adjustment.test_robustness import shifted, survey
from tests.support.long_runs import LONG
from tests.support.surveys import disturbed, planar_survey

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
PRIOR = TRUTH.with_boresight(np.zeros(3))
FIXED_SURFACE_MODEL = StochasticModel(surface=0.002)


@pytest.fixture(scope="module")
def linearised():
    data = survey(1, 0.3)
    data = relative_to_origins(data, target_centroids(data, PRIOR))
    problem = AdjustmentProblem.of(data, PRIOR, FIXED_SURFACE_MODEL)
    return iterate(problem, problem.start(PRIOR, fit_shapes(data, PRIOR)), no_progress).linearised


def dense(linearised):
    """Return the covariance of all unknowns, including the POS errors, from dense matrices."""
    normal, problem = linearised.normal, linearised.problem
    layout, knots = normal.layout, problem.groups.knots
    u, e = layout.size, len(normal.pos_right)
    full = np.zeros((u + e, u + e))
    full[:u, :u] = normal.matrix
    full[:u, u:] = normal.mixed
    full[u:, :u] = normal.mixed.T
    for i in range(12):
        full[range(u + i, u + e), range(u, u + e - i)] = normal.band[i, : e - i]
        full[range(u, u + e - i), range(u + i, u + e)] = normal.band[i, : e - i]
    assert knots is not None
    return np.linalg.inv(full)


def test_covariance_equals_the_inverse_of_the_whole_normal_matrix(linearised) -> None:
    size = linearised.normal.layout.size
    np.testing.assert_allclose(
        linearised.normal.covariance, dense(linearised)[:size, :size], rtol=1e-5, atol=1e-14
    )


def test_redundancy_numbers_sum_to_the_degrees_of_freedom(linearised) -> None:
    """Their sum is the number of points less the part of the unknowns determined by data."""
    normal, problem = linearised.normal, linearised.problem
    redundancy, w, _, _ = _point_reliability(
        linearised, _group_covariances(linearised, normal.knot_covariance)
    )
    inverse = dense(linearised)
    size = normal.layout.size
    prior = np.zeros_like(inverse)
    first = normal.layout.surfaces[0].start
    prior[range(first, size), range(first, size)] = 0.002**-2
    knots = problem.groups.knots
    flat = np.eye(len(normal.pos_right)).reshape(len(normal.pos_right), -1, 6)
    prior[size:, size:] = np.stack([knots.apply_prior_precision(unit).reshape(-1) for unit in flat])
    explained_by_data = np.trace(inverse @ (np.linalg.inv(inverse) - prior))
    assert redundancy.sum() == pytest.approx(len(redundancy) - explained_by_data, rel=1e-3)
    assert (redundancy > 0.3).all()
    assert (redundancy < 1).all()
    assert np.std(w) == pytest.approx(1.0, abs=0.15)


def test_shift_equals_that_of_an_adjustment_without_its_prior(linearised) -> None:
    tests = sighting_tests(linearised)
    for s in (0, 5, 9):
        problem = Blunder("surface", (s,)).reject_in(linearised.problem)
        free = iterate(problem, linearised.state, no_progress).linearised
        # The tilts are released too, so the results agree only approximately.
        offset = free.departures[s, 2]
        assert tests.shift[s] == pytest.approx(offset, abs=0.7 * tests.sigma[s])


def test_shift_and_sigma_match_dense_matrices_without_the_prior(linearised) -> None:
    """The prior of one offset is removed from the whole normal matrix, which is inverted again."""
    tests, problem = sighting_tests(linearised), linearised.problem
    covariance = dense(linearised)
    full, usual = np.linalg.inv(covariance), problem.default_surface_sigmas[2]
    for s, place in enumerate(linearised.normal.layout.surfaces):
        offset = place.stop - 1
        weight = problem.surface_sigma[s, 2] ** -2
        without, pos_right = full.copy(), np.zeros(len(full))
        without[offset, offset] -= weight
        pos_right[offset] = weight * linearised.departures[s, 2]
        free = np.linalg.inv(without)
        found = linearised.departures[s, 2] + (free @ pos_right)[offset]
        assert tests.shift[s] == pytest.approx(found, rel=1e-4)
        assert tests.sigma[s] == pytest.approx(
            np.hypot(usual, free[offset, offset] ** 0.5), rel=1e-4
        )
        assert tests.w[s] == pytest.approx(tests.shift[s] / tests.sigma[s])
        np.testing.assert_allclose(tests.effect[s], weight * covariance[:3, offset], rtol=1e-4)


def test_the_pos_error_of_a_sighting_is_that_of_the_nearest_knot(linearised) -> None:
    observations, knots = linearised.problem.observations, linearised.problem.groups.knots
    size = linearised.normal.layout.size
    variance = np.diag(dense(linearised))[size:].reshape(-1, 6)
    sigma = np.hstack([observations.sigma_position, observations.sigma_attitude])
    for s, item in enumerate(compute_reliability(linearised)):
        own = observations.sighting == s
        nearest = np.argmin(np.abs(knots.time - observations.time[own].mean()))
        np.testing.assert_array_equal(item.pos_error, -linearised.state.pos_corrections[nearest])
        np.testing.assert_allclose(item.pos_sigma_after, np.sqrt(variance[nearest]), rtol=1e-4)
        np.testing.assert_allclose(item.pos_sigma, sigma[own].mean(axis=0), rtol=1e-12)


@pytest.mark.parametrize("sighting", [0, 7])
def test_mean_and_shift_are_presented_positive_if_nearer_to_the_vessel(sighting: int) -> None:
    data = survey(1, 0.3)
    shape = fit_shapes(data, PRIOR)[data.target_of_sighting[sighting]]
    side = np.sign(data.position[data.sighting == sighting].mean(axis=0) @ shape[:3] + shape[3])
    (clean, nearer) = (
        sighting_values(adjust(each, PRIOR, FIXED_SURFACE_MODEL))[sighting]
        for each in (data, shifted(data, sighting, 0.05 * side))
    )
    assert nearer.mean_after_m > clean.mean_after_m + 0.01
    assert nearer.shift_m == pytest.approx(clean.shift_m + 0.05, abs=0.01)
    assert nearer.w > clean.w + 3.0


def test_sign_of_the_effect_is_that_of_a_shift_towards_the_vessel() -> None:
    data = survey(1, 0.3)
    result = adjust(data, PRIOR, FIXED_SURFACE_MODEL)
    (values, *_), test = sighting_values(result), result.reliability[0]
    side = result.targets[0].vessel_side
    assert values.effect_deg.roll == -side * np.degrees(test.effect[0])


def test_results_without_the_side_of_the_vessel_have_no_signed_values() -> None:
    result = adjust(survey(1, 0.3), PRIOR, FIXED_SURFACE_MODEL)
    old = replace(result, targets=tuple(replace(t, vessel_side=None) for t in result.targets))
    for new, each in zip(sighting_values(result), sighting_values(old), strict=True):
        assert (each.mean_after_m, each.shift_m, each.w, each.effect_deg) == (None,) * 4
        assert (each.status, each.detectable_m) == (new.status, new.detectable_m)


def test_detectable_shift_is_four_sigmas(linearised) -> None:
    """Baarda's 4.13 is the sum of two normal quantiles: 3.29 (level 0.1 %), 0.84 (power 80 %)."""
    tests = sighting_tests(linearised)
    for s, item in enumerate(compute_reliability(linearised)):
        assert item.detectable == pytest.approx(4.13 * tests.sigma[s])
        np.testing.assert_allclose(item.effect, tests.effect[s] * item.detectable)
        assert (item.shift, item.w) == (tests.shift[s], tests.w[s])
        assert not item.rejected
    assert pytest.approx(-ndtri(0.0005) - ndtri(0.2), abs=0.005) == NONCENTRALITY
    assert pytest.approx(-ndtri(0.0005), abs=0.005) == CRITICAL_VALUE


def test_statistics_of_sightings_are_standard_normal() -> None:
    values = []
    for seed in range(30):
        generator = np.random.default_rng([12, seed])
        data = add_errors(
            error_free_survey(TRUTH, THESIS_BOARDS, six_courses(), 0.15, generator),
            HYDROGRAPHIC_INS,
            generator,
        )
        result = adjust(data, PRIOR, StochasticModel(surface=0.0005))
        values += [item.w for item in result.reliability]
    assert np.mean(values) == pytest.approx(0, abs=0.25)
    assert 0.8 < np.std(values) < 1.2


def test_predicted_effect_of_a_shift_on_the_angles_is_observed() -> None:
    data = survey(2, 0.15)
    model = StochasticModel(surface=0.002)
    before = adjust(data, PRIOR, model)
    for s in (1, 8):
        after = adjust(shifted(data, s, 0.02), PRIOR, model)
        item = before.reliability[s]
        predicted = item.effect / item.detectable * 0.02
        done = after.boresight - before.boresight
        # The sign depends on the direction of the normal, which is arbitrary.
        assert (
            min(np.abs(done - predicted).max(), np.abs(done + predicted).max())
            < 0.25 * np.abs(done).max() + 0.02 * before.sigma.max()
        )


def test_detectable_biases_of_points_follow_from_noise_and_redundancy(linearised) -> None:
    for item in compute_reliability(linearised):
        assert item.point_detectable == pytest.approx(
            4.13 * 0.003 / np.sqrt(item.redundancy), rel=0.1
        )
        assert item.pos_error.shape == item.pos_sigma.shape == (6,)
        assert (item.pos_sigma_after <= item.pos_sigma * 1.0001).all()


@pytest.mark.parametrize("component", [1, 2])
def test_pos_errors_are_reported_minus_true_values(component: int) -> None:
    data = survey(2, 0.15)
    line = np.array([each.line for each in data.sightings]) == "L3"
    wrong = data.position.copy()
    wrong[line[data.sighting], component] += 0.02
    before, after = (
        adjust(each, PRIOR, FIXED_SURFACE_MODEL) for each in (data, replace(data, position=wrong))
    )
    changes = [
        b.pos_error[component] - a.pos_error[component]
        for a, b in zip(before.reliability, after.reliability, strict=True)
        if a.sighting.line == "L3"
    ]
    assert len(changes) == 2
    assert 0.002 < min(changes) <= max(changes) < 0.021


def test_point_with_the_largest_residual_is_identified_by_its_time() -> None:
    data = survey(2, 0.15)
    k = int(np.flatnonzero(data.sighting == 4)[11])
    points = data.points_lidar.copy()
    points[k] *= 1 + 0.1 / np.linalg.norm(points[k])
    for loss in ("none", "tukey"):
        result = adjust(
            replace(data, points_lidar=points), PRIOR, StochasticModel(surface=0.002, loss=loss)
        )
        clean = adjust(data, PRIOR, StochasticModel(surface=0.002, loss=loss))
        found = max(result.reliability, key=lambda item: item.largest_w)
        assert found.sighting == data.sightings[4]
        assert found.largest_at == data.time[k]
        assert found.largest_w > 6
        assert found.outliers == clean.reliability[4].outliers + 1
        for item, sighting in zip(clean.reliability, data.sightings, strict=True):
            own = data.time[[data.sightings[s] == sighting for s in data.sighting]]
            assert item.largest_at in own
            assert item.largest_w < 5


@pytest.mark.parametrize("beam", [False, True])
def test_lidar_noise_is_propagated_through_the_beam(beam) -> None:
    """Compare with ``b' C b`` for the full covariance C of a beam in any direction."""
    generator = np.random.default_rng(0)
    for _ in range(20):
        point, b = generator.normal(0, 10, 3), generator.normal(0, 1, 3)
        along, across = 0.004, 0.011
        axis = point / np.linalg.norm(point)
        covariance = across**2 * np.eye(3) + (along**2 - across**2) * np.outer(axis, axis)
        sigma = np.array([along, across, across]) if beam else np.array([0.001, 0.002, 0.003])
        expected = b @ (covariance if beam else np.diag(sigma**2)) @ b
        found = lidar_variance(0, point[None], sigma[None], beam, b)
        assert found == pytest.approx(expected, rel=1e-12)


def test_variance_components_recover_the_simulated_errors() -> None:
    """Sigmas of LiDAR half, of positions twice the true ones, over several surveys."""
    logs = []
    for seed in range(6):
        data = survey(30 + seed, 0.08)
        scaled = data.with_scaled_sigmas(0.5, 2.0, 1.0)
        result = adjust(
            scaled, PRIOR, StochasticModel(surface=0.0), components=True, diagnostics=False
        )
        lidar, position, attitude = result.components
        assert [each.name for each in result.components] == [
            "LiDAR",
            "POS position",
            "POS attitude",
        ]
        noise = np.mean([target.noise for target in result.targets])
        logs.append([np.log(lidar.factor * noise), np.log(position.factor)])
        assert attitude.lower <= 1 <= attitude.upper
        if position.applied:
            assert result.sigma_factors[1] == position.used
            assert position.used == pytest.approx(position.factor, rel=0.05)
    mean = np.exp(np.mean(logs, axis=0))
    np.testing.assert_allclose(mean, [2.0, 0.5], rtol=0.15)


@pytest.mark.long
def test_variance_components_recover_too_small_position_sigmas() -> None:
    """Positions are 2.5 times worse than given; only without components sigmas are too small."""
    model = StochasticModel(loss="tukey")
    plain, with_components, factors = [], [], []
    for seed in range(6):
        scaled = survey(60 + seed, 0.2).with_scaled_sigmas(1.0, 0.4, 1.0)
        without = adjust(scaled, PRIOR, model, diagnostics=False)
        result = adjust(scaled, PRIOR, model, components=True, diagnostics=False)
        plain.append((without.boresight - TRUTH.boresight) / without.sigma)
        with_components.append((result.boresight - TRUTH.boresight) / result.sigma)
        factors.append(result.components[1].factor)
    assert np.mean(np.square(plain)) > 1.5
    assert np.mean(np.square(with_components)) < 1.5
    assert np.exp(np.mean(np.log(factors))) == pytest.approx(2.5, rel=0.35)


@LONG
def test_variance_components_recover_too_small_attitude_sigmas() -> None:
    """Attitudes are four times worse than given, and the search begins at the given sigmas."""
    normalised, logs = [], []
    for seed in range(6):
        true = planar_survey(TRUTH, seed=seed).with_scaled_sigmas(1.0, 1.0, 10.0)
        scaled = disturbed(true, correlated=True, seed=seed).with_scaled_sigmas(1.0, 1.0, 0.25)
        result = adjust(
            scaled, PRIOR, StochasticModel(loss="tukey"), components=True, diagnostics=False
        )
        lidar, _, attitude = result.components
        assert lidar.lower < 1 < lidar.upper
        assert attitude.lower < 4 < attitude.upper
        normalised.append((result.boresight - TRUTH.boresight) / result.sigma)
        logs.append(np.log(attitude.factor))
    assert np.exp(np.mean(logs)) == pytest.approx(4.0, rel=0.35)
    limit = chdtri(18, 0.001) / 18  # exceeded once in a thousand with correct sigmas
    assert np.mean(np.square(normalised)) < limit


def test_likelihood_matches_dense_matrices(linearised) -> None:
    """Compare with the restricted likelihood from one dense covariance of all misclosures."""
    from lispac.adjustment.solve.variance_components import _RestrictedLikelihood

    likelihood = _RestrictedLikelihood(linearised)
    steps = [np.ones(4), [1.3, 1, 1, 1], [1, 0.7, 1, 1], [1, 1, 1.5, 1], [1, 1, 1, 0.6]]
    factors = [np.log(step) for step in steps]
    found = np.array([likelihood(f) for f in factors])
    normal, problem = linearised.normal, linearised.problem
    size, e = normal.layout.size, len(normal.pos_right)
    fixed = normal.layout.surfaces[0].start
    inverse = dense(linearised)
    full = np.linalg.inv(inverse)
    prior = np.zeros_like(full)
    prior[range(fixed, size), range(fixed, size)] = 0.002**-2
    knots = problem.groups.knots
    flat = np.eye(e).reshape(e, -1, 6)
    pos = np.stack([knots.apply_prior_precision(unit).reshape(-1) for unit in flat])
    right = np.concatenate([normal.right, normal.pos_right])
    state = np.concatenate(
        [
            np.zeros(fixed),
            linearised.departures.reshape(-1),
            linearised.state.pos_corrections.reshape(-1),
        ]
    )
    data_matrix = full - prior
    data_matrix[size:, size:] -= pos
    prior[size:, size:] = pos
    data_right = right + prior @ state
    data_square = normal.quadratic - state @ prior @ state
    count = len(problem.observations)
    kind = np.tile([1, 1, 1, 2, 2, 2], len(knots.time))
    expected = []
    for log in factors:
        scale = np.exp(-2 * log[:3])
        root = np.ones(size + e)
        root[size:] = np.exp(-log[kind])
        root[fixed:size] = np.exp(-log[3])
        scaled = prior * np.outer(root, root)
        matrix = data_matrix * scale[0] + scaled
        pos_right = data_right * scale[0] - scaled @ state
        square = data_square * scale[0] + state @ scaled @ state
        least = square - pos_right @ np.linalg.solve(matrix, pos_right)
        determinant = np.linalg.slogdet(matrix)[1]
        counts = np.array([count, 3 * len(knots.time), 3 * len(knots.time), size - fixed])
        expected.append(2 * counts @ log + determinant + least)
    np.testing.assert_allclose(np.diff(found), np.diff(expected), rtol=1e-4, atol=1e-3)
    assert len(estimate_variance_components(linearised).components) == 3


def test_cross_checks_agree_on_a_clean_survey_and_name_a_blunder() -> None:
    model = StochasticModel(loss="tukey", surface=0.0)
    clean = average_points_in_cells(survey(40), PRIOR, 0.1)
    checks = cross_checks(clean, PRIOR, adjust(clean, PRIOR, model))
    assert [c.kind for c in checks.parts].count("line") == 6
    assert [c.kind for c in checks.parts].count("target") == 2
    assert len(checks.disagreements) <= 1
    halves = [c for c in checks.parts if c.kind == "half"]
    np.testing.assert_allclose(halves[0].difference, -halves[1].difference)
    # Opposite shifts of two sightings contradict every model.
    inconsistent = average_points_in_cells(
        shifted(shifted(survey(40), 0, 0.08), 1, -0.08), PRIOR, 0.1
    )
    plain = replace(model, loss="none")
    cross_checked = cross_checks(inconsistent, PRIOR, adjust(inconsistent, PRIOR, plain))
    assert {"L1", "L2"} & {c.part for c in cross_checked.disagreements}


def test_subsets_without_a_result_give_the_reason() -> None:
    generator = np.random.default_rng(5)
    exact = error_free_survey(TRUTH, THESIS_BOARDS[1:], six_courses()[:3], 0.1, generator)
    data = add_errors(exact, HYDROGRAPHIC_INS, generator)
    result = adjust(data, PRIOR, StochasticModel(surface=0.0), accept_single_orientation=True)
    checks = cross_checks(data, PRIOR, result)
    alone = next(c for c in checks.parts if c.kind == "target")
    assert alone.boresight is None
    assert alone.reason
    assert not alone.disagrees
