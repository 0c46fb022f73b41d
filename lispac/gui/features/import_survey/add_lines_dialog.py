"""Import dialogue for lines that are added to the open project."""

from PySide6.QtWidgets import QWidget

from lispac.gui.app.settings import AppSettings
from lispac.gui.features.import_survey.import_dialog import MOUNTING, ImportDialog
from lispac.language import gettext
from lispac.project import LineSource, Project
from lispac.workflow.importing.input_files import InputFiles


class AddLinesDialog(ImportDialog):
    """Adds lines to a project and checks them against its trajectory.

    Parameters
    ----------
    project : Project
        The open project.
    """

    def __init__(
        self, settings: AppSettings, project: Project, parent: QWidget | None = None
    ) -> None:
        super().__init__(settings, parent)
        self.setWindowTitle(gettext("Add lines to {project}", project=project.name))
        self.ok.setText(gettext("Add to project"))
        self.place.hide()
        self.tabs.setTabVisible(MOUNTING, False)
        self.work.begin(InputFiles.of_project(project))

    def sources(self) -> tuple[LineSource, ...]:
        """The lines to add."""
        return self.input_files.sources()

    def _problem_text(self) -> str:
        if self.input_files.files and not self.input_files.lines and not self.work.busy:
            return gettext(
                "No lines have been added yet. Drop the scan files of the lines here, or press "
                "Add files."
            )
        return self.input_files.files_problem_text()

    def _hint(self) -> str:
        if any(line.is_georeferenced for line in self.input_files.lines):
            return gettext(
                "Georeferenced lines are transformed back to the scanner frame with the lever arm "
                "and prior boresight of the project. Add only lines that were georeferenced with "
                "these values."
            )
        return ""
