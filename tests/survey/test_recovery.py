"""Tests of scanner-frame points recovered from georeferenced clouds through files."""

import json
from dataclasses import dataclass, replace
from pathlib import Path
from types import SimpleNamespace

import laspy
import numpy as np
import pytest
from pyproj import CRS

from lispac.errors import InputError
from lispac.geometry.frames import LocalFrame
from lispac.io.format_types import PointChunk
from lispac.io.las.las_chunks import LAS_FORMAT
from lispac.io.las.las_format import read_scan
from lispac.io.point_reader_common import crs_of_options
from lispac.io.trajectory.sbet import read_sbet
from lispac.simulation.simulated_survey import SimulatedSurvey, port_survey
from lispac.survey.crs import CoordinateSystem, coordinate_system
from lispac.survey.georeferencing import Mounting, georeference
from lispac.survey.scanner_frame_recovery import (
    RecoverySetup,
    recover_scanner_points,
    require_scanner_frame,
)
from lispac.survey.trajectory import LocalTrajectory, Trajectory
from tests.support.error_codes import has_code
from tests.support.long_runs import others_long
from tests.support.message_codes import codes

WRONG_BORESIGHT = np.radians([0.8, -1.7, 1.1])


@dataclass
class Cloud:
    """A georeferenced line, the setup that made it, and its points in the scanner frame."""

    path: Path
    points_lidar: np.ndarray
    recovery: RecoverySetup


@pytest.fixture(scope="module")
def port() -> SimulatedSurvey:
    return port_survey(points_per_second=20_000.0)


def port_trajectory(survey: SimulatedSurvey) -> LocalTrajectory:
    states = survey.trajectory
    trajectory = Trajectory(
        states.time, states.latitude, states.longitude, states.height,
        np.stack([states.roll, states.pitch, states.heading], axis=1),
    )  # fmt: skip
    return LocalTrajectory.of(trajectory, trajectory.mean_frame())


def written(
    path: Path, points: np.ndarray, time: np.ndarray, code: int, scales: tuple[float, ...]
) -> Path:
    """Write a cloud as other programs do, and return its path."""
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.offsets = np.array(scales), np.floor(points.mean(axis=0))
    header.add_crs(CRS.from_epsg(code))
    header.global_encoding.gps_time_type = laspy.header.GpsTimeType.WEEK_TIME
    las = laspy.LasData(header)
    las.x, las.y, las.z = points.T
    las.gps_time = time
    las.intensity = np.arange(len(time)) % 60_000
    las.write(path)
    return path


def system_in(path: Path) -> CoordinateSystem:
    """Return the coordinate system that the file header alone specifies."""
    system = crs_of_options(LAS_FORMAT.complete_options(LAS_FORMAT.preview(path, {}).choice))
    assert system is not None
    return system


SCALES = (1e-4, 1e-4, 1e-4)


@pytest.mark.parametrize(
    ("code", "scales"),
    others_long([(32619, SCALES), (2949, SCALES), (4978, SCALES), (4979, (1e-9, 1e-9, 1e-4))]),
    ids=["UTM", "MTM", "ECEF", "geographic"],
)
def test_simulated_lines_are_recovered(
    port: SimulatedSurvey,
    tmp_path: Path,
    code: int,
    scales: tuple[float, ...],
    capsys: pytest.CaptureFixture[str],
) -> None:
    """Lines written to LAZ with a resolution of 0.1 mm, with all parameters of a mounting."""
    trajectory = port_trajectory(port)
    mounting = Mounting(port.lever_arm, WRONG_BORESIGHT, 0.03, 0.002, 0.004)
    system = coordinate_system(f"EPSG:{code}")
    worst = 0.0
    for line in port.lines[:3]:
        local = georeference(line.points_lidar, line.time, trajectory, mounting)
        cloud = system.from_local(local, trajectory.frame)
        path = written(tmp_path / f"{line.name}.laz", cloud, line.time, code, scales)
        recovery = RecoverySetup(system_in(path), trajectory, mounting)
        choice = LAS_FORMAT.preview(path, {}).choice
        chunks = list(recover_scanner_points(LAS_FORMAT.read(path, choice), recovery))
        back = np.concatenate([chunk.xyz for chunk, _ in chunks])
        worst = max(worst, float(np.linalg.norm(back - line.points_lidar, axis=1).max()))
        assert sum(skipped for _, skipped in chunks) == 0
        intensity = np.concatenate([chunk.extra["intensity"] for chunk, _ in chunks])
        np.testing.assert_array_equal(intensity, np.arange(len(back)) % 60_000)
    with capsys.disabled():
        print(f"\nEPSG:{code}: scanner-frame points come back within {1000 * worst:.4f} mm")
    assert worst < 0.0002


def test_recovery_without_files_is_exact(port: SimulatedSurvey) -> None:
    trajectory = port_trajectory(port)
    mounting = Mounting(port.lever_arm, WRONG_BORESIGHT, -0.02, -0.001, -0.01)
    system = coordinate_system("EPSG:32619")
    line = port.lines[3]
    local = georeference(line.points_lidar, line.time, trajectory, mounting)
    cloud = system.from_local(local, trajectory.frame)
    back = RecoverySetup(system, trajectory, mounting).points_lidar(cloud, line.time)
    np.testing.assert_allclose(back, line.points_lidar, rtol=0, atol=1e-7)


