"""Tests of rotation matrices, their angles and their derivatives."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from lispac.geometry.rotations import rotation_angles, rotation_derivatives, rotation_matrix

angle = st.floats(-3.1, 3.1)
tilt = st.floats(-1.5, 1.5)


@given(angle, tilt, angle)
def test_matrix_is_the_product_of_three_right_handed_rotations(
    roll: float, pitch: float, yaw: float
) -> None:
    expected = Rotation.from_euler("ZYX", [-yaw, pitch, roll]).as_matrix()
    np.testing.assert_allclose(rotation_matrix(roll, pitch, yaw), expected, atol=1e-15)


@given(angle, tilt, angle)
def test_angles_are_recovered(roll: float, pitch: float, yaw: float) -> None:
    back = rotation_angles(rotation_matrix(roll, pitch, yaw))
    np.testing.assert_allclose(back, [roll, pitch, yaw], rtol=0, atol=1e-12)


def test_signs_of_the_angles() -> None:
    forward, left, up = np.eye(3)
    turn = np.radians(1.0)
    assert (rotation_matrix(turn, 0, 0) @ left)[2] > 0, "roll lifts the left side"
    assert (rotation_matrix(0, turn, 0) @ forward)[2] < 0, "pitch lowers the bow"
    assert (rotation_matrix(0, 0, turn) @ forward)[1] < 0, "yaw turns the bow to the east"
    assert (rotation_matrix(turn, turn, 0) @ up)[2] > 0


@given(angle, tilt, angle)
def test_derivatives_match_central_differences_of_the_matrix(
    roll: float, pitch: float, yaw: float
) -> None:
    angles, step = np.array([roll, pitch, yaw]), 1e-6
    derivatives = rotation_derivatives(*angles)
    for k in range(3):
        change = np.eye(3)[k] * step
        difference = rotation_matrix(*(angles + change)) - rotation_matrix(*(angles - change))
        np.testing.assert_allclose(derivatives[k], difference / (2 * step), atol=1e-9)


def test_many_rotations_equal_single_ones() -> None:
    angles = np.random.default_rng(1).uniform(-1, 1, (7, 3))
    stacked, derivatives = rotation_matrix(*angles.T), rotation_derivatives(*angles.T)
    for k, row in enumerate(angles):
        np.testing.assert_array_equal(stacked[k], rotation_matrix(*row))
        np.testing.assert_allclose(derivatives[:, k], rotation_derivatives(*row), atol=1e-16)


@pytest.mark.parametrize("pitch", [np.pi / 2, -np.pi / 2])
def test_angles_at_the_singularity_reproduce_the_rotation(pitch: float) -> None:
    rotation = rotation_matrix(0.3, pitch, 0.2)
    np.testing.assert_allclose(rotation_matrix(*rotation_angles(rotation)), rotation, atol=1e-7)
