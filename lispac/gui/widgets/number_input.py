"""Numbers typed by the user: one parser for all fields and tables, and their commit.

A typed text becomes the value of its field, the *commit*, when Enter is pressed, when the focus
leaves the field, and before a shortcut, a click elsewhere or an action is processed.
"""

import math
import re
from abc import abstractmethod
from collections.abc import Iterable, Iterator
from functools import lru_cache
from typing import Any

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QAction, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QApplication, QDialog, QScrollArea, QTabWidget, QToolTip, QWidget

from lispac.errors import InputError
from lispac.gui.appearance.message_texts import message_text
from lispac.messages import Message

_SPACES = dict.fromkeys(map(ord, "\N{NO-BREAK SPACE}\N{NARROW NO-BREAK SPACE}\N{THIN SPACE}"), " ")
_NUMBER_PATTERN = re.compile(
    r"(?P<sign>[+-]?)\s*(?P<whole>\d{1,3}(?: \d{3})+|\d*)(?:[.,](?P<part>\d*))?"
    r"(?P<exponent>[eE][+-]?\d+)?\s*(?P<unit>.*)"
)
_UNITS: dict[str, tuple[str, float]] = {
    **{sign: ("length", metres) for sign, metres in (
        ("m", 1.0), ("km", 1e3), ("cm", 1e-2), ("mm", 1e-3), ("µm", 1e-6), ("ft", 0.3048),
        ("ftUS", 1200 / 3937), ("in", 0.0254),
    )},
    **{sign: ("angle", degrees) for sign, degrees in (
        ("°", 1.0), ("deg", 1.0), ("′", 1 / 60), ("'", 1 / 60), ("″", 1 / 3600), ('"', 1 / 3600),
        ("rad", math.degrees(1)), ("mrad", math.degrees(1e-3)), ("µrad", math.degrees(1e-6)),
        ("gon", 0.9),
    )},
    **{sign: ("time", seconds) for sign, seconds in (
        ("s", 1.0), ("ms", 1e-3), ("µs", 1e-6), ("min", 60.0), ("h", 3600.0),
    )},
    **{sign: ("frequency", hertz) for sign, hertz in (("Hz", 1.0), ("kHz", 1e3), ("MHz", 1e6))},
}  # fmt: skip
"""Quantity of a unit, and its size in the base unit of the quantity."""

_COMMAND_KEYS = (
    Qt.KeyboardModifier.ControlModifier
    | Qt.KeyboardModifier.AltModifier
    | Qt.KeyboardModifier.MetaModifier
)
"""Keys held down for a command; others type characters."""

REASON_PROPERTY = "wrong_reason"
"""Property of a field with the reason why its text is not accepted; empty if it is."""


@lru_cache(maxsize=2048)
def parse_number(text: str, unit: str = "") -> float | None:
    """Number in a text, in ``unit``; None if the text is not a finite number.

    Accepted are a decimal point or comma, spaces between thousands, an exponent, any minus sign,
    and after the number ``unit`` or another unit of the same quantity, which is converted.
    """
    plain = text.translate(_SPACES).replace("\N{MINUS SIGN}", "-").replace("\u03bc", "µ").strip()
    match = _NUMBER_PATTERN.fullmatch(plain)
    if match is None or not (match["whole"] or match["part"]):
        return None
    factor = _conversion_factor(match["unit"], unit)
    if factor is None:
        return None
    digits = f"{match['whole'].replace(' ', '')}.{match['part'] or ''}"
    number = float(f"{match['sign']}{digits}{match['exponent'] or ''}")
    number = number if factor == 1.0 else number * factor
    return number if math.isfinite(number) else None


def text_in_unit(text: str, typed_unit: str, unit: str) -> str:
    """Text of a number typed in one unit, as it is typed in a field with another unit."""
    is_bare = parse_number(f"{text} {typed_unit}", typed_unit) is not None
    return f"{text} {typed_unit}" if is_bare and typed_unit != unit else text


def is_start_of_number(text: str) -> bool:
    """Whether a text becomes a number if more digits are typed."""
    return parse_number(text.rstrip() + "0") is not None


def _conversion_factor(typed: str, unit: str) -> float | None:
    if typed in ("", unit):
        return 1.0
    if typed not in _UNITS or unit not in _UNITS or _UNITS[typed][0] != _UNITS[unit][0]:
        return None
    return _UNITS[typed][1] / _UNITS[unit][1]


class NumberEntry:
    """Base of the widgets in which a number is typed."""

    is_typing = False
    """Whether a text was typed that is not committed. Qt sends events to unfinished objects too."""
    _usual_tip: str | None = None

    @property
    @abstractmethod
    def input_error(self) -> Message | None:
        """Reason why the text is not accepted; None if it is."""

    @abstractmethod
    def commit(self) -> bool:
        """Make the typed number the value; return whether the text is accepted."""

    @abstractmethod
    def restore(self) -> None:
        """Discard the typed text and show the value again."""

    def _mark(self, wrong: bool, reason: str = "") -> None:
        """Mark the widget as wrong, with the reason in its tip, or remove the mark."""
        assert isinstance(self, QWidget)
        if wrong:
            self._usual_tip = self.toolTip() if self._usual_tip is None else self._usual_tip
            self.setToolTip(reason or self._usual_tip)
        elif self._usual_tip is not None:
            self.setToolTip(self._usual_tip)
            self._usual_tip = None
        if (self.property(REASON_PROPERTY) or "") != reason:
            self.setProperty(REASON_PROPERTY, reason)
        if bool(self.property("wrong")) != wrong:
            self.setProperty("wrong", wrong)
            self.style().unpolish(self)
            self.style().polish(self)


