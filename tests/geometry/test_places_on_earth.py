"""Tests that a survey has the same local trajectory anywhere on Earth."""

from pathlib import Path

import numpy as np
import pytest

from lispac.geometry.frames import LocalFrame
from lispac.geometry.rotations import rotation_angles, rotation_matrix
from lispac.io.formats import recognise_formats
from lispac.io.trajectory.sbet import read_sbet, write_sbet
from lispac.survey.trajectory import DEFAULT_LONGEST_GAP_S, LocalTrajectory, Trajectory

PLACES = [
    (0.0, 0.0), (48.0, -69.0), (-17.0, 180.0), (-17.0, -180.0), (-60.0, -179.9999),
    (52.0, 179.9999), (85.0, 30.0), (-77.0, 166.7), (-33.9, 0.0), (1.3, 103.8),
]  # fmt: skip
TIME = 1000.0 + np.arange(0, 60, 0.05)


def motion() -> tuple[np.ndarray, np.ndarray]:
    """Return positions (n, 3), metres, and attitudes (n, 3), radians, of a loop of 60 m."""
    turn = 2 * np.pi * (TIME - TIME[0]) / 60
    position = 30 * np.stack([np.sin(turn), 1 - np.cos(turn), 0.01 * np.sin(5 * turn)], axis=1)
    heading = -turn
    waves = np.radians(2) * np.sin(np.stack([9 * turn, 7 * turn], axis=1))
    return position - position.mean(axis=0), np.column_stack([waves, heading])


def at_place(latitude: float, longitude: float, turn: float = 0.0) -> Trajectory:
    """Return the motion at a place, with longitudes within +-pi, or from 0 to ``turn``."""
    frame = LocalFrame(*np.radians([latitude, longitude]), 20.0)
    position, attitude = motion()
    lat, lon, height = frame.to_geodetic(position)
    level = frame.rotation_local_level(lat, lon)
    body = np.swapaxes(level, -1, -2) @ rotation_matrix(*attitude.T)
    lon = np.mod(lon + np.pi, 2 * np.pi) - np.pi if not turn else np.mod(lon, turn)
    return Trajectory(TIME, lat, lon, height, rotation_angles(body))


@pytest.mark.parametrize("turn", [0.0, 2 * np.pi])
@pytest.mark.parametrize(("latitude", "longitude"), PLACES)
def test_the_local_trajectory_is_the_same_at_ten_places(
    latitude: float, longitude: float, turn: float
) -> None:
    trajectory = at_place(latitude, longitude, turn)
    frame = trajectory.mean_frame()
    local = LocalTrajectory.of(trajectory, frame, DEFAULT_LONGEST_GAP_S)
    position, attitude = motion()
    # The mean of latitude and longitude differs a little from the mean position.
    assert np.linalg.norm(local.position.mean(axis=0)) < 0.02
    meridian = (frame.longitude - np.radians(longitude) + np.pi) % (2 * np.pi) - np.pi
    turned = meridian * np.sin(frame.latitude)  # convergence of the meridians of both origins
    np.testing.assert_allclose(
        local.position - local.position.mean(axis=0), position, rtol=0, atol=1e-3
    )
    off = np.angle(np.exp(1j * (local.attitude - attitude)))
    assert np.degrees(np.abs(off - [0, 0, -turned])).max() < 1e-4 or (
        np.degrees(np.abs(off)).max() < 1e-3
    )


@pytest.mark.parametrize(("latitude", "longitude"), PLACES)
def test_sbet_round_trip_at_ten_places(tmp_path: Path, latitude: float, longitude: float) -> None:
    trajectory = at_place(latitude, longitude)
    write_sbet(tmp_path / "a.sbet", trajectory)
    again = read_sbet(tmp_path / "a.sbet")
    np.testing.assert_allclose(again.longitude, trajectory.longitude, rtol=0, atol=1e-14)
    raw = np.fromfile(tmp_path / "a.sbet").reshape(-1, 17)
    assert np.abs(raw[:, 2]).max() <= np.pi + 1e-12


@pytest.mark.parametrize("whole", [False, True])
def test_text_longitudes_across_the_antimeridian_or_from_0_to_360(
    tmp_path: Path, whole: bool
) -> None:
    trajectory = at_place(-17.0, 180.0 if not whole else -69.0, 2 * np.pi if whole else 0.0)
    degrees = np.degrees(trajectory.longitude_within_half_turn)
    if whole:
        degrees %= 360
    rows = np.column_stack(
        [TIME, np.degrees(trajectory.latitude), degrees, trajectory.height,
         np.degrees(trajectory.attitude) * [1, -1, 1]]
    )  # fmt: skip
    path = tmp_path / "track.txt"
    names = "Time,Latitude,Longitude,Height,Roll,Pitch,Heading"
    np.savetxt(path, rows, delimiter=",", header=names, comments="", fmt="%.12f")
    format = recognise_formats(path, "trajectory")[0][0]
    read = format.read(path, format.preview(path, {}).choice)
    assert isinstance(read, Trajectory)
    np.testing.assert_allclose(
        np.sin(read.longitude), np.sin(trajectory.longitude), rtol=0, atol=1e-12
    )
    assert np.ptp(read.longitude) < 1e-4
    assert np.cos(read.mean_frame().longitude - trajectory.mean_frame().longitude) > 1 - 1e-12
