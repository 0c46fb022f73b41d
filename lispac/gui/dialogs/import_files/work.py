"""The dialogue's own worker: files are looked into one after the other, never in the window."""

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from lispac.errors import Cancelled, LispacError
from lispac.gui.dialogs.error import describe
from lispac.gui.language import say
from lispac.gui.tasks import TaskRunner
from lispac.io.files import message_about
from lispac.messages import Message, error
from lispac.progress import Progress
from lispac.survey.source import printable
from lispac.workflow.intake import Intake, gathered, project_among
from lispac.workflow.intake_entry import Entry, examined, examined_again, examined_as_given

STOPPED = "import.stopped"
"""Code of the error of a file that was not examined, because the user stopped it."""


class Work(QObject):
    """Holds the intake, and reads what it asks for.

    Parameters
    ----------
    mappings : dict of str to str
        Columns chosen for text files before, by their layout.
    """

    changed = Signal()
    """The intake is another one."""
    moved = Signal()
    """The running work has moved: look at `words` and `fraction`."""
    project_found = Signal(object)
    """A project was dropped: it is to be opened."""

    def __init__(self, mappings: dict[str, str], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.intake = Intake()
        self._mappings = mappings
        self._asked: dict[Path, Entry] = {}
        self._done = 0
        self.runner = TaskRunner(self)
        self.runner.moved.connect(self.moved)

    def begin(self, intake: Intake) -> None:
        """Begin with files that an open project has."""
        self.edit(intake)

    def add(self, paths: Iterable[Path]) -> None:
        """Take in files and folders."""
        paths = list(paths)

        def work(progress: Progress) -> tuple[Path | None, tuple[Path, ...]]:
            return project_among(paths), gathered(paths)

        def done(found: tuple[Path | None, tuple[Path, ...]]) -> None:
            if found[0] is not None:
                self.project_found.emit(found[0])
            else:
                self.edit(self.intake.with_files(found[1]))

        self.runner.run("Listing the files", work, done)

    def edit(self, intake: Intake) -> None:
        """Take another intake, and look into the files that wait for it."""
        self.intake = intake
        here = {entry.path for entry in intake.entries}
        self._asked = {path: entry for path, entry in self._asked.items() if path in here}
        for entry in intake.entries:
            if entry.pending and self._asked.get(entry.path) is not entry:
                self._look(entry)
        self.changed.emit()

    def stop(self) -> None:
        """Look into no more files."""
        self.runner.cancel()
        self._asked = {}
        self._done = 0
        entries = tuple(
            replace(e, pending=False, error=_stopped(e)) if e.pending else e
            for e in self.intake.entries
        )
        self.intake = replace(self.intake, entries=entries)
        self.changed.emit()

    @property
    def was_stopped(self) -> bool:
        """Whether some files were not looked into."""
        return any(_was_stopped(entry) for entry in self.intake.entries)

    def look_again(self) -> None:
        """Look into the files that were passed over when it was stopped."""
        entries = tuple(
            replace(e, pending=True) if _was_stopped(e) else e for e in self.intake.entries
        )
        self.edit(replace(self.intake, entries=entries))

    @property
    def busy(self) -> bool:
        """Whether a file is being looked into, or waits."""
        return self.runner.active

    @property
    def words(self) -> str:
        """What is being done, in the user's language."""
        task = self.runner.current
        if task is None:
            return ""
        total = self._done + sum(entry.pending for entry in self.intake.entries)
        what = say(task.message or task.title)
        return f"{what} ({say(f'{self._done + 1} of {total}')})" if total > 1 else what

    @property
    def fraction(self) -> float:
        """How much is done, from 0 to 1."""
        task = self.runner.current
        total = self._done + sum(entry.pending for entry in self.intake.entries)
        return (self._done + (0.0 if task is None else task.fraction)) / max(total, 1)

    def close(self) -> None:
        """Stop, and wait for the worker to end."""
        self.runner.close()

    def _look(self, entry: Entry) -> None:
        self._asked[entry.path] = entry
        mappings = self._mappings

        def work(progress: Progress) -> Entry:
            try:
                if entry.given is not None:
                    return examined_as_given(entry, progress=progress)
                if not entry.looks:
                    return examined(entry.path, mappings, progress=progress)
                return examined_again(entry, progress=progress)
            except Cancelled:
                raise
            except Exception as failure:  # whatever one file does, the others are examined
                return replace(entry, pending=False, error=_not_examined(entry, failure))

        def done(found: Entry) -> None:
            if self._asked.get(entry.path) is not entry:
                return
            del self._asked[entry.path]
            self._done = self._done + 1 if self._asked else 0
            self.edit(self.intake.with_entry(found).sorted_out(found.path))

        self.runner.run(f"Looking into {entry.path.name}", work, done, key=str(entry.path))


def _stopped(entry: Entry) -> Message:
    return error(STOPPED, file=printable(entry.path.name))


def _was_stopped(entry: Entry) -> bool:
    return entry.error is not None and entry.error.code == STOPPED


def _not_examined(entry: Entry, failure: Exception) -> Message:
    """The error of a file that cannot be examined, whatever went wrong."""
    if isinstance(failure, LispacError):
        return message_about(failure, entry.path)
    file, (sentence, details) = printable(entry.path.name), describe(failure)
    if not details:
        return error("file.refused", file=file, reason=sentence)
    kind = type(failure).__name__
    return error("import.not_examined", file=file, kind=kind, reason=str(failure))
