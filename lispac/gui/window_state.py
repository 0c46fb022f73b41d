"""Transfer of the state of a window to the one that replaces it: fields, choices, view."""

from typing import TYPE_CHECKING, TypeVar

from PySide6.QtWidgets import QAbstractButton, QComboBox, QWidget

from lispac.errors import InputError
from lispac.gui.panels.fields import OptionalNumber
from lispac.gui.panels.number_field import NumberField
from lispac.gui.viewing_actions import COLOURED

if TYPE_CHECKING:
    from lispac.gui.main_window import MainWindow

Kind = TypeVar("Kind", bound=QWidget)


def carry_over(former: "MainWindow", heir: "MainWindow") -> None:
    """Transfer fields and choices of the steps, the open step, the view and the candidate."""
    for before, after in (
        (former.data, heir.data),
        (former.targets, heir.targets),
        (former.adjust, heir.adjust),
        (former.validate, heir.validate),
    ):
        fill_in(before, after)
    heir.workflow.open(former.workflow.opened)
    if former.controller.candidate is not None:
        heir.controller.offer(former.controller.candidate)
    _shown(former, heir)
    if former.tour.on:
        heir.tour.go_on()


def fill_in(before: QWidget, after: QWidget) -> None:
    """Copy choices and numbers between the fields that have the same names.

    Choices first: they may set the unit of a number.
    """
    _choices(before, after)
    _numbers(before, after)


def _choices(before: QWidget, after: QWidget) -> None:
    for list_, own in _pairs(QComboBox, before, after):
        if list_.count() == own.count():
            own.setCurrentIndex(list_.currentIndex())
    for button, own in _pairs(QAbstractButton, before, after):
        # A radio button cannot be switched off, only another one on.
        if button.isCheckable() and (button.isChecked() or not own.autoExclusive()):
            own.setChecked(button.isChecked())


def _numbers(before: QWidget, after: QWidget) -> None:
    for number, own in _pairs(NumberField, before, after):
        own.setValue(number.value())
    for optional, own in _pairs(OptionalNumber, before, after):
        try:
            own.show_value(optional.value())
        except InputError:
            own.setText(optional.text())
        own.textChanged.emit(own.text())


def _shown(former: "MainWindow", heir: "MainWindow") -> None:
    """Transfer the state and the colouring of the view."""
    heir.scene.take_over(former.scene)
    for name in ("wipe", COLOURED[former.scene.colouring]):
        heir.actions_[name].setChecked(former.actions_[name].isChecked())


def _pairs(kind: type[Kind], before: QWidget, after: QWidget) -> list[tuple[Kind, Kind]]:
    """Fields of one kind that have the same name in both."""
    named = {each.objectName(): each for each in after.findChildren(kind) if each.objectName()}
    return [
        (each, named[each.objectName()])
        for each in before.findChildren(kind)
        if each.objectName() in named
    ]
