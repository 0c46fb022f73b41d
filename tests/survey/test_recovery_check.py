"""Tests of the diagnosis of points recovered from clouds with a wrong setup."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from lispac.geometry.frames import LocalFrame
from lispac.geometry.rotations import rotation_matrix
from lispac.messages import Level, Message
from lispac.survey.crs import CoordinateSystem, coordinate_system
from lispac.survey.georeferencing import Mounting
from lispac.survey.point_mapping import ScannerPointConverter
from lispac.survey.scanner_frame_recovery import RecoverySetup
from lispac.survey.scanner_frame_recovery_check import LineSample, recovery_messages
from lispac.survey.trajectory import LocalTrajectory
from tests.support.long_runs import LONG, others_long
from tests.support.message_codes import codes

LEVER = np.array([-0.2, 0.05, 2.0])
UTM, FEET = "EPSG:32619", "EPSG:2249"  # the second in US survey feet, Massachusetts
PLACES = {UTM: (48.0, -69.0), FEET: (42.3, -71.0)}


def trajectory(seed: int, system: str = UTM) -> LocalTrajectory:
    """Return two minutes of trajectory with waves of some degrees and a turn."""
    rng = np.random.default_rng(seed)
    time = np.arange(0, 120, 0.02)
    latitude, longitude = np.radians(PLACES[system])
    waves = [
        np.radians(size) * np.sin(2 * np.pi * time / period + phase)
        for size, period, phase in zip(
            (3.0, 1.5, 2.0), rng.uniform(4, 9, 3), rng.uniform(0, 6, 3), strict=True
        )
    ]
    heading = 0.5 + 0.02 * time + waves[2]
    position = np.stack([1.5 * time, 0.3 * time, 0.1 * np.sin(time)], axis=1)
    frame = LocalFrame(latitude, longitude, 20.0)
    return LocalTrajectory(frame, time, position, np.stack([waves[0], waves[1], heading], axis=1))


def profiler(seed: int, turn: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return points of a profiler across the x axis, on two sides, and their times."""
    rng = np.random.default_rng(seed + 100)
    count = 6000
    near, far = rng.uniform(-0.5, 0.7, count), rng.uniform(2, 4, count)
    angle = np.where(rng.random(count) < 0.6, near, far)
    ranges = rng.uniform(5, 40, count) + rng.normal(0, 0.005, count)
    beams = np.stack([0 * angle, np.cos(angle), np.sin(angle)], axis=1)
    return (beams * ranges[:, None]) @ turn.T, np.sort(rng.uniform(25, 95, count))


def cloud(
    seed: int, system: str = UTM, turn: np.ndarray | None = None
) -> tuple[np.ndarray, np.ndarray, RecoverySetup]:
    """Return a georeferenced cloud rounded to 1 mm, its times, and the setup that made it."""
    own = coordinate_system(system)
    made = RecoverySetup(
        own, trajectory(seed, system), Mounting(LEVER, np.radians([0.3, -0.4, 0.6]))
    )
    points, time = profiler(seed, np.eye(3) if turn is None else turn)
    placed = ScannerPointConverter(own, made.trajectory, made.mounting).to_map(points, time)
    step = 0.001 / np.array(own.metres)
    return np.round(placed / step) * step, time, made


def found(
    points: np.ndarray, time: np.ndarray, recovery: RecoverySetup, ring: np.ndarray | None = None
) -> Message | None:
    messages = recovery_messages("L1", LineSample(points, time, ring), recovery)
    assert len(messages) <= 1
    return messages[0] if messages else None


SEEDS = (1, pytest.param(2, marks=pytest.mark.long))


