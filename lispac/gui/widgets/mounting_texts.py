"""Lever arm, boresight and their convention as sentences, in the user's language and units."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lispac.gui.appearance import units
from lispac.language import N_, gettext
from lispac.survey.conventions.mounting_texts import (
    common_decimals,
    lever_arm_text,
    orientation_text,
)

_FRAMES_TEXT = N_(
    "The boresight rotates LiDAR coordinates into the body frame (forward, left, up):"
)
CONVENTION_NAME_TEXT = N_("Convention: LISPAC (as iXblue)")
_FORMULA_TEXT = N_("R = {z}(−yaw) · {y}(pitch) · {x}(roll)")
_ROTATION_SYMBOLS = {axis: f"R<sub>{axis}</sub>" for axis in "xyz"}
SIGNS_TEXT = N_(
    "Roll is positive port side up, pitch positive bow down, yaw positive clockwise seen from "
    "above."
)


def lever_arm_sentence(lever_arm: Sequence[float] | NDArray[np.float64]) -> str:
    """Text on the position of the optical centre, metres, body frame (forward, left, up)."""
    return str(lever_arm_text(lever_arm, lambda values: _amount_texts(values, "m")))


def boresight_sentence(boresight: NDArray[np.float64]) -> str:
    """Text on the orientation of the scanner: roll, pitch, yaw, radians."""
    return str(orientation_text(boresight, lambda values: _amount_texts(np.degrees(values), "°")))


def convention_html(*, is_named: bool = True) -> str:
    """Definition of the three angles, by default with the name of the convention."""
    formula = gettext(_FORMULA_TEXT, **_ROTATION_SYMBOLS)
    name = f"{gettext(CONVENTION_NAME_TEXT)}<br>" if is_named else ""
    return f"{name}{gettext(_FRAMES_TEXT)}<br><b>{formula}</b><br>{gettext(SIGNS_TEXT)}"


def _amount_texts(values: Sequence[float], base: units.Base) -> list[str]:
    """Texts of absolute values with their unit; empty for zero."""
    sizes = [float(abs(value)) for value in values]
    decimals = common_decimals(sizes)
    return [
        units.local_amount(size, base, f".{decimals}f") if round(size, 4) else "" for size in sizes
    ]
