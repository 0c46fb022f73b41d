"""Tests of finding a sphere from a seed, in one line and in all: masts, walls, other balls."""

import numpy as np
import pytest

from lispac.errors import Cancelled, InputError, SphereNotFound
from lispac.geometry.radius_search import PointGrid
from lispac.geometry.rotations import rotation_matrix
from lispac.geometry.spheres import Sphere
from lispac.messages import Message
from lispac.targets.plane_finder import FinderSettings
from lispac.targets.sphere_finder import RadiusRange, find_sphere
from lispac.targets.spheres_across_lines import find_spheres_in_lines
from tests.support.balls import BALL, CENTRE, cast, front
from tests.support.error_codes import has_code
from tests.support.long_runs import others_long
from tests.support.message_codes import codes

SETTINGS = FinderSettings()
ANY_RADIUS = RadiusRange()
MAST_TOP = CENTRE - [0.0, 0.0, 0.099]
SCENES = {
    "alone": {},
    "on a mast": {"mast": (MAST_TOP, 0.02)},
    "before a wall": {"wall": 20.6},
    "close to a wall": {"wall": 20.13, "mast": (MAST_TOP, 0.02)},
}


@pytest.mark.parametrize("scene", SCENES)
@pytest.mark.parametrize("searched", [RadiusRange.of_known_radius(0.1), ANY_RADIUS])
@pytest.mark.parametrize("noise", others_long([0.0, 0.002, 0.004], lambda noise: noise == 0.004))
def test_a_ball_is_separated_from_its_surroundings(scene, searched, noise):
    rng = np.random.default_rng(1)
    points, label = cast(rng, [BALL], noise=noise, **SCENES[scene])
    patch = find_sphere(points, front(BALL), searched, SETTINGS)
    on = label[patch.indices] == 0
    off = np.abs(BALL.distances(points[patch.indices]))
    assert on.mean() > 0.98
    assert off.max() < max(4.5 * noise, 0.003)
    # Points beyond 80 degrees (3 % of the visible ball) are excluded, with the mixed pixels there.
    assert np.count_nonzero(on) > 0.85 * np.count_nonzero(label == 0)
    assert patch.rms < 1.1 * noise + 5e-4
    assert 0.3 < patch.share < 0.46
    np.testing.assert_array_equal(patch.indices, np.unique(patch.indices))
    # The noise averages out over hundreds of points; an unknown radius also changes the depth.
    assert np.linalg.norm(patch.centre - CENTRE) < (0.001 if searched.known else 0.003)
    assert abs(patch.sphere.radius - 0.1) < 0.003


@pytest.mark.parametrize("radius", [0.06, 0.0725, 0.15, 0.4])
def test_balls_of_unknown_radius_are_found(radius):
    ball = Sphere(CENTRE, radius)
    points, label = cast(np.random.default_rng(2), [ball], wall=21.0)
    patch = find_sphere(points, front(ball, off=(0.5, 0.5)), ANY_RADIUS, SETTINGS)
    assert abs(patch.sphere.radius - radius) < 0.003
    assert (label[patch.indices] == 0).mean() > 0.98


@pytest.mark.parametrize("searched", [RadiusRange.of_known_radius(0.1), ANY_RADIUS])
@pytest.mark.parametrize(
    "turn_deg", others_long(range(0, 360, 45), lambda turn_deg: turn_deg % 90 == 45)
)
def test_a_seed_on_the_edge_or_slightly_off_the_ball_is_enough(searched, turn_deg):
    points, label = cast(np.random.default_rng(3), [BALL], mast=(MAST_TOP, 0.02), wall=20.6)
    angle = np.radians(turn_deg)
    direction = np.array([np.cos(angle), 0.0, np.sin(angle)])
    for seed in (
        CENTRE + 0.099 * direction,
        CENTRE + 0.14 * direction,
        front(BALL, gap=0.03),
        CENTRE,
    ):
        patch = find_sphere(points, seed, searched, SETTINGS)
        assert np.linalg.norm(patch.centre - CENTRE) < 0.003
        assert (label[patch.indices] == 0).mean() > 0.98


