"""Tests of edge cases of plans: plans outside the site, no sightings, failed adjustments."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from lispac.design.monte_carlo import run_monte_carlo, simulate_plan
from lispac.design.objective import PlanObjective
from lispac.design.plan import Line, Plan
from lispac.design.plan_choices import DesignSpace, PlanChoice
from lispac.design.site import clearance_from_wall, evenly_spaced
from lispac.errors import LispacError, RankDeficient
from lispac.simulation.closed_form_survey import Ball, Board
from lispac.simulation.scene import Cylinder, Sphere, upright_rectangle
from lispac.simulation.simulated_survey import _surface_seeds
from tests.design.test_design import SMALL
from tests.studies.prediction_study import BOARDS, PLAN
from tests.support.error_codes import has_code

SPACE = DesignSpace(SMALL, PlanObjective())
CHOICE = PlanChoice((0, 5), (0, 1, 2))
CHOSEN_PLAN = SPACE.plan(CHOICE)
HIDDEN_BOARD = Board("away", (0.0, -15.0, 5.0), (0.0, -1.0, 0.0))


def test_the_choice_of_a_plan_is_recovered() -> None:
    assert SPACE.nearest(CHOSEN_PLAN) == CHOICE
    assert SPACE.choice(SPACE.genes(CHOICE)) == CHOICE


@pytest.mark.parametrize(
    "other",
    [
        replace(CHOSEN_PLAN, lines=CHOSEN_PLAN.lines[:2]),
        replace(CHOSEN_PLAN, targets=CHOSEN_PLAN.targets[:1]),
        replace(CHOSEN_PLAN, lines=(*CHOSEN_PLAN.lines[:2], Line(12.0))),
        replace(CHOSEN_PLAN, targets=(CHOSEN_PLAN.targets[0], BOARDS[0])),
        replace(
            CHOSEN_PLAN,
            targets=(CHOSEN_PLAN.targets[0], Ball("S1", CHOSEN_PLAN.targets[1].centre, 0.3, True)),
        ),
    ],
)
def test_a_plan_outside_the_site_has_no_choice(other: Plan) -> None:
    assert SPACE.nearest(other) is None


def test_lines_without_targets_have_no_clearance() -> None:
    assert clearance_from_wall(replace(CHOSEN_PLAN, targets=()), SMALL.wall) == ()
    assert len(clearance_from_wall(CHOSEN_PLAN, SMALL.wall)) == 3


@pytest.mark.parametrize(
    ("bounds", "values"),
    [
        ((0.0, 1.0, 0.5), (0.0, 0.5, 1.0)),
        ((2.0, 2.0, 1.0), (2.0,)),
        ((0.0, 0.3, 0.2), (0, 0.2, 0.3)),
    ],
)
def test_steps_end_at_the_given_bounds(bounds: tuple, values: tuple) -> None:
    assert evenly_spaced(*bounds) == pytest.approx(values)


def test_a_board_that_no_line_sees_has_no_sightings() -> None:
    """A board that faces away from all lines, beside visible boards."""
    both = simulate_plan(replace(PLAN, targets=(*BOARDS, HIDDEN_BOARD)), np.random.default_rng(1))
    assert set(both.targets) == {"T1", "T2"}
    assert len(both.sightings) == 2 * len(PLAN.lines)
    with pytest.raises(RankDeficient, check=has_code("design.no_sightings")):
        simulate_plan(replace(PLAN, targets=(HIDDEN_BOARD,)), np.random.default_rng(1))


def test_monte_carlo_without_adjusted_surveys_is_refused() -> None:
    def failing(trial, numbers):
        return (np.full((2, 3), np.nan) for _ in numbers)

    with pytest.raises(LispacError, check=has_code("design.none_adjusted")):
        run_monte_carlo(PLAN, 3, mapper=failing)


def test_failed_adjustments_are_counted() -> None:
    errors = iter([1.0, np.nan, -1.0])

    def made(trial, numbers):
        return (np.full((2, 3), next(errors)) for _ in numbers)

    found = run_monte_carlo(PLAN, 3, mapper=made)
    assert found.failed == 1
    np.testing.assert_array_equal(found.errors, [[1.0] * 3, [-1.0] * 3])
    assert {each.code: each.params for each in found.messages}["campaign.not_adjusted"] == {
        "count": 1
    }


def test_seeds_lie_on_boards_and_spheres() -> None:
    """At the middle of a board, on the side of a sphere towards the vessel, on no mast."""
    board = upright_rectangle("T1", (0.0, -12.0), 4.0, 5.0, 1.0, 270)
    ball = Sphere("S1", np.array([3.0, -10.0, 2.0]), 0.5)
    mast = Cylinder("mast", 6.0, -10.0, 0.0, 9.0, 0.3)
    scene = {each.name: each for each in (board, ball, mast)}
    motion = SimpleNamespace(position=np.array([[3.0, -2.0, 1.0], [3.0, 2.0, 3.0]]))
    found = _surface_seeds(SimpleNamespace(scene=scene), tuple(scene), motion)
    assert set(found) == {"T1", "S1"}
    np.testing.assert_allclose(found["T1"], [0.0, -12.0, 4.5])
    np.testing.assert_allclose(found["S1"], [3.0, -9.5, 2.0])
