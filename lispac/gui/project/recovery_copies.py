"""Recovery copies of unsaved changes, and the lock of the open project.

After every edit, a copy of the project is written beside its saved state, in a separate thread so
that it is also written while an adjustment runs. Saving or discarding the changes removes the copy.
A copy that is found when a project is opened was left by a crash and is offered for recovery.
"""

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from pathlib import Path
from typing import Any

from PySide6.QtCore import QLockFile, QObject, Signal

from lispac.errors import InputError, LispacError, failure_reason
from lispac.gui.app.language import local_datetime
from lispac.gui.app.questions import Questions
from lispac.gui.app.settings import AppSettings
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.io.project.project_file import remove_unsaved, write_unsaved
from lispac.language import N_, gettext
from lispac.messages import Message, error
from lispac.project import Project
from lispac.workflow.project.moved_files import with_files_of
from lispac.workflow.project.projects import UnsavedProject, read_unsaved_project, require_folder

LOCK_FILE_NAME = "open.lock"
LOCKED_PROJECT_ERROR = error("window.unsaved_work_elsewhere")


class RecoveryCopies(QObject):
    """Writes the recovery copy and holds the lock of the project in a window.

    Parameters
    ----------
    former : RecoveryCopies, optional
        Those of the window that this one replaces. They hold the lock until `take_lock_from`.
    """

    problem_changed = Signal()
    """`problem` has changed."""
    _failed = Signal(object)
    _written = Signal()

    def __init__(
        self,
        document: Document,
        controller: Controller,
        questions: Questions,
        settings: AppSettings,
        former: "RecoveryCopies | None" = None,
    ) -> None:
        super().__init__(controller)
        self._former = former
        self._document, self._questions = document, questions
        self._settings, self._note = settings, controller.logged.emit
        self._writer = ThreadPoolExecutor(1, "lispac-keeping")
        self._latest: Project | None = None
        self._failed.connect(self._on_write_failed)
        self._written.connect(lambda: self._set_problem(None) if self.problem is not None else None)
        self._folder: Path | None = None
        self._lock: QLockFile | None = None
        self._writes_copies = False
        self.problem: Message | None = None
        """Reason why no recovery copy is written; None if it is written."""
        controller.may_save = self._may_save
        controller.may_overwrite = lambda project: self._questions.ask_to_overwrite(project.name)
        document.opened.connect(self._on_project_opened)
        document.changed.connect(self._write_copy)
        # `changed` is emitted before the undo stack is marked as modified
        document.modified.connect(
            lambda modified: self._write_copy() if modified else self.discard()
        )
        document.saved.connect(self._on_saved)

    # -- opening and closing ---------------------------------------------------------------------

    def _on_project_opened(self) -> None:
        """Lock the project that was opened, and offer unsaved changes for recovery."""
        project = self._document.project
        former, self._former = self._former, None
        if former is not None:
            former.finish_writing()
            self._folder, self._writes_copies = former._folder, former._writes_copies
            self._set_problem(former.problem)
            return
        self.discard()
        self.release_lock()
        self._set_problem(None)
        if project is None:
            return
        self._folder, self._writes_copies = project.folder, True
        self._settings.last_project = project.folder
        if not self._lock_project(project):
            self._writes_copies = False
            if self._questions.ask_to_open_locked(project.name, self._lock_holder()):
                self._set_problem(LOCKED_PROJECT_ERROR)
            else:
                self._document.open(None, None)
        elif not self._document.is_modified:
            self._ask_recovery(project)

    def _lock_project(self, project: Project) -> bool:
        """Lock the project; return False if another window has locked it.

        Return True if the lock cannot be written, as in a read-only folder.
        """
        lock = QLockFile(str(project.folder / LOCK_FILE_NAME))
        lock.setStaleLockTime(0)  # a lock of an ended program is stale at any age
        self._lock = lock
        return lock.tryLock(0) or lock.error() != QLockFile.LockError.LockFailedError

    def _lock_holder(self) -> str:
        """Computer and process of the window that holds the lock."""
        process, host, _ = self._lock.getLockInfo()
        if not process:
            return gettext("another program")
        return gettext("{host}, process {process}", host=host, process=process)

    def _ask_recovery(self, project: Project) -> None:
        """Ask whether to recover the changes that a crash left unsaved."""
        try:
            found = read_unsaved_project(project.folder)
        except LispacError as failure:
            self._note(str(failure))
            return
        if found is None:
            remove_unsaved(project.folder)
        elif self._questions.ask_to_recover(project.name, _copy_time_text(found)):
            recovered = with_files_of(found.project, project)
            self._document.edit(N_("recovery of unsaved changes"), recovered)
            self._note(gettext("Unsaved changes were recovered. Save the project to keep them."))
        else:
            remove_unsaved(project.folder)

    def discard(self) -> None:
        """Remove the recovery copy."""
        if self._folder is not None and self._writes_copies:
            self._latest = None
            self._run_in_worker(remove_unsaved, self._folder)

    def release_lock(self) -> None:
        """Release the lock of the project."""
        if self._lock is not None:
            self._lock.unlock()
        self._lock = self._folder = None

    def take_lock_from(self, former: "RecoveryCopies") -> None:
        """Hold the lock of the project instead of the window that this one replaces."""
        self._lock, former._lock = former._lock, None

    def finish_writing(self) -> None:
        """Wait until the recovery copy is written."""
        self._writer.submit(lambda: None).result()

    def stop(self) -> None:
        """Finish writing, stop the worker and release the lock."""
        self._writer.shutdown(wait=True)
        self.release_lock()

    # -- editing and saving ----------------------------------------------------------------------

    def _write_copy(self) -> None:
        project = self._document.project
        if project is None:
            return
        if project.folder != self._folder:  # saved in another folder
            self._folder = project.folder
            self._settings.last_project = project.folder
            self._writes_copies = self._lock_project(project)
        if self._writes_copies and self._document.is_modified:
            self._latest = project
            self._run_in_worker(self._write_latest_copy, project)

    def _write_latest_copy(self, project: Project) -> None:
        if project is self._latest:  # else superseded by a later edit
            require_folder(project)
            write_unsaved(project)
            self._written.emit()

    def _run_in_worker(self, write: Callable[[Any], None], argument: object) -> None:
        def ended(done: Future[None]) -> None:
            if (failure := done.exception()) is not None:
                self._failed.emit(failure)

        self._writer.submit(write, argument).add_done_callback(ended)

    def _on_saved(self) -> None:
        """Clear the problem after a save, unless another window has locked the project."""
        self._set_problem(None if self._writes_copies else LOCKED_PROJECT_ERROR)

    def _may_save(self, project: Project) -> bool:
        """Whether the folder of the project still exists; if not, show an error."""
        try:
            require_folder(project)
        except InputError as failure:
            self._questions.show_error(failure)
            return False
        return True

    def _on_write_failed(self, failure: BaseException) -> None:
        # The next edit tries again, since the disk or the drive may be available then.
        problem = error("window.unsaved_work_not_kept", reason=failure_reason(failure))
        if problem != self.problem:
            self._set_problem(problem)
            self._note(message_text(problem))

    def _set_problem(self, problem: Message | None) -> None:
        self.problem = problem
        self.problem_changed.emit()


def _copy_time_text(unsaved: UnsavedProject) -> str:
    """Time of the recovery copy, and of the last save of the project if it was later."""
    kept, saved = local_datetime(unsaved.kept), local_datetime(unsaved.saved)
    if unsaved.saved <= unsaved.kept:
        return kept
    return gettext("{time}; the project was saved later, at {saved}", time=kept, saved=saved)
