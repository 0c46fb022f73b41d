"""Warnings about an unlikely lever arm, such as a wrong sign or unit."""

from collections.abc import Sequence

import numpy as np

from lispac.messages import Message, note
from lispac.warning_causes import Cause

MAX_DEPTH_BELOW_POS_M = 1.0
"""Distance below the POS; a scanner farther below would be in the hull or in the water."""
MAX_USUAL_LENGTH_M = 30.0
"""Length of a lever arm that exceeds the size of most vessels."""


def lever_arm_warnings(lever_arm: Sequence[float]) -> tuple[Message, ...]:
    """Warnings about values to check in a lever arm.

    Parameters
    ----------
    lever_arm : three numbers, metres, body frame (forward, port, up)
    """
    field, up = Cause.of_field("lever_arm"), float(lever_arm[2])
    if not any(lever_arm):
        return (note("mounting.lever_arm_zero", subject=field),)
    found = []
    if up < -MAX_DEPTH_BELOW_POS_M:
        found.append(note("mounting.lever_arm_below", below=-up, subject=field))
    if (length := float(np.linalg.norm(lever_arm))) > MAX_USUAL_LENGTH_M:
        found.append(note("mounting.lever_arm_long", length=length, subject=field))
    return tuple(found)