@pytest.mark.parametrize("searched", [RadiusRange.of_known_radius(0.1), ANY_RADIUS])
def test_the_clicked_one_of_two_balls_is_found(searched):
    balls = [BALL, Sphere(CENTRE + [0.21, 0.02, 0.0], 0.1)]
    points, label = cast(np.random.default_rng(4), balls, wall=20.6)
    for k, ball in enumerate(balls):
        for off in ((0.0, 0.0), (-1.0, 0.5), (1.0, 0.3), (0.0, -1.5)):
            patch = find_sphere(points, front(ball, off=off), searched, SETTINGS)
            assert np.linalg.norm(patch.centre - ball.centre) < 0.003, (k, off)
            assert (label[patch.indices] == k).mean() > 0.98


def test_result_is_reproducible_and_independent_of_the_point_order():
    points, _ = cast(np.random.default_rng(5), [BALL], mast=(MAST_TOP, 0.02), wall=20.4)
    points[5] = np.nan
    first = find_sphere(points, front(BALL), ANY_RADIUS, SETTINGS)
    again = find_sphere(
        points.copy(), front(BALL), ANY_RADIUS, SETTINGS, index=PointGrid(points, 0.5)
    )
    np.testing.assert_array_equal(first.indices, again.indices)
    np.testing.assert_array_equal(first.centre, again.centre)
    order = np.random.default_rng(0).permutation(len(points))
    shuffled = find_sphere(points[order], front(BALL), ANY_RADIUS, SETTINGS)
    np.testing.assert_array_equal(np.sort(order[shuffled.indices]), first.indices)
    np.testing.assert_allclose(shuffled.centre, first.centre, rtol=0, atol=1e-9)


def test_large_coordinates_lose_no_accuracy():
    points, _ = cast(np.random.default_rng(6), [BALL], wall=20.4)
    far = np.array([5_400_000.0, -330_000.0, 20.0])
    near, away = (
        find_sphere(points + o, front(BALL) + o, ANY_RADIUS, SETTINGS) for o in (0.0, far)
    )
    np.testing.assert_array_equal(near.indices, away.indices)
    np.testing.assert_allclose(away.centre - far, near.centre, rtol=0, atol=1e-7)


def wall(rng):
    return cast(rng, [], wall=20.0)[0]


def plate(rng):
    points = wall(rng)
    return points[np.linalg.norm(points - CENTRE, axis=1) < 0.08]


def box(rng):
    """Return points of the corner of a box seen from outside (three faces)."""
    faces = rng.uniform(0.0, 0.4, (3, 1500, 3))
    for k in range(3):
        faces[k, :, k] = 0.0
    return CENTRE + faces.reshape(-1, 3) + rng.normal(0.0, 0.002, (4500, 3))


def bush(rng):
    return CENTRE + rng.uniform(-0.3, 0.3, (4000, 3))


def post(radius):
    """Return a function that makes upright posts seen from the side."""
    return lambda rng: cast(rng, [], mast=(CENTRE + [0.0, 0.0, 9.0], radius), wall=21.0)[0]


@pytest.mark.parametrize(
    "make", others_long([wall, plate, box, bush, post(0.03), post(0.06), post(0.1), post(0.2)])
)
@pytest.mark.parametrize("searched", [RadiusRange.of_known_radius(0.1), ANY_RADIUS])
@pytest.mark.parametrize("draw", others_long(range(4)))
def test_objects_that_are_not_balls_are_refused(make, searched, draw):
    points = make(np.random.default_rng(draw))
    seed = points[np.argmin(np.linalg.norm(points - CENTRE, axis=1))]
    with pytest.raises(SphereNotFound, match=r"\.$"):
        find_sphere(points, seed, searched, SETTINGS)


def test_a_shallow_dish_is_refused():
    """An end cap of a tank with a radius of 0.4 m and a half angle of 20 degrees."""
    rng = np.random.default_rng(10)
    ball = Sphere(CENTRE, 0.4)
    points, _ = cast(rng, [ball], mixed=0.0)
    seed = front(ball)
    dish = points[ball.directions(points) @ ball.directions(seed[None])[0] > np.cos(np.radians(20))]
    with pytest.raises(
        SphereNotFound,
        check=has_code("finder.sphere_small_part", share=pytest.approx(0.03, abs=0.005)),
    ):
        find_sphere(dish, seed, ANY_RADIUS, SETTINGS)


