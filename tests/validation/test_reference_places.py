"""Tests of distances to a reference and their derivatives, on synthetic walls."""

import numpy as np
import pytest

from lispac.adjustment.model.point_sensitivity import sensitivity
from lispac.errors import NotComparable
from lispac.geometry.rotations import rotation_matrix
from lispac.survey.georeferencing import Mounting
from lispac.survey.trajectory import Poses
from lispac.validation.reference_places import measure_to_points, measure_to_surface
from tests.support.error_codes import has_code


def test_places_with_large_distances_before_are_kept() -> None:
    """A near wall is 20 mm off; a far one with a tenth as many places is 300 mm off."""
    rng = np.random.default_rng(2)

    def wall(west: float, width: float, off: float) -> tuple[np.ndarray, np.ndarray]:
        count = int(400 * width)
        flat = np.column_stack(
            [rng.uniform(0, width, count), np.full(count, west), rng.uniform(0, 2, count)]
        )
        return flat, flat - np.outer(off + rng.normal(0.0, 0.003, count), (0.0, 1.0, 0.0))

    (near, line_near), (far, line_far) = wall(10.0, 40.0, 0.02), wall(60.0, 4.0, 0.3)
    reference, line = np.concatenate([near, far]), np.concatenate([line_near, line_far])
    cores = np.array([(x, w, z) for w, n in ((10.0, 40), (60.0, 4))
                      for x in np.arange(0.5, n, 0.5) for z in (0.5, 1.0, 1.5)])  # fmt: skip
    found = measure_to_surface(
        line, line, reference, cores, facing=np.tile((0.0, -1.0, 0.0), (len(cores), 1)),
        diameters=np.full(len(cores), 0.4), reach=1.0, roughest=0.015,
    ).before  # fmt: skip
    assert len(found.at) == len(cores)
    expected = np.where(cores[:, 1] > 30.0, 0.3, 0.02)
    np.testing.assert_allclose(found.distance, expected, atol=0.004)


def test_interval_at_a_surveyed_point_has_its_nominal_coverage() -> None:
    """93 to 97 % of 1,000 points that lie 1 to 20 mm in front of a noisy wall."""
    rng, is_covered = np.random.default_rng(5), []
    place, facing = np.array([[0.02, 15.0, 4.0]]), np.array([[0.0, -15.0, -3.0]])
    for k in range(1000):
        offset = (0.001, 0.005, 0.02)[k % 3]
        wall = np.column_stack(
            [
                rng.uniform(-0.5, 0.5, 400),
                15.0 - rng.normal(offset, 0.003, 400),
                rng.uniform(3.5, 4.5, 400),
            ]
        )
        how = {"diameters": np.array([0.3]), "reach": 1.0, "roughest": 0.015}
        found = measure_to_points(wall, wall, place, facing=facing, **how).after
        is_covered.append(abs(found.distance[0] - offset) <= found.half_width[0])
    assert abs(np.mean(is_covered) - 0.95) <= 0.02


WALL = np.array([(0.5, 15.0, 4.0), (1.0, 15.0, 4.0), (1.5, 15.0, 4.0)])
"""Places on a wall 15 m west, which faces the vessel at the origin."""


def _wall(east_of: float = 0.0, north: tuple[float, float] = (0.0, 2.0)) -> np.ndarray:
    """Return an even grid of points on the wall, or `east_of` metres in front of it."""
    x, z = np.meshgrid(np.arange(*north, 0.02), np.arange(3.4, 4.6, 0.02))
    return np.column_stack([x.ravel(), np.full(x.size, 15.0 - east_of), z.ravel()])


def _on_surface(before: np.ndarray, after: np.ndarray) -> np.ndarray:
    return measure_to_surface(
        before, after, _wall(), WALL, facing=np.tile((0.0, -1.0, 0.0), (3, 1)),
        diameters=np.full(3, 0.3), reach=1.0, roughest=0.015,
    ).after.at  # fmt: skip


def _at_points(before: np.ndarray, after: np.ndarray) -> np.ndarray:
    return measure_to_points(
        before, after, WALL, facing=-WALL, diameters=np.full(3, 0.3), reach=0.3, roughest=0.015
    ).after.at


@pytest.mark.parametrize("state", ["before", "after"])
def test_a_line_out_of_reach_of_the_surface_is_reported(state: str) -> None:
    lines = {"before": _wall(0.01), "after": _wall(0.01), state: _wall(5.0)}
    with pytest.raises(NotComparable, check=has_code("validation.line_out_of_reach")):
        _on_surface(lines["before"], lines["after"])


def test_surveyed_points_need_line_points_around_their_foot() -> None:
    """Only the first point has them: the others lie beyond the edge or have too few."""
    ends = _wall(
        0.01, (0.0, 0.8)
    )  # ends 0.2 m from the second place: within reach, but not around it
    few = _wall(0.01, (1.3, 1.7))[::200]
    np.testing.assert_array_equal(_at_points(ends, ends), [0])
    np.testing.assert_array_equal(_at_points(np.vstack([ends, few]), ends), [0])
    thin = _wall(0.01, (0.0, 0.5))
    np.testing.assert_array_equal(_at_points(thin, thin), [0])


def test_a_larger_area_is_used_for_sparse_profiles() -> None:
    """Profiles are 0.2 m apart: one lies within 0.3 m of a point, three within 0.51 m."""
    profiles = np.vstack([_wall(0.01, (x, x + 0.01)) for x in np.arange(0.1, 2.0, 0.2)])
    np.testing.assert_array_equal(_at_points(profiles, profiles), [0, 1, 2])


def test_a_line_far_from_all_surveyed_points_is_reported() -> None:
    with pytest.raises(NotComparable, check=has_code("validation.no_flat_point")):
        _at_points(_wall(0.7), _wall(0.7))


def test_places_seen_only_before_or_only_after_are_reported() -> None:
    south, north = _wall(0.01, (0.0, 0.8)), _wall(0.01, (1.2, 2.0))
    with pytest.raises(NotComparable, check=has_code("validation.no_place_in_both")):
        _at_points(south, north)


def test_derivatives_match_central_differences() -> None:
    """X = P + R(attitude) (R(boresight) x + lever arm), the equation of the thesis."""
    rng = np.random.default_rng(1)
    points = rng.uniform(-20, 20, (5, 3))
    position, attitude = rng.uniform(-50, 50, (5, 3)), rng.uniform(-0.3, 0.3, (5, 3))
    values = np.array([0.02, -0.03, 0.05, 0.3, -0.1, 2.0, 0, 0, 0])
    normals = rng.normal(size=(5, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)

    def placed(k: int, x: np.ndarray) -> float:
        pose, turn, point, mounting = x[:3], x[3:6], x[6:9], x[9:15]
        body = rotation_matrix(*mounting[:3]) @ point + mounting[3:]
        return float(normals[k] @ (pose + rotation_matrix(*turn) @ body))

    found = sensitivity(points, Poses(position, attitude), Mounting.of_values(values), normals)
    for k in range(5):
        x = np.concatenate([position[k], attitude[k], points[k], values[:6]])
        steps = 1e-6 * np.eye(15)
        numeric = [(placed(k, x + s) - placed(k, x - s)) / 2e-6 for s in steps]
        analytic = np.concatenate(
            [
                found.by_position[k],
                found.by_attitude[k],
                found.by_lidar[k],
                found.by_mounting[k, :6],
            ]
        )
        np.testing.assert_allclose(analytic, numeric, atol=1e-6)
