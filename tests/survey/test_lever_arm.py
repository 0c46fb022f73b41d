"""Tests of the warnings about unlikely lever arms."""

import pytest

from lispac.messages import Level
from lispac.survey.lever_arm_warnings import lever_arm_warnings
from lispac.warning_causes import Cause

ZERO_CODE, BELOW_CODE, LONG_CODE = (
    f"mounting.lever_arm_{what}" for what in ("zero", "below", "long")
)


@pytest.mark.parametrize(
    ("lever_arm", "expected"),
    [
        ((0.0, 0.0, 0.0), [(ZERO_CODE, {})]),
        ((0.0, 0.0, 0.1), []),
        ((1.2, 0.3, -1.0), []),
        ((1.2, 0.3, -1.01), [(BELOW_CODE, {"below": 1.01})]),
        ((0.0, 18.0, 24.0), []),
        ((0.0, 18.1, 24.0), [(LONG_CODE, {"length": pytest.approx(30.06, abs=0.01)})]),
        (
            (1200.0, 300.0, -2100.0),
            [
                (BELOW_CODE, {"below": 2100.0}),
                (LONG_CODE, {"length": pytest.approx(2437.2, abs=0.1)}),
            ],
        ),
    ],
)
def test_sign_and_length_of_a_lever_arm_are_checked(lever_arm, expected) -> None:
    found = lever_arm_warnings(lever_arm)
    assert [(each.code, each.params) for each in found] == expected
    assert {(each.level, each.subject) for each in found} <= {
        (Level.NOTE, Cause.of_field("lever_arm"))
    }