@pytest.mark.parametrize(
    ("system", "seed"), [*((UTM, seed) for seed in range(10)), (FEET, 0), (FEET, 1)]
)
def test_a_cloud_with_the_right_setup_has_no_message(seed: int, system: str) -> None:
    assert found(*cloud(seed, system)) is None


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(
    ("system", "offset"), others_long([(UTM, 28.4), (FEET, -44.1), (UTM, 6.3)], 2)
)
def test_a_height_offset_is_diagnosed(seed: int, system: str, offset: float) -> None:
    points, time, made = cloud(seed, system)
    points[:, 2] += offset / made.system.metres[2]
    message = found(points, time, made)
    assert message is not None
    assert (message.code, message.level) == ("recovery.height_offset", Level.WARNING)
    assert message.params["offset"] == pytest.approx(offset, abs=0.05)
    (action,) = message.actions
    assert action.params["name"] == "height"
    corrected = coordinate_system(system, height=action.params["value"])
    assert found(points, time, replace(made, system=corrected)) is None


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize(
    "shift", others_long([18.0, 1.0, -1.0, 0.3], lambda shift: shift in (18.0, 0.3))
)
def test_a_time_offset_is_diagnosed(seed: int, shift: float) -> None:
    points, time, made = cloud(seed)
    message = found(points, time - shift, made)
    assert message is not None
    assert message.code == "recovery.time_offset"
    assert message.params["value"] == pytest.approx(shift, abs=0.01)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("wrong", others_long([1.0, -0.5]))
def test_a_wrong_lever_arm_is_diagnosed(seed: int, wrong: float) -> None:
    """The error is along the mirror axis; across it, points stay in the plane of the beams."""
    points, time, made = cloud(seed)
    lever = LEVER + [wrong, 0, 0]
    message = found(points, time, replace(made, mounting=replace(made.mounting, lever_arm=lever)))
    assert message is not None
    assert message.code == "recovery.lever_arm_x"
    assert message.params["value"] == pytest.approx(-wrong, abs=0.02)


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("signs", [(1, -1, 1), (-1, -1, 1)])
def test_wrong_signs_of_the_attitude_are_diagnosed(seed: int, signs: tuple[int, int, int]) -> None:
    points, time, made = cloud(seed)
    turned = replace(made.trajectory, attitude=made.trajectory.attitude * np.array(signs))
    message = found(points, time, replace(made, trajectory=turned))
    assert message is not None
    names = {"recovery.pitch_sign", "recovery.roll_pitch_signs", "recovery.several_causes"}
    assert message.code in names
    if message.code == "recovery.several_causes":
        assert {"suspect.pitch_sign", "suspect.attitude_signs"} & set(
            codes(message.params["causes"])
        )


@pytest.mark.parametrize("seed", SEEDS)
def test_a_wrong_trajectory_has_no_single_cause(seed: int) -> None:
    points, time, made = cloud(seed)
    drift = np.radians(1.5) * np.sin(made.trajectory.time[:, None] / [3.0, 2.0, 5.0])
    other = replace(made.trajectory, attitude=made.trajectory.attitude + drift)
    message = found(points, time, replace(made, trajectory=other))
    assert message is not None
    assert message.code == "recovery.unexplained"


@pytest.mark.parametrize("seed", SEEDS)
def test_a_wrong_boresight_is_a_note(seed: int) -> None:
    points, time, made = cloud(seed)
    mounting = replace(made.mounting, boresight=np.radians([0.3, -0.4, 25.6]))
    message = found(points, time, replace(made, mounting=mounting))
    assert message is not None
    assert (message.code, message.level) == ("recovery.boresight_used", Level.NOTE)
    assert message.params["turn"] == pytest.approx(np.radians(25.0), abs=np.radians(0.5))


def cone(rng: np.random.Generator, count: int) -> np.ndarray:
    azimuth = rng.uniform(0, 2 * np.pi, count)
    return np.stack([np.cos(azimuth), np.sin(azimuth), np.full(count, 0.4)], axis=1)


def spinning(rng: np.random.Generator, count: int) -> np.ndarray:
    elevation = np.radians(rng.choice(np.linspace(-25, 15, 32), count))
    azimuth = rng.uniform(0, 2 * np.pi, count)
    flat = np.cos(elevation)
    return np.stack([flat * np.cos(azimuth), flat * np.sin(azimuth), np.sin(elevation)], axis=1)