def test_real_drone_survey_is_recovered(
    shared_data: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """The survey of the tent, georeferenced with a wrong boresight and written as LAS in UTM."""
    folder = shared_data / "lanl_tent"
    site = json.loads((folder / "site.json").read_text())
    latitude, longitude, height = site["origin_deg_m"]
    frame = LocalFrame(np.radians(latitude), np.radians(longitude), height)
    trajectory = LocalTrajectory.of(read_sbet(folder / "trajectory.sbet"), frame)
    mounting = Mounting(np.array(site["lever_arm_m"]), WRONG_BORESIGHT)
    system = coordinate_system("EPSG:32614")
    for name in ("line1", "line2"):
        scan = read_scan(folder / f"{name}.laz")
        local = georeference(scan.points_lidar, scan.time, trajectory, mounting)
        cloud = system.from_local(local, frame)
        path = written(tmp_path / f"{name}.las", cloud, scan.time, 32614, SCALES)
        recovery = RecoverySetup(system_in(path), trajectory, mounting)
        back = np.concatenate(
            [
                chunk.xyz
                for chunk, _ in recover_scanner_points(
                    LAS_FORMAT.read(path, {"frame": "georeferenced"}), recovery
                )
            ]
        )
        apart = np.linalg.norm(back - scan.points_lidar, axis=1)
        with capsys.disabled():
            print(f"\n{name}: {len(back):,} points back within {1000 * apart.max():.4f} mm")
        # Half the resolution of 0.1 mm along each axis, and the scale factor of the grid
        assert apart.max() < np.sqrt(3) * 0.5e-4 * 1.001


def small(port: SimulatedSurvey) -> tuple[RecoverySetup, np.ndarray, np.ndarray]:
    trajectory = port_trajectory(port)
    mounting = Mounting(port.lever_arm, port.boresight)
    system = coordinate_system("EPSG:32619")
    line = port.lines[0]
    some = slice(0, 2000)
    local = georeference(line.points_lidar[some], line.time[some], trajectory, mounting)
    cloud = system.from_local(local, trajectory.frame)
    return RecoverySetup(system, trajectory, mounting), cloud, line.time[some]


def test_points_without_a_pose_are_skipped_and_counted(port: SimulatedSurvey) -> None:
    recovery, cloud, time = small(port)
    outside = time.copy()
    outside[:30] = recovery.trajectory.time[0] - 1.0
    chunk = PointChunk(cloud, outside, {"mark": np.arange(len(time))}, None)
    ((kept, skipped),) = recover_scanner_points([chunk], recovery)
    assert skipped == 30
    assert len(kept.xyz) == len(kept.time) == len(time) - 30
    np.testing.assert_array_equal(kept.extra["mark"], np.arange(30, len(time)))


def test_points_in_a_gap_are_skipped(port: SimulatedSurvey) -> None:
    recovery, cloud, time = small(port)
    whole = recovery.trajectory
    middle = float(np.median(time))
    kept = (whole.time < middle - 1) | (whole.time > middle + 1)
    with_gap = replace(
        whole, time=whole.time[kept], position=whole.position[kept], attitude=whole.attitude[kept]
    )
    chunk = PointChunk(cloud, time, {}, None)
    ((_, skipped),) = recover_scanner_points([chunk], replace(recovery, trajectory=with_gap))
    last, first = (
        with_gap.time[with_gap.time < middle].max(),
        with_gap.time[with_gap.time > middle].min(),
    )
    assert skipped == np.count_nonzero((time > last) & (time < first)) > 0


@pytest.mark.parametrize(
    "wrong",
    ["EPSG:32620", "EPSG:2949", "feet"],
)
def test_a_wrong_coordinate_system_is_refused(port: SimulatedSurvey, wrong: str) -> None:
    recovery, cloud, time = small(port)
    if wrong == "feet":
        cloud = cloud / 0.3048
    else:
        recovery = replace(recovery, system=coordinate_system(wrong))
    with pytest.raises(
        InputError,
        check=lambda error: error.code in ("survey.points_too_far", "crs.points_outside"),
    ):
        list(recover_scanner_points([PointChunk(cloud, time, {}, None)], recovery))


def test_assumptions_of_the_recovery_are_reported(port: SimulatedSurvey) -> None:
    recovery, _, _ = small(port)
    assert {"assumed.cloud_made_with", "assumed.heights_not_named", "assumed.datum"} <= set(
        codes(recovery.assumptions)
    )


def test_latency_shifts_the_times_with_a_pose(port: SimulatedSurvey) -> None:
    trajectory = port_trajectory(port)
    first, last = trajectory.time[0], trajectory.time[-1]
    late = SimpleNamespace(
        trajectory=trajectory, mounting=Mounting(np.zeros(3), np.zeros(3), latency=0.5)
    )
    times = np.array([first - 0.6, first - 0.4, first + 0.1, last - 0.6, last - 0.4])
    assert RecoverySetup.has_pose(late, times).tolist() == [False, True, True, True, False]


@pytest.mark.parametrize(("near", "is_accepted"), [(40, False), (60, True)])
def test_lines_with_half_their_points_too_far_are_not_in_the_scanner_frame(
    near: int, is_accepted: bool
) -> None:
    points = np.full((100, 3), 1e6)
    points[:near] = 10.0
    if is_accepted:
        require_scanner_frame(points, Path("line.laz"))
        return
    with pytest.raises(InputError, check=has_code("survey.not_scanner_frame")):
        require_scanner_frame(points, Path("line.laz"))
