"""Trajectory, geoid and LAS files of every point format for tests of georeferenced clouds."""

import struct
from pathlib import Path

import laspy
import numpy as np

from lispac.io.trajectory.sbet import write_sbet
from lispac.project import LineSource, Project, Reading, Settings
from lispac.survey.crs import CoordinateSystem
from lispac.survey.georeferencing import Mounting, place_points
from lispac.survey.trajectory import LocalTrajectory, Trajectory
from tests.support.point_files import cloud as open3d_cloud

MOUNTING = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.4, -1.9, 0.4]), 0.02, 0.001, 0.003)
QUEBEC, SYDNEY, GREENWICH = (46.8, -71.2), (-33.9, 151.2), (51.48, 0.0)
TIMED_FORMATS = (1, 3, 4, 5, 6, 7, 8, 9, 10)
COORDINATES = ("X", "Y", "Z", "gps_time")
VERSIONS = {1: "1.2", 3: "1.2", 4: "1.3", 5: "1.3"}


def written_las(
    path: Path,
    number: int,
    points: np.ndarray,
    time: np.ndarray,
    *,
    version: str | None = None,
    standard_time: bool = False,
    extra: bool = True,
) -> laspy.LasData:
    """Write points with random attributes in every dimension of a point format."""
    rng = np.random.default_rng(number)
    header = laspy.LasHeader(point_format=number, version=version or VERSIONS.get(number, "1.4"))
    header.scales, header.offsets = np.full(3, 1e-4), np.zeros(3)
    kinds = laspy.header.GpsTimeType
    header.global_encoding.gps_time_type = kinds.STANDARD if standard_time else kinds.WEEK_TIME
    header.file_source_id, header.system_identifier = 17, "a scanner"
    if extra:
        header.add_extra_dims(
            [
                laspy.ExtraBytesParams("amplitude", "i4", "scaled", [0.5], [0.01]),
                laspy.ExtraBytesParams("deviation", "f4", "plain"),
                laspy.ExtraBytesParams("normal", "3i2", "three", [0, 0, 0], [1e-4] * 3),
                laspy.ExtraBytesParams("stamp", "u8", "64 bits"),
            ]
        )
    header.vlrs.append(laspy.VLR("someone", 7, "theirs", b"kept as it is"))
    las = laspy.LasData(header)
    las.x, las.y, las.z = points.T
    las.gps_time = time
    raw = las.points.array
    for name in raw.dtype.names:
        if name in COORDINATES:
            continue
        field = raw[name]
        if field.dtype.kind == "f":
            raw[name] = rng.normal(0, 1, field.shape)
        else:
            bounds = np.iinfo(field.dtype)
            raw[name] = rng.integers(
                bounds.min, bounds.max, field.shape, field.dtype, endpoint=True
            )
    if header.version.minor >= 4:
        las.evlrs = laspy.vlrs.vlrlist.VLRList([laspy.VLR("someone", 8, "at the end", b"e" * 70)])
    las.write(path)
    return laspy.read(path)


def track(
    place_deg: tuple[float, float] = QUEBEC, *, size: float = 800.0, turns: float = 3.0
) -> LocalTrajectory:
    """Circles of a rolling vessel, whose heading passes through north repeatedly."""
    time = 400_000 + np.arange(12_001) / 200
    course = np.linspace(0, 2 * np.pi * turns, len(time))
    latitude = np.radians(place_deg[0]) + size / 6.37e6 * np.sin(course)
    longitude = np.radians(place_deg[1]) - size / 6.37e6 / np.cos(latitude) * np.cos(course)
    attitude = np.stack(
        [0.1 * np.sin(time), 0.05 * np.cos(0.8 * time), course % (2 * np.pi)], axis=1
    )
    height = 5 + np.sin(time)
    trajectory = Trajectory(time, latitude, longitude, height, attitude)
    return LocalTrajectory.of(trajectory, trajectory.mean_frame())


def sweep(trajectory: LocalTrajectory, count: int = 4000) -> tuple[np.ndarray, np.ndarray]:
    rng = np.random.default_rng(8)
    time = rng.uniform(trajectory.time[0] + 0.01, trajectory.time[-1] - 0.01, count)
    return rng.uniform(-90, 90, (count, 3)), np.sort(time)


def folded_geoid(path: Path) -> Path:
    """Write a geoid in the format of NOAA (GTX): waves of decimetres on nodes 1' apart."""
    south, west = np.mgrid[0:121, 0:181]
    waves = -27.5 + 0.3 * np.sin(south / 5) + 0.4 * np.cos(west / 7)
    head = struct.pack(">4d2i", 46.0, -73.0, 1 / 60, 1 / 60, *waves.shape)
    path.write_bytes(head + waves.astype(">f4").tobytes())
    return path


def one_by_one(
    system: CoordinateSystem, trajectory: LocalTrajectory, points: np.ndarray, time: np.ndarray
) -> np.ndarray:
    """Reference georeferencing: the formulas step by step, with PROJ for every point."""
    local = place_points(points, trajectory.at(time + MOUNTING.latency), MOUNTING)
    return system.from_geodetic(*trajectory.frame.to_geodetic(local))


LINE_POINTS = 3000
"""Number of points of the first line of `two_lines`."""


def states() -> Trajectory:
    """States of `track` as in a trajectory file."""
    local = track()
    latitude, longitude, height = local.frame.to_geodetic(local.position)
    return Trajectory(local.time, latitude, longitude, height, local.attitude)


def two_lines(folder: Path) -> Project:
    """Two lines in the scanner frame: a LAS file with a time shift and a PLY file."""
    write_sbet(folder / "sbet.out", states())
    points, time = sweep(track(), LINE_POINTS)
    raw = written_las(folder / "raw.laz", 6, points, time - 18.0)
    raw.withheld[:] = 0
    raw.write(folder / "raw.laz")
    open3d_cloud(folder / "other.ply")
    shifted = Reading("las", (), 18.0)
    return Project(
        folder=folder / "project", trajectory=folder / "sbet.out",
        lines=(
            LineSource("L1", folder / "raw.laz", (), shifted),
            LineSource("L2", folder / "other.ply", (), Reading("ply", (("time_field", "time"),))),
        ),
        settings=settings_of(MOUNTING),
    )  # fmt: skip


def settings_of(mounting: Mounting) -> Settings:
    """Settings of a project whose prior is this mounting."""
    return Settings(
        tuple(mounting.lever_arm), tuple(np.degrees(mounting.boresight)), None,
        range_offset=mounting.range_offset,
        scan_angle_offset_deg=float(np.degrees(mounting.scan_angle_offset)),
        latency=mounting.latency,
    )  # fmt: skip
