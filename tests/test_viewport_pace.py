"""How many points a frame holds, by how long frames take."""

import pytest

from lispac.gui.viewport.decimation import Budget
from lispac.gui.viewport.frame_times import (
    MAX_PICTURE_S,
    MIN_POINTS,
    SLICE_FRACTIONS,
    TARGET_FRAME_S,
    FrameTimes,
)

BUDGET = Budget()


def drive(pace: FrameTimes, rate: float, overhead: float = 0.0, frames: int = 20) -> float:
    """Move on a computer that draws so many points a second; the last frame's seconds."""
    took = 0.0
    for _ in range(frames):
        points = int(SLICE_FRACTIONS[pace.slice] * BUDGET.moving)
        took = overhead + points / rate
        pace.record("moving", points, took, BUDGET.moving)
    return took


def test_a_quick_computer_draws_the_whole_budget() -> None:
    pace = FrameTimes(BUDGET)
    assert pace.rest_points == BUDGET.resting
    assert drive(pace, 1e9) < TARGET_FRAME_S["moving"]
    assert SLICE_FRACTIONS[pace.slice] == 1.0
    assert pace.rest_points == BUDGET.resting


def test_a_slow_one_draws_as_many_as_there_is_time_for() -> None:
    for rate in (3e5, 1e6, 2e6):
        pace = FrameTimes(BUDGET)
        took = drive(pace, rate, overhead=0.01)
        drawn = SLICE_FRACTIONS[pace.slice] * BUDGET.moving
        assert took <= TARGET_FRAME_S["moving"] + 0.01 or drawn <= MIN_POINTS["moving"]
        for _ in range(5):
            pace.record("resting", pace.rest_points, 2 * pace.rest_points / rate)
        assert 2 * pace.rest_points / rate <= 1.01 * TARGET_FRAME_S["resting"] or (
            pace.rest_points == MIN_POINTS["resting"]
        )
        assert MIN_POINTS["resting"] <= pace.rest_points <= BUDGET.resting
        # A picture is drawn once: it takes its time
        wanted = max(MIN_POINTS["resting"], min(BUDGET.resting, MAX_PICTURE_S * rate / 2))
        assert pace.picture_points == pytest.approx(wanted, rel=1e-5)


def test_a_single_slow_frame_changes_nothing_and_lasting_ones_do() -> None:
    pace = FrameTimes(BUDGET)
    drive(pace, 1e7)
    whole = pace.slice
    pace.record("moving", BUDGET.moving, 1.0, BUDGET.moving)
    assert pace.slice == whole
    drive(pace, 5e5)
    assert pace.slice < whole
    drive(pace, 1e7)
    assert pace.slice == whole


def test_a_slice_does_not_come_and_go() -> None:
    pace = FrameTimes(BUDGET)
    drive(pace, 0.99 * 0.5 * BUDGET.moving / TARGET_FRAME_S["moving"])
    thin = pace.slice
    for _ in range(4):
        drive(pace, 1.02 * 0.5 * BUDGET.moving / TARGET_FRAME_S["moving"])
        assert pace.slice == thin


def test_small_budgets_are_left_alone() -> None:
    pace = FrameTimes(Budget(resting=4000, moving=500))
    pace.record("moving", 500, 9.0, 500)
    pace.record("resting", 4000, 9.0)
    assert pace.rest_points == 4000
    assert SLICE_FRACTIONS[pace.slice] == 1.0
