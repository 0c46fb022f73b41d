"""Tests of trajectory interpolation with velocities and angular rates."""

from pathlib import Path

import numpy as np
import pytest

from lispac.geometry.frames import LocalFrame
from lispac.io.trajectory.sbet import SbetOptions, read_sbet
from lispac.survey.georeferencing import Mounting, place_points, to_lidar
from lispac.survey.state_densification import MAX_INTERPOLATION_ERROR, attitude_rates, hermite_cubic
from lispac.survey.trajectory import LocalTrajectory, Trajectory
from lispac.survey.trajectory_sampling import interpolation_error

ORIGINS_DEG = {"north": (48.0, -69.0), "antimeridian": (-17.0, 180.0), "south": (-33.8, 18.4)}
DURATION = 60.0
Array = np.ndarray


def motion(time: Array) -> tuple[Array, Array, Array, Array]:
    """Return position (north, west, up), velocity, attitude (bow up) and its rates on waves."""
    roll, pitch, heave = 2 * np.pi / np.array([6.0, 4.5, 7.0])
    turn = 2 * np.pi / 25.0
    heading = 0.3 + 3.0 * np.sin(turn * time)
    heading_rate = 3.0 * turn * np.cos(turn * time)
    radius, speed = 40.0, 2 * np.pi / 90.0
    position = np.stack(
        [radius * np.sin(speed * time), radius * np.cos(speed * time), 0.6 * np.sin(heave * time)],
        axis=1,
    )
    velocity = np.stack(
        [radius * speed * np.cos(speed * time), -radius * speed * np.sin(speed * time),
         0.6 * heave * np.cos(heave * time)], axis=1,
    )  # fmt: skip
    attitude = np.stack(
        [np.radians(5) * np.sin(roll * time), np.radians(3) * np.sin(pitch * time + 1), heading],
        axis=1,
    )
    rates = np.stack(
        [np.radians(5) * roll * np.cos(roll * time),
         np.radians(3) * pitch * np.cos(pitch * time + 1), heading_rate], axis=1,
    )  # fmt: skip
    return position, velocity, attitude, rates


def body_rates(attitude: Array, rates: Array) -> Array:
    """Return angular rates about forward, starboard and down by the kinematic equations."""
    roll, pitch, _ = attitude.T
    dr, dp, dh = rates.T
    return np.stack(
        [dr - np.sin(pitch) * dh, np.cos(roll) * dp + np.sin(roll) * np.cos(pitch) * dh,
         -np.sin(roll) * dp + np.cos(roll) * np.cos(pitch) * dh], axis=1,
    )  # fmt: skip


def sbet(path: Path, rate: float, place: str = "north", wander: float = 0.2) -> LocalFrame:
    """Write the motion as an SBET with velocities in the wander frame and wrapped angles."""
    time = np.arange(0.0, DURATION, 1 / rate)
    position, velocity, attitude, rates = motion(time)
    frame = LocalFrame(*np.radians(ORIGINS_DEG[place]), 20.0)
    latitude, longitude, height = frame.to_geodetic(position)
    records = np.zeros((len(time), 17))
    records[:, 0] = 300_000 + time
    records[:, 1], records[:, 3] = latitude, height
    records[:, 2] = np.remainder(longitude + np.pi, 2 * np.pi) - np.pi
    north, east, up = velocity[:, 0], -velocity[:, 1], velocity[:, 2]
    records[:, 4] = north * np.cos(wander) - east * np.sin(wander)
    records[:, 5] = -(north * np.sin(wander) + east * np.cos(wander))
    records[:, 6] = up
    records[:, 7:9] = attitude[:, :2]
    records[:, 9] = np.remainder(attitude[:, 2] + wander, 2 * np.pi)
    records[:, 10] = wander
    records[:, 14:17] = body_rates(attitude, rates)
    records.astype("<f8").tofile(path)
    return frame


def errors(path: Path, frame: LocalFrame, track: Trajectory) -> tuple[float, float]:
    """Return the largest interpolation errors in metres and radians."""
    local = LocalTrajectory.of(track, frame)
    time = np.random.default_rng(3).uniform(1.0, DURATION - 2.0, 5000)
    position, _, attitude, _ = motion(time)
    poses = local.at(300_000 + time)
    turned = poses.attitude * [1, -1, 1] - attitude
    wrapped = np.remainder(turned + np.pi, 2 * np.pi) - np.pi
    return float(np.abs(poses.position - position).max()), float(np.abs(wrapped[:, :2]).max())


def linear(track: Trajectory) -> Trajectory:
    from dataclasses import replace

    return replace(track, velocity=None, attitude_rate=None)


@pytest.mark.parametrize("place", ORIGINS_DEG)
@pytest.mark.parametrize("axes", ["unknown", "wander-nwu"])
def test_interpolation_errors_at_10_hz_are_five_times_smaller(
    tmp_path: Path, place: str, axes: str
) -> None:
    path = tmp_path / "a.sbet"
    frame = sbet(path, 10.0, place)
    track = read_sbet(path, SbetOptions(axes=axes))
    straight, curved = errors(path, frame, linear(track)), errors(path, frame, track)
    # North turns by 1e-5 rad over the 40 m from the origin of the frame.
    assert straight[0] > 5e-4
    assert curved[0] < straight[0] / 5
    assert curved[1] < straight[1] / 5
    assert curved[0] < 2 * MAX_INTERPOLATION_ERROR[0] + 1e-5


