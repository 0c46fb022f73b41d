"""Tests of camera, point budget and picking of the 3D viewport, without a window."""

import numpy as np
import pytest

from lispac.gui.viewport.camera import Camera, ViewportSize
from lispac.gui.viewport.decimation import (
    line_budgets,
    lowest_ranked,
    points_in_view,
    random_ranks,
    trimmed_points,
)
from lispac.gui.viewport.overlay import length_text, scale_bar_length
from lispac.gui.viewport.point_picker import pick_point
from tests.support.view_scenes import SIZE, scene


def random_camera(seed, *, parallel=False):
    rng = np.random.default_rng(seed)
    place = rng.normal(size=3) * 10, rng.uniform(0, 6), rng.uniform(-1.5, 1.5)
    return Camera(*place, 30.0, parallel)


@pytest.mark.parametrize("seed", range(4))
def test_camera_axes_are_right_handed_and_projection_is_invertible(seed):
    camera = random_camera(seed)
    right, up, forward = camera.axes
    np.testing.assert_allclose(camera.axes @ camera.axes.T, np.eye(3), atol=1e-14)
    np.testing.assert_allclose(np.cross(right, up), -forward, atol=1e-14)
    assert right[2] == 0.0  # the horizon is level
    point = camera.point_at(123.0, 456.0, 17.0, SIZE)
    np.testing.assert_allclose(camera.project(point, SIZE)[0], [123.0, 456.0, 17.0], atol=1e-9)
    np.testing.assert_allclose(camera.project(camera.focal, SIZE)[0], [400.0, 300.0, 30.0])


def test_orientation_of_north_and_top_views():
    north = Camera(np.zeros(3), 0.0, 0.0, 10.0)
    east = north.project(np.array([0.0, -1.0, 0.0]), SIZE)[0]
    assert east[0] > 400.0
    top = Camera(np.zeros(3), 0.0, 0.5 * np.pi, 10.0)
    assert top.project(np.array([1.0, 0.0, 0.0]), SIZE)[0, 1] < 300.0
    assert top.project(np.array([0.0, 1.0, 0.0]), SIZE)[0, 0] < 400.0


@pytest.mark.parametrize("seed", range(4))
def test_orbit_and_zoom_keep_the_pixel_of_their_point(seed):
    camera = random_camera(seed)
    point = camera.point_at(200.0, 150.0, 20.0, SIZE)
    np.testing.assert_allclose(
        camera.orbited(37.0, 0.0, point).project(point, SIZE)[0], [200.0, 150.0, 20.0], atol=1e-8
    )
    closer = camera.zoomed(0.5, point).project(point, SIZE)[0]
    np.testing.assert_allclose(closer, [200.0, 150.0, 10.0], atol=1e-8)
    shifted = camera.panned(30.0, -12.0, 20.0, SIZE).project(point, SIZE)[0]
    np.testing.assert_allclose(shifted, [230.0, 138.0, 20.0], atol=1e-8)


@pytest.mark.parametrize("seed", range(4))
def test_parallel_projection_keeps_lengths_and_the_picked_point(seed):
    camera = random_camera(seed, parallel=True)
    perspective = camera.with_projection(parallel=False)
    # At the focal point both projections have the same scale.
    beside = camera.focal + 2.0 * camera.axes[0]
    for each in (camera, perspective):
        np.testing.assert_allclose(
            each.project(beside, SIZE)[0, :2],
            [400.0 + 2.0 * SIZE.pixels_per_tangent / each.distance, 300.0],
        )
    behind = camera.focal - 400.0 * camera.axes[2]  # behind the eye of the perspective camera
    ends = camera.project(np.array([behind, behind + 2.0 * camera.axes[0]]), SIZE)
    assert ends[1, 0] - ends[0, 0] == pytest.approx(2.0 * SIZE.pixels_per_tangent / camera.distance)
    assert ends[0, 2] > 0.0
    point = camera.point_at(200.0, 150.0, camera.focal_depth + 17.0, SIZE)
    np.testing.assert_allclose(
        camera.project(point, SIZE)[0], [200.0, 150.0, camera.focal_depth + 17.0]
    )
    for moved in (
        camera.orbited(37.0, 0.0, point), camera.zoomed(0.5, point),
        camera.with_focal_depth(camera.focal_depth + 17.0),
    ):  # fmt: skip
        np.testing.assert_allclose(moved.project(point, SIZE)[0, :2], [200.0, 150.0], atol=1e-7)
    shifted = camera.panned(30.0, -12.0, camera.focal_depth, SIZE).project(point, SIZE)[0]
    np.testing.assert_allclose(shifted[:2], [230.0, 138.0], atol=1e-7)
    points = np.random.default_rng(seed).normal(size=(500, 3)) * [30.0, 10.0, 5.0] + 100.0
    fitted = camera.fitted(points, SIZE)
    pixels = fitted.project(points, SIZE)[:, :2]
    assert pixels.min() >= 0.0
    assert np.all(pixels.max(axis=0) <= [SIZE.width, SIZE.height])
    assert 0.85 < (np.ptp(pixels, axis=0) / [SIZE.width, SIZE.height]).max() <= 1.0
    assert len(points_in_view(points, fitted, SIZE)) == len(points)
    hit = pick_point({"a": points}, fitted, *pixels[17], SIZE)
    assert hit is not None
    np.testing.assert_allclose(pixels[hit.index], pixels[17], atol=2.0)


