"""All plans that a site allows, as numbers that a search can change."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations, product
from math import comb

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.observability import one_facing
from lispac.design.objective import BY_EYE, Objective
from lispac.design.plan import SIX, Line, Plan, pattern
from lispac.design.site import Site, apart
from lispac.simulation.closed_form import Ball, Board

Array = NDArray[np.float64]

NO_PLAN = 2 * BY_EYE
"""Number of a plan whose boards hang over each other, whose lines come too near the wall, or whose
targets all face one way, which the adjustment refuses: worse than any."""

DIGITS = 9
"""Of the number of a plan: plans that mirror each other are equal, whichever processor rounds."""


def faces_one_way(plan: Plan) -> bool:
    """Whether all targets are planes that face one way: the adjustment would refuse them."""
    normals = [t.facing if isinstance(t, Board) else np.zeros(3) for t in plan.targets]
    balls = np.array([isinstance(t, Ball) for t in plan.targets])
    return one_facing(np.stack(normals), balls)


@dataclass(frozen=True)
class Choice:
    """Indices of the boards and of the lines of a plan among those that are allowed."""

    boards: tuple[int, ...]
    lines: tuple[int, ...]


@dataclass(frozen=True, eq=False)
class DesignSpace:
    """All plans that a site allows."""

    site: Site
    objective: Objective

    @cached_property
    def places(self) -> tuple[tuple[float, float, float, int], ...]:
        """Along, height, inclination and size of each board that could hang."""
        site = self.site
        sizes = range(len(site.sizes))
        return tuple(product(site.along, site.heights, site.inclinations_deg, sizes))

    def board(self, name: str, place: int) -> Board:
        """One of the boards that could hang."""
        along, up, lean, size = self.places[place]
        return self.site.wall.board(name, along, up, lean, self.site.sizes[size])

    @cached_property
    def lines(self) -> tuple[Line, ...]:
        """Each line that could be sailed."""
        return self.site.lines_allowed

    @property
    def size(self) -> int:
        """Plans there are, those with boards over each other among them.

        The order of the lines counts: what is sailed soon after each other shares its POS error.
        """
        boards = comb(len(self.places), self.site.boards) if self.site.boards else 1
        return boards * int(len(self.lines) ** self.site.lines)

    def all(self) -> Iterator[Choice]:
        """Every plan; a line may be sailed more than once."""
        for boards in combinations(range(len(self.places)), self.site.boards):
            for lines in product(range(len(self.lines)), repeat=self.site.lines):
                yield Choice(boards, lines)

    def plan(self, choice: Choice) -> Plan:
        """The plan of a choice."""
        boards = [self.board(f"T{n + 1}", k) for n, k in enumerate(choice.boards)]
        return self.site.plan(boards, [self.lines[k] for k in choice.lines])

    def value(self, choice: Choice) -> float:
        """The objective's number of a choice, radians, to `DIGITS` digits."""
        plan = self.plan(choice)
        boards = [target for target in plan.targets if isinstance(target, Board)]
        if not apart(boards) or faces_one_way(plan) or not self.site.keeps_off(plan):
            return NO_PLAN
        return float(f"{self.objective.of(plan):.{DIGITS}g}")

    @cached_property
    def widths(self) -> tuple[int, ...]:
        """How many values each gene has: of a board its four, of a line its place in the list.

        Numbers near each other stand for like boards and lines, which an evolution needs.
        """
        site = self.site
        board = (
            len(site.along), len(site.heights), len(site.inclinations_deg), len(site.sizes),
        )  # fmt: skip
        return board * site.boards + (len(self.lines),) * site.lines

    def choice(self, genes: Sequence[float] | Array) -> Choice:
        """The choice that genes (n,) stand for, as many as `widths`."""
        whole = [min(int(g), w - 1) for g, w in zip(genes, self.widths, strict=True)]
        boards = whole[: 4 * self.site.boards]
        shape = self.widths[:4] if self.site.boards else (1, 1, 1, 1)
        places = [
            int(np.ravel_multi_index(tuple(boards[k : k + 4]), shape))
            for k in range(0, len(boards), 4)
        ]
        return Choice(tuple(places), tuple(whole[4 * self.site.boards :]))

    def genes(self, choice: Choice) -> list[float]:
        """The inverse of `choice`."""
        shape = self.widths[:4] if self.site.boards else (1, 1, 1, 1)
        boards = [float(g) for k in choice.boards for g in np.unravel_index(k, shape)]
        return [*boards, *(float(k) for k in choice.lines)]

    def nearest(self, plan: Plan) -> Choice | None:
        """The choice that is a plan, or None where the site does not allow it."""
        hung = [t for t in plan.targets if t not in self.site.natural]
        if len(hung) != self.site.boards or len(plan.lines) != self.site.lines:
            return None
        allowed = [self.board("", k) for k in range(len(self.places))]
        boards = [[k for k, other in enumerate(allowed) if _alike(other, t)] for t in hung]
        lines = [[k for k, other in enumerate(self.lines) if other == line] for line in plan.lines]
        if not all(boards) or not all(lines):
            return None
        return Choice(tuple(found[0] for found in boards), tuple(found[0] for found in lines))


def _alike(one: Board, other: Board | Ball) -> bool:
    if isinstance(other, Ball):
        return False
    return bool(
        np.allclose(one.centre, other.centre, atol=1e-6)
        and np.allclose(one.facing, other.facing, atol=1e-6)
        and (one.width, one.height) == (other.width, other.height)
    )


def thesis_plan(site: Site) -> Plan:
    """What the thesis recommends, on a site: two boards, upright and at 45 deg, and six lines.

    The boards hang 1.6 m apart at 5 m above the vessel, and all lines pass them at 15 m
    (thesis 4.4.1, figures 3.3 and 4.2); what is there anyway takes no part.
    """
    boards = [
        site.wall.board("T1", -0.8, 5.0, 90.0, site.sizes[0]),
        site.wall.board("T2", 0.8, 5.0, 45.0, site.sizes[0]),
    ]
    turned = [site.facing_deg - 270.0 + heading for heading in SIX]
    lines = pattern(turned, 15.0, facing_deg=site.facing_deg)
    return site.plan(boards, lines).with_targets(boards)
