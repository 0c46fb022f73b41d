"""Constraints of a site: possible places of boards, allowed lines, available time."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations, pairwise

import numpy as np
from numpy.typing import NDArray

from lispac.design.plan import STRAIGHT_MARGIN, Line, Plan, System
from lispac.errors import InputError
from lispac.messages import error
from lispac.simulation.closed_form_survey import Ball, Board

Array = NDArray[np.float64]

MIN_SUPPORT_WIDTH_RATIO = 3.0
"""Smallest ratio of widths for which a plane is regarded as the support of a board.

A board on a quay face does not count as overlapping it.
"""


@dataclass(frozen=True)
class Wall:
    """A wall at the water, such as a quay, and its coordinate system.

    Attributes
    ----------
    middle : tuple of float, metres, local
        Origin of the wall coordinates, a point of its face.
    facing_deg : float, degrees
        Azimuth that the wall faces, towards the water.
    """

    middle: tuple[float, float, float]
    facing_deg: float

    @property
    def outward(self) -> Array:
        """Unit vector towards the water, north and west, shape (2,)."""
        azimuth = np.radians(self.facing_deg)
        return np.array([np.cos(azimuth), -np.sin(azimuth)])

    @property
    def rightward(self) -> Array:
        """Unit vector to the right when facing the wall, north and west, shape (2,)."""
        out = self.outward
        return np.array([-out[1], out[0]])

    def local_point(self, along: float, off: float, up: float) -> tuple[float, float, float]:
        """Position in the local frame of wall coordinates: along, off and up, metres.

        They are counted to the right when facing the wall, towards the water, and upwards.
        """
        north, west = np.array(self.middle[:2]) + along * self.rightward + off * self.outward
        return float(north), float(west), float(self.middle[2] + up)

    def wall_coordinates(self, place: Sequence[float]) -> tuple[float, float, float]:
        """Wall coordinates along, off and up of a position; the inverse of `local_point`."""
        offset = np.array(place[:2]) - self.middle[:2]
        return (
            float(offset @ self.rightward),
            float(offset @ self.outward),
            place[2] - self.middle[2],
        )

    def board(
        self, name: str, along: float, up: float, inclination_deg: float,
        size: tuple[float, float], *, off: float = 0.0, facing_deg: float | None = None,
        flatness: float | None = None, control_sigma: float | None = None,
    ) -> Board:  # fmt: skip
        """Create a board on the wall or in front of it.

        Parameters
        ----------
        along, up, off : float, metres
            Wall coordinates of the centre.
        inclination_deg : float, degrees from level
            90 is upright; a smaller value leans back, a larger one forward.
        size : pair of float, metres
            Width and height.
        facing_deg : float, degrees, optional
            Azimuth that the board faces; by default that of the wall.
        flatness, control_sigma : float, metres, optional
            See `Board`.
        """
        facing = self if facing_deg is None else replace(self, facing_deg=facing_deg)
        lean = np.radians(inclination_deg)
        level = np.sin(lean) * facing.outward
        normal = (float(level[0]), float(level[1]), float(np.cos(lean)))
        return Board(name, self.local_point(along, off, up), normal, *size, flatness, control_sigma)

    def board_orientation(self, board: Board) -> tuple[float, float]:
        """Inclination from level and azimuth of a board, degrees.

        The azimuth of a level board is that of the wall.
        """
        normal = board.facing
        lean = float(np.degrees(np.arccos(np.clip(normal[2], -1.0, 1.0))))
        if np.hypot(normal[0], normal[1]) < 1e-9:
            return lean, self.facing_deg
        return lean, float(np.degrees(np.arctan2(-normal[1], normal[0])) % 360)


@dataclass(frozen=True, eq=False)
class Site:
    """A wall at the water, its natural targets, and the constraints of a survey.

    Attributes
    ----------
    middle : tuple of float, metres, local
        Point of the wall's face to which the places of boards and the distances of lines refer.
        Height zero is that of the vessel's POS.
    facing_deg : float, degrees
        Azimuth that the wall faces, towards the water.
    along : tuple of float, metres
        Allowed positions of boards along the wall, to the right of the middle as seen facing it;
        negative to the left.
    heights : tuple of float, metres
        Allowed heights of the middles of boards above ``middle``.
    inclinations_deg : tuple of float, degrees
        Allowed inclinations of boards: 90 is upright, 0 is level with the face up.
    sizes : tuple of pairs of float, metres
        Available widths and heights of boards.
    natural : tuple of Board or Ball
        Targets that exist at the site, with their own flatness; they need no time.
    headings_deg, distances, speeds : tuples of float, degrees, metres, metres per second
        Allowed headings, distances and speeds of the lines; the distance is that from the middle
        when it is abeam.
    boards, lines : int
        Number of boards and of lines.
    closest : float, metres
        Smallest distance from the wall on the straight part of a line (`Plan.straight_extents`).
    time_on_site : float, minutes
        Available time.
    minutes_per_line, minutes_per_board : float
        Time for a line including the turn, and for installing and removing a board.
    system : System
    flatness : float, metres
        Flatness of targets without their own value (`Plan.flatness`).
    control_sigma : float or None, metres
        Standard deviation on each axis of the surveyed corners of the boards; None if they are not
        surveyed. Natural targets have their own.
    """

    middle: tuple[float, float, float]
    facing_deg: float
    along: tuple[float, ...] = (-8.0, -4.0, -1.0, 1.0, 4.0, 8.0)
    heights: tuple[float, ...] = (2.0, 5.0, 8.0)
    inclinations_deg: tuple[float, ...] = (90.0, 60.0, 45.0, 30.0)
    sizes: tuple[tuple[float, float], ...] = ((1.23, 1.22),)
    natural: tuple[Board | Ball, ...] = ()
    headings_deg: tuple[float, ...] = (0.0, 45.0, 90.0, 135.0, 180.0, 225.0, 270.0, 315.0)
    distances: tuple[float, ...] = (10.0, 15.0, 20.0, 30.0, 40.0)
    speeds: tuple[float, ...] = (1.0,)
    boards: int = 2
    lines: int = 6
    closest: float = 6.0
    time_on_site: float = 60.0
    minutes_per_line: float = 1.5
    minutes_per_board: float = 15.0
    system: System = field(default_factory=System)
    flatness: float = 0.0005
    control_sigma: float | None = None

    def __post_init__(self) -> None:
        if self.boards < 0 or self.lines < 2 or self.boards + len(self.natural) < 1:
            raise InputError(error("design.site_too_small"))
        if self.boards and not (
            self.along and self.heights and self.inclinations_deg and self.sizes
        ):
            raise InputError(error("design.no_board_places"))
        needed = self.lines * self.minutes_per_line + self.boards * self.minutes_per_board
        if needed > self.time_on_site:
            raise InputError(
                error(
                    "design.too_long",
                    lines=self.lines,
                    minutes_per_line=self.minutes_per_line,
                    boards=self.boards,
                    minutes_per_board=self.minutes_per_board,
                    needed=needed,
                    available=self.time_on_site,
                )
            )
        if not self.allowed_lines:
            raise InputError(error("design.lines_too_close", closest=self.closest))

    @property
    def wall(self) -> Wall:
        """The wall."""
        return Wall(self.middle, self.facing_deg)

    @property
    def allowed_lines(self) -> tuple[Line, ...]:
        """Lines that keep clear of the wall while they pass a target at the middle of the site."""
        allowed = []
        for heading in self.headings_deg:
            across, towards = (
                float(f(np.radians(heading - self.facing_deg))) for f in (np.sin, np.cos)
            )
            for distance in self.distances:
                if distance * abs(across) - STRAIGHT_MARGIN * abs(towards) < self.closest:
                    continue
                allowed += [Line(heading, distance, across > 0, speed) for speed in self.speeds]
        return tuple(allowed)

    def plan(self, boards: Sequence[Board], lines: Sequence[Line]) -> Plan:
        """Create a plan with these boards, the natural targets and these lines."""
        return Plan(
            (*boards, *self.natural),
            tuple(lines),
            self.middle,
            self.system,
            60.0 * self.minutes_per_line,
            self.flatness,
        )

    def keeps_clear_of_wall(self, plan: Plan) -> bool:
        """Whether the straight part of every line keeps clear of the wall."""
        return all(off >= self.closest - 1e-9 for off in clearance_from_wall(plan, self.wall))

    def minutes(self, plan: Plan) -> float:
        """Duration of a plan, minutes, including the installation and removal of boards."""
        boards = len(plan.targets) - sum(target in self.natural for target in plan.targets)
        return len(plan.lines) * self.minutes_per_line + boards * self.minutes_per_board


def clearance_from_wall(plan: Plan, wall: Wall) -> tuple[float, ...]:
    """Smallest distance of each line's straight part from the wall, metres; negative behind it."""
    if not plan.targets:
        return ()
    found = []
    for course, (start, stop) in zip(plan.courses, plan.straight_extents, strict=True):
        ends = np.array(course.abeam) + np.outer([start, stop], course.direction[:2])
        found.append(float(((ends - wall.middle[:2]) @ wall.outward).min()))
    return tuple(found)


