"""Tests of spheres: the fit to a cap, and the visible share of the surface."""

import numpy as np
import pytest

from lispac.errors import SphereNotFound
from lispac.geometry.spheres import Sphere, fit_sphere, rms_from_sphere, visible_share
from tests.support.error_codes import has_code

RADII = [0.05, 0.1, 0.145, 1.0]


def cap(rng, sphere, half_angle_deg, count=400, *, towards=(0.3, -1.0, 0.2), noise=0.0):
    """Return points spread evenly over a cap of a sphere with normal noise of the distance."""
    axis = np.asarray(towards, float) / np.linalg.norm(towards)
    across = np.linalg.svd(axis[None, :])[2][1:]
    height = rng.uniform(np.cos(np.radians(half_angle_deg)), 1.0, count)
    turn = rng.uniform(0.0, 2.0 * np.pi, count)
    level = np.stack([np.cos(turn), np.sin(turn)], axis=1) @ across
    unit = height[:, None] * axis + np.sqrt(1.0 - height**2)[:, None] * level
    return sphere.centre + (sphere.radius + rng.normal(0.0, noise, (count, 1))) * unit


def test_distances_are_signed_and_positive_outside():
    sphere = Sphere(np.array([1.0, 2.0, 3.0]), 0.5)
    points = sphere.centre + np.array([[0.0, 0.0, 0.0], [0.5, 0.0, 0.0], [0.0, -0.8, 0.0]])
    np.testing.assert_allclose(sphere.distances(points), [-0.5, 0.0, 0.3], atol=1e-15)
    assert float(sphere.distances(points[2])) == pytest.approx(0.3)
    np.testing.assert_allclose(sphere.directions(points)[1:], [[1, 0, 0], [0, -1, 0]])


@pytest.mark.parametrize("known", [True, False])
@pytest.mark.parametrize("radius", RADII)
@pytest.mark.parametrize("half_angle_deg", [20, 60, 90, 180])
@pytest.mark.parametrize("origin", [(0, 0, 0), (500_000, 5_000_000, 30)])
def test_a_cap_without_noise_determines_the_sphere_exactly(known, radius, half_angle_deg, origin):
    true = Sphere(np.array(origin, float), radius)
    points = cap(np.random.default_rng(1), true, half_angle_deg)
    sphere = fit_sphere(points, radius if known else None)
    # UTM northings are rounded to about a nanometre, which a small cap magnifies.
    tolerance = 1e-10 if origin == (0, 0, 0) else 2e-8
    np.testing.assert_allclose(sphere.centre, true.centre, rtol=0, atol=tolerance)
    assert sphere.radius == pytest.approx(radius, abs=tolerance)


@pytest.mark.parametrize(("known", "half_angle_deg"), [(True, 40), (True, 85), (False, 85)])
def test_errors_follow_from_error_propagation(known, half_angle_deg):
    """The spread over many draws equals that of first-order error propagation."""
    true = Sphere(np.array([3.0, -20.0, 5.0]), 0.1)
    noise, draws = 0.002, 300
    errors, expected = [], []
    for draw in range(draws):
        points = cap(np.random.default_rng(draw), true, half_angle_deg, 120, noise=noise)
        sphere = fit_sphere(points, 0.1 if known else None)
        errors.append([*(sphere.centre - true.centre), sphere.radius - 0.1])
        rows = np.column_stack([true.directions(points), np.ones(120)])[:, : 3 if known else 4]
        expected.append(np.diag(np.linalg.inv(rows.T @ rows)) * noise**2)
    size = 3 if known else 4
    spread = np.sqrt(np.mean(np.square(errors), axis=0))[:size]
    sigma = np.sqrt(np.mean(expected, axis=0))
    # 300 draws determine an RMS to one part in 24; the tolerance is four of these.
    np.testing.assert_allclose(spread, sigma, rtol=4.0 / np.sqrt(2 * draws))


def test_fit_is_weighted_least_squares():
    rng = np.random.default_rng(4)
    points = cap(rng, Sphere(np.ones(3), 0.1), 80, 300, noise=0.004)
    for radius in (None, 0.1):
        sphere = fit_sphere(points, radius)
        best = rms_from_sphere(sphere, points)
        for nudge in rng.normal(0, 1e-4, (30, 4)):
            longer = sphere.radius + (nudge[3] if radius is None else 0.0)
            assert rms_from_sphere(Sphere(sphere.centre + nudge[:3], longer), points) > best
        doubled = fit_sphere(np.concatenate([points, points[:100]]), radius)
        weighted = fit_sphere(points, radius, np.where(np.arange(300) < 100, 2.0, 1.0))
        np.testing.assert_allclose(weighted.centre, doubled.centre, rtol=0, atol=1e-10)
        again = fit_sphere(points, radius, start=Sphere(sphere.centre + 0.03, 0.08))
        np.testing.assert_allclose(again.centre, sphere.centre, rtol=0, atol=1e-9)


