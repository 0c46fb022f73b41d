"""Field for a number in the unit and language of the user."""

from collections.abc import Mapping

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QFocusEvent, QKeyEvent, QValidator, QWheelEvent
from PySide6.QtWidgets import QDoubleSpinBox, QToolTip

from lispac.gui.appearance import units
from lispac.gui.appearance.units import Base
from lispac.language import gettext

BASE_OF_SUFFIX: Mapping[str, Base] = {" m": "m", " mm": "mm", " °": "°"}
"""Base unit of a field by its suffix; other units are never converted."""
EQUAL_TOLERANCE = 1e-9
"""Difference, in the unit of the value, below which a value is considered unchanged."""
STORED_DECIMALS = 12
"""Decimals of the stored value, sufficient for a value typed in another unit."""
TIP_DELAY_MS = 300
"""Delay of the tip after the field loses the focus, since Qt then hides all tips."""


class NumberField(QDoubleSpinBox):
    """Number field that keeps all digits of its value in the base unit and shows some of them.

    A value that is shown or confirmed without a change keeps all its digits. A decimal comma and a
    decimal point are both accepted in every language. A number outside the range can be typed; it
    is marked, with the range in a tip, and never clipped. Enter does not accept it, and when the
    field loses the focus, the former value returns.

    Parameters
    ----------
    base : Base or None
        Unit of the value; None if it is never converted.
    """

    def __init__(self, base: Base | None = None) -> None:
        super().__init__()
        self._base = base
        self._factor = 1.0 if base is None else units.shown_unit(base).factor
        # A hidden field in the unit shown validates and formats texts.
        self._face = QDoubleSpinBox()
        self._before: float | None = None
        super().setDecimals(STORED_DECIMALS)
        line = self.lineEdit()
        line.textEdited.connect(self._on_typed)
        line.textChanged.connect(self._mark_invalid)

    def setDecimals(self, decimals: int) -> None:
        """Set the number of decimals in the base unit."""
        self._face.setDecimals(
            decimals if self._base is None else units.shown_decimals(decimals, self._base)
        )
        self._reformat_text()

    def decimals(self) -> int:
        """Number of decimals shown."""
        return self._face.decimals()

    def setRange(self, low: float, high: float) -> None:
        """Set the range, in the base unit."""
        self._face.setRange(low * self._factor, high * self._factor)
        super().setRange(low, high)

    def setSuffix(self, suffix: str) -> None:
        """Set the suffix, for the unit shown."""
        self._face.setSuffix(suffix)
        super().setSuffix(suffix)

    def setSpecialValueText(self, text: str) -> None:
        """Set the text that is shown for the lowest value."""
        self._face.setSpecialValueText(text)
        super().setSpecialValueText(text)

    def textFromValue(self, value: float) -> str:
        """Text of a value, in the unit shown."""
        shown = value * self._factor
        # A value that rounds to zero has no sign.
        return self._face.textFromValue(shown if round(shown, self.decimals()) else 0.0)

    def validate(self, text: str, place: int) -> object:
        """Whether a text is a number, inside or outside the range, or the start of one."""
        found = self._face.validate(self._with_local_decimal_sign(text), place)
        if found[0] is QValidator.State.Invalid and (
            self._is_minus_sign(text) or self._is_out_of_range(text)
        ):
            return QValidator.State.Intermediate, text, place
        return found

    def valueFromText(self, text: str) -> float:
        """Value of a text in the unit shown; the present value if the text is unchanged."""
        typed = self._face.valueFromText(self._with_local_decimal_sign(text))
        shown = self._face.valueFromText(self.textFromValue(self.value()))
        return self.value() if typed == shown else typed / self._factor

    def stepBy(self, steps: int) -> None:
        """Step from the typed value, or from the former one if the typed one is out of range."""
        self._finish_typing()
        super().stepBy(steps)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Restore the former value if the typed one is outside the range."""
        self._finish_typing()
        super().focusOutEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Accept the typed value with Enter, unless it is outside the range."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            if self._is_out_of_range(self.text()):
                self._show_range("")
                event.accept()
                return
            self._finish_typing()
        elif event.key() == Qt.Key.Key_Escape and self._is_out_of_range(self.text()):
            self._finish_typing()
            event.accept()
            return
        super().keyPressEvent(event)

    def _on_typed(self, text: str) -> None:
        if self._before is None:
            self._before = self.value()
        if self._is_out_of_range(text):
            self._show_range("")

    def _finish_typing(self) -> None:
        """Finish typing: keep a valid number, otherwise restore the former value."""
        before, self._before = self._before, None
        if before is None or self.hasAcceptableInput():
            return
        typed = self.cleanText()
        self.setValue(before)
        self._reformat_text()
        self._mark_invalid(self.text())  # Qt emits a signal for typed texts only
        if typed and self._is_out_of_range(typed):
            QTimer.singleShot(TIP_DELAY_MS, self, lambda: self._show_range(typed))

    def _show_range(self, typed: str) -> None:
        """Show the range in a tip, with a note if a typed number was not accepted."""
        if not self.isVisible():  # the tip is shown after a delay
            return
        low = self._face.textFromValue(self._face.minimum())
        high = f"{self._face.textFromValue(self._face.maximum())}{self.suffix()}"
        text = gettext("Range: {low} to {high}", low=low, high=high)
        if typed:
            text = gettext(
                "{typed} is outside the range {low} to {high}. {value} is kept.",
                typed=typed, low=low, high=high, value=self.text(),
            )  # fmt: skip
        QToolTip.showText(self.mapToGlobal(self.rect().bottomLeft()), text, self)

    def _mark_invalid(self, text: str) -> None:
        wrong = self._is_out_of_range(text)
        if bool(self.property("wrong")) != wrong:
            self.setProperty("wrong", wrong)
            self.style().unpolish(self)
            self.style().polish(self)

    def _is_minus_sign(self, text: str) -> bool:
        return self._without_unit(text) in ("-", "\N{MINUS SIGN}")

    def _is_out_of_range(self, text: str) -> bool:
        number, is_number = self.locale().toDouble(self._without_unit(text))
        face = self._face
        return is_number and not face.minimum() <= number <= face.maximum()

    def _without_unit(self, text: str) -> str:
        return self._with_local_decimal_sign(text).removesuffix(self.suffix()).strip()

    def _with_local_decimal_sign(self, text: str) -> str:
        point = self.locale().decimalPoint()
        return text.replace(",", point).replace(".", point)

    def _reformat_text(self) -> None:
        """Format the text again, which Qt does not do by itself."""
        super().setDecimals(STORED_DECIMALS)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Change the value with the wheel only if the field has the focus."""
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()