def test_dense_states_are_not_changed(tmp_path: Path) -> None:
    path = tmp_path / "a.sbet"
    frame = sbet(path, 200.0)
    track = read_sbet(path)
    local, plain = LocalTrajectory.of(track, frame), LocalTrajectory.of(linear(track), frame)
    assert local.time.tobytes() == plain.time.tobytes()
    assert local.position.tobytes() == plain.position.tobytes()
    assert local.attitude.tobytes() == plain.attitude.tobytes()
    assert local.curve_error is None


def test_the_states_of_the_file_are_kept(tmp_path: Path) -> None:
    path = tmp_path / "a.sbet"
    frame = sbet(path, 10.0)
    track = read_sbet(path)
    local, plain = LocalTrajectory.of(track, frame), LocalTrajectory.of(linear(track), frame)
    own = np.isin(local.time, plain.time)
    assert np.count_nonzero(own) == len(plain.time) < len(local.time)
    np.testing.assert_array_equal(local.position[own], plain.position)
    np.testing.assert_array_equal(local.attitude[own], plain.attitude)


@pytest.mark.parametrize(
    ("column", "change", "component"),
    [
        (4, lambda v: -v, 0), (5, lambda v: 0.3 * v, 1), (6, lambda v: -v, 2),
        (14, lambda v: -v, 3), (15, lambda v: np.degrees(v), 4), (14, lambda v: 0 * v, 3),
    ],
)  # fmt: skip
def test_rates_that_contradict_the_states_are_not_used(
    tmp_path: Path, column: int, change: object, component: int
) -> None:
    path = tmp_path / "a.sbet"
    frame = sbet(path, 10.0, wander=0.0)
    records = np.fromfile(path, "<f8").reshape(-1, 17)
    records[:, column] = change(records[:, column])  # type: ignore[operator]
    records.tofile(path)
    local = LocalTrajectory.of(read_sbet(path, SbetOptions(axes="wander-nwu")), frame)
    plain = LocalTrajectory.of(linear(read_sbet(path)), frame)
    states = np.hstack([local.position, local.attitude])[:, component]
    straight = np.interp(
        local.time, plain.time, np.hstack([plain.position, plain.attitude])[:, component]
    )
    np.testing.assert_allclose(states, straight, rtol=0, atol=1e-9)
    assert [each.code for each in local.messages] == ["trajectory.rates_not_used"]


def test_gaps_are_not_interpolated_with_a_curve(tmp_path: Path) -> None:
    path = tmp_path / "a.sbet"
    frame = sbet(path, 10.0)
    records = np.fromfile(path, "<f8").reshape(-1, 17)
    np.delete(records, slice(200, 260), axis=0).tofile(path)
    local = LocalTrajectory.of(read_sbet(path), frame)
    inside = (local.time > records[199, 0]) & (local.time < records[260, 0])
    assert not inside.any()
    assert not local.covers(np.array([records[230, 0]])).any()


def test_raw_points_are_recovered_exactly(tmp_path: Path) -> None:
    path = tmp_path / "a.sbet"
    frame = sbet(path, 10.0)
    local = LocalTrajectory.of(read_sbet(path), frame)
    rng = np.random.default_rng(1)
    mounting = Mounting(np.array([-0.2, 0.05, 2.0]), np.radians([0.3, -0.4, 0.6]))
    points = rng.uniform(-20, 20, (2000, 3))
    poses = local.at(np.sort(300_000 + rng.uniform(1, 58, 2000)))
    back = to_lidar(place_points(points, poses, mounting), poses, mounting)
    np.testing.assert_allclose(back, points, rtol=0, atol=1e-9)


def test_errors_are_within_the_reported_bound(tmp_path: Path) -> None:
    path = tmp_path / "a.sbet"
    frame = sbet(path, 10.0)
    track = read_sbet(path)
    bound = interpolation_error(LocalTrajectory.of(track, frame))
    straight = interpolation_error(LocalTrajectory.of(linear(track), frame))
    error = errors(path, frame, track)
    assert error[0] < 3 * np.quantile(bound[:, :3].max(axis=1), 0.95) + 1e-5
    assert np.quantile(bound, 0.95, axis=0).max() < np.quantile(straight, 0.95, axis=0).max() / 3


def test_a_cubic_is_interpolated_exactly() -> None:
    rng = np.random.default_rng(4)
    c = rng.normal(size=(4, 5))
    u, span = rng.uniform(0, 1, (50, 1)), np.full((50, 1), 0.7)

    def value(t: Array) -> Array:
        return c[0] + c[1] * t + c[2] * t**2 + c[3] * t**3

    def slope(t: Array) -> Array:
        return c[1] + 2 * c[2] * t + 3 * c[3] * t**2

    zero, one = np.zeros((50, 1)), span
    found = hermite_cubic(u, span, (value(zero), value(one)), (slope(zero), slope(one)))
    np.testing.assert_allclose(found, value(u * span), rtol=0, atol=1e-12)


def test_body_rates_are_derivatives_of_the_angles() -> None:
    time = np.linspace(0, 30, 500)
    _, _, attitude, rates = motion(time)
    np.testing.assert_allclose(
        attitude_rates(attitude, body_rates(attitude, rates)), rates, rtol=0, atol=1e-12
    )
