"""Time to find a plane from a seed in six lines, and to find neighbours with and without a grid.

Open3D's plane segmentation runs on the same neighbourhood. Run with
``pytest -s tests/benchmarks/bench_finder.py``.
"""

import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.radius_search import PointGrid, points_within
from lispac.targets.plane_finder import FinderSettings, find_plane
from lispac.targets.planes_across_lines import find_in_lines

Array = NDArray[np.float64]
CENTRE = np.array([0.0, 20.0, 4.0])
AIM_SECONDS = 0.5


def median_time(work: Callable[[], object], rounds: int = 5) -> float:
    """Median time of some runs, s, after a first run that compiles."""
    work()
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return float(np.median(times))


def line(rng: np.random.Generator, points: int) -> tuple[Array, Array]:
    """Simulate a quay wall 60 m long with a board of 1.22 x 1.22 m above it.

    Returns the points, displaced at random by up to half a metre, and whether each is on the board.
    """
    board = CENTRE + rng.uniform(-0.61, 0.61, (2500, 3)) * [1, 0, 1]
    wall = rng.uniform([-30, 20.3, -2], [30, 20.3, 3.2], (points - len(board) - 5000, 3))
    posts = rng.uniform([-1.9, 20, 3.2], [-1.7, 20.2, 5], (5000, 3))
    cloud = np.concatenate([board, posts, wall]) + rng.normal(0, 0.002, (points, 3))
    order = rng.permutation(points)
    return (cloud + rng.uniform(-0.5, 0.5, 3))[order], order < len(board)


def test_seed_to_planes_in_six_lines_of_a_million_points() -> None:
    rng = np.random.default_rng(1)
    lines = {f"L{k}": line(rng, 1_000_000) for k in range(1, 7)}
    clouds = {name: cloud for name, (cloud, _) in lines.items()}
    first = clouds["L1"]
    seed = first[lines["L1"][1]].mean(axis=0)
    start = time.perf_counter()
    PointGrid(first[:1000])
    compiled = time.perf_counter() - start
    prepared = median_time(lambda: [PointGrid(cloud) for cloud in clouds.values()], 3)
    grids = {name: PointGrid(cloud) for name, cloud in clouds.items()}
    settings = FinderSettings()
    plain = median_time(lambda: find_in_lines(clouds, seed, settings, first_line="L1"))
    cells = median_time(
        lambda: find_in_lines(clouds, seed, settings, first_line="L1", indices=grids)
    )
    anywhere = median_time(lambda: find_in_lines(clouds, seed, settings, indices=grids))
    found, missing = find_in_lines(clouds, seed, settings, first_line="L1")
    assert missing == {}
    print(f"\nsix lines of 1 M points, one seed (aim {AIM_SECONDS} s)")
    print(f"  clicked line known, whole clouds read  {plain:.3f} s")
    print(f"  clicked line known, prepared cells     {cells:.3f} s")
    print(f"  clicked line unknown, prepared cells   {anywhere:.3f} s")
    print(f"  preparing the cells of six lines       {prepared:.3f} s (first use {compiled:.1f} s)")
    for name, patch in found.items():
        board = lines[name][1]
        print(
            f"  {name}: {len(patch.indices)} points, precision {board[patch.indices].mean():.4f}, "
            f"recall {board[patch.indices].sum() / board.sum():.4f}, "
            f"rms {1000 * patch.rms:.1f} mm"
        )


def test_points_in_a_sphere_of_a_long_line() -> None:
    cloud, _ = line(np.random.default_rng(2), 10_000_000)
    grid = PointGrid(cloud)
    scan = median_time(lambda: points_within(cloud, CENTRE, 2.0), 3)
    cells = median_time(lambda: grid.within(CENTRE, 2.0), 3)
    build = median_time(lambda: PointGrid(cloud), 1)
    print(f"\nsphere of 2 m in 10 M points: read through {1000 * scan:.1f} ms, ", end="")
    print(f"prepared cells {1000 * cells:.2f} ms (prepared in {build:.2f} s)")


def test_one_plane_beside_open3d() -> None:
    import open3d

    cloud, board = line(np.random.default_rng(3), 1_000_000)
    seed = cloud[board].mean(axis=0)
    near = points_within(cloud, seed, 2.0)
    settings = FinderSettings()
    ours = median_time(lambda: find_plane(cloud[near], seed, settings))
    patch = find_plane(cloud[near], seed, settings)
    theirs_cloud = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(cloud[near]))
    open3d.utility.random.seed(0)

    def segment() -> NDArray[np.int64]:
        _, inliers = theirs_cloud.segment_plane(0.01, 3, 1000)
        return np.asarray(inliers)

    theirs = median_time(segment)
    segmented = segment()
    theirs_cloud.estimate_normals()
    patches = median_time(lambda: theirs_cloud.detect_planar_patches(), 1)
    truth = board[near]
    print(f"\none plane among {len(near)} points around the seed")
    for name, seconds, indices in (
        ("here", ours, patch.indices),
        ("Open3D segment_plane", theirs, segmented),
    ):
        print(
            f"  {name:22s} {1000 * seconds:7.1f} ms, precision {truth[indices].mean():.4f}, "
            f"recall {truth[indices].sum() / truth.sum():.4f}"
        )
    print(f"  Open3D detect_planar_patches {1000 * patches:.1f} ms, all planes, no points")
