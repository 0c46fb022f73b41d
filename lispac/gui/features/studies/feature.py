"""Actions, dialogues and controllers of the studies."""

from lispac.gui.features.studies.actions import ACTIONS
from lispac.gui.features.studies.dialogs import StudyDialogs
from lispac.gui.features.studies.studies import AlternativeMethods, Studies
from lispac.gui.project.features import Feature, WindowParts


def _connect(window: WindowParts[StudyDialogs]) -> Studies:
    studies = Studies(
        window.document, window.runner, window.scene, window.viewport, window.controller,
        window.dialogs, window.actions,
    )  # fmt: skip
    AlternativeMethods(
        window.document, window.runner, window.controller, window.dialogs, window.actions
    )
    return studies


FEATURE = Feature(ACTIONS, StudyDialogs, connect=_connect)
