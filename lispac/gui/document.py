"""The open project, its data in memory, and the way back: one undo command per edit."""

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from lispac.project import Project
from lispac.workflow.survey import Survey


def data_key(project: Project) -> tuple[object, ...]:
    """Everything the loaded data depend on: when it changes they are read again."""
    settings = project.settings
    return (
        project.trajectory,
        project.accuracy,
        project.lines,
        settings.lever_arm,
        settings.boresight_deg,
        settings.origin_deg_m,
        settings.position_sigma,
        settings.attitude_sigma_deg,
    )


class _Edit(QUndoCommand):
    """The project before and after one edit."""

    def __init__(self, text: str, document: "Document", before: Project, after: Project) -> None:
        super().__init__(text)
        self._document, self._before, self._after = document, before, after

    def redo(self) -> None:
        self._document._set(self._after)

    def undo(self) -> None:
        self._document._set(self._before)


class Document(QObject):
    """A project value that changes by edits, and the survey loaded for it."""

    changed = Signal()
    """The project is another value."""
    survey_changed = Signal()
    """Data were loaded or let go."""
    opened = Signal()
    """Another project, or none, is in the document."""
    modified = Signal(bool)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.project: Project | None = None
        self.survey: Survey | None = None
        self._key: tuple[object, ...] | None = None
        self.undo_stack = QUndoStack(self)
        self.undo_stack.cleanChanged.connect(self._clean_changed)

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
        self.project = project
        self.set_survey(project, survey)
        self.opened.emit()
        self.changed.emit()

    def set_survey(self, project: Project | None, survey: Survey | None) -> None:
        """Keep the data that were loaded for ``project``."""
        self.survey = survey
        self._key = data_key(project) if project is not None and survey is not None else None
        self.survey_changed.emit()

    def edit(self, text: str, project: Project) -> None:
        """Replace the project by an edited one, as one undo step."""
        if self.project is None or project is self.project:
            return
        self.undo_stack.push(_Edit(text, self, self.project, project))

    def mark_saved(self) -> None:
        """The project on disk is the one in memory."""
        self.undo_stack.setClean()

    def _clean_changed(self, clean: bool) -> None:
        self.modified.emit(not clean)

    def _set(self, project: Project) -> None:
        self.project = project
        self.changed.emit()
