"""Alternative methods for the boresight: their results, and running those without one."""

from collections.abc import Mapping

from PySide6.QtCore import QObject

from lispac.gui.app.actions import Actions
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.features.studies.dialogs import StudyDialogs
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.language import N_, gettext
from lispac.messages import Message
from lispac.method_comparison import method_results, missing_methods
from lispac.progress import Progress
from lispac.project import Project
from lispac.workflow.calibration.method_runs import run_missing_methods
from lispac.workflow.project.survey import Survey

MissingResults = tuple[Project, Mapping[str, Message]]


class AlternativeMethods(QObject):
    """Shows the results of alternative methods and runs those that have none."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        controller: Controller,
        dialogs: StudyDialogs,
        actions: Actions,
    ) -> None:
        super().__init__(actions)
        self._document, self._runner = document, runner
        self._controller, self._dialogs = controller, dialogs
        self._action = actions["methods"]
        actions.connect_slots({"methods": self.compare})
        for moved in (self._document.changed, self._document.survey_changed, self._runner.changed):
            moved.connect(self._enable_controls)
        self._enable_controls()

    def compare(self, refused: Mapping[str, Message] | None = None) -> None:
        """Show the available results, and run the other methods on request.

        Parameters
        ----------
        refused : why a method has no result, by its name
        """
        project, survey = self._document.project, self._document.survey
        if project is None or survey is None or not self._document.survey_is_current:
            return
        run_missing = self._dialogs.methods(
            method_results(project), missing_methods(project), refused or {}
        )
        if run_missing and self._document.project is project:
            self._run_missing(project, survey)

    def _run_missing(self, project: Project, survey: Survey) -> None:
        def work(progress: Progress) -> MissingResults:
            return run_missing_methods(project, survey, progress=progress)

        def done(results: MissingResults) -> None:
            found, refused = results
            if found is not project:
                self._document.edit(N_("results of alternative methods"), found)
            self.compare(refused)

        task = self._runner.run(gettext("Running alternative methods"), work, done, modal=True)
        self._controller.cancel_on_edit(task)

    def _enable_controls(self) -> None:
        ready = self._document.survey_is_current and not self._runner.busy
        self._action.setEnabled(self._document.project is not None and ready)
