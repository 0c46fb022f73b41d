"""The report: its details, preview and export."""

import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import astuple
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from lispac.errors import InputError
from lispac.gui.app.actions import Actions
from lispac.gui.app.settings import AppSettings
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.features.report.dialogs import ReportDialogs
from lispac.gui.features.report.identity_dialog import SURVEY_FIELDS
from lispac.gui.features.report.report_panel import ReportPanel
from lispac.gui.features.report.report_pictures import Pictures, ReportPictures
from lispac.gui.project.computations import Computations
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document, ExportedReport
from lispac.gui.project.scene import Scene
from lispac.gui.viewport.base import Viewport
from lispac.identity import COMPANY_FIELDS
from lispac.installation_paths import home_folder
from lispac.language import N_, LazyText, gettext
from lispac.messages import error
from lispac.progress import Progress, sub_progress
from lispac.project import Project
from lispac.report.options import Extent, ReportOptions
from lispac.workflow.calibration.sighting_assessment import (
    AssessedQuality,
    SightingKey,
    assess_sightings,
)
from lispac.workflow.planning.sensors import read_library
from lispac.workflow.project.output_crs import trajectory_datum_of
from lispac.workflow.project.survey import Survey
from lispac.workflow.project.survey_dates import survey_dates

if TYPE_CHECKING:
    from lispac.report.pdf import Preview

PIXELS_PER_INCH = 96.0
"""Resolution of the previewed pages on a screen without scaling."""


