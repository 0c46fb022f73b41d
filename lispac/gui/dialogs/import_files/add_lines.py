"""The import dialogue for lines that are added to an open project."""

from PySide6.QtWidgets import QWidget

from lispac.gui.dialogs.import_files.dialog import MOUNTING, ImportDialog
from lispac.gui.language import say
from lispac.gui.settings import AppSettings
from lispac.project import LineSource, Project
from lispac.workflow.intake import Intake


class AddLinesDialog(ImportDialog):
    """Checks more lines against the project's own trajectory; what the project has stays as it is.

    Parameters
    ----------
    project : Project
        That is open.
    """

    def __init__(
        self, settings: AppSettings, project: Project, parent: QWidget | None = None
    ) -> None:
        super().__init__(settings, parent)
        self.setWindowTitle(say(f"Add lines to {project.name}"))
        self.ok.setText(say("Add to project"))
        self.place.hide()
        self.tabs.setTabVisible(MOUNTING, False)
        self.work.begin(Intake.of_project(project))

    def sources(self) -> tuple[LineSource, ...]:
        """The lines to add."""
        return self.intake.sources()

    def _problem(self) -> str:
        if self.intake.entries and not self.intake.lines and not self.work.busy:
            return "Add the scan files of the lines: drop them here, or press Add files."
        return self.intake.files_problem()

    def _hint(self) -> str:
        if any(line.georeferenced for line in self.intake.lines):
            return say(
                "Lines on the map are taken back to the scanner with the project's lever arm and "
                "prior boresight: they have to be those the lines were made with."
            )
        return ""
