"""All dialogues of the window behind one object, which tests replace."""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from PySide6.QtWidgets import QApplication, QDialog, QFileDialog

from lispac.alternative_methods import Method
from lispac.gui.app.actions import dialog_title
from lispac.gui.app.questions import Questions
from lispac.gui.app.settings import AppSettings
from lispac.gui.features.design.sensors_dialog import PlanSensorsDialog, Sensors
from lispac.gui.features.export.export_dialog import ExportDialog
from lispac.gui.features.export.script_dialog import ScriptDialog
from lispac.gui.features.help.about import about_box, shortcuts_box
from lispac.gui.features.import_survey.add_lines_dialog import AddLinesDialog
from lispac.gui.features.import_survey.import_dialog import ImportDialog
from lispac.gui.features.pick_targets.find_again_dialog import FindAgainDialog
from lispac.gui.features.pick_targets.proposal_dialog import ProposedTargetsDialog
from lispac.gui.features.pick_targets.seed_at import SeedDialog
from lispac.gui.features.pick_targets.seed_list import SeedListDialog, SeedsFoundDialog
from lispac.gui.features.preferences.preferences import Preferences
from lispac.gui.features.preferences.settings_dialog import SettingsDialog
from lispac.gui.features.report.identity_dialog import IdentityDialog
from lispac.gui.features.report.preview_dialog import PreviewDialog
from lispac.gui.features.studies.budget_dialog import BudgetDialog
from lispac.gui.features.studies.check_dialog import CheckDialog, CheckRequest, CheckResultDialog
from lispac.gui.features.studies.history_dialog import HistoryDialog
from lispac.gui.features.studies.line_quality_dialog import LineQualityDialog
from lispac.gui.features.studies.methods_dialog import MethodsDialog
from lispac.gui.features.studies.subsampling_dialog import SubsamplingDialog
from lispac.gui.features.studies.visibility_dialog import VisibilityDialog
from lispac.gui.project.seed_options import SeedOptions
from lispac.identity import Identity
from lispac.language import N_, gettext
from lispac.messages import Message
from lispac.method_comparison import MethodResult
from lispac.project import LineSource, Project, Target, Triple
from lispac.report.absolute_values import AbsoluteCheckValues
from lispac.report.budget_values import ErrorBudgetValues
from lispac.simulation.visibility_study import VisibilityStudy
from lispac.survey.trajectory import LocalTrajectory
from lispac.targets.finder_settings import FinderChoices
from lispac.workflow.calibration.proposals import Proposal
from lispac.workflow.calibration.seed_lists import ListedSeed, SeedOutcome
from lispac.workflow.checking.calibration_history import CalibrationHistory
from lispac.workflow.checking.line_quality import LineQuality
from lispac.workflow.checking.subsampling import SubsamplingResult
from lispac.workflow.importing.input_files import ImportRequest
from lispac.workflow.output.export_request import ExportRequest, What
from lispac.workflow.output.georeferencing import Which

if TYPE_CHECKING:
    from lispac.workflow.output.script import Script

DesignFile = Literal["open", "save", "page", "site"]
DESIGN_FILES: dict[DesignFile, tuple[str, str, bool]] = {
    "open": (N_("Open survey plan"), N_("Survey plan (*.toml)"), False),
    "save": (N_("Save survey plan"), N_("Survey plan (*.toml)"), True),
    "page": (N_("Save field plan"), "PDF (*.pdf)", True),
    "site": (N_("Open site file"), N_("Site file (*.toml)"), False),
}
"""Title and filter of the file dialogue, and whether the file is written."""
REPORT_FILTERS = (
    "PDF (*.pdf)", "HTML (*.html)", N_("Results as JSON (*.json)"),
    N_("Tables as CSV in a ZIP file (*.zip)"),
)  # fmt: skip


