"""A field for a number, shown and typed in the user's unit and language."""

from collections.abc import Mapping

from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QDoubleSpinBox

from lispac.gui import units
from lispac.gui.units import Base

BASES: Mapping[str, Base] = {" m": "m", " mm": "mm", " °": "°"}
"""By the suffix of a field; others are shown in the unit they are in."""
ALIKE = 1e-9
"""What was calculated to and fro is the same."""
KEPT = 12
"""Decimals of the value: as many as a typed one may need in another unit."""


class NumberField(QDoubleSpinBox):
    """Has its value in the base, with all its digits; shows it with as many as are read.

    A value that is only shown, or confirmed as it is shown, stays what it is. A decimal comma and a
    decimal point are taken alike, whatever the language.

    Parameters
    ----------
    base : Base or None
        Unit of the value; None where no other is ever shown.
    """

    def __init__(self, base: Base | None = None) -> None:
        super().__init__()
        self._base = base
        self._factor = 1.0 if base is None else units.unit(base).factor
        # What is seen of it: judges and writes in the unit shown.
        self._face = QDoubleSpinBox()
        super().setDecimals(KEPT)

    def setDecimals(self, decimals: int) -> None:
        """As many as the base is shown with."""
        self._face.setDecimals(
            decimals if self._base is None else units.decimals(decimals, self._base)
        )
        self._show_again()

    def decimals(self) -> int:
        """As many as are shown."""
        return self._face.decimals()

    def setRange(self, low: float, high: float) -> None:
        """In the base."""
        self._face.setRange(low * self._factor, high * self._factor)
        super().setRange(low, high)

    def setSuffix(self, suffix: str) -> None:
        """Of the unit shown."""
        self._face.setSuffix(suffix)
        super().setSuffix(suffix)

    def setSpecialValueText(self, text: str) -> None:
        """What stands for the lowest value."""
        self._face.setSpecialValueText(text)
        super().setSpecialValueText(text)

    def textFromValue(self, value: float) -> str:
        """Text of a value, in the unit shown."""
        shown = value * self._factor
        # Nothing has no sign, however little is left of it behind the last digit shown
        return self._face.textFromValue(shown if round(shown, self.decimals()) else 0.0)

    def validate(self, text: str, place: int) -> object:
        """Whether a text may become a number."""
        return self._face.validate(self._own(text), place)

    def valueFromText(self, text: str) -> float:
        """Value of a text in the unit shown; the value as it is where its text is the same."""
        typed = self._face.valueFromText(self._own(text))
        shown = self._face.valueFromText(self.textFromValue(self.value()))
        return self.value() if typed == shown else typed / self._factor

    def _own(self, text: str) -> str:
        point = self.locale().decimalPoint()
        return text.replace(",", point).replace(".", point)

    def _show_again(self) -> None:
        """The text, which Qt would keep."""
        super().setDecimals(KEPT)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Turn the value only with the focus: else the page under it moves."""
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()
