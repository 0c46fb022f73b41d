"""Export of the georeferenced lines, the targets or the trajectory."""

from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject

from lispac.gui.app.actions import Actions
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.export.dialogs import ExportDialogs
from lispac.gui.project.availability import data_reason
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.language import N_, Plural, gettext
from lispac.messages import Message
from lispac.progress import Progress
from lispac.workflow.output.export_request import ExportContent, ExportRequest

EXPORT_TITLES = {
    "lines": N_("Writing the lines"),
    "targets": N_("Writing the targets"),
    "planes": N_("Writing the files of the planes"),
    "trajectory": N_("Writing the trajectory"),
    "corrected_trajectory": N_("Writing the corrected trajectory"),
}
"""Title of the task that exports each kind of data."""
DATA_KINDS: tuple[ExportContent, ...] = (
    "lines",
    "targets",
    "trajectory",
    "corrected_trajectory",
)
"""Kinds of data with their own export action, which has the same name."""


class DataExport(QObject):
    """Asks for the options of an export and writes it in the background."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        scene: Scene,
        controller: Controller,
        dialogs: ExportDialogs,
        actions: Actions,
    ) -> None:
        super().__init__(actions)
        self._document, self._runner, self._scene = document, runner, scene
        self._controller, self._dialogs, self._actions = controller, dialogs, actions
        actions.connect_slots({what: partial(self.export, what) for what in DATA_KINDS})
        for changed in (document.changed, document.survey_changed, runner.changed):
            changed.connect(self._enable_controls)
        self._enable_controls()

    def export(self, what: ExportContent = "lines") -> None:
        """Show the export dialogue and export lines, targets or the trajectory."""
        project, survey = self._document.project, self._document.survey
        if project is not None and survey is not None:
            request = self._dialogs.export(what, self._scene.which, project, survey.trajectory)
            if request is not None:
                self._write(request)

    def _write(self, request: ExportRequest) -> None:
        """Export lines, targets or the trajectory to files."""
        project, survey = self._document.current_data
        if project is None or survey is None:
            return

        def work(progress: Progress) -> tuple[list[Path], tuple[Message, ...]]:
            from lispac.workflow.output.export_request import export

            return export(project, survey, request, progress=progress)

        def done(written: tuple[list[Path], tuple[Message, ...]]) -> None:
            paths, notes = written
            for note in notes:
                self._controller.logged.emit(message_text(note))
            wrote = Plural("Wrote {path}", "Wrote {path} ({count:n} files)")
            self._controller.logged.emit(gettext(wrote, count=len(paths), path=request.output))

        self._runner.run(gettext(EXPORT_TITLES[request.what]), work, done, persistent=True)

    def _enable_controls(self) -> None:
        for what in DATA_KINDS:
            self._actions.set_reason(what, data_reason(self._document, self._runner))
