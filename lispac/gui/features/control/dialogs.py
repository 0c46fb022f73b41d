"""Dialogues of the surveyed control."""

from typing import TYPE_CHECKING

from lispac.gui.app.questions import Questions, run_dialog
from lispac.project import Project

if TYPE_CHECKING:
    from lispac.gui.features.control.control_dialog import ControlChoice
    from lispac.gui.features.control.import_dialog import ControlRequest
    from lispac.survey.trajectory import LocalTrajectory


class ControlDialogs(Questions):
    """Dialogues that show the control and ask for a file."""

    def control(self, project: Project) -> "ControlChoice | None":
        """Show the control of a project; None if nothing is to be changed."""
        from lispac.gui.features.control.control_dialog import ControlDialog

        dialog = ControlDialog(project, self.parent)
        return dialog.choice if run_dialog(dialog) else None

    def control_file(
        self, project: Project, trajectory: "LocalTrajectory"
    ) -> "ControlRequest | None":
        """Ask for a file with control; None if cancelled."""
        from lispac.gui.features.control.import_dialog import ControlImportDialog

        dialog = ControlImportDialog(project, trajectory, self.parent)
        return dialog.request if run_dialog(dialog) else None
