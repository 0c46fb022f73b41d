"""Transfer of choices and numbers between the fields of two widgets."""

from typing import TypeVar

from PySide6.QtWidgets import QAbstractButton, QComboBox, QWidget

from lispac.errors import InputError
from lispac.gui.widgets.number_field import NumberField
from lispac.gui.widgets.optional_number import OptionalNumber

WidgetType = TypeVar("WidgetType", bound=QWidget)


def copy_fields(before: QWidget, after: QWidget) -> None:
    """Copy choices and numbers between the fields that have the same names.

    Choices are copied first, since they may set the unit of a number.
    """
    _copy_choices(before, after)
    _copy_numbers(before, after)


def _copy_choices(before: QWidget, after: QWidget) -> None:
    for box, copied in _matching_fields(QComboBox, before, after):
        if box.count() == copied.count():
            copied.setCurrentIndex(box.currentIndex())
    for button, copied in _matching_fields(QAbstractButton, before, after):
        # A radio button is switched off only by switching on another one.
        if button.isCheckable() and (button.isChecked() or not copied.autoExclusive()):
            copied.setChecked(button.isChecked())


def _copy_numbers(before: QWidget, after: QWidget) -> None:
    for number, copied in _matching_fields(NumberField, before, after):
        copied.setValue(number.value())
        if number.input_error is not None:
            copied.lineEdit().setText(number.text())
    for optional, copied in _matching_fields(OptionalNumber, before, after):
        try:
            copied.show_value(optional.value())
        except InputError:
            copied.setText(optional.text())
        copied.textChanged.emit(copied.text())


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
