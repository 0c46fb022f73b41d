"""Tests of the simulator against the georeferencing equation, for each error of the mounting.

The ray caster computes the beams, `georeference` the positions of their points, and the closed form
their ranges. The three share no code.
"""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from lispac.geometry.frames import LocalFrame
from lispac.simulation.closed_form_ranges import range_to_plane, range_to_sphere
from lispac.simulation.scanner import Echoes, Scanner, scan_scene
from lispac.simulation.scene import (
    Cylinder,
    Rectangle,
    Scene,
    Sphere,
    tilted_rectangle,
    upright_rectangle,
)
from lispac.survey.georeferencing import MOUNTING_VALUE_NAMES, Mounting, georeference
from lispac.survey.trajectory import LocalTrajectory

LARGEST_ERRORS = np.array([*np.radians([3, 3, 3]), 1.0, 1.0, 1.0, 0.2, np.radians(2.0), 0.3])
"""Of each value of a mounting, in the order of `MOUNTING_VALUE_NAMES`."""
NOMINAL_VALUES = np.array([0, 0, 0, -0.24, 0.06, 2.17, 0, 0, 0])
SCENE = Scene.of(
    [
        upright_rectangle("wall", (0.0, 15.0), 0.0, 14.0, 30.0, 90),
        tilted_rectangle("board", (0.5, 13.5, 5.0), 1.0, 1.0, 90, 45),
        Sphere("ball", np.array([-1.5, 12.5, 4.0]), 0.5),
        Cylinder("mast", 2.5, 12.0, -3.0, 9.0, 0.5),
    ]
)
TIMES = np.arange(0.0, 12.0, 0.05)
STATES = (
    TIMES,
    np.stack([0.8 * (TIMES - 6), 0.03 * np.sin(TIMES), 0.05 * np.cos(1.3 * TIMES)], axis=1),
    np.radians(
        np.stack([0.9 * np.sin(0.9 * TIMES), 0.4 * np.cos(TIMES), 2 + 0.3 * np.sin(TIMES)], axis=1)
    ),
)
TRAJECTORY = LocalTrajectory(LocalFrame(0.8, -1.2, 30.0), *STATES)
PROFILER = Scanner(8_000.0, turns_per_second=20.0, divergence=0.0)
SPINNING = Scanner(
    60_000.0, turns_per_second=10.0, window=(0.0, np.pi), axis="z", divergence=0.0,
    elevations=tuple(np.radians(np.arange(-20.0, 21.0, 2.0))),
)  # fmt: skip


def scanned(mounting: Mounting, scanner: Scanner = PROFILER) -> Echoes:
    return scan_scene(scanner, SCENE, STATES, (1.0, 11.0), False, mounting, None)


def farthest_off(echoes: Echoes, mounting: Mounting) -> float:
    points = georeference(echoes.points_lidar, echoes.time, TRAJECTORY, mounting)
    assert set(np.unique(echoes.label)) == {0, 1, 2, 3}
    return max(
        float(np.abs(SCENE.surfaces[label].distance(points[echoes.label == label])).max())
        for label in np.unique(echoes.label)
    )


@pytest.mark.parametrize("scanner", [PROFILER, SPINNING], ids=["profiler", "spinning"])
@pytest.mark.parametrize("value", MOUNTING_VALUE_NAMES)
def test_each_error_alone_is_corrected_by_the_true_mounting(value: str, scanner: Scanner) -> None:
    k = MOUNTING_VALUE_NAMES.index(value)
    for sign in (-1.0, 1.0):
        values = NOMINAL_VALUES.copy()
        values[k] += sign * LARGEST_ERRORS[k]
        mounting = Mounting.of_values(values)
        echoes = scanned(mounting, scanner)
        assert len(echoes.time) > 1000
        assert farthest_off(echoes, mounting) < 1e-9
        assert farthest_off(echoes, Mounting.of_values(NOMINAL_VALUES)) > 1e-3, (
            "the error does nothing"
        )


