"""Tests of averaging points over a surface: no loss of information, no outliers."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.model.target_shapes import points_local
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting
from tests.support.long_runs import LONG, others_long

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
PRIOR = TRUTH.with_boresight(np.zeros(3))


@pytest.fixture(scope="module")
def survey():
    generator = np.random.default_rng(11)
    exact = error_free_survey(TRUTH, THESIS_BOARDS, six_courses(), 0.04, generator)
    return add_errors(exact, HYDROGRAPHIC_INS, generator)


@pytest.mark.parametrize("distance", [0.1, 0.2])
def test_averages_keep_the_mean_place_and_the_information(survey, distance) -> None:
    fewer = average_points_in_cells(survey, PRIOR, distance)
    assert len(fewer) < len(survey) / 3
    counts = (survey.sigma_lidar[0, 0] / fewer.sigma_lidar[:, 0]) ** 2
    assert counts.sum() == pytest.approx(len(survey))
    for s in range(len(survey.sightings)):
        own = fewer.sighting == s
        mean = np.average(points_local(fewer, PRIOR)[own], axis=0, weights=counts[own])
        expected = points_local(survey, PRIOR)[survey.sighting == s].mean(axis=0)
        np.testing.assert_allclose(mean, expected, rtol=0, atol=1e-9)


def test_averages_keep_the_sigmas_of_the_pos_and_the_mean_time(survey) -> None:
    """The points of an average share the POS error, so that averaging does not reduce it."""
    fewer = average_points_in_cells(survey, PRIOR, 0.2)
    counts = (survey.sigma_lidar[0, 0] / fewer.sigma_lidar[:, 0]) ** 2
    for name in ("sigma_position", "sigma_attitude"):
        given_values = getattr(survey, name)
        assert np.ptp(given_values, axis=0).max() == 0
        expected = np.broadcast_to(given_values[0], (len(fewer), 3))
        np.testing.assert_allclose(getattr(fewer, name), expected, rtol=1e-12)
    assert np.average(fewer.time, weights=counts) == pytest.approx(survey.time.mean(), abs=1e-9)


def test_averages_span_a_short_time_only(survey) -> None:
    """Points of one cell measured at other times have different POS errors."""
    fewer = [
        len(average_points_in_cells(survey, PRIOR, 0.1, longest=seconds))
        for seconds in (0.05, 0.25, 100.0)
    ]
    assert fewer[0] > 1.5 * fewer[1] > 1.5 * fewer[2]


@LONG
def test_sigmas_do_not_depend_on_the_distance() -> None:
    """From 4 to 20 cm the change is below a tenth; a selection of points would double them."""
    model, distances, sigmas = StochasticModel(loss="tukey"), (0.0, 0.05, 0.1, 0.2), []
    for seed in range(5):
        generator = np.random.default_rng([13, seed])
        exact = error_free_survey(TRUTH, THESIS_BOARDS, six_courses(), 0.04, generator)
        noisy = add_errors(exact, HYDROGRAPHIC_INS, generator)
        thinned = [average_points_in_cells(noisy, PRIOR, d) for d in distances]
        sigmas.append([adjust(o, PRIOR, model, diagnostics=False).sigma for o in thinned])
    mean = np.mean(sigmas, axis=0)
    assert (mean.max(axis=0) / mean.min(axis=0) < 1.10).all(), np.degrees(mean)


def test_zero_distance_changes_nothing(survey) -> None:
    assert average_points_in_cells(survey, PRIOR, 0.0) is survey


def test_a_heading_through_north_is_averaged_to_north(survey) -> None:
    attitude = survey.attitude.copy()
    first = survey.sighting == 0
    attitude[first, 2] = np.where(np.arange(first.sum()) % 2, 1e-4, 2 * np.pi - 1e-4)
    fewer = average_points_in_cells(replace(survey, attitude=attitude), PRIOR, 0.2)
    heading = fewer.attitude[fewer.sighting == 0, 2]
    assert np.abs(np.angle(np.exp(1j * heading))).max() < 1.1e-4


def with_outliers(observations, share: float, generator):
    """Ranges of a share of the points wrong by 0.1 to 1 m, either way."""
    hit = generator.random(len(observations)) < share
    beam = observations.points_lidar[hit]
    size = generator.uniform(0.1, 1, len(beam)) * generator.choice([-1, 1], len(beam))
    points = observations.points_lidar.copy()
    points[hit] += beam / np.linalg.norm(beam, axis=1)[:, None] * size[:, None]
    return replace(observations, points_lidar=points), hit


@LONG
@pytest.mark.parametrize("spacing", others_long([0.02, 0.04]))
def test_outliers_are_excluded_from_averages(spacing) -> None:
    """Of dense points one in twenty is an outlier: without a test, at least one in each average."""
    model = StochasticModel(loss="tukey")
    for seed in range(2):
        generator = np.random.default_rng([14, seed])
        exact = error_free_survey(TRUTH, THESIS_BOARDS, six_courses(), spacing, generator)
        clean = add_errors(exact, HYDROGRAPHIC_INS, generator)
        strayed, hit = with_outliers(clean, 0.05, generator)
        fewer = average_points_in_cells(strayed, PRIOR, 0.1, no_outliers=True)
        assert fewer.excluded_outliers == hit.sum()
        found = adjust(fewer, PRIOR, model, diagnostics=False)
        assert found.excluded_outliers == fewer.excluded_outliers
        all_clean = adjust(
            average_points_in_cells(clean, PRIOR, 0.1), PRIOR, model, diagnostics=False
        )
        assert (np.abs(found.boresight - all_clean.boresight) < all_clean.sigma).all()
        without = average_points_in_cells(clean.where(~hit), PRIOR, 0.1)
        expected = adjust(without, PRIOR, model, diagnostics=False)
        np.testing.assert_allclose(found.boresight, expected.boresight, rtol=0, atol=1e-7)
        np.testing.assert_allclose(found.sigma, expected.sigma, rtol=1e-3)


def test_a_clean_survey_has_no_outliers(survey) -> None:
    """Three in a million normal errors lie beyond the limit."""
    assert average_points_in_cells(survey, PRIOR, 0.1, no_outliers=True).excluded_outliers <= 1


def test_larger_lidar_noise_than_given_makes_no_outliers(survey) -> None:
    """The limit follows from the spread of the points, not from the given sigma."""
    scaled = survey.with_scaled_sigmas(0.2, 1.0, 1.0)
    assert average_points_in_cells(scaled, PRIOR, 0.1, no_outliers=True).excluded_outliers <= 1


def test_the_smaller_of_two_surfaces_in_a_sighting_is_excluded(survey) -> None:
    """The points of the smaller surface are excluded, even a third of all points."""
    third = (np.arange(len(survey)) % 3 == 0) & (survey.sighting == 0)
    points = survey.points_lidar.copy()
    points[third] *= 1 + 0.2 / np.linalg.norm(points[third], axis=1)[:, None]
    fewer = average_points_in_cells(
        replace(survey, points_lidar=points), PRIOR, 0.1, no_outliers=True
    )
    assert fewer.excluded_outliers == third.sum()


def test_a_sample_does_not_depend_on_the_order_of_the_points(survey) -> None:
    assert np.bincount(survey.sighting).min() > 600
    chosen = survey.sample(0.5)
    assert chosen.mean() == pytest.approx(0.5, abs=0.02)
    order = np.random.default_rng(2).permutation(len(survey))
    np.testing.assert_array_equal(survey.reordered(order).sample(0.5), chosen[order])
    # A tenth would leave too few points in every sighting
    assert survey.sample(0.1).all()


def test_two_points_of_a_sighting_are_not_averaged(survey) -> None:
    """Two points lie on a straight line, which determines no plane to average over."""
    two = np.flatnonzero(survey.sighting == 3)[:2]
    kept = (survey.sighting != 3) | np.isin(range(len(survey)), two)
    fewer = average_points_in_cells(survey.where(kept), TRUTH, 0.5, longest=100.0)
    expected = np.sort(survey.points_lidar[two], axis=0)
    np.testing.assert_allclose(np.sort(fewer.points_lidar[fewer.sighting == 3], axis=0), expected)
