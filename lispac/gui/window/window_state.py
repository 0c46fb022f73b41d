"""Transfer of the state of a window to the one that replaces it: fields, choices, view."""

from typing import TYPE_CHECKING

from lispac.gui.app.view_actions import COLOUR_ACTIONS
from lispac.gui.widgets.field_transfer import copy_fields

if TYPE_CHECKING:
    from lispac.gui.window.main_window import MainWindow


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


def _transfer_view(former: "MainWindow", new: "MainWindow") -> None:
    """Transfer the state and the colouring of the view."""
    new.scene.copy_state_from(former.scene)
    for name in ("wipe", COLOUR_ACTIONS[former.scene.colouring]):
        new.actions_[name].setChecked(former.actions_[name].isChecked())
