"""How the vessel moves: passes along straight courses, turns between them, and the sea."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray
from scipy.special import erf

Array = NDArray[np.float64]

RATE = 200.0  # trajectory samples per second
FAR_SPEED, NEAR_SPEED = 2.2, 0.6  # m/s: a helmsman slows down in front of the boards
NEAR_TIME = 4.5  # s, half-width of the slow stretch
RAMP = 6.0  # s to come up to speed before a pass and to stop after it
TRANSIT = 48.0  # s from one stop to the start of the next run-up, turning on the way
WAIT = 15.0  # s of standing still at both ends of the survey
# Standard deviations of the motion on top of the course
ROLL, PITCH, YAW = np.radians([0.9, 0.35, 0.3])
HEAVE, DRIFT = 0.05, 0.03  # metres
PERIODS = (4.0, 9.0)  # s
SINES = 4


@dataclass(frozen=True)
class Pass:
    """A straight pass; the scanner records from ``run_in`` before abeam to ``run_out`` after it.

    Attributes
    ----------
    heading : float, radians clockwise from north
    abeam : pair of float, metres, local
        North and west of the vessel when the boards are abeam.
    run_in, run_out : float, metres along the course
    starboard : bool
        Whether the boards pass to starboard.
    """

    heading: float
    abeam: tuple[float, float]
    run_in: float
    run_out: float
    starboard: bool

    @cached_property
    def times(self) -> tuple[float, float]:
        """Start and stop of recording relative to abeam, on the trajectory's samples, seconds."""
        slow = (FAR_SPEED - NEAR_SPEED) * NEAR_TIME * np.sqrt(np.pi) / 2
        before, after = ((run + slow) / FAR_SPEED for run in (self.run_in, self.run_out))
        return -float(np.ceil(before * RATE)) / RATE, float(np.ceil(after * RATE)) / RATE

    def _speed(self, time: float) -> float:
        return float(FAR_SPEED - (FAR_SPEED - NEAR_SPEED) * np.exp(-((time / NEAR_TIME) ** 2)))

    def _along(self, time: Array) -> Array:
        slow = (FAR_SPEED - NEAR_SPEED) * NEAR_TIME * np.sqrt(np.pi) / 2
        return np.asarray(FAR_SPEED * time - slow * erf(time / NEAR_TIME))

    def course(self) -> Array:
        """Positions from standstill over the recorded stretch to standstill, shape (n, 2)."""
        start, stop = self.times
        time = np.arange(round((start - RAMP) * RATE), round((stop + RAMP) * RATE) + 1) / RATE
        along = self._along(np.clip(time, start, stop))
        along -= self._speed(start) * _ramp_length(np.clip(start - time, 0, RAMP))
        along += self._speed(stop) * _ramp_length(np.clip(time - stop, 0, RAMP))
        direction = np.array([np.cos(self.heading), -np.sin(self.heading)])
        return np.asarray(self.abeam + along[:, None] * direction)


def _ramp_length(time: Array) -> Array:
    """Way made in ``time`` at unit speed that fades out smoothly over `RAMP` seconds."""
    u = time / RAMP
    return np.asarray(RAMP * (u - u**3 + u**4 / 2))


def _blend(count: int) -> Array:
    """From 0 to 1, at rest and without acceleration at both ends (ends left out)."""
    u = np.arange(1, count) / count
    return np.asarray(u**3 * (10 - 15 * u + 6 * u**2))


@dataclass(frozen=True, eq=False)
class Motion:
    """The vessel's true states, sampled.

    Attributes
    ----------
    time : ndarray of shape (n,), seconds from the start of the survey
    position : ndarray of shape (n, 3), metres, local
    attitude : ndarray of shape (n, 3), radians
        Roll, pitch, heading against the axes of the local frame, without jumps.
    recorded : tuple of pairs of float, seconds
        Start and stop of recording of each pass.
    """

    time: Array
    position: Array
    attitude: Array
    recorded: tuple[tuple[float, float], ...]


def sail(passes: Sequence[Pass], height: float, generator: np.random.Generator) -> Motion:
    """Sail the passes one after the other in one unbroken motion.

    Between two passes the vessel stops, turns the short way while it moves over, and starts
    again; straight starboard where it must turn about.

    Parameters
    ----------
    height : float, metres
        Mean height of the POS in the local frame.
    """
    wait = round(WAIT * RATE)
    blend = _blend(round(TRANSIT * RATE))
    courses = [each.course() for each in passes]
    heading = passes[0].heading
    stretches = [np.repeat(courses[0][:1], wait, axis=0)]
    headings = [np.full(wait, heading)]
    recorded = []
    for i, (each, course) in enumerate(zip(passes, courses, strict=True)):
        if i > 0:
            stop = stretches[-1][-1]
            stretches.append(stop + blend[:, None] * (course[0] - stop))
            turn = -((heading - each.heading + np.pi) % (2 * np.pi) - np.pi)
            headings.append(heading + blend * turn)
            heading += turn
        start = sum(map(len, stretches)) / RATE + RAMP
        recorded.append((start, start + each.times[1] - each.times[0]))
        stretches.append(course)
        headings.append(np.full(len(course), heading))
    stretches.append(np.repeat(courses[-1][-1:], wait, axis=0))
    headings.append(np.full(wait, heading))

    level = np.concatenate(stretches)
    time = np.arange(len(level)) / RATE
    drift_n, drift_w, heave, roll, pitch, yaw = (
        _sea(time, sigma, stream)
        for sigma, stream in zip(
            (DRIFT, DRIFT, HEAVE, ROLL, PITCH, YAW), generator.spawn(6), strict=True
        )
    )
    position = np.stack([level[:, 0] + drift_n, level[:, 1] + drift_w, height + heave], axis=1)
    attitude = np.stack([roll, pitch, np.concatenate(headings) + yaw], axis=1)
    return Motion(time, position, attitude, tuple(recorded))


def _sea(time: Array, sigma: float, generator: np.random.Generator) -> Array:
    """A smooth motion: a few sines with random periods and phases."""
    periods = generator.uniform(*PERIODS, SINES)
    phases = generator.uniform(0, 2 * np.pi, SINES)
    weights = generator.uniform(0.5, 1.0, SINES)
    weights *= sigma * np.sqrt(2) / np.linalg.norm(weights)
    waves = np.sin(2 * np.pi * time / periods[:, None] + phases[:, None])
    return np.asarray(weights @ waves)