class ReportExport(QObject):
    """Asks for the details and options of the report, previews it and writes it."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        scene: Scene,
        viewport: Viewport,
        controller: Controller,
        computations: Computations,
        dialogs: ReportDialogs,
        settings: AppSettings,
        actions: Actions,
        panel: ReportPanel,
    ) -> None:
        super().__init__(actions)
        self._document, self._dialogs = document, dialogs
        self._runner, self._controller = runner, controller
        self._pictures = ReportPictures(document, runner, controller, scene, viewport, self)
        self._computations = computations
        self._panel, self._settings = panel, settings
        self.show_choice()
        panel.report_requested.connect(actions["report"].trigger)
        panel.preview_requested.connect(actions.guarded(self.preview))
        panel.template_requested.connect(self.ask_template)
        panel.details_requested.connect(self.ask_missing)
        panel.open_requested.connect(actions.guarded(self._open_exported))
        panel.opens.setChecked(settings.opens_report)
        panel.changed.connect(self._store_choice)
        actions.connect_slots({"report": self.export})
        document.opened.connect(self._restore_report)
        document.saved.connect(self._store_report)

    def show_choice(self) -> None:
        """Show the stored options in the panel."""
        self._panel.show_choice(self._settings.report_choice())
        self._document.set_report_options(self._chosen_options)

    @property
    def _chosen_options(self) -> tuple[object, ...]:
        return astuple(self._panel.choice)

    def ask_missing(self) -> None:
        """Ask for the details for the report, first for the missing ones."""
        if (project := self._document.project) is not None:
            self.ask_details(project.identity.missing)

    def ask_details(self, missing: Sequence[str] = (), *, continues: bool = False) -> bool:
        """Ask for the details for the report, and store them as one undo step.

        Parameters
        ----------
        missing : names of empty fields that are to be filled in
        continues : whether an export follows

        Returns
        -------
        bool
            Whether the user accepted the dialogue.
        """
        project, survey = self._document.project, self._survey
        if project is None:
            return False
        identity = self._dialogs.identity(
            project.identity,
            None if survey is None else lambda: survey_dates(project, survey),
            self._settings.companies(),
            _reference_frame(project),
            missing,
            self._equipment(),
            continues,
        )
        if identity is not None and identity.company:
            names = (*COMPANY_FIELDS, *SURVEY_FIELDS)
            given = {name: getattr(identity, name) for name in names}
            known = self._settings.companies().get(identity.company, {})
            details = {**known, **{name: text for name, text in given.items() if text}}
            self._settings.save_company(identity.company, details)
        current = self._document.project  # a task may have changed it meanwhile
        if identity is not None and current is not None and identity != current.identity:
            self._document.edit(N_("change of report details"), current.with_identity(identity))
        return identity is not None

    def _equipment(self) -> dict[str, list[str]]:
        """Names of the sensors of the library, by field of the details."""
        library = read_library(self._settings.sensors)
        return {
            "scanner": [each.figures.title for each in library.scanners],
            "pos": [each.figures.title for each in library.pos],
        }

    def ask_template(self) -> None:
        """Ask for the template of the report."""
        last = self._settings.report_choice().template
        path = self._dialogs.report_template(Path(last).parent if last else home_folder())
        if path is not None:
            self._panel.show_template(path)
            self._store_choice()

    def export(self) -> None:
        """Ask for a file and write the report with pictures of the view."""
        if not self._ask_missing_once() or (found := self._input()) is None:
            return
        project, survey, options = found
        path = self._dialogs.report_file(self._proposed_file(project, options))
        if path is not None:
            write = partial(self._write, project, survey, options, path)
            self._computations.run_with_placed_lines(
                project, survey, lambda: self._pictures.capture(project, options, write)
            )

    def _proposed_file(self, project: Project, options: ReportOptions) -> Path:
        """File that the dialogues propose, in the folder of the last export of the project."""
        last = self._settings.exported_report(project.folder)
        folder = project.folder if last is None else last[0].parent
        return (folder if folder.is_dir() else project.folder) / report_file_name(
            project.name, options.extent
        )

    def _input(self) -> tuple[Project, Survey, ReportOptions] | None:
        """Project, survey and options of a report.

        None if there is no result or the options cannot be used.
        """
        project, survey, options = self._document.project, self._survey, self._options()
        if project is None or project.result is None or survey is None or options is None:
            return None
        return project, survey, options

    def _ask_missing_once(self) -> bool:
        """Ask for missing details, once for a project; return False if the user cancelled.

        The report on a simulated survey is not signed, and needs none.
        """
        project, asked = self._document.project, self._document.folders_asked_for_details
        if project is None or project.truth_deg is not None:
            return True
        if not project.identity.missing or project.folder in asked:
            return True
        if not self.ask_details(project.identity.missing, continues=True):
            return False
        asked.add(project.folder)
        return True

    def _write(
        self,
        project: Project,
        survey: Survey,
        options: ReportOptions,
        path: Path,
        pictures: Pictures,
    ) -> None:
        refused = self._document.refused_since
        assess = self._assessment(project, survey)

        def work(progress: Progress) -> Path:
            from lispac.workflow.output.export import write_report

            known = assess(sub_progress(progress, 0.0, 0.3))
            with _temporary_files(pictures) as files:
                write_report(
                    project, survey, path, pictures=files, options=options, refused=refused,
                    known=known, progress=sub_progress(progress, 0.3, 1.0),
                )  # fmt: skip
            return path

        title, chosen = gettext("Writing the report"), self._chosen_options
        self._runner.run(title, work, partial(self._on_exported, project, chosen), persistent=True)

    def _assessment(
        self, project: Project, survey: Survey
    ) -> Callable[[Progress], dict[SightingKey, AssessedQuality]]:
        """Function for the worker that assesses the sightings whose quality is not known yet."""
        document, known = self._document, self._document.qualities

        def assess(progress: Progress) -> dict[SightingKey, AssessedQuality]:
            found = assess_sightings(project, survey, known=known, progress=progress)
            document.keep_qualities(survey, found)
            return found

        return assess

    def preview(self) -> None:
        """Show the pages of the report as they are printed."""
        if (found := self._input()) is None:
            return
        project, survey, options = found
        set_pages = partial(self._lay_out_pages, project, survey, options)
        self._computations.run_with_placed_lines(
            project, survey, lambda: self._pictures.capture(project, options, set_pages)
        )

    def _lay_out_pages(
        self,
        project: Project,
        survey: Survey,
        options: ReportOptions,
        pictures: Pictures,
    ) -> None:
        refused = self._document.refused_since
        ppi = PIXELS_PER_INCH * self._panel.devicePixelRatioF()

        assess = self._assessment(project, survey)

        def work(progress: Progress) -> "Preview":
            from lispac.workflow.output.export import preview_report

            known = assess(sub_progress(progress, 0.0, 0.5))
            with _temporary_files(pictures) as files:
                return preview_report(
                    project, survey, pictures=files, options=options, refused=refused, ppi=ppi,
                    known=known, progress=sub_progress(progress, 0.5, 1.0),
                )  # fmt: skip

        self._runner.run(
            gettext("Laying out the pages"),
            work,
            lambda preview: self._show_preview(project, options, preview),
            modal=True,
        )

    def _show_preview(self, project: Project, options: ReportOptions, preview: "Preview") -> None:
        chosen = self._chosen_options

        def save() -> str:
            path = self._dialogs.pdf_file(self._proposed_file(project, options))
            if path is None:
                return ""
            from lispac.workflow.output.export import save_preview

            try:
                save_preview(preview, path)
            except InputError as error:
                self._controller.refused.emit(error)
                return ""
            self._on_written(project, chosen, path)
            return gettext("Wrote {path}", path=path)

        self._dialogs.preview(preview.pages, save)

    def _on_exported(self, project: Project, options: tuple[object, ...], path: Path) -> None:
        self._on_written(project, options, path)
        if self._panel.opens.isChecked():
            self._open(path)

    def _open_exported(self, path: Path) -> None:
        """Open the exported report or its folder, which may have been moved since."""
        if path.exists():
            self._open(path)
        else:
            self._controller.refused.emit(InputError(error("report.file_moved", file=str(path))))

    def _open(self, path: Path) -> None:
        if not self._dialogs.open_file(path):
            self._controller.refused.emit(InputError(error("report.not_opened", file=str(path))))

    def _on_written(self, project: Project, options: tuple[object, ...], path: Path) -> None:
        self._document.mark_reported(project, ExportedReport(path, time.time(), options=options))
        self._store_report()
        self._controller.logged.emit(gettext("Wrote {path}", path=path))

    def _restore_report(self) -> None:
        """Set the report that was exported from this project before it was opened."""
        project = self._document.project
        if project is None or self._document.report is not None:  # as in a rebuilt window
            return
        stored = self._settings.exported_report(project.folder)
        if stored is not None and stored[0].exists():
            path, exported, digest, options = stored
            is_current = bool(digest) and digest == project.file_digest
            self._document.restore_report(ExportedReport(path, exported, is_current, options))

    def _store_report(self) -> None:
        """Store the exported report for the next time the project is opened."""
        document, report = self._document, self._document.report
        if document.project is not None and report is not None:
            is_saved = report.is_current and not document.is_modified
            self._settings.save_exported_report(
                document.project.folder, report.path, report.exported,
                document.file_digest if is_saved else "", report.options,
            )  # fmt: skip

    def _options(self) -> ReportOptions | None:
        """Options of the report; None if they cannot be used."""
        try:
            return self._panel.options()
        except InputError as error:
            self._controller.refused.emit(error)
            return None

    def _store_choice(self) -> None:
        self._settings.save_report_choice(self._panel.choice)
        self._settings.opens_report = self._panel.opens.isChecked()
        self._document.set_report_options(self._chosen_options)

    @property
    def _survey(self) -> Survey | None:
        return self._document.survey if self._document.is_survey_current else None


def report_file_name(project: str, extent: Extent) -> str:
    """Name of the PDF file of a report, which depends on its extent, in the language in use."""
    template = (
        N_("{project} boresight report (full)")
        if extent == "full"
        else N_("{project} boresight report")
    )
    return f"{gettext(template, project=project)}.pdf"


def _reference_frame(project: Project) -> dict[str, str]:
    """Datum and epoch with which georeferenced lines are read, to be proposed; empty if unknown."""
    try:
        datum, epoch = trajectory_datum_of(project.lines)
    except InputError:
        return {}
    return {"datum": datum, "epoch": "" if epoch is None else str(epoch)}


@contextmanager
def _temporary_files(pictures: Pictures) -> Iterator[dict[str | LazyText, Path]]:
    """Write pictures to temporary PNG files; slow, so used in the worker."""
    with tempfile.TemporaryDirectory(prefix="lispac-") as folder:
        files: dict[str | LazyText, Path] = {
            caption: Path(folder) / f"{k}.png" for k, caption in enumerate(pictures)
        }
        for picture, file in zip(pictures.values(), files.values(), strict=True):
            if not picture.save(str(file), "PNG"):
                raise InputError(error("window.disk_full", file=str(file)))
        yield files
