"""Tests of the adjustment of point correspondences on simulated surveys."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.linalg import cho_factor, cho_solve

from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.correspondences.adjustment import (
    MIN_PAIRS,
    CorrespondenceEstimate,
    _coarse_knots,
    _linearise,
    adjust_correspondences,
)
from lispac.errors import AdjustmentError
from lispac.survey.georeferencing import Mounting, place_points
from lispac.survey.trajectory import Poses
from tests.support.correspondence_survey import TRUE_MOUNTING, SimulatedPairs, simulate_pairs
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG

MODEL = StochasticModel()
PRIOR = TRUE_MOUNTING.with_boresight(np.zeros(3))


def adjusted(pairs: SimulatedPairs, noise: float | None = None) -> CorrespondenceEstimate:
    return adjust_correspondences(pairs.ends, PRIOR, MODEL, noise=noise)


def test_without_noise_the_boresight_is_exact() -> None:
    found = adjusted(simulate_pairs(1, 200, noise=0.0, pos_factor=0.0))
    assert found.boresight == pytest.approx(TRUE_MOUNTING.boresight, abs=1e-9)
    assert found.rms_after < 1e-9
    assert found.used.all()


def test_derivatives_agree_with_differences() -> None:
    ends = simulate_pairs(2, 30).ends
    knots = _coarse_knots(ends, MODEL)
    conditions = _linearise(ends, PRIOR, knots)
    count, step = len(ends) // 2, 1e-5

    def differences(mounting: Mounting, corrections: np.ndarray) -> np.ndarray:
        u = knots.fraction[:, None]
        moved = (1 - u) * corrections[knots.left] + u * corrections[knots.left + 1]
        poses = Poses(ends.position + moved[:, :3], ends.attitude + moved[:, 3:])
        points = place_points(ends.points_lidar, poses, mounting)
        return points[:count] - points[count:]

    none = np.zeros((len(knots.time), 6))
    assert conditions.difference == pytest.approx(differences(PRIOR, none), abs=1e-9)
    for k in range(3):
        moves = [
            differences(PRIOR.with_boresight(PRIOR.boresight + sign * step * np.eye(3)[k]), none)
            for sign in (1, -1)
        ]
        expected = (moves[0] - moves[1]) / (2 * step)
        assert conditions.by_boresight[:, :, k] == pytest.approx(expected, abs=1e-6)
    generator = np.random.default_rng(0)
    for _ in range(5):
        change = step * generator.standard_normal(none.shape)
        expected = 0.5 * (differences(PRIOR, change) - differences(PRIOR, -change))
        found = (conditions.by_pos @ change.ravel()).reshape(-1, 3)
        assert found == pytest.approx(expected, abs=1e-9)


def test_the_result_is_that_of_generalised_least_squares() -> None:
    """The POS errors are eliminated into the covariance matrix of all differences instead."""
    noise, pairs = 0.03, simulate_pairs(3, 150)
    found = adjusted(pairs, noise)
    assert found.used.all()
    ends = pairs.ends
    at = PRIOR.with_boresight(found.boresight)
    conditions = _linearise(ends, at, _coarse_knots(ends, MODEL))
    count = len(ends) // 2
    times = np.repeat([MODEL.position_time, MODEL.attitude_time], 3)
    step = 1e-6
    rows = []  # derivatives of the differences by the six components of the pose at each end
    for c in range(6):
        moved = [
            Poses(ends.position + s * step * np.eye(6)[c, :3],
                  ends.attitude + s * step * np.eye(6)[c, 3:])
            for s in (1, -1)
        ]  # fmt: skip
        points = [place_points(ends.points_lidar, each, at) for each in moved]
        rows.append((points[0] - points[1]) / (2 * step))
    covariance = noise**2 * np.eye(3 * count)
    sign = np.repeat([1.0, -1.0], count)
    sigmas = np.hstack([ends.sigma_position, ends.sigma_attitude])
    for c in range(6):
        correlation = np.exp(-np.abs(ends.time[:, None] - ends.time) / times[c])
        errors = correlation * sigmas[:, c] * sigmas[:, c, None]
        by_end = (rows[c] * sign[:, None]).T  # (3, 2 n)
        block = np.einsum("ip,pq,jq->ipjq", by_end, errors, by_end)
        block = block.reshape(3, 2, count, 3, 2, count).sum(axis=(1, 4))
        covariance += block.transpose(1, 0, 3, 2).reshape(3 * count, 3 * count)
    design = conditions.by_boresight.reshape(-1, 3)
    factor = cho_factor(covariance)
    normal = design.T @ cho_solve(factor, design)
    step_left = np.linalg.solve(normal, design.T @ cho_solve(factor, conditions.difference.ravel()))
    sigma = np.sqrt(np.diag(np.linalg.inv(normal)))
    assert np.abs(step_left).max() < 0.05 * sigma.min()
    assert found.sigma == pytest.approx(sigma, rel=0.01), "with the variance between the knots"


@pytest.mark.parametrize("wrong", [0.0, 0.3])
def test_wrong_pairs_are_rejected(wrong: float) -> None:
    found = adjusted(simulate_pairs(4, 300, wrong=wrong))
    assert found.used.mean() == pytest.approx(1 - wrong, abs=0.01)
    assert np.abs(found.boresight - TRUE_MOUNTING.boresight).max() < 4 * found.sigma.max()
    assert found.noise == pytest.approx(0.03, rel=0.1)
    assert found.is_noise_estimated


def test_a_given_noise_is_used_and_judged() -> None:
    found = adjusted(simulate_pairs(5, 300), noise=0.06)
    assert found.noise == 0.06
    assert not found.is_noise_estimated
    assert found.variance_factor == pytest.approx(0.25, rel=0.15)


def test_angles_that_the_pairs_do_not_show_are_named() -> None:
    """Both points of each pair at the same time: any boresight displaces them equally."""
    ends = simulate_pairs(6, 60).ends
    count = len(ends) // 2
    twice = np.tile(np.arange(count), 2)
    same = replace(
        ends,
        **{
            name: getattr(ends, name)[twice]
            for name in ("points_lidar", "position", "attitude", "time")
        },
    )
    with pytest.raises(AdjustmentError, check=has_code("correspondences.undetermined")):
        adjust_correspondences(same, PRIOR, MODEL)


def test_few_pairs_are_refused() -> None:
    with pytest.raises(AdjustmentError, check=has_code("correspondences.few")):
        adjusted(simulate_pairs(7, MIN_PAIRS - 1))


def test_mostly_wrong_pairs_are_refused() -> None:
    with pytest.raises(AdjustmentError, check=has_code("correspondences.most_rejected")):
        adjusted(simulate_pairs(8, 200, wrong=0.8), noise=0.03)


@pytest.mark.parametrize(
    ("surveys", "wrong"), [(12, 0.1), *(pytest.param(300, each, marks=LONG) for each in (0.0, 0.1))]
)
@pytest.mark.timeout(3600)
def test_the_standard_deviations_hold(surveys: int, wrong: float) -> None:
    errors, noises = [], []
    for seed in range(surveys):
        found = adjusted(simulate_pairs(1000 + seed, 200, wrong=wrong))
        errors.append((found.boresight - TRUE_MOUNTING.boresight) / found.sigma)
        noises.append(found.noise)
    inside = np.abs(errors) < 1.96
    print(
        f"{surveys} surveys, {100 * wrong:.0f} % wrong: "
        f"95 % intervals {np.round(100 * inside.mean(axis=0), 1)} %, "
        f"scatter {np.round(np.std(errors, axis=0), 3)}, noise {1000 * np.mean(noises):.2f} mm"
    )
    if surveys < 100:
        assert np.square(errors).mean() == pytest.approx(1.0, abs=3 * np.sqrt(2 / (3 * surveys)))
    else:
        assert 0.93 <= inside.mean() <= 0.97
    scatter = 1 / np.sqrt(2 * 3 * 200 * (1 - wrong) * surveys)
    assert np.mean(noises) == pytest.approx(0.03, rel=max(3 * scatter, 0.01))
