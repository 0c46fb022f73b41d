"""Tests of assumed standard deviations: estimated where the data allow, otherwise reported."""

from dataclasses import replace

import numpy as np
import pytest
import scipy.stats

from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import SIGMA_GROUPS
from lispac.adjustment.solve.noise_estimation import assign_surface_blocks
from lispac.messages import Level
from lispac.present.calibration.adjustment import adjustment_values
from lispac.project import Settings
from tests.studies.assumed_sigmas import row, study
from tests.studies.coverage_study import PRIOR, TRUTH
from tests.support.long_runs import others_long
from tests.support.surveys import disturbed, planar_survey


@pytest.mark.parametrize("noise", others_long([0.002, 0.012]))
def test_assumed_lidar_noise_is_replaced_by_that_of_the_data(noise: float) -> None:
    """Bounds of the binomial distribution at one in a thousand; noise known to 2 %."""
    count = 8
    found = study(noise, ("LiDAR",), None, count, workers=1)
    text = row(noise, ("LiDAR",), None, found)
    fewest = scipy.stats.binom.ppf(0.0005, 3 * count, 0.95) / (3 * count)
    assert found.angles.hits.mean() >= fewest, text
    np.testing.assert_allclose(found.lidar, noise, rtol=0.06, err_msg=text)
    assert found.passed == 1.0, text


@pytest.mark.long
@pytest.mark.timeout(7200)
@pytest.mark.parametrize("groups", [("LiDAR",), SIGMA_GROUPS])
@pytest.mark.parametrize("noise", [0.002, 0.012])
def test_intervals_with_assumed_sigmas_contain_the_truth(noise, groups) -> None:
    found = study(noise, groups, None, 300)
    text = row(noise, groups, None, found)
    assert (found.angles.hits.mean() > 0.92) & (found.angles.hits.mean() < 0.985), text


def _survey(seed: int = 3):
    return disturbed(planar_survey(TRUTH, seed=seed), correlated=True, seed=seed)


def test_given_sigmas_are_not_estimated() -> None:
    data, model = _survey(), StochasticModel(loss="tukey")
    plain = adjust(data, PRIOR, model)
    automatic = adjust(data, PRIOR, model, components=None)
    assert automatic.components == ()
    np.testing.assert_array_equal(automatic.boresight, plain.boresight)
    np.testing.assert_array_equal(automatic.covariance_all, plain.covariance_all)


def test_only_assumed_groups_are_estimated_and_the_others_keep_their_sigmas() -> None:
    data = _survey().with_scaled_sigmas(2.5, 1.0, 1.0)
    result = adjust(data, PRIOR, StochasticModel(loss="tukey"), components=None, assumed=("LiDAR",))
    (lidar,) = result.components
    assert lidar.name == "LiDAR"
    assert lidar.used == pytest.approx(0.4, rel=0.1)
    assert result.sigma_factors[1:] == (1.0, 1.0)
    assert result.unestimated_sigmas == ()


def test_sigmas_that_the_data_do_not_determine_are_named_in_a_note() -> None:
    result = adjust(
        _survey(5), PRIOR, StochasticModel(loss="tukey"), components=None, assumed=SIGMA_GROUPS
    )
    assert "POS attitude" in result.unestimated_sigmas
    assert "LiDAR" not in result.unestimated_sigmas
    (found,) = (
        each for each in result_warnings(result, None) if each.code == "adjustment.assumed_sigmas"
    )
    assert found.level is Level.NOTE
    assert "item.assumed_attitude" in {each.code for each in found.params["groups"]}


@pytest.mark.parametrize("scale", others_long([0.2, 3.0]))
@pytest.mark.parametrize("components", [None, False])
def test_a_wrong_assumed_lidar_noise_gives_no_warning(
    scale: float, components: bool | None
) -> None:
    data = _survey()
    usual = {e.code for e in result_warnings(adjust(data, PRIOR, StochasticModel()), None)}
    result = adjust(
        data.with_scaled_sigmas(scale, 1.0, 1.0), PRIOR, StochasticModel(), components=components,
        assumed=("LiDAR",),
    )  # fmt: skip
    serious = {e.code for e in result_warnings(result, None) if e.level is Level.WARNING}
    assert serious <= usual


def test_settings_know_which_sigmas_nobody_gave() -> None:
    settings = Settings((0.0, 0.0, 1.0))
    assert settings.assumed_sigmas == SIGMA_GROUPS
    assert settings.used_lidar_sigma == 0.005
    given = replace(settings, lidar_sigma=0.005, position_sigma=(0.02, 0.02, 0.03))
    assert given.assumed_sigmas == ("POS attitude",)
    assert replace(settings, lidar_beam_sigma=(0.004, 0.01)).assumed_sigmas == SIGMA_GROUPS[1:]
    assert settings.with_lidar_noise_scaled(0.4).assumed_sigmas == SIGMA_GROUPS[1:]
    assert settings.with_lidar_noise_scaled(0.4).lidar_sigma == 0.002


