"""Field for a number in the unit and language of the user."""

from collections.abc import Mapping

from PySide6.QtCore import QEvent, Qt, QTimer, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QShowEvent, QValidator, QWheelEvent
from PySide6.QtWidgets import QDoubleSpinBox, QToolTip

from lispac.gui.appearance import units
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.appearance.units import Base
from lispac.gui.widgets.number_input import (
    PanelEntry,
    PendingInput,
    handle_shortcut_override,
    is_start_of_number,
    parse_number,
    text_in_unit,
)
from lispac.language import gettext
from lispac.messages import Message, error

BASE_OF_SUFFIX: Mapping[str, Base] = {" m": "m", " mm": "mm", " °": "°"}
"""Base unit of a field by its suffix; other units are never converted."""
EQUAL_TOLERANCE = 1e-9
"""Difference, in the unit of the value, below which a value is considered unchanged."""
STORED_DECIMALS = 12
"""Decimals of the stored value, sufficient for a value typed in another unit."""
TIP_DELAY_MS = 300
"""Delay of the tip after the field loses the focus, since Qt then hides all tips."""


class NumberField(PanelEntry, QDoubleSpinBox):
    """Number field that keeps all digits of its value in the base unit and shows some of them.

    A value that is shown or confirmed without a change keeps all its digits. Any text can be typed;
    `parse_number` reads it. A text that is not a number, or is outside the range, is kept and
    marked, with the reason in a tip, also when the focus leaves; the value is then the former one.

    Parameters
    ----------
    base : Base or None
        Unit of the value; None if it is never converted.
    """

    committed = Signal(float)
    """The user changed the value, or confirmed an assumed one; emitted once, while `valueChanged`
    follows the typing."""
    assumed_changed = Signal(bool)
    is_assumed = False
    """Whether the value is a default that nobody gave."""
    _before: float | None = None
    """Value before the typing that is not committed yet."""
    _kept: str | None = None
    """Typed text that is not accepted, without the unit."""

    def __init__(self, base: Base | None = None) -> None:
        super().__init__()
        self._base = base
        self._factor = 1.0 if base is None else units.shown_unit(base).factor
        self._decimals = 2
        self.title = ""
        """Name of the field in messages, in the user's language; the tip if empty."""
        self.unit = ""
        """Unit of the number if it is shown beside the field; otherwise it is the suffix."""
        self.whole = False
        """Whether only whole numbers are accepted."""
        self._pending = PendingInput(self)
        super().setDecimals(STORED_DECIMALS)
        line = self.lineEdit()
        line.textEdited.connect(self._begin)
        line.textChanged.connect(self._check_text)

    def setDecimals(self, decimals: int) -> None:
        """Set the number of decimals in the base unit."""
        shown = decimals if self._base is None else units.shown_decimals(decimals, self._base)
        self._decimals = shown
        self._reformat_text()

    def decimals(self) -> int:
        """Number of decimals shown."""
        return self._decimals

    def setValue(self, value: float) -> None:
        """Set the value; a text being typed is kept unless it belonged to another value."""
        before = self.value() if self._before is None else self._before
        if self._is_edited and min(abs(value - before), abs(value - self.value())) < (
            EQUAL_TOLERANCE
        ):
            return
        self._end()
        self._set_assumed(False)
        super().setValue(value)

    def show_assumed(self, value: float) -> None:
        """Show a default that nobody gave in grey; a typed number, also the same one, is given."""
        self.setValue(value)
        self._set_assumed(True)

    def _set_assumed(self, is_assumed: bool) -> None:
        if self.is_assumed != is_assumed:
            self.is_assumed = is_assumed
            self.setProperty("assumed", is_assumed)
            self.assumed_changed.emit(is_assumed)
            self.style().unpolish(self)
            self.style().polish(self)

    def textFromValue(self, value: float) -> str:
        """Text of a value, in the unit shown, or the typed text that is not accepted."""
        return self._value_text(value) if self._kept is None else self._kept

    def validate(self, text: str, place: int) -> object:
        """Whether a text is a number inside the range; every text can be typed."""
        states = QValidator.State
        is_accepted = self._problem(text) is None
        return states.Acceptable if is_accepted else states.Intermediate, text, place

    def fixup(self, text: str) -> str:
        """Keep a text that is not accepted; Qt would remove its commas and read another number."""
        return text

    def valueFromText(self, text: str) -> float:
        """Value of a text in the unit shown; the former value if the text is that of it."""
        if text and text == self.specialValueText():
            return self.minimum()
        before = self.value() if self._before is None else self._before
        typed = self._parsed(text)
        if typed is None or typed == self._parsed(self._value_text(before)):
            return before
        return typed / self._factor

    @property
    def input_error(self) -> Message | None:
        """Reason why the text is not accepted; None if it is, or while a number is being typed."""
        return None if self._kept is None or self._is_unfinished else self._problem(self._kept)

    def commit(self) -> bool:
        """Make the typed number the value; return whether the text is accepted."""
        before = self._before
        if before is None:
            return self._kept is None
        kept = self._kept
        if kept is None:
            self.interpretText()  # without keyboard tracking, the value is still the former one
        self._end()
        self._kept = kept
        if kept is not None:
            super().setValue(before)
            self._reformat_text()
            self._mark(True, self._reason())
            return False
        self._reformat_text()
        was_assumed = self.is_assumed
        self._set_assumed(False)
        if was_assumed or abs(self.value() - before) > EQUAL_TOLERANCE:
            self.committed.emit(self.value())
        return True

    def restore(self) -> None:
        """Discard the typed text and show the former value."""
        value = self.value() if self._before is None else self._before
        self._end()
        super().setValue(value)
        self._reformat_text()

    def copy_state_from(self, former: "NumberField") -> None:
        """Copy the value of a field of a former window, and the text that is typed in it.

        An assumed value stays assumed.
        """
        value = former.value() if former._before is None else former._before
        self._end()
        if former.is_assumed:
            self.show_assumed(value)
        else:
            self.setValue(value)
        if not former._is_edited:
            return
        if former.is_typing:
            self._begin()
        text = text_in_unit(former._without_unit(former.text()), former._sign, self._sign)
        self._show_typed(text)

    def stepBy(self, steps: int) -> None:
        """Step from the typed value, or from the former one if the typed one is not accepted."""
        if self._kept is not None:
            self.restore()
        self._begin()
        super().stepBy(steps)
        if not self.hasFocus():
            self.commit()

    def event(self, event: QEvent) -> bool:
        """Use the keys that concern the typed text; leave Undo to the window if there is none."""
        is_handled = handle_shortcut_override(event, self._is_edited)
        return super().event(event) if is_handled is None else is_handled

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Commit the typed number, or show why it is not accepted."""
        if event.reason() != Qt.FocusReason.PopupFocusReason and not self.commit():
            QTimer.singleShot(TIP_DELAY_MS, self, self._show_reason)
        super().focusOutEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Commit the typed number with Enter; Escape discards it."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            if not self.commit():
                self._show_reason()
                event.accept()
                return
        elif event.key() == Qt.Key.Key_Escape and self._kept is not None:
            self.restore()
            event.accept()
            return
        super().keyPressEvent(event)

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Change the value with the wheel only if the field has the focus."""
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()

    def showEvent(self, event: QShowEvent) -> None:
        """Keep the text being typed, which Qt would format as a value."""
        text = self._without_unit(self.text())
        super().showEvent(event)
        if self._is_edited:
            self._show_typed(text)

    def _show_typed(self, text: str) -> None:
        """Show a text without its unit, with the cursor at its end."""
        self.lineEdit().setText(f"{text}{self.suffix()}")
        self.lineEdit().setCursorPosition(len(text))

    @property
    def _is_edited(self) -> bool:
        return self._before is not None or self._kept is not None

    @property
    def _is_unfinished(self) -> bool:
        """Whether more digits can make a number of the text being typed."""
        kept = self._kept
        return (
            self.is_typing
            and kept is not None
            and self._parsed(kept) is None
            and is_start_of_number(kept)
        )

    def _begin(self) -> None:
        """Store the value when the user begins to change it."""
        if self._before is None:
            self._before = self.value()
            self._pending.begin()

    def _end(self) -> None:
        self._before = self._kept = None
        self._pending.end()
        self._mark(False)

    def _check_text(self, text: str) -> None:
        """Keep and mark a text that is not accepted."""
        problem = self._problem(text)
        self._kept = None if problem is None else self._without_unit(text)
        self._mark(problem is not None and not self._is_unfinished, self._reason(problem))
        if problem is not None and problem.code == "window.out_of_range" and self.is_typing:
            self._show_tip(self._range_text())

    def _problem(self, text: str) -> Message | None:
        """Reason why a text is not accepted."""
        plain = self._without_unit(text)
        if plain and self.specialValueText() in (text, plain):
            return None
        number = self._parsed(text)
        name, unit = self.title or self.accessibleName(), self._sign
        if not plain:
            return error("window.empty_number", field=name)
        if number is None and unit:
            return error("window.not_a_number_in", field=name, text=plain, unit=unit)
        if number is None:
            return error("window.not_a_number", field=name, text=plain)
        if self.whole and number != round(number):
            return error("window.not_a_whole_number", field=name, text=plain)
        low, high = self._shown_limits()
        if not low <= number <= high:
            return error(
                "window.out_of_range", field=name, text=plain, unit=unit,
                low=self._value_text(self.minimum()), high=self._value_text(self.maximum()),
            )  # fmt: skip
        return None

    def _shown_limits(self) -> tuple[float, float]:
        """Limits in the unit shown, at least as wide as their texts."""
        limits = []
        for limit, choose in ((self.minimum(), min), (self.maximum(), max)):
            rounded = parse_number(self._value_text(limit))
            assert rounded is not None
            limits.append(choose(limit * self._factor, rounded))
        return limits[0], limits[1]

    def _parsed(self, text: str) -> float | None:
        return parse_number(self._without_unit(text), self._sign)

    @property
    def _sign(self) -> str:
        return self.unit or self.suffix().strip()

    def _without_unit(self, text: str) -> str:
        """Text without the unit that Qt adds after every text."""
        return text.removesuffix(self.suffix()).strip()

    def _value_text(self, value: float) -> str:
        shown = value * self._factor
        # A value that rounds to zero has no sign.
        shown = shown if round(shown, self._decimals) else 0.0
        locale = self.locale()
        text = locale.toString(float(shown), "f", self._decimals)
        return text.replace(locale.groupSeparator(), "").replace("-", "\N{MINUS SIGN}")

    def _reason(self, problem: Message | None = None) -> str:
        problem = problem or self.input_error
        return "" if problem is None else message_text(problem)

    def _show_reason(self) -> None:
        if self._kept is not None:
            self._show_tip(self._reason())

    def _range_text(self) -> str:
        low = self._value_text(self.minimum())
        high = f"{self._value_text(self.maximum())}{self.suffix()}"
        return gettext("Range: {low} to {high}", low=low, high=high)

    def _show_tip(self, text: str) -> None:
        # The tip is shown after a delay; over another field, it would seem to be about that one
        if not self.visibleRegion().isEmpty():
            QToolTip.showText(self.mapToGlobal(self.rect().bottomLeft()), text, self)

    def _reformat_text(self) -> None:
        """Format the text again, which Qt does not do by itself."""
        super().setDecimals(STORED_DECIMALS)
