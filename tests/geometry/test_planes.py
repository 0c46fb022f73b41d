"""Tests of planes: fit, axes, extent; and of neighbours in a sphere."""

import numpy as np
import pytest

from lispac.errors import PlaneNotFound
from lispac.geometry.planes import (
    MIN_SPREAD_RATIO,
    Plane,
    extent_in_plane,
    fit_plane,
    fit_plane_robustly,
    plane_axes,
    plane_through,
    rms_distance,
)
from lispac.geometry.radius_search import PointGrid, nearest_point, points_within
from tests.support.error_codes import has_code

NORMALS = [(0, -1, 0), (0, -1, 1), (0.3, 0.2, 1), (1, 0, 0), (0, 0, 1), (0, 0, -1), (-1, 2, -3)]


@pytest.mark.parametrize("normal", NORMALS)
@pytest.mark.parametrize("origin", [(0, 0, 0), (500_000, 5_000_000, 30)])
def test_fit_recovers_a_plane_also_at_large_coordinates(normal, origin):
    rng = np.random.default_rng(3)
    true = plane_through(np.array(origin, float), np.array(normal, float))
    points = np.array(origin) + rng.uniform(-1, 1, (200, 2)) @ plane_axes(true.normal)
    plane = fit_plane(points)
    assert plane.tilt_to(true) < 1e-8
    assert np.abs(plane.distances(points)).max() < 2e-9
    assert np.isclose(np.linalg.norm(plane.normal), 1.0, atol=1e-15)
    assert plane.normal[np.argmax(np.abs(normal))] > 0


