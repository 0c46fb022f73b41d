"""Tests of the steps of tasks: number of points, rate and remaining time."""

import pytest

from lispac import progress
from lispac.language import duration_text, gettext_lazy, in_language
from lispac.progress import PointRate, count_text


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> list[float]:
    """Replace the clock by a list with its time in seconds."""
    now = [100.0]
    monkeypatch.setattr(progress.time, "monotonic", lambda: now[0])
    return now


@pytest.mark.parametrize(
    ("total", "done_before", "done", "seconds", "words"),
    [
        (4_000_000, 0, 1_000_000, 0.5, "Reading L1: 1.0 M of 4.0 M points"),
        (
            4_000_000, 0, 1_000_000, 2.0,
            "Reading L1: 1.0 M of 4.0 M points, 0.50 M points/s, 6 s left",
        ),
        # Points read before the start of the clock do not count for the rate.
        (
            4_000_000, 2_000_000, 3_000_000, 2.0,
            "Reading L1: 3.0 M of 4.0 M points, 0.50 M points/s, 2 s left",
        ),
        (4_000_000, 2_000_000, 2_000_000, 9.0, "Reading L1: 2.0 M of 4.0 M points"),
        (None, 0, 1_000_000, 2.0, "Reading L1: 1.0 M points, 0.50 M points/s"),
        (None, 0, 812, 0.1, "Reading L1: 812 points"),
    ],
)  # fmt: skip
def test_the_text_of_a_step_has_points_rate_and_time_left(
    clock: list[float], total: int | None, done_before: int, done: int, seconds: float, words: str
) -> None:
    rate = PointRate(gettext_lazy("Reading {line}", line="L1"), total, done_before)
    clock[0] += seconds
    assert str(rate.step(done)) == words


def test_a_step_is_translated_when_it_is_shown(clock: list[float]) -> None:
    rate = PointRate(gettext_lazy("Reading {line}", line="L1"), 4_000_000)
    clock[0] += 2.0
    step = rate.step(1_000_000)
    with in_language("fr"):
        assert (
            step.without_time_left()
            == "Lecture de L1\u00a0: 1,0 M points sur 4,0 M, 0,50 M points/s"
        )
        assert str(step).endswith(", encore 6 s")


@pytest.mark.parametrize(
    ("seconds", "words"),
    [
        (0.2, "1 s"),
        (59.4, "59 s"),
        (60.0, "1 min 00 s"),
        (130.0, "2 min 10 s"),
        (3600.0, "1 h 00 min"),
        (3900.0, "1 h 05 min"),
    ],
)
def test_texts_of_durations(seconds: float, words: str) -> None:
    assert duration_text(seconds) == words


def test_counts_of_a_million_and_more_are_in_millions() -> None:
    assert (count_text(999_999), count_text(4_900_000)) == ("999,999", "4.9 M")
