"""Background tasks: one runner on the GUI thread, one worker, one cancel flag per task.

The worker runs a function that takes `progress` and returns a value. The worker only sets the
progress of the task and checks its cancel flag. The GUI thread reads the progress twenty times a
second, and only the GUI thread processes the value. A cancelled or failed task changes nothing; a
task that has already written its files when it is cancelled is reported as completed. A task whose
value is shown in a dialogue ends before its dialogue opens, and waits while another one is open.
"""

import queue
import threading
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtWidgets import QApplication

from lispac.errors import Cancelled
from lispac.gui.app.garbage_collection import MemoryTrimming
from lispac.language import gettext
from lispac.progress import Progress, Step

REFRESH_INTERVAL_MS = 50
REPORT_INTERVAL_S = 0.5
"""Shortest time between two stored reports of the progress."""
MIN_ESTIMATE_TIME_S, MIN_ESTIMATE_FRACTION = 3.0, 0.05
"""Time and fraction of a task before which no time left is estimated."""
MAX_SILENCE_SHARE = 0.2
"""Share of the elapsed time without a report after which no time left is estimated."""
MAX_DURATION_RATIO = 1.5
"""Largest ratio of two estimated durations that agree."""


@dataclass(eq=False)
class Task:
    """Task that runs in the worker or is queued.

    Attributes
    ----------
    work : function that takes a Progress and returns a value; runs in the worker
    done : function that takes the value; runs on the GUI thread
    quiet : the user does not wait for the task, and any task that is not quiet cancels it
    key : a later task with the same key cancels and replaces the task; empty for no replacement
    persistent : the task writes files, and cannot be cancelled after they are written
    modal : the value is shown in a dialogue
    has_time_left : the time left can be estimated from the fraction
    superseded : the task was cancelled in favour of another task, not by the user
    """

    title: str
    work: Callable[[Progress], Any]
    done: Callable[[Any], None]
    quiet: bool = False
    key: str = ""
    persistent: bool = False
    modal: bool = False
    has_time_left: bool = True
    superseded: bool = False
    cancel: threading.Event = field(default_factory=threading.Event)
    fraction: float = 0.0
    step: Step | None = None
    started: float = 0.0
    reports: list[tuple[float, float]] = field(default_factory=list)
    """Seconds since the start and fraction of some reports."""
    _last_report: float = field(default=0.0, init=False)
    value: Any = None
    error: BaseException | None = None

    def report(self, fraction: float, step: Step | None = None) -> None:
        """Report the progress, which never decreases; raises `Cancelled` if it was cancelled."""
        if self.cancel.is_set():
            raise Cancelled
        self.fraction = min(max(fraction, self.fraction), 1.0)
        self._last_report = elapsed = time.monotonic() - self.started
        if not self.reports or elapsed - self.reports[-1][0] >= REPORT_INTERVAL_S:
            self.reports.append((elapsed, self.fraction))
        if step is not None:
            self.step = step

    def clear_data(self) -> None:
        """Release the data of an ended task, but keep its state and its error."""
        self.work, self.done, self.value = _ignore, _ignore, None
        if self.error is not None:
            self.error.__traceback__ = None  # its traceback refers to the data as well

    def seconds_left(self) -> float | None:
        """Estimated seconds left at the mean rate; None while the rate is not dependable.

        It is dependable if the durations that were estimated now and after half of the elapsed
        time agree.
        """
        elapsed = time.monotonic() - self.started
        if not self.has_time_left:
            return None
        if elapsed < MIN_ESTIMATE_TIME_S or self.fraction < MIN_ESTIMATE_FRACTION:
            return None
        if elapsed - self._last_report > max(MAX_SILENCE_SHARE * elapsed, MIN_ESTIMATE_TIME_S):
            return None  # the mean rate is that of other steps
        duration = self._last_report / self.fraction
        former = next((each for each in reversed(self.reports) if each[0] <= 0.5 * elapsed), None)
        if former is not None:
            time_then, fraction_then = former
            if fraction_then <= 0 or not (
                1 / MAX_DURATION_RATIO < time_then / fraction_then / duration < MAX_DURATION_RATIO
            ):
                return None
        return max(duration - elapsed, 0.0)


