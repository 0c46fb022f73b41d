"""Tests of the number of points per frame as a function of the frame time."""

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


def simulate_motion(
    pace: FrameTimes, rate: float, overhead: float = 0.0, frames: int = 20
) -> float:
    """Move on a computer of this drawing rate; return the seconds of the last frame."""
    took = 0.0
    for _ in range(frames):
        points = int(SLICE_FRACTIONS[pace.slice] * BUDGET.moving)
        took = overhead + points / rate
        pace.record("moving", points, took, BUDGET.moving)
    return took


def test_a_fast_computer_draws_the_whole_budget() -> None:
    pace = FrameTimes(BUDGET)
    assert pace.rest_points == BUDGET.resting
    assert simulate_motion(pace, 1e9) < TARGET_FRAME_S["moving"]
    assert SLICE_FRACTIONS[pace.slice] == 1.0
    assert pace.rest_points == BUDGET.resting


def test_a_slow_computer_draws_as_many_points_as_the_time_allows() -> None:
    for rate in (3e5, 1e6, 2e6):
        pace = FrameTimes(BUDGET)
        took = simulate_motion(pace, rate, overhead=0.01)
        drawn = SLICE_FRACTIONS[pace.slice] * BUDGET.moving
        assert took <= TARGET_FRAME_S["moving"] + 0.01 or drawn <= MIN_POINTS["moving"]
        for _ in range(5):
            pace.record("resting", pace.rest_points, 2 * pace.rest_points / rate)
        assert 2 * pace.rest_points / rate <= 1.01 * TARGET_FRAME_S["resting"] or (
            pace.rest_points == MIN_POINTS["resting"]
        )
        assert MIN_POINTS["resting"] <= pace.rest_points <= BUDGET.resting
        # A still picture is drawn once and may take longer.
        expected = max(MIN_POINTS["resting"], min(BUDGET.resting, MAX_PICTURE_S * rate / 2))
        assert pace.picture_points == pytest.approx(expected, rel=1e-5)


def test_only_repeated_slow_frames_change_the_budget() -> None:
    pace = FrameTimes(BUDGET)
    simulate_motion(pace, 1e7)
    whole = pace.slice
    pace.record("moving", BUDGET.moving, 1.0, BUDGET.moving)
    assert pace.slice == whole
    simulate_motion(pace, 5e5)
    assert pace.slice < whole
    simulate_motion(pace, 1e7)
    assert pace.slice == whole


def test_a_reduced_budget_is_stable() -> None:
    pace = FrameTimes(BUDGET)
    simulate_motion(pace, 0.99 * 0.5 * BUDGET.moving / TARGET_FRAME_S["moving"])
    thin = pace.slice
    for _ in range(4):
        simulate_motion(pace, 1.02 * 0.5 * BUDGET.moving / TARGET_FRAME_S["moving"])
        assert pace.slice == thin


def test_small_budgets_are_not_reduced() -> None:
    pace = FrameTimes(Budget(resting=4000, moving=500))
    pace.record("moving", 500, 9.0, 500)
    pace.record("resting", 4000, 9.0)
    assert pace.rest_points == 4000
    assert SLICE_FRACTIONS[pace.slice] == 1.0
