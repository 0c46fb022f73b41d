"""Tests of the time shifts suggested for lines with points outside the trajectory."""

from pathlib import Path

import numpy as np
import pytest

from lispac.messages import Message, note
from lispac.project import LineSource, Reading
from lispac.survey.line_source import DEFAULT_READING
from lispac.survey.time_base import DAY
from lispac.workflow.importing.time_shift_advice import outside_trajectory_message, shift_gain_note

TIMES_OVER_MIDNIGHT = np.r_[np.linspace(DAY - 40, DAY - 1, 40), np.linspace(0, 39, 40)]
"""Seconds of the day as a file has them that was begun before midnight."""


def track(first: float, last: float) -> np.ndarray:
    return np.linspace(first, last, 500)


def line(reading: Reading = DEFAULT_READING) -> LineSource:
    return LineSource("L1", Path("L1.las"), reading=reading)


def test_no_shift_is_suggested_for_a_line_without_points() -> None:
    assert shift_gain_note(line(), np.zeros(0), track(0, 100)) is None


def test_a_time_rollover_is_suggested_once() -> None:
    counted = track(DAY - 50, DAY + 50)
    assert shift_gain_note(line(), TIMES_OVER_MIDNIGHT, counted) == note(
        "import.restart_found", file="L1.las", place=note("rollover.midnight"),
        option="time_rollover=midnight",
    )  # fmt: skip
    reading = Reading(options=(("time_rollover", "midnight"),))
    assert (
        shift_gain_note(line(reading), reading.to_trajectory_time(TIMES_OVER_MIDNIGHT), counted)
        is None
    )


def test_original_times_are_suggested_beside_a_sorted_trajectory() -> None:
    reading = Reading(options=(("time_rollover", "midnight"),))
    assert shift_gain_note(
        line(reading), reading.to_trajectory_time(TIMES_OVER_MIDNIGHT), track(0, DAY)
    ) == note("import.restart_not_needed", file="L1.las", share=1.0, option="time_rollover=none")


def test_no_shift_is_suggested_beside_a_typed_one() -> None:
    """A matching time base is suggested only where no shift is typed; a typed shift is kept."""
    times, known = 400_000.0 + np.linspace(-15, 15, 300), track(400_000, 400_100)
    found = shift_gain_note(line(), times, known)
    assert found is not None
    assert (found.code, found.params["shift"]) == ("import.shift_possible", 18.0)
    assert shift_gain_note(line(Reading(time_shift=3.0)), times, known) is None


@pytest.mark.parametrize(
    ("shift", "code"), [(5_000.0, "import.shift_not_needed"), (-90_000.0, "import.shift_wrong")]
)
def test_a_shift_out_of_the_trajectory_has_a_suggested_action(shift: float, code: str) -> None:
    written = np.linspace(400_010, 400_020, 50) + (0 if shift > 0 else 4_000)
    times, known = written + shift, track(400_000, 400_100)
    refusal = outside_trajectory_message(Reading(time_shift=shift), times, known, Path("L1.las"))
    assert isinstance(refusal, Message)
    assert refusal.code == code
    assert refusal.params == {
        "file": "L1.las", "shift": shift, "first": times.min(), "last": times.max(),
        "start": 400_000.0, "end": 400_100.0,
    }  # fmt: skip
