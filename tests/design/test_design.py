"""Tests of the search for the best plan, against an exhaustive search of a small site."""

from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace

import numpy as np
import pytest

from lispac.design.objective import CRITERION_TEXTS, Criterion, PlanObjective
from lispac.design.plan import Line
from lispac.design.plan_choices import thesis_plan
from lispac.design.plan_search import MAX_EXHAUSTIVE_PLANS, information_gains, search
from lispac.design.prediction import predict
from lispac.design.site import Site, are_boards_separate, evenly_spaced
from lispac.errors import Cancelled, InputError, RankDeficient
from lispac.progress import Step
from lispac.simulation.closed_form_survey import Board
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG, others_long

SMALL = Site(
    (0.0, -15.0, 0.0),
    270.0,
    along=(-4.0, 1.0),
    heights=(2.0, 8.0),
    inclinations_deg=(90.0, 45.0),
    headings_deg=(0.0, 45.0, 135.0),
    distances=(15.0,),
    lines=3,
    boards=2,
    closest=3.0,
)
LARGE = Site((0.0, -15.0, 0.0), 270.0)


@pytest.fixture(scope="module")
def best():
    """The best plan of a small site, found by evaluating all plans."""
    return search(SMALL)


@LONG
def test_a_small_site_is_searched_exactly(best) -> None:
    assert best.exact
    assert best.evaluated == 28 * 3**3 <= MAX_EXHAUSTIVE_PLANS
    generator = np.random.default_rng(3)
    lines, objective = SMALL.allowed_lines, PlanObjective()
    for _ in range(60):
        boards = [
            SMALL.wall.board(
                f"T{k}", *(float(generator.choice(v)) for v in (SMALL.along, SMALL.heights)),
                float(generator.choice(SMALL.inclinations_deg)), SMALL.sizes[0],
            )
            for k in range(2)
        ]  # fmt: skip
        chosen = [lines[k] for k in generator.integers(0, len(lines), 3)]
        if are_boards_separate(boards) and boards[0].normal != boards[1].normal:
            assert objective.of(SMALL.plan(boards, chosen)) >= best.value * (1 - 1e-9)


@pytest.mark.parametrize("count", others_long([3, 5]))
def test_evolution_finds_what_an_exhaustive_search_finds(
    best, monkeypatch: pytest.MonkeyPatch, count: int
) -> None:
    """One seed in thirty ends with the second best plan, which no single exchange improves.

    Which one it is depends on the last digit of the numbers, and so on the processor.
    """
    monkeypatch.setattr("lispac.design.plan_search.MAX_EXHAUSTIVE_PLANS", 10)
    found = [search(SMALL, plans=400, seed=seed) for seed in range(count)]
    assert not any(design.exact for design in found)
    beyond = np.array([design.value for design in found]) / best.value - 1
    assert np.median(beyond) < 1e-9
    assert beyond.max() < 0.05


@LONG
def test_the_result_does_not_depend_on_the_mapper(best, monkeypatch: pytest.MonkeyPatch) -> None:
    with ThreadPoolExecutor(2) as pool:
        assert search(SMALL, mapper=pool.map).plan.lines == best.plan.lines
        monkeypatch.setattr("lispac.design.plan_search.MAX_EXHAUSTIVE_PLANS", 10)
        one, other = (search(SMALL, plans=200, mapper=m) for m in (map, pool.map))
    assert one.plan.targets == other.plan.targets
    assert one.plan.lines == other.plan.lines
    assert one.value == other.value


