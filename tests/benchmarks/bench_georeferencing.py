"""Georeferenced points per second of the kernel, to the map and to LAZ, with reference programs.

The references are NumPy, PROJ and laspy. `LISPAC_BENCHMARK_POINTS` (1e6, or 1e6,1e7,1e8) sets the
sizes of the files. The compared programs run alternately for several rounds; a ratio is the median
of the ratios of the rounds. On a busy machine, processor time is the better measure.
"""

import os
import resource
from collections.abc import Callable, Iterator
from pathlib import Path
from statistics import median
from time import perf_counter, process_time

import laspy
import numpy as np
import pytest

from lispac.io.format_types import PointChunk
from lispac.io.las.las_chunks import LAS_FORMAT
from lispac.io.las.las_export import coordinate_resolution, layout_of_columns, layout_of_las
from lispac.io.trajectory.sbet import write_sbet
from lispac.project import LineSource, Project, Settings
from lispac.survey.crs import coordinate_system
from lispac.survey.georeferencing import Mounting, georeference, place_points, to_lidar
from lispac.survey.point_mapping import ScannerPointConverter
from lispac.survey.trajectory import Trajectory
from lispac.workflow.importing.file_reading import local_trajectory
from lispac.workflow.importing.line_import import import_lines, open_stored_line
from lispac.workflow.output.cloud_export import write_cloud
from lispac.workflow.output.georeferencing import stored_chunks
from tests.support.cloud_files import sweep, track
from tests.survey.test_georeferencing import survey

SIZES = [int(float(n)) for n in os.environ.get("LISPAC_BENCHMARK_POINTS", "1e6,1e7").split(",")]
CHUNK = 1_000_000
UTM = coordinate_system("EPSG:32619")


def timed(run: Callable[[], object]) -> tuple[float, float]:
    """Wall-clock time and processor time of a run, s."""
    start, work = perf_counter(), process_time()
    run()
    return perf_counter() - start, process_time() - work


def ratio(of: list[tuple[float, float]], to: list[tuple[float, float]], k: int = 0) -> float:
    """Median over the rounds of the ratio of times; ``k`` is 1 for processor times."""
    return median(a[k] / b[k] for a, b in zip(of, to, strict=True))


def rate(count: int, times: list[tuple[float, float]]) -> str:
    """Text with the median rate, million points per second, and the best one in brackets."""
    clock = [time for time, _ in times]
    return f"{count / median(clock) / 1e6:.2f} ({count / min(clock) / 1e6:.2f}) M points/s"


def test_kernel_beside_numpy():
    count, rounds = 4_000_000, 5
    path, points, time, mounting = survey(count)
    time.sort()
    georeference(points[:1000], time[:1000], path, mounting)  # compile
    found = {}
    kernel, numpy = [], []
    for _ in range(rounds):
        kernel.append(timed(lambda: found.update(k=georeference(points, time, path, mounting))))
        numpy.append(timed(lambda: found.update(n=place_points(points, path.at(time), mounting))))
    assert np.abs(found["k"] - found["n"]).max() < 1e-9
    print(
        f"\ngeoreferencing: kernel {rate(count, kernel)}, NumPy {rate(count, numpy)}, "
        f"ratio {ratio(numpy, kernel):.1f} (processor time {ratio(numpy, kernel, 1):.1f})"
    )


@pytest.mark.parametrize("code", ["EPSG:32619", "EPSG:4979", "EPSG:4978"])
def test_to_the_map_and_back_beside_proj(code):
    count, rounds = 2_000_000, 3
    trajectory, system = track(), coordinate_system(code)
    points, time = sweep(trajectory, count)
    mounting = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.4, -1.9, 0.4]))
    mapper = ScannerPointConverter(system, trajectory, mounting)
    fit, _ = timed(lambda: (mapper.fit_to(points), mapper.to_map(points[:9], time[:9])))
    found = {}
    fused, exact, back, exact_back = [], [], [], []
    for _ in range(rounds):
        fused.append(timed(lambda: found.update(f=mapper.to_map(points, time))))
        exact.append(timed(lambda: found.update(e=by_proj(system, trajectory, points, time,
                                                          mounting))))  # fmt: skip
        mapper.to_scanner(found["f"][:9], time[:9])
        back.append(timed(lambda: found.update(b=mapper.to_scanner(found["f"], time))))
        exact_back.append(timed(lambda: back_by_proj(system, trajectory, found["f"], time,
                                                     mounting)))  # fmt: skip
    off = np.abs((found["f"] - found["e"]) * np.array(system.metres)).max()
    print(
        f"\n{code}: to the map {rate(count, fused)}, NumPy and PROJ {rate(count, exact)}, ratio "
        f"{ratio(exact, fused):.0f}; off {1e3 * off:.1e} mm; fit {fit:.2f} s\n"
        f"  back {rate(count, back)}, PROJ and NumPy {rate(count, exact_back)}, ratio "
        f"{ratio(exact_back, back):.0f}; off {1e3 * np.abs(found['b'] - points).max():.1e} mm"
    )


