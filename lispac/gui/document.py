"""The open project, its data in memory, and the way back: one undo command per edit."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from lispac.language import Template, gettext
from lispac.messages import Message
from lispac.project import Project
from lispac.workflow.survey import Survey
from lispac.workflow.survey import data_key as data_key


@dataclass(eq=False)
class _State:
    """A project between two edits; a result that follows from an edit is filled in afterwards.

    Attributes
    ----------
    follows : whether its result is computed without being asked for
    refusal : why there is no such result
    refused_since : why an estimate after the result was refused
    """

    project: Project
    follows: bool = False
    refusal: Message | str = ""
    refused_since: Message | str = ""


@dataclass(frozen=True)
class _EditName:
    """Name of an edit, translated when a window shows it."""

    template: Template
    params: Mapping[str, Any]


class _Edit(QUndoCommand):
    """The state before and after one edit."""

    def __init__(
        self, name: _EditName, document: "Document", before: _State, after: _State
    ) -> None:
        super().__init__(gettext(name.template, **name.params))
        self.name = name
        self._document, self._before, self._after = document, before, after

    def redo(self) -> None:
        self._document._set(self._after)

    def undo(self) -> None:
        self._document._set(self._before)


class Document(QObject):
    """A project value that changes by edits, and the survey loaded for it."""

    changed = Signal()
    """The project is another value, or other data are at hand for it."""
    left = Signal()
    """What was shown goes; `opened` follows."""
    survey_changed = Signal()
    """Data were loaded or released; `changed` follows."""
    opened = Signal()
    """Another project, or none, is in the document."""
    modified = Signal(bool)
    saved = Signal()
    """The project on disk is the one in memory."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._state: _State | None = None
        self._folder: Path | None = None
        self.file_digest = ""
        """Digest of the project file as it was read or last saved."""
        self.survey: Survey | None = None
        self._key: tuple[object, ...] | None = None
        self._survey_told = True
        self._reported: tuple[Project | None, str] = (None, "")
        self.undo_stack = QUndoStack(self)
        self.undo_stack.cleanChanged.connect(self._clean_changed)

    @property
    def project(self) -> Project | None:
        """The project as it stands."""
        return None if self._state is None else self._state.project

    @property
    def awaits_result(self) -> bool:
        """Whether the project's result is still to follow from the last edit."""
        state = self._state
        return (
            state is not None
            and state.follows
            and state.project.result is None
            and not state.refusal
        )

    @property
    def refusal(self) -> Message | str:
        """Why no result follows from the last edit; empty where one does."""
        return "" if self._state is None else self._state.refusal

    @property
    def refused_since(self) -> Message | str:
        """Why a later estimate was refused; empty if none was."""
        return "" if self._state is None else self._state.refused_since

    @property
    def reported(self) -> str:
        """Name of the last report of the project as it stands; empty where there is none."""
        told, name = self._reported
        return name if told is not None and told is self.project else ""

    @property
    def is_modified(self) -> bool:
        """Whether there is something to save."""
        return self.project is not None and not self.undo_stack.isClean()

    @property
    def survey_is_current(self) -> bool:
        """Whether the loaded data are those of the project as it stands."""
        return self.project is not None and self._key == data_key(self.project)

    def open(self, project: Project | None, survey: Survey | None) -> None:
        """Put a project in, fresh and unmodified."""
        self.undo_stack.clear()
        self._state = None if project is None else _State(project)
        self._folder = None if project is None else project.folder
        self.file_digest = "" if project is None else project.file_digest
        self.survey = survey
        self._key = data_key(project) if project is not None and survey is not None else None
        self.show_again()

    def show_again(self) -> None:
        """Emit the signals of a project that was just opened."""
        self.left.emit()
        self.survey_changed.emit()
        self.opened.emit()
        self.changed.emit()

    def set_survey(self, project: Project | None, survey: Survey | None) -> None:
        """Keep the data that were loaded for ``project``."""
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
        follows: bool = False,
        **params: Any,
    ) -> None:
        """Replace the project by an edited one, as one undo step.

        Parameters
        ----------
        name : Template
            Name of the edit as the undo menu shows it, marked with `N_`; ``params`` fill it.
        survey : Survey, optional
            The data as the edited project places them, where they are at hand already.
        follows : bool
            Whether a result that the edit drops is to be computed again by itself: `amend` fills
            it in, and one undo takes back the edit and its result.
        """
        if self._state is None or project is self._state.project:
            return
        again = follows and (self._state.project.result is not None or self._state.follows)
        before, after = self._state, _State(self._here(project), follows=again)
        if project.result is before.project.result is not None:
            after.refused_since = before.refused_since
        if survey is not None:
            self.survey, self._key, self._survey_told = survey, data_key(project), False
        self.undo_stack.push(_Edit(_EditName(name, params), self, before, after))

    def amend(self, project: Project) -> None:
        """Fill in what follows from the last edit; it belongs to that edit's undo step."""
        assert self._state is not None
        self._state.project = self._here(project)
        if self.undo_stack.isClean():
            self.undo_stack.resetClean()  # what was saved lacks it
        self.changed.emit()

    def refuse(self, reason: Message | str) -> None:
        """Keep why nothing follows from the last edit."""
        assert self._state is not None
        self._state.refusal = reason
        self.changed.emit()

    def keep_older(self, reason: Message | str) -> None:
        """Keep why an estimate was refused: the result is that of one before."""
        if self._state is not None and self._state.project.result is not None:
            self._state.refused_since = reason
            self.changed.emit()

    def mark_saved(self, file_digest: str) -> None:
        """The project on disk is the one in memory; its file has this digest."""
        self.file_digest = file_digest
        self.undo_stack.setClean()
        self.saved.emit()

    def mark_reported(self, project: Project, name: str) -> None:
        """A report of ``project`` was written to a file of this name."""
        self._reported = (project, name)
        self.changed.emit()

    def move(self, project: Project, survey: Survey) -> None:
        """The project was saved in another folder and goes on there, with every edit before."""
        assert self._state is not None
        self._folder, self.file_digest = project.folder, project.file_digest
        self._state.project = project
        self.undo_stack.setClean()
        self.set_survey(project, survey)

    def handed_over(self, parent: QObject | None = None) -> "Document":
        """The same project with the same way back, for a window made anew."""
        heir = Document(parent)
        heir._reported = self._reported
        heir._folder, heir.file_digest = self._folder, self.file_digest
        heir.survey, heir._key = self.survey, self._key
        stack = self.undo_stack
        steps = [stack.command(k) for k in range(stack.count())]
        first = steps[0]._before if steps else self._state
        heir._state = first
        for k, step in enumerate(steps):
            if stack.cleanIndex() == k:
                heir.undo_stack.setClean()
            heir.undo_stack.push(_Edit(step.name, heir, step._before, step._after))
        if stack.cleanIndex() == len(steps):
            heir.undo_stack.setClean()
        elif stack.cleanIndex() < 0:
            heir.undo_stack.resetClean()
        heir.undo_stack.setIndex(stack.index())
        return heir

    def _here(self, project: Project) -> Project:
        """The project in the folder it has now; an edit before it moved knows another."""
        if self._folder is None or project.folder == self._folder:
            return project
        return replace(project, folder=self._folder)

    def _clean_changed(self, clean: bool) -> None:
        self.modified.emit(not clean)

    def _set(self, state: _State) -> None:
        state.project = self._here(state.project)
        self._state = state
        if not self._survey_told:
            self._survey_told = True
            self.survey_changed.emit()
        self.changed.emit()