@LONG
@pytest.mark.parametrize("criterion", ["largest", pytest.param("A", marks=pytest.mark.long)])
def test_the_search_finds_better_plans_than_the_thesis(criterion: Criterion) -> None:
    """Two boards and six lines, as the thesis recommends, but at other places."""
    objective = PlanObjective(criterion)
    usual = objective.of(thesis_plan(LARGE))
    found = search(LARGE, objective, plans=400)
    print(f"{criterion}: {np.degrees(usual):.4f} -> {np.degrees(found.value):.4f} deg")
    assert found.value < usual / 1.5
    assert len(found.plan.lines) == 6
    assert len(found.plan.targets) == 2
    for course, (start, stop) in zip(found.plan.courses, found.plan.straight_extents, strict=True):
        west = course.abeam[1] + np.array([start, stop]) * course.direction[1]
        assert (west + 15.0 >= LARGE.closest - 1e-9).all()  # the face of the wall is at -15


@LONG
def test_the_search_never_returns_a_worse_plan_than_the_start() -> None:
    site = replace(LARGE, along=(-0.8, 0.8), heights=(5.0,), distances=(15.0, 20.0))
    start = thesis_plan(site)
    found = search(site, plans=150, start=start)
    assert found.value <= PlanObjective().of(start)


def test_information_gain_is_the_loss_without_the_part(best) -> None:
    found = {each.name: each.without for each in information_gains(best.plan, PlanObjective())}
    assert set(found) == {"T1", "T2", "L1", "L2", "L3"}
    without = best.plan.with_lines(best.plan.lines[1:])
    assert found["L1"] == pytest.approx(PlanObjective().of(without))
    assert all(value >= best.value for value in found.values())
    gains = information_gains(best.plan, PlanObjective())
    assert best.gains == gains
    sigma = {each.name: each.sigma for each in gains}
    assert sigma["L1"] == pytest.approx(predict(without).sigma)
    assert all(np.all(np.array(each) >= best.prediction.sigma) for each in sigma.values())


def test_less_time_is_never_better(best) -> None:
    minutes = [step.minutes for step in best.front]
    values = [step.value for step in best.front]
    assert minutes == sorted(minutes, reverse=True)
    assert values == sorted(values)
    assert best.front[0].plan is best.plan
    assert best.front[0].minutes == 3 * SMALL.minutes_per_line + 2 * SMALL.minutes_per_board


@LONG
def test_existing_planes_are_used() -> None:
    """Part of a tower 30 m behind the wall and 35 m up, and a roof: better than the thesis plan."""
    tower = Board("tower", (0.0, -45.0, 35.0), (0.0, 1.0, 0.0), 6.0, 6.0, 0.003)
    deck = Board("roof", (4.0, -25.0, -2.0), (0.0, 0.6, 0.8), 6.0, 6.0, 0.005)
    # At 15 m an oblique line would reach the shore before the tower is abeam
    headings = (0.0, 45.0, 135.0, 180.0)
    site = replace(LARGE, boards=0, lines=4, natural=(tower, deck), headings_deg=headings)
    with pytest.raises(RankDeficient, check=has_code("design.no_plan")):
        search(replace(site, distances=(15.0,), headings_deg=(45.0, 135.0)))
    site = replace(site, distances=(40.0,))
    found = search(site)
    assert found.exact
    assert {t.name for t in found.plan.targets} == {"tower", "roof"}
    assert found.value < PlanObjective().of(thesis_plan(LARGE))
    assert site.minutes(found.plan) == pytest.approx(4 * 1.5)


@pytest.mark.long
def test_a_search_for_a_criterion_minimises_it(best) -> None:
    for criterion in CRITERION_TEXTS:
        objective = PlanObjective(criterion)
        own = search(SMALL, objective)
        assert own.value <= objective.of(best.plan) * (1 + 1e-12)


def test_several_pos_factors_count_by_their_mean() -> None:
    plan = thesis_plan(LARGE)
    one, two, both = (PlanObjective(pos_factors=f).of(plan) for f in ((1.0,), (2.0,), (1.0, 2.0)))
    assert one < both < two
    assert both == pytest.approx((one + two) / 2)
    doubled = replace(plan, system=plan.system.with_pos_scaled(2.0))
    assert two == pytest.approx(float(predict(doubled).sigma.max()), rel=1e-3)