class TaskRunner(QObject):
    """Runs tasks one after the other."""

    changed = Signal()
    """A task started or ended: see `current`."""
    progress_changed = Signal()
    """A task started, progressed or ended: see the progress of `current`."""
    failed = Signal(object)
    """Exception that ended a task."""
    stopped = Signal(str)
    """Title of a task that was cancelled, unless it is quiet or another task replaced it."""
    cancelled_too_late = Signal(str)
    """Text that says that a task was completed before it could be cancelled."""
    idle = Signal()
    """No task is running or queued."""
    _ended = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.current: Task | None = None
        self._waiting: list[Task] = []
        self._inbox: queue.SimpleQueue[Task | None] = queue.SimpleQueue()
        self._worker: threading.Thread | None = None
        self._closed = False
        self._timer = QTimer(self)
        self._timer.setInterval(REFRESH_INTERVAL_MS)
        self._timer.timeout.connect(self.progress_changed)
        self.changed.connect(self.progress_changed)
        self._ended.connect(self._finish_task, Qt.ConnectionType.QueuedConnection)

    @property
    def busy(self) -> bool:
        """Whether a task is running or queued that the user waits for."""
        return any(not task.quiet for task in self._unfinished_tasks())

    def is_busy_beside(self, key: str) -> bool:
        """Whether the user waits for a task that has another key."""
        return any(not task.quiet and task.key != key for task in self._unfinished_tasks())

    @property
    def active(self) -> bool:
        """Whether any task is running or queued."""
        return bool(self._unfinished_tasks())

    def run(
        self,
        title: str,
        work: Callable[[Progress], Any],
        done: Callable[[Any], None],
        *,
        quiet: bool = False,
        key: str = "",
        persistent: bool = False,
        modal: bool = False,
        has_time_left: bool = True,
    ) -> Task:
        """Queue a task for the worker; ``done`` receives its value on the GUI thread."""
        task = Task(title, work, done, quiet, key, persistent, modal, has_time_left)
        for other in self._unfinished_tasks():
            replaced = key and other.key == key
            superseded = other.quiet and not quiet
            if replaced or superseded:
                other.superseded = True
                other.cancel.set()
        self._waiting = [other for other in self._waiting if not other.cancel.is_set()]
        self._waiting.append(task)
        self._start_next()
        return task

    def is_unfinished(self, task: Task) -> bool:
        """Whether a task is running or queued, and was not cancelled."""
        return not task.cancel.is_set() and any(task is own for own in self._unfinished_tasks())

    def cancel(self) -> None:
        """Cancel the running and the queued tasks."""
        for task in self._unfinished_tasks():
            task.cancel.set()
        self._waiting = []
        self.changed.emit()

    def close(self) -> None:
        """Cancel all tasks and wait until the worker has ended."""
        self._closed = True
        self.cancel()
        self._timer.stop()
        if self._worker is not None:
            self._inbox.put(None)
            self._worker.join()
            self._worker = None
        self.current = None

    def _unfinished_tasks(self) -> list[Task]:
        return [*([self.current] if self.current else []), *self._waiting]

    def _start_next(self) -> None:
        if self.current is not None or self._closed:
            return
        if not self._waiting:
            self.idle.emit()
            return
        if self._worker is None:
            self._worker = threading.Thread(target=self._run_worker, name="lispac-worker")
            self._worker.start()
        self.current = self._waiting.pop(0)
        self.current.started = time.monotonic()
        self._inbox.put(self.current)
        self._timer.start()
        self.changed.emit()

    def _run_worker(self) -> None:
        memory = MemoryTrimming()
        while (task := self._inbox.get()) is not None:
            try:
                task.report(0.0)
                task.value = task.work(task.report)
            except BaseException as error:  # noqa: BLE001, RUF100 - handed to the GUI thread whole
                task.error = error
            self._ended.emit()
            memory.trim_if_due()

    def _finish_task(self) -> None:
        if self.current is None or self._closed:
            return
        if self.current.modal and QApplication.activeModalWidget() is not None:
            QTimer.singleShot(REFRESH_INTERVAL_MS, self, self._finish_task)
            return
        task, self.current = self.current, None
        self._timer.stop()
        try:
            wrote = task.persistent and task.error is None
            if (task.cancel.is_set() and not wrote) or isinstance(task.error, Cancelled):
                if not task.quiet and not task.superseded:
                    self.stopped.emit(task.title)
            elif task.error is not None:
                self.changed.emit()  # no task runs while the error is shown
                self.failed.emit(task.error)
            else:
                if task.cancel.is_set():
                    self.cancelled_too_late.emit(
                        gettext("{task}: completed before it could be cancelled", task=task.title)
                    )
                if task.modal:
                    self.changed.emit()
                task.done(task.value)
        finally:
            self.changed.emit()
            task.clear_data()
            self._start_next()


def _ignore(_ignored: object) -> None:
    """Replacement for the functions of an ended task."""


def preload_matplotlib() -> None:
    """Import Matplotlib, which takes half a second; called in the worker."""
    import lispac.report.distance_profiles  # noqa: F401
    import lispac.report.histograms  # noqa: F401
