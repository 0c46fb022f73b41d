"""Tests of the bound of the error of linear interpolation, of held positions, and the warnings."""

from functools import partial
from pathlib import Path

import numpy as np
import pytest

from lispac.geometry.frames import LocalFrame
from lispac.io.formats import format_of
from lispac.messages import Level
from lispac.survey.state_densification import insert_states
from lispac.survey.trajectory import LocalTrajectory, TrajectoryAccuracy
from lispac.survey.trajectory_sampling import (
    held_position_messages,
    interpolation_error,
    interpolation_messages,
)
from lispac.warning_causes import Cause

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


@pytest.mark.parametrize(
    ("length", "warned"), [(0.02, False), (0.1, False), (0.4, True), (1.0, True), (2.0, False)]
)
def test_an_interpolated_gap_gives_a_warning_if_its_error_exceeds_the_accuracy(
    length: float, warned: bool
) -> None:
    """A gap of 2 s is not interpolated; its points are excluded."""
    time = np.arange(0, 60, 1 / 200)
    time = time[(time <= 20.0) | (time >= 20.0 + length)]
    track = LocalTrajectory(FRAME, time, *states(time))
    lines = {"L1": np.linspace(5.0, 35.0, 3000), "L2": np.linspace(40.0, 55.0, 500)}
    messages = interpolation_messages(track, ACCURACY, lines)
    assert len(messages) == warned
    inside = np.linspace(20.0, 20.0 + length, 101)
    poses, (position, attitude) = track.at(inside), states(inside)
    shift, turn = (
        float(np.abs(got - true).max())
        for got, true in ((poses.position, position), (poses.attitude, attitude))
    )
    for message in messages:
        assert (message.code, message.level) == ("trajectory.gap_interpolated", Level.WARNING)
        assert (message.subject, message.params["count"]) == (Cause.of_line("L1"), 1)
        assert message.params["longest"] == pytest.approx(length, abs=0.006)
        assert message.params["shift"] == pytest.approx(shift, rel=0.3)
        assert message.params["turn"] == pytest.approx(turn, rel=0.3)
    exceeds = shift > 0.02 or turn > np.radians(0.01)
    assert warned == (exceeds and length <= track.longest_gap)


def test_a_short_gap_between_the_sampled_times_gives_a_warning() -> None:
    time = np.arange(0, 60, 1 / 200)
    track = LocalTrajectory(FRAME, *(each[(time <= 20.0) | (time >= 20.4)] for each in
                                     (time, *states(time))))  # fmt: skip
    points, pause = np.linspace(5.0, 55.0, 100_000), np.linspace(20.5, 55.0, 50_000)
    runs = np.concatenate([np.linspace(k, k + 1e-4, 16) for k in np.linspace(5.7, 54.7, 50)])
    assert not ((runs > 20.0) & (runs < 20.4)).any(), "the runs miss the gap"
    calls = []

    def dense(times: np.ndarray) -> np.ndarray:
        calls.append(times)
        return times

    for own, warned in ((points, True), (np.concatenate([[6.0], pause]), False)):
        messages = interpolation_messages(
            track, ACCURACY, {"L1": runs}, {"L1": partial(dense, own)}
        )
        assert [each.code for each in messages] == ["trajectory.gap_interpolated"] * warned
    calls.clear()
    assert not interpolation_messages(
        trajectory(200.0), ACCURACY, {"L1": runs}, {"L1": partial(dense, points)}
    )
    assert not calls, "read only if the trajectory has gaps"


def test_the_reported_rate_is_that_of_the_file() -> None:
    time, tick = np.arange(0, 60, 0.5), 1e-4
    own, rates = (
        np.hstack(states(time)),
        (np.hstack(states(time + tick)) - np.hstack(states(time - tick))) / (2 * tick),
    )
    dense = insert_states(time, own, lambda: rates, longest_gap=1.0)
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


def held(time: np.ndarray, period: float, *, still: float = 0.0) -> LocalTrajectory:
    """Trajectory whose horizontal position is measured every ``period`` seconds only.

    The vessel is at rest for the first ``still`` seconds, and attitude and height vary throughout.
    """
    position, attitude = states(time)
    measured = np.floor(np.round(time / period, 6)) * period if period else time
    position[:, :2] = states(np.maximum(measured - still, 0.0))[0][:, :2]
    return LocalTrajectory(FRAME, time, position, attitude)


