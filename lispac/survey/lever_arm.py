"""What is hardly ever true of a lever arm: a wrong sign or unit that nothing else would show."""

from collections.abc import Sequence

import numpy as np

FAR_BELOW = 1.0
"""Metres under the POS centre: there is water, or the hull."""
LONG = 30.0
"""Metres; from scanner to INS most vessels are shorter as a whole."""


def lever_arm_doubts(lever_arm: Sequence[float]) -> tuple[str, ...]:
    """What to look at again in a lever arm, a sentence each.

    Parameters
    ----------
    lever_arm : three numbers, metres, body (forward, left, up)
    """
    up = float(lever_arm[2])
    if not any(lever_arm):
        return (
            "The lever arm is zero, as if the scanner's optical centre were at the POS centre: "
            "type the measured one.",
        )
    told = []
    if up < -FAR_BELOW:
        told.append(
            f"The lever arm puts the scanner {-up:.2f} m below the POS centre, and on a vessel it "
            "is mostly above it: look at the sign of Z, which is positive up here."
        )
    if (length := float(np.linalg.norm(lever_arm))) > LONG:
        told.append(
            f"The lever arm is {length:.1f} m long, and few vessels are: it is stated in metres "
            "here."
        )
    return tuple(told)
