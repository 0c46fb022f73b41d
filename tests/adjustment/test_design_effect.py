"""Tests of the design effect of points that share part of their noise (Kish 1965)."""

import numpy as np
import pytest

from lispac.adjustment.model.robust_loss import LOSS_NAMES
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.model.target_shapes import fit_shapes, points_local, target_centroids
from lispac.adjustment.solve.adjustment_problem import AdjustmentProblem
from lispac.adjustment.solve.noise_estimation import (
    _design_effect,
    assign_surface_blocks,
    form_error_noise,
    reestimate_noise,
    target_noise_factors,
    with_noise_blocks,
)
from tests.adjustment.test_robustness import TRUTH, survey, with_outliers

BLOCKS = np.repeat(np.arange(400), 25)


@pytest.mark.parametrize("shared", [0.2, 0.5, 1.0])
def test_the_design_effect_follows_from_the_intraclass_correlation(shared) -> None:
    """``1 + (m - 1) rho`` for m points with correlation rho, whatever the size of the residuals."""
    rng = np.random.default_rng(4)
    rho = shared**2 / (1 + shared**2)
    residuals = shared * rng.normal(size=400)[BLOCKS] + rng.normal(size=len(BLOCKS))
    found = _design_effect(residuals, BLOCKS)
    assert found == pytest.approx(1 + 24 * rho, rel=0.25)  # 7 % is one sigma for 400 sums
    assert _design_effect(7.0 * residuals, BLOCKS) == pytest.approx(found)
    assert _design_effect(residuals, 3 * BLOCKS) == pytest.approx(found), "numbers nobody has"


def test_equal_residuals_in_a_block_count_once() -> None:
    signs = np.where(np.arange(400) % 2, 1.0, -1.0)
    assert _design_effect(signs[BLOCKS], BLOCKS) == pytest.approx(25.0)


def test_random_variation_is_no_design_effect() -> None:
    rng = np.random.default_rng(5)
    found = [_design_effect(rng.normal(size=len(BLOCKS)), BLOCKS) for _ in range(40)]
    # By chance one in forty exceeds two sigmas of a chi square of 400
    assert found.count(1.0) >= 36
    assert _design_effect(np.zeros(len(BLOCKS)), BLOCKS) == 1.0


def test_a_small_excess_over_chance_is_measured() -> None:
    """An excess of one half is seven sigmas for 400 sums."""
    rng = np.random.default_rng(6)
    residuals = rng.normal(size=400)[BLOCKS] * np.sqrt(0.5 / 24) + rng.normal(size=len(BLOCKS))
    assert _design_effect(residuals, BLOCKS) == pytest.approx(1.5, abs=0.3)


def test_outliers_are_noise_unless_a_robust_loss_is_used() -> None:
    outliers, _ = with_outliers(survey(1, 0.3), 3)
    noise, scale = {}, {}
    for loss in LOSS_NAMES:
        problem = AdjustmentProblem.of(outliers, TRUTH, StochasticModel(loss=loss))
        problem = with_noise_blocks(problem)
        state = problem.start(TRUTH, fit_shapes(survey(1, 0.3), TRUTH))
        estimated = reestimate_noise(problem, state)
        noise[loss], scale[loss] = estimated.noise, estimated.scale
    np.testing.assert_array_equal(scale["none"], 1.0)
    np.testing.assert_array_equal(noise["huber"], noise["tukey"])
    assert (noise["none"] > 3.0 * noise["tukey"]).all(), noise


@pytest.mark.parametrize("seed", range(4))
def test_only_a_bend_common_to_all_lines_is_a_form_error(seed) -> None:
    """A bend of the surfaces, then a bend of the lines with opposite signs on half of them."""
    data, rng = survey(seed, 0.04), np.random.default_rng(seed)
    owner, line = data.target_of_sighting[data.sighting], data.sighting
    off = np.linalg.norm(points_local(data, TRUTH) - target_centroids(data, TRUTH)[owner], axis=1)
    size = np.array([off[owner == k].max() for k in range(len(data.targets))])[owner]
    bend = 2 * (off / size) ** 2
    names = sorted({each.line for each in data.sightings})
    signs = np.array([(-1.0) ** names.index(each.line) for each in data.sightings])
    noise = rng.normal(size=len(data))
    blocks, every = assign_surface_blocks(data, TRUTH), np.ones(len(data.targets), dtype=bool)
    of_surface = form_error_noise(data, TRUTH, noise + bend, every)
    assert (of_surface > 1.6).all()
    np.testing.assert_allclose(
        of_surface, target_noise_factors(data, noise + bend - bend.mean(), blocks, None), rtol=0.4
    )
    of_lines = noise + signs[line] * bend
    assert (target_noise_factors(data, of_lines, blocks, None) > 2).all()
    assert (form_error_noise(data, TRUTH, of_lines, every) < 1.35).all()
    some = every & (np.arange(len(every)) > 0)
    np.testing.assert_array_equal(np.isnan(form_error_noise(data, TRUTH, noise, some)), ~some)
