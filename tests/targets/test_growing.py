"""Tests of growing a plane over connected points."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.geometry.planes import Plane
from lispac.targets.finder_settings import FinderSettings
from lispac.targets.region_growing import grow_best_contender, grow_plane, trim_outliers

LEVEL_PLANE = Plane(np.array([0.0, 0.0, 1.0]), 0.0)
DISTANT_PLANE = Plane(np.array([0.0, 0.0, 1.0]), -30.0)
SETTINGS = FinderSettings(threshold=0.01)


def _board(noise: float = 0.002) -> np.ndarray:
    rng = np.random.default_rng(4)
    flat = rng.uniform(-0.5, 0.5, (400, 2))
    return np.column_stack([flat, rng.normal(0.0, noise, 400)])


def test_a_plane_without_points_near_it_grows_to_no_points() -> None:
    points = _board()
    assert len(grow_plane(points, np.ones(400), DISTANT_PLANE, SETTINGS, None)) == 0
    assert len(grow_plane(points, np.ones(400), LEVEL_PLANE, SETTINGS, None)) > 380


@pytest.mark.parametrize("contenders", [[DISTANT_PLANE, LEVEL_PLANE], [LEVEL_PLANE, DISTANT_PLANE]])
def test_the_best_contender_is_the_plane_with_points(contenders: list[Plane]) -> None:
    found = grow_best_contender(_board(), np.ones(400), contenders, SETTINGS, None)
    assert abs(found.d) < 0.001
    assert found.tilt_to(LEVEL_PLANE) < np.radians(0.1)


def test_the_first_contender_is_kept_if_none_has_points() -> None:
    other = replace(DISTANT_PLANE, d=-40.0)
    assert (
        grow_best_contender(_board(), np.ones(400), [DISTANT_PLANE, other], SETTINGS, None)
        is DISTANT_PLANE
    )


def test_points_at_the_threshold_are_included_without_tilting_the_plane() -> None:
    """They have no weight in the fit, so the plane does not change."""
    points = np.array([(0.0, 0.0, 0.5), (0.1, 0.0, 0.5), (0.0, 0.1, -0.5), (0.1, 0.1, -0.5)])
    on = grow_plane(points, np.ones(4), LEVEL_PLANE, replace(SETTINGS, threshold=0.5), None)
    np.testing.assert_array_equal(on, np.arange(4))


def test_points_amid_many_points_off_the_plane_are_not_included() -> None:
    """Of five points on the plane, four lie amid fifty points each that lie just off it."""
    rng = np.random.default_rng(1)
    corners = np.array([(0.8, 0.0), (-0.8, 0.0), (0.0, 0.8), (0.0, -0.8)])
    on = np.column_stack([np.vstack([[0.0, 0.0], corners]), np.zeros(5)])
    crowds = [
        np.column_stack([corner + rng.uniform(-0.05, 0.05, (50, 2)), np.full(50, 0.015)])
        for corner in corners
    ]
    votes = np.full(205, 1e-3)
    votes[0] = 1.0
    assert len(grow_plane(on, votes[:5], LEVEL_PLANE, SETTINGS, None)) == 3, (
        "alone they are connected"
    )
    assert len(grow_plane(np.concatenate([on, *crowds]), votes, LEVEL_PLANE, SETTINGS, None)) == 0


def test_too_few_points_for_a_plane_are_not_trimmed() -> None:
    points = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 5.0)])
    np.testing.assert_array_equal(trim_outliers(points, np.array([0, 1]), SETTINGS), [0, 1])
