"""Dialogues about exported data and the script."""

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QFileDialog

from lispac.gui.app.questions import Questions, run_dialog
from lispac.gui.features.export.export_dialog import ExportDialog
from lispac.gui.features.export.script_dialog import ScriptDialog
from lispac.language import gettext
from lispac.project import Project
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.output.export_request import ExportRequest, What
from lispac.workflow.output.georeferencing import Which

if TYPE_CHECKING:
    from lispac.workflow.output.script import Script


class ExportDialogs(Questions):
    """Dialogues about exported data and the script."""

    def export(
        self, what: What, which: Which, project: Project, trajectory: LocalTrajectory
    ) -> ExportRequest | None:
        """Ask for the options of an export; None if cancelled."""
        dialog = ExportDialog(what, which, project, trajectory, self.parent)
        return dialog.request() if run_dialog(dialog) else None

    def script_file(self, start: Path) -> Path | None:
        """File for the script of the project."""
        name, _ = QFileDialog.getSaveFileName(
            self.parent, gettext("Save the script"), str(start), "Python (*.py)"
        )
        return Path(name if Path(name).suffix else f"{name}.py") if name else None

    def script(self, script: "Script", save: Callable[[], str]) -> None:
        """Show the script of the project; ``save`` saves it and returns a text about it."""
        run_dialog(ScriptDialog(script, save, self.parent))
