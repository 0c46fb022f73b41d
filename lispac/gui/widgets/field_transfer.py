"""Transfer of choices, numbers, texts and scroll positions between two widgets."""

from functools import partial
from typing import TypeVar

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractScrollArea,
    QComboBox,
    QPlainTextEdit,
    QWidget,
)

from lispac.gui.widgets.number_input import PanelEntry

WidgetType = TypeVar("WidgetType", bound=QWidget)


def copy_fields(before: QWidget, after: QWidget) -> None:
    """Copy choices, numbers and texts between the fields that have the same names.

    Choices are copied first, since they may set the unit of a number, or clear a text.
    """
    _copy_choices(before, after)
    _copy_entries(before, after)


def copy_scroll_positions(before: QWidget, after: QWidget) -> None:
    """Scroll the areas and tables that have the same names to the same places, once laid out."""
    for area, copied in _matching_fields(QAbstractScrollArea, before, after):
        for bar, other in (
            (area.verticalScrollBar(), copied.verticalScrollBar()),
            (area.horizontalScrollBar(), copied.horizontalScrollBar()),
        ):
            if bar.value():
                QTimer.singleShot(0, other, partial(other.setValue, bar.value()))


def _copy_choices(before: QWidget, after: QWidget) -> None:
    for box, copied in _matching_fields(QComboBox, before, after):
        if box.count() == copied.count():
            copied.setCurrentIndex(box.currentIndex())
    for button, copied in _matching_fields(QAbstractButton, before, after):
        # A radio button is switched off only by switching on another one.
        if button.isCheckable() and (button.isChecked() or not copied.autoExclusive()):
            copied.setChecked(button.isChecked())


def _copy_entries(before: QWidget, after: QWidget) -> None:
    for field, copied in _matching_fields(QWidget, before, after):
        if isinstance(copied, PanelEntry):
            copied.copy_state_from(field)
    for text, copied in _matching_fields(QPlainTextEdit, before, after):
        if not text.isReadOnly() and text.toPlainText() != copied.toPlainText():
            copied.setPlainText(text.toPlainText())


def _matching_fields(
    kind: type[WidgetType], before: QWidget, after: QWidget
) -> list[tuple[WidgetType, WidgetType]]:
    """Pairs of fields of one kind with the same name in both widgets."""
    named = {each.objectName(): each for each in after.findChildren(kind) if each.objectName()}
    return [
        (each, named[each.objectName()])
        for each in before.findChildren(kind)
        if each.objectName() in named
    ]
