"""Error and speed of the linear and cubic interpolation of a trajectory.

    pytest -s -n0 tests/benchmarks/bench_interpolation.py

uses a simulated motion in waves at 10, 50 and 200 Hz, and thinned real SBETs if they are in the
shared data.
"""

import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from lispac.io.trajectory.sbet import read_sbet
from lispac.survey.georeferencing import Mounting, georeference
from lispac.survey.trajectory import LocalTrajectory, Trajectory
from tests.survey.test_states_between import DURATION, linear, sbet

RATES = (10.0, 50.0, 200.0)
POINTS = 2_000_000
SHARED = Path(__file__).parents[2].parent / "shared"


def differences(local: LocalTrajectory, times: np.ndarray, truth: np.ndarray) -> np.ndarray:
    """Errors of position (m) and attitude (rad), shape (n, 6)."""
    poses = local.at(times)
    off = np.hstack([poses.position, poses.attitude]) - truth
    off[:, 3:] = np.remainder(off[:, 3:] + np.pi, 2 * np.pi) - np.pi
    return off


def words(off: np.ndarray) -> str:
    position, turn = 1e3 * np.abs(off[:, :3]), 1e3 * np.degrees(np.abs(off[:, 3:]))
    return (
        f"{position.max():8.3f} mm {turn.max():8.3f} mdeg (rms {np.sqrt((position**2).mean()):.4f} "
        f"mm, {np.sqrt((turn**2).mean()):.4f} mdeg)"
    )


@pytest.mark.parametrize("rate", RATES)
def test_error_and_speed(tmp_path: Path, rate: float) -> None:
    path = tmp_path / "a.sbet"
    frame = sbet(path, rate)
    track = read_sbet(path)
    times = 300_000 + np.random.default_rng(3).uniform(1, DURATION - 2, 20_000)
    sbet(tmp_path / "truth.sbet", 2000.0)
    exact = LocalTrajectory.of(linear(read_sbet(tmp_path / "truth.sbet")), frame).at(times)
    truth = np.hstack([exact.position, exact.attitude])
    straight, curved = LocalTrajectory.of(linear(track), frame), LocalTrajectory.of(track, frame)
    print(f"\n{rate:.0f} Hz, linear: {words(differences(straight, times, truth))}")
    print(f"{rate:.0f} Hz, cubic:  {words(differences(curved, times, truth))}")
    points = np.random.default_rng(4).uniform(-20, 20, (POINTS, 3))
    when = np.sort(300_000 + np.random.default_rng(5).uniform(1, DURATION - 2, POINTS))
    mounting = Mounting(np.zeros(3), np.zeros(3))
    seconds: dict[str, list[float]] = {"linear": [], "cubic": []}
    for _ in range(7):
        for name, local in (("linear", straight), ("cubic", curved)):
            start = time.perf_counter()
            georeference(points, when, local, mounting)
            seconds[name].append(time.perf_counter() - start)
    share = np.median(np.array(seconds["linear"]) / seconds["cubic"])
    print(
        f"{rate:.0f} Hz, {POINTS:,} points: {POINTS / np.median(seconds['cubic']) / 1e6:.1f} "
        f"million a second with {len(curved.time):,} states for {len(straight.time):,}, "
        f"{100 * share:.0f} % of the linear throughput"
    )


@pytest.mark.parametrize("path", sorted(SHARED.glob("data/**/*.sbet")) + sorted(
    path for path in SHARED.glob("data/**/*.out") if path.stat().st_size % 136 == 0
), ids=lambda path: path.name)  # fmt: skip
@pytest.mark.parametrize("rate", RATES[:2])
def test_thinning_a_real_trajectory(path: Path, rate: float) -> None:
    """Compare the thinned trajectory with the complete file."""
    track = read_sbet(path)
    if track.velocity is None:
        pytest.skip("without velocities")
    step = float(np.median(np.diff(track.time)))
    every = round(1 / (rate * step))
    if every < 2:
        pytest.skip("not dense enough")
    frame = track.mean_frame()
    whole = LocalTrajectory.of(linear(track), frame)
    some = thinned(track, every)
    times = track.time[every // 2 :: every][2:-2]
    truth = whole.at(times)
    truth = np.hstack([truth.position, truth.attitude])
    for name, each in (("linear", linear(some)), ("cubic", some)):
        local = LocalTrajectory.of(each, frame)
        usable = local.covers(times)
        print(
            f"\n{path.name} at {rate:.0f} Hz, {name}: "
            f"{words(differences(local, times[usable], truth[usable]))}"
        )


def thinned(track: Trajectory, every: int) -> Trajectory:
    rows = slice(None, None, every)
    return replace(
        track, time=track.time[rows], latitude=track.latitude[rows],
        longitude=track.longitude[rows], height=track.height[rows], attitude=track.attitude[rows],
        velocity=None if track.velocity is None else track.velocity[rows],
        attitude_rate=None if track.attitude_rate is None else track.attitude_rate[rows],
    )  # fmt: skip