@settings(max_examples=25, deadline=None)
@given(st.lists(st.floats(-1, 1), min_size=9, max_size=9))
def test_all_errors_together_are_corrected_by_the_true_mounting(shares: list[float]) -> None:
    mounting = Mounting.of_values(NOMINAL_VALUES + LARGEST_ERRORS * shares)
    assert farthest_off(scanned(mounting), mounting) < 1e-9


def read_ranges(echoes: Echoes) -> tuple[np.ndarray, np.ndarray]:
    ranges = np.linalg.norm(echoes.points_lidar, axis=1)
    return ranges, echoes.points_lidar / ranges[:, None]


@pytest.mark.parametrize("scanner", [PROFILER, SPINNING], ids=["profiler", "spinning"])
def test_ray_casting_and_closed_form_agree(scanner: Scanner) -> None:
    """They differ by rounding of float64, 1e-14 m, far below the required 1e-6 m."""
    mounting = Mounting.of_values(
        NOMINAL_VALUES + LARGEST_ERRORS * [1, -1, 0.7, 0.5, -1, 0.2, 1, -1, 1]
    )
    echoes = scanned(mounting, scanner)
    ranges, beams = read_ranges(echoes)
    poses = TRAJECTORY.at(echoes.time + mounting.latency)
    formula = np.full(len(ranges), np.nan)
    for label, surface in enumerate(SCENE.surfaces):
        if isinstance(surface, Rectangle):
            plane = np.array([*surface.normal, -surface.normal @ surface.centre])
            of_surface = range_to_plane(plane, beams, poses, mounting)
        elif isinstance(surface, Sphere):
            of_surface = range_to_sphere(surface.centre, surface.radius, beams, poses, mounting)
        else:
            continue
        own = echoes.label == label
        assert np.count_nonzero(own) > 20
        formula[own] = of_surface[own]
    known = np.isfinite(formula)
    assert known.mean() > 0.5
    assert np.abs(ranges[known] - formula[known]).max() < 1e-11


def test_closed_form_of_beams_without_an_echo() -> None:
    beams = np.array([[0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]])
    poses = replace(TRAJECTORY.at(np.full(3, 6.0)), position=np.zeros((3, 3)),
                    attitude=np.zeros((3, 3)))  # fmt: skip
    mounting = Mounting(np.zeros(3), np.zeros(3), range_offset=0.25)
    wall = np.array([0.0, 1.0, 0.0, -8.0])
    np.testing.assert_array_equal(
        range_to_plane(wall, beams, poses, mounting), [7.75, np.inf, np.inf]
    )
    ball = range_to_sphere(np.array([0.0, 8.0, 0.0]), 1.0, beams, poses, mounting)
    np.testing.assert_array_equal(ball, [6.75, np.inf, np.inf])
    inside = range_to_sphere(np.zeros(3), 2.0, beams, poses, mounting)
    np.testing.assert_array_equal(inside, [1.75] * 3)


def test_signs_of_offsets() -> None:
    """Range offsets are added to readings and latencies to times."""
    still = (TIMES, np.zeros((len(TIMES), 3)), np.zeros((len(TIMES), 3)))
    plain, long = (
        scan_scene(PROFILER, SCENE, still, (1.0, 3.0), False, mounting, None)
        for mounting in (Mounting(np.zeros(3), np.zeros(3), offset) for offset in (0.0, 0.1))
    )
    np.testing.assert_allclose(read_ranges(plain)[0] - read_ranges(long)[0], 0.1, atol=1e-12)
    late = scanned(Mounting.of_values(NOMINAL_VALUES + [0, 0, 0, 0, 0, 0, 0, 0, 0.25]))
    shifted = (STATES[0] - 0.25, *STATES[1:])
    early = scan_scene(
        PROFILER, SCENE, shifted, (1.0, 11.0), False, Mounting.of_values(NOMINAL_VALUES), None
    )  # fmt: skip
    np.testing.assert_allclose(late.time, early.time, atol=1e-12)
    np.testing.assert_allclose(late.points_lidar, early.points_lidar, atol=1e-9)
