"""Tests of signed distances along the normal and of plane offsets with their intervals."""

from itertools import product

import numpy as np
import pytest
from numpy.typing import NDArray

from lispac.errors import InputError, NotComparable
from lispac.geometry.rotations import rotation_matrix
from lispac.validation.normal_distance import (
    MIN_CYLINDER_POINTS,
    NormalDistances,
    distances_along_normal,
)
from lispac.validation.plane_offset import PlaneOffset, plane_offset
from lispac.value_conversion import decode_value, encode_value
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG

Array = NDArray[np.float64]

EAST = np.array([0.0, -1.0, 0.0])
OFFSETS_M = [0.0, 0.002, 0.005, 0.020]
TURNS_DEG = [0.0, 0.01, 0.1]


def wall(
    rng: np.random.Generator, n: int, *, noise: float = 0.003, offset: float = 0.0,
    tilt: float = 0.0, turn: float = 0.0,
) -> Array:  # fmt: skip
    """Return points of a wall 15 m to the west, 2 m long and 3 m high, moved and turned.

    The wall is moved east by ``offset``. ``tilt`` turns it about the horizontal axis, top to the
    east, and ``turn`` about the vertical axis, north end to the east; both in radians.
    """
    along, height = rng.uniform(-1.0, 1.0, n), rng.uniform(-1.5, 1.5, n)
    off = rng.normal(offset, noise, n) + np.tan(tilt) * height + np.tan(turn) * along
    return np.column_stack((along, 15.0 - off, height + 4.0))


def distances_to_reference(
    compared: Array, reference: Array, cores: Array, **how: float
) -> NormalDistances:
    scales = {"normal_scale": 1.0, "diameter": 0.4, "depth": 0.3} | how
    return distances_along_normal(compared, reference, cores, facing=EAST, **scales)


@pytest.mark.parametrize("offset", OFFSETS_M)
def test_a_known_offset_is_recovered_with_its_sign(offset: float) -> None:
    rng = np.random.default_rng(1)
    found = distances_to_reference(
        wall(rng, 3000, offset=offset), (ref := wall(rng, 3000)), ref[::30]
    )
    # The 100 places have few points in common.
    assert found.distance.mean() == pytest.approx(offset, abs=0.0004)
    assert np.median(found.half_width) == pytest.approx(1.97 * 0.003 * np.sqrt(2 / 63), rel=0.1)
    back = distances_to_reference(ref, wall(rng, 3000, offset=offset), ref[::30])
    assert back.distance.mean() == pytest.approx(-offset, abs=0.0004)


@pytest.mark.parametrize(("n", "noise"), [(3000, (0.003, 0.003)), (400, (0.002, 0.008))])
def test_intervals_have_the_stated_coverage(n: int, noise: tuple[float, float]) -> None:
    """Coverage at one place in 1,000 pairs of clouds, with 60 and 8 points in a cylinder.

    The coverage must be 93 to 97 %; 1,000 draws at 95 % leave this range once in 270 times.
    """
    rng, is_covered = np.random.default_rng(7), []
    core = np.array([[0.0, 15.0, 4.0]])
    for k in range(1000):
        offset = OFFSETS_M[k % len(OFFSETS_M)]
        moved, still = wall(rng, n, noise=noise[0], offset=offset), wall(rng, n, noise=noise[1])
        try:
            found = distances_to_reference(moved, still, core)
        except NotComparable:
            assert n == 400  # fewer than four points in the cylinder: no distance
            continue
        is_covered.append(abs(found.distance[0] - offset) <= found.half_width[0])
    assert len(is_covered) > 900
    assert 0.93 <= np.mean(is_covered) <= 0.97


def test_the_distance_is_along_the_normal_of_an_oblique_surface() -> None:
    rng = np.random.default_rng(3)
    turned = rotation_matrix(*np.radians([20.0, -30.0, 40.0]))
    ref, moved = wall(rng, 3000) @ turned.T, wall(rng, 3000, offset=0.02) @ turned.T
    found = distances_along_normal(
        moved,
        ref,
        ref[::50],
        facing=turned @ EAST,
        normal_scale=1.0,
        diameter=0.4,
        depth=0.3,
    )
    assert found.distance.mean() == pytest.approx(0.02, abs=0.0005)


