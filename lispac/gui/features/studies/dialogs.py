"""Dialogues that ask for a study and show its result."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QFileDialog

from lispac.alternative_methods import Method
from lispac.gui.app.actions import dialog_title
from lispac.gui.app.questions import Questions, run_dialog
from lispac.gui.features.studies.actions import ACTIONS
from lispac.language import gettext
from lispac.messages import Message
from lispac.project import Project

if TYPE_CHECKING:
    from lispac.gui.features.studies.check_dialog import CheckRequest
    from lispac.gui.features.studies.study_dialog import LineQualityDialog
    from lispac.method_comparison import MethodResult
    from lispac.present.calibration.error_budget import ErrorBudgetValues
    from lispac.present.calibration.subsampling import SubsamplingValues
    from lispac.present.checking.absolute import AbsoluteCheckValues
    from lispac.simulation.visibility_study import VisibilityStudy
    from lispac.survey.trajectory import LocalTrajectory
    from lispac.workflow.checking.calibration_history import CalibrationHistory
    from lispac.workflow.checking.line_quality import LineQuality


class StudyDialogs(Questions):
    """Dialogues that ask for a study and show its result."""

    def folder_of_projects(self, start: Path) -> Path | None:
        """Ask for a folder that contains projects."""
        name = QFileDialog.getExistingDirectory(
            self.parent, gettext("Folder that contains the calibration projects"), str(start)
        )
        return Path(name) if name else None

    def correspondence_file(self, start: Path) -> Path | None:
        """Ask for a file of point correspondences."""
        name, _ = QFileDialog.getOpenFileName(
            self.parent, dialog_title(ACTIONS["correspondences"]), str(start),
            gettext("Text files (*.txt *.csv *.dat);;All files (*)"),
        )  # fmt: skip
        return Path(name) if name else None

    def check(self, project: Project, trajectory: "LocalTrajectory") -> "CheckRequest | None":
        """Ask for the reference of a check of the lines; None if cancelled."""
        from lispac.gui.features.studies.check_dialog import CheckDialog

        dialog = CheckDialog(project, trajectory, self.parent)
        return dialog.request if run_dialog(dialog) else None

    def show_check_result(self, values: "AbsoluteCheckValues") -> None:
        """Show the result of a check: distances of the lines from the reference."""
        from lispac.gui.features.studies.check_dialog import CheckResultDialog

        run_dialog(CheckResultDialog(values, self.parent))

    def budget(self, budget: "ErrorBudgetValues") -> None:
        """Show the error budget."""
        from lispac.gui.features.studies.study_dialog import BudgetDialog

        run_dialog(BudgetDialog(budget, self.parent))

    def history(
        self, histories: "Sequence[CalibrationHistory]", messages: Sequence[Message]
    ) -> None:
        """Show the calibrations of each system."""
        from lispac.gui.features.studies.study_dialog import HistoryDialog

        run_dialog(HistoryDialog(histories, messages, self.parent))

    def subsampling(self, results: "Sequence[SubsamplingValues]", used: float) -> None:
        """Show the results at several point spacings; ``used`` is the spacing of the project."""
        from lispac.gui.features.studies.study_dialog import SubsamplingDialog

        run_dialog(SubsamplingDialog(results, used, self.parent))

    def line_quality(self, quality: "LineQuality") -> "LineQualityDialog":
        """Show the differences between the lines beside the usable window."""
        from lispac.gui.features.studies.study_dialog import LineQualityDialog

        dialog = LineQualityDialog(quality, self.parent)
        dialog.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        dialog.show()
        return dialog

    def methods(
        self,
        results: "Sequence[MethodResult]",
        absent: Sequence[Method],
        refused: Mapping[str, Message],
    ) -> bool:
        """Show the results of all methods; return whether to run the missing ones."""
        from lispac.gui.features.studies.methods_dialog import MethodsDialog

        dialog = MethodsDialog(results, absent, refused, self.parent)
        run_dialog(dialog)
        return dialog.runs_missing

    def visibility(self, studies: "Sequence[VisibilityStudy]") -> None:
        """Show the visibility of errors on each site."""
        from lispac.gui.features.studies.visibility_dialog import VisibilityDialog

        run_dialog(VisibilityDialog(studies, self.parent))
