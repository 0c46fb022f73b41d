"""Lever arm and boresight in sentences, in the user's language and units."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lispac.gui import units
from lispac.gui.language import say
from lispac.gui.units import Base
from lispac.survey.conventions.words import Figures, boresight_words, lever_arm_words


def lever_arm_said(lever_arm: Sequence[float] | NDArray[np.float64]) -> str:
    """Position of the optical centre; metres, body frame (forward, left, up)."""
    return units.signs(say(lever_arm_words(lever_arm, _figures("m"))), "m")


def boresight_said(boresight: NDArray[np.float64]) -> str:
    """Orientation of the scanner; radians, roll, pitch, yaw."""
    return units.signs(say(boresight_words(boresight, _figures("°"))), "°")


def _figures(base: Base) -> Figures | None:
    """Writes numbers in the unit shown; None where the sentence can write them itself."""
    if not units.differs(base):
        return None

    def written(*values: float) -> list[str]:
        texts = [units.figure(abs(value), base, ".4f") for value in values]
        return [text if float(text) else "" for text in texts]

    return written
