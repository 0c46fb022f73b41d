"""Import of a line and reading of a region: 10^6 and 10^7 points, with ``-m long`` 10^8.

The line is a LAS or LAZ file (point format 6) of a profiler that moves along a quay wall, written
with laspy before the measurement. Peak memory is that of the whole process, which reads, sorts and
writes; it includes mapped parts of files. Run with ``pytest -s tests/benchmarks/bench_store.py``.
"""

import os
import resource
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path

import laspy
import numpy as np
import pytest

from lispac.io.trajectory.sbet import write_sbet
from lispac.progress import Step
from lispac.project import LineSource, Project, Settings
from lispac.survey.georeferencing import Georeferencer
from lispac.survey.trajectory import Trajectory
from lispac.workflow.importing.file_reading import local_trajectory
from lispac.workflow.importing.line_import import import_line, open_stored_line

RATE, SPEED, WALL, DECK = 500_000, 1.5, 15.0, -4.0
"""Pulse rate, Hz; speed, m/s; distance of the wall on the left, m; height of the quay, m."""
LEVER_ARM = (-0.2, 0.04, 2.4)
CHUNK = 1_000_000


def points(count: int) -> Iterator[tuple[np.ndarray, np.ndarray]]:
    """Points in the LiDAR frame and their times, in chunks of a million."""
    rng = np.random.default_rng(1)
    for start in range(0, count, CHUNK):
        numbers = np.arange(start, min(start + CHUNK, count))
        elapsed = numbers / RATE
        angle = np.radians(-60 + 140 * ((elapsed * 100) % 1))
        across, up = np.cos(angle), np.sin(angle)
        with np.errstate(divide="ignore"):
            reach = np.minimum(WALL / across, np.where(up < 0, DECK / up, np.inf))
        reach += rng.normal(0, 0.003, len(numbers))
        yield np.column_stack([np.zeros(len(numbers)), reach * across, reach * up]), 1000 + elapsed


def make_project(folder: Path, count: int, ending: str) -> Project:
    """Write a trajectory and a line, and return a project of them."""
    time_ = np.arange(999.0, 1001 + count / RATE, 0.005)
    along = (time_ - 1000) * SPEED
    swing = np.column_stack(
        [0.02 * np.sin(time_ / 3), 0.01 * np.sin(time_ / 5), 0.03 * np.sin(time_ / 20)]
    )
    write_sbet(
        folder / "trajectory.sbet",
        Trajectory(
            time_, np.radians(45.5) + along / 6_367_000, np.full(len(time_), np.radians(-73.5)),
            np.zeros(len(time_)), swing,
        ),
    )  # fmt: skip
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales = np.full(3, 1e-4)
    path = folder / f"L1.{ending}"
    rng = np.random.default_rng(2)
    with laspy.open(path, mode="w", header=header) as writer:
        for xyz, times in points(count):
            record = laspy.ScaleAwarePointRecord.zeros(len(times), header=header)
            record.x, record.y, record.z = xyz.T
            record.gps_time = times
            record.intensity = rng.integers(0, 4000, len(times))
            record.scan_angle = np.arange(len(times)) % 10_000
            record.return_number[:] = record.number_of_returns[:] = 1
            writer.write_points(record)
    settings = Settings(lever_arm=LEVER_ARM, boresight_deg=(0.3, -0.4, 0.5))
    return Project(
        folder=folder,
        trajectory=folder / "trajectory.sbet",
        lines=(LineSource("L1", path),),
        settings=settings,
    )


@pytest.mark.parametrize(
    "count", [10**6, 10**7, pytest.param(10**8, marks=pytest.mark.long)], ids="{:.0e}".format
)
@pytest.mark.parametrize("ending", ["las", "laz"])
def test_store(count: int, ending: str, tmp_path: Path) -> None:
    project = make_project(tmp_path, count, ending)
    command = [sys.executable, __file__, str(tmp_path)]
    run = subprocess.run(
        command, capture_output=True, text=True, check=False, cwd=Path(__file__).parents[2]
    )
    assert run.returncode == 0, run.stderr
    size = project.lines[0].path.stat().st_size / 1e6
    print(f"\n{count:12,} points, {ending.upper()} of {size:,.0f} MB\n{run.stdout}")
    for path in sorted(tmp_path.rglob("*"), reverse=True):
        path.rmdir() if path.is_dir() else path.unlink()


