"""Expected size and inclination of a target."""

from math import radians

from PySide6.QtWidgets import QHBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.appearance import theme, units
from lispac.language import gettext
from lispac.targets.expected_target import ExpectedTarget

DEFAULT_SIZE = (1.23, 1.22)
"""Metres: width and height of the usual board."""


class ExpectedFields(QWidget):
    """Width, height and tilt in a row; nothing is expected while a side is 0."""

    def __init__(self) -> None:
        super().__init__()
        width, height = (units.local_amount(side, "m", ".2f") for side in DEFAULT_SIZE)
        self._width = widgets.number(
            "expected_width", suffix=" m", decimals=2, low=0, high=100, step=0.1,
            tip=gettext(
                "Expected width of the target, 0 if unknown. Usual board: {width}", width=width
            ),
        )  # fmt: skip
        self._height = widgets.number(
            "expected_height", suffix=" m", decimals=2, low=0, high=100, step=0.1,
            tip=gettext(
                "Expected height of the target along its slope, 0 if unknown. Usual board: "
                "{height}",
                height=height,
            ),
        )  # fmt: skip
        self._tilt = widgets.number(
            "expected_tilt", suffix="°", decimals=0, low=0, high=90, step=5,
            tip=gettext("Expected tilt of the target from horizontal: 0 is horizontal, 90 is "
                        "vertical"),
        )  # fmt: skip
        self._tilt.setValue(90)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(theme.SPACING // 2)
        for field in (self._width, self._height, self._tilt):
            field.setMinimumWidth(60)
            row.addWidget(field, 1)
        for field in (self._width, self._height):
            field.setSpecialValueText(gettext("any"))

    @property
    def value(self) -> ExpectedTarget | None:
        """The expected target; None where a side is not given."""
        width, height = self._width.value(), self._height.value()
        if not (width and height):
            return None
        return ExpectedTarget(width, height, radians(self._tilt.value()))
