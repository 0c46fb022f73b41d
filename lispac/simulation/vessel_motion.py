"""Motion of the vessel: straight lines, turns between them, and sea motion."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

SAMPLE_RATE = 200.0
"""Samples of the trajectory per second."""
SINE_COUNT = 4
"""Number of sines in each component of the sea motion."""


@dataclass(frozen=True)
class VesselHandling:
    """Speeds, turns and sea motion of a vessel.

    Attributes
    ----------
    speed, speed_abeam : float, metres per second
        On the line, and in front of the boards, where the vessel slows down.
    slow_time : float, seconds
        Half-width of the slow part: the reduction of the speed falls to 1/e of its maximum.
    ramp : float, seconds
        Time for acceleration before a line, and for stopping after it.
    transit : float, seconds
        Time from one stop to the start of the next acceleration, including the turn.
    wait : float, seconds
        Time at rest at both ends of the survey.
    roll, pitch, yaw : float, radians, 1 sigma
    heave, drift : float, metres, 1 sigma
    periods : pair of float, seconds
        Shortest and longest period of the sea motion.
    """

    speed: float = 2.2
    speed_abeam: float = 0.6
    slow_time: float = 4.5
    ramp: float = 6.0
    transit: float = 48.0
    wait: float = 15.0
    roll: float = np.radians(0.9)
    pitch: float = np.radians(0.35)
    yaw: float = np.radians(0.3)
    heave: float = 0.05
    drift: float = 0.03
    periods: tuple[float, float] = (4.0, 9.0)


SMALL_VESSEL = VesselHandling()
"""The small vessel of the built-in survey."""


@dataclass(frozen=True)
class SailedLine:
    """A straight line; the scanner records from ``run_in`` before abeam to ``run_out`` after it.

    Attributes
    ----------
    heading : float, radians clockwise from north
    abeam : pair of float, metres, local
        North and west of the vessel when the boards are abeam.
    run_in, run_out : float, metres along the course
    starboard : bool
        Whether the boards pass to starboard.
    handling : VesselHandling
    """

    heading: float
    abeam: tuple[float, float]
    run_in: float
    run_out: float
    starboard: bool
    handling: VesselHandling = SMALL_VESSEL

    @cached_property
    def times(self) -> tuple[float, float]:
        """Start and stop of recording relative to abeam, on the trajectory's samples, seconds."""
        before, after = (
            (run + self._lost_distance) / self.handling.speed for run in (self.run_in, self.run_out)
        )
        return (
            -float(np.ceil(before * SAMPLE_RATE)) / SAMPLE_RATE,
            float(np.ceil(after * SAMPLE_RATE)) / SAMPLE_RATE,
        )

    @property
    def _lost_distance(self) -> float:
        """Distance lost by slowing down, on either side of abeam, metres."""
        own = self.handling
        return float((own.speed - own.speed_abeam) * own.slow_time * np.sqrt(np.pi) / 2)

    def _speed_at(self, time: float) -> float:
        own = self.handling
        slow = np.exp(-((time / own.slow_time) ** 2))
        return float(own.speed - (own.speed - own.speed_abeam) * slow)

    def _distance_along(self, time: Array) -> Array:
        from scipy.special import erf

        own = self.handling
        return np.asarray(own.speed * time - self._lost_distance * erf(time / own.slow_time))

    def course(self) -> Array:
        """Positions from rest through the recorded part to rest, shape (n, 2), metres."""
        start, stop = self.times
        ramp = self.handling.ramp
        first, last = round((start - ramp) * SAMPLE_RATE), round((stop + ramp) * SAMPLE_RATE)
        time = np.arange(first, last + 1) / SAMPLE_RATE
        along = self._distance_along(np.clip(time, start, stop))
        along -= self._speed_at(start) * _ramp_distance(np.clip(start - time, 0, ramp), ramp)
        along += self._speed_at(stop) * _ramp_distance(np.clip(time - stop, 0, ramp), ramp)
        direction = np.array([np.cos(self.heading), -np.sin(self.heading)])
        return np.asarray(self.abeam + along[:, None] * direction)


