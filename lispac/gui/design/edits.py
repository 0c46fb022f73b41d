"""What can be done to a plan by hand: every edit makes a new one; knows no window."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from math import radians

import numpy as np

from lispac.design.choices import thesis_plan
from lispac.design.plan import Line, Plan, System
from lispac.design.site import Site, Wall
from lispac.gui import units
from lispac.io.plan_file import TitledPlan
from lispac.io.sensor_file import PosState, ScannerFigures
from lispac.simulation.closed_form import Ball, Board

NEAREST, FARTHEST = 1.0, 200.0
"""Metres: distances a line can be dragged to."""
SNAP_DEG = 5.0
"""Headings are dragged in steps of this."""
MOST_LINES, MOST_TARGETS = 24, 12
"""More than a day on the water and a lorry can carry; every one of them costs time while dragging.
"""
TITLE = "Site"


@dataclass(frozen=True)
class PlacedTarget:
    """A target in the coordinates of an observer on the water.

    Attributes
    ----------
    along, off, up : float, metres
        To the right on the wall, towards the water, above the vessel's POS.
    lean, facing : float, degrees
        From level, and the azimuth a board faces; a ball has none.
    width, height : float, metres
        A ball's are its diameter.
    flatness : float or None, metres
        None is the plan's.
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

    @classmethod
    def of(cls, target: Board | Ball, wall: Wall) -> "PlacedTarget":
        """A target of a plan."""
        along, off, up = wall.seen(target.centre)
        if isinstance(target, Ball):
            wide = 2 * target.radius
            return cls(target.name, along, off, up, 90.0, wall.facing_deg, wide, wide,
                       target.flatness, True, target.radius_known)  # fmt: skip
        lean, facing = wall.facing_of(target)
        return cls(target.name, along, off, up, lean, facing, target.width, target.height,
                   target.flatness)  # fmt: skip

    def on(self, wall: Wall) -> Board | Ball:
        """The target of a plan."""
        if self.ball:
            place = wall.place(self.along, self.off, self.up)
            return Ball(self.name, place, self.width / 2, self.radius_known, self.flatness)
        return wall.board(
            self.name, self.along, self.up, self.lean, (self.width, self.height), off=self.off,
            facing_deg=self.facing, flatness=self.flatness,
        )  # fmt: skip


def usual(facing_deg: float = 270.0) -> TitledPlan:
    """What the thesis recommends: to begin with."""
    site = Site((0.0, 0.0, 0.0), facing_deg)
    return TitledPlan(TITLE, thesis_plan(site), site.wall)


def thesis_beside(titled: TitledPlan) -> Plan:
    """The thesis's boards and lines on this wall, with this system."""
    plan, wall = titled.plan, titled.wall
    site = Site(wall.middle, wall.facing_deg, system=plan.system, flatness=plan.flatness)
    return replace(thesis_plan(site), interval=plan.interval)


def with_lines(titled: TitledPlan, lines: Sequence[Line]) -> TitledPlan:
    """Other lines."""
    return replace(titled, plan=titled.plan.with_lines(lines))


def with_line(titled: TitledPlan, k: int, line: Line) -> TitledPlan:
    """Another line in one's place."""
    lines = titled.plan.lines
    return with_lines(titled, (*lines[:k], line, *lines[k + 1 :]))


def line_put_in(titled: TitledPlan, k: int, line: Line) -> TitledPlan:
    """One more line, sailed as the k-th."""
    lines = titled.plan.lines
    return with_lines(titled, (*lines[:k], line, *lines[k:]))


def line_removed(titled: TitledPlan, k: int) -> TitledPlan:
    """One line less."""
    lines = titled.plan.lines
    return with_lines(titled, (*lines[:k], *lines[k + 1 :]))


def line_sailed(titled: TitledPlan, k: int, turn: int) -> TitledPlan:
    """The k-th line sailed as another turn."""
    lines = list(titled.plan.lines)
    lines.insert(turn, lines.pop(k))
    return with_lines(titled, lines)


