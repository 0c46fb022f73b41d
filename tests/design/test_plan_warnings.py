"""Tests of the warnings about a plan: distance to the wall, overlapping boards."""

from dataclasses import replace

import pytest

from lispac.design.plan import Line, Plan
from lispac.design.plan_choices import thesis_plan
from lispac.design.site import Site, Wall
from lispac.errors import RankDeficient
from lispac.io.config.plan_file import TitledPlan
from lispac.workflow.planning.plan_checks import (
    ONE_ORIENTATION_ERROR,
    observability_messages,
    plan_warnings,
    simulate_surveys,
)

WALL = Wall((0.0, 0.0, 0.0), 270.0)


@pytest.fixture
def plan() -> Plan:
    return thesis_plan(Site(WALL.middle, 270.0))


def test_the_default_plan_has_no_warnings(plan: Plan) -> None:
    assert plan_warnings(TitledPlan("Quay", plan, WALL)) == ()


@pytest.mark.parametrize(
    ("line", "code", "distance"),
    [
        # At 2 m, the closest distance; at 45 deg the line continues beyond the last target.
        (Line(0.0, 2.0, True), "plan.line_near_wall", pytest.approx(2.0)),
        (Line(45.0, 5.0, True), "plan.line_through_wall", None),
    ],
)
def test_lines_near_or_through_the_wall_are_reported(
    plan: Plan, line: Line, code: str, distance: float | None
) -> None:
    (found,) = plan_warnings(TitledPlan("Quay", replace(plan, lines=(line,)), WALL))
    assert (found.code, found.params["line"]) == (code, 1)
    assert found.params["distance"] > 0
    if distance is not None:
        assert found.params["distance"] == distance


def test_overlapping_boards_are_reported(plan: Plan) -> None:
    one = plan.targets[0]
    duplicates = replace(plan, targets=(one, replace(one, name="duplicate"), *plan.targets[1:]))
    found = plan_warnings(TitledPlan("Quay", duplicates, WALL))
    assert found[0].code == "plan.targets_overlap"
    assert dict(found[0].params) == {"first": one.name, "second": "duplicate"}


def test_parallel_boards_are_not_simulated(plan: Plan) -> None:
    one = plan.targets[0]
    parallel = replace(plan, targets=(one, replace(one, name="duplicate")))
    assert observability_messages(parallel) == (ONE_ORIENTATION_ERROR,)
    with pytest.raises(RankDeficient) as caught:
        simulate_surveys(parallel, 3, seed=1)
    assert caught.value.message == ONE_ORIENTATION_ERROR
