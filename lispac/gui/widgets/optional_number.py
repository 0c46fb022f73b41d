"""Field for a number with its unit that may be empty."""

from PySide6.QtCore import QEvent, QLocale, Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QLineEdit

from lispac.errors import InputError
from lispac.gui.appearance import theme, units
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.appearance.units import Base
from lispac.gui.widgets.number_input import (
    PanelEntry,
    PendingInput,
    handle_shortcut_override,
    parse_number,
    text_in_unit,
)
from lispac.language import gettext
from lispac.messages import Message, error

BASE_OF_SIGN: dict[str, Base] = {"m": "m", "mm": "mm", "°": "°"}


class OptionalNumber(PanelEntry, QLineEdit):
    """Field for a number with its unit; an empty field means unknown.

    `parse_number` reads the text. A text that is not a number is kept and marked.

    Parameters
    ----------
    title : name of the field in the user's language, as all texts of this class
    unit : sign of the base unit
    scale : number of base units in one metre, radian or second
    empty : meaning of an empty field, or the expected content of a ``needed`` field
    description : description of the number, without its unit
    limits : smallest and largest value, metres, radians or seconds; None if there are none
    """

    committed = Signal()
    """The user changed the value."""

    def __init__(
        self,
        name: str,
        title: str,
        unit: str,
        scale: float,
        empty: str,
        description: str,
        needed: bool = False,
        limits: tuple[float, float] | None = None,
    ) -> None:
        super().__init__()
        self._pending = PendingInput(self)
        self.setObjectName(name)
        base = BASE_OF_SIGN.get(unit)
        shown = units.shown_unit(base) if units.is_converted(base) else units.Unit(unit)
        self.setAccessibleName(f"{title}, {shown.sign}")
        if needed:
            tip = gettext("{description}, in {unit}", description=description, unit=shown.sign)
        else:
            tip = gettext(
                "{description}, in {unit}. If empty: {meaning}.",
                description=description, unit=shown.sign, meaning=empty,
            )  # fmt: skip
        self.setToolTip(tip)
        self.setPlaceholderText(empty)
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setFont(theme.tabular_font(self.font()))
        self.setMinimumWidth(48)
        self._title, self._unit, self._scale = title, shown.sign, scale * shown.factor
        self._limits = limits
        self._shown_value: tuple[str, float] | None = None
        self.textEdited.connect(self._pending.begin)
        self.textChanged.connect(self._mark_invalid)
        self.editingFinished.connect(self.commit)

    @property
    def unit(self) -> str:
        """Sign of the unit in which the number is typed."""
        return self._unit

    def value(self) -> float | None:
        """Value in metres, radians or seconds; None if the field is empty.

        Raises
        ------
        InputError
            If the text is not a number, or the value is outside the limits.
        """
        if self._shown_value is not None and self.text() == self._shown_value[0]:
            return self._shown_value[1]  # an unchanged value keeps all its digits
        text = self.text().strip()
        if not text:
            return None
        number = parse_number(text, self._unit)
        if number is None:
            raise InputError(
                error("window.not_a_number_in", field=self._title, text=text, unit=self._unit)
            )
        value = number / self._scale
        if self._limits is not None and not self._limits[0] <= value <= self._limits[1]:
            low, high = (
                units.localised(units.plain_figure(each * self._scale, 6)) for each in self._limits
            )
            raise InputError(
                error(
                    "window.out_of_range",
                    field=self._title, text=text, unit=self._unit, low=low, high=high,
                )
            )  # fmt: skip
        return value

    def show_value(self, value: float | None) -> None:
        """Fill in a value without emitting a signal; a wrong text of the same value is kept."""
        if self._is_shown(value) and (self.is_typing or self.input_error is not None):
            return
        self._pending.end()
        self.blockSignals(True)
        shown = "" if value is None else units.plain_figure(value * self._scale, 6)
        self.setText(shown.replace(".", QLocale().decimalPoint()))
        self._shown_value = None if value is None else (self.text(), value)
        self.blockSignals(False)
        self._mark_invalid()

    @property
    def input_error(self) -> Message | None:
        """Reason why the text is not accepted; None if it is."""
        try:
            self.value()
        except InputError as failure:
            return failure.message
        return None

    def commit(self) -> bool:
        """Make the typed number the value; return whether the text is accepted."""
        is_typed = self.is_typing
        self._pending.end()
        self._mark_invalid()
        if self.input_error is not None:
            return False
        value = self.value()
        if is_typed and not self._is_shown(value):
            self.show_value(value)
            self.committed.emit()
        return True

    def restore(self) -> None:
        """Discard the typed text and show the value again."""
        self._pending.end()
        self.setText("" if self._shown_value is None else self._shown_value[0])

    def copy_state_from(self, former: "OptionalNumber") -> None:
        """Copy the value of a field of a former window, and the text that is typed in it."""
        self._pending.end()
        if former.is_typing or former.input_error is not None:
            self.show_value(None if former._shown_value is None else former._shown_value[1])
            if former.is_typing:
                self._pending.begin()
            self.setText(text_in_unit(former.text(), former.unit, self.unit))
        else:
            self.show_value(former.value())
        self.textChanged.emit(self.text())

    def event(self, event: QEvent) -> bool:
        """Use the keys that concern the typed text; leave Undo to the window if there is none."""
        is_handled = handle_shortcut_override(event, self.is_typing)
        return super().event(event) if is_handled is None else is_handled

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Discard a text that is not accepted with Escape."""
        if event.key() == Qt.Key.Key_Escape and self.input_error is not None:
            self.restore()
            event.accept()
            return
        super().keyPressEvent(event)

    def _is_shown(self, value: float | None) -> bool:
        """Whether the last value that was shown equals this one."""
        return value == (None if self._shown_value is None else self._shown_value[1])

    def _mark_invalid(self) -> None:
        """Mark the field as wrong if its text is not a number or is negative."""
        problem = self.input_error
        wrong = problem is not None or (self.value() or 0.0) < 0
        self._mark(wrong, "" if problem is None else message_text(problem))