def overlapping_targets(targets: Sequence[Board | Ball]) -> tuple[tuple[str, str], ...]:
    """Names of the pairs of overlapping boards; a board may lie on a much larger plane."""
    boards = [target for target in targets if isinstance(target, Board)]
    return tuple(
        (one.name, other.name)
        for one, other in combinations(boards, 2)
        if max(one.width, other.width) < MIN_SUPPORT_WIDTH_RATIO * min(one.width, other.width)
        and not are_boards_separate((one, other))
    )


def are_boards_separate(boards: Sequence[Board]) -> bool:
    """Whether no two boards overlap, in plan and in height, whatever their inclinations."""
    centres = np.array([board.centre for board in boards]).reshape(-1, 3)
    half = np.array([(board.width / 2, board.height / 2) for board in boards]).reshape(-1, 2)
    between = centres[:, None] - centres[None]
    beside = np.hypot(between[..., 0], between[..., 1]) < half[:, None, 0] + half[None, :, 0]
    above = np.abs(between[..., 2]) < half[:, None, 1] + half[None, :, 1]
    return not bool((beside & above & ~np.eye(len(boards), dtype=bool)).any())


def evenly_spaced(low: float, high: float, step: float) -> tuple[float, ...]:
    """Values from the lowest to the highest in equal steps; the highest is always included.

    Raises
    ------
    InputError
        The step is not positive, or the highest is below the lowest.
    """
    if not step > 0 or high < low:
        raise InputError(error("design.steps", low=low, high=high, step=step))
    count = int(np.floor((high - low) / step + 1e-9))
    values = [low + k * step for k in range(count + 1)]
    if high - values[-1] > 1e-9 * max(abs(high), 1.0):
        values.append(high)
    assert all(a < b for a, b in pairwise(values))
    return tuple(float(v) for v in values)
