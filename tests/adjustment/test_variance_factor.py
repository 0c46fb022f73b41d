"""Tests that the variance factor is 1 if the given sigmas are those of the simulator."""

from dataclasses import replace

import numpy as np
import pytest
import scipy.stats

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.observations import Observations, Sighting
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import PosErrorKnots, StochasticModel
from lispac.geometry.frames import LocalFrame
from lispac.project import Settings
from lispac.simulation.pos_errors import PosErrorModel
from lispac.simulation.scene import Scene
from lispac.simulation.simulated_survey import SurveySetup, simulate_survey
from lispac.survey.georeferencing import Mounting
from lispac.survey.trajectory import LocalTrajectory, Trajectory
from lispac.workflow.planning.simulated_setup import read_simulation
from tests.studies import coverage_of_errors
from tests.support.long_runs import others_long

SURVEYS = 6


def marine() -> SurveySetup:
    """The marine scene with its two boards only."""
    setup = read_simulation("marine").setup
    boards = [surface for surface in setup.scene.surfaces if surface.name in setup.targets]
    return replace(setup, scene=Scene.of(boards), validation=())


def surveyed(setup: SurveySetup, seed: int) -> Observations:
    """Simulate a survey; return observations with true labels and the sigmas of the simulator."""
    survey, pos, scanner = simulate_survey(setup, seed=seed), setup.pos, setup.scanner
    assert isinstance(pos, PosErrorModel)
    measured = survey.trajectory
    attitude = np.stack([measured.roll, measured.pitch, measured.heading], axis=1)
    states = Trajectory(
        measured.time, measured.latitude, measured.longitude, measured.height, attitude
    )
    trajectory = LocalTrajectory.of(states, LocalFrame(*setup.origin))
    points_of_sightings = [
        (Sighting(name, line.name), np.flatnonzero(line.label == k), line)
        for line in survey.lines
        for k, name in enumerate(survey.surface_names)
    ]
    points = np.concatenate([line.points_lidar[own] for _, own, line in points_of_sightings])
    time = np.concatenate([line.time[own] for _, own, line in points_of_sightings])
    poses = trajectory.at(time)
    across = scanner.angle_sigma * np.linalg.norm(points, axis=1)
    return Observations(
        points_lidar=points,
        position=poses.position,
        attitude=poses.attitude,
        sigma_lidar=np.stack([np.full(len(time), scanner.range_sigma), across, across], axis=1),
        beam_sigmas=True,
        sigma_position=np.tile(pos.sigma_position, (len(time), 1)),
        sigma_attitude=np.tile(pos.sigma_attitude, (len(time), 1)),
        time=time,
        sighting=np.repeat(
            np.arange(len(points_of_sightings)), [len(own) for _, own, _ in points_of_sightings]
        ),
        sightings=tuple(sighting for sighting, _, _ in points_of_sightings),
    )


@pytest.mark.parametrize("count", others_long([2, SURVEYS]))
def test_the_variance_factor_of_exact_sigmas_is_one(count: int) -> None:
    """Several surveys averaged to 10 cm as by default; chi-square test at a level of 0.001."""
    setup, model = marine(), StochasticModel()
    prior = Mounting(setup.mounting.lever_arm, np.zeros(3))
    statistic, freedom = 0.0, 0
    for seed in range(count):
        points = average_points_in_cells(
            surveyed(setup, seed), prior, 0.1, longest=model.knot_interval
        )
        result = adjust(points, prior, model, diagnostics=False)
        statistic += result.chi_square.statistic
        freedom += result.degrees_of_freedom
    lower, upper = scipy.stats.chi2.ppf([0.0005, 0.9995], freedom) / freedom
    assert lower < statistic / freedom < upper


def test_mean_of_points_deviates_less_from_the_chord_than_the_points() -> None:
    """Compare with the mean covariance of a Brownian bridge over all pairs of points."""
    generator = np.random.default_rng(5)
    model = StochasticModel()
    count, interval = 40, model.knot_interval
    time = interval * (7 + generator.uniform(0.1, 0.9, count))
    flat = np.column_stack([generator.uniform(0, 0.01, (count, 2)), np.full(count, 5.0)])
    sigma = np.full((count, 3), 0.01)
    observations = Observations(
        points_lidar=flat,
        position=np.zeros((count, 3)),
        attitude=np.zeros((count, 3)),
        sigma_lidar=sigma,
        sigma_position=sigma,
        sigma_attitude=sigma,
        time=time,
        sighting=np.zeros(count, dtype=np.int64),
        sightings=(Sighting("T", "L"),),
    )
    u = time / interval - 7
    single = PosErrorKnots.of(observations, model)
    np.testing.assert_allclose(single.bridge_variance, u * (1 - u), atol=1e-9)
    level = Mounting(np.zeros(3), np.zeros(3))
    mean = average_points_in_cells(observations, level, 1.0, longest=interval)
    assert len(mean) == 1
    pairs = np.minimum(u[:, None], u) - u[:, None] * u
    knots = PosErrorKnots.of(mean, model)
    np.testing.assert_allclose(knots.bridge_variance, pairs.mean(), atol=1e-9)
    assert knots.bridge_variance[0] < 0.8 * np.mean(u * (1 - u))


@pytest.mark.parametrize("scale", [2.5, 1.0, 0.5])
def test_the_lidar_noise_is_that_of_the_residuals(scale: float) -> None:
    """Given sigmas that are too large are conservative, not an error."""
    data = coverage_of_errors.survey("none", 3)
    given = replace(data, sigma_lidar=scale * data.sigma_lidar)
    result = adjust(given, coverage_of_errors.PRIOR, coverage_of_errors.MODEL)
    outcome = {2.5: "conservative", 1.0: "passed", 0.5: "failed"}[scale]
    assert result.chi_square.outcome == outcome
    if outcome == "passed":
        assert result.lidar_noise_ratio is None
    else:
        assert result.lidar_noise_ratio == pytest.approx(1 / scale, rel=0.03)
        settings = Settings((0.0, 0.0, 0.0), lidar_sigma=scale * 0.004)
        scaled = settings.with_lidar_noise_scaled(result.lidar_noise_ratio)
        assert scaled.lidar_sigma == pytest.approx(0.004, rel=0.03)
        found = replace(data, sigma_lidar=scaled.lidar_sigma / 0.004 * data.sigma_lidar)
        again = adjust(found, coverage_of_errors.PRIOR, coverage_of_errors.MODEL)
        assert again.chi_square.outcome == "passed"
        assert again.lidar_noise_ratio is None


def test_a_rough_target_is_not_taken_for_lidar_noise() -> None:
    data = coverage_of_errors.survey("none", 3)
    own = data.target_of_sighting[data.sighting] == data.targets.index("T5")
    given = replace(data, sigma_lidar=np.where(own[:, None], 0.3, 1.0) * data.sigma_lidar)
    result = adjust(given, coverage_of_errors.PRIOR, coverage_of_errors.MODEL)
    assert result.chi_square.outcome == "failed"
    assert result.lidar_noise_ratio is None


def test_all_given_lidar_sigmas_are_scaled() -> None:
    settings = Settings((0.0, 0.0, 0.0), lidar_sigma_xyz=(0.001, 0.002, 0.004))
    assert settings.with_lidar_noise_scaled(2.04).lidar_sigma_xyz == (0.00204, 0.00408, 0.00816)
    settings = Settings((0.0, 0.0, 0.0), lidar_beam_sigma=(0.01, 0.05))
    assert settings.with_lidar_noise_scaled(0.333).lidar_beam_sigma == (0.00333, 0.0167)