def by_proj(system, trajectory, points, time, mounting):
    """Georeference with NumPy and convert each point with PROJ, vectorised."""
    return system.from_local(place_points(points, trajectory.at(time), mounting), trajectory.frame)


def back_by_proj(system, trajectory, points, time, mounting):
    """Inverse of `by_proj`."""
    local = system.to_local(points, trajectory.frame)
    return to_lidar(local, trajectory.at(time), mounting)


def profiler(count: int) -> Iterator[PointChunk]:
    """Simulate the points of a rotating profiler in a nearly round room."""
    trajectory, rng = track(), np.random.default_rng(0)
    start, span = trajectory.time[0] + 1, trajectory.time[-1] - trajectory.time[0] - 2
    for first in range(0, count, CHUNK):
        k = np.arange(first, min(first + CHUNK, count))
        turn = k * (2 * np.pi / 5000)
        reach = 20 + 5 * np.sin(3 * turn) + rng.normal(0, 0.005, len(k))
        xyz = np.stack([0 * turn, reach * np.sin(turn), reach * np.cos(turn)], axis=1)
        ones = np.ones(len(k), np.uint8)
        extra = {
            "intensity": (500 + 50 * np.sin(7 * turn) + rng.integers(0, 20, len(k))).astype("u2"),
            "return_number": ones,
            "number_of_returns": ones,
            "classification": ones,
        }
        yield PointChunk(xyz, start + span * k / count, extra, count)


def write_las(path: Path, count: int) -> laspy.LasHeader:
    """Write the profiler's points in the scanner frame as LAS or LAZ; return the header."""
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales = np.full(3, 1e-4)
    with laspy.open(path, "w", header=header) as writer:
        for chunk in profiler(count):
            record = laspy.ScaleAwarePointRecord.zeros(len(chunk.time), header=header)
            record.x, record.y, record.z = chunk.xyz.T
            record.gps_time = chunk.time
            for name, values in chunk.extra.items():
                record[name] = values
            writer.write_points(record)
    return header


class LaspyWriter:
    """Writes points in map coordinates with laspy, as the reference for the export."""

    def __init__(self, path: Path, mapper: ScannerPointConverter) -> None:
        self.header = laspy.LasHeader(point_format=6, version="1.4")
        self.header.scales, self.header.offsets = (
            coordinate_resolution(UTM),
            np.round(mapper.centre),
        )
        self._writer = laspy.open(path, "w", header=self.header)
        self._mapper = mapper

    def write(self, points: np.ndarray, chunk: PointChunk) -> None:
        record = laspy.ScaleAwarePointRecord.zeros(len(points), header=self.header)
        record.x, record.y, record.z = points.T
        record.gps_time = chunk.time
        for name, values in chunk.extra.items():
            record[name] = values
        self._writer.write_points(record)

    def run(self, chunks: Iterator[PointChunk]) -> tuple[float, float]:
        """Write all chunks; return the times of the writing alone, without the transformation."""
        clock = work = 0.0
        for chunk in chunks:
            points = self._mapper.to_map(chunk.xyz, chunk.time)
            more = timed(lambda points=points, chunk=chunk: self.write(points, chunk))
            clock, work = clock + more[0], work + more[1]
        more = timed(self._writer.close)
        return clock + more[0], work + more[1]


