"""Tests of the noise of LiDAR points along the normal of a surface."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.adjustment.model.condition_equations import lidar_variance
from lispac.project import Project
from lispac.survey.georeferencing import Mounting, directions_to_lidar, to_lidar
from lispac.survey.lidar_noise import LidarNoise
from lispac.survey.trajectory import Poses
from lispac.targets.sighting_quality import plane_quality
from lispac.workflow.calibration.sighting_assessment import sighting_qualities
from lispac.workflow.project.survey import Survey
from tests.targets.test_quality import fit_plane

BEAM = LidarNoise((0.0026,) * 3, (0.0026, np.radians(0.0052)))
AXES = LidarNoise((0.001, 0.002, 0.004))
ROUGH_CODES = {"quality.rough", "quality.rough_beyond_threshold"}


def oblique_board(
    angle_deg: float, rms: float = 0.0, *, count: int = 20000
) -> tuple[np.ndarray, np.ndarray]:
    """Points with noise along and across the beam on a board at 45.7 m and 55 deg, and its normal.

    Parameters
    ----------
    angle_deg : float
        Noise of the beam direction.
    rms : float, metres
        Roughness of the board.
    """
    rng = np.random.default_rng(5)
    angle = np.radians(55.0)
    normal = np.array([np.sin(angle), -np.cos(angle), 0.0])
    along, up = np.array([np.cos(angle), np.sin(angle), 0.0]), np.array([0.0, 0.0, 1.0])
    u, v = rng.uniform(-0.75, 0.75, (2, count))
    off = rng.normal(0.0, rms, count) if rms else np.zeros(count)
    true = np.array([0.0, 45.7, 0.0]) + np.outer(u, along) + np.outer(v, up) + np.outer(off, normal)
    ranges = np.linalg.norm(true, axis=1, keepdims=True)
    beams = true / ranges
    sideways = np.cross(beams, up)
    sideways /= np.linalg.norm(sideways, axis=1, keepdims=True)
    upwards = np.cross(sideways, beams)
    noise = rng.normal(0.0, 1.0, (3, count, 1))
    across = ranges * np.radians(angle_deg)
    shift = 0.0026 * noise[0] * beams + across * (noise[1] * sideways + noise[2] * upwards)
    return true + shift, normal


@pytest.mark.parametrize("noise", [BEAM, AXES])
def test_variance_is_that_of_the_adjustment(noise: LidarNoise) -> None:
    rng = np.random.default_rng(2)
    points = rng.normal(0.0, 30.0, (40, 3))
    normals = rng.normal(0.0, 1.0, (40, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    sigmas = noise.sigmas(points)
    expected = [
        lidar_variance(i, points, sigmas, noise.beam is not None, normals[i]) ** 0.5
        for i in range(len(points))
    ]
    np.testing.assert_allclose(noise.along_normals(points, normals), expected, rtol=1e-12)


def test_normal_sigma_is_the_scatter_of_simulated_points() -> None:
    points, normal = oblique_board(0.0052)
    predicted = BEAM.normal_sigma(points, np.tile(normal, (len(points), 1)))
    assert predicted == pytest.approx(0.00371, abs=0.00002)
    assert np.std(points @ normal) == pytest.approx(predicted, rel=0.02)


def test_one_value_for_all_axes_is_the_noise_in_all_directions() -> None:
    points, normal = oblique_board(0.0, count=10)
    normals = np.tile(normal, (10, 1))
    assert LidarNoise((0.0019,) * 3).normal_sigma(points, normals) == 0.0019


@pytest.mark.parametrize(("rms", "is_rough"), [(0.0, False), (0.020, True)])
def test_a_board_is_rough_only_beyond_range_and_beam_noise(rms: float, is_rough: bool) -> None:
    points, normal = oblique_board(0.012, rms)
    beam = LidarNoise((0.0026,) * 3, (0.0026, np.radians(0.012)))
    noise = beam.normal_sigma(points, np.tile(normal, (len(points), 1)))
    every = np.arange(len(points))
    quality = plane_quality(points, points, every, fit_plane(points), noise)
    assert bool(ROUGH_CODES & {each.code for each in quality.reasons}) == is_rough
    assert (quality.flatness == "good") != is_rough
    # The noise of the range alone calls even the flat board rough.
    by_range = plane_quality(points, points, every, fit_plane(points), 0.0026)
    assert ROUGH_CODES & {each.code for each in by_range.reasons}


def test_directions_are_rotated_as_points_are() -> None:
    rng = np.random.default_rng(4)
    poses = Poses(rng.normal(0.0, 50.0, (6, 3)), rng.uniform(-1.0, 1.0, (6, 3)))
    mounting = Mounting(np.array([1.0, 2.0, 3.0]), np.array([0.1, -0.2, 2.0]), 0.0, 0.03)
    start, directions = rng.normal(0.0, 20.0, (2, 6, 3))
    moved = to_lidar(start + directions, poses, mounting) - to_lidar(start, poses, mounting)
    np.testing.assert_allclose(directions_to_lidar(directions, poses, mounting), moved, atol=1e-12)


def with_beam_noise(survey: Survey, angle: float) -> Survey:
    """The survey with noise of the beam direction, radians, added to its points."""
    rng = np.random.default_rng(8)
    scans = {}
    for name, scan in survey.scans.items():
        points, _ = scan.take(np.arange(len(scan)))
        noise = rng.normal(0.0, angle, points.shape) * np.linalg.norm(points, axis=1)[:, None]
        beams = points / np.linalg.norm(points, axis=1, keepdims=True)
        noise -= np.einsum("ni,ni->n", noise, beams)[:, None] * beams
        scans[name] = replace(scan, points_lidar=points + noise)
    return replace(survey, scans=scans)


def test_ratings_of_a_project_use_the_noise_of_the_beam(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated
    angle_deg = 0.04
    noisy = with_beam_noise(survey, np.radians(angle_deg))

    def rough_sightings(beam_deg: float | None) -> set[tuple[str, str]]:
        beam = None if beam_deg is None else (project.settings.used_lidar_sigma, beam_deg)
        settings = replace(project.settings, lidar_beam_sigma=beam)
        found = sighting_qualities(replace(project, settings=settings), noisy)
        return {
            key
            for key, quality in found.items()
            if any(each.code.startswith("quality.rough") for each in quality.reasons)
        }

    assert rough_sightings(None)
    assert rough_sightings(angle_deg) == set()


def test_sigma_for_surfaces_of_any_orientation(calibrated: tuple[Project, Survey]) -> None:
    project, survey = calibrated

    def sigma(**values: object) -> float:
        return survey.lidar_sigma(project.settings.with_values(**values))

    ranges = np.concatenate([cloud.sample_range for cloud in survey.clouds.values()])
    expected = np.median(ranges) * np.radians(0.5)
    assert sigma(lidar_beam_sigma=(0.002, 0.5)) == pytest.approx(expected)
    assert sigma(lidar_beam_sigma=(0.002, 1e-5)) == 0.002
    assert sigma(lidar_sigma=0.0031) == 0.0031