def test_settings_know_that_a_noise_comes_from_residuals() -> None:
    settings = Settings((0.0, 0.0, 1.0), lidar_sigma=0.005)
    assert not settings.is_lidar_noise_from_residuals
    taken = settings.with_lidar_noise_scaled(0.4)
    assert taken.is_lidar_noise_from_residuals
    assert taken.with_values(latency=0.1).is_lidar_noise_from_residuals
    assert not taken.with_lidar_sigma(0.002).is_lidar_noise_from_residuals
    beam = taken.with_values(lidar_beam_sigma=(0.002, 0.01))
    assert beam.lidar_noise_source == "given"
    by_script = settings.with_values(lidar_sigma=0.002, lidar_noise_source="residuals")
    assert by_script == taken
    assumed = replace(taken, lidar_sigma=None)
    assert "LiDAR" in assumed.assumed_sigmas
    assert not assumed.is_lidar_noise_from_residuals


def test_a_noise_from_the_residuals_is_not_judged_by_them() -> None:
    data = _survey()
    result = adjust(data, PRIOR, StochasticModel(), diagnostics=False)
    assert result.chi_square.passed
    assert adjustment_values(result).chi_square.outcome == "passed"
    taken = adjustment_values(replace(result, lidar_noise_from_residuals=True)).chi_square
    assert (taken.outcome, taken.passed) == ("not judged", None)
    estimated = adjust(
        data.with_scaled_sigmas(0.5, 1.0, 1.0), PRIOR, StochasticModel(), components=None,
        assumed=("LiDAR",), diagnostics=False,
    )  # fmt: skip
    assert estimated.chi_square.passed
    assert adjustment_values(estimated).chi_square.outcome == "not judged"


def test_one_form_of_the_lidar_noise_replaces_another() -> None:
    settings = Settings((0.0, 0.0, 1.0), lidar_sigma=0.005, lidar_beam_sigma=(0.005, 0.001))
    given = settings.with_values(lidar_sigma=0.02)
    assert (given.lidar_beam_sigma, given.used_lidar_sigma) == (None, 0.02)
    assert settings.with_values(latency=0.1).lidar_beam_sigma == (0.005, 0.001)
    axes = settings.with_values(lidar_sigma_xyz=(0.003, 0.004, 0.012))
    assert axes.lidar_beam_sigma is None
    assert axes.used_lidar_sigma == pytest.approx(np.sqrt((9 + 16 + 144) / 3) / 1000)
    typed = settings.with_lidar_sigma(0.02)
    assert (typed.lidar_beam_sigma, typed.used_lidar_sigma) == ((0.02, 0.001), 0.02)
    assert axes.with_lidar_sigma(0.02).lidar_sigma_xyz is None


@pytest.mark.parametrize("surface", [None, 0.0])
def test_a_rough_target_leaves_an_assumed_lidar_noise_undetermined(surface: float | None) -> None:
    """The larger noise of one target is that of its surface."""
    data = _survey()
    rough = data.target_of_sighting[data.sighting] == 1
    points = data.points_lidar.copy()
    points[rough] += np.random.default_rng(1).normal(0.0, 0.02, points[rough].shape)
    result = adjust(
        replace(data, points_lidar=points), PRIOR, StochasticModel(surface=surface),
        components=None, assumed=("LiDAR",), diagnostics=False,
    )  # fmt: skip
    first, second = result.targets
    assert second.noise > 3 * first.noise
    assert result.sigma_factors == (1.0, 1.0, 1.0)
    assert result.unestimated_sigmas == ("LiDAR",)


def test_two_lines_determine_an_assumed_lidar_noise() -> None:
    data = _survey()
    two = data.of_sightings(np.array([s.line in ("L1", "L3") for s in data.sightings]))
    found = adjust(
        two.with_scaled_sigmas(0.5, 1.0, 1.0), PRIOR, StochasticModel(), components=None,
        assumed=("LiDAR",), diagnostics=False,
    )  # fmt: skip
    assert found.sigma_factors[0] == pytest.approx(2.0, rel=0.1)


@pytest.mark.parametrize("assumed", [(), ("LiDAR",)])
def test_correlated_residuals_do_not_keep_an_assumed_noise_that_is_too_large(assumed) -> None:
    data = _survey()
    rng, block = np.random.default_rng(1), assign_surface_blocks(data, PRIOR)
    own = data.target_of_sighting[data.sighting] == 1
    rough = rng.normal(0.0, 0.0025, block.max() + 1)[block] * own
    beams = data.points_lidar / np.linalg.norm(data.points_lidar, axis=1)[:, None]
    uneven = replace(data, points_lidar=data.points_lidar + rough[:, None] * beams)
    result = adjust(
        uneven.with_scaled_sigmas(4.0, 1.0, 1.0), PRIOR, StochasticModel(), components=None,
        assumed=assumed, diagnostics=False,
    )  # fmt: skip
    if assumed:
        assert result.sigma_factors[0] == pytest.approx(0.25, rel=0.15)
        assert result.unestimated_sigmas == ()
        assert result.chi_square.outcome == "passed"
    else:
        assert result.sigma_factors == (1.0, 1.0, 1.0)
