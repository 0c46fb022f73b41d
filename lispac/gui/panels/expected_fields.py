"""Size and inclination that a target is known to have."""

from math import radians

from PySide6.QtWidgets import QHBoxLayout, QWidget

from lispac.gui import theme, units
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.targets.expected import ExpectedTarget

USUAL = (1.23, 1.22)
"""Metres: width and height of the usual board."""


class ExpectedFields(QWidget):
    """Width, height and angle from level in a row; nothing is expected while a side is 0."""

    def __init__(self) -> None:
        super().__init__()
        usual = " × ".join(units.limit(side, "m") for side in USUAL)
        last = f"; the planes found are compared with it. {usual} m at 90° is the usual board"
        self._width = widgets.number(
            "expected_width", suffix=" m", decimals=2, low=0, high=100, step=0.1,
            tip=f"Width of the target, 0 where nothing is known{last}",
        )  # fmt: skip
        self._height = widgets.number(
            "expected_height", suffix=" m", decimals=2, low=0, high=100, step=0.1,
            tip=f"Height of the target up its slope, 0 where nothing is known{last}",
        )  # fmt: skip
        self._tilt = widgets.number(
            "expected_tilt", suffix="°", decimals=0, low=0, high=90, step=5,
            tip=f"Angle from level: 0 lies flat, 90 stands upright{last}",
        )  # fmt: skip
        self._tilt.setValue(90)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(theme.SPACE // 2)
        for field in (self._width, self._height, self._tilt):
            widgets.convert_tip(field, "m")
            field.setMinimumWidth(60)
            row.addWidget(field, 1)
        for field in (self._width, self._height):
            field.setSpecialValueText(say("any"))

    @property
    def value(self) -> ExpectedTarget | None:
        """What is expected, None where a side is not given."""
        width, height = self._width.value(), self._height.value()
        if not (width and height):
            return None
        return ExpectedTarget(width, height, radians(self._tilt.value()))
