"""Motion of a vessel during a simulated survey: simulated lines or a recorded trajectory."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from lispac.errors import InputError
from lispac.messages import error
from lispac.simulation.vessel_motion import SailedLine, VesselMotion, sail_lines
from lispac.survey.trajectory import LocalTrajectory

MIN_ERROR_INTERVAL = 0.005
"""Smallest interval of simulated POS errors, seconds; recorded trajectories may have bursts."""
START_SECONDS_OF_WEEK = 2 * 86400 + 15 * 3600.0
"""Start of a simulated survey, GPS seconds of week: a Tuesday at 15:00."""


@dataclass(frozen=True)
class RecordedLeg:
    """A line to be recorded.

    Attributes
    ----------
    name : str
    heading_deg : float
    starboard : bool
        Whether the site is to starboard.
    """

    name: str
    heading_deg: float
    starboard: bool

    @classmethod
    def numbered_leg(cls, number: int, heading_deg: float, starboard: bool) -> "RecordedLeg":
        """Leg named after its number and heading."""
        return cls(f"L{number}_{round(heading_deg) % 360:03d}", heading_deg, starboard)


class MotionSource(Protocol):
    """Source of the true motion of the simulated vessel and of its recorded trajectory."""

    @property
    def start(self) -> float:
        """GPS seconds of week at time 0 of the motion."""

    @property
    def legs(self) -> tuple[RecordedLeg, ...]:
        """Lines, in the order of the recorded time spans."""

    def motion(self, generator: np.random.Generator) -> VesselMotion:
        """True states of the vessel."""


@dataclass(frozen=True, eq=False)
class SailedTrajectory:
    """Lines run one after the other (see `lispac.simulation.vessel_motion.sail_lines`).

    Attributes
    ----------
    lines : tuple of SailedLine
    height : float, metres
        Height of the POS in the local frame.
    """

    lines: tuple[SailedLine, ...]
    height: float

    @property
    def start(self) -> float:
        """GPS seconds of week."""
        return START_SECONDS_OF_WEEK

    @property
    def legs(self) -> tuple[RecordedLeg, ...]:
        """Legs, one for each line, named after its number and heading."""
        return tuple(
            RecordedLeg.numbered_leg(k + 1, float(np.degrees(each.heading)), each.starboard)
            for k, each in enumerate(self.lines)
        )

    def motion(self, generator: np.random.Generator) -> VesselMotion:
        """Motion of the vessel: its courses and the motion due to the sea."""
        return sail_lines(self.lines, self.height, generator)


@dataclass(frozen=True)
class TrajectoryStretch:
    """A part of a trajectory that is recorded as a line.

    Attributes
    ----------
    start, stop : float, seconds
        In the time base of the trajectory.
    starboard : bool
        Whether the site lies to starboard.
    """

    start: float
    stop: float
    starboard: bool


@dataclass(frozen=True, eq=False)
class RecordedTrajectory:
    """A recorded trajectory used as the truth.

    Attributes
    ----------
    trajectory : LocalTrajectory
    stretches : tuple of TrajectoryStretch
    """

    trajectory: LocalTrajectory
    stretches: tuple[TrajectoryStretch, ...]

    @property
    def start(self) -> float:
        """Always 0: times are those of the trajectory."""
        return 0.0

    @property
    def legs(self) -> tuple[RecordedLeg, ...]:
        """Legs, one for each stretch, named after its median heading."""
        headings = []
        for each in self.stretches:
            time = self.trajectory.time
            own = (time >= each.start) & (time <= each.stop)
            headings.append(float(np.degrees(np.median(self.trajectory.attitude[own, 2]))) % 360)
        return tuple(
            RecordedLeg.numbered_leg(k + 1, heading, each.starboard)
            for k, (heading, each) in enumerate(zip(headings, self.stretches, strict=True))
        )

    def motion(self, generator: np.random.Generator) -> VesselMotion:
        """Recorded states; no random numbers are used."""
        known = self.trajectory
        interval = max(float(np.median(np.diff(known.time))), MIN_ERROR_INTERVAL)
        recorded = tuple((each.start, each.stop) for each in self.stretches)
        return VesselMotion(known.time, known.position, known.attitude, recorded, interval)

    def require_stretches_covered(self, latency: float) -> None:
        """Raise an error if the trajectory does not cover one of the stretches.

        Parameters
        ----------
        latency : float, seconds
            Added to the times of the stretches.

        Raises
        ------
        InputError
            A stretch starts before or ends after the trajectory, or lies in a gap.
        """
        time = self.trajectory.time
        for k, each in enumerate(self.stretches):
            ends = np.array([each.start, each.stop]) + latency
            inside = time[(time > ends[0]) & (time < ends[1])]
            if not self.trajectory.covers(np.concatenate([ends, inside])).all() or not len(inside):
                raise InputError(
                    error(
                        "simulation.line_outside",
                        number=k + 1,
                        start=float(ends[0]),
                        stop=float(ends[1]),
                        first=float(time[0]),
                        last=float(time[-1]),
                    )
                )
