"""Time of cloud-to-cloud distances with a local plane, for a million points each.

CloudCompare and Open3D (nearest point only) are run on the same clouds where they are installed.
Run with ``pytest tests/benchmarks``.
"""

import os
import re
import resource
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from lispac.validation.cloud_distance import cloud_to_cloud
from lispac.validation.plane_comparison import compare_plane

Array = NDArray[np.float64]
AIM_SECONDS = 2.5


def wall(n: int, seed: int, offset: float) -> Array:
    """Return a noisy wall of 10 x 10 m."""
    rng = np.random.default_rng(seed)
    points = rng.uniform(0, 10, (n, 3))
    points[:, 1] = rng.normal(offset, 0.003, n)
    return points


def tower(n: int, seed: int, offset: float) -> Array:
    """Return four noisy walls of 6 x 40 m, moved outwards."""
    rng = np.random.default_rng(seed)
    side, along, height = rng.integers(0, 4, n), rng.uniform(0, 6, n), rng.uniform(0, 40, n)
    depth = rng.normal(offset, 0.005, n)
    x = np.choose(side, [along, along, -depth, 6 + depth])
    y = np.choose(side, [-depth, 6 + depth, along, along])
    return np.column_stack((x, y, height))


def median_seconds(run: Callable[[], object], rounds: int = 3) -> float:
    """Return the median time of some runs."""
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        run()
        times.append(time.perf_counter() - start)
    return float(np.median(times))


def cloudcompare_seconds(compared: Array, reference: Array, level: int) -> tuple[float, float]:
    """Return the seconds and the mean distance (metres) printed by CloudCompare.

    The octree level is given, because version 2.11 does not finish on the tower if it chooses the
    level.
    """
    with tempfile.TemporaryDirectory() as folder:
        for name, points in (("compared", compared), ("reference", reference)):
            np.savetxt(Path(folder) / f"{name}.asc", points, fmt="%.6f")
        program = shutil.which("CloudCompare")
        assert program is not None
        done = subprocess.run(
            [program, "-SILENT", "-C_EXPORT_FMT", "BIN", "-O", "compared.asc",
             "-O", "reference.asc", "-C2C_DIST", "-MODEL", "LS", "KNN", "6",
             "-OCTREE_LEVEL", str(level)],
            cwd=folder,
            env=os.environ | {"QT_QPA_PLATFORM": "offscreen", "XDG_RUNTIME_DIR": folder},
            capture_output=True,
            text=True,
            check=True,
            timeout=300,
        )  # fmt: skip
    printed = done.stdout + done.stderr
    seconds = sum(float(s) for s in re.findall(r"Distances\] Time: ([\d.]+) s", printed))
    mean = re.search(r"Mean distance = ([\d.]+)", printed)
    assert mean is not None
    return seconds, float(mean.group(1))


def open3d_seconds(compared: Array, reference: Array) -> float:
    """Return the time of Open3D for distances to the nearest point, without a plane."""
    import open3d

    clouds = [
        open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points))
        for points in (compared, reference)
    ]
    return median_seconds(lambda: clouds[0].compute_point_cloud_distance(clouds[1]))


@pytest.mark.parametrize("make", [wall, tower])
def test_one_million_on_one_million(make: Callable[[int, int, float], Array]) -> None:
    cloud_to_cloud(make(100, 1, 0.0), make(100, 2, 0.0))  # compile
    n = 1_000_000
    compared, reference = make(n, 1, 0.01), make(n, 2, 0.0)
    ours = median_seconds(lambda: cloud_to_cloud(compared, reference))
    mean = cloud_to_cloud(compared, reference).mean()
    print(
        f"\n{make.__name__}, {n:,} on {n:,}: {ours:.2f} s (aim {AIM_SECONDS} s), "
        f"mean {1e3 * mean:.3f} mm"
    )
    if shutil.which("CloudCompare"):
        theirs, mean = cloudcompare_seconds(compared, reference, level=9)
        print(
            f"    CloudCompare {theirs:.2f} s without its octrees, mean {1e3 * mean:.3f} mm: "
            f"ours takes {ours / theirs:.2f} of it"
        )
    try:
        nearest = open3d_seconds(compared, reference)
    except ImportError as error:
        print(f"    Open3D cannot be loaded: {error}")
    else:
        print(f"    Open3D, nearest point only, {nearest:.2f} s: ours takes {ours / nearest:.2f}")


def test_cost_by_size() -> None:
    """Time should be proportional to the number of points; memory is the peak of the process."""
    cloud_to_cloud(tower(100, 1, 0.0), tower(100, 2, 0.0))  # compile
    for n in (100_000, 1_000_000, 10_000_000):
        compared, reference = tower(n, 1, 0.01), tower(n, 2, 0.0)
        start = time.perf_counter()
        cloud_to_cloud(compared, reference)
        elapsed = time.perf_counter() - start
        peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 2**20
        print(
            f"\n{n:,} on {n:,}: {elapsed:.2f} s, {1e6 * elapsed / n:.2f} us a point, {peak:.1f} GB"
        )


def test_one_plane_on_six_lines() -> None:
    for points in (10_000, 100_000):
        lines = {f"L{i}": wall(points, i, 0.002 * i) for i in range(6)}
        headings = dict(zip(lines, np.radians([0, 180, 45, 225, 315, 135]).tolist(), strict=True))
        start = time.perf_counter()
        compare_plane("V1", lines, lines, headings)
        elapsed = time.perf_counter() - start
        print(f"\none plane, six lines of {points:,} points, 15 pairs: {elapsed:.2f} s")
