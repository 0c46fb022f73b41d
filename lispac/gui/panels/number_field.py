"""A field for a number, shown and typed in the user's unit and language."""

from collections.abc import Mapping

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QFocusEvent, QKeyEvent, QValidator, QWheelEvent
from PySide6.QtWidgets import QDoubleSpinBox, QToolTip

from lispac.gui import units
from lispac.gui.language import say
from lispac.gui.units import Base

BASES: Mapping[str, Base] = {" m": "m", " mm": "mm", " °": "°"}
"""By the suffix of a field; others are shown in the unit they are in."""
ALIKE = 1e-9
"""What was calculated to and fro is the same."""
KEPT = 12
"""Decimals of the value: as many as a typed one may need in another unit."""
TOLD_MS = 300
"""After the field was left: Qt hides every tip when the focus moves and when a click ends."""


class NumberField(QDoubleSpinBox):
    """Has its value in the base, with all its digits; shows it with as many as are read.

    A value that is only shown, or confirmed as it is shown, stays what it is. A decimal comma and
    a decimal point are taken alike, whatever the language. A number beyond the range can be typed,
    and is marked with the range beside it; it is never cut to another. Enter does not take it, and
    where the field is left with it, what was there before comes back.

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
        self._before: float | None = None
        super().setDecimals(KEPT)
        line = self.lineEdit()
        line.textEdited.connect(self._typed)
        line.textChanged.connect(self._mark)

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
        """Whether a text may become a number, or is one beyond the range."""
        found = self._face.validate(self._own(text), place)
        if found[0] is QValidator.State.Invalid and (self._minus(text) or self._beyond(text)):
            return QValidator.State.Intermediate, text, place
        return found

    def valueFromText(self, text: str) -> float:
        """Value of a text in the unit shown; the value as it is where its text is the same."""
        typed = self._face.valueFromText(self._own(text))
        shown = self._face.valueFromText(self.textFromValue(self.value()))
        return self.value() if typed == shown else typed / self._factor

    def stepBy(self, steps: int) -> None:
        """From what is typed, or from what was there before where that is beyond the range."""
        self._end()
        super().stepBy(steps)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Give back what was there before, where what is typed is no number of the range."""
        self._end()
        super().focusOutEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter takes what is typed, unless it lies beyond the range."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            if self._beyond(self.text()):
                self._say_range("")
                event.accept()
                return
            self._end()
        elif event.key() == Qt.Key.Key_Escape and self._beyond(self.text()):
            self._end()
            event.accept()
            return
        super().keyPressEvent(event)

    def _typed(self, text: str) -> None:
        if self._before is None:
            self._before = self.value()
        if self._beyond(text):
            self._say_range("")

    def _end(self) -> None:
        """What is typed is done with."""
        before, self._before = self._before, None
        if before is None or self.hasAcceptableInput():
            return
        typed = self.cleanText()
        self.setValue(before)
        self._show_again()
        self._mark(self.text())  # Qt tells of typed texts only
        if typed and self._beyond(typed):
            QTimer.singleShot(TOLD_MS, self, lambda: self._say_range(typed))

    def _say_range(self, typed: str) -> None:
        if not self.isVisible():  # by now
            return
        low = self._face.textFromValue(self._face.minimum())
        high = f"{self._face.textFromValue(self._face.maximum())}{self.suffix()}"
        words = f"From {low} to {high}"
        if typed:
            words = f"{typed} is not between {low} and {high}: {self.text()} is kept"
        QToolTip.showText(self.mapToGlobal(self.rect().bottomLeft()), say(words), self)

    def _mark(self, text: str) -> None:
        wrong = self._beyond(text)
        if bool(self.property("wrong")) != wrong:
            self.setProperty("wrong", wrong)
            self.style().unpolish(self)
            self.style().polish(self)

    def _minus(self, text: str) -> bool:
        return self._bare(text) in ("-", "\N{MINUS SIGN}")

    def _beyond(self, text: str) -> bool:
        number, is_one = self.locale().toDouble(self._bare(text))
        face = self._face
        return is_one and not face.minimum() <= number <= face.maximum()

    def _bare(self, text: str) -> str:
        return self._own(text).removesuffix(self.suffix()).strip()

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