def test_targets_with_the_same_orientation_are_no_plan() -> None:
    site = replace(SMALL, inclinations_deg=(90.0,))
    with pytest.raises(RankDeficient, check=has_code("design.no_plan")):
        search(site)


def test_a_search_can_be_cancelled() -> None:
    def stop(fraction: float, step: Step | None = None) -> None:
        raise Cancelled

    with pytest.raises(Cancelled):
        search(SMALL, progress=stop)


def test_limits_that_allow_no_plan_are_refused() -> None:
    with pytest.raises(InputError, check=has_code("design.site_too_small")):
        replace(SMALL, lines=1)
    with pytest.raises(InputError, check=has_code("design.too_long", lines=50)):
        replace(SMALL, lines=50)
    with pytest.raises(
        InputError, check=has_code("design.too_long", boards=2, minutes_per_board=15.0, needed=34.5)
    ):
        replace(SMALL, time_on_site=20.0)
    with pytest.raises(InputError, check=has_code("design.lines_too_close", closest=40.0)):
        replace(SMALL, closest=40.0)
    with pytest.raises(InputError, check=has_code("design.no_board_places")):
        replace(SMALL, heights=())
    with pytest.raises(InputError, check=has_code("design.steps")):
        evenly_spaced(0.0, 1.0, 0.0)
    assert evenly_spaced(0.0, 1.0, 0.4) == pytest.approx((0.0, 0.4, 0.8, 1.0))


def test_straight_lines_keep_clear_of_the_wall() -> None:
    """Targets far apart along the wall make lines long, so that an oblique line nears the wall."""
    boards = [LARGE.wall.board(f"T{k}", a, 5.0, 90.0, (1.0, 1.0)) for k, a in enumerate((-8, 8))]
    oblique = LARGE.plan(boards, [Line(45.0, 15.0, True)])
    assert not LARGE.keeps_clear_of_wall(oblique)
    assert LARGE.keeps_clear_of_wall(LARGE.plan(boards, [Line(0.0, 15.0, True)]))
    assert LARGE.keeps_clear_of_wall(
        LARGE.plan([LARGE.wall.board("T", 0, 5, 90, (1.0, 1.0))], oblique.lines)
    )


def test_overlapping_boards_are_detected() -> None:
    def board(along: float, up: float) -> Board:
        return LARGE.wall.board("T", along, up, 90.0, (1.23, 1.22))

    assert not are_boards_separate([board(0.0, 5.0), board(0.9, 5.9)])
    assert are_boards_separate([board(0.0, 5.0), board(1.3, 5.9)])
    assert are_boards_separate([board(0.0, 5.0), board(0.9, 6.3)])
    assert are_boards_separate([board(0.0, 5.0)])


def test_an_indispensable_line_has_an_infinite_gain(best) -> None:
    two = best.plan.with_lines(best.plan.lines[:2])
    found = {each.name: each.without for each in information_gains(two, PlanObjective())}
    assert np.isinf(found["L1"])
    assert np.isinf(found["L2"])
    assert all(
        np.isinf(each.sigma).all()
        for each in information_gains(two, PlanObjective())
        if each.name in ("L1", "L2")
    )


def test_a_board_is_at_the_given_place() -> None:
    """The board is to the right as seen from the water, faces the water and leans back."""
    board = LARGE.wall.board("T1", 2.0, 6.0, 60.0, LARGE.sizes[0])
    # The wall faces west; for an observer looking east at it, south is to the right.
    assert board.centre == pytest.approx((-2.0, -15.0, 6.0))
    assert board.normal == pytest.approx((0.0, np.sin(np.radians(60)), 0.5))
    assert Line(0.0, 15.0, True).abeam((0.0, -15.0)) == pytest.approx((0.0, 0.0))
    assert all(Line.abeam(line, (0.0, -15.0))[1] > -15.0 for line in LARGE.allowed_lines)