def test_an_uneven_plate_within_a_wide_threshold_is_reported_as_flat():
    rng = np.random.default_rng(11)
    points = plate(rng)
    points += rng.normal(0.0, 0.01, (len(points), 1)) * np.array([0.0, 1.0, 0.0])
    with pytest.raises(SphereNotFound, check=has_code("finder.sphere_flat")):
        find_sphere(
            points, CENTRE, RadiusRange.of_known_radius(0.1), FinderSettings(threshold=0.03)
        )


def test_a_small_ball_before_a_large_one_is_found_where_it_was_clicked():
    balls = [Sphere(CENTRE, 0.06), Sphere(CENTRE + [0.35, 0.1, 0.0], 0.28)]
    points, label = cast(np.random.default_rng(12), balls, wall=20.9)
    for k, ball in enumerate(balls):
        patch = find_sphere(points, front(ball), ANY_RADIUS, SETTINGS)
        assert np.linalg.norm(patch.centre - ball.centre) < 0.003
        assert (label[patch.indices] == k).mean() > 0.98


@pytest.mark.parametrize(
    ("points", "seed", "code", "params"),
    [
        (np.zeros((0, 3)), CENTRE, "finder.no_points_near", {"radius": 2.0}),
        (
            np.zeros((500, 3)),
            CENTRE,
            "finder.no_points",
            {"distance": pytest.approx(20.4, abs=0.005)},
        ),
        (np.full((500, 3), np.nan), CENTRE, "finder.no_points_near", {}),
        (np.eye(3)[:2] + CENTRE, CENTRE, "finder.few_points", {"count": 2}),
        (np.zeros((500, 3)), np.zeros(2), "finder.seed", {}),
    ],
)
def test_a_search_without_points_gives_the_reason(points, seed, code, params):
    with pytest.raises(SphereNotFound, check=has_code(code, **params)):
        find_sphere(points, seed, ANY_RADIUS, SETTINGS)


@pytest.mark.parametrize(
    ("offset", "searched", "code"),
    [
        (0.9, RadiusRange.of_known_radius(0.1), "finder.sphere_few_nearby"),
        (0.0, RadiusRange(0.3, 0.5), "finder.sphere_of_radii"),
        (0.0, RadiusRange.of_known_radius(0.14), "finder.sphere_of_radius"),
    ],
)
def test_a_ball_elsewhere_or_of_another_radius_is_refused(offset, searched, code):
    points, _ = cast(np.random.default_rng(7), [BALL])
    with pytest.raises(SphereNotFound) as refused:
        find_sphere(points, CENTRE + [offset, 0.0, 0.0], searched, SETTINGS)
    message = refused.value.message
    parts = [each for each in message.params.values() if isinstance(each, Message)]
    assert code in codes([message, *parts])


@pytest.mark.parametrize("span", [(0.0, 0.1), (0.2, 0.1), (0.1, np.nan), (0.1, np.inf)])
def test_impossible_radii_are_refused(span):
    with pytest.raises(InputError, check=has_code("finder.radii")):
        RadiusRange(*span)


def moved_lines(balls, count=4, *, shift=1.5, tilt_deg=3.0, seed=8):
    """Return the same scene as each line sees it with a wrong boresight."""
    rng = np.random.default_rng(seed)
    clouds, labels, centres = {}, {}, {}
    for k in range(count):
        points, label = cast(rng, balls, mast=(MAST_TOP, 0.02), wall=21.0)
        turn = rotation_matrix(*rng.uniform(-1, 1, 3) * np.radians(tilt_deg) * (k > 0))
        direction = rng.normal(size=3)
        step = direction / np.linalg.norm(direction) * shift * (k > 0)
        clouds[f"L{k + 1}"] = (points - CENTRE) @ turn.T + CENTRE + step
        labels[f"L{k + 1}"] = label
        centres[f"L{k + 1}"] = [(b.centre - CENTRE) @ turn.T + CENTRE + step for b in balls]
    return clouds, labels, centres


