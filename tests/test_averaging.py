"""Points averaged over a surface say what all of them say."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.averaging import averaged
from lispac.adjustment.shapes import points_local
from lispac.adjustment.solver import adjust
from lispac.adjustment.stochastic import StochasticModel
from lispac.simulation.closed_form import BOARDS, exact_survey, observed, six_courses
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
PRIOR = TRUTH.with_boresight(np.zeros(3))


@pytest.fixture(scope="module")
def survey():
    generator = np.random.default_rng(11)
    exact = exact_survey(TRUTH, BOARDS, six_courses(), 0.04, generator)
    return observed(exact, HYDROGRAPHIC_INS, generator)


@pytest.mark.parametrize("distance", [0.1, 0.2])
def test_averages_keep_the_mean_place_and_the_information(survey, distance) -> None:
    fewer = averaged(survey, PRIOR, distance)
    assert len(fewer) < len(survey) / 3
    counts = (survey.sigma_lidar[0, 0] / fewer.sigma_lidar[:, 0]) ** 2
    assert counts.sum() == pytest.approx(len(survey))
    for s in range(len(survey.sightings)):
        own = fewer.sighting == s
        mean = np.average(points_local(fewer, PRIOR)[own], axis=0, weights=counts[own])
        expected = points_local(survey, PRIOR)[survey.sighting == s].mean(axis=0)
        np.testing.assert_allclose(mean, expected, atol=1e-9)


def test_averages_reach_over_a_short_time_only(survey) -> None:
    """Points of one square seen at other times have POS errors of their own."""
    fewer = [len(averaged(survey, PRIOR, 0.1, longest=seconds)) for seconds in (0.05, 0.25, 100.0)]
    assert fewer[0] > 1.5 * fewer[1] > 1.5 * fewer[2]


def test_sigmas_do_not_depend_on_the_distance() -> None:
    """From 4 to 20 cm: on average less than a tenth, where a selection would double them."""
    model, distances, sigmas = StochasticModel(loss="tukey"), (0.0, 0.05, 0.1, 0.2), []
    for seed in range(5):
        generator = np.random.default_rng([13, seed])
        exact = exact_survey(TRUTH, BOARDS, six_courses(), 0.04, generator)
        noisy = observed(exact, HYDROGRAPHIC_INS, generator)
        thinned = [averaged(noisy, PRIOR, d) for d in distances]
        sigmas.append([adjust(o, PRIOR, model, diagnostics=False).sigma for o in thinned])
    mean = np.mean(sigmas, axis=0)
    assert (mean.max(axis=0) / mean.min(axis=0) < 1.10).all(), np.degrees(mean)


def test_zero_distance_changes_nothing(survey) -> None:
    assert averaged(survey, PRIOR, 0.0) is survey


def test_a_heading_through_north_is_averaged_to_north(survey) -> None:
    attitude = survey.attitude.copy()
    first = survey.sighting == 0
    attitude[first, 2] = np.where(np.arange(first.sum()) % 2, 1e-4, 2 * np.pi - 1e-4)
    fewer = averaged(replace(survey, attitude=attitude), PRIOR, 0.2)
    heading = fewer.attitude[fewer.sighting == 0, 2]
    assert np.abs(np.angle(np.exp(1j * heading))).max() < 1.1e-4