def flat(rng, noise):
    return np.column_stack([rng.uniform(-0.1, 0.1, (200, 2)), rng.normal(0.0, noise, 200)])


@pytest.mark.parametrize(
    ("points", "radius", "code"),
    [
        (np.eye(3), None, "target.sphere_few_points"),
        (np.eye(3), 0.1, "target.sphere_few_points"),
        (flat(np.random.default_rng(0), 0.0), None, "target.sphere_in_plane"),
        (flat(np.random.default_rng(0), 0.0), 0.5, "target.sphere_in_plane"),
        (np.outer(np.arange(9.0), [1, 2, 3]), 0.5, "target.sphere_in_plane"),
        (np.zeros((9, 3)), 0.5, "target.sphere_in_plane"),
        (np.full((9, 3), np.nan), None, "target.sphere_not_finite"),
        (flat(np.random.default_rng(0), 0.003), None, "target.sphere_little_curved"),
        (flat(np.random.default_rng(0), 0.003), 0.5, "target.sphere_side"),
        (np.eye(4)[:, :3], 0.0, "target.sphere_radius"),
        (np.eye(4)[:, :3], np.nan, "target.sphere_radius"),
    ],
)
def test_points_that_determine_no_sphere_are_refused(points, radius, code):
    with pytest.raises(SphereNotFound, check=has_code(code)):
        fit_sphere(points, radius)


def centre_or_reason(points, radius=None):
    try:
        return fit_sphere(points, radius).centre
    except SphereNotFound as error:
        return error.code


def test_a_known_radius_helps_where_a_free_one_is_undetermined():
    """The cap of a ball of 0.1 m with a half angle of 8 degrees is 1 mm high."""
    true = Sphere(np.zeros(3), 0.1)
    help_count = 0
    for draw in range(50):
        points = cap(np.random.default_rng(draw), true, 8, 100, noise=0.001)
        free, known = centre_or_reason(points), centre_or_reason(points, 0.1)
        if isinstance(known, str):
            assert known == "target.sphere_side"
        else:  # never on the wrong side, with an error of 0.2 m
            assert np.linalg.norm(known) < 0.01
            help_count += isinstance(free, str) and free == "target.sphere_little_curved"
    assert help_count > 20


@pytest.mark.parametrize("half_angle_deg", [20, 45, 90, 150])
def test_visible_share_is_that_of_the_cap(half_angle_deg):
    sphere = Sphere(np.array([5.0, 6.0, 7.0]), 0.2)
    points = cap(np.random.default_rng(6), sphere, half_angle_deg, 20_000)
    expected = (1.0 - np.cos(np.radians(half_angle_deg))) / 2.0
    assert visible_share(sphere, points) == pytest.approx(expected, rel=0.01)
    assert visible_share(sphere, points[:2]) == 0.0
    assert visible_share(sphere, points[:0]) == 0.0


@pytest.mark.parametrize("scale", [1e-9, 1e9])
@pytest.mark.parametrize("radius", [None, 0.1])
def test_only_the_ratios_of_weights_matter(scale, radius):
    rng = np.random.default_rng(8)
    points = cap(rng, Sphere(np.array([3.0, -20.0, 5.0]), 0.1), 60, noise=0.001)
    weights = rng.uniform(0.5, 2.0, len(points))
    one, other = fit_sphere(points, radius, weights), fit_sphere(points, radius, scale * weights)
    np.testing.assert_allclose(other.centre, one.centre, rtol=0, atol=1e-10)
    assert other.radius == pytest.approx(one.radius, abs=1e-10)


@pytest.mark.parametrize("side", [1.0, -1.0])
@pytest.mark.parametrize("seed", range(3))
def test_a_cap_with_more_noise_than_curvature_is_refused(seed, side):
    """A 5 cm cap of a ball of 1 m is 0.3 mm high; the noise is 2 mm."""
    rng = np.random.default_rng(seed)
    points = rng.uniform(-0.025, 0.025, (30, 3)) * [1, 1, 0]
    points[:, 2] = side * (rng.normal(0, 0.002, 30) - (points**2).sum(axis=1) / 2)
    with pytest.raises(SphereNotFound, check=has_code("target.sphere_side")):
        fit_sphere(points, 1.0)