def test_a_camera_looks_along_any_direction():
    camera = random_camera(1)
    for direction in np.random.default_rng(2).normal(size=(20, 3)):
        expected = direction / np.linalg.norm(direction)
        np.testing.assert_allclose(camera.along(direction).axes[2], expected, atol=1e-12)
    down = camera.along(np.array([0.0, 0.0, -2.0]))
    np.testing.assert_allclose(down.axes[2], [0.0, 0.0, -1.0], atol=1e-12)
    assert down.azimuth == camera.azimuth


def test_elevation_is_limited_to_the_vertical():
    camera = random_camera(0).orbited(0.0, 1e5, np.zeros(3))
    assert camera.elevation == pytest.approx(0.5 * np.pi)


@pytest.mark.parametrize("seed", range(4))
@pytest.mark.parametrize("size", [SIZE, ViewportSize(300, 900)])
def test_fit_shows_all_points_and_fills_the_view(seed, size):
    points = np.random.default_rng(seed).normal(size=(500, 3)) * [30.0, 10.0, 5.0] + 100.0
    pixels = random_camera(seed).fitted(points, size).project(points, size)
    spread = np.ptp(pixels[:, :2], axis=0) / [size.width, size.height]
    assert pixels[:, :2].min() >= 0.0
    assert np.all(pixels[:, :2].max(axis=0) <= [size.width, size.height])
    assert 0.85 < spread.max() <= 1.0
    assert len(points_in_view(points, random_camera(seed).fitted(points, size), size)) == len(
        points
    )


def test_line_budgets_are_proportional_with_a_minimum_of_one():
    assert line_budgets({"a": 10, "b": 20}, 100) == {"a": 10, "b": 20}
    shared = line_budgets({"a": 900_000, "b": 100_000, "c": 3}, 1000)
    assert shared["a"] == pytest.approx(900, abs=1)
    assert shared["b"] == pytest.approx(100, abs=1)
    assert shared["c"] == 1
    assert line_budgets({"a": 0, "b": 500}, 10)["a"] == 0


def test_sample_is_reproducible_and_even():
    places = random_ranks(100_000)
    np.testing.assert_array_equal(places, random_ranks(100_000))
    chosen = lowest_ranked(places, 10_000)
    assert len(np.unique(chosen)) == 10_000
    assert places[chosen].max() <= np.delete(places, chosen).min()
    assert set(lowest_ranked(places, 100)) <= set(chosen)
    counts = np.histogram(chosen, bins=10, range=(0, 100_000))[0]
    assert counts.min() > 850
    for count in (1, 99_999, 100_000, 200_000):
        assert len(lowest_ranked(places, count)) == min(count, 100_000)
    np.testing.assert_array_equal(lowest_ranked(np.full(5, 0.9, np.float32), 2), [0, 1])


def test_robust_sample_rejects_outliers_only():
    points = np.random.default_rng(0).uniform(-1, 1, size=(20_000, 3))
    points[7] = [5000.0, 0.0, 0.0]
    kept = trimmed_points(points)
    assert kept.max() < 1.5
    assert len(kept) > 0.99 * len(points)


def test_pick_prefers_the_front_surface_under_the_cursor():
    clouds, _ = scene()
    camera = Camera(np.array([0.0, 15.0, 1.5]), -0.5 * np.pi, 0.0, 15.0)
    hit = pick_point(clouds, camera, 400.0, 300.0, SIZE)
    assert hit is not None
    assert hit.line == "red"
    assert hit.depth == pytest.approx(15.0)
    # Five pixels beside the edge of the red wall, the point of the blue wall is picked.
    edge = camera.project(clouds["red"], SIZE)[:, 0].max()
    beside = pick_point(clouds, camera, edge + 5.0, 300.0, SIZE)
    assert beside is not None
    assert beside.line == "blue"
    assert pick_point(clouds, camera, 400.0, 595.0, SIZE) is None
    assert pick_point({}, camera, 400.0, 300.0, SIZE) is None


