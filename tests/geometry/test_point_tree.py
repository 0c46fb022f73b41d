"""Nearest points by the k-d tree, compared with SciPy's."""

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from lispac.geometry.point_tree import PointTree

Array = NDArray[np.float64]
RNG = np.random.default_rng(7)


def uneven() -> Array:
    """Clusters of very different density, at large coordinates as of a map projection."""
    sizes = (0.001, 0.1, 10.0, 1000.0)
    clusters = [RNG.normal(size=3) * 100 + size * RNG.normal(size=(700, 3)) for size in sizes]
    return np.concatenate(clusters) + np.array([4e5, 5.2e6, 30.0])


def powers_of_two() -> Array:
    """Points that no division separates evenly, so that the tree has hundreds of levels."""
    x = 0.5 ** np.arange(900)
    return np.column_stack((x, -x, np.zeros_like(x)))


CLOUDS: dict[str, Callable[[], Array]] = {
    "uniform": lambda: RNG.uniform(0, 10, (5000, 3)),
    "uneven": uneven,
    "wall": lambda: np.column_stack((RNG.uniform(0, 9, (4000, 2)), np.full(4000, 3.0))),
    "line": lambda: np.column_stack((np.linspace(0, 1, 500), np.zeros((500, 2)))),
    "powers of two": powers_of_two,
    "few": lambda: RNG.normal(size=(3, 3)),
    "one": lambda: np.ones((1, 3)),
}


@pytest.mark.parametrize("name", CLOUDS)
def test_the_same_neighbours_as_scipy(name: str) -> None:
    points = CLOUDS[name]()
    span = float(np.ptp(points, axis=0).max())
    places = np.concatenate(
        (points[::3], points[::2] + 0.05 * span * RNG.normal(size=points[::2].shape))
    )
    tree, theirs = PointTree(points), cKDTree(points)
    np.testing.assert_array_equal(points[tree.order], tree.points)
    distance, found = tree.nearest(places)
    np.testing.assert_allclose(distance, theirs.query(places)[0], rtol=1e-12)
    np.testing.assert_allclose(
        np.linalg.norm(tree.points[found] - places, axis=1), distance, rtol=1e-12
    )
    for count in (2, 6, 20):
        near, which = tree.neighbours(places, count)
        np.testing.assert_allclose(near, theirs.query(places, count)[0], rtol=1e-12)
        valid = np.isfinite(near)
        assert np.array_equal(which == len(points), ~valid)
        assert all(len(set(row[ok])) == ok.sum() for row, ok in zip(which, valid, strict=True))


@pytest.mark.parametrize("name", CLOUDS)
def test_the_same_points_within_a_radius_as_scipy(name: str) -> None:
    points = CLOUDS[name]()
    radius = 0.07 * float(np.ptp(points, axis=0).max()) + 1e-9
    found, counts = PointTree(points).within(points, radius)
    order = PointTree(points).order
    for row, count, theirs in zip(
        found, counts, cKDTree(points).query_ball_point(points, radius), strict=True
    ):
        assert set(order[row[:count]]) == set(theirs)


def test_a_limit_excludes_points_at_this_distance_and_beyond() -> None:
    tree = PointTree([[0.0, 0.0, 0.0], [3.0, 0.0, 0.0]])
    places = np.array([[1.0, 0.0, 0.0], [0.5, 0.0, 0.0], [9.0, 0.0, 0.0]])
    distance, found = tree.nearest(places, 1.0)
    np.testing.assert_array_equal(distance, [np.inf, 0.5, np.inf])
    assert found.tolist()[::2] == [2, 2]
    np.testing.assert_array_equal(tree.points[found[1]], [0.0, 0.0, 0.0])


def test_points_that_coincide_are_all_found() -> None:
    points = np.concatenate((np.full((50, 3), 2.0), np.full((50, 3), 5.0)))
    tree = PointTree(points)
    distance, found = tree.neighbours(np.full((1, 3), 2.1), 50)
    np.testing.assert_allclose(distance, 0.1 * np.sqrt(3))
    assert set(tree.order[found[0]]) == set(range(50))


def test_an_empty_cloud_has_no_neighbours() -> None:
    tree = PointTree(np.empty((0, 3)))
    assert np.isinf(tree.nearest(np.zeros((2, 3)))[0]).all()
    assert np.isinf(tree.neighbours(np.zeros((2, 3)), 4)[0]).all()
    assert tree.within(np.zeros((2, 3)), 1.0)[1].tolist() == [0, 0]


@pytest.mark.parametrize("points", [np.zeros((4, 2)), np.zeros(3), np.full((2, 3), np.nan)])
def test_other_arrays_are_refused(points: Array) -> None:
    with pytest.raises(ValueError, match="finite points"):
        PointTree(points)


def test_places_that_repeat_or_coincide_with_points() -> None:
    points = RNG.uniform(0, 10, (300, 3))
    places = np.repeat(points[:40], 3, axis=0)
    tree = PointTree(points)
    distance, found = tree.nearest(places)
    assert not distance.any()
    np.testing.assert_array_equal(tree.points[found], places)
    near, which = tree.neighbours(places, 5)
    np.testing.assert_array_equal(near[::3], near[2::3])
    np.testing.assert_array_equal(which[::3], which[2::3])
    assert np.isfinite(near).all()
