"""Time to find a sphere from a seed in one line and in six lines of a million points.

Run with ``pytest -s tests/benchmarks/bench_sphere_finder.py``.
"""

import numpy as np
from numpy.typing import NDArray

from lispac.errors import SphereNotFound
from lispac.geometry.radius_search import PointGrid
from lispac.targets.plane_finder import FinderSettings
from lispac.targets.sphere_finder import RadiusRange, find_sphere
from lispac.targets.spheres_across_lines import find_spheres_in_lines
from tests.benchmarks.bench_finder import median_time

Array = NDArray[np.float64]
CENTRE = np.array([0.0, 20.0, 4.0])
RADIUS = 0.1


def line(rng: np.random.Generator, points: int) -> tuple[Array, Array, Array]:
    """Simulate a quay wall 60 m long and a sphere on a mast 0.6 m in front of it, displaced.

    Returns the points, whether each is on the sphere, and the centre of the sphere.
    """
    turn, height = rng.uniform(0, np.pi, 400), rng.uniform(-1, 1, 400)
    level = np.sqrt(1 - height**2)
    facing = np.stack([level * np.cos(turn), -level * np.sin(turn), height], axis=1)
    ball = CENTRE + RADIUS * facing
    mast = CENTRE + rng.uniform([-0.02, 0, -1.5], [0.02, 0, -0.1], (700, 3))
    wall = rng.uniform([-30, 20.6, -2], [30, 20.6, 6], (points - 1100, 3))
    cloud = np.concatenate([ball, mast, wall]) + rng.normal(0, 0.002, (points, 3))
    order, moved = rng.permutation(points), rng.uniform(-0.5, 0.5, 3)
    return (cloud + moved)[order], order < 400, CENTRE + moved


def test_seed_to_sphere_in_a_million_points() -> None:
    rng = np.random.default_rng(1)
    lines = {f"L{k}": line(rng, 1_000_000) for k in range(1, 7)}
    clouds = {name: cloud for name, (cloud, _, _) in lines.items()}
    grids = {name: PointGrid(cloud) for name, cloud in clouds.items()}
    cloud, ball, centre = lines["L1"]
    seed = cloud[ball][np.argmin(cloud[ball][:, 1])]
    on_wall = centre + [5.0, 0.6, 0.0]
    settings = FinderSettings()

    def refused(searched: RadiusRange) -> None:
        try:
            find_sphere(cloud, on_wall, searched, settings)
        except SphereNotFound:
            return
        raise AssertionError("a ball was found on the bare wall")

    for words, searched in (
        ("known", RadiusRange.of_known_radius(RADIUS)),
        ("free", RadiusRange()),
    ):
        read = median_time(lambda s=searched: find_sphere(cloud, seed, s, settings))
        cells = median_time(
            lambda s=searched: find_sphere(cloud, seed, s, settings, index=grids["L1"])
        )
        none = median_time(lambda s=searched: refused(s))
        six = median_time(
            lambda s=searched: find_spheres_in_lines(
                clouds, seed, s, settings, first_line="L1", indices=grids
            ),
            3,
        )
        patch = find_sphere(cloud, seed, searched, settings)
        found, missing = find_spheres_in_lines(clouds, seed, searched, settings, first_line="L1")
        assert missing == {}
        worst = max(np.linalg.norm(found[name].centre - lines[name][2]) for name in found)
        print(f"\nradius {words}, line of 1 M points")
        print(f"  one line, whole cloud read       {1000 * read:6.1f} ms")
        print(f"  one line, prepared cells         {1000 * cells:6.1f} ms")
        print(f"  seed on the bare wall: refused   {1000 * none:6.1f} ms")
        print(f"  six lines, prepared cells        {1000 * six:6.1f} ms")
        print(
            f"  {len(patch.indices)} points, precision {ball[patch.indices].mean():.4f}, recall "
            f"{ball[patch.indices].sum() / ball.sum():.4f}, radius "
            f"{1000 * patch.sphere.radius:.1f} mm, "
            f"centre at worst {1000 * worst:.1f} mm off in the six lines"
        )