def water_side(wall: Wall, heading_deg: float, otherwise: bool) -> bool:
    """Whether the site lies to starboard of a vessel that stays on the wall's water side."""
    across = float(np.sin(np.radians(heading_deg - wall.facing_deg)))
    return otherwise if abs(across) < 0.01 else across > 0


def turned(line: Line, wall: Wall, heading_deg: float) -> Line:
    """The line with another heading, on the wall's water side."""
    heading = heading_deg % 360
    return replace(line, heading_deg=heading, starboard=water_side(wall, heading, line.starboard))


def snapped(heading_deg: float) -> float:
    """The nearest heading in whole steps for a helmsman."""
    return float(SNAP_DEG * round(heading_deg / SNAP_DEG) % 360)


def stepped(metres: float, step: float) -> float:
    """A length in whole steps, which are round in the unit shown and about so many metres."""
    step = units.step(step, "m")
    return round(round(metres / step) * step, 9)


def at_distance(line: Line, distance: float) -> Line:
    """The line nearer or farther, to a decimetre or what is like it."""
    return replace(line, distance=float(np.clip(stepped(distance, 0.1), NEAREST, FARTHEST)))


def hung(titled: TitledPlan) -> list[PlacedTarget]:
    """All targets in the coordinates of an observer on the water."""
    return [PlacedTarget.of(target, titled.wall) for target in titled.plan.targets]


def with_target(titled: TitledPlan, k: int, target: PlacedTarget) -> TitledPlan:
    """Another target in one's place; as the last, one more."""
    targets = list(titled.plan.targets)
    targets[k : k + 1] = [target.on(titled.wall)]
    return replace(titled, plan=titled.plan.with_targets(targets))


def target_removed(titled: TitledPlan, k: int) -> TitledPlan:
    """One target less."""
    targets = titled.plan.targets
    return replace(titled, plan=titled.plan.with_targets((*targets[:k], *targets[k + 1 :])))


def free_name(titled: TitledPlan, letter: str) -> str:
    """The first of T1, T2, … that no target has."""
    names = {target.name for target in titled.plan.targets}
    return next(name for k in range(1, len(names) + 2) if (name := f"{letter}{k}") not in names)


def with_system(titled: TitledPlan, system: System) -> TitledPlan:
    """Another system on the vessel."""
    return replace(titled, plan=replace(titled.plan, system=system))


def with_sensors(
    titled: TitledPlan, figures: ScannerFigures | None, state: PosState | None
) -> TitledPlan:
    """The sigmas of sensors of the library; None leaves what there is."""
    system = titled.plan.system
    if figures is not None:
        scanner = replace(
            system.scanner,
            range_sigma=figures.range_sigma,
            angle_sigma=radians(figures.angle_sigma_deg),
            divergence=figures.divergence_mrad / 1000.0,
        )
        system = replace(system, scanner=scanner)
    if state is not None:
        north, east, up = state.position_sigma
        roll, pitch, heading = map(radians, state.attitude_sigma_deg)
        pos = replace(
            system.pos, sigma_position=(north, east, up), sigma_attitude=(roll, pitch, heading)
        )
        system = replace(system, pos=pos)
    return with_system(titled, system)


def wall_faces(titled: TitledPlan, facing_deg: float) -> TitledPlan:
    """The whole site turned: wall, targets and lines."""
    by = facing_deg - titled.wall.facing_deg
    wall = replace(titled.wall, facing_deg=facing_deg % 360)
    targets = [replace(t, facing=(t.facing + by) % 360).on(wall) for t in hung(titled)]
    lines = [replace(each, heading_deg=(each.heading_deg + by) % 360) for each in titled.plan.lines]
    plan = titled.plan.with_targets(targets).with_lines(lines)
    return replace(titled, plan=plan, wall=wall)
