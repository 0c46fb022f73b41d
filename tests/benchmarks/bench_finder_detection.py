"""Compare time and quality of the detection of planes with Open3D.

Region growing and Open3D's detector and plane segmentation run on the same clouds. Run with
``pytest -s tests/benchmarks/bench_finder_detection.py``.
"""

import time

import numpy as np
import open3d
import pytest

from lispac.geometry.radius_search import points_within
from lispac.simulation.simulated_survey import SimulatedSurvey, port_survey
from lispac.targets.flat_patches import find_flat_patches
from lispac.targets.plane_detection import COARSE_VOXEL_SIDE, detect_planes
from lispac.targets.plane_finder import FinderSettings, find_plane
from tests.simulation.test_simulation import placed
from tests.support.finder_scenes import precision_and_recall
from tests.targets.test_finder_sites import scenery


def test_the_target_around_a_seed() -> None:
    print(f"\n{'scene':17s}{'method':28s}{'ms':>8s}{'precision':>11s}{'recall':>8s}")
    for name in ("5 cm proud", "similar targets", "bollard", "grazing"):
        scene_site = scenery(name)
        cloud, truth = scene_site.clouds()["L1"], scene_site.on("L1", "T1")
        seed = cloud[truth][np.argmin(np.linalg.norm(cloud[truth] - cloud[truth].mean(0), axis=1))]
        near = points_within(cloud, seed, 2.0)
        points, on = cloud[near], truth[near]
        theirs = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(points))

        def ours(points=points, seed=seed):
            return find_plane(points, seed, FinderSettings()).indices

        def segmented(theirs=theirs):
            return np.asarray(theirs.segment_plane(0.01, 3, 1000)[1])

        def boxed(theirs=theirs, points=points, seed=seed):
            """Indices of the points within 10 mm of the box nearest to the seed."""
            theirs.estimate_normals(open3d.geometry.KDTreeSearchParamKNN(30))
            boxes = theirs.detect_planar_patches(
                normal_variance_threshold_deg=30, coplanarity_deg=75, outlier_ratio=0.75,
                min_plane_edge_length=0.3, min_num_points=30,
            )  # fmt: skip
            if not boxes:
                return np.empty(0, dtype=np.int64)
            inside = [(np.abs((points - b.center) @ b.R) - b.extent / 2) for b in boxes]
            at_seed = [np.max(np.abs((seed - b.center) @ b.R) - b.extent / 2) for b in boxes]
            return np.flatnonzero((inside[int(np.argmin(at_seed))] < 0.01).all(axis=1))

        for method, work in (
            ("here", ours), ("Open3D segment_plane", segmented),
            ("Open3D detect_planar_patches", boxed),
        ):  # fmt: skip
            work()
            start = time.perf_counter()
            indices = work()
            took = time.perf_counter() - start
            precision, recall = precision_and_recall(indices, on)
            print(f"{name:12s}{method:28s}{1000 * took:8.0f}{precision:11.3f}{recall:8.3f}")


@pytest.fixture(scope="module")
def port() -> SimulatedSurvey:
    return port_survey()


def test_all_planes_of_a_line(port: SimulatedSurvey) -> None:
    cloud = placed(port, port.lines[0])
    find_flat_patches(cloud[::50], 0.01, voxel=COARSE_VOXEL_SIDE)
    start = time.perf_counter()
    flat = find_flat_patches(cloud, 0.01, voxel=COARSE_VOXEL_SIDE)
    ours = time.perf_counter() - start
    start = time.perf_counter()
    theirs = open3d.geometry.PointCloud(open3d.utility.Vector3dVector(flat.thinned))
    theirs.estimate_normals(open3d.geometry.KDTreeSearchParamKNN(12))
    boxes = theirs.detect_planar_patches(
        normal_variance_threshold_deg=30, coplanarity_deg=75, outlier_ratio=0.75,
        min_plane_edge_length=0.5, min_num_points=30,
    )  # fmt: skip
    open3ds = time.perf_counter() - start
    known = port.targets | port.validation
    print(f"\none line, {len(cloud):,} points, {len(flat.thinned):,} after thinning")
    for name, seconds, centres in (
        ("here", ours, [patch.centre for patch in flat.patches]),
        ("Open3D detect_planar_patches", open3ds, [box.center for box in boxes]),
    ):
        hit = [
            key for key, place in known.items()
            if min(np.linalg.norm(place - centre) for centre in centres) < 0.5
        ]  # fmt: skip
        print(f"  {name:28s} {seconds:6.2f} s, {len(centres)} patches, centres of {hit}")


def test_detection_in_six_lines(port: SimulatedSurvey) -> None:
    """Aim: under 20 s for six lines of a million points."""
    dense = port_survey(points_per_second=500_000.0)
    clouds = {line.name: placed(dense, line, np.zeros(3)) for line in dense.lines}
    start = time.perf_counter()
    planes = detect_planes(clouds, FinderSettings())
    took = time.perf_counter() - start
    count = sum(map(len, clouds.values()))
    print(f"\nsix lines, {count:,} points: {len(planes)} planes in {took:.1f} s (aim 20 s)")
