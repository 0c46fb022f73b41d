from pathlib import Path

import numpy as np
import pytest

from lispac.errors import Cancelled, InputError
from lispac.geometry.frames import LocalFrame
from lispac.io.trajectory.sbet import read_sbet, write_sbet
from lispac.progress import Step
from lispac.survey.georeferencing import (
    POINTS_PER_KERNEL_CALL,
    Mounting,
    georeference,
    place_points,
    to_lidar,
)
from lispac.survey.trajectory import LocalTrajectory, Poses, Trajectory
from tests.support.error_codes import has_code

FRAME = LocalFrame(np.radians(45.5), np.radians(-73.5), 0.0)


def trajectory(count: int = 500, seed: int = 4) -> LocalTrajectory:
    rng = np.random.default_rng(seed)
    time = np.cumsum(rng.uniform(0.004, 0.006, count)) + 486_000
    position = np.cumsum(rng.normal(0, 0.01, (count, 3)), axis=0)
    # The heading passes through north, where interpolation without unwrapping fails.
    attitude = np.cumsum(rng.normal(0, 0.002, (count, 3)), axis=0)
    return LocalTrajectory(FRAME, time, position, attitude)


def survey(count: int, seed: int = 5) -> tuple[LocalTrajectory, np.ndarray, np.ndarray, Mounting]:
    rng = np.random.default_rng(seed)
    path = trajectory()
    time = rng.uniform(path.time[0], path.time[-1], count)
    points = rng.uniform(-40, 40, (count, 3))
    mounting = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.4, -1.9, 0.4]))
    return path, points, time, mounting


@pytest.mark.parametrize("order", ["sorted", "backward", "shuffled"])
def test_kernel_equals_the_reference_formula(order: str) -> None:
    path, points, time, mounting = survey(5000)
    if order != "shuffled":
        time = np.sort(time) if order == "sorted" else np.sort(time)[::-1]
    expected = place_points(points, path.at(time), mounting)
    np.testing.assert_allclose(
        georeference(points, time, path, mounting), expected, rtol=0, atol=1e-11
    )


def test_kernel_equals_the_reference_over_several_chunks() -> None:
    path, points, time, mounting = survey(POINTS_PER_KERNEL_CALL + 1000)
    local = georeference(points, time, path, mounting)
    ends = np.r_[0:500, POINTS_PER_KERNEL_CALL - 500 : POINTS_PER_KERNEL_CALL + 1000]
    np.testing.assert_allclose(
        local[ends], place_points(points[ends], path.at(time[ends]), mounting), atol=1e-11
    )


def test_to_lidar_is_the_inverse_of_georeference() -> None:
    path, points, time, mounting = survey(2000)
    local = georeference(points, time, path, mounting)
    np.testing.assert_allclose(to_lidar(local, path.at(time), mounting), points, atol=1e-11)


@pytest.mark.parametrize("wrong", [-1e-6, np.nan])
def test_times_outside_the_trajectory_are_refused(wrong: float) -> None:
    path, points, time, mounting = survey(10)
    time[3] = path.time[0] + wrong
    with pytest.raises(InputError, check=has_code("survey.outside_trajectory")):
        georeference(points, time, path, mounting)


def test_times_outside_are_reported_beside_those_of_the_trajectory() -> None:
    path, points, time, mounting = survey(10)
    time[:] = np.linspace(5.0, 9.25, 10)
    expected = {
        "first": 5.0, "last": 9.25, "start": path.time.min(), "end": path.time.max(),
    }  # fmt: skip
    with pytest.raises(InputError, check=has_code("survey.outside_trajectory", **expected)):
        georeference(points, time, path, mounting)


@pytest.mark.parametrize("offset", [1.0, -0.5])
def test_a_range_offset_lengthens_every_range(offset: float) -> None:
    mounting = Mounting(np.zeros(3), np.zeros(3), range_offset=offset)
    points = np.array([[3.0, 4.0, 0.0], [0.0, 0.0, -20.0]])
    longer = mounting.corrected(points)
    np.testing.assert_allclose(np.linalg.norm(longer, axis=1), [5 + offset, 20 + offset])
    np.testing.assert_allclose(np.cross(longer, points), 0.0, atol=1e-12)
    np.testing.assert_allclose(mounting.raw_points(longer), points, atol=1e-12)


def test_both_ends_of_the_trajectory_are_included() -> None:
    path, points, _, mounting = survey(2)
    ends = path.time[[0, -1]]
    expected = place_points(points, Poses(path.position[[0, -1]], path.attitude[[0, -1]]), mounting)
    np.testing.assert_allclose(georeference(points, ends, path, mounting), expected, atol=1e-11)


def test_georeferencing_can_be_cancelled() -> None:
    path, points, time, mounting = survey(10)

    def stop(fraction: float, step: Step | None = None) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        georeference(points, time, path, mounting, progress=stop)


def test_heading_through_north_is_interpolated_the_short_way(tmp_path: Path) -> None:
    time = np.array([0.0, 1.0])
    attitude = np.radians([[0, 0, 359.0], [0, 0, 1.0]])
    raw = Trajectory(time, np.full(2, 0.8), np.full(2, -1.3), np.zeros(2), attitude)
    write_sbet(tmp_path / "north.sbet", raw)
    local = LocalTrajectory.of(read_sbet(tmp_path / "north.sbet"), raw.mean_frame())
    heading = local.at(np.array([0.5])).attitude[0, 2]
    assert np.degrees(heading) % 360 == pytest.approx(0.0, abs=1e-6) or np.degrees(
        heading
    ) % 360 == pytest.approx(360.0, abs=1e-6)


def test_vessel_data_regeoreferences_to_its_stored_coordinates(shared_data: Path) -> None:
    """Points of a real vessel LiDAR, stored with the coordinates that another program computed."""
    mounting = Mounting(
        np.array([-0.185596, 0.037658, 2.419063]), np.radians([0.4395, -1.8681, 0.3992])
    )
    files = sorted((shared_data / "cidco").glob("*/*/*"))
    assert len(files) == 16
    for path in files:
        rows = np.fromfile(path, dtype="<f8").reshape(-1, 22)
        local = place_points(rows[:, 4:7], Poses(rows[:, 16:19], rows[:, 10:13]), mounting)
        worst = np.abs(local - rows[:, :3]).max()
        assert worst < 1e-9, f"{path.name}: {worst:.2e} m"