class Dialogs(Questions):
    """Shows the dialogues and returns the answers of the user."""

    def new_project(
        self, settings: AppSettings, paths: Sequence[Path] = ()
    ) -> ImportRequest | Path | None:
        """The import of a new project, or an existing project that was dropped instead.

        Parameters
        ----------
        paths : sequence of Path
            Files and folders to start with.
        """
        dialog = ImportDialog(settings, self.parent)
        dialog.add(paths)
        accepted = dialog.exec() == QDialog.DialogCode.Accepted
        result = dialog.request() if accepted else dialog.project
        dialog.deleteLater()
        return result

    def add_lines(
        self, settings: AppSettings, project: Project, paths: Sequence[Path] = ()
    ) -> tuple[LineSource, ...] | Path | None:
        """Lines to add to the open project, or the project that was dropped instead.

        Parameters
        ----------
        paths : sequence of Path
            Files and folders to start with.
        """
        dialog = AddLinesDialog(settings, project, self.parent)
        dialog.add(paths)
        accepted = dialog.exec() == QDialog.DialogCode.Accepted
        result = dialog.sources() if accepted else dialog.project
        dialog.deleteLater()
        return result

    def project_to_open(self, start: Path) -> Path | None:
        """File of a project to open."""
        name, _ = QFileDialog.getOpenFileName(
            self.parent,
            dialog_title("open"),
            str(start),
            gettext("LISPAC project (project.json *.lispac)"),
        )
        return Path(name) if name else None

    def folder_to_save_in(self, start: Path) -> Path | None:
        """Ask for a new folder for the project; ``start`` is proposed."""
        name, _ = QFileDialog.getSaveFileName(
            self.parent,
            gettext("{title} (name of the new folder)", title=dialog_title("save_as")),
            str(start),
            gettext("Folder (*)"),
            # Nothing is overwritten: existing projects and files are refused
            options=QFileDialog.Option.DontConfirmOverwrite,
        )
        return Path(name) if name else None

    def folder_of_projects(self, start: Path) -> Path | None:
        """A folder that contains projects."""
        name = QFileDialog.getExistingDirectory(
            self.parent, gettext("Folder that contains the calibration projects"), str(start)
        )
        return Path(name) if name else None

    def check(self, project: Project, trajectory: LocalTrajectory) -> CheckRequest | None:
        """Ask for the reference of a check of the lines; None if cancelled."""
        dialog = CheckDialog(project, trajectory, self.parent)
        result = dialog.request if dialog.exec() == QDialog.DialogCode.Accepted else None
        dialog.deleteLater()
        return result

    def show_check_result(self, values: AbsoluteCheckValues) -> None:
        """Show the result of a check: distances of the lines from the reference."""
        dialog = CheckResultDialog(values, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def budget(self, budget: ErrorBudgetValues) -> None:
        """Show the error budget."""
        dialog = BudgetDialog(budget, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def history(self, histories: Sequence[CalibrationHistory], messages: Sequence[Message]) -> None:
        """Show the calibrations of each system."""
        dialog = HistoryDialog(histories, messages, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def subsampling(self, results: Sequence[SubsamplingResult], used: float) -> None:
        """Show the results at several point spacings; ``used`` is that of the project."""
        dialog = SubsamplingDialog(results, used, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def line_quality(self, quality: LineQuality) -> None:
        """Show the differences between the lines."""
        dialog = LineQualityDialog(quality, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def methods(
        self,
        results: Sequence[MethodResult],
        absent: Sequence[Method],
        refused: Mapping[str, Message],
    ) -> bool:
        """Show the results of all methods; return whether to run the missing ones."""
        dialog = MethodsDialog(results, absent, refused, self.parent)
        dialog.exec()
        dialog.deleteLater()
        return dialog.runs_missing

    def visibility(self, studies: Sequence[VisibilityStudy]) -> None:
        """Show the visibility of errors on each site."""
        dialog = VisibilityDialog(studies, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def design_file(self, what: DesignFile, start: Path) -> Path | None:
        """A file of a plan, a site or a field plan, to read or to write."""
        title, filter_, writes = DESIGN_FILES[what]
        get_file_name = QFileDialog.getSaveFileName if writes else QFileDialog.getOpenFileName
        name, _ = get_file_name(self.parent, gettext(title), str(start), gettext(filter_))
        if not name:
            return None
        path = Path(name)
        ending = start.suffix if writes else ""
        return path if path.suffix or not ending else path.with_name(path.name + ending)

    def report_file(self, start: Path) -> Path | None:
        """File for the report; its suffix, or the chosen filter, sets the format."""
        filters = ";;".join(map(gettext, REPORT_FILTERS))
        name, kind = QFileDialog.getSaveFileName(
            self.parent, dialog_title("report"), str(start), filters
        )
        if not name:
            return None
        path = Path(name)
        ending = kind.rpartition("*")[2].rstrip(")")  # of "PDF (*.pdf)", in any language
        return path if path.suffix else path.with_suffix(ending)

    def pdf_file(self, start: Path) -> Path | None:
        """PDF file for the report of the preview."""
        name, _ = QFileDialog.getSaveFileName(
            self.parent, gettext("Save the report as PDF"), str(start), "PDF (*.pdf)"
        )
        path = Path(name)
        return (
            path.with_name(f"{path.name}.pdf" if not path.suffix else path.name) if name else None
        )

    def preview(self, pages: Sequence[bytes], save: Callable[[], str]) -> None:
        """Show the pages of the report; ``save`` saves them and returns a text about it."""
        dialog = PreviewDialog(pages, save, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def script_file(self, start: Path) -> Path | None:
        """File for the script of the project."""
        name, _ = QFileDialog.getSaveFileName(
            self.parent, gettext("Save the script"), str(start), "Python (*.py)"
        )
        return Path(name if Path(name).suffix else f"{name}.py") if name else None

    def script(self, script: "Script", save: Callable[[], str]) -> None:
        """Show the script of the project; ``save`` saves it and returns a text about it."""
        dialog = ScriptDialog(script, save, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def report_template(self, start: Path) -> Path | None:
        """Template of the reports of a company."""
        name, _ = QFileDialog.getOpenFileName(
            self.parent, gettext("Open report template"), str(start),
            gettext("Report template (*.toml)"),
        )  # fmt: skip
        return Path(name) if name else None

    def picture_file(self, start: Path, kinds: Sequence[str]) -> Path | None:
        """File for a picture; its suffix, or the chosen filter, sets the format."""
        filters = ";;".join(f"{kind} (*.{kind.lower()})" for kind in kinds)
        name, chosen = QFileDialog.getSaveFileName(
            self.parent, dialog_title("picture"), str(start), filters
        )
        if not name:
            return None
        path, ending = Path(name), f".{chosen.split(' ')[0].lower()}"
        known = path.suffix.lower() in {f".{kind.lower()}" for kind in kinds}
        return path if known else path.with_name(path.name + ending)

    def export(
        self, what: What, which: Which, project: Project, trajectory: LocalTrajectory
    ) -> ExportRequest | None:
        """Ask for the options of an export; None if cancelled."""
        dialog = ExportDialog(what, which, project, trajectory, self.parent)
        result = dialog.request() if dialog.exec() == QDialog.DialogCode.Accepted else None
        dialog.deleteLater()
        return result

    def identity(self, identity: Identity, dates: Callable[[], str]) -> Identity | None:
        """Ask for the details of the report; ``dates`` returns the days of the lines."""
        dialog = IdentityDialog(identity, dates, self.parent)
        result = dialog.identity if dialog.exec() == QDialog.DialogCode.Accepted else None
        dialog.deleteLater()
        return result

    def preferences(self, present: Preferences, settings: AppSettings) -> Preferences | None:
        """Preferences for all projects; the dialogue also edits the sensor library."""
        dialog = SettingsDialog(present, settings.sensors, self.parent)
        result = dialog.preferences if dialog.exec() == QDialog.DialogCode.Accepted else None
        dialog.deleteLater()
        return result

    def sensors_of_plan(self, settings: AppSettings) -> Sensors | None:
        """Sensors of the library for a plan; None where the dialogue is cancelled."""
        dialog = PlanSensorsDialog(settings.sensors, QApplication.activeWindow() or self.parent)
        result = dialog.sensors if dialog.exec() == QDialog.DialogCode.Accepted else None
        dialog.deleteLater()
        return result

    def proposal(self, proposal: Proposal) -> tuple[str, ...]:
        """Names of the accepted targets of a proposal."""
        dialog = ProposedTargetsDialog(proposal, self.parent)
        result = dialog.ticked_entries if dialog.exec() == QDialog.DialogCode.Accepted else ()
        dialog.deleteLater()
        return result

    def find_again(self, target: Target) -> tuple[float, float, FinderChoices] | None:
        """Threshold and search radius (metres) and other settings to find a target again."""
        dialog = FindAgainDialog(target, self.parent)
        result = dialog.settings if dialog.exec() == QDialog.DialogCode.Accepted else None
        dialog.deleteLater()
        return result

    def seed_at(
        self, project: Project, trajectory: LocalTrajectory, seed_options: SeedOptions, name: str
    ) -> tuple[str, Triple] | None:
        """Name and place of a typed seed; ``name`` is proposed."""
        dialog = SeedDialog(project, trajectory, seed_options, name, self.parent)
        result = dialog.seed if dialog.exec() == QDialog.DialogCode.Accepted else None
        dialog.deleteLater()
        return result

    def seed_list_file(self, start: Path) -> Path | None:
        """A list of target coordinates."""
        name, _ = QFileDialog.getOpenFileName(
            self.parent, dialog_title("seed_list"), str(start),
            ";;".join(
                [
                    gettext(
                        "Lists of coordinates ({patterns})",
                        patterns="*.txt *.csv *.asc *.xyz *.pts *.dat",
                    ),
                    gettext("All files (*)"),
                ]
            ),
        )  # fmt: skip
        return Path(name) if name else None

    def seed_list(
        self, path: Path, project: Project, trajectory: LocalTrajectory, how: str
    ) -> tuple[ListedSeed, ...]:
        """Seeds of a list to pick; ``how`` describes the search."""
        dialog = SeedListDialog(path, project, trajectory, how, self.parent)
        result = dialog.ticked_entries if dialog.exec() == QDialog.DialogCode.Accepted else ()
        dialog.deleteLater()
        return result

    def seeds_found(self, outcomes: Sequence[SeedOutcome], lines: int) -> None:
        """Show which seeds of a list led to a target."""
        dialog = SeedsFoundDialog(outcomes, lines, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def about(self) -> None:
        """Show version, conventions and licence of the program."""
        box = about_box(self.parent)
        box.exec()
        box.deleteLater()

    def shortcuts(self) -> None:
        """Show the mouse and keyboard commands."""
        box = shortcuts_box(self.parent)
        box.exec()
        box.deleteLater()
