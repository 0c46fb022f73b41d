"""What is offered for a line of which points lie outside the trajectory, and when nothing is."""

from pathlib import Path

import numpy as np
import pytest

from lispac.messages import Message
from lispac.project import Reading
from lispac.survey.time_base import DAY
from lispac.workflow.offers import offered, outside

ROUND_MIDNIGHT = np.r_[np.linspace(DAY - 40, DAY - 1, 40), np.linspace(0, 39, 40)]
"""Seconds of the day as a file has them that was begun before midnight."""


def track(first: float, last: float) -> np.ndarray:
    return np.linspace(first, last, 500)


def test_nothing_is_offered_for_a_line_without_points() -> None:
    assert offered(Reading(), np.zeros(0), track(0, 100)) == ""


def test_times_that_restart_are_offered_to_be_counted_on_once() -> None:
    counted = track(DAY - 50, DAY + 50)
    said = offered(Reading(), ROUND_MIDNIGHT, counted)
    assert said == (
        "its times restart within it: import it again with --line-option restart=midnight"
    )
    reading = Reading(options=(("restart", "midnight"),))
    assert offered(reading, reading.moved(ROUND_MIDNIGHT), counted) == ""


def test_a_line_counted_on_beside_a_sorted_trajectory_is_offered_as_it_was_written() -> None:
    reading = Reading(options=(("restart", "midnight"),))
    said = offered(reading, reading.moved(ROUND_MIDNIGHT), track(0, DAY))
    assert said.startswith("not counted on, 100.0 % of its points lie inside: ")
    assert said.endswith("--line-option restart=none")


def test_beside_a_typed_shift_no_other_is_offered() -> None:
    """A base that fits is offered where nothing is typed, and the shift that was typed is kept."""
    times, known = 400_000.0 + np.linspace(-15, 15, 300), track(400_000, 400_100)
    assert "--time-shift 18" in offered(Reading(), times, known)
    assert offered(Reading(time_shift=3.0), times, known) == ""


@pytest.mark.parametrize(
    ("shift", "code"), [(5_000.0, "import.shift_not_needed"), (-90_000.0, "import.shift_wrong")]
)
def test_a_shift_that_leads_outside_is_named_with_what_helps(shift: float, code: str) -> None:
    written = np.linspace(400_010, 400_020, 50) + (0 if shift > 0 else 4_000)
    times, known = written + shift, track(400_000, 400_100)
    refusal = outside(Reading(time_shift=shift), times, known, Path("L1.las"))
    assert isinstance(refusal, Message)
    assert refusal.code == code
    assert refusal.params == {
        "file": "L1.las", "shift": shift, "first": times.min(), "last": times.max(),
        "start": 400_000.0, "end": 400_100.0,
    }  # fmt: skip