def test_a_click_between_the_points_of_a_sparse_board_picks_the_board_not_the_wall():
    """The wall is exactly under the cursor; points of the board are on all sides of it."""
    camera = Camera(np.array([0.0, 15.0, 1.5]), -0.5 * np.pi, 0.0, 15.0)
    metres = camera.distance / SIZE.pixels_per_tangent
    steps = np.array([-15.0, -5.0, 5.0, 15.0]) * metres
    x, z = (each.ravel() for each in np.meshgrid(steps, steps))
    board = np.column_stack([x, np.full(16, 15.0), 1.5 + z])
    behind = camera.position + 18.0 * camera.axes[2]
    assert picked_line({"board": board, "wall": behind[None]}, camera) == "board"
    # At the edge of the board, its points are on one side only.
    edge = camera.project(board, SIZE)[:, 0].max() + 3.0
    beside = camera.point_at(edge, 300.0, camera.focal_depth + 3.0, SIZE)
    assert picked_line({"board": board, "wall": beside[None]}, camera, edge) == "wall"


def picked_line(clouds: dict[str, np.ndarray], camera: Camera, x: float = 400.0) -> str:
    hit = pick_point(clouds, camera, x, 300.0, SIZE)
    assert hit is not None
    return hit.line


def test_nothing_behind_the_eye_is_picked():
    camera = Camera(np.zeros(3), 0.0, 0.0, 10.0)
    assert pick_point({"a": np.array([[-30.0, 0.0, 0.0]])}, camera, 400.0, 300.0, SIZE) is None


@pytest.mark.parametrize(
    ("scale", "text"),
    [(0.1, "10 m"), (0.001, "10 cm"), (40.0, "5 km"), (0.0171, "2 m"), (0.00001, "1 mm")],
)
def test_scale_bar_has_a_round_length(scale, text):
    metres = scale_bar_length(scale)
    assert length_text(metres) == text
    assert 50.0 <= metres / scale <= 150.001


@pytest.mark.parametrize("parallel", [False, True])
def test_fitted_points_touch_the_edges_of_the_picture(parallel):
    points = np.random.default_rng(3).normal(size=(5000, 3)) * [20.0, 5.0, 2.0]
    camera = random_camera(2, parallel=parallel).fitted(points, SIZE, margin=1.0)
    pixels = camera.project(points, SIZE)[:, :2]
    low, high = pixels.min(axis=0), pixels.max(axis=0)
    whole = np.array([SIZE.width, SIZE.height])
    assert (low > -1.0).all()
    assert (high < whole + 1.0).all()
    assert np.minimum(low, whole - high).min() < 1.0
    # The points touch both opposite edges.
    tight = int(np.argmin(np.minimum(low, whole - high)))
    assert low[tight] == pytest.approx(whole[tight] - high[tight], abs=1.0)


@pytest.mark.parametrize("parallel", [False, True])
@pytest.mark.parametrize("shape", [(20.0, 5.0, 2.0), (1.0, 1.0, 20.0)])
def test_fitted_points_leave_a_strip_at_the_bottom_free(parallel, shape):
    points = np.random.default_rng(3).normal(size=(5000, 3)) * shape
    camera = random_camera(2, parallel=parallel).fitted(points, SIZE, margin=1.0, bottom=60.0)
    pixels = camera.project(points, SIZE)[:, :2]
    low, high = pixels.min(axis=0), pixels.max(axis=0)
    allowed = np.array([SIZE.width, SIZE.height - 60.0])
    assert (low > -1.0).all()
    assert (high < allowed + 1.0).all()
    tight = int(np.argmin(np.minimum(low, allowed - high)))
    assert low[tight] == pytest.approx(allowed[tight] - high[tight], abs=1.0)


@pytest.mark.parametrize("parallel", [False, True])
def test_points_at_the_focal_depth_keep_their_pixels_when_the_picture_becomes_lower(parallel):
    camera, low = random_camera(3, parallel=parallel), ViewportSize(SIZE.width, 0.7 * SIZE.height)
    points = [camera.point_at(x, y, camera.focal_depth, SIZE) for x, y in ((10, 20), (300, 250))]
    resized = camera.resized(SIZE, low)
    np.testing.assert_allclose(
        resized.project(np.array(points), low)[:, :2], [(10, 20), (300, 250)], atol=1e-6
    )
    assert (resized.azimuth, resized.elevation) == (camera.azimuth, camera.elevation)
