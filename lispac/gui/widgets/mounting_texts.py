"""Lever arm and boresight in sentences, in the user's language and units."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lispac.gui.appearance import units
from lispac.survey.conventions.mounting_texts import decimals_of, lever_arm_text, orientation_text


def lever_arm_sentence(lever_arm: Sequence[float] | NDArray[np.float64]) -> str:
    """Text on the optical centre; metres, body frame (forward, left, up)."""
    return str(lever_arm_text(lever_arm, lambda values: _amount_texts(values, "m")))


def boresight_sentence(boresight: NDArray[np.float64]) -> str:
    """Text on the orientation of the scanner; radians, roll, pitch, yaw."""
    return str(orientation_text(boresight, lambda values: _amount_texts(np.degrees(values), "°")))


def _amount_texts(values: Sequence[float], base: units.Base) -> list[str]:
    """Texts of absolute values with their unit; empty for zero."""
    sizes = [float(abs(value)) for value in values]
    return [
        units.local_amount(size, base, f".{decimals_of(size)}f") if round(size, 4) else ""
        for size in sizes
    ]
