"""Worker of the import dialogue: reads files one after the other in the background."""

from collections.abc import Iterable
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QObject, Signal

from lispac.errors import Cancelled, LispacError
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.widgets.error_box import error_text_and_details
from lispac.io.files import message_with_file_name
from lispac.language import gettext
from lispac.messages import Message, error
from lispac.progress import Progress
from lispac.survey.line_source import printable
from lispac.workflow.importing.input_file import (
    InputFile,
    examine_file,
    examine_project_file,
    reexamine_file,
)
from lispac.workflow.importing.input_files import InputFiles, collect_files, find_project

STOPPED_CODE = "import.stopped"
"""Message code of files that were not read because the user stopped the reading."""


class ImportWorker(QObject):
    """Holds the files of an import and reads them in the background.

    Parameters
    ----------
    mappings : dict of str to str
        Columns of text files chosen earlier, by their layout.
    """

    changed = Signal()
    """The files or their settings have changed."""
    progress_changed = Signal()
    """The running work has progressed: see `progress_text` and `fraction`."""
    project_found = Signal(object)
    """Path of a dropped project that is to be opened."""

    def __init__(self, mappings: dict[str, str], parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.input_files = InputFiles()
        self._mappings = mappings
        self._queued: dict[Path, InputFile] = {}
        self._done = 0
        self.runner = TaskRunner(self)
        self.runner.progress_changed.connect(self.progress_changed)

    def begin(self, input_files: InputFiles) -> None:
        """Set the files of an open project."""
        self.edit(input_files)

    def add(self, paths: Iterable[Path]) -> None:
        """Add files and folders."""
        paths = list(paths)

        def work(progress: Progress) -> tuple[Path | None, tuple[Path, ...]]:
            return find_project(paths), collect_files(paths)

        def done(result: tuple[Path | None, tuple[Path, ...]]) -> None:
            if result[0] is not None:
                self.project_found.emit(result[0])
            else:
                self.edit(self.input_files.with_files(result[1]))

        self.runner.run(gettext("Listing the files"), work, done)

    def edit(self, input_files: InputFiles) -> None:
        """Replace the import, and read the files that are pending."""
        self.input_files = input_files
        paths = {input_file.path for input_file in input_files.files}
        self._queued = {
            path: input_file for path, input_file in self._queued.items() if path in paths
        }
        for input_file in input_files.files:
            if input_file.pending and self._queued.get(input_file.path) is not input_file:
                self._examine_file(input_file)
        self.changed.emit()

    def stop(self) -> None:
        """Stop reading files."""
        self.runner.cancel()
        self._queued = {}
        self._done = 0
        files = tuple(
            replace(e, pending=False, error=_stopped_error(e)) if e.pending else e
            for e in self.input_files.files
        )
        self.input_files = replace(self.input_files, files=files)
        self.changed.emit()

    @property
    def was_stopped(self) -> bool:
        """Whether some files were not read because the user stopped the reading."""
        return any(_was_stopped(input_file) for input_file in self.input_files.files)

    def read_skipped(self) -> None:
        """Read the files that were skipped when the reading was stopped."""
        files = tuple(
            replace(e, pending=True) if _was_stopped(e) else e for e in self.input_files.files
        )
        self.edit(replace(self.input_files, files=files))

    @property
    def busy(self) -> bool:
        """Whether a file is being read or is queued."""
        return self.runner.active

    @property
    def progress_text(self) -> str:
        """Text of the running step in the language of the user."""
        task = self.runner.current
        if task is None:
            return ""
        total = self._done + sum(input_file.pending for input_file in self.input_files.files)
        step = str(task.step or task.title)
        if total <= 1:
            return step
        return gettext(
            "{step} ({number:n} of {total:n})", step=step, number=self._done + 1, total=total
        )

    @property
    def fraction(self) -> float:
        """Share of the work that is done, from 0 to 1."""
        task = self.runner.current
        total = self._done + sum(input_file.pending for input_file in self.input_files.files)
        return (self._done + (0.0 if task is None else task.fraction)) / max(total, 1)

    def close(self) -> None:
        """Stop the worker and wait for its end."""
        self.runner.close()

    def _examine_file(self, input_file: InputFile) -> None:
        self._queued[input_file.path] = input_file
        mappings = self._mappings

        def work(progress: Progress) -> InputFile:
            try:
                if input_file.project_reading is not None:
                    return examine_project_file(input_file, progress=progress)
                if not input_file.checks:
                    return examine_file(input_file.path, mappings, progress=progress)
                return reexamine_file(input_file, progress=progress)
            except Cancelled:
                raise
            except Exception as failure:  # an error in one file must not affect the others
                return replace(
                    input_file, pending=False, error=_examination_error(input_file, failure)
                )

        def done(result: InputFile) -> None:
            if self._queued.get(input_file.path) is not input_file:
                return
            del self._queued[input_file.path]
            self._done = self._done + 1 if self._queued else 0
            self.edit(self.input_files.with_changed_file(result).with_resolved_role(result.path))

        title = gettext("Reading {file}", file=input_file.path.name)
        self.runner.run(title, work, done, key=str(input_file.path))


def _stopped_error(input_file: InputFile) -> Message:
    return error(STOPPED_CODE, file=printable(input_file.path.name))


def _was_stopped(input_file: InputFile) -> bool:
    return input_file.error is not None and input_file.error.code == STOPPED_CODE


def _examination_error(input_file: InputFile, failure: Exception) -> Message:
    """Error of a file that cannot be examined."""
    if isinstance(failure, LispacError):
        return message_with_file_name(failure, input_file.path)
    file, (sentence, details) = printable(input_file.path.name), error_text_and_details(failure)
    if not details:
        return error("file.refused", file=file, reason=sentence)
    kind = type(failure).__name__
    return error("import.not_examined", file=file, kind=kind, reason=str(failure))
