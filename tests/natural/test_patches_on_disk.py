"""Tests that patches of lines on disk have the same points as those of lines in memory."""

from dataclasses import replace
from pathlib import Path

import numpy as np

from lispac.geometry.frames import LocalFrame
from lispac.natural.patches import Patches, find_patches
from lispac.survey.cloud import Cloud, CloudInMemory, CloudOnDisk
from lispac.survey.georeferencing import Georeferencer, Mounting, to_lidar
from lispac.survey.scan import Scan
from lispac.survey.store.line_import import write_store
from lispac.survey.store.stored_line import open_store
from lispac.survey.trajectory import LocalTrajectory
from tests.support.store_lines import RECIPE, Line

MOUNTING = Mounting(np.array([0.2, 0.1, 0.5]), np.radians([1.0, -2.0, 3.0]))
TIME = np.linspace(0.0, 20.0, 41)
TRACK = LocalTrajectory(
    LocalFrame(0.8, -1.2, 0.0), TIME, np.column_stack([0.3 * TIME, 0 * TIME, 0 * TIME]),
    np.zeros((41, 3)),
)  # fmt: skip


def _scan(seed: int) -> Scan:
    """Return a scan of a wall, 6 m by 4 m, a quarter of whose points are of a bush beside it."""
    rng, count = np.random.default_rng(seed), 4000
    local = np.column_stack(
        [rng.uniform(0, 6, count), -15 + rng.normal(0, 0.002, count), rng.uniform(2, 6, count)]
    )
    local[::4] = rng.uniform(0.0, 3.0, (count // 4, 3)) + [8.0, -14.0, 1.0]
    time = np.linspace(0.0, 20.0, count)
    return Scan(to_lidar(local, TRACK.at(time), MOUNTING), time)


def _points(found: Patches, clouds: dict[str, Cloud]) -> dict[str, set[int]]:
    """Return the point indices of each line on the patches, none of which is thinned."""
    assert len(found)
    names, numbers = list(clouds), {name: set() for name in clouds}
    for row, line in enumerate(found.planes.line):
        own, one_in = found.points_on(row, clouds[names[line]])
        assert one_in == 1
        numbers[names[line]] |= set(own.tolist())
    return numbers


def test_a_line_on_disk_has_the_points_of_the_same_line_in_memory(tmp_path: Path) -> None:
    scans = {name: _scan(seed) for name, seed in (("L1", 1), ("L2", 2))}
    memory = {n: CloudInMemory.of(scan, TRACK, MOUNTING) for n, scan in scans.items()}
    where, disk = Georeferencer.of(TRACK, MOUNTING), {}
    recipe = replace(RECIPE, placed_with={"mounting": MOUNTING.values.tolist()})
    for name, scan in scans.items():
        source = Line(len(scan), xyz=scan.points_lidar).pieces(1500)
        write_store(tmp_path / name, recipe, source, where)
        disk[name] = CloudOnDisk(open_store(tmp_path / name, "L1"), where)
    kept, read = (
        _points(find_patches(clouds, 0.003, 0.02), clouds) for clouds in (memory, disk)
    )  # fmt: skip
    wall = set(range(4000)) - set(range(0, 4000, 4))
    for one, other in ((kept[name], read[name]) for name in scans):
        assert len(one) > 0.8 * len(wall)
        assert one <= wall
        assert other <= wall
        # Regions on disk are selected by voxels, so a few points at the edge may differ.
        assert len(one & other) > 0.9 * len(one)
