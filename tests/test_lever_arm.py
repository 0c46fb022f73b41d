"""Lever arms that are hardly ever true, to the letter."""

import pytest

from lispac.survey.lever_arm import lever_arm_doubts

LONG = "The lever arm is {} m long, and few vessels are: it is stated in metres here."
BELOW = (
    "The lever arm puts the scanner {} m below the POS centre, and on a vessel it is mostly above "
    "it: look at the sign of Z, which is positive up here."
)


@pytest.mark.parametrize(
    ("lever_arm", "said"),
    [
        (
            (0.0, 0.0, 0.0),
            [
                "The lever arm is zero, as if the scanner's optical centre were at the POS "
                "centre: type the measured one."
            ],
        ),
        ((0.0, 0.0, 0.1), []),
        ((1.2, 0.3, -1.0), []),
        ((1.2, 0.3, -1.01), [BELOW.format("1.01")]),
        ((0.0, 18.0, 24.0), []),
        ((0.0, 18.1, 24.0), [LONG.format("30.1")]),
        ((1200.0, 300.0, -2100.0), [BELOW.format("2100.00"), LONG.format("2437.2")]),
    ],
)
def test_a_lever_arm_is_doubted_by_its_sign_and_its_length(lever_arm, said: list[str]) -> None:
    assert list(lever_arm_doubts(lever_arm)) == said
