"""Tests of the comparison of calibrations: the two surveys of the thesis, chance, real changes."""

import numpy as np
import pytest
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.validation.repeatability import Calibration, combine_calibrations, compare_calibrations
from tests.support.error_codes import has_code

Array = NDArray[np.float64]

SIGMA = np.radians([0.008, 0.010, 0.025])
CORRELATION = np.array([[1.0, 0.3, -0.4], [0.3, 1.0, 0.2], [-0.4, 0.2, 1.0]])
COVARIANCE = np.outer(SIGMA, SIGMA) * CORRELATION
TRUE_BORESIGHT = np.radians([0.27, -1.14, 0.36])


def random_calibration(
    rng: np.random.Generator, name: str = "survey", off: Array | float = 0.0
) -> Calibration:
    return Calibration(name, rng.multivariate_normal(TRUE_BORESIGHT + off, COVARIANCE), COVARIANCE)


def test_the_two_surveys_of_the_thesis() -> None:
    """Table 4.5: the text gives 0.47 degrees and 41 cm at 50 m."""
    july = Calibration(
        "July", np.radians([0.208, -1.245, 0.149]),
        np.diag(np.radians([0.0010, 0.0118, 0.0008]) ** 2),
    )  # fmt: skip
    october = Calibration(
        "October", np.radians([0.341, -0.805, 0.032]),
        np.diag(np.radians([0.0014, 0.0110, 0.0006]) ** 2),
    )  # fmt: skip
    found = compare_calibrations(july, october)
    np.testing.assert_allclose(np.degrees(found.angles), [0.133, 0.440, -0.117], atol=1e-9)
    assert np.degrees(found.turn) == pytest.approx(0.47, abs=0.005)
    assert found.largest_displacement(50.0) == pytest.approx(0.41, abs=0.005)
    assert found.differ
    assert found.significant == (True, True, True)


def test_false_alarm_rate_is_five_percent() -> None:
    rng = np.random.default_rng(3)
    pairs = [
        compare_calibrations(random_calibration(rng), random_calibration(rng)) for _ in range(2000)
    ]
    assert np.mean([pair.differ for pair in pairs]) == pytest.approx(0.05, abs=0.015)
    by_angle = np.mean([pair.significant for pair in pairs], axis=0)
    assert by_angle == pytest.approx(0.05, abs=0.015)


def test_a_displaced_scanner_is_detected() -> None:
    rng = np.random.default_rng(4)
    bump = np.radians([0.0, 0.08, 0.0])
    found = [
        compare_calibrations(random_calibration(rng), random_calibration(rng, off=bump))
        for _ in range(200)
    ]
    assert np.mean([pair.differ for pair in found]) > 0.99
    assert np.degrees(np.mean([pair.angles[1] for pair in found])) == pytest.approx(0.08, abs=0.005)


def test_displacement_is_that_of_rotated_points() -> None:
    from lispac.geometry.rotations import rotation_matrix

    rng = np.random.default_rng(5)
    first, second = (
        random_calibration(rng),
        random_calibration(rng, off=np.radians([0.3, -0.5, 1.0])),
    )
    directions = rng.normal(size=(20_000, 3))
    points = 50.0 * directions / np.linalg.norm(directions, axis=1)[:, None]
    placed = [points @ rotation_matrix(*each.boresight).T for each in (first, second)]
    farthest = np.linalg.norm(placed[0] - placed[1], axis=1).max()
    assert compare_calibrations(first, second).largest_displacement(50.0) == pytest.approx(
        farthest, rel=1e-3
    )


def test_yaw_is_compared_modulo_a_full_turn() -> None:
    almost = [Calibration("a", np.radians([0, 0, yaw]), COVARIANCE) for yaw in (179.99, -179.99)]
    found = compare_calibrations(*almost)
    assert np.degrees(found.angles[2]) == pytest.approx(0.02)
    assert np.degrees(found.turn) == pytest.approx(0.02)
    assert abs(np.degrees(combine_calibrations(almost).boresight[2])) == pytest.approx(180.0)


def test_sigma_of_a_combination_falls_with_the_root_of_its_number() -> None:
    rng = np.random.default_rng(6)
    groups = [
        combine_calibrations([random_calibration(rng) for _ in range(4)]) for _ in range(1000)
    ]
    assert np.mean([group.differ for group in groups]) == pytest.approx(0.05, abs=0.02)
    np.testing.assert_allclose(groups[0].sigma, SIGMA / 2)
    off = np.array([group.boresight for group in groups]) - TRUE_BORESIGHT
    np.testing.assert_allclose(off.std(axis=0), SIGMA / 2, rtol=0.07)
    spread = np.sqrt(np.mean([group.spread**2 for group in groups], axis=0))
    np.testing.assert_allclose(spread, SIGMA, rtol=0.05)


def test_incomparable_calibrations_are_refused() -> None:
    with pytest.raises(InputError, check=has_code("validation.repeatability_few")):
        combine_calibrations([Calibration("only", TRUE_BORESIGHT, COVARIANCE)])
    with pytest.raises(
        InputError, check=has_code("validation.repeatability_covariance", name="old")
    ):
        Calibration("old", TRUE_BORESIGHT, np.zeros((3, 3)))
    with pytest.raises(InputError, check=has_code("validation.repeatability_values")):
        Calibration("old", TRUE_BORESIGHT[:2], COVARIANCE)
