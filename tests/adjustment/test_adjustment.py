"""Tests of the adjustment: Jacobians, reduction, simulated surveys and refusals."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import scipy.linalg
import scipy.stats

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.condition_equations import (
    MOUNTING_COLUMNS,
    POSE_COLUMNS,
    SHAPE_COLUMNS,
    linearise,
)
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.robust_loss import Loss
from lispac.adjustment.model.stochastic_model import (
    MAX_KNOT_INTERVAL,
    PosErrorKnots,
    StochasticModel,
)
from lispac.adjustment.solve.group_sums import (
    AdjustmentState,
    PointWeights,
    group_points,
    sum_by_group,
)
from lispac.errors import AdjustmentError, Cancelled, RankDeficient
from lispac.io.text.plane_file import read_plane_files
from lispac.progress import Step
from lispac.survey.georeferencing import Mounting, place_points
from lispac.survey.trajectory import Poses
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG
from tests.support.surveys import TARGETS, disturbed, planar_survey

LEVER_ARM = np.array([-0.2, 0.04, 2.4])
INDEPENDENT, CORRELATED = StochasticModel("independent"), StochasticModel("correlated")
NO_SURFACE = StochasticModel("correlated", surface=0.0)
PLANES = np.array([[0.02, -0.99, 0.1, 15.0], [0.0, -0.7, 0.7, 7.0]])
PLANES /= np.linalg.norm(PLANES[:, :3], axis=1)[:, None]


def mounting(*angles_deg: float) -> Mounting:
    return Mounting(LEVER_ARM, np.radians(angles_deg or (0.0, 0.0, 0.0)))


def changed(observations: Observations, name: str, k: int, step: float) -> Observations:
    values = getattr(observations, name).copy()
    values[:, k] += step
    return replace(observations, **{name: values})


@pytest.mark.parametrize("spheres", [False, True])
@pytest.mark.parametrize("block", ["mounting", "shape", "position", "attitude", "points_lidar"])
def test_jacobians_against_central_differences(block: str, spheres: bool) -> None:
    """Planes and spheres; the mounting has a range offset, a scan-angle offset and a latency."""
    here = Mounting(LEVER_ARM, np.radians([0.5, -1.5, 2.0]), 0.12, np.radians(1.3), 0.02)
    observations = planar_survey(mounting(1.0, 2.0, -1.0), points=5)
    rate = np.random.default_rng(3).normal(0, 1, (len(observations), 6))
    radii = {"T1": None, "T2": 0.4} if spheres else {}
    observations = replace(observations, pose_rate=rate, radii=radii)
    shapes = np.array([[1.0, 15.0, 6.0, 0.4], [-1.0, 14.0, 5.0, 0.5]]) if spheres else PLANES
    conditions = linearise(observations, here, shapes)
    step = 1e-6

    def shifted(k: int, sign: float) -> np.ndarray:
        if block == "mounting":
            there = Mounting.of_values(here.values + sign * step * np.eye(9)[k])
            return linearise(observations, there, shapes).misclosure
        if block == "shape":
            return linearise(observations, here, shapes + sign * step * np.eye(4)[k]).misclosure
        return linearise(changed(observations, block, k, sign * step), here, shapes).misclosure

    analytic = {
        "mounting": conditions.rows[:, MOUNTING_COLUMNS],
        "shape": conditions.rows[:, SHAPE_COLUMNS],
        "position": conditions.rows[:, POSE_COLUMNS][:, :3],
        "attitude": conditions.rows[:, POSE_COLUMNS][:, 3:],
        "points_lidar": conditions.by_lidar,
    }[block]
    for k in range(analytic.shape[1]):
        difference = (shifted(k, 1) - shifted(k, -1)) / (2 * step)
        np.testing.assert_allclose(analytic[:, k], difference, rtol=1e-6, atol=3e-7)


def dense_rows(
    observations: Observations, here: Mounting, knots: PosErrorKnots | None, effects: np.ndarray
) -> tuple[np.ndarray, np.ndarray]:
    """Rows of the dense design matrix and variances of all points, without summation."""
    kept = [0, 1, 2, 9, 10, 11, 12, 19]
    conditions = linearise(observations, here, PLANES)
    by_pose = conditions.rows[:, POSE_COLUMNS]
    variance = ((conditions.by_lidar * observations.sigma_lidar) ** 2).sum(axis=1)
    if knots is None:
        sigma = np.hstack([observations.sigma_position, observations.sigma_attitude])
        variance += ((by_pose * sigma) ** 2).sum(axis=1)
        return conditions.rows[:, kept], variance
    u = knots.fraction[:, None]
    error = (1 - u) * effects[knots.left] + u * effects[knots.left + 1]
    misclosure = conditions.misclosure + (by_pose * error).sum(axis=1)
    sigma = np.hstack([observations.sigma_position, observations.sigma_attitude])
    # Variance of a Gauss-Markov process between two knots about their chord
    between = 2 * MAX_KNOT_INTERVAL / np.repeat([300.0, 600.0], 3) * u * (1 - u)
    variance += (between * (by_pose * sigma) ** 2).sum(axis=1)
    # Derivatives at the adjusted observations
    pull = (misclosure / variance)[:, None]
    noise = pull * conditions.by_lidar * observations.sigma_lidar**2
    adjusted = replace(observations, points_lidar=observations.points_lidar - noise)
    conditions = linearise(adjusted, here, PLANES)
    by_pose = conditions.rows[:, POSE_COLUMNS]
    rows = [conditions.rows[:, kept[:-1]], (1 - u) * by_pose, u * by_pose, misclosure[:, None]]
    return np.hstack(rows), variance


@pytest.mark.parametrize("model", [INDEPENDENT, CORRELATED])
def test_sums_equal_dense_matrix_products(model: StochasticModel) -> None:
    observations, here = planar_survey(mounting(), points=6), mounting(0.1, 0.2, 0.3)
    knots = PosErrorKnots.of(observations, model) if model is CORRELATED else None
    effects = np.random.default_rng(0).normal(0, 0.01, (len(knots.time) if knots else 0, 6))
    observations, groups = group_points(observations, knots)
    rows, variance = dense_rows(observations, here, groups.knots, effects)
    state = AdjustmentState(here, PLANES, np.zeros((12, 4)), effects)
    weights = PointWeights(Loss("none"), np.ones(2), np.ones(2))
    sums = sum_by_group(observations, groups, state, np.arange(3), weights)
    assert len(sums) == len(groups.sighting) > 1
    for g in range(len(sums)):
        own = slice(groups.start[g], groups.start[g + 1])
        expected = rows[own].T @ np.diag(1 / variance[own]) @ rows[own]
        np.testing.assert_allclose(sums[g], expected, rtol=1e-9, atol=1e-6)


def test_knots_interpolate_and_have_the_gauss_markov_prior() -> None:
    observations = planar_survey(mounting(), points=5)
    model = StochasticModel("correlated", position_time=200.0, attitude_time=500.0)
    knots = PosErrorKnots.of(observations, model)
    u = knots.fraction
    time = (1 - u) * knots.time[knots.left] + u * knots.time[knots.left + 1]
    np.testing.assert_allclose(time, observations.time, atol=1e-9)
    count = len(knots.time)
    apart = np.abs(knots.time[:, None] - knots.time[None, :])
    for k, (tau, sigma) in {0: (200.0, 0.012), 5: (500.0, np.radians(0.012))}.items():
        unit = np.zeros((count, count, 6))
        unit[range(count), range(count), k] = 1.0
        precision = np.stack([knots.apply_prior_precision(column)[:, k] for column in unit])
        expected = sigma**2 * np.exp(-apart / tau)
        np.testing.assert_allclose(np.linalg.inv(precision), expected, rtol=1e-6)


def test_elimination_of_the_pos_error_equals_generalised_least_squares() -> None:
    """The reference is one dense covariance of all misclosures, without knots."""
    observations = planar_survey(mounting(0.1, 0.2, 0.3), points=8)
    on_knots = replace(
        observations, time=np.round(observations.time / MAX_KNOT_INTERVAL) * MAX_KNOT_INTERVAL
    )
    here = mounting(0.1, 0.2, 0.3)
    result = adjust(on_knots, here, NO_SURFACE)
    planes = np.stack([target.plane for target in result.targets])
    conditions = linearise(on_knots, here.with_boresight(result.boresight), planes)
    apart = np.abs(on_knots.time[:, None] - on_knots.time[None, :])
    covariance = np.diag(((conditions.by_lidar * on_knots.sigma_lidar) ** 2).sum(axis=1))
    sigma = np.hstack([on_knots.sigma_position, on_knots.sigma_attitude])
    for k, tau in enumerate([300.0] * 3 + [600.0] * 3):
        part = conditions.rows[:, POSE_COLUMNS][:, k] * sigma[:, k]
        covariance += np.exp(-apart / tau) * np.outer(part, part)
    design = np.zeros((len(on_knots), 9))
    design[:, :3] = conditions.rows[:, :3]
    target = on_knots.target_of_sighting[on_knots.sighting]
    for k, plane in enumerate(planes):
        turns = scipy.linalg.null_space(plane[None, :3])
        columns = np.column_stack([conditions.rows[:, 9:12] @ turns, conditions.rows[:, 12]])
        design[target == k, 3 + 3 * k : 6 + 3 * k] = columns[target == k]
    expected = np.linalg.inv(design.T @ np.linalg.solve(covariance, design))[:3, :3]
    np.testing.assert_allclose(result.covariance, expected, rtol=1e-6, atol=1e-16)


@pytest.mark.parametrize("case", ["a", "c"])
def test_the_classical_model_equals_the_prototype(shared_data: Path, case: str) -> None:
    folder = shared_data / "prototype"
    expected = json.loads((folder / "expected.json").read_text())[case]
    files = [folder / case / "plane1.txt", folder / case / "plane2.txt"]
    observations, planes = read_plane_files(files, 0.0031)
    start = Mounting(
        np.array(expected["lever_arm_m"], dtype=float),
        np.radians(expected["initial_boresight_deg"]),
    )
    result = adjust(observations, start, INDEPENDENT, shapes=planes)
    np.testing.assert_allclose(
        np.degrees(result.boresight), expected["boresight_deg"], rtol=0, atol=1e-6
    )
    np.testing.assert_allclose(np.degrees(result.sigma), expected["sigma_deg"], rtol=0, atol=1e-6)
    assert result.variance_factor == pytest.approx(expected["variance_factor"], abs=1e-6)
    assert result.points == expected["points"]


@pytest.mark.parametrize("model", [INDEPENDENT, CORRELATED])
@pytest.mark.parametrize("truth_deg", [(2.0, 2.0, 2.0), (-2.0, 1.0, -0.5)])
def test_true_boresight_is_recovered_without_noise(
    model: StochasticModel, truth_deg: tuple[float, float, float]
) -> None:
    observations = planar_survey(mounting(*truth_deg))
    result = adjust(observations, mounting(), model)
    np.testing.assert_allclose(np.degrees(result.boresight), truth_deg, rtol=0, atol=1e-6)
    assert result.rms_before > 0.05
    assert result.rms_after < 1e-9


def test_incidence_is_the_angle_between_beam_and_normal() -> None:
    truth = mounting(2.0, -1.0, 0.5)
    observations = planar_survey(truth)
    result = adjust(observations, mounting(), CORRELATED)
    poses = Poses(observations.position, observations.attitude)
    scanner, points = (
        place_points(xyz, poses, truth)
        for xyz in (np.zeros_like(observations.points_lidar), observations.points_lidar)
    )
    beams = (points - scanner) / np.linalg.norm(points - scanner, axis=1)[:, None]
    for k, fit in enumerate(result.sightings):
        normal = TARGETS[fit.sighting.target][1]
        angles = np.arccos(np.abs(beams[observations.sighting == k] @ normal))
        assert fit.incidence == pytest.approx(angles.mean(), abs=1e-6)


@LONG
@pytest.mark.parametrize(
    "model",
    [
        CORRELATED,
        pytest.param(INDEPENDENT, marks=LONG),
        pytest.param(
            StochasticModel("correlated", position_time=5.0, attitude_time=5.0),
            marks=pytest.mark.long,
        ),
    ],
)
def test_sigmas_agree_with_the_errors_when_the_model_is_correct(model: StochasticModel) -> None:
    """The squared ratios of error to sigma over many surveys follow a chi-square distribution."""
    exact = planar_survey(mounting(0.2, -1.2, 0.15), points=40)
    times = (model.position_time, model.attitude_time)
    ratios = []
    for seed in range(60):
        correlated = model.pos_errors == "correlated"
        noisy = disturbed(exact, correlated=correlated, seed=seed, correlation_times=times)
        result = adjust(noisy, mounting(), model, diagnostics=False)
        ratios.append((result.boresight - np.radians([0.2, -1.2, 0.15])) / result.sigma)
    squares = np.sum(np.square(ratios), axis=0)
    lower, upper = scipy.stats.chi2.ppf([0.0005, 0.9995], 60)
    assert ((squares > lower) & (squares < upper)).all(), squares / 60


def test_shorter_correlation_times_come_with_the_sigmas_of_the_given_ones() -> None:
    """The POS errors change within half a minute; the given correlation times are far longer."""
    exact = planar_survey(mounting(0.2, -1.2, 0.15), points=400)
    noisy = disturbed(exact, correlated=True, seed=4, correlation_times=(15.0, 30.0))
    result = adjust(noisy, mounting(), CORRELATED)
    given = adjust(noisy, mounting(), CORRELATED, test_model=False)
    assert given.is_model_rejected()
    assert not result.is_model_rejected()
    assert result.given_correlation_times == (CORRELATED.position_time, CORRELATED.attitude_time)
    assert result.sigma_at_given_times is not None
    assert (result.sigma_at_given_times >= given.sigma * (1 - 1e-12)).all()
    assert result.model.position_time < CORRELATED.position_time
    held = adjust(noisy, mounting(), CORRELATED, shorten_times=False)
    assert (held.model, held.given_correlation_times) == (given.model, None)
    assert adjust(exact, mounting(), CORRELATED).sigma_at_given_times is None


def test_the_classical_model_is_over_confident_on_shared_pos_errors() -> None:
    exact = planar_survey(mounting(), points=100)
    noisy = disturbed(exact, correlated=True, seed=3)
    independent = adjust(noisy, mounting(), INDEPENDENT)
    correlated = adjust(noisy, mounting(), CORRELATED)
    assert (correlated.sigma > 2 * independent.sigma)[[0, 2]].all()


def test_sightings_at_the_same_instant_are_allowed() -> None:
    observations = planar_survey(mounting(1, 1, 1))
    still = replace(observations, time=np.zeros(len(observations)))
    result = adjust(still, mounting(), CORRELATED)
    np.testing.assert_allclose(np.degrees(result.boresight), 1.0, atol=1e-6)


@pytest.mark.parametrize("model", [INDEPENDENT, CORRELATED])
def test_order_of_the_points_does_not_matter(model: StochasticModel) -> None:
    noisy = disturbed(planar_survey(mounting()), correlated=True, seed=1)
    order = np.random.default_rng(2).permutation(len(noisy))
    columns = (
        "points_lidar", "position", "attitude", "sigma_lidar", "sigma_position",
        "sigma_attitude", "time", "sighting",
    )  # fmt: skip
    shuffled = replace(noisy, **{name: getattr(noisy, name)[order] for name in columns})
    first, second = (adjust(o, mounting(), model) for o in (noisy, shuffled))
    np.testing.assert_allclose(
        np.degrees(first.boresight), np.degrees(second.boresight), rtol=0, atol=1e-9
    )


@pytest.mark.parametrize("model", [INDEPENDENT, CORRELATED])
def test_parallel_lines_on_one_vertical_board_are_refused(model: StochasticModel) -> None:
    """Only roll is observable (thesis 4.4.1.1)."""
    level = planar_survey(mounting(), headings_deg=(0, 180), targets=("T1",), scatter=False)
    with pytest.raises(RankDeficient, check=has_code("adjustment.undetermined_because")):
        adjust(level, mounting(), model)


def test_points_on_one_straight_line_are_refused() -> None:
    observations = planar_survey(mounting(), points=3)
    same = replace(
        observations,
        points_lidar=np.tile([0.0, 10.0, 1.0], (len(observations), 1)),
        attitude=np.zeros((len(observations), 3)),
        position=np.zeros((len(observations), 3)),
    )
    with pytest.raises(RankDeficient):
        adjust(same, mounting(), INDEPENDENT)


def test_fewer_than_three_points_are_refused() -> None:
    observations = planar_survey(mounting(), points=2)
    with pytest.raises(
        AdjustmentError, check=has_code("adjustment.few_points", count=2, line="L1")
    ):
        adjust(observations, mounting(), INDEPENDENT)


def test_invalid_sigmas_are_refused() -> None:
    observations = planar_survey(mounting(), points=5)
    zero = replace(observations, sigma_lidar=np.zeros((len(observations), 3)))
    with pytest.raises(AdjustmentError, check=has_code("adjustment.sigma_lidar_zero")):
        adjust(zero, mounting(), INDEPENDENT)
    negative = replace(observations, sigma_attitude=-observations.sigma_attitude)
    with pytest.raises(AdjustmentError, check=has_code("adjustment.sigma_attitude")):
        adjust(negative, mounting(), INDEPENDENT)


def test_can_be_cancelled() -> None:
    def stop(fraction: float, step: Step | None = None) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        adjust(planar_survey(mounting(), points=5), mounting(), INDEPENDENT, progress=stop)
