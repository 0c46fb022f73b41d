"""Transfer of the state of a window to the one that replaces it: fields, choices, view."""

from typing import TYPE_CHECKING, TypeVar

from PySide6.QtWidgets import QAbstractButton, QComboBox, QWidget

from lispac.errors import InputError
from lispac.gui.app.view_actions import COLOUR_ACTIONS
from lispac.gui.widgets.fields import OptionalNumber
from lispac.gui.widgets.number_field import NumberField

if TYPE_CHECKING:
    from lispac.gui.window.main_window import MainWindow

W = TypeVar("W", bound=QWidget)


def transfer_window_state(former: "MainWindow", new: "MainWindow") -> None:
    """Transfer fields and choices of the steps, the open step, the view and the candidate."""
    for before, after in (
        (former.data, new.data),
        (former.targets, new.targets),
        (former.adjust, new.adjust),
        (former.validate, new.validate),
    ):
        copy_fields(before, after)
    new.workflow.open(former.workflow.opened)
    if former.controller.candidate is not None:
        new.controller.set_candidate(former.controller.candidate)
    _transfer_view(former, new)
    if former.tour.is_running:
        new.tour.resume()


def copy_fields(before: QWidget, after: QWidget) -> None:
    """Copy choices and numbers between the fields that have the same names.

    Choices first: they may set the unit of a number.
    """
    _copy_choices(before, after)
    _copy_numbers(before, after)


def _copy_choices(before: QWidget, after: QWidget) -> None:
    for list_, own in _matching_fields(QComboBox, before, after):
        if list_.count() == own.count():
            own.setCurrentIndex(list_.currentIndex())
    for button, own in _matching_fields(QAbstractButton, before, after):
        # A radio button cannot be switched off, only another one on.
        if button.isCheckable() and (button.isChecked() or not own.autoExclusive()):
            own.setChecked(button.isChecked())


def _copy_numbers(before: QWidget, after: QWidget) -> None:
    for number, own in _matching_fields(NumberField, before, after):
        own.setValue(number.value())
    for optional, own in _matching_fields(OptionalNumber, before, after):
        try:
            own.show_value(optional.value())
        except InputError:
            own.setText(optional.text())
        own.textChanged.emit(own.text())


def _transfer_view(former: "MainWindow", new: "MainWindow") -> None:
    """Transfer the state and the colouring of the view."""
    new.scene.copy_state_from(former.scene)
    for name in ("wipe", COLOUR_ACTIONS[former.scene.colouring]):
        new.actions_[name].setChecked(former.actions_[name].isChecked())


def _matching_fields(kind: type[W], before: QWidget, after: QWidget) -> list[tuple[W, W]]:
    """Pairs of fields of one kind with the same name in both widgets."""
    named = {each.objectName(): each for each in after.findChildren(kind) if each.objectName()}
    return [
        (each, named[each.objectName()])
        for each in before.findChildren(kind)
        if each.objectName() in named
    ]
