"""Actions, dialogues and controllers of the export."""

from lispac.gui.features.export.actions import ACTIONS
from lispac.gui.features.export.data_export import DataExport
from lispac.gui.features.export.dialogs import ExportDialogs
from lispac.gui.features.export.script_export import ScriptExport
from lispac.gui.project.features import Feature, WindowParts


def _connect(window: WindowParts[ExportDialogs]) -> None:
    DataExport(
        window.document, window.runner, window.scene, window.controller, window.dialogs,
        window.actions,
    )  # fmt: skip
    ScriptExport(window.document, window.runner, window.controller, window.dialogs, window.actions)


FEATURE = Feature(ACTIONS, ExportDialogs, connect=_connect)
