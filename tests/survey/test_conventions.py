"""Tests of all conventions against georeferencing with the formula of each program.

The formulas below are written from each program's definition, in its own frames, and use nothing
of the converters: matrices typed out, or turns made one after the other on vectors.
"""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from lispac.survey.conventions.conversion import (
    ConventionSetup,
    convert_to_system,
    rotation_of_angles,
)
from lispac.survey.conventions.correction import correct_boresight
from lispac.survey.conventions.systems import SYSTEMS, convention_of_key
from lispac.survey.georeferencing import Mounting, place_points
from lispac.survey.trajectory import Poses

WITH_ANGLES = [each for each in SYSTEMS if each.has_angles]
LEVER_ARM = np.array([-0.185596, 0.037658, 2.419063])
cos, sin = np.cos, np.sin

Formula = Callable[[np.ndarray, np.ndarray, np.ndarray, np.ndarray], np.ndarray]
"""Maps raw points, typed angles (radians), a typed lever arm and the attitude of this program
(roll, pitch, heading of every point) to points relative to the POS in North, West, Up."""


def survey(count: int = 400, seed: int = 3) -> tuple[np.ndarray, Poses]:
    rng = np.random.default_rng(seed)
    attitude = rng.uniform((-0.3, -0.2, -3.1), (0.3, 0.2, 3.1), (count, 3))
    return rng.uniform(-100, 100, (count, 3)), Poses(rng.uniform(-50, 50, (count, 3)), attitude)


def each_point(formula: Callable[..., np.ndarray]) -> Formula:
    def run(points, angles, lever_arm, attitude):
        rows = zip(points, attitude, strict=True)
        return np.array([formula(x, angles, lever_arm, *a) for x, a in rows])

    return run


def down_frame(roll: float, pitch: float, heading: float) -> np.ndarray:
    """The matrix of textbooks on NED: roll starboard down, pitch bow up, heading clockwise."""
    return np.array(
        [
            [
                cos(heading) * cos(pitch),
                cos(heading) * sin(pitch) * sin(roll) - sin(heading) * cos(roll),
                cos(heading) * sin(pitch) * cos(roll) + sin(heading) * sin(roll),
            ],
            [
                sin(heading) * cos(pitch),
                sin(heading) * sin(pitch) * sin(roll) + cos(heading) * cos(roll),
                sin(heading) * sin(pitch) * cos(roll) - cos(heading) * sin(roll),
            ],
            [-sin(pitch), cos(pitch) * sin(roll), cos(pitch) * cos(roll)],
        ]
    )


def north_west_up(ned: np.ndarray) -> np.ndarray:
    return np.array([ned[0], -ned[1], -ned[2]])


def from_east_north_up(enu: np.ndarray) -> np.ndarray:
    return np.array([enu[1], -enu[0], enu[2]])


def about(axis: str, angle: float, v: np.ndarray) -> np.ndarray:
    """Right-handed turn of a vector about a fixed axis."""
    x, y, z = v
    c, s = cos(angle), sin(angle)
    return np.array(
        {
            "x": (x, c * y - s * z, s * y + c * z),
            "y": (c * x + s * z, y, -s * x + c * z),
            "z": (c * x - s * y, s * x + c * y, z),
        }[axis]
    )


def lispac(x, angles, lever_arm, roll, pitch, heading):
    """Thesis 4.3, one rotation after the other."""
    for r, p, h, shift in ((*angles, lever_arm), (roll, pitch, heading, np.zeros(3))):
        x = about("z", -h, about("y", p, about("x", r, x))) + shift
    return x


def applanix(x, angles, lever_arm, roll, pitch, heading):
    """NED: scanner, reference and local frame all forward/north, starboard/east, down."""
    x = np.array([x[0], -x[1], -x[2]])
    body = down_frame(*angles) @ x + lever_arm
    return north_west_up(down_frame(roll, -pitch, heading) @ body)


def starboard_forward_up(x, angles, lever_arm, roll, pitch, heading):
    """ENU with scanner and body starboard, forward, up: roll about Y, pitch about X.

    First rolled, then pitched, then turned clockwise.
    """
    x = np.array([-x[1], x[0], x[2]])
    own = (roll, -pitch, heading)
    for (r, p, h), shift in ((angles, lever_arm), (own, np.zeros(3))):
        x = about("z", -h, about("x", p, about("y", r, x))) + shift
    return from_east_north_up(x)


