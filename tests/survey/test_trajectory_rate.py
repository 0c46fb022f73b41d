"""Tests of the bound of the error of linear interpolation, and of the warning about it."""

import numpy as np
import pytest

from lispac.geometry.frames import LocalFrame
from lispac.messages import Level
from lispac.survey.state_densification import insert_states
from lispac.survey.trajectory import LocalTrajectory, TrajectoryAccuracy
from lispac.survey.trajectory_sampling import interpolation_error, interpolation_messages

FRAME = LocalFrame(0.8, -1.2, 0.0)
ACCURACY = TrajectoryAccuracy.constant(np.full(3, 0.02), np.radians([0.01, 0.01, 0.02]))


def states(time: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return position and attitude of a vessel that rolls and pitches (metres, radians)."""
    position = np.stack([2 * time, 0.2 * np.sin(time / 4), 0.1 * np.sin(1.2 * time)], axis=1)
    attitude = np.radians(
        np.stack(
            [3 * np.sin(1.1 * time), 2 * np.sin(1.4 * time + 1), 5 * np.sin(0.4 * time)], axis=1
        )
    )
    return position, attitude


def trajectory(rate: float) -> LocalTrajectory:
    time = np.arange(0, 60, 1 / rate)
    return LocalTrajectory(FRAME, time, *states(time))


@pytest.mark.parametrize("rate", [5.0, 10.0, 50.0])
def test_the_bound_approximates_the_interpolation_error(rate: float) -> None:
    track = trajectory(rate)
    bound = interpolation_error(track)
    middle = 0.5 * (track.time[:-1] + track.time[1:])
    poses, (position, attitude) = track.at(middle), states(middle)
    error = np.abs(np.hstack([poses.position - position, poses.attitude - attitude]))
    for k in range(6):
        largest = np.quantile(error[:, k], 0.95)
        assert 0.9 * largest <= np.quantile(bound[:, k], 0.95) <= 1.2 * largest + 1e-12


@pytest.mark.parametrize(("rate", "warned"), [(200.0, False), (50.0, False), (10.0, True)])
def test_a_rate_too_low_for_the_motion_gives_a_warning(rate: float, warned: bool) -> None:
    messages = interpolation_messages(
        trajectory(rate), ACCURACY, {"L1": np.linspace(10.0, 30.0, 500)}
    )
    assert bool(messages) is warned
    for message in messages:
        assert (message.code, message.level) == ("trajectory.rate_too_low", Level.WARNING)
        assert message.params["rate"] == pytest.approx(rate)
        assert message.params["share"] > 0.1


def test_the_reported_rate_is_that_of_the_file() -> None:
    time, tick = np.arange(0, 60, 0.5), 1e-4
    own, rates = (
        np.hstack(states(time)),
        (np.hstack(states(time + tick)) - np.hstack(states(time - tick))) / (2 * tick),
    )
    dense = insert_states(time, own, rates, longest_gap=1.0)
    assert dense.parts > 1
    track = LocalTrajectory(
        FRAME, dense.time, dense.states[:, :3], dense.states[:, 3:],
        curve_error=dense.error, parts=dense.parts,
    )  # fmt: skip
    (message,) = interpolation_messages(track, ACCURACY, {"L1": np.linspace(10.0, 30.0, 500)})
    assert message.params["rate"] == pytest.approx(2.0)


LINES = {"L1": np.linspace(5.0, 25.0, 500), "L2": np.linspace(40.0, 55.0, 500)}


def test_turns_between_the_lines_are_ignored() -> None:
    time = np.arange(0, 60, 0.1)
    position, attitude = states(time)
    attitude[:, :2] = 0.0
    attitude[:, 2] = np.where(time < 30, 0.0, np.minimum(3.0, 0.5 * (time - 30) ** 2))
    track = LocalTrajectory(FRAME, time, position, attitude)
    assert interpolation_messages(track, ACCURACY, LINES) == ()
    assert interpolation_messages(track, ACCURACY, {"turn": np.linspace(29.0, 33.0, 500)}) != ()


def test_intervals_without_points_are_ignored() -> None:
    """Bursts of states 0.2 us apart have gaps of 0.4 s with waves between them."""
    time = np.concatenate([0.4 * k + 2e-7 * np.arange(200) for k in range(100)])
    position, attitude = states(time)
    track = LocalTrajectory(FRAME, time, position, np.round(attitude, 7))
    assert interpolation_messages(track, ACCURACY, {"L1": time + 1e-7}) == ()
    assert interpolation_messages(track, ACCURACY, {"L1": np.arange(10.1, 20, 0.4)}) != ()
