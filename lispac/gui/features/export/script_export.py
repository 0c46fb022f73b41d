"""File > Script of this project: created in the background, shown, and saved on request."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from lispac.errors import InputError
from lispac.gui.app.actions import Actions
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.app.unavailable import Unavailable, first_reason
from lispac.gui.features.export.dialogs import ExportDialogs
from lispac.gui.project.availability import data_reason
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.language import gettext
from lispac.progress import Progress
from lispac.project import Project

if TYPE_CHECKING:
    from lispac.workflow.output.script import Script


class ScriptExport(QObject):
    """Creates the script of the project, shows it and saves it."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        controller: Controller,
        dialogs: ExportDialogs,
        actions: Actions,
    ) -> None:
        super().__init__(actions)
        self._document, self._runner = document, runner
        self._controller, self._dialogs = controller, dialogs
        self._actions = actions
        actions.connect_slots({"script": self.show_script})
        for moved in (self._document.changed, self._document.survey_changed, self._runner.changed):
            moved.connect(self._enable_controls)
        self._enable_controls()

    def show_script(self) -> None:
        """Create the script of the current project and show it."""
        project, survey = self._document.current_data
        if project is None or survey is None:
            return

        def work(progress: Progress) -> "Script":
            from lispac.workflow.output.script import script_of

            return script_of(project, survey, progress=progress)

        task = self._runner.run(
            gettext("Writing the script of this project"),
            work,
            lambda made: self._show(project, made),
            modal=True,
        )
        self._controller.cancel_on_edit(task)

    def _show(self, project: Project, script: "Script") -> None:
        def save() -> str:
            path = self._dialogs.script_file(project.folder / f"{project.name}.py")
            if path is None:
                return ""
            from lispac.workflow.output.script import save_script

            try:
                save_script(script, path)
            except InputError as error:
                self._controller.refused.emit(error)
                return ""
            text = gettext("Wrote {path}", path=path)
            self._controller.logged.emit(text)
            return text

        self._dialogs.script(script, save)

    def _enable_controls(self) -> None:
        self._actions.set_reason(
            "script",
            data_reason(self._document, self._runner)
            or first_reason((self._document.awaits_result, Unavailable.WAITING)),
        )