@pytest.mark.parametrize("count", SIZES)
def test_to_laz_beside_laspy_alone(tmp_path, count):
    trajectory = track()
    mapper = ScannerPointConverter(
        UTM, trajectory, Mounting(np.zeros(3), np.radians([0.4, -1.9, 0.4]))
    )
    rounds = 1 if count > 20_000_000 else 3
    ours, alone, making = tmp_path / "ours.laz", tmp_path / "alone.laz", []
    warm = list(profiler(1000))
    write_cloud(warm, ours, ours, mapper, layout_of_columns)
    made, laspys = [], []
    for _ in range(rounds):
        scan_chunks = list(profiler(count)) if count <= 20_000_000 else None
        laspys.append(
            LaspyWriter(alone, mapper).run(iter(scan_chunks) if scan_chunks else profiler(count))
        )
        if scan_chunks is None:  # measure the time of the simulation, which is part of the export's
            making.append(timed(lambda: [None for _ in profiler(count)])[0])
        source = scan_chunks if scan_chunks is not None else profiler(count)
        made.append(timed(lambda source=source: write_cloud(
            source, ours, ours, mapper, layout_of_columns)))  # fmt: skip
    size = ours.stat().st_size / alone.stat().st_size
    note = f", of which making the points alone takes {making[0]:.0f} s" if making else ""
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    print(
        f"\n{count:,} points to UTM LAZ: {rate(count, made)} ({made[0][0]:.1f} s{note}), laspy "
        f"alone {rate(count, laspys)}, ratio {ratio(made, laspys):.2f} (processor time "
        f"{ratio(made, laspys, 1):.2f}); file {size:.3f} of laspy's; peak {peak:.2f} GB"
    )


@pytest.mark.parametrize("ending", ["las", "laz"])
@pytest.mark.parametrize("count", [n for n in SIZES if n <= 20_000_000])
def test_file_to_laz_beside_laspy_reading_and_writing(tmp_path, count, ending):
    trajectory = track()
    mapper = ScannerPointConverter(
        UTM, trajectory, Mounting(np.zeros(3), np.radians([0.4, -1.9, 0.4]))
    )
    source, ours, copy = tmp_path / f"raw.{ending}", tmp_path / "ours.laz", tmp_path / "copy.laz"
    header = write_las(source, count)

    def through() -> None:
        with laspy.open(source) as reader, laspy.open(copy, "w", header=header) as writer:
            for points in reader.chunk_iterator(CHUNK):
                writer.write_points(points)

    made, copied = [], []
    for _ in range(3):
        copied.append(timed(through))
        made.append(timed(lambda: write_cloud(
            LAS_FORMAT.read(source, LAS_FORMAT.complete_options({})), ours, ours, mapper,
            lambda _: layout_of_las(source))))  # fmt: skip
    print(
        f"\n{count:,} points from {ending} to UTM LAZ: {rate(count, made)}, laspy reading and "
        f"writing the same {rate(count, copied)}, ratio {ratio(made, copied):.2f} "
        f"(processor time {ratio(made, copied, 1):.2f})"
    )


@pytest.mark.parametrize("count", SIZES)
def test_store_to_laz_beside_laspy_alone(tmp_path, count):
    """Export an imported line, whose points are in spatial order."""
    local = track()
    latitude, longitude, height = local.frame.to_geodetic(local.position)
    write_sbet(
        tmp_path / "sbet.out",
        Trajectory(local.time, latitude, longitude, height, local.attitude),
    )
    source = tmp_path / "raw.las"
    write_las(source, count)
    project = Project(
        folder=tmp_path / "project", trajectory=tmp_path / "sbet.out",
        lines=(LineSource("L1", source),),
        settings=Settings((0.0, 0.0, 0.0)),
    )  # fmt: skip
    project.folder.mkdir()
    import_lines(project)
    trajectory = local_trajectory(project)[0]
    mapper = ScannerPointConverter(UTM, trajectory, project.mounting("prior"))
    stored = open_stored_line(project, project.lines[0], trajectory)
    ours, alone = tmp_path / "ours.laz", tmp_path / "alone.laz"
    made, laspys = [], []
    for _ in range(1 if count > 20_000_000 else 3):
        laspys.append(LaspyWriter(alone, mapper).run(stored_chunks(stored)))
        made.append(timed(lambda: write_cloud(
            stored_chunks(stored), ours, ours, mapper, layout_of_columns)))  # fmt: skip
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    print(
        f"\n{count:,} points from the store to UTM LAZ: {rate(count, made)}, laspy alone "
        f"{rate(count, laspys)}, ratio {ratio(made, laspys):.2f} (processor time "
        f"{ratio(made, laspys, 1):.2f}); peak {peak:.2f} GB"
    )
