"""Every question the window asks in a dialogue, in one place.

The window gets such an object; a test gives it one that answers by itself.
"""

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from PySide6.QtWidgets import QApplication, QDialog, QFileDialog

from lispac.gui.dialogs.about import about_box, shortcuts_box
from lispac.gui.dialogs.budget import BudgetDialog
from lispac.gui.dialogs.check import CheckDialog, CheckedDialog, CheckRequest
from lispac.gui.dialogs.export import ExportDialog
from lispac.gui.dialogs.find_again import FindAgainDialog
from lispac.gui.dialogs.history import HistoryDialog
from lispac.gui.dialogs.identity import IdentityDialog
from lispac.gui.dialogs.import_files.add_lines import AddLinesDialog
from lispac.gui.dialogs.import_files.dialog import ImportDialog
from lispac.gui.dialogs.line_quality import LineQualityDialog
from lispac.gui.dialogs.methods import MethodsDialog
from lispac.gui.dialogs.preview import PreviewDialog
from lispac.gui.dialogs.proposal import ProposalDialog
from lispac.gui.dialogs.questions import Questions
from lispac.gui.dialogs.script import ScriptDialog
from lispac.gui.dialogs.seed_at import SeedDialog
from lispac.gui.dialogs.seed_list import SeedListDialog, SeedsFoundDialog
from lispac.gui.dialogs.sensors_of_plan import Sensors, SensorsDialog
from lispac.gui.dialogs.settings import SettingsDialog
from lispac.gui.dialogs.subsampling import SubsamplingDialog
from lispac.gui.dialogs.visibility import VisibilityDialog
from lispac.gui.language import say
from lispac.gui.preferences import Preferences
from lispac.gui.settings import AppSettings
from lispac.gui.wishes import Wishes
from lispac.identity import Identity
from lispac.methods import Answer
from lispac.opinions import Method
from lispac.project import LineSource, Project, Target, Triple
from lispac.report.absolute_values import Absolute
from lispac.report.budget_values import Budget
from lispac.simulation.visibility_study import Visibility
from lispac.survey.trajectory import LocalTrajectory
from lispac.targets.settings import FinderChoices
from lispac.workflow.export_request import ExportRequest, What
from lispac.workflow.georeferencing import Which
from lispac.workflow.history import History
from lispac.workflow.intake import ImportRequest
from lispac.workflow.line_quality import LineQuality
from lispac.workflow.proposing import Proposal
from lispac.workflow.seed_lists import ListedSeed, Outcome
from lispac.workflow.subsampling import Subsampled

if TYPE_CHECKING:
    from lispac.workflow.script import Script

DesignFile = Literal["open", "save", "page", "site"]
DESIGN_FILES: dict[DesignFile, tuple[str, str, bool]] = {
    "open": ("Open plan", "Plan (*.toml)", False),
    "save": ("Save plan", "Plan (*.toml)", True),
    "page": ("Write the field plan", "PDF (*.pdf)", True),
    "site": ("Open site", "Site (*.toml)", False),
}

REPORT_FILTER = (
    "PDF (*.pdf);;HTML (*.html);;Numbers as JSON (*.json);;Tables as CSV in a ZIP file (*.zip)"
)