def report(folder: str) -> None:
    """Import and read a line; runs in a separate process so that its peak memory is measured."""
    root = Path(folder)
    (path,) = root.glob("L1.*")
    settings = Settings(lever_arm=LEVER_ARM, boresight_deg=(0.3, -0.4, 0.5))
    project = Project(
        folder=root,
        trajectory=root / "trajectory.sbet",
        lines=(LineSource("L1", path),),
        settings=settings,
    )
    trajectory = local_trajectory(project)[0]
    place = Georeferencer.of(trajectory, project.mounting("prior"))
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    stages: dict[str, tuple[float, float]] = {}

    def progress(fraction: float, step: Step | None = None) -> None:
        stages.setdefault(str(step).partition(" ")[0], now())

    start = now()
    stored = import_line(project, project.lines[0], trajectory, progress=progress).stored
    end, ordering = now(), stages["Sorting"]
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    laspy_took, laspy_cpu = laspy_alone(path)
    took, cpu = end[0] - start[0], end[1] - start[1]
    print(
        f"  import     {took:8.1f} s, {len(stored) / took / 1e6:.2f} M points/s "
        f"(reading {ordering[0] - start[0]:.1f} s, ordering {end[0] - ordering[0]:.1f} s); "
        f"{cpu:.1f} s of processor; laspy alone reads the file in {laspy_took:.1f} s "
        f"({laspy_cpu:.1f} s of processor): import {took / laspy_took:.1f} x\n"
        f"  memory     {before:.2f} GB before, at most {peak:.2f} GB; on disk "
        f"{stored.manifest.bytes / 1e6:,.0f} MB, {stored.manifest.bytes / len(stored):.1f} bytes "
        "a point"
    )
    away = trajectory.position[len(trajectory.position) // 2]
    centre = away + [0.0, WALL, 3.0]
    stored.within(centre, 3.0, place)  # compile
    start = now()
    stored.require_sound()
    checking = least([since(start)])
    print(f"  check      every byte of the store, as after a copy, {checking}")
    drop_page_cache(stored.folder)
    for state, rounds in (("cold", 1), ("warm", 9)):
        opening, regions = [], []
        for _ in range(rounds):
            start = now()
            found = open_stored_line(project, project.lines[0], trajectory)
            coarse = np.array(found.coarse.points_local)
            opening.append(since(start))
            start = now()
            rows, _ = found.within(centre, 3.0, place)
            regions.append(since(start))
        runs = found.near(centre, 3.0)
        print(
            f"  {state}       open and {len(coarse):,} coarse points {least(opening)}; "
            f"sphere of 3 m: {len(rows):,} of {(runs[:, 1] - runs[:, 0]).sum():,} points in "
            f"{len(runs)} runs, {least(regions)}"
        )


def since(start: tuple[float, float]) -> tuple[float, float]:
    """Wall-clock time and processor time since ``start``, s."""
    end = now()
    return end[0] - start[0], end[1] - start[1]


def least(seconds: list[tuple[float, float]]) -> str:
    """Text with the shortest time of some rounds, which other programs affect least."""
    clock, cpu = np.min(seconds, axis=0) * 1e3
    return f"{clock:.1f} ms ({cpu:.1f} ms of processor)"


def now() -> tuple[float, float]:
    """Present wall-clock time and processor time of this process, s."""
    return time.perf_counter(), time.process_time()


def laspy_alone(path: Path) -> tuple[float, float]:
    """Wall-clock time and processor time for reading all points and times with laspy, s."""
    start = now()
    with laspy.open(path) as reader:
        for chunk in reader.chunk_iterator(CHUNK):
            np.stack([chunk.x, chunk.y, chunk.z], axis=1)
            np.array(chunk.gps_time)
    return since(start)


def drop_page_cache(folder: Path) -> None:
    """Drop the files of a store from the cache of the system."""
    for path in folder.rglob("*.npy"):
        handle = os.open(path, os.O_RDONLY)
        os.fsync(handle)
        os.posix_fadvise(handle, 0, 0, os.POSIX_FADV_DONTNEED)
        os.close(handle)


if __name__ == "__main__":
    report(sys.argv[1])