def novatel(x, angles, lever_arm, roll, pitch, heading):
    """The vehicle axes are rotated to the sensor axes: intrinsic Z, X, Y.

    Written with moving axes: each next turn is about an axis the former ones have moved.
    """
    x_turn, y_turn, z_turn = angles
    axes = np.eye(3)  # rows: sensor axes in the vehicle frame
    for which, angle in ((2, z_turn), (0, x_turn), (1, y_turn)):
        k = axes[which].copy()
        axes = np.array(
            [
                cos(angle) * a + sin(angle) * np.cross(k, a) + (1 - cos(angle)) * (k @ a) * k
                for a in axes
            ]
        )
    sensor = np.array([-x[1], x[0], x[2]])
    vehicle = sensor @ axes + lever_arm
    # INSPVA: azimuth clockwise, pitch about X and roll about Y, both right-handed.
    return from_east_north_up(about("z", -heading, about("x", -pitch, about("y", roll, vehicle))))


def opals(x, angles, lever_arm, roll, pitch, yaw):
    """Body forward, starboard, down; the mounting rotates the raw axes, then the misalignment."""
    mounting = np.array([[1, 0, 0], [0, -1, 0], [0, 0, -1]])
    body = down_frame(*angles) @ (mounting @ x) + lever_arm
    return north_west_up(down_frame(roll, -pitch, yaw) @ body)


def phoenix(x, angles, lever_arm, roll, pitch, heading):
    """Raw axes are kept; IMU starboard, forward, up here; turns about fixed X, then Y, then Z."""
    for axis, angle in zip("xyz", angles, strict=True):
        x = about(axis, angle, x)
    imu = x + lever_arm
    body = np.array([imu[1], imu[0], -imu[2]])  # forward, starboard, down
    return north_west_up(down_frame(roll, -pitch, heading) @ body)


def phoenix_old(x, angles, lever_arm, roll, pitch, heading):
    """Raw axes are kept; vehicle frame right, up, rear."""
    for axis, angle in zip("xyz", angles, strict=True):
        x = about(axis, angle, x)
    right, up, rear = x + lever_arm
    return north_west_up(down_frame(roll, -pitch, heading) @ np.array([-rear, right, -up]))


def hypack(x, angles, lever_arm, roll, pitch, heading):
    """Offsets starboard, forward, down; the angles have the documented directions, in NED."""
    turned = down_frame(*angles) @ np.array([x[0], -x[1], -x[2]])
    body = turned + np.array([lever_arm[1], lever_arm[0], lever_arm[2]])
    return north_west_up(down_frame(roll, -pitch, heading) @ body)


FORMULAS: dict[str, Formula] = {
    "lispac": each_point(lispac),
    "applanix": each_point(applanix),
    "kluster": each_point(applanix),
    "stripalign": each_point(applanix),
    "qinsy": each_point(starboard_forward_up),
    "terrascan": each_point(starboard_forward_up),
    "novatel": each_point(novatel),
    "opals": each_point(opals),
    "phoenix": each_point(phoenix),
    "phoenix-1-5": each_point(phoenix_old),
    "caris": each_point(hypack),
    "hypack": each_point(hypack),
}
IMU_AXES = {"phoenix": ("starboard", "forward", "up")}


def setup_of(key: str) -> ConventionSetup:
    return ConventionSetup(convention_of_key(key), IMU_AXES.get(key))


@pytest.mark.parametrize("key", [each.key for each in WITH_ANGLES])
@pytest.mark.parametrize("boresight_deg", [(0.4395, -1.8681, 0.3992), (12.0, 7.0, -15.0)])
def test_points_agree_with_the_formula_of_each_program(key: str, boresight_deg) -> None:
    points, poses = survey()
    mounting = Mounting(LEVER_ARM, np.radians(boresight_deg))
    converted = convert_to_system(mounting, setup_of(key))
    theirs = FORMULAS[key](points, converted.angles, converted.lever_arm, poses.attitude)
    ours = place_points(points, poses, mounting) - poses.position
    assert np.abs(theirs - ours).max() < 1e-9


@pytest.mark.parametrize("key", [each.key for each in SYSTEMS])
def test_points_agree_with_the_4x4_matrix(key: str) -> None:
    """The scan2imu matrix of PDAL and the matrices of all other systems."""
    points, poses = survey()
    mounting = Mounting(LEVER_ARM, np.radians([0.4, -1.9, 0.4]))
    setup = setup_of(key)
    transform = convert_to_system(mounting, setup).transform
    points_scanner = points
    if setup.scanner_frame == "turned":
        points_scanner = points @ setup.permutation.T
    theirs = np.c_[points_scanner, np.ones(len(points))] @ transform.T
    body_ned = {
        ("forward", "starboard", "down"): ((0, 1), (1, 1), (2, 1)),
        ("forward", "port", "up"): ((0, 1), (1, -1), (2, -1)),
        ("starboard", "forward", "up"): ((1, 1), (0, 1), (2, -1)),
        ("starboard", "up", "aft"): ((2, -1), (0, 1), (1, -1)),
        ("starboard", "forward", "down"): ((1, 1), (0, 1), (2, 1)),
    }[setup.axes]
    for x, attitude, ours in zip(
        theirs, poses.attitude, place_points(points, poses, mounting) - poses.position, strict=True
    ):
        body = np.array([sign * x[k] for k, sign in body_ned])
        roll, pitch, heading = attitude
        local = north_west_up(down_frame(roll, -pitch, heading) @ body)
        assert np.abs(local - ours).max() < 1e-9


