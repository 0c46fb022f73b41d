"""Tests of regions and samples of lines after a change of the mounting, and of displacements."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.geometry.frames import LocalFrame
from lispac.survey import cloud as cloud_module
from lispac.survey.cloud import Cloud, CloudInMemory, CloudOnDisk, place_clouds
from lispac.survey.georeferencing import Georeferencer, Mounting, place_points
from lispac.survey.scan import Scan
from lispac.survey.store.line_import import write_store
from lispac.survey.store.spatial_cells import is_number_in_sample
from lispac.survey.store.stored_line import open_store
from lispac.survey.trajectory import LocalTrajectory
from tests.support.store_lines import RECIPE, Line, small

__all__ = ["small"]
pytestmark = pytest.mark.usefixtures("small")

COUNT = 6_300
PRIOR = Mounting(np.array([0.2, 0.1, 0.5]), np.radians([1.0, -2.0, 3.0]))
OTHER = Mounting(np.array([0.25, 0.1, 0.4]), np.radians([1.5, -1.5, 3.4]), 0.03, 1e-3, 0.02)
TIME = np.linspace(-1.0, 21.0, 441)
TRACK = LocalTrajectory(
    LocalFrame(0.8, -1.2, 0.0), TIME, np.column_stack([0.9 * TIME, np.sin(TIME), 0 * TIME]),
    np.column_stack([0.1 * np.sin(TIME), 0.05 * np.cos(TIME), 0.3 * np.sin(0.2 * TIME)]),
)  # fmt: skip


@pytest.fixture
def clouds(tmp_path: Path) -> dict[str, Cloud]:
    """The same line in memory and on disk, with the coordinates of the store."""
    line = Line(COUNT)
    line.xyz = line.xyz.astype(np.float32).astype(float)
    scan = Scan(line.xyz, line.time, line.extra["intensity"].astype(float))
    where = Georeferencer.of(TRACK, PRIOR)
    recipe = replace(RECIPE, placed_with={"mounting": PRIOR.values.tolist()})
    write_store(tmp_path, recipe, line.pieces(1500), where)
    return {
        "memory": CloudInMemory.of(scan, TRACK, PRIOR),
        "disk": CloudOnDisk(open_store(tmp_path, "L1"), where),
    }


def reference(cloud: Cloud, mounting: Mounting) -> np.ndarray:
    """All points of the line by the reference formula, in the order of the file."""
    line = Line(COUNT)
    xyz = line.xyz.astype(np.float32).astype(float)
    return place_points(xyz, TRACK.at(line.time + mounting.latency), mounting)


@pytest.mark.parametrize("mounting", [PRIOR, OTHER], ids=["as placed", "placed anew"])
@pytest.mark.parametrize("kind", ["memory", "disk"])
def test_a_region_agrees_with_brute_force(
    clouds: dict[str, Cloud], kind: str, mounting: Mounting
) -> None:
    cloud = place_clouds(clouds, mounting)[kind]
    every = reference(cloud, mounting)
    assert len(cloud) == COUNT
    # Many points, a single point, no point and all points
    for centre, radius in ((every[100], 3.0), (every[7], 1e-3), ([900, 0, 0], 5), ([0, 0, 0], 99)):
        region = cloud.within(np.array(centre, dtype=float), radius)
        off = np.linalg.norm(every - centre, axis=1)
        np.testing.assert_array_equal(region.numbers, np.flatnonzero(off <= radius))
        np.testing.assert_allclose(region.points, every[region.numbers], rtol=0, atol=1e-9)
        assert region.one_in == 1


@pytest.mark.parametrize("kind", ["memory", "disk"])
def test_points_and_samples_are_placed_with_the_mounting(
    clouds: dict[str, Cloud], kind: str
) -> None:
    line, numbers = Line(COUNT), np.array([77, 3, 5000])
    for mounting in (PRIOR, OTHER):
        cloud = clouds[kind].georeferenced_with(mounting)
        every = reference(cloud, mounting)
        np.testing.assert_allclose(cloud[numbers], every[numbers], rtol=0, atol=1e-9)
        sampled = np.searchsorted(line.time, cloud.sample_time)
        np.testing.assert_array_equal(line.time[sampled], cloud.sample_time)
        assert 1000 < len(np.unique(sampled)) == len(sampled)
        np.testing.assert_allclose(cloud.sample, every[sampled], rtol=0, atol=1e-9)
        np.testing.assert_array_equal(cloud.sample_intensity, line.extra["intensity"][sampled])
        own = line.xyz[sampled].astype(np.float32).astype(float)
        np.testing.assert_allclose(cloud.sample_range, np.linalg.norm(own, axis=1), rtol=1e-12)
        some, their_time = cloud.sample_lidar(np.array([9, 2]))
        np.testing.assert_array_equal(some, own[[9, 2]])
        np.testing.assert_array_equal(their_time, cloud.sample_time[[9, 2]])
    points_of_line = cloud.scan if isinstance(cloud, CloudInMemory) else cloud.stored
    points, times = points_of_line.take(numbers)
    np.testing.assert_array_equal(points, line.xyz[numbers].astype(np.float32))
    np.testing.assert_array_equal(times, line.time[numbers])
    np.testing.assert_array_equal(
        points_of_line.intensities(numbers), line.extra["intensity"][numbers]
    )
    assert Scan(points, times).intensities(np.array([0, 2])) is None


def test_a_crowded_region_is_the_same_sample_in_memory_and_on_disk(
    clouds: dict[str, Cloud], monkeypatch: pytest.MonkeyPatch
) -> None:
    centre = np.array([8.0, 20.0, 4.0])
    one, other = (cloud.within(centre, 12.0, limit=300) for cloud in clouds.values())
    whole = clouds["memory"].within(centre, 12.0)
    assert one.one_in == other.one_in
    halvings = one.one_in.bit_length() - 1
    np.testing.assert_array_equal(one.numbers, other.numbers)
    np.testing.assert_array_equal(
        one.numbers, whole.numbers[is_number_in_sample(whole.numbers, halvings)]
    )
    np.testing.assert_allclose(one.points, other.points, rtol=0, atol=1e-9)
    # The smallest number of halvings that gives few enough points
    assert (
        len(one.numbers) <= 300 < np.count_nonzero(is_number_in_sample(whole.numbers, halvings - 1))
    )
    monkeypatch.setattr(cloud_module, "MAX_REGION_POINTS", 300)
    for cloud in clouds.values():
        np.testing.assert_array_equal(cloud.within(centre, 12.0).numbers, one.numbers)


def test_each_sample_is_half_of_the_previous_one() -> None:
    numbers, before = np.arange(40_000), np.ones(40_000, bool)
    for halvings in range(1, 6):
        kept = is_number_in_sample(numbers, halvings)
        assert not (kept & ~before).any()
        assert np.count_nonzero(kept) == pytest.approx(40_000 / 2**halvings, rel=0.1)
        before = kept


ZERO = Mounting(np.zeros(3), np.zeros(3))


@pytest.mark.parametrize(
    ("other", "loose"),
    [
        (replace(ZERO, lever_arm=np.array([0.3, -0.4, 1.2])), 1.001),
        (replace(ZERO, boresight=np.radians([0.0, 0.5, 0.0])), 1.01),
        (replace(ZERO, range_offset=0.2), 1.001),
        (replace(ZERO, scan_angle_offset=0.01), 1.01),
        (replace(ZERO, latency=0.1), 1.2),
        (OTHER, 2.5),
    ],
)
def test_the_reported_largest_displacement_is_a_tight_bound(other: Mounting, loose: float) -> None:
    """The platform turns by one radian in two seconds, at rest and under way."""
    time = np.linspace(0.0, 2.0, 21)
    for speed in (0.0, 5.0):
        position = np.column_stack([speed * time, 0 * time, 0 * time])
        attitude = np.column_stack([0 * time, 0 * time, 0.5 * time])
        track = LocalTrajectory(LocalFrame(0.8, -1.2, 0.0), time, position, attitude)
        points = np.random.default_rng(3).normal(size=(3000, 3))
        points *= 40.0 / np.linalg.norm(points, axis=1, keepdims=True)
        when = np.full(3000, 1.0)
        one, moved = Georeferencer.of(track, ZERO), Georeferencer.of(track, other)
        off = np.linalg.norm(one(points, when) - moved(points, when), axis=1).max()
        assert off <= one.largest_displacement(other, 40.0) * (1 + 1e-12)
        assert moved.largest_displacement(ZERO, 40.0) >= off * (1 - 1e-12)
        assert one.largest_displacement(other, 40.0) <= loose * off
    assert Georeferencer.of(track, other).largest_displacement(other, 40.0) == 0


def test_the_displacement_of_a_place_follows_from_the_points_near_it() -> None:
    """Points near the place move by half a metre, the others by more."""
    centre = np.array([10.0, 20.0, 30.0])
    after = centre + np.random.default_rng(1).uniform(-5, 5, (4000, 3))
    far = np.linalg.norm(after - centre, axis=1) > 2.0 + cloud_module.PROBE_SEARCH_MARGIN_M
    before = after - np.where(far[:, None], [0.0, 2.0, 0.0], [0.3, -0.4, 0.0])
    near = cloud_module.MARGIN_FACTOR * 0.5 + cloud_module.MIN_MARGIN_M
    found = cloud_module._largest_move_near(before, after, centre, 2.0, 9.0)
    assert found == pytest.approx(near)
    assert cloud_module._largest_move_near(before, after, centre, 2.0, 0.25) == 0.25
    # With fewer than 50 points near it, only the bound for all points is known
    chosen = np.flatnonzero(~far)
    for count, margin in ((49, 9.0), (50, near)):
        some = chosen[:count]
        found = cloud_module._largest_move_near(before[some], after[some], centre, 2.0, 9.0)
        assert found == pytest.approx(margin)
