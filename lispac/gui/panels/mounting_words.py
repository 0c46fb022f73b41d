"""Lever arm and boresight in sentences, in the user's language and units."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lispac.gui import units
from lispac.survey.conventions.words import decimals, lever_arm_text, orientation_text


def lever_arm_said(lever_arm: Sequence[float] | NDArray[np.float64]) -> str:
    """Position of the optical centre; metres, body frame (forward, left, up)."""
    return str(lever_arm_text(lever_arm, lambda values: _amounts(values, "m")))


def boresight_said(boresight: NDArray[np.float64]) -> str:
    """Orientation of the scanner; radians, roll, pitch, yaw."""
    return str(orientation_text(boresight, lambda values: _amounts(np.degrees(values), "°")))


def _amounts(values: Sequence[float], base: units.Base) -> list[str]:
    """Sizes with their unit; empty for zero."""
    sizes = [float(abs(value)) for value in values]
    return [
        units.local_amount(size, base, f".{decimals(size)}f") if round(size, 4) else ""
        for size in sizes
    ]