def test_places_without_points_have_no_distance_and_are_counted() -> None:
    rng = np.random.default_rng(4)
    ref, half = wall(rng, 3000), wall(rng, 3000)
    half = half[half[:, 0] < 0.0]
    found = distances_to_reference(half, ref, ref[::20])
    beyond = np.count_nonzero(ref[::20, 0] > 0.25)
    assert found.no_distance >= beyond
    assert len(found.distance) == len(ref[::20]) - found.no_distance
    with pytest.raises(
        NotComparable, check=has_code("validation.cylinder_too_narrow", needed=MIN_CYLINDER_POINTS)
    ):
        distances_to_reference(half + [0.0, 5.0, 0.0], ref, ref[::20])


def test_differences_of_points_without_noise_are_significant() -> None:
    rng = np.random.default_rng(5)
    found = distances_to_reference(
        wall(rng, 500, noise=0.0, offset=0.01), (ref := wall(rng, 500, noise=0.0)), ref
    )
    np.testing.assert_allclose(found.distance, 0.01, atol=1e-9)
    assert found.significant == 1.0


@pytest.mark.parametrize(
    ("name", "code"),
    [
        ("normal_scale", "validation.normal_scale"),
        ("diameter", "validation.cylinder_diameter"),
        ("depth", "validation.cylinder_depth"),
    ],
)
def test_a_size_of_zero_is_refused(name: str, code: str) -> None:
    cloud = wall(np.random.default_rng(0), 50)
    with pytest.raises(InputError, check=has_code(code, value=0.0)):
        distances_to_reference(cloud, cloud, cloud, **{name: 0.0})


@LONG
def test_intervals_of_plane_offsets_and_turns_have_the_stated_coverage() -> None:
    """The coverage of the three intervals is 93 to 97 % in 600 pairs of clouds."""
    rng, is_covered = np.random.default_rng(11), []
    for offset, turn_deg in list(product(OFFSETS_M, TURNS_DEG)) * 50:
        angle = np.radians(turn_deg)
        moved = wall(rng, 500, offset=offset, tilt=angle, turn=-angle)
        found = plane_offset(moved, wall(rng, 700, noise=0.005), EAST)
        is_covered.append([
            abs(found.offset - offset) <= found.offset_95,
            abs(found.rotation_horizontal_axis - angle) <= found.rotation_horizontal_axis_95,
            abs(found.rotation_slope_axis + angle) <= found.rotation_slope_axis_95,
        ])  # fmt: skip
    assert np.all(np.abs(np.mean(is_covered, axis=0) - 0.95) <= 0.02)


def test_the_angle_is_that_between_the_normals() -> None:
    rng = np.random.default_rng(2)
    tilt = np.radians(0.1)
    moved = wall(rng, 4000, noise=0.0, tilt=tilt, turn=tilt)
    found = plane_offset(moved, wall(rng, 4000, noise=0.0), EAST)
    assert found.angle == pytest.approx(np.arctan(np.hypot(np.tan(tilt), np.tan(tilt))), rel=1e-6)
    assert found.outliers == 0


def test_outliers_are_rejected_and_counted() -> None:
    rng = np.random.default_rng(8)
    moved = wall(rng, 2000, offset=0.005)
    moved[:60, 1] -= 0.08
    found = plane_offset(moved, wall(rng, 2000), EAST)
    assert found.outliers >= 60
    assert found.outliers < 75
    assert abs(found.offset - 0.005) < 2 * found.offset_95


def test_a_large_offset_does_not_change_the_turn() -> None:
    rng = np.random.default_rng(9)
    moved = wall(rng, 2000, offset=0.8, tilt=np.radians(0.5)) + [0.7, 0.0, 0.6]
    found = plane_offset(moved, wall(rng, 2000), EAST)
    assert np.degrees(found.rotation_horizontal_axis) == pytest.approx(0.5, abs=0.01)


def test_too_few_or_collinear_points_are_refused() -> None:
    cloud = wall(np.random.default_rng(0), 50)
    with pytest.raises(NotComparable, check=has_code("validation.plane_few_points")):
        plane_offset(cloud[:3], cloud, EAST)
    row = np.column_stack((np.zeros(20), np.full(20, 15.0), np.linspace(0, 1, 20)))
    with pytest.raises(NotComparable, check=has_code("validation.points_in_row")):
        plane_offset(row, cloud, EAST)


def test_plane_offset_round_trip_through_json() -> None:
    rng = np.random.default_rng(1)
    found = plane_offset(wall(rng, 100), wall(rng, 100), EAST)
    assert decode_value(encode_value(found), PlaneOffset) == found
