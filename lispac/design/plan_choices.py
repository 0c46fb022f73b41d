"""All plans that a site allows, encoded as numbers for a search."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import combinations, product
from math import comb

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.solve.determinability import have_one_orientation
from lispac.design.objective import PRIOR_ANGLE_SIGMA, PlanObjective
from lispac.design.plan import SIX_HEADINGS_DEG, Line, Plan, line_pattern
from lispac.design.site import Site, are_boards_separate
from lispac.simulation.closed_form_survey import Ball, Board

Array = NDArray[np.float64]

INVALID_PLAN_VALUE = 2 * PRIOR_ANGLE_SIGMA
"""Objective value of an invalid plan, radians; larger than that of any valid plan.

A plan is invalid if its boards overlap, if a line is too close to the wall, or if all targets have
the same orientation, which the adjustment does not accept.
"""

VALUE_DIGITS = 9
"""Significant digits of an objective value.

Rounding makes the values of mirrored plans equal, whatever the processor.
"""


def have_targets_one_orientation(plan: Plan) -> bool:
    """Whether all targets are planes of one orientation, which the adjustment does not accept."""
    normals = [t.facing if isinstance(t, Board) else np.zeros(3) for t in plan.targets]
    balls = np.array([isinstance(t, Ball) for t in plan.targets])
    return have_one_orientation(np.stack(normals), balls)


@dataclass(frozen=True)
class PlanChoice:
    """A plan as indices into the allowed boards and the allowed lines of the site."""

    boards: tuple[int, ...]
    lines: tuple[int, ...]


@dataclass(frozen=True, eq=False)
class DesignSpace:
    """All plans that a site allows."""

    site: Site
    objective: PlanObjective

    @cached_property
    def places(self) -> tuple[tuple[float, float, float, int], ...]:
        """Position along the wall, height, inclination and size index of each allowed board."""
        site = self.site
        sizes = range(len(site.sizes))
        return tuple(product(site.along, site.heights, site.inclinations_deg, sizes))

    def board(self, name: str, place: int) -> Board:
        """Create the board with index ``place`` in `places`."""
        along, up, lean, size = self.places[place]
        return self.site.wall.board(
            name, along, up, lean, self.site.sizes[size], control_sigma=self.site.control_sigma
        )

    @cached_property
    def lines(self) -> tuple[Line, ...]:
        """Lines that the site allows."""
        return self.site.allowed_lines

    @property
    def size(self) -> int:
        """Number of plans, including those with overlapping boards.

        Plans with the same lines in another order are different, because lines that follow each
        other closely in time share most of their POS error.
        """
        boards = comb(len(self.places), self.site.boards) if self.site.boards else 1
        return boards * int(len(self.lines) ** self.site.lines)

    def all(self) -> Iterator[PlanChoice]:
        """Iterate over all plans; a line may be repeated."""
        for boards in combinations(range(len(self.places)), self.site.boards):
            for lines in product(range(len(self.lines)), repeat=self.site.lines):
                yield PlanChoice(boards, lines)

    def plan(self, choice: PlanChoice) -> Plan:
        """Create the plan of a choice."""
        boards = [self.board(f"T{n + 1}", k) for n, k in enumerate(choice.boards)]
        return self.site.plan(boards, [self.lines[k] for k in choice.lines])

    def value(self, choice: PlanChoice) -> float:
        """Objective value of a choice, radians, rounded to `VALUE_DIGITS` digits."""
        plan = self.plan(choice)
        boards = [target for target in plan.targets if isinstance(target, Board)]
        if (
            not are_boards_separate(boards)
            or have_targets_one_orientation(plan)
            or not self.site.keeps_clear_of_wall(plan)
        ):
            return INVALID_PLAN_VALUE
        return float(f"{self.objective.of(plan):.{VALUE_DIGITS}g}")

    @cached_property
    def gene_sizes(self) -> tuple[int, ...]:
        """Number of values of each gene: four genes for each board and one for each line.

        Neighbouring values represent similar boards and lines, as differential evolution requires.
        """
        site = self.site
        board = (
            len(site.along), len(site.heights), len(site.inclinations_deg), len(site.sizes),
        )  # fmt: skip
        return board * site.boards + (len(self.lines),) * site.lines

    def choice(self, genes: Sequence[float] | Array) -> PlanChoice:
        """Decode genes, shape (n,), one for each of `gene_sizes`, into a choice."""
        whole = [min(int(g), w - 1) for g, w in zip(genes, self.gene_sizes, strict=True)]
        boards = whole[: 4 * self.site.boards]
        shape = self.gene_sizes[:4] if self.site.boards else (1, 1, 1, 1)
        places = [
            int(np.ravel_multi_index(tuple(boards[k : k + 4]), shape))
            for k in range(0, len(boards), 4)
        ]
        return PlanChoice(tuple(places), tuple(whole[4 * self.site.boards :]))

    def genes(self, choice: PlanChoice) -> list[float]:
        """Encode a choice as genes; the inverse of `choice`."""
        shape = self.gene_sizes[:4] if self.site.boards else (1, 1, 1, 1)
        boards = [float(g) for k in choice.boards for g in np.unravel_index(k, shape)]
        return [*boards, *(float(k) for k in choice.lines)]

    def nearest(self, plan: Plan) -> PlanChoice | None:
        """Choice that represents a plan, or None if the site does not allow the plan."""
        boards_of_plan = [t for t in plan.targets if t not in self.site.natural]
        if len(boards_of_plan) != self.site.boards or len(plan.lines) != self.site.lines:
            return None
        allowed = [self.board("", k) for k in range(len(self.places))]
        boards = [
            [k for k, other in enumerate(allowed) if _are_boards_equal(other, t)]
            for t in boards_of_plan
        ]
        lines = [[k for k, other in enumerate(self.lines) if other == line] for line in plan.lines]
        if not all(boards) or not all(lines):
            return None
        return PlanChoice(tuple(found[0] for found in boards), tuple(found[0] for found in lines))


def _are_boards_equal(one: Board, other: Board | Ball) -> bool:
    if isinstance(other, Ball):
        return False
    return bool(
        np.allclose(one.centre, other.centre, atol=1e-6)
        and np.allclose(one.facing, other.facing, atol=1e-6)
        and (one.width, one.height) == (other.width, other.height)
    )


def thesis_plan(site: Site) -> Plan:
    """Plan recommended by the thesis: two boards, upright and at 45 deg, and six lines.

    The boards are 1.6 m apart and 5 m above the middle of the site, and all lines pass at 15 m
    (thesis 4.4.1, figures 3.3 and 4.2). Natural planes of the site are not used.
    """
    boards = [
        site.wall.board(name, along, 5.0, lean, site.sizes[0], control_sigma=site.control_sigma)
        for name, along, lean in (("T1", -0.8, 90.0), ("T2", 0.8, 45.0))
    ]
    turned = [site.facing_deg - 270.0 + heading for heading in SIX_HEADINGS_DEG]
    lines = line_pattern(turned, 15.0, facing_deg=site.facing_deg)
    return site.plan(boards, lines).with_targets(boards)