def test_three_points_determine_a_plane():
    plane = fit_plane(np.array([[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [0.0, 3.0, 1.0]]))
    np.testing.assert_allclose([*plane.normal, plane.d], [0, 0, 1, -1], atol=1e-15)


@pytest.mark.parametrize(
    ("width", "fits"), [(0.99 * MIN_SPREAD_RATIO, False), (1.01 * MIN_SPREAD_RATIO, True)]
)
def test_a_narrow_strip_does_not_determine_a_plane(width, fits):
    strip = np.array([[a, b * width, 0.0] for a in (-1, 1) for b in (-1, 1)])
    if fits:
        np.testing.assert_allclose(fit_plane(strip).normal, [0, 0, 1], atol=1e-12)
        return
    with pytest.raises(PlaneNotFound, check=has_code("target.plane_on_line")):
        fit_plane(strip)


def test_fit_is_weighted_least_squares():
    rng = np.random.default_rng(4)
    points = rng.uniform(-1, 1, (300, 3)) * [1, 1, 0.05]
    plane = fit_plane(points)
    best = rms_distance(plane, points)
    for nudge in rng.normal(0, 0.01, (20, 4)):
        other = plane_through(
            -plane.d * plane.normal + nudge[3] * plane.normal, plane.normal + nudge[:3]
        )
        assert rms_distance(other, points) >= best
    doubled = fit_plane(np.concatenate([points, points[:100]]))
    weighted = fit_plane(points, np.where(np.arange(300) < 100, 2.0, 1.0))
    np.testing.assert_allclose(weighted.normal, doubled.normal, rtol=0, atol=1e-12)
    assert weighted.d == pytest.approx(doubled.d, abs=1e-12)


@pytest.mark.parametrize(
    ("points", "code"),
    [
        (np.zeros((2, 3)), "target.plane_few_points"),
        (np.outer(np.arange(9.0), [1, 2, 3]), "target.plane_on_line"),
        (np.zeros((5, 3)), "target.plane_on_line"),
        (np.full((5, 3), np.nan), "target.plane_not_finite"),
    ],
)
def test_fit_refuses_points_that_determine_no_plane(points, code):
    with pytest.raises(PlaneNotFound, check=has_code(code)):
        fit_plane(points)


@pytest.mark.parametrize("normal", NORMALS)
def test_axes_are_horizontal_and_along_the_slope(normal):
    unit = np.array(normal, float) / np.linalg.norm(normal)
    level, slope = plane_axes(unit)
    np.testing.assert_allclose(
        np.stack([level, slope, unit]) @ np.stack([level, slope, unit]).T, np.eye(3), atol=1e-12
    )
    assert abs(level[2]) < 1e-12
    assert slope[2] >= -1e-12


@pytest.mark.parametrize("up", [1.0, -1.0])
@pytest.mark.parametrize("tilt", [(0, 0), (9e-4, 0), (-9e-4, 0), (0, 9e-4), (6e-4, -6e-4)])
def test_axes_of_a_flat_plane_are_west_and_north(up, tilt):
    normal = np.array([*tilt, up]) / np.linalg.norm([*tilt, up])
    level, slope = plane_axes(normal)
    np.testing.assert_allclose(level, [0, 1, 0], rtol=0, atol=1e-3)
    np.testing.assert_allclose(slope, [1, 0, 0], rtol=0, atol=1e-3)
    np.testing.assert_allclose([level @ normal, slope @ normal], 0, atol=1e-15)


def test_extent_gives_width_and_height_of_an_inclined_board():
    normal = np.array([0.0, -1.0, 1.0]) / np.sqrt(2)
    u, v = np.meshgrid(np.linspace(0, 1.23, 30), np.linspace(0, 0.76, 20))
    points = np.stack([u.ravel(), v.ravel()], 1) @ plane_axes(normal)
    np.testing.assert_allclose(extent_in_plane(fit_plane(points), points), [1.23, 0.76], atol=1e-9)


def test_outliers_on_one_side_hardly_move_the_robust_plane():
    rng = np.random.default_rng(8)
    points = np.column_stack([rng.uniform(-1, 1, (900, 2)), rng.normal(0, 0.003, 900)])
    points[:270, 0] = np.abs(points[:270, 0])  # outliers on one half also tilt the plane
    points[:270, 2] += 0.3
    level = np.array([0.0, 0.0, 1.0])
    usual, robust = fit_plane(points), fit_plane_robustly(points, 0.003)
    assert abs(usual.d) > 0.05
    assert abs(robust.d) < 0.01
    assert np.degrees(np.arccos(robust.facing(level).normal @ level)) < 1.0
    assert robust.tilt_to(usual) > 0.05


def test_a_flipped_plane_is_the_same_plane():
    plane = Plane(np.array([0.0, 0.6, 0.8]), -2.0)
    assert plane.flipped().tilt_to(plane) == 0.0
    assert plane.facing(np.array([0.0, 0.0, -1.0])).normal[2] < 0
    assert plane.facing(np.array([0.0, 0.0, 1.0])) is plane
    points = np.random.default_rng(0).normal(size=(5, 3))
    np.testing.assert_allclose(plane.flipped().distances(points), -plane.distances(points))


@pytest.mark.parametrize("cell", [0.3, 1.0, 50.0])
def test_grid_and_direct_search_agree_with_the_definition(cell):
    rng = np.random.default_rng(5)
    points = rng.uniform(-3, 3, (5000, 3))
    points[::50] = np.nan
    points[7, 1] = np.inf
    grid = PointGrid(points, cell)
    for centre in (np.zeros(3), np.array([3.0, -3.0, 1.0]), np.array([40.0, 0, 0])):
        for radius in (0.01, 0.7, 9.0):
            with np.errstate(invalid="ignore"):
                expected = np.flatnonzero(np.linalg.norm(points - centre, axis=1) <= radius)
            np.testing.assert_array_equal(points_within(points, centre, radius), expected)
            np.testing.assert_array_equal(grid.within(centre, radius), expected)


def test_direct_search_in_threads_agrees_with_the_definition(monkeypatch):
    monkeypatch.setattr("os.cpu_count", lambda: 8)  # more than there are chunks
    points = np.random.default_rng(6).uniform(-3, 3, (600_000, 3))
    expected = np.flatnonzero((points**2).sum(axis=1) <= 1.0)
    np.testing.assert_array_equal(points_within(points, np.zeros(3), 1.0), expected)


def test_a_distant_outlier_does_not_exhaust_the_memory_of_the_grid():
    points = np.concatenate([np.random.default_rng(7).normal(size=(1000, 3)), [[1e7, -1e7, 1e6]]])
    grid = PointGrid(points, 0.5)
    np.testing.assert_array_equal(
        grid.within(np.zeros(3), 1.0), points_within(points, np.zeros(3), 1.0)
    )


@pytest.mark.parametrize("points", [np.empty((0, 3)), np.full((4, 3), np.nan)])
def test_neighbours_without_points(points):
    assert len(points_within(points, np.zeros(3), 1.0)) == 0
    assert len(PointGrid(points).within(np.zeros(3), 1.0)) == 0
    assert nearest_point(points, np.zeros(3)) == (-1, np.inf)