class Dialogs(Questions):
    """Asks the user."""

    def new_project(
        self, settings: AppSettings, paths: Sequence[Path] = ()
    ) -> ImportRequest | Path | None:
        """What a new project is to hold, or the project that was dropped instead.

        Parameters
        ----------
        paths : sequence of Path
            Files and folders to begin with.
        """
        dialog = ImportDialog(settings, self.parent)
        dialog.add(paths)
        accepted = dialog.exec() == QDialog.DialogCode.Accepted
        answer = dialog.request() if accepted else dialog.project
        dialog.deleteLater()
        return answer

    def add_lines(
        self, settings: AppSettings, project: Project, paths: Sequence[Path] = ()
    ) -> tuple[LineSource, ...] | Path | None:
        """Lines to add to the open project, or the project that was dropped instead.

        Parameters
        ----------
        paths : sequence of Path
            Files and folders to begin with.
        """
        dialog = AddLinesDialog(settings, project, self.parent)
        dialog.add(paths)
        accepted = dialog.exec() == QDialog.DialogCode.Accepted
        answer = dialog.sources() if accepted else dialog.project
        dialog.deleteLater()
        return answer

    def project_to_open(self, start: Path) -> Path | None:
        """A project's folder."""
        name, _ = QFileDialog.getOpenFileName(
            self.parent,
            say("Open project"),
            str(start),
            say("LISPAC project (project.json *.lispac)"),
        )
        return Path(name) if name else None

    def folder_to_save_in(self, start: Path) -> Path | None:
        """A new folder for the project; ``start`` is proposed."""
        name, _ = QFileDialog.getSaveFileName(
            self.parent,
            say("Save project as: name of its new folder"),
            str(start),
            say("Folder (*)"),
            # Nothing is replaced: a folder with a project is refused, and so is a file
            options=QFileDialog.Option.DontConfirmOverwrite,
        )
        return Path(name) if name else None

    def folder_of_projects(self, start: Path) -> Path | None:
        """A folder that holds projects."""
        name = QFileDialog.getExistingDirectory(
            self.parent, say("Folder with the projects of all calibrations"), str(start)
        )
        return Path(name) if name else None

    def check(self, project: Project, trajectory: LocalTrajectory) -> CheckRequest | None:
        """Against which reference the lines are to be checked."""
        dialog = CheckDialog(project, trajectory, self.parent)
        answer = dialog.request if dialog.exec() == QDialog.DialogCode.Accepted else None
        dialog.deleteLater()
        return answer

    def checked(self, found: Absolute) -> None:
        """Show how far the lines are from the reference."""
        dialog = CheckedDialog(found, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def budget(self, budget: Budget) -> None:
        """Show what each source of error does."""
        dialog = BudgetDialog(budget, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def history(self, histories: Sequence[History], remarks: Sequence[str]) -> None:
        """Show the calibrations of each system."""
        dialog = HistoryDialog(histories, remarks, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def subsampling(self, found: Sequence[Subsampled], used: float) -> None:
        """Show the answers with other distances between the points; ``used`` is the project's."""
        dialog = SubsamplingDialog(found, used, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def line_quality(self, found: LineQuality) -> None:
        """Show how far the lines are apart."""
        dialog = LineQualityDialog(found, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def methods(
        self, found: Sequence[Answer], absent: Sequence[Method], refused: Mapping[str, str]
    ) -> bool:
        """Show the answers of all methods; whether those that are missing are to be asked."""
        dialog = MethodsDialog(found, absent, refused, self.parent)
        dialog.exec()
        dialog.deleteLater()
        return dialog.asks

    def visibility(self, found: Sequence[Visibility]) -> None:
        """Show which boards and lines show which error, on each site."""
        dialog = VisibilityDialog(found, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def design_file(self, what: DesignFile, start: Path) -> Path | None:
        """A file of a plan, a site or a field plan, to read or to write."""
        title, kind, writes = DESIGN_FILES[what]
        ask = QFileDialog.getSaveFileName if writes else QFileDialog.getOpenFileName
        name, _ = ask(self.parent, say(title), str(start), say(kind))
        if not name:
            return None
        path = Path(name)
        ending = start.suffix if writes else ""
        return path if path.suffix or not ending else path.with_name(path.name + ending)

    def report_file(self, start: Path) -> Path | None:
        """Where the report goes; the ending chooses its kind."""
        name, kind = QFileDialog.getSaveFileName(
            self.parent, say("Export report"), str(start), say(REPORT_FILTER)
        )
        if not name:
            return None
        path = Path(name)
        ending = kind.rpartition("*")[2].rstrip(")")  # "PDF (*.pdf)", whatever the language
        return path if path.suffix else path.with_suffix(ending)

    def pdf_file(self, start: Path) -> Path | None:
        """Where the report that was looked at goes."""
        name, _ = QFileDialog.getSaveFileName(
            self.parent, say("Save the report as PDF"), str(start), say("PDF (*.pdf)")
        )
        path = Path(name)
        return (
            path.with_name(f"{path.name}.pdf" if not path.suffix else path.name) if name else None
        )

    def preview(self, pages: Sequence[bytes], save: Callable[[], str]) -> None:
        """Show the pages of the report; ``save`` keeps them and says where."""
        dialog = PreviewDialog(pages, save, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def script_file(self, start: Path) -> Path | None:
        """Where the project's script goes."""
        name, _ = QFileDialog.getSaveFileName(
            self.parent, say("Save the script"), str(start), say("Python (*.py)")
        )
        return Path(name if Path(name).suffix else f"{name}.py") if name else None

    def script(self, script: "Script", save: Callable[[], str]) -> None:
        """Show the project's script; ``save`` keeps it and says where."""
        dialog = ScriptDialog(script, save, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def report_template(self, start: Path) -> Path | None:
        """The template of a company's reports."""
        name, _ = QFileDialog.getOpenFileName(
            self.parent, say("Template of the report"), str(start), say("Report template (*.toml)")
        )
        return Path(name) if name else None

    def picture_file(self, start: Path, kinds: Sequence[str]) -> Path | None:
        """Where a picture goes; the ending chooses its kind, else the filter does."""
        filters = ";;".join(f"{kind} (*.{kind.lower()})" for kind in kinds)
        name, chosen = QFileDialog.getSaveFileName(
            self.parent, say("Save the picture"), str(start), filters
        )
        if not name:
            return None
        path, ending = Path(name), f".{chosen.split(' ')[0].lower()}"
        known = path.suffix.lower() in {f".{kind.lower()}" for kind in kinds}
        return path if known else path.with_name(path.name + ending)

    def export(
        self, what: What, which: Which, project: Project, trajectory: LocalTrajectory
    ) -> ExportRequest | None:
        """What to export besides the report, and where."""
        dialog = ExportDialog(what, which, project, trajectory, self.parent)
        answer = dialog.request() if dialog.exec() == QDialog.DialogCode.Accepted else None
        dialog.deleteLater()
        return answer

    def identity(self, identity: Identity, dates: Callable[[], str]) -> Identity | None:
        """Who, when and with what, for the report; ``dates`` are those the lines tell."""
        dialog = IdentityDialog(identity, dates, self.parent)
        answer = dialog.identity if dialog.exec() == QDialog.DialogCode.Accepted else None
        dialog.deleteLater()
        return answer

    def preferences(self, present: Preferences, settings: AppSettings) -> Preferences | None:
        """What the user prefers for all projects; the sensor library is edited beside it."""
        dialog = SettingsDialog(present, settings.sensors, self.parent)
        answer = dialog.preferences if dialog.exec() == QDialog.DialogCode.Accepted else None
        dialog.deleteLater()
        return answer

    def sensors_of_plan(self, settings: AppSettings) -> Sensors | None:
        """Sensors of the library for a plan; None where it stays as it is."""
        dialog = SensorsDialog(settings.sensors, QApplication.activeWindow() or self.parent)
        answer = dialog.sensors if dialog.exec() == QDialog.DialogCode.Accepted else None
        dialog.deleteLater()
        return answer

    def proposal(self, proposal: Proposal) -> tuple[str, ...]:
        """Names of the proposed targets that are wanted."""
        dialog = ProposalDialog(proposal, self.parent)
        answer = dialog.ticked if dialog.exec() == QDialog.DialogCode.Accepted else ()
        dialog.deleteLater()
        return answer

    def find_again(self, target: Target) -> tuple[float, float, FinderChoices] | None:
        """Threshold and search radius (metres) and the rest, to find a target again with."""
        dialog = FindAgainDialog(target, self.parent)
        answer = dialog.settings if dialog.exec() == QDialog.DialogCode.Accepted else None
        dialog.deleteLater()
        return answer

    def seed_at(
        self, project: Project, trajectory: LocalTrajectory, wishes: Wishes, name: str
    ) -> tuple[str, Triple] | None:
        """Name and place of a seed that is typed; ``name`` is proposed."""
        dialog = SeedDialog(project, trajectory, wishes, name, self.parent)
        answer = dialog.seed if dialog.exec() == QDialog.DialogCode.Accepted else None
        dialog.deleteLater()
        return answer

    def seed_list_file(self, start: Path) -> Path | None:
        """A list of target coordinates."""
        name, _ = QFileDialog.getOpenFileName(
            self.parent, say("Seeds from a file"), str(start),
            say("Lists of coordinates (*.txt *.csv *.asc *.xyz *.pts *.dat);;All files (*)"),
        )  # fmt: skip
        return Path(name) if name else None

    def seed_list(
        self, path: Path, project: Project, trajectory: LocalTrajectory, how: str
    ) -> tuple[ListedSeed, ...]:
        """Seeds of a list that are to be picked; ``how`` says how they are sought."""
        dialog = SeedListDialog(path, project, trajectory, how, self.parent)
        answer = dialog.ticked if dialog.exec() == QDialog.DialogCode.Accepted else ()
        dialog.deleteLater()
        return answer

    def seeds_found(self, outcomes: Sequence[Outcome], lines: int) -> None:
        """Say what came of the seeds of a list."""
        dialog = SeedsFoundDialog(outcomes, lines, self.parent)
        dialog.exec()
        dialog.deleteLater()

    def about(self) -> None:
        """Say what the program is."""
        box = about_box(self.parent)
        box.exec()
        box.deleteLater()

    def shortcuts(self) -> None:
        """Say what mouse and keys do."""
        box = shortcuts_box(self.parent)
        box.exec()
        box.deleteLater()