def _ramp_distance(time: Array, ramp: float) -> Array:
    """Distance in ``time`` with a speed that decreases smoothly from 1 to 0 in ``ramp`` seconds."""
    u = time / ramp
    return np.asarray(ramp * (u - u**3 + u**4 / 2))


def _smooth_step(count: int) -> Array:
    """Values from 0 to 1, with zero speed and acceleration at both ends, which are excluded."""
    u = np.arange(1, count) / count
    return np.asarray(u**3 * (10 - 15 * u + 6 * u**2))


@dataclass(frozen=True, eq=False)
class VesselMotion:
    """True positions and attitudes of the simulated vessel at sampled times.

    Attributes
    ----------
    time : ndarray of shape (n,), seconds from the start of the survey
    position : ndarray of shape (n, 3), metres, local
    attitude : ndarray of shape (n, 3), radians
        Roll, pitch, heading relative to the axes of the local frame, without jumps.
    recorded : tuple of pairs of float, seconds
        Start and stop of recording of each line.
    interval : float, seconds
        Between two samples.
    """

    time: Array
    position: Array
    attitude: Array
    recorded: tuple[tuple[float, float], ...]
    interval: float = 1 / SAMPLE_RATE


def sail_lines(
    lines: Sequence[SailedLine], height: float, generator: np.random.Generator
) -> VesselMotion:
    """Simulate the lines one after the other as one continuous motion.

    Between two lines the vessel stops, turns by the smaller angle while it moves to the next line,
    and starts again; turns by 180 deg are to starboard.

    Parameters
    ----------
    lines : sequence of SailedLine
        All with the same handling.
    height : float, metres
        Mean height of the POS in the local frame.
    """
    own = lines[0].handling
    wait = round(own.wait * SAMPLE_RATE)
    blend = _smooth_step(round(own.transit * SAMPLE_RATE))
    courses = [each.course() for each in lines]
    heading = lines[0].heading
    stretches = [np.repeat(courses[0][:1], wait, axis=0)]
    headings = [np.full(wait, heading)]
    recorded = []
    for i, (each, course) in enumerate(zip(lines, courses, strict=True)):
        if i > 0:
            stop = stretches[-1][-1]
            stretches.append(stop + blend[:, None] * (course[0] - stop))
            turn = -((heading - each.heading + np.pi) % (2 * np.pi) - np.pi)
            headings.append(heading + blend * turn)
            heading += turn
        start = sum(map(len, stretches)) / SAMPLE_RATE + own.ramp
        recorded.append((start, start + each.times[1] - each.times[0]))
        stretches.append(course)
        headings.append(np.full(len(course), heading))
    stretches.append(np.repeat(courses[-1][-1:], wait, axis=0))
    headings.append(np.full(wait, heading))

    level = np.concatenate(stretches)
    time = np.arange(len(level)) / SAMPLE_RATE
    drift_n, drift_w, heave, roll, pitch, yaw = (
        _sea_motion(time, sigma, own.periods, stream)
        for sigma, stream in zip(
            (own.drift, own.drift, own.heave, own.roll, own.pitch, own.yaw),
            generator.spawn(6),
            strict=True,
        )
    )
    position = np.stack([level[:, 0] + drift_n, level[:, 1] + drift_w, height + heave], axis=1)
    attitude = np.stack([roll, pitch, np.concatenate(headings) + yaw], axis=1)
    return VesselMotion(time, position, attitude, tuple(recorded))


def _sea_motion(
    time: Array, sigma: float, range_of: tuple[float, float], generator: np.random.Generator
) -> Array:
    """Smooth motion as a sum of sines with random periods and phases."""
    periods = generator.uniform(*range_of, SINE_COUNT)
    phases = generator.uniform(0, 2 * np.pi, SINE_COUNT)
    weights = generator.uniform(0.5, 1.0, SINE_COUNT)
    weights *= sigma * np.sqrt(2) / np.linalg.norm(weights)
    waves = np.sin(2 * np.pi * time / periods[:, None] + phases[:, None])
    return np.asarray(weights @ waves)