class PanelEntry(NumberEntry):
    """Base of the fields of the panels, which continue in a new window."""

    @abstractmethod
    def copy_state_from(self, former: Any) -> None:
        """Copy the value of a field of the same class, and the text that is typed in it.

        A text that is not committed is not committed here.
        """


class PendingInput(QObject):
    """Commits the typed text of a field before a shortcut or a click elsewhere is processed.

    Actions are thus enabled or disabled according to the committed value.
    """

    def __init__(self, field: NumberEntry) -> None:
        assert isinstance(field, QWidget)
        super().__init__(field)
        self._field, self._widget = field, field

    def begin(self) -> None:
        """Start when the user types."""
        if not self._field.is_typing:
            self._field.is_typing = True
            QApplication.instance().installEventFilter(self)

    def end(self) -> None:
        """End when the text is committed or discarded."""
        if self._field.is_typing:
            self._field.is_typing = False
            QApplication.instance().removeEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Commit the text before another part of the window receives the event."""
        kind, field = event.type(), self._widget
        if (
            kind == QEvent.Type.MouseButtonPress
            and isinstance(watched, QWidget)
            and watched is not field
            and not field.isAncestorOf(watched)
            and watched.window() is field.window()
        ) or (kind == QEvent.Type.ShortcutOverride and _is_shortcut(event)):
            self._field.commit()
        return False


def handle_shortcut_override(event: QEvent, is_edited: bool) -> bool | None:
    """Decide whether a key is for a field or an action; None if Qt decides.

    Enter and Escape are for the field while it contains a typed text. Undo and Redo are for the
    window otherwise.

    Returns
    -------
    bool or None
        Whether the field has used the event.
    """
    if event.type() != QEvent.Type.ShortcutOverride:
        return None
    assert isinstance(event, QKeyEvent)
    if is_edited and event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Escape):
        event.accept()
        return True
    if not is_edited and _is_undo_key(event):
        event.ignore()
        return False
    return None


def _is_undo_key(event: QKeyEvent) -> bool:
    """Whether a key event is that of Undo or Redo."""
    keys = QKeySequence.StandardKey
    return event.matches(keys.Undo) or event.matches(keys.Redo)


def types_character(event: QKeyEvent) -> bool:
    """Whether a key types a visible character, with or without Shift."""
    return (
        event.text().isprintable()
        and bool(event.text().strip())
        and not (event.modifiers() & _COMMAND_KEYS)
    )


def _is_shortcut(event: QEvent) -> bool:
    """Whether a key starts an action of a window; Undo reverts the typing itself."""
    assert isinstance(event, QKeyEvent)
    if _is_undo_key(event) or (event.text() and not event.modifiers() & _COMMAND_KEYS):
        return False
    pressed = QKeySequence(event.keyCombination())
    return any(
        pressed in action.shortcuts()
        for window in QApplication.topLevelWidgets()
        for action in window.findChildren(QAction)
    )


def commit_focused_field() -> bool:
    """Commit the number typed in the focused field; return whether it was accepted."""
    field = QApplication.focusWidget()
    return field.commit() if isinstance(field, NumberEntry) else True


def number_fields(widget: QWidget) -> list[QWidget]:
    """Number fields of a widget."""
    return [each for each in widget.findChildren(QWidget) if isinstance(each, NumberEntry)]


def wrong_fields(fields: Iterable[QWidget]) -> Iterator[tuple[QWidget, Message]]:
    """Enabled number fields whose text is not accepted, and the reasons."""
    for field in fields:
        if field.isEnabled():
            problem = field.input_error
            if problem is not None:
                yield field, problem


def first_error_of(fields: Iterable[QWidget]) -> Message | None:
    """Reason why the text of a number field is not accepted; None if all are."""
    return next((problem for _, problem in wrong_fields(fields)), None)


def first_input_error(widget: QWidget) -> Message | None:
    """Reason why a text in a number field of a widget is not accepted; None if all are."""
    return first_error_of(number_fields(widget))


def require_accepted_texts(widget: QWidget) -> None:
    """Refuse a widget with a wrong number field.

    Raises
    ------
    InputError
        If the text of a number field is not accepted.
    """
    problem = first_input_error(widget)
    if problem is not None:
        raise InputError(problem)


def scroll_to(field: QWidget) -> None:
    """Make a field visible in the scroll areas around it."""
    around = field.parentWidget()
    while around is not None:
        if isinstance(around, QScrollArea):
            around.ensureWidgetVisible(field)
        around = around.parentWidget()


class NumberDialog(QDialog):
    """Dialogue that is not accepted while a text in one of its number fields is not accepted."""

    def accept(self) -> None:
        """Close the dialogue, or show the first wrong field."""
        if not self._show_wrong_field():
            super().accept()

    def _show_wrong_field(self) -> bool:
        """Show the first wrong field and the reason; return whether there is one."""
        commit_focused_field()
        field, problem = next(wrong_fields(number_fields(self)), (None, None))
        if field is None or problem is None:
            return False
        page: QWidget = field
        while page is not self:
            parent = page.parentWidget()
            tabs = parent.parentWidget()
            if isinstance(tabs, QTabWidget) and tabs.indexOf(page) >= 0:
                tabs.setCurrentWidget(page)
            page = parent
        field.setFocus()
        scroll_to(field)
        place = field.mapToGlobal(field.rect().bottomLeft())
        QToolTip.showText(place, message_text(problem), field)
        return True
