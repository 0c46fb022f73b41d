"""Edits of a plan, independent of the window; each function returns a changed plan."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import radians

import numpy as np

from lispac.design.plan import Line, Plan, System
from lispac.design.plan_choices import thesis_plan
from lispac.design.site import Site, Wall
from lispac.gui.appearance import units
from lispac.io.config.plan_file import TitledPlan
from lispac.io.config.sensor_file import PosAccuracy, ScannerSpecification
from lispac.simulation.closed_form_survey import Ball, Board

MIN_LINE_DISTANCE_M, MAX_LINE_DISTANCE_M = 1.0, 200.0
"""Smallest and largest distance to which a line can be dragged, metres."""
HEADING_SNAP_DEG = 5.0
"""Step of a heading while a line is turned with the mouse, degrees."""
MAX_LINES, MAX_TARGETS = 24, 12
"""Largest numbers of lines and targets in a plan; each of them slows down a drag."""
DEFAULT_PLAN_TITLE = "Site"


@dataclass(frozen=True)
class PlacedTarget:
    """Target in coordinates of the wall: to the right, towards the water and up.

    Attributes
    ----------
    along, off, up : float, metres
        Coordinates to the right along the wall, towards the water, and above the POS of the vessel.
    lean, facing : float, degrees
        Inclination of a board from the horizontal, and azimuth that it faces; unused for a ball.
    width, height : float, metres
        Both are the diameter of a ball.
    flatness : float or None, metres
        Flatness of the board; None for that of the plan.
    control_sigma : float or None, metres
        Standard deviation of the surveyed control; None without control.
    """

    name: str
    along: float
    off: float
    up: float
    lean: float = 90.0
    facing: float = 270.0
    width: float = 1.23
    height: float = 1.22
    flatness: float | None = None
    ball: bool = False
    radius_known: bool = True
    control_sigma: float | None = None

    @classmethod
    def of(cls, target: Board | Ball, wall: Wall) -> "PlacedTarget":
        """Convert a target of a plan."""
        along, off, up = wall.wall_coordinates(target.centre)
        if isinstance(target, Ball):
            wide = 2 * target.radius
            return cls(target.name, along, off, up, 90.0, wall.facing_deg, wide, wide,
                       target.flatness, True, target.radius_known,
                       target.control_sigma)  # fmt: skip
        lean, facing = wall.board_orientation(target)
        return cls(target.name, along, off, up, lean, facing, target.width, target.height,
                   target.flatness, control_sigma=target.control_sigma)  # fmt: skip

    def on(self, wall: Wall) -> Board | Ball:
        """Convert to a target of a plan at this wall."""
        if self.ball:
            place = wall.local_point(self.along, self.off, self.up)
            return Ball(
                self.name, place, self.width / 2, self.radius_known, self.flatness,
                self.control_sigma,
            )  # fmt: skip
        return wall.board(
            self.name, self.along, self.up, self.lean, (self.width, self.height), off=self.off,
            facing_deg=self.facing, flatness=self.flatness, control_sigma=self.control_sigma,
        )  # fmt: skip


def default_plan(facing_deg: float = 270.0) -> TitledPlan:
    """Initial plan, with the boards and lines that the thesis recommends."""
    site = Site((0.0, 0.0, 0.0), facing_deg)
    return TitledPlan(DEFAULT_PLAN_TITLE, thesis_plan(site), site.wall)


def thesis_plan_at_wall(titled: TitledPlan) -> Plan:
    """Plan with the boards and lines of the thesis at this wall, with this system."""
    plan, wall = titled.plan, titled.wall
    site = Site(wall.middle, wall.facing_deg, system=plan.system, flatness=plan.flatness)
    return replace(thesis_plan(site), interval=plan.interval)


def with_lines(titled: TitledPlan, lines: Sequence[Line]) -> TitledPlan:
    """Plan with other lines."""
    return replace(titled, plan=titled.plan.with_lines(lines))


def with_line(titled: TitledPlan, k: int, line: Line) -> TitledPlan:
    """Plan with the k-th line replaced."""
    lines = titled.plan.lines
    return with_lines(titled, (*lines[:k], line, *lines[k + 1 :]))


def with_line_inserted(titled: TitledPlan, k: int, line: Line) -> TitledPlan:
    """Plan with a line inserted as the k-th."""
    lines = titled.plan.lines
    return with_lines(titled, (*lines[:k], line, *lines[k:]))


def without_line(titled: TitledPlan, k: int) -> TitledPlan:
    """Plan without the k-th line."""
    lines = titled.plan.lines
    return with_lines(titled, (*lines[:k], *lines[k + 1 :]))


def with_line_moved(titled: TitledPlan, k: int, position: int) -> TitledPlan:
    """Plan with the k-th line moved to another position in the order."""
    lines = list(titled.plan.lines)
    lines.insert(position, lines.pop(k))
    return with_lines(titled, lines)


def is_site_to_starboard(wall: Wall, heading_deg: float, otherwise: bool) -> bool:
    """Whether the site is to starboard of a vessel on the water side of the wall.

    The result is ``otherwise`` if the heading is perpendicular to the wall.
    """
    across = float(np.sin(np.radians(heading_deg - wall.facing_deg)))
    return otherwise if abs(across) < 0.01 else across > 0


def with_heading(line: Line, wall: Wall, heading_deg: float) -> Line:
    """Line with another heading, kept on the water side of the wall."""
    heading = heading_deg % 360
    return replace(
        line, heading_deg=heading, starboard=is_site_to_starboard(wall, heading, line.starboard)
    )


def snap_heading(heading_deg: float) -> float:
    """Heading rounded to a multiple of `HEADING_SNAP_DEG`."""
    return float(HEADING_SNAP_DEG * round(heading_deg / HEADING_SNAP_DEG) % 360)


def round_to_step(metres: float, step: float) -> float:
    """Length rounded to a step of about ``step`` metres, a round number in the unit shown."""
    step = units.shown_step(step, "m")
    return round(round(metres / step) * step, 9)


def with_distance(line: Line, distance: float) -> Line:
    """Line at another distance from the wall, within the limits, rounded to about a decimetre."""
    return replace(
        line,
        distance=float(
            np.clip(round_to_step(distance, 0.1), MIN_LINE_DISTANCE_M, MAX_LINE_DISTANCE_M)
        ),
    )


def placed_targets(titled: TitledPlan) -> list[PlacedTarget]:
    """All targets of a plan in coordinates of the wall."""
    return [PlacedTarget.of(target, titled.wall) for target in titled.plan.targets]


def with_target(titled: TitledPlan, k: int, target: PlacedTarget) -> TitledPlan:
    """Plan with the k-th target replaced, or with one added at the end."""
    targets = list(titled.plan.targets)
    targets[k : k + 1] = [target.on(titled.wall)]
    return replace(titled, plan=titled.plan.with_targets(targets))


def without_target(titled: TitledPlan, k: int) -> TitledPlan:
    """Plan without the k-th target."""
    targets = titled.plan.targets
    return replace(titled, plan=titled.plan.with_targets((*targets[:k], *targets[k + 1 :])))


def free_target_name(titled: TitledPlan, letter: str) -> str:
    """First unused name of a letter and a number, such as T1."""
    names = {target.name for target in titled.plan.targets}
    return next(name for k in range(1, len(names) + 2) if (name := f"{letter}{k}") not in names)


def with_system(titled: TitledPlan, system: System) -> TitledPlan:
    """Plan with another survey system."""
    return replace(titled, plan=replace(titled.plan, system=system))


def with_sensors(
    titled: TitledPlan, specification: ScannerSpecification | None, accuracy: PosAccuracy | None
) -> TitledPlan:
    """Plan with the standard deviations of sensors of the library; None keeps the current ones."""
    system = titled.plan.system
    if specification is not None:
        scanner = replace(
            system.scanner,
            range_sigma=specification.range_sigma,
            angle_sigma=radians(specification.angle_sigma_deg),
            divergence=specification.divergence_mrad / 1000.0,
        )
        system = replace(system, scanner=scanner)
    if accuracy is not None:
        north, east, up = accuracy.position_sigma
        roll, pitch, heading = map(radians, accuracy.attitude_sigma_deg)
        pos = replace(
            system.pos, sigma_position=(north, east, up), sigma_attitude=(roll, pitch, heading)
        )
        system = replace(system, pos=pos)
    return with_system(titled, system)


def with_wall_facing(titled: TitledPlan, facing_deg: float) -> TitledPlan:
    """Plan with the whole site (wall, targets, lines) turned so that the wall faces an azimuth."""
    rotation_deg = facing_deg - titled.wall.facing_deg
    wall = replace(titled.wall, facing_deg=facing_deg % 360)
    targets = [
        replace(target, facing=(target.facing + rotation_deg) % 360).on(wall)
        for target in placed_targets(titled)
    ]
    lines = [
        replace(line, heading_deg=(line.heading_deg + rotation_deg) % 360)
        for line in titled.plan.lines
    ]
    plan = titled.plan.with_targets(targets).with_lines(lines)
    return replace(titled, plan=plan, wall=wall)
