"""Tests of scanner models: directions and number of beams, and effects of the incidence angle."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.simulation.scanner import Echoes, Scanner, scan_scene
from lispac.simulation.scene import Scene, Sphere, upright_rectangle
from lispac.survey.georeferencing import Mounting

ELEVATIONS_DEG = (-30.67, -9.33, 0.0, 10.67)
SPINNING = Scanner(
    40_000.0, turns_per_second=10.0, window=(-np.pi, np.pi), axis="z", divergence=0.0,
    elevations=tuple(np.radians(ELEVATIONS_DEG)), range_sigma=0.02, angle_sigma=0.0,
)  # fmt: skip
DOME = Scene.of([Sphere("dome", np.zeros(3), 20.0)])
WALL = Scene.of([upright_rectangle("wall", (0.0, 4.0), -50.0, 50.0, 200.0, 90)])
TIMES = np.arange(0.0, 5.0, 0.05)
STATIONARY_STATES = (TIMES, np.zeros((len(TIMES), 3)), np.zeros((len(TIMES), 3)))
IDENTITY_MOUNTING = Mounting(np.zeros(3), np.zeros(3))


def scanned(
    scanner: Scanner, scene: Scene, *, starboard: bool = False, noise: bool = False
) -> Echoes:
    generator = np.random.default_rng(3) if noise else None
    return scan_scene(
        scanner, scene, STATIONARY_STATES, (1.0, 3.0), starboard, IDENTITY_MOUNTING, generator
    )


def test_beams_keep_their_elevations_over_full_turns() -> None:
    echoes = scanned(SPINNING, DOME)
    assert len(echoes.time) == 2 * 40_000
    x, y, z = (echoes.points_lidar / 20.0).T
    elevation = np.degrees(np.arcsin(z)).reshape(-1, len(ELEVATIONS_DEG))
    np.testing.assert_allclose(elevation, np.tile(ELEVATIONS_DEG, (len(elevation), 1)), atol=1e-9)
    azimuth = np.degrees(np.unwrap(np.arctan2(y, x)))
    np.testing.assert_allclose(np.diff(azimuth), 360 * 10 / 40_000, atol=1e-9)
    assert azimuth[-1] - azimuth[0] == pytest.approx(20 * 360, abs=0.1)
    np.testing.assert_allclose(np.diff(echoes.time), 1 / 40_000, atol=1e-9)


def test_beams_rotate_about_the_longitudinal_axis() -> None:
    echoes = scanned(replace(SPINNING, axis="x"), DOME)
    forward = np.degrees(np.arcsin(echoes.points_lidar[:, 0] / 20.0)).reshape(-1, 4)
    np.testing.assert_allclose(forward, np.tile(ELEVATIONS_DEG, (len(forward), 1)), atol=1e-9)


@pytest.mark.parametrize("axis", ["x", "z"])
def test_angle_noise_acts_along_and_across_the_rotation(axis) -> None:
    """The recorded beam keeps its elevation; the true beam deviates by sigma both ways."""
    sigma = np.radians(0.05)
    scanner = replace(SPINNING, axis=axis, elevations=(0.0,), range_sigma=0.0, angle_sigma=sigma)
    echoes = scanned(scanner, DOME, noise=True)
    about = {"x": 0, "z": 2}[axis]
    assert np.all(echoes.points_lidar[:, about] == 0)
    read, true_beams = echoes.points_lidar / 20.0, echoes.true_points_local / 20.0
    along = np.cross(np.eye(3)[about], read)
    misses = np.stack([np.sum((true_beams - read) * along, axis=1), true_beams[:, about]])
    # 80,000 beams determine sigma to 0.25 %
    np.testing.assert_allclose(misses.std(axis=1), sigma, rtol=0.01)
    assert abs(np.corrcoef(misses)[0, 1]) < 0.015


@pytest.mark.parametrize("axis", ["x", "z"])
def test_scanning_to_starboard_mirrors_scanning_to_port(axis) -> None:
    low, high = np.radians([20.0, 60.0])
    scanner = replace(SPINNING, axis=axis, window=(low, high), elevations=(0.0,))
    port = scanned(scanner, DOME).points_lidar
    starboard = scanned(scanner, DOME, starboard=True).points_lidar
    up = 2 if axis == "x" else 0
    assert (port[:, 1] > 0).all()
    assert (starboard[:, 1] < 0).all()
    for points in (port, starboard):
        angle = np.degrees(np.arctan2(points[:, up], np.abs(points[:, 1])))
        inside = (20, 60) if axis == "x" else (30, 70)
        assert angle.min() == pytest.approx(inside[0], abs=0.1)
        assert angle.max() == pytest.approx(inside[1], abs=0.1)


def test_range_noise_grows_with_incidence() -> None:
    scanner = Scanner(
        200_000.0, 20.0, window=(0.0, np.radians(75)), angle_sigma=0.0, divergence=0.0,
        range_sigma=0.01, incidence_growth=1.0,
    )  # fmt: skip
    echoes = scanned(scanner, WALL, noise=True)
    exact = scanned(scanner, WALL)
    error = np.linalg.norm(echoes.points_lidar, axis=1) - np.linalg.norm(exact.points_lidar, axis=1)
    incidence = np.arctan2(exact.points_lidar[:, 2], exact.points_lidar[:, 1])
    for low in range(0, 75, 15):
        own = (np.degrees(incidence) >= low) & (np.degrees(incidence) < low + 15)
        expected = np.sqrt(np.mean((0.01 / np.cos(incidence[own])) ** 2))
        # 16,000 points determine a standard deviation to 0.6 %; the tolerance is 4 sigma
        assert error[own].std() == pytest.approx(expected, rel=0.025)


def test_intensity_decreases_with_incidence_and_grazing_beams_have_no_echo() -> None:
    scanner = Scanner(200_000.0, 20.0, window=(0.0, np.radians(85)), divergence=0.0)
    every = scanned(scanner, WALL)
    incidence = np.arctan2(every.points_lidar[:, 2], every.points_lidar[:, 1])
    np.testing.assert_allclose(every.intensity, 60000 * 0.4 * np.cos(incidence), atol=1.0)
    kept = scanned(replace(scanner, grazing=np.radians(70.0)), WALL)
    assert np.degrees(incidence).max() > 84
    assert len(kept.time) == np.count_nonzero(incidence <= np.radians(70.0))
    steepest = np.arctan2(kept.points_lidar[:, 2], kept.points_lidar[:, 1]).max()
    assert 69.9 < np.degrees(steepest) <= 70.0


def test_nothing_is_recorded_beyond_the_maximum_range() -> None:
    scanner = Scanner(50_000.0, 20.0, window=(0.0, 1.2), divergence=0.0)
    near = replace(scanner, min_range=5.0, max_range=6.0)
    ranges = np.linalg.norm(scanned(near, WALL).points_lidar, axis=1)
    step = 0.02  # from one beam to the next on the wall, along the beam
    assert 5.0 < ranges.min() < 5.0 + step
    assert 6.0 - step < ranges.max() < 6.0
    assert len(ranges) < len(scanned(scanner, WALL).time)


def test_beams_are_smeared_at_edges_only() -> None:
    scene = Scene.of([upright_rectangle("board", (0.0, 3.7), -1.0, 1.0, 4.0, 90), *WALL.surfaces])
    echoes = scanned(
        Scanner(50_000.0, 20.0, window=(-0.5, 0.5), divergence=0.01), scene, noise=True
    )
    mixed = echoes.label < 0
    assert mixed.any()
    height = echoes.true_points_local[mixed, 2] * 3.7 / echoes.true_points_local[mixed, 1]
    assert np.abs(np.abs(height) - 1.0).max() < 0.01 * 4.2
    west = echoes.points_lidar[mixed, 1]
    assert west.min() > 3.6
    assert west.max() < 4.1
