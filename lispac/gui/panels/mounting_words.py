"""Lever arm and boresight in sentences, in the user's language and units."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lispac.gui import units
from lispac.gui.language import say
from lispac.gui.units import Base
from lispac.survey.conventions.words import Figures, boresight_words, lever_arm_words


def lever_arm_said(lever_arm: Sequence[float] | NDArray[np.float64]) -> str:
    """Where the optical centre is; metres, body (forward, left, up)."""
    return units.signs(say(lever_arm_words(lever_arm, _figures("m"))), "m")


def boresight_said(boresight: NDArray[np.float64]) -> str:
    """Where the scanner looks; radians, roll, pitch, yaw."""
    return units.signs(say(boresight_words(boresight, _figures("°"))), "°")


def _figures(base: Base) -> Figures | None:
    """None where the base is shown, which the sentence writes itself."""
    if not units.differs(base):
        return None

    def written(*values: float) -> list[str]:
        said = [units.figure(abs(value), base, ".4f") for value in values]
        return [each if float(each) else "" for each in said]

    return written
