"""Tests that the standard deviations of the given lever arm increase those of the angles."""

from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.diagnostics.excess_scatter import with_raised_sigmas
from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import AdjustmentResult
from lispac.simulation.closed_form_survey import (
    THESIS_BOARDS,
    add_errors,
    error_free_survey,
    six_courses,
)
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS
from lispac.survey.georeferencing import Mounting

TRUE_MOUNTING = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.2, -1.2, 0.15]))
EXACT = StochasticModel(loss="tukey", surface=1e-5)
SIGMA = 0.03, 0.02, 0.04
UNCERTAIN = replace(EXACT, lever_arm_sigma=SIGMA)
LINES = 4
"""Few lines, so that the angles absorb much of an error of the lever arm."""


def survey(seed: int) -> tuple[Observations, np.random.Generator]:
    generator = np.random.default_rng([65, seed])
    courses = six_courses()[:LINES]
    free = error_free_survey(TRUE_MOUNTING, THESIS_BOARDS, courses, 0.1, generator)
    return add_errors(free, HYDROGRAPHIC_INS, generator), generator


def estimated(
    observations: Observations, lever_arm: np.ndarray, model: StochasticModel
) -> AdjustmentResult:
    thinned = average_points_in_cells(observations, TRUE_MOUNTING, 0.2)
    prior = replace(TRUE_MOUNTING.with_boresight(np.zeros(3)), lever_arm=lever_arm)
    return adjust(thinned, prior, model, test_model=False)


@pytest.fixture(scope="module")
def results() -> dict[str, AdjustmentResult]:
    observations, _ = survey(0)
    return {
        "exact": estimated(observations, TRUE_MOUNTING.lever_arm, EXACT),
        "uncertain": estimated(observations, TRUE_MOUNTING.lever_arm, UNCERTAIN),
    }


def test_the_effect_is_the_change_with_another_lever_arm(
    results: dict[str, AdjustmentResult],
) -> None:
    """Compared with adjustments with a lever arm that differs by 1 mm in one component."""
    observations, _ = survey(0)
    effect = results["exact"].lever_arm_effect
    assert effect is not None
    for k in range(3):
        shift = 0.001 * np.eye(3)[k]
        fixed = replace(EXACT, loss="none")
        low, high = (
            estimated(observations, TRUE_MOUNTING.lever_arm + sign * shift, fixed)
            for sign in (-1, 1)
        )
        change = (high.boresight - low.boresight) / 0.002
        expected = low.lever_arm_effect
        assert expected is not None
        assert np.abs(change - expected[:, k]).max() < 0.01 * np.abs(expected).max()


def test_only_the_standard_deviations_change(results: dict[str, AdjustmentResult]) -> None:
    exact, uncertain = results["exact"], results["uncertain"]
    np.testing.assert_array_equal(uncertain.boresight, exact.boresight)
    assert exact.lever_arm_effect is not None
    moves = exact.lever_arm_effect * SIGMA
    np.testing.assert_allclose(uncertain.covariance, exact.covariance + moves @ moves.T)
    np.testing.assert_allclose(uncertain.with_exact_lever_arm.covariance, exact.covariance)
    assert uncertain.observability is not None
    np.testing.assert_allclose(
        np.linalg.inv(
            uncertain.observability.directions
            @ np.diag(uncertain.observability.eigenvalues)
            @ uncertain.observability.directions.T
        ),
        uncertain.covariance,
        rtol=1e-6,
        atol=1e-14,
    )
    codes = [each.code for each in result_warnings(uncertain, None)]
    assert "adjustment.lever_arm_uncertainty" in codes
    assert "adjustment.lever_arm_uncertainty" not in [
        each.code for each in result_warnings(exact, None)
    ]


def test_raised_sigmas_do_not_raise_the_share_of_the_lever_arm(
    results: dict[str, AdjustmentResult],
) -> None:
    exact, uncertain = results["exact"], results["uncertain"]
    factors = np.array([1.5, 2.0, 1.0])
    raised = with_raised_sigmas(uncertain, factors)
    np.testing.assert_allclose(
        np.diag(raised.covariance),
        factors**2 * np.diag(exact.covariance) + np.diag(uncertain.lever_arm_covariance),
    )
    np.testing.assert_allclose(raised.with_formal_sigmas.covariance, exact.covariance)


def test_an_estimated_component_has_no_effect() -> None:
    observations, _ = survey(0)
    prior = TRUE_MOUNTING.with_boresight(np.zeros(3))
    thinned = average_points_in_cells(observations, prior, 0.2)
    freed = Parameter("lever_x", SIGMA[0])
    result = adjust(thinned, prior, UNCERTAIN, parameters=(freed,), test_model=False)
    assert result.lever_arm_effect is not None
    assert "lever_x" in result.estimated
    assert (result.lever_arm_effect[:, 0] == 0).all()
    assert (result.lever_arm_effect[:, 1] != 0).any()
    names, covariance = result.mounting_covariance()
    assert names == ("roll", "pitch", "yaw", "lever_x", "lever_y", "lever_z")
    assert np.linalg.eigvalsh(covariance).min() > 0
    np.testing.assert_allclose(covariance[:4, :4], result.covariance_all)
    np.testing.assert_allclose(np.sqrt(np.diag(covariance)[4:]), SIGMA[1:])


def _normalised_errors(count: int) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    for seed in range(count):
        observations, generator = survey(seed)
        lever_arm = TRUE_MOUNTING.lever_arm + np.array(SIGMA) * generator.standard_normal(3)
        result = estimated(observations, lever_arm, UNCERTAIN)
        error = result.boresight - TRUE_MOUNTING.boresight
        yield error / result.sigma, error / result.with_exact_lever_arm.sigma


@pytest.mark.parametrize("count", [40, pytest.param(300, marks=pytest.mark.long)])
def test_the_standard_deviations_hold_with_a_wrong_lever_arm(count: int) -> None:
    """Errors of the angles over their sigmas, with a lever arm drawn from its sigmas.

    The RMS of ``count`` standard normal values has a sigma of about ``1 / sqrt(2 count)``.
    """
    errors = np.array(list(_normalised_errors(count)))
    rms = np.sqrt((errors**2).mean(axis=0))
    print(f"RMS with and without the lever arm: {rms.round(3).tolist()}")
    inside = 100 * (np.abs(errors) < 1.96).mean(axis=0)
    print(f"in the 95 % interval: {inside.round(1).tolist()}")
    assert (np.abs(rms[0] - 1) < 3.5 / np.sqrt(2 * count)).all()
    assert rms[1].max() > 1.5
