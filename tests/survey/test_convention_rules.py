"""Tests of conventions: round trips, corrections, sigmas, gimbal lock and refusals."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

from lispac.errors import InputError
from lispac.geometry.rotations import rotation_matrix
from lispac.survey.conventions.axes import (
    DIRECTIONS,
    FORWARD_PORT_UP,
    axes_matrix,
    complete_axes,
    nearest_axes,
)
from lispac.survey.conventions.conversion import (
    GIMBAL_LOCK_COSINE,
    ConventionSetup,
    angle_jacobian,
    angles_of_rotation,
    convert_from_system,
    convert_to_system,
    mounting_of_angles,
    require_rotation,
    rotation_of_angles,
)
from lispac.survey.conventions.correction import (
    add_to_applied_boresight,
    angle_between_rotations,
    correct_boresight,
)
from lispac.survey.conventions.systems import LISPAC_CONVENTION, SYSTEMS, convention_of_key
from lispac.survey.georeferencing import Mounting
from tests.support.error_codes import has_code

WITH_ANGLES = [each for each in SYSTEMS if each.has_angles]
LEVER_ARM = np.array([-0.185596, 0.037658, 2.419063])

# -- round trips -----------------------------------------------------------------------------------

turn = st.floats(-np.pi, np.pi)
# Beyond, another axis may be nearest, which is assumed for a scanner without given axes
small = st.floats(-0.55, 0.55)
every_system = st.sampled_from(SYSTEMS)
every_direction = st.sampled_from(["lidar_to_body", "body_to_lidar"])


@given(st.sampled_from(WITH_ANGLES), turn, turn, turn)
@settings(max_examples=300, deadline=None)
def test_angles_of_a_product_give_the_product(convention, a, b, c) -> None:
    rotation = rotation_of_angles(convention, np.array([a, b, c]))
    angles, _ = angles_of_rotation(convention, rotation)
    np.testing.assert_allclose(rotation_of_angles(convention, angles), rotation, atol=3e-8)
    assert abs(angles[convention.order[1]]) <= np.pi / 2


@pytest.mark.parametrize("convention", WITH_ANGLES, ids=lambda convention: convention.key)
def test_the_text_of_a_sign_agrees_with_the_matrix(convention) -> None:
    """A small positive angle turns the scanner as the text of the angle says."""
    angle = 0.01
    setup = ConventionSetup(convention, scanner="turned")
    for k, turn_of_angle in enumerate(convention.turns):
        mounting = mounting_of_angles(setup, angle * np.eye(3)[k], np.zeros(3))
        bow, port, _ = mounting.rotation_body_lidar.T  # forward, port and up parts
        effects = {
            "bow up": bow[2], "bow down": -bow[2], "port side up": port[2],
            "starboard side down": port[2], "counter-clockwise seen from above": bow[1],
            "positive clockwise seen from above": -bow[1],
        }  # fmt: skip
        named = [effect for words, effect in effects.items() if words in turn_of_angle.meaning]
        if turn_of_angle.meaning == "right-handed":
            axis = setup.permutation[turn_of_angle.axis]
            expected = np.eye(3) + np.sin(angle) * np.cross(axis, np.eye(3)).T
            expected += (1 - np.cos(angle)) * (np.outer(axis, axis) - np.eye(3))
            np.testing.assert_allclose(mounting.rotation_body_lidar, expected, atol=1e-12)
        else:
            assert named == pytest.approx([np.sin(angle)]), turn_of_angle.name


@example(convention_of_key("phoenix-1-5"), "lidar_to_body", 0.0, 0.0, 1e-10, False)
@given(every_system, every_direction, small, small, small, st.booleans())
@settings(max_examples=300, deadline=None)
def test_conversion_there_and_back_gives_the_same_mounting(
    convention, direction, roll, pitch, yaw, kept
) -> None:
    left_handed = convention.axes == ("starboard", "forward", "down")
    scanner = "kept" if kept and not left_handed else None
    setup = ConventionSetup(replace(convention, direction=direction), scanner=scanner)
    mounting = Mounting(LEVER_ARM, np.array([roll, pitch, yaw]))
    converted = convert_to_system(mounting, setup)
    back = convert_from_system(setup, converted.rotation, converted.lever_arm)
    np.testing.assert_allclose(back.boresight, mounting.boresight, rtol=0, atol=1e-12)
    np.testing.assert_allclose(back.lever_arm, LEVER_ARM, rtol=0, atol=1e-15)
    if converted.angles is not None:
        again = mounting_of_angles(setup, converted.angles, converted.lever_arm)
        # At the pole the third angle is redundant, which the note reports.
        exact = (
            GIMBAL_LOCK_COSINE
            if converted.note is not None and converted.note.code == "convention.gimbal_lock"
            else 1e-12
        )
        np.testing.assert_allclose(
            again.rotation_body_lidar, mounting.rotation_body_lidar, atol=exact
        )


@given(st.sampled_from(WITH_ANGLES), every_direction, small, small, small)
@settings(max_examples=100, deadline=None)
def test_jacobian_against_central_differences(convention, direction, roll, pitch, yaw) -> None:
    setup = ConventionSetup(replace(convention, direction=direction), scanner=None)
    boresight, step = np.array([roll, pitch, yaw]), 1e-6
    jacobian = angle_jacobian(setup, boresight)
    middle = abs(
        convert_to_system(Mounting(np.zeros(3), boresight), setup).angles[convention.order[1]]
    )
    if middle > 1.4:  # kept axes may be near the pole, where difference quotients are inaccurate
        return
    for k in range(3):
        change = step * np.eye(3)[k]
        ahead, behind = (
            convert_to_system(Mounting(np.zeros(3), boresight + sign * change), setup).angles
            for sign in (1, -1)
        )
        difference = (ahead - behind + np.pi) % (2 * np.pi) - np.pi
        np.testing.assert_allclose(jacobian[:, k], difference / (2 * step), atol=1e-6)


def test_sigmas_follow_a_sample_of_boresights() -> None:
    rng = np.random.default_rng(8)
    middle = np.array([0.3, -0.4, 0.9])
    root = rng.normal(0, 1e-4, (3, 3))
    covariance = root @ root.T
    setup = ConventionSetup(convention_of_key("novatel"), scanner="turned")
    sigmas = convert_to_system(Mounting(LEVER_ARM, middle), setup, covariance).sigmas
    sample = middle + rng.normal(size=(4000, 3)) @ root.T
    angles = [convert_to_system(Mounting(LEVER_ARM, each), setup).angles for each in sample]
    np.testing.assert_allclose(np.std(angles, axis=0), sigmas, rtol=0.05)


def test_direction_is_the_transpose() -> None:
    boresight = np.radians([1.0, 2.0, 3.0])
    to_body = ConventionSetup(convention_of_key("applanix"))
    to_lidar = ConventionSetup(replace(convention_of_key("applanix"), direction="body_to_lidar"))
    one = convert_to_system(Mounting(LEVER_ARM, boresight), to_body)
    other = convert_to_system(Mounting(LEVER_ARM, boresight), to_lidar)
    np.testing.assert_allclose(one.rotation, other.rotation.T, atol=1e-15)
    np.testing.assert_allclose(one.transform, other.transform, atol=1e-15)
    # The transpose is not the negative of the angles, which would differ by 0.1 deg here.
    assert np.degrees(np.abs(one.angles + other.angles).max()) > 0.05


@pytest.mark.parametrize("axes", [("up", "aft", "starboard"), ("port", "aft", "up")])
def test_a_mounting_contains_the_quarter_turns(axes) -> None:
    """A scanner mounted on its side has small OPALS angles, and its raw points still fit."""
    rotation = rotation_matrix(*np.radians([0.3, -0.5, 0.8])) @ axes_matrix(axes).T
    boresight, _ = angles_of_rotation(LISPAC_CONVENTION, rotation)
    assert nearest_axes(rotation) == axes
    setup = ConventionSetup(convention_of_key("opals"))
    converted = convert_to_system(Mounting(LEVER_ARM, boresight), setup)
    assert np.degrees(np.abs(converted.angles).max()) < 1.0
    back = convert_from_system(
        replace(setup, mounting=axes), converted.rotation, converted.lever_arm
    )
    np.testing.assert_allclose(back.rotation_body_lidar, rotation, rtol=0, atol=1e-12)
    body = converted.transform[:3, :3] @ [1.0, 2.0, 3.0]
    np.testing.assert_allclose(body * [1, -1, -1], rotation @ [1.0, 2.0, 3.0], atol=1e-12)


# -- corrections -----------------------------------------------------------------------------------


def test_a_sum_of_angles_has_the_reported_error() -> None:
    convention = convention_of_key("applanix")
    current, expected = np.radians([5.0, -4.0, 10.0]), np.radians([-2.0, 3.0, 1.0])
    found = correct_boresight(convention, current, rotation_of_angles(convention, expected))
    summed = rotation_of_angles(convention, current + found.correction)
    sight = np.array([0.0, 0.0, 1.0])
    off = 100 * np.linalg.norm(summed @ sight - rotation_of_angles(convention, expected) @ sight)
    assert 0.1 < off <= 100 * found.sum_error * 1.0001
    assert found.sum_error == pytest.approx(
        angle_between_rotations(summed, rotation_of_angles(convention, expected))
    )


@pytest.mark.parametrize("direction", ["lidar_to_body", "body_to_lidar"])
@pytest.mark.parametrize("exported", [("forward", "port", "up"), ("forward", "starboard", "down")])
def test_angles_estimated_on_rotated_lines_are_combined_with_the_old_ones(
    direction, exported
) -> None:
    """The raw points were rotated by old settings before their export to this program."""
    truth = Mounting(LEVER_ARM, np.radians([1.3, -1.1, 2.4]))
    setup = ConventionSetup(replace(convention_of_key("applanix"), direction=direction))
    current = np.radians([1.0, 1.5, 2.0])
    old = mounting_of_angles(setup, current, LEVER_ARM).rotation_body_lidar
    to_exported = axes_matrix(exported) @ old  # raw scanner to the axes of the export
    remainder, _ = angles_of_rotation(LISPAC_CONVENTION, truth.rotation_body_lidar @ to_exported.T)
    whole, _ = add_to_applied_boresight(setup, current, Mounting(LEVER_ARM, remainder))
    np.testing.assert_allclose(
        whole.rotation_body_lidar, truth.rotation_body_lidar, rtol=0, atol=1e-14
    )


def test_the_covariance_of_the_combination_agrees_with_a_sample() -> None:
    rng = np.random.default_rng(5)
    setup, current = ConventionSetup(convention_of_key("applanix")), np.radians([20.0, 35.0, 60.0])
    remainder = np.array([0.01, -0.02, 0.005])
    root = rng.normal(0, 1e-4, (3, 3))
    _, covariance = add_to_applied_boresight(
        setup, current, Mounting(LEVER_ARM, remainder), root @ root.T
    )
    drawn = rng.normal(size=(400, 3))
    drawn -= drawn.mean(axis=0)
    # The sample has exactly the given covariance, so that a small one is sufficient.
    drawn = drawn @ np.linalg.inv(np.linalg.cholesky(drawn.T @ drawn / len(drawn))).T
    sample = remainder + drawn @ root.T
    angles = [
        add_to_applied_boresight(setup, current, Mounting(LEVER_ARM, s))[0].boresight
        for s in sample
    ]
    np.testing.assert_allclose(np.sqrt(np.diag(covariance)), np.std(angles, axis=0), rtol=0.001)


# -- poles and refusals ----------------------------------------------------------------------------


@pytest.mark.parametrize("convention", WITH_ANGLES, ids=lambda each: each.key)
@pytest.mark.parametrize("pole", [90.0, -90.0])
def test_at_the_pole_the_rotation_is_right_and_a_note_says_so(convention, pole) -> None:
    angles = np.radians([10.0, 20.0, 30.0])
    angles[convention.order[1]] = np.radians(pole)
    rotation = rotation_of_angles(convention, angles)
    found, message = angles_of_rotation(convention, rotation)
    np.testing.assert_allclose(rotation_of_angles(convention, found), rotation, atol=1e-12)
    assert message is not None
    assert message.params["angle"] == pytest.approx(np.radians(pole))
    assert found[convention.order[2]] == 0.0
    # With a free mounting, a system chooses other axes instead of the pole.
    setup = ConventionSetup(convention, mounting=FORWARD_PORT_UP)
    mounting = convert_from_system(setup, rotation, LEVER_ARM)
    converted = convert_to_system(mounting, setup, np.eye(3) * 1e-8)
    assert converted.sigmas is None
    assert converted.note is not None
    assert converted.note.code == "convention.gimbal_lock"


def test_near_the_pole_a_note_requires_all_digits() -> None:
    convention = convention_of_key("applanix")
    rotation = rotation_of_angles(convention, np.radians([10.0, 85.0, 30.0]))
    note = angles_of_rotation(convention, rotation)[1]
    assert note is not None
    assert note.code == "convention.near_gimbal_lock"
    assert angles_of_rotation(convention, np.eye(3))[1] is None


def test_invalid_rotation_matrices_are_refused() -> None:
    good = rotation_matrix(0.1, 0.2, 0.3)
    np.testing.assert_allclose(require_rotation(np.round(good, 6)), good, atol=1e-6)
    with pytest.raises(InputError, check=has_code("survey.matrix_mirrors")):
        require_rotation(np.diag([1.0, 1.0, -1.0]) @ good)
    for bad in (1.001 * good, good + 1e-4, np.zeros((3, 3))):
        with pytest.raises(InputError, check=has_code("survey.not_a_rotation")):
            require_rotation(bad)
    for bad in (np.full((3, 3), np.nan), np.eye(4)):
        with pytest.raises(InputError, check=has_code("survey.matrix_shape")):
            require_rotation(bad)


def test_invalid_systems_and_axes_are_refused() -> None:
    with pytest.raises(InputError, check=has_code("survey.unknown_program", name="posmv")):
        convention_of_key("posmv")
    with pytest.raises(InputError, check=has_code("survey.matrix_only")):
        mounting_of_angles(
            ConventionSetup(convention_of_key("riprocess")), np.zeros(3), np.zeros(3)
        )
    with pytest.raises(InputError, check=has_code("survey.axes_left_handed")):
        convert_to_system(
            Mounting(LEVER_ARM, np.zeros(3)),
            ConventionSetup(convention_of_key("hypack"), scanner="kept"),
        )
    with pytest.raises(InputError, check=has_code("survey.unknown_direction", word="ahead")):
        axes_matrix(("ahead", "port", "up"))
    with pytest.raises(InputError, check=has_code("survey.axes_not_spanning")):
        axes_matrix(("forward", "aft", "up"))
    with pytest.raises(InputError, check=has_code("survey.axes_on_one_line")):
        complete_axes("up", "down")


def test_all_right_handed_axes_can_be_given() -> None:
    made = set()
    for x in DIRECTIONS:
        for y in DIRECTIONS:
            try:
                made.add(complete_axes(x, y))
            except InputError:
                continue
    assert len(made) == 24
    assert all(np.linalg.det(axes_matrix(axes)) == pytest.approx(1) for axes in made)
    assert all(nearest_axes(axes_matrix(axes).T) == axes for axes in made)


def test_halfway_between_two_axes_a_frame_points_forward() -> None:
    for yaw in (45.0, -45.0):
        assert nearest_axes(rotation_matrix(0, 0, np.radians(yaw))) == FORWARD_PORT_UP


@pytest.mark.parametrize(
    "setup",
    [
        ConventionSetup(convention_of_key("applanix"), scanner="kept"),
        ConventionSetup(convention_of_key("kluster"), body_axes=("forward", "port", "up")),
    ],
)
def test_axes_other_than_the_documented_ones_are_unverified(setup) -> None:
    assert setup.convention.status == "verified"
    assert setup.status == "unverified"
    assert "axes differ from the documentation" in str(setup.assumption)


def test_signs_are_reported_for_the_documented_axes_only() -> None:
    as_known = ConventionSetup(convention_of_key("kluster"))
    turned = ConventionSetup(convention_of_key("kluster"), body_axes=("forward", "port", "up"))
    assert [str(each) for each in as_known.meanings] == [
        turn.meaning for turn in as_known.convention.turns
    ]
    assert not any("bow" in str(each) for each in turned.meanings)
