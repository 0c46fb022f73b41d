"""Tests of points sorted by group, and of planes of groups of different sizes."""

import numpy as np
import pytest

from lispac.geometry.local_planes import planes_of_groups
from lispac.geometry.planes import fit_plane
from lispac.geometry.point_groups import sort_by_group


@pytest.mark.parametrize("count", [0, 1, 7])
def test_indices_are_sorted_by_group(count: int) -> None:
    group = np.random.default_rng(1).integers(-1, count, 500)
    group[group == 4] = 5  # a group without points
    order, ends = sort_by_group(group, count)
    assert len(ends) == count
    for k, own in enumerate(np.split(order, ends)[:count]):
        np.testing.assert_array_equal(own, np.flatnonzero(group == k))
    assert len(order) == np.count_nonzero(group >= 0)


def test_planes_of_groups_are_least_squares_planes() -> None:
    rng = np.random.default_rng(2)
    sizes = np.array([3, 40, 5, 700])
    points = rng.normal(5e5, 1.0, (sizes.sum(), 3)) * (1.0, 1.0, 0.01)
    centres, normals = planes_of_groups(points, np.cumsum(sizes))
    for own, centre, normal in zip(
        np.split(points, np.cumsum(sizes)), centres, normals, strict=False
    ):
        plane = fit_plane(own)
        np.testing.assert_allclose(np.abs(normal @ plane.normal), 1.0, atol=1e-12)
        np.testing.assert_allclose(plane.distances(centre), 0.0, atol=1e-8)


def test_a_group_on_a_straight_line_has_no_plane() -> None:
    points = np.linspace(0.0, 1.0, 20)[:, None] * np.array([1.0, 2.0, 3.0])
    assert np.isnan(planes_of_groups(points, np.array([20]))[1]).all()