@pytest.mark.parametrize("beams", [cone, spinning])
def test_scanners_other_than_profilers_have_no_message(
    beams: Callable[[np.random.Generator, int], np.ndarray],
) -> None:
    _, time, made = cloud(1)
    rng = np.random.default_rng(5)
    points = beams(rng, len(time)) * rng.uniform(5, 40, len(time))[:, None]
    placed = ScannerPointConverter(made.system, made.trajectory, made.mounting).to_map(points, time)
    assert found(placed, time, made) is None


def other_scanner(
    seed: int, kind: str
) -> tuple[np.ndarray, np.ndarray, RecoverySetup, np.ndarray | None]:
    """Return a cloud of a conical or spinning scanner, its times, its setup and its rings."""
    _, time, made = cloud(seed)
    rng = np.random.default_rng(seed + 50)
    count, ring = len(time), None
    if kind == "cone":
        beams = cone(rng, count)
        beams /= np.linalg.norm(beams, axis=1)[:, None]
    else:
        ring = rng.integers(0, 32, count)
        elevation = np.radians(np.linspace(-25, 15, 32))[ring]
        azimuth = rng.uniform(0, 2 * np.pi, count)
        flat = np.cos(elevation)
        beams = np.stack(
            [flat * np.cos(azimuth), flat * np.sin(azimuth), np.sin(elevation)], axis=1
        )
    ranges = rng.uniform(5, 40, count) + rng.normal(0, 0.01, count)
    mapper = ScannerPointConverter(made.system, made.trajectory, made.mounting)
    return mapper.to_map(beams * ranges[:, None], time), time, made, ring


@pytest.mark.parametrize("seed", SEEDS)
@pytest.mark.parametrize("kind", others_long(["cone", "rings"]))
def test_errors_are_diagnosed_with_other_scanners(seed: int, kind: str) -> None:
    points, time, made, ring = other_scanner(seed, kind)
    assert found(points, time, made, ring) is None
    raised = points + [0, 0, 28.4]
    message = found(raised, time, made, ring)
    assert message is not None
    assert message.code == "recovery.height_offset"
    assert message.params["offset"] == pytest.approx(28.4, abs=0.05)
    late = found(points, time - 18.0, made, ring)
    assert late is not None
    assert late.code == "recovery.time_offset"
    assert late.params["value"] == pytest.approx(18.0, abs=0.01)
    lever = replace(made.mounting, lever_arm=LEVER + [0.8, 0, 0])
    wrong = found(points, time, replace(made, mounting=lever), ring)
    assert wrong is not None
    assert wrong.code in ("recovery.lever_arm_x", "recovery.several_causes")


def test_lasers_are_numbered_consistently_over_all_parts_of_a_line() -> None:
    parts = [
        LineSample(np.zeros((3, 3)), np.zeros(3), np.array(own)) for own in ([7, 9, 9], [12, 7, 9])
    ]
    joined = LineSample.joined(parts)
    assert joined.ring is not None
    assert joined.ring.tolist() == [0, 1, 1, 2, 0, 1]
    assert LineSample.joined([parts[0], replace(parts[1], ring=None)]).ring is None


@LONG
def test_a_height_offset_is_diagnosed_in_another_mounting() -> None:
    turn = rotation_matrix(*np.radians([90.0, 0.0, 90.0]))
    points, time, made = cloud(4, turn=turn)
    assert found(points, time, made) is None
    points[:, 2] += 30.0
    message = found(points, time, made)
    assert message is not None
    assert message.code == "recovery.height_offset"


def test_height_offset_applies_in_both_directions() -> None:
    plain, raised = (coordinate_system(UTM, height=height) for height in ("", "-28.4"))
    assert isinstance(raised, CoordinateSystem)
    points = np.array([[500_000.0, 5_316_000.0, 30.0], [500_100.0, 5_316_200.0, -2.0]])
    down = points - [0, 0, 28.4]
    for one, other in zip(raised.to_geodetic(points), plain.to_geodetic(down), strict=True):
        np.testing.assert_allclose(one, other, rtol=0, atol=1e-9)
    np.testing.assert_allclose(
        raised.from_geodetic(*raised.to_geodetic(points)), points, rtol=0, atol=1e-6
    )
