"""Action, dialogues and controller of the surveyed control."""

from lispac.gui.features.control.actions import ACTIONS
from lispac.gui.features.control.controller import ControlController
from lispac.gui.features.control.dialogs import ControlDialogs
from lispac.gui.project.features import Feature, WindowParts


def _connect(window: WindowParts[ControlDialogs]) -> None:
    ControlController(
        window.document, window.runner, window.controller, window.dialogs, window.actions
    )


FEATURE = Feature(ACTIONS, ControlDialogs, connect=_connect)
