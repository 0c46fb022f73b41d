"""A plane grown over points: what belongs to it, and what does not end it."""

from dataclasses import replace

import numpy as np
import pytest

from lispac.geometry.planes import Plane
from lispac.targets.finder_settings import FinderSettings
from lispac.targets.region_growing import grow_best_contender, grow_plane, trim_outliers

LEVEL = Plane(np.array([0.0, 0.0, 1.0]), 0.0)
FAR = Plane(np.array([0.0, 0.0, 1.0]), -30.0)
SETTINGS = FinderSettings(threshold=0.01)


def _board(noise: float = 0.002) -> np.ndarray:
    rng = np.random.default_rng(4)
    flat = rng.uniform(-0.5, 0.5, (400, 2))
    return np.column_stack([flat, rng.normal(0.0, noise, 400)])


def test_a_plane_where_there_is_nothing_grows_to_nothing() -> None:
    points = _board()
    assert len(grow_plane(points, np.ones(400), FAR, SETTINGS, None)) == 0
    assert len(grow_plane(points, np.ones(400), LEVEL, SETTINGS, None)) > 380


@pytest.mark.parametrize("contenders", [[FAR, LEVEL], [LEVEL, FAR]])
def test_the_plane_with_points_is_the_strongest(contenders: list[Plane]) -> None:
    found = grow_best_contender(_board(), np.ones(400), contenders, SETTINGS, None)
    assert abs(found.d) < 0.001
    assert found.tilt_to(LEVEL) < np.radians(0.1)


def test_without_points_on_any_the_first_contender_stays() -> None:
    other = replace(FAR, d=-40.0)
    assert grow_best_contender(_board(), np.ones(400), [FAR, other], SETTINGS, None) is FAR


def test_points_right_at_the_threshold_belong_and_do_not_tilt_the_plane() -> None:
    """They have no weight in the fit: the plane stays where it was."""
    points = np.array([(0.0, 0.0, 0.5), (0.1, 0.0, 0.5), (0.0, 0.1, -0.5), (0.1, 0.1, -0.5)])
    on = grow_plane(points, np.ones(4), LEVEL, replace(SETTINGS, threshold=0.5), None)
    np.testing.assert_array_equal(on, np.arange(4))


def test_a_crowd_that_the_plane_runs_through_is_not_its_patch() -> None:
    """Five points on the plane, four of them amid fifty that lie just off it."""
    rng = np.random.default_rng(1)
    corners = np.array([(0.8, 0.0), (-0.8, 0.0), (0.0, 0.8), (0.0, -0.8)])
    on = np.column_stack([np.vstack([[0.0, 0.0], corners]), np.zeros(5)])
    crowds = [
        np.column_stack([corner + rng.uniform(-0.05, 0.05, (50, 2)), np.full(50, 0.015)])
        for corner in corners
    ]
    votes = np.full(205, 1e-3)
    votes[0] = 1.0
    assert len(grow_plane(on, votes[:5], LEVEL, SETTINGS, None)) == 3, "alone they are connected"
    assert len(grow_plane(np.concatenate([on, *crowds]), votes, LEVEL, SETTINGS, None)) == 0


def test_too_few_points_for_a_plane_are_not_trimmed() -> None:
    points = np.array([(0.0, 0.0, 0.0), (1.0, 0.0, 5.0)])
    np.testing.assert_array_equal(trim_outliers(points, np.array([0, 1]), SETTINGS), [0, 1])