@pytest.mark.parametrize("searched", [RadiusRange.of_known_radius(0.1), ANY_RADIUS])
@pytest.mark.parametrize("first_line", ["L1", None])
def test_a_ball_is_found_at_its_position_on_each_line(searched, first_line):
    clouds, labels, centres = moved_lines([BALL])
    clicked = clouds["L1"][np.argmin(np.linalg.norm(clouds["L1"] - front(BALL), axis=1))]
    found, missing = find_spheres_in_lines(
        clouds, clicked, searched, SETTINGS, first_line=first_line
    )
    assert missing == {}
    for name, patch in found.items():
        assert np.linalg.norm(patch.centre - centres[name][0]) < 0.003, name
        assert (labels[name][patch.indices] == 0).mean() > 0.98
        assert patch.rms < 0.003


def test_equal_balls_near_each_other_are_not_swapped():
    balls = [BALL, Sphere(CENTRE + [0.5, 0.05, 0.1], 0.1)]
    clouds, _, centres = moved_lines(balls, 6, shift=0.5)
    for k, ball in enumerate(balls):
        found, missing = find_spheres_in_lines(
            clouds, front(ball), RadiusRange.of_known_radius(0.1), SETTINGS, first_line="L1"
        )
        assert missing == {}
        for name, patch in found.items():
            assert np.linalg.norm(patch.centre - centres[name][k]) < 0.003, (name, k)


def test_a_line_without_the_ball_has_a_reason():
    clouds, _, _ = moved_lines([BALL], 2)
    clouds["away"] = clouds["L1"] + [50.0, 0, 0]
    clouds["empty"] = np.empty((0, 3))
    clouds["wall"] = cast(np.random.default_rng(9), [], wall=21.0)[0]
    found, missing = find_spheres_in_lines(
        clouds, front(BALL), ANY_RADIUS, SETTINGS, first_line="L1"
    )
    assert set(found) == {"L1", "L2"}
    assert set(missing) == {"away", "empty", "wall"}
    assert missing["away"].code == "finder.line_no_points"


def test_a_seed_in_empty_space_or_an_unknown_line_is_refused():
    clouds, _, _ = moved_lines([BALL], 2)
    up = CENTRE + [0, 0, 100]
    with pytest.raises(SphereNotFound, check=has_code("finder.no_sphere_in_lines")):
        find_spheres_in_lines(clouds, up, ANY_RADIUS, SETTINGS)
    with pytest.raises(SphereNotFound, check=has_code("finder.no_points")):
        find_spheres_in_lines(clouds, up, ANY_RADIUS, SETTINGS, first_line="L1")
    with pytest.raises(SphereNotFound, check=has_code("finder.unknown_line", line="L9")):
        find_spheres_in_lines(clouds, CENTRE, ANY_RADIUS, SETTINGS, first_line="L9")
    with pytest.raises(SphereNotFound, check=has_code("finder.no_line_for_sphere")):
        find_spheres_in_lines({}, CENTRE, ANY_RADIUS, SETTINGS)
    with pytest.raises(SphereNotFound, check=has_code("finder.seed")):
        find_spheres_in_lines(clouds, np.zeros(2), ANY_RADIUS, SETTINGS)


def test_the_search_reports_progress_and_can_be_cancelled():
    clouds, _, _ = moved_lines([BALL], 3)
    calls = []
    find_spheres_in_lines(
        clouds, front(BALL), ANY_RADIUS, SETTINGS, first_line="L1",
        progress=lambda fraction, message="": calls.append((fraction, message)),
    )  # fmt: skip
    assert calls[-1][0] == 1.0
    assert "L3" in str(calls[-1][1])

    def cancel(fraction, message=""):
        raise Cancelled

    with pytest.raises(Cancelled):
        find_spheres_in_lines(
            clouds, front(BALL), ANY_RADIUS, SETTINGS, first_line="L1", progress=cancel
        )
