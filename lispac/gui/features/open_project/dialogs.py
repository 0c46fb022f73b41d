"""Dialogues that open, create and copy projects."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QFileDialog

from lispac.gui.app.actions import dialog_title
from lispac.gui.app.questions import Questions, run_dialog
from lispac.gui.app.settings import AppSettings
from lispac.gui.features.open_project.actions import ACTIONS
from lispac.language import gettext
from lispac.project import LineSource, Project

if TYPE_CHECKING:
    from lispac.workflow.importing.input_files import ImportRequest
    from lispac.workflow.project.attitude_signs import SignedAngle
    from lispac.workflow.project.survey import Survey


class ProjectDialogs(Questions):
    """Dialogues that open, create and copy projects."""

    def new_project(
        self, settings: AppSettings, paths: Sequence[Path] = ()
    ) -> "ImportRequest | Path | None":
        """Ask for the import of a new project; return it, or an existing project that was dropped.

        Parameters
        ----------
        paths : sequence of Path
            Files and folders that are added initially.
        """
        from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog

        dialog = ImportDialog(settings, self.parent)
        dialog.add(paths)
        if not run_dialog(dialog):
            return dialog.project
        settings.keep_sensors(dialog.mounting.sensors.names)
        return dialog.request()

    def add_lines(
        self, settings: AppSettings, project: Project, paths: Sequence[Path] = ()
    ) -> tuple[LineSource, ...] | Path | None:
        """Ask for lines to add to the open project; return them, or a project that was dropped.

        Parameters
        ----------
        paths : sequence of Path
            Files and folders that are added initially.
        """
        from lispac.gui.features.open_project.import_survey.import_dialog import AddLinesDialog

        dialog = AddLinesDialog(settings, project, self.parent)
        dialog.add(paths)
        return dialog.sources() if run_dialog(dialog) else dialog.project

    def check_signs(
        self, survey: "Survey", reversible: "tuple[SignedAngle, ...]"
    ) -> "tuple[SignedAngle, ...]":
        """Show the attitude of a survey and the signs it must have; return the reversed angles.

        Parameters
        ----------
        reversible : angles whose signs can be changed in the project
        """
        from lispac.gui.features.open_project.import_survey.quality_figures import AttitudeRecord
        from lispac.gui.features.open_project.import_survey.sign_check_dialog import SignCheckDialog

        record = AttitudeRecord.of_survey(survey)
        dialog = SignCheckDialog(record, "project", self.parent, reversible)
        return dialog.reversed_angles if run_dialog(dialog) else ()

    def project_to_open(self, start: Path) -> Path | None:
        """Ask for the file of a project to open."""
        name, _ = QFileDialog.getOpenFileName(
            self.parent,
            dialog_title(ACTIONS["open"]),
            str(start),
            gettext("LISPAC project (project.json *.lispac)"),
        )
        return Path(name) if name else None

    def folder_to_save_in(self, start: Path) -> Path | None:
        """Ask for a new folder for the project; ``start`` is proposed."""
        name, _ = QFileDialog.getSaveFileName(
            self.parent,
            gettext("{title} (name of the new folder)", title=dialog_title(ACTIONS["save_as"])),
            str(start),
            gettext("Folder (*)"),
            # Nothing is overwritten: existing projects and files are refused
            options=QFileDialog.Option.DontConfirmOverwrite,
        )
        return Path(name) if name else None
