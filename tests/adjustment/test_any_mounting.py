"""Tests that the estimated rotation does not depend on the direction of mounting."""

import json
from dataclasses import replace
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.condition_equations import linearise
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import AdjustmentResult
from lispac.geometry.rotations import rotation_angles, rotation_matrix
from lispac.survey.georeferencing import RIGHT_ANGLE_ROTATIONS, Mounting
from lispac.value_conversion import decode_value, encode_value
from tests.support.long_runs import others_long
from tests.support.surveys import TARGETS, planar_survey

LEVER = np.array([-0.2, 0.05, 2.0])
TRUTH = np.radians([0.3, -0.4, 0.6])
SURVEY = planar_survey(Mounting(LEVER, TRUTH), points=40, seed=3)
NOISE = np.random.default_rng(8).normal(0, 0.003, (len(SURVEY), 3))


def adjusted(turn: np.ndarray) -> AdjustmentResult:
    """Adjust the survey with its scanner points in axes rotated by ``turn``."""
    observations = replace(SURVEY, points_lidar=(SURVEY.points_lidar + NOISE) @ turn)
    prior = Mounting.with_nearest_axes(LEVER, rotation_angles(turn))
    np.testing.assert_allclose(prior.rotation_body_lidar, turn, atol=1e-12)
    return adjust(observations, prior, StochasticModel("correlated"))


@cache
def unturned() -> AdjustmentResult:
    """Adjustment with the axes of the scanner parallel to those of the vessel."""
    return adjusted(np.eye(3))


def small_rotation(one: np.ndarray, other: np.ndarray) -> np.ndarray:
    """Rotation vector from one rotation to a near one, shape (3,), radians, body axes."""
    turn = other @ one.T
    return np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / 2


def body_covariance(result: AdjustmentResult) -> np.ndarray:
    """Covariance of the small rotation about the body axes, shape (3, 3)."""
    rotation = result.mounting.rotation_body_lidar
    turns = result.mounting.rotation_derivatives @ rotation.T
    jacobian = np.stack([turns[:, 2, 1], turns[:, 0, 2], turns[:, 1, 0]])
    return jacobian @ result.covariance @ jacobian.T


def test_there_are_24_mountings_along_the_axes() -> None:
    assert len(RIGHT_ANGLE_ROTATIONS) == 24
    assert len({tuple(axes.ravel()) for axes in RIGHT_ANGLE_ROTATIONS}) == 24
    assert all(np.linalg.det(axes) == 1 for axes in RIGHT_ANGLE_ROTATIONS)


@pytest.mark.parametrize("number", others_long(range(24), lambda number: number % 4 == 0))
def test_all_mountings_along_the_axes_give_the_same_answer(number: int) -> None:
    turn = RIGHT_ANGLE_ROTATIONS[number]
    result = adjusted(turn)
    rotation = result.mounting.rotation_body_lidar
    off = small_rotation(unturned().mounting.rotation_body_lidar @ turn, rotation)
    assert np.degrees(np.abs(off)).max() < 1e-5
    assert np.degrees(np.abs(small_rotation(rotation_matrix(*TRUTH) @ turn, rotation))).max() < 0.05
    np.testing.assert_allclose(body_covariance(result), body_covariance(unturned()), rtol=1e-3)
    np.testing.assert_allclose(rotation_matrix(*result.angles), rotation, atol=1e-12)
    steep = bool(abs(turn[2, 0]) == 1)
    assert (result.mounting.axes is not None) is steep


@settings(max_examples=12, deadline=None)
@given(st.integers(0, 2**32 - 1))
def test_mountings_between_the_axes_give_the_same_answer(seed: int) -> None:
    quaternion = np.random.default_rng(seed).normal(size=4)
    w, x, y, z = quaternion / np.linalg.norm(quaternion)
    turn = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
    result = adjusted(turn)
    off = small_rotation(
        unturned().mounting.rotation_body_lidar @ turn, result.mounting.rotation_body_lidar
    )
    assert np.degrees(np.abs(off)).max() < 1e-5
    np.testing.assert_allclose(body_covariance(result), body_covariance(unturned()), rtol=2e-3)


@pytest.mark.parametrize("pitch", [-90.0, 90.0, -89.9, 88.0])
def test_jacobians_at_a_steep_pitch_agree_with_differences(pitch: float) -> None:
    mounting = Mounting.with_nearest_axes(LEVER, np.radians([20.0, pitch, -35.0]))
    assert mounting.axes is not None
    shapes = np.array([[*normal, -normal @ centre] for centre, normal in TARGETS.values()])
    rows = linearise(SURVEY, mounting, shapes).rows
    step = 1e-6
    for k in range(9):
        ends = [
            linearise(
                SURVEY, mounting.with_values(mounting.values + sign * step * np.eye(9)[k]), shapes
            ).misclosure
            for sign in (1, -1)
        ]
        if k == 8:  # the observations have no rates of the poses
            continue
        np.testing.assert_allclose(
            rows[:, k], (ends[0] - ends[1]) / (2 * step), rtol=1e-5, atol=1e-6
        )


def test_ordinary_mountings_need_no_axes() -> None:
    for angles in ([0.3, -0.4, 0.6], [90.0, 0.0, -90.0], [180.0, 0.0, 0.0], [10.0, 55.0, 200.0]):
        mounting = Mounting.with_nearest_axes(LEVER, np.radians(angles))
        assert mounting.axes is None
        np.testing.assert_array_equal(mounting.boresight, np.radians(angles))


def test_a_mounting_with_turned_axes_is_stored_in_a_project() -> None:
    mounting = Mounting.with_nearest_axes(LEVER, np.radians([5.0, -89.0, 10.0]), 0.01, 0.002, 0.0)
    again = decode_value(json.loads(json.dumps(encode_value(mounting))), Mounting)
    assert again.axes is not None
    np.testing.assert_array_equal(again.rotation_body_lidar, mounting.rotation_body_lidar)
    before = {k: v for k, v in encode_value(Mounting(LEVER, TRUTH)).items() if k != "axes"}
    assert decode_value(before, Mounting).axes is None
