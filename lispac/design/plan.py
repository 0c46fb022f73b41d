"""Plan of a calibration survey: targets, lines past them, and the system."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.stochastic_model import PosErrors
from lispac.simulation.closed_form_survey import Ball, Board, Course
from lispac.simulation.pos_errors import HYDROGRAPHIC_INS, PosErrorModel
from lispac.simulation.scanner import Scanner
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

SIX_HEADINGS_DEG = (0, 180, 45, 225, 315, 135)
"""Headings of the pattern of six lines, degrees, for a wall in the east (thesis figure 3.3)."""

STRAIGHT_MARGIN = 5.0
"""Length of the straight part of a line before the first and after the last target, metres."""


@dataclass(frozen=True, eq=False)
class System:
    """System on the vessel: scanner, POS and mounting.

    Attributes
    ----------
    mounting : Mounting
        Approximate mounting; the sigmas hardly depend on it.
    scanner : Scanner
    pos : PosErrorModel
    pos_errors : {"correlated", "independent"}
        Model of the POS errors in the adjustment: correlated in time, or independent for each
        point as in the thesis.
    lever_arm_sigma : tuple of three float, metres, body frame
        Sigmas of the lever arm as it will be measured; zero for an exact one.
    """

    mounting: Mounting = field(
        default_factory=lambda: Mounting(np.array([0.0, 0.0, 2.0]), np.zeros(3))
    )
    scanner: Scanner = field(default_factory=lambda: Scanner(150_000.0))
    pos: PosErrorModel = HYDROGRAPHIC_INS
    pos_errors: PosErrors = "correlated"
    lever_arm_sigma: tuple[float, float, float] = (0.0, 0.0, 0.0)

    def with_pos_scaled(self, factor: float) -> "System":
        """System with the sigmas of its POS multiplied by a factor."""
        north, east, up = (factor * sigma for sigma in self.pos.sigma_position)
        roll, pitch, heading = (factor * sigma for sigma in self.pos.sigma_attitude)
        return replace(
            self,
            pos=replace(
                self.pos,
                sigma_position=(north, east, up),
                sigma_attitude=(roll, pitch, heading),
            ),
        )


@dataclass(frozen=True)
class Line:
    """A straight line past the site.

    Attributes
    ----------
    heading_deg : float, degrees clockwise from north
    distance : float, metres
        Distance from the middle of the site when it is abeam.
    starboard : bool
        Whether the site lies to starboard; to port otherwise.
    speed : float, metres per second
    """

    heading_deg: float
    distance: float = 15.0
    starboard: bool = True
    speed: float = 1.0

    @property
    def name(self) -> str:
        """Short name with heading, distance and side."""
        side = "starboard" if self.starboard else "port"
        return f"{self.heading_deg % 360:03.0f} deg, {self.distance:g} m to {side}"

    def abeam(self, middle: Sequence[float]) -> tuple[float, float]:
        """Position of the vessel when the middle of the site is abeam: north and west, metres."""
        heading = np.radians(self.heading_deg)
        # Direction to port of the course; the vessel lies there if the site is to starboard.
        port = np.array([np.sin(heading), np.cos(heading)])
        north, west = np.array(middle[:2]) + (port if self.starboard else -port) * self.distance
        return float(north), float(west)


@dataclass(frozen=True, eq=False)
class Plan:
    """A planned survey.

    Attributes
    ----------
    targets : tuple of Board or Ball
    lines : tuple of Line
        In the order of the survey.
    middle : tuple of float, metres, local
        Middle of the site; the distances of the lines refer to it.
    system : System
    interval : float, seconds
        Time from one line to the next, including the turn.
    flatness : float, metres
        Standard deviation of the difference between a target in one line and its common shape in
        all lines (`StochasticModel.surface`), due to bent boards or range errors. Targets may have
        their own value.
    """

    targets: tuple[Board | Ball, ...]
    lines: tuple[Line, ...]
    middle: tuple[float, float, float]
    system: System = field(default_factory=System)
    interval: float = 90.0
    flatness: float = 0.0005

    @property
    def courses(self) -> tuple[Course, ...]:
        """Courses of the lines in space and time."""
        return tuple(
            Course(
                f"L{k + 1}",
                float(np.radians(line.heading_deg)),
                line.abeam(self.middle),
                50.0 + k * self.interval,
                line.speed,
            )
            for k, line in enumerate(self.lines)
        )

    @property
    def straight_extents(self) -> tuple[tuple[float, float], ...]:
        """Limits of the straight part of each line, metres from the point abeam of the middle."""
        found = []
        for course in self.courses:
            along = [
                float((np.array(target.centre[:2]) - course.abeam) @ course.direction[:2])
                for target in self.targets
            ]
            found.append((min(along) - STRAIGHT_MARGIN, max(along) + STRAIGHT_MARGIN))
        return tuple(found)

    @property
    def duration(self) -> float:
        """Time on site, seconds."""
        return len(self.lines) * self.interval

    @property
    def surveyed_targets(self) -> tuple[Board | Ball, ...]:
        """Targets with surveyed control."""
        return tuple(target for target in self.targets if target.control_sigma is not None)

    def without_control(self, names: Collection[str] | None = None) -> "Plan":
        """Plan in which some targets, or by default all, have no surveyed control."""
        return self.with_targets(
            [
                replace(target, control_sigma=None)
                if names is None or target.name in names
                else target
                for target in self.targets
            ]
        )

    def with_targets(self, targets: Sequence[Board | Ball]) -> "Plan":
        """Plan with the same lines and other targets."""
        return replace(self, targets=tuple(targets))

    def with_lines(self, lines: Sequence[Line]) -> "Plan":
        """Plan with the same targets and other lines."""
        return replace(self, lines=tuple(lines))


def line_pattern(
    headings_deg: Sequence[float] = SIX_HEADINGS_DEG,
    distance: float = 15.0,
    *,
    facing_deg: float = 270.0,
    speed: float = 1.0,
) -> tuple[Line, ...]:
    """Create lines with given headings at one distance from the site, in front of its wall.

    Parameters
    ----------
    distance : float, metres
    facing_deg : float, degrees
        Azimuth that the wall faces; the vessel stays on that side.
    speed : float, metres per second
    """
    lines = []
    for heading in headings_deg:
        # The vessel stays in front of the wall: the heading determines the side of the site.
        to_port = np.sin(np.radians(heading - facing_deg)) > 0
        lines.append(Line(float(heading), distance, bool(to_port), speed))
    return tuple(lines)
