"""Tests of the replacement of current settings, given as a 4x4 matrix.

The expected points come from the formulas of the systems (`tests/survey/test_conventions.py`),
which do not use the converters.
"""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from lispac.survey.conventions.conversion import (
    ConventionSetup,
    angles_of_rotation,
    convert_to_system,
)
from lispac.survey.conventions.correction import add_to_applied_boresight
from lispac.survey.conventions.mounting_replacement import (
    MountingReplacement,
    current_mounting_of_matrix,
    replace_mounting,
)
from lispac.survey.conventions.systems import LISPAC_CONVENTION, SYSTEMS
from lispac.survey.georeferencing import Mounting
from tests.survey.test_conventions import FORMULAS, LEVER_ARM, setup_of

SYSTEM_KEYS = [each.key for each in SYSTEMS]
OLD_MOUNTING = Mounting(np.array([-0.05, 0.11, 2.31]), np.radians([1.3, 0.8, -2.4]))
NEW_MOUNTING = Mounting(LEVER_ARM, np.radians([0.44, -1.87, 0.40]))
FLIPPED_AXES = np.diag([1.0, -1.0, -1.0])


def in_body(points: np.ndarray, mounting: Mounting) -> np.ndarray:
    """Return points as forward, port, up from the POS, by the formula of the thesis."""
    return FORMULAS["lispac"](
        points, mounting.boresight, mounting.lever_arm, np.zeros((len(points), 3))
    )


def moved(points: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    """Transform points by a 4x4 matrix."""
    return np.array([[row[:3] @ x + row[3] for row in matrix[:3]] for x in points])


def replacement_of_old(
    setup: ConventionSetup, found: Mounting, *, applied: bool, known: bool
) -> MountingReplacement:
    """Replace settings of a system that currently has ``OLD_MOUNTING`` as a 4x4 matrix."""
    matrix = convert_to_system(OLD_MOUNTING, setup).transform
    current = current_mounting_of_matrix(setup, matrix[:3, :3], matrix[:3, 3])
    return replace_mounting(setup, found, None, current, applied=applied, has_lever_arm=known)


@pytest.fixture
def points() -> np.ndarray:
    return np.random.default_rng(8).uniform(-80, 80, (200, 3))


@pytest.mark.parametrize("known", [True, False])
@pytest.mark.parametrize("key", SYSTEM_KEYS)
def test_the_correction_matrix_moves_points_to_the_new_mounting(
    key: str, known: bool, points: np.ndarray
) -> None:
    setup = setup_of(key)
    new = replacement_of_old(setup, NEW_MOUNTING, applied=False, known=known)
    expected = Mounting(
        NEW_MOUNTING.lever_arm if known else OLD_MOUNTING.lever_arm, NEW_MOUNTING.boresight
    )
    assert new.current is not None
    assert new.current.transform is not None
    assert new.transform is not None
    theirs = points @ setup.permutation.T if setup.scanner_frame == "turned" else points
    now = moved(theirs, new.current.transform)
    np.testing.assert_allclose(
        now @ setup.permutation, in_body(points, OLD_MOUNTING), rtol=0, atol=1e-9
    )
    corrected = moved(now, new.transform) @ setup.permutation
    np.testing.assert_allclose(corrected, in_body(points, expected), rtol=0, atol=1e-9)
    np.testing.assert_allclose(moved(theirs, new.in_system.transform), moved(now, new.transform),
                               rtol=0, atol=1e-9)  # fmt: skip
    assert new.lever_arm == ("replaced" if known else "taken over")
    assert (new.lever_arm == "taken over") != known
    assert new.correction is not None
    np.testing.assert_allclose(
        new.correction.rotation @ new.correction.current_rotation,
        new.in_system.rotation,
        rtol=0,
        atol=1e-12,
    )
    if setup.convention.has_angles:
        again = FORMULAS[key](
            points, new.in_system.angles, new.in_system.lever_arm, np.zeros((len(points), 3))
        )
        np.testing.assert_allclose(again, in_body(points, expected), rtol=0, atol=1e-9)


@pytest.mark.parametrize("exported", [np.eye(3), FLIPPED_AXES], ids=["up", "down"])
@pytest.mark.parametrize("key", SYSTEM_KEYS)
def test_corrections_are_added_to_applied_settings(
    key: str, exported: np.ndarray, points: np.ndarray
) -> None:
    """A mounting found on lines with applied settings is added to these settings."""
    lines = in_body(points, OLD_MOUNTING) @ exported.T
    small = Rotation.from_rotvec([0.004, -0.007, 0.002]).as_matrix()
    found = Mounting(
        np.array([0.02, -0.01, 0.03]), angles_of_rotation(LISPAC_CONVENTION, small @ exported.T)[0]
    )
    new = replacement_of_old(setup_of(key), found, applied=True, known=True)
    np.testing.assert_allclose(
        in_body(points, new.mounting), in_body(lines, found), rtol=0, atol=1e-9
    )
    assert new.lever_arm == "on top"
    # Without a new lever arm the current one is rotated by the correction
    unknown = Mounting(np.zeros(3), found.boresight)
    new = replacement_of_old(setup_of(key), unknown, applied=True, known=False)
    np.testing.assert_allclose(
        new.mounting.lever_arm, small @ OLD_MOUNTING.lever_arm, rtol=0, atol=1e-12
    )
    assert new.lever_arm == "turned"
    assert new.has_lever_arm


@pytest.mark.parametrize("applied", [True, False])
def test_sigmas_of_the_new_settings(applied: bool) -> None:
    setup, covariance = setup_of("applanix"), np.diag(np.radians([0.01, 0.02, 0.03]) ** 2)
    current = current_mounting_of_matrix(
        setup, convert_to_system(OLD_MOUNTING, setup).rotation, None
    )
    new = replace_mounting(
        setup, NEW_MOUNTING, covariance, current, applied=applied, has_lever_arm=True
    )
    whole, of_whole = NEW_MOUNTING, covariance
    if applied:
        whole, of_whole = add_to_applied_boresight(setup, current.values, NEW_MOUNTING, covariance)
        assert np.abs(of_whole - covariance).max() > 1e-9
    np.testing.assert_array_equal(new.covariance, of_whole)
    np.testing.assert_array_equal(
        new.in_system.sigmas, convert_to_system(whole, setup, of_whole).sigmas
    )


def test_a_matrix_is_from_the_scanner_for_both_directions_of_angles() -> None:
    setup = setup_of("applanix")
    other = replace(setup, convention=replace(setup.convention, direction="body_to_lidar"))
    for each in (setup, other):
        converted = convert_to_system(OLD_MOUNTING, each)
        assert converted.angles is not None
        current = current_mounting_of_matrix(each, converted.transform[:3, :3], None)
        found = angles_of_rotation(each.convention, current.values)[0]
        np.testing.assert_allclose(found, converted.angles, rtol=0, atol=1e-12)


def test_a_3x3_matrix_does_not_change_the_lever_arm() -> None:
    setup = setup_of("applanix")
    current = current_mounting_of_matrix(setup, np.eye(3), None)
    for known, source in ((True, "given"), (False, "none")):
        new = replace_mounting(
            setup, NEW_MOUNTING, None, current, applied=False, has_lever_arm=known
        )
        assert new.transform is None
        assert new.lever_arm == source
        assert new.lever_arm_note is None
        np.testing.assert_array_equal(new.mounting.lever_arm, NEW_MOUNTING.lever_arm)
