"""Places of a reference, and how they move: against made walls and central differences."""

import numpy as np

from lispac.adjustment.sensitivity import sensitivity
from lispac.geometry.rotations import rotation_matrix
from lispac.survey.georeferencing import Mounting
from lispac.survey.trajectory import Poses
from lispac.validation.reference_places import at_points, on_surface


def test_what_is_far_off_before_is_kept_beside_what_is_not() -> None:
    """A near wall 20 mm off, and a tenth as many places of a far one 300 mm off."""
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
    found = on_surface(
        line, line, reference, cores, facing=np.tile((0.0, -1.0, 0.0), (len(cores), 1)),
        diameters=np.full(len(cores), 0.4), reach=1.0, roughest=0.015,
    ).before  # fmt: skip
    assert len(found.at) == len(cores)
    expected = np.where(cores[:, 1] > 30.0, 0.3, 0.02)
    np.testing.assert_allclose(found.distance, expected, atol=0.004)


def test_the_interval_at_a_surveyed_point_holds_what_it_says() -> None:
    """93 to 97 % of 1,000 points a millimetre to two centimetres before a noisy wall."""
    rng, held = np.random.default_rng(5), []
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
        found = at_points(wall, wall, place, facing=facing, **how).after
        held.append(abs(found.distance[0] - offset) <= found.half_width[0])
    assert abs(np.mean(held) - 0.95) <= 0.02


def test_derivatives_are_those_of_the_thesis_equation() -> None:
    """X = P + R(attitude) (R(boresight) x + lever arm), by central differences."""
    rng = np.random.default_rng(1)
    points = rng.uniform(-20, 20, (5, 3))
    position, attitude = rng.uniform(-50, 50, (5, 3)), rng.uniform(-0.3, 0.3, (5, 3))
    values = np.array([0.02, -0.03, 0.05, 0.3, -0.1, 2.0, 0, 0, 0])
    normals = rng.normal(size=(5, 3))
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)

    def placed(k: int, x: np.ndarray) -> float:
        pose, turn, seen, mounting = x[:3], x[3:6], x[6:9], x[9:15]
        body = rotation_matrix(*mounting[:3]) @ seen + mounting[3:]
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
