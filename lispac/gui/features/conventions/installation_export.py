"""Files with the boresight and lever arm of the panel for another program."""

from PySide6.QtCore import QObject

from lispac.gui.app.actions import Actions
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.conventions.convention_panel import ConventionPanel
from lispac.gui.features.conventions.dialogs import ConventionDialogs
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.installation_paths import home_folder
from lispac.language import gettext
from lispac.messages import Message
from lispac.progress import Progress
from lispac.workflow.output.installation import installation_formats, write_installation


class InstallationExport(QObject):
    """Asks for a file for the program chosen in the panel, and writes it."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        controller: Controller,
        dialogs: ConventionDialogs,
        actions: Actions,
        panel: ConventionPanel,
    ) -> None:
        super().__init__(actions)
        self._document, self._runner, self._controller = document, runner, controller
        self._dialogs, self.panel = dialogs, panel
        panel.save_requested.connect(self._save)
        document.opened.connect(self._leave_project)
        self._had_project = document.project is not None

    def copy_state_from(self, former: "InstallationExport") -> None:
        """Copy the panel of a former window with the same project."""
        self.panel.copy_state_from(former.panel)

    def _leave_project(self) -> None:
        """Clear the settings of the other program if they were given for another project."""
        if self._had_project:
            self.panel.clear_current_settings()
        self._had_project = self._document.project is not None

    def _save(self) -> None:
        new, sigma_warning = self.panel.replacement, self.panel.inputs.sigma_warning
        if new is None:
            return
        project, convention = self._document.project, new.in_system.setup.convention
        stem = f"boresight-{convention.key}"
        start = home_folder() / stem
        trajectory = None
        if project is not None:
            start = project.folder / f"{project.name}-{stem}"
            if project.trajectory_reading.format in ("", "sbet"):
                trajectory = project.trajectory
        formats = installation_formats(convention, with_trajectory=trajectory is not None)
        chosen = self._dialogs.installation_file(start, formats)
        if chosen is None:
            return
        path, form = chosen

        def work(_progress: Progress) -> tuple[Message, ...]:
            return write_installation(
                path, new, form, trajectory=trajectory, sigma_warning=sigma_warning, project=project
            )

        def done(notes: tuple[Message, ...]) -> None:
            wrote = gettext("Wrote {path}", path=path)
            self._controller.logged.emit(wrote)
            self.panel.show_saved([wrote, *map(message_text, notes)])

        self._runner.run(gettext("Writing the file"), work, done, persistent=True)