@pytest.mark.parametrize(("rate", "period"), [(50.0, 1.0), (50.0, 0.2), (10.0, 0.2), (200.0, 0.1)])
def test_positions_that_are_repeated_give_a_warning(rate: float, period: float) -> None:
    """At 2 m/s, a position that is 0.98 s old is wrong by 1.96 m."""
    track = held(np.arange(0, 60, 1 / rate), period)
    first, second = held_position_messages(track, ACCURACY, LINES)
    assert [str(each.subject) for each in (first, second)] == [
        str(Cause.of_line(name)) for name in ("L1", "L2")
    ]
    assert (first.code, first.level) == ("trajectory.position_held", Level.WARNING)
    age = period - 1 / rate
    assert first.params["longest"] == pytest.approx(age, abs=1e-6)
    assert first.params["shift"] == pytest.approx(2 * age, rel=0.01)


def test_a_position_that_is_frozen_once_gives_a_warning_on_its_line_only() -> None:
    time = np.arange(0, 60, 0.02)
    position, attitude = states(time)
    frozen = (time >= 45.0) & (time < 46.5)
    position[frozen] = position[np.argmax(frozen)]
    track = LocalTrajectory(FRAME, time, position, attitude)
    (message,) = held_position_messages(track, ACCURACY, LINES)
    assert message.params["line"] == "L2"
    assert message.params["longest"] == pytest.approx(1.48)
    assert message.params["shift"] == pytest.approx(2.96, rel=0.01)
    assert held_position_messages(track, ACCURACY, {"L1": LINES["L1"]}) == ()
    between = {"L1": np.concatenate([np.linspace(40, 44.9, 99), np.linspace(46.6, 55, 99)])}
    assert held_position_messages(track, ACCURACY, between) == ()


@pytest.mark.parametrize(
    "track",
    [
        pytest.param(trajectory(50.0), id="moving"),
        pytest.param(held(np.arange(0, 60, 0.02), 0.0, still=10.0), id="starts from rest"),
        pytest.param(held(np.arange(0, 60, 0.5), 0.0, still=10.0), id="starts at 2 Hz"),
        pytest.param(held(np.arange(0, 60, 0.02), 0.0, still=60.0), id="at rest"),
        pytest.param(held(np.arange(0, 60, 0.0005), 0.005), id="within the accuracy"),
    ],
)
def test_sound_positions_give_no_warning(track: LocalTrajectory) -> None:
    assert held_position_messages(track, ACCURACY, LINES) == ()


def test_positions_rounded_to_centimetres_give_no_warning() -> None:
    track = trajectory(200.0)
    rounded = LocalTrajectory(FRAME, track.time, np.round(track.position, 2), track.attitude)
    assert held_position_messages(rounded, ACCURACY, LINES) == ()


def test_bursts_of_states_in_millimetres_give_no_warning() -> None:
    """States 0.2 us apart, in bursts every 0.4 s, have the same position within each burst."""
    time = np.concatenate([0.4 * k + 2e-7 * np.arange(200) for k in range(150)])
    position, attitude = states(time)
    track = LocalTrajectory(FRAME, time, np.round(position, 3), attitude)
    assert held_position_messages(track, ACCURACY, LINES) == ()


def test_a_step_after_a_gap_gives_no_warning() -> None:
    """Points in a gap are not used."""
    time = np.concatenate([np.arange(0, 20, 0.02), np.arange(22, 60, 0.02)])
    position, attitude = states(time)
    position[990:1000] = position[990]
    track = LocalTrajectory(FRAME, time, position, attitude)
    assert held_position_messages(track, ACCURACY, LINES) == ()


@pytest.mark.parametrize("name", ["harbour", "lanl_truck", "lanl_tent"])
def test_the_reference_surveys_have_no_held_positions(shared_data: Path, name: str) -> None:
    read = format_of("sbet").read(shared_data / name / "trajectory.sbet", {})
    frame = LocalFrame(read.latitude[0], read.longitude[0], read.height[0])
    times = {name: np.linspace(read.time[0], read.time[-1], 20_000)}
    track = LocalTrajectory.of(read, frame)
    assert held_position_messages(track, ACCURACY, times) == ()