def test_real_vessel_data_by_the_applanix_formula(shared_data: Path) -> None:
    """The converted angles give the coordinates stored by another program, in NED."""
    mounting = Mounting(LEVER_ARM, np.radians([0.4395, -1.8681, 0.3992]))
    converted = convert_to_system(mounting, ConventionSetup(convention_of_key("applanix")))
    np.testing.assert_allclose(np.degrees(converted.angles), [0.4395, 1.8681, 0.3992], atol=1e-12)
    files = sorted((shared_data / "cidco").glob("*/*/*"))
    assert len(files) == 16
    for path in files:
        rows = np.fromfile(path, dtype="<f8").reshape(-1, 22)[:300]
        local = (
            FORMULAS["applanix"](
                rows[:, 4:7], converted.angles, converted.lever_arm, rows[:, 10:13]
            )
            + rows[:, 16:19]
        )
        assert np.abs(local - rows[:, :3]).max() < 1e-9, path.name


# -- examples from manuals -------------------------------------------------------------------------


def test_applanix_example_of_the_manual() -> None:
    """An IMU rotated by 93 deg, 2 deg about its y and -5 deg about its x axis (POS MV guide)."""
    turned = rotation_of_angles(convention_of_key("applanix"), np.radians([-5.0, 2.0, 93.0]))
    x_axis, y_axis = turned[:, 0], turned[:, 1]
    assert x_axis[1] > 0.99, "x points to starboard"
    assert x_axis[2] == pytest.approx(-sin(np.radians(2.0)), abs=1e-12), "and 2 deg up"
    assert y_axis[2] < 0, "its own starboard side is the higher one"


def test_novatel_example_of_the_application_note() -> None:
    """Y backwards, X to the right, Z down: X = 0, Y = 180, Z = 180 (APN-065, example 1).

    The same triple as an end-for-end turn: X 180, Y 0, Z 0.
    """
    axes = rotation_of_angles(convention_of_key("novatel"), np.radians([0.0, 180.0, 180.0]))
    np.testing.assert_allclose(axes, np.diag([1.0, -1.0, -1.0]), atol=1e-15)


def test_phoenix_turns_about_fixed_axes() -> None:
    angles = np.radians([30.0, 40.0, 50.0])
    moved = np.array([0.3, -0.2, 0.9])
    for axis, angle in zip("xyz", angles, strict=True):
        moved = about(axis, angle, moved)
    np.testing.assert_allclose(
        rotation_of_angles(convention_of_key("phoenix"), angles) @ [0.3, -0.2, 0.9],
        moved,
        atol=1e-15,
    )


@pytest.mark.parametrize("key", ["applanix", "kluster", "qinsy", "caris", "terrascan", "hypack"])
def test_small_angles_differ_in_the_sign_of_the_pitch_only(key: str) -> None:
    converted = convert_to_system(
        Mounting(np.zeros(3), np.radians([0.1, 0.0, 0.0])), ConventionSetup(convention_of_key(key))
    )
    np.testing.assert_allclose(np.degrees(converted.angles), [0.1, 0, 0], atol=1e-12)
    converted = convert_to_system(
        Mounting(np.zeros(3), np.radians([0.0, 0.1, 0.0])), ConventionSetup(convention_of_key(key))
    )
    np.testing.assert_allclose(np.degrees(converted.angles), [0, -0.1, 0], atol=1e-12)


@pytest.mark.parametrize("key", [each.key for each in WITH_ANGLES])
def test_the_new_rotation_is_correction_times_current(key: str) -> None:
    """The rotation of the correction times the current rotation is the new rotation."""
    setup = setup_of(key)
    mounting = Mounting(LEVER_ARM, np.radians([0.4, -1.9, 0.4]))
    converted = convert_to_system(mounting, setup)
    current = np.radians([2.0, -3.0, 5.0])
    found = correct_boresight(setup.convention, current, converted.rotation)
    product = rotation_of_angles(setup.convention, found.correction) @ rotation_of_angles(
        setup.convention, found.current
    )
    np.testing.assert_allclose(product, converted.rotation, rtol=0, atol=1e-12)
    np.testing.assert_allclose(
        found.rotation @ rotation_of_angles(setup.convention, current), product, atol=1e-12
    )
    points, poses = survey(100)
    theirs = FORMULAS[key](points, found.new, converted.lever_arm, poses.attitude)
    assert np.abs(theirs - place_points(points, poses, mounting) + poses.position).max() < 1e-9
