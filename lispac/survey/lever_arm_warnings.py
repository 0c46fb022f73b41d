"""Warnings about an unlikely lever arm, such as a wrong sign or unit."""

from collections.abc import Sequence

import numpy as np

from lispac.messages import Message, note
from lispac.warning_causes import Cause

FAR_BELOW = 1.0
"""Distance in metres below the POS from which a scanner would be in the hull or in the water."""
LONG = 30.0
"""Length of a lever arm in metres that exceeds the size of most vessels."""


def lever_arm_warnings(lever_arm: Sequence[float]) -> tuple[Message, ...]:
    """Warnings about values to check in a lever arm.

    Parameters
    ----------
    lever_arm : three numbers, metres, body (forward, left, up)
    """
    field, up = Cause.of_field("lever_arm"), float(lever_arm[2])
    if not any(lever_arm):
        return (note("mounting.lever_arm_zero", subject=field),)
    found = []
    if up < -FAR_BELOW:
        found.append(note("mounting.lever_arm_below", below=-up, subject=field))
    if (length := float(np.linalg.norm(lever_arm))) > LONG:
        found.append(note("mounting.lever_arm_long", length=length, subject=field))
    return tuple(found)
