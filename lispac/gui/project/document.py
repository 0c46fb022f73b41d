"""Open project, its data in memory and its undo history: one undo command per edit."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from lispac.adjustment.result import AdjustmentResult
from lispac.language import Template, gettext
from lispac.messages import Message
from lispac.project import Project
from lispac.workflow.calibration.sighting_assessment import AssessedQuality, SightingKey
from lispac.workflow.project.survey import Survey
from lispac.workflow.project.survey import data_key as data_key


@dataclass(eq=False)
class _ProjectState:
    """Project between two edits; `Document.complete_last_edit` adds the result of an edit.

    Attributes
    ----------
    recompute : whether its result is computed automatically
    refusal : reason why the automatic computation gave no result
    refused_since : reason why an estimate after the result was refused
    """

    project: Project
    recompute: bool = False
    refusal: Message | str = ""
    refused_since: Message | str = ""


@dataclass(frozen=True)
class ExportedReport:
    """Report that was last exported from a project.

    Attributes
    ----------
    exported : time of the export, seconds since 1970
    is_current : whether the project has not changed since then
    options : options of the report as stored in the settings; None if they are not known
    has_other_options : whether other options are chosen now
    """

    path: Path
    exported: float
    is_current: bool = True
    options: tuple[object, ...] | None = None
    has_other_options: bool = False


@dataclass(frozen=True)
class _EditName:
    """Name of an edit, translated when it is shown."""

    template: Template
    params: Mapping[str, Any]


class _Edit(QUndoCommand):
    """Undo command with the states before and after one edit."""

    def __init__(
        self, name: _EditName, document: "Document", before: _ProjectState, after: _ProjectState
    ) -> None:
        super().__init__(gettext(name.template, **name.params))
        self.name = name
        self._document, self._before, self._after = document, before, after
        self._is_new = True

    def redo(self) -> None:
        self._document._set_state(self._after)
        if not self._is_new:  # Qt calls this at first for the edit itself
            self._announce(self._before, self._after)
        self._is_new = False

    def undo(self) -> None:
        self._document._set_state(self._before)
        self._announce(self._after, self._before)

    def _announce(self, former: _ProjectState, shown: _ProjectState) -> None:
        others = former.project.targets
        edited = [each.name for each in shown.project.targets if each not in others]
        if len(edited) == 1:
            self._document.reverted.emit(edited[0])


class Document(QObject):
    """Project, changed by edits, and the survey loaded for it."""

    changed = Signal()
    """The project was replaced by an edited one, or its data were loaded or released."""
    about_to_open = Signal()
    """Another project replaces the current one; `opened` follows."""
    survey_changed = Signal()
    """Data were loaded or released; `changed` follows."""
    opened = Signal()
    """Another project was opened, or the project was closed."""
    modified = Signal(bool)
    """Whether the project now has unsaved changes."""
    saved = Signal()
    """The project was saved."""
    reverted = Signal(str)
    """An edit was undone or redone: name of the only target that this added or changed."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._state: _ProjectState | None = None
        self._folder: Path | None = None
        self.file_digest = ""
        """Digest of the project file as it was read or last saved."""
        self.survey: Survey | None = None
        self._key: tuple[object, ...] | None = None
        self._survey_announced = True
        self._report: ExportedReport | None = None
        self._reported_project: Project | None = None
        self._report_options: tuple[object, ...] | None = None
        self.folders_asked_for_details: set[Path] = set()
        """Folders of the projects whose missing details for the report were asked for."""
        self.unchecked_result: AdjustmentResult | None = None
        """Result without advice and cross-checks, which are computed when no task runs."""
        self._had_result = False
        self._qualities: tuple[object, dict[SightingKey, AssessedQuality]] = None, {}
        """Lines of the survey, and qualities of the sightings assessed with them."""
        self.undo_stack = QUndoStack(self)
        self.undo_stack.cleanChanged.connect(self._on_clean_changed)

    @property
    def project(self) -> Project | None:
        """Current project; None if no project is open."""
        return None if self._state is None else self._state.project

    @property
    def awaits_result(self) -> bool:
        """Whether the result after the last edit is still to be computed."""
        state = self._state
        return (
            state is not None
            and state.recompute
            and state.project.result is None
            and not state.refusal
        )

    @property
    def refusal(self) -> Message | str:
        """Reason why the project has no result after an estimate; empty if there is none."""
        return "" if self._state is None else self._state.refusal

    @property
    def refused_since(self) -> Message | str:
        """Reason why a later estimate was refused while an older result is kept; else empty."""
        return "" if self._state is None else self._state.refused_since

    @property
    def is_result_outdated(self) -> bool:
        """Whether an edit has removed the result of this project."""
        return self._had_result and self.project is not None and self.project.result is None

    @property
    def report(self) -> ExportedReport | None:
        """Report that was last exported from the project; None if there is none."""
        if self._report is None or self.project is None:
            return None
        known = self._report.options is not None and self._report_options is not None
        return replace(
            self._report,
            is_current=self._reported_project is self.project,
            has_other_options=known and self._report.options != self._report_options,
        )

    @property
    def awaits_checks(self) -> bool:
        """Whether the result of the project is not completely checked."""
        result = None if self.project is None else self.project.result
        return result is not None and result is self.unchecked_result

    @property
    def is_modified(self) -> bool:
        """Whether there are unsaved changes."""
        return self.project is not None and not self.undo_stack.isClean()

    @property
    def is_survey_current(self) -> bool:
        """Whether the loaded data belong to the current project."""
        return self.project is not None and self._key == data_key(self.project)

    @property
    def current_data(self) -> tuple[Project | None, Survey | None]:
        """The project, and the survey if its data belong to the project."""
        return self.project, self.survey if self.is_survey_current else None

    def open(self, project: Project | None, survey: Survey | None) -> None:
        """Set a project that is not modified, and clear the undo history."""
        self.undo_stack.clear()
        self._state = None if project is None else _ProjectState(project)
        self._report = self._reported_project = None
        self._had_result = project is not None and project.result is not None
        self._folder = None if project is None else project.folder
        self.file_digest = "" if project is None else project.file_digest
        self.survey = survey
        self._key = data_key(project) if project is not None and survey is not None else None
        self.notify_opened()

    def notify_opened(self) -> None:
        """Emit the signals of a newly opened project."""
        self.about_to_open.emit()
        self.survey_changed.emit()
        self.opened.emit()
        self.changed.emit()

    @property
    def qualities(self) -> dict[SightingKey, AssessedQuality]:
        """Last qualities of the sightings that were assessed with the present lines."""
        lines, qualities = self._qualities
        return qualities if self.survey is not None and lines is self.survey.scans else {}

    def keep_qualities(
        self, survey: Survey, qualities: Mapping[SightingKey, AssessedQuality]
    ) -> None:
        """Store the qualities of sightings for windows and reports; callable in any thread."""
        self._qualities = survey.scans, dict(qualities)

    def set_survey(self, project: Project | None, survey: Survey | None) -> None:
        """Store the data that were loaded for ``project``."""
        self.survey = survey
        self._key = data_key(project) if project is not None and survey is not None else None
        self.survey_changed.emit()
        self.changed.emit()

    def edit(
        self,
        name: Template,
        project: Project,
        *,
        survey: Survey | None = None,
        recompute: bool = False,
        **params: Any,
    ) -> None:
        """Replace the project by an edited one, as one undo step.

        Parameters
        ----------
        name : Template
            Name of the edit as the undo menu shows it, marked with `N_`; ``params`` fill it.
        survey : Survey, optional
            Data georeferenced as in the edited project, if they are already available.
        recompute : bool
            Whether a result that the edit removes is computed again automatically:
            `complete_last_edit` adds it, and one undo reverts the edit and its result.
        """
        if self._state is None or project is self._state.project:
            return
        again = recompute and (self._state.project.result is not None or self._state.recompute)
        before, after = (
            self._state,
            _ProjectState(self._with_current_folder(project), recompute=again),
        )
        if project.result is before.project.result is not None:
            after.refused_since = before.refused_since
        if survey is not None:
            self.survey, self._key, self._survey_announced = survey, data_key(project), False
        self.undo_stack.push(_Edit(_EditName(name, params), self, before, after))

    def complete_last_edit(self, project: Project) -> None:
        """Store what was computed after the last edit within the undo step of that edit."""
        assert self._state is not None
        self._state.project = self._with_current_folder(project)
        self._had_result |= project.result is not None
        if self.undo_stack.isClean():
            self.undo_stack.resetClean()  # the saved project lacks what was computed
        self.changed.emit()

    def refuse(self, reason: Message | str) -> None:
        """Store the reason why the last edit has no result."""
        assert self._state is not None
        self._state.refusal = reason
        self.changed.emit()

    def refuse_request(self, reason: Message | str) -> None:
        """Store the reason why a requested estimate was refused; an older result is kept."""
        if self._state is None:
            return
        if self._state.project.result is None:
            self._state.refusal = reason
        else:
            self._state.refused_since = reason
        self.changed.emit()

    def mark_saved(self, file_digest: str) -> None:
        """Mark the project as saved to a file with this digest."""
        self.file_digest = file_digest
        self.undo_stack.setClean()
        self.saved.emit()

    def mark_reported(self, project: Project, report: ExportedReport) -> None:
        """Record that a report of ``project`` was exported."""
        self._report, self._reported_project = report, project
        self.changed.emit()

    def set_report_options(self, options: tuple[object, ...]) -> None:
        """Set the options that are chosen for the next report."""
        if options != self._report_options:
            self._report_options = options
            if self._report is not None:
                self.changed.emit()

    def restore_report(self, report: ExportedReport) -> None:
        """Set the report that was exported before the project was opened; `changed` follows."""
        self._report = report
        self._reported_project = self.project if report.is_current else None

    def move(self, project: Project, survey: Survey) -> None:
        """Continue in another folder where the project was saved, with all undo steps."""
        assert self._state is not None
        self._folder, self.file_digest = project.folder, project.file_digest
        self._state.project = project
        self.undo_stack.setClean()
        self.set_survey(project, survey)

    def copy_for_new_window(self, parent: QObject | None = None) -> "Document":
        """Copy of the document with its undo steps, for a rebuilt window."""
        copy = Document(parent)
        copy._report, copy._reported_project = self._report, self._reported_project
        copy._had_result = self._had_result
        copy.folders_asked_for_details = self.folders_asked_for_details
        copy._qualities = self._qualities
        copy._folder, copy.file_digest = self._folder, self.file_digest
        copy.survey, copy._key = self.survey, self._key
        stack = self.undo_stack
        steps = [stack.command(k) for k in range(stack.count())]
        first = steps[0]._before if steps else self._state
        copy._state = first
        for k, step in enumerate(steps):
            if stack.cleanIndex() == k:
                copy.undo_stack.setClean()
            copy.undo_stack.push(_Edit(step.name, copy, step._before, step._after))
        if stack.cleanIndex() == len(steps):
            copy.undo_stack.setClean()
        elif stack.cleanIndex() < 0:
            copy.undo_stack.resetClean()
        copy.undo_stack.setIndex(stack.index())
        return copy

    def _with_current_folder(self, project: Project) -> Project:
        """Project with the current folder; earlier states may contain a former folder."""
        if self._folder is None or project.folder == self._folder:
            return project
        return replace(project, folder=self._folder)

    def _on_clean_changed(self, clean: bool) -> None:
        self.modified.emit(not clean)

    def _set_state(self, state: _ProjectState) -> None:
        state.project = self._with_current_folder(state.project)
        self._state = state
        self._had_result |= state.project.result is not None
        if not self._survey_announced:
            self._survey_announced = True
            self.survey_changed.emit()
        self.changed.emit()
