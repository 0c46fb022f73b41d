"""Progress, time left and Cancel of the running task, and the last note."""

import time

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QLabel, QProgressBar, QStatusBar

from lispac.gui.panels import widgets
from lispac.gui.tasks import Task

QUIET_FOR = 0.3
"""Seconds a quiet task may take before it is shown."""


class TaskBar(QStatusBar):
    """The window's status bar."""

    cancel_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setSizeGripEnabled(False)
        self.text = QLabel()
        self.text.setObjectName("task_text")
        self.bar = QProgressBar()
        self.bar.setObjectName("task_progress")
        self.bar.setRange(0, 1000)
        self.bar.setFixedWidth(200)
        self.cancel = widgets.button("Cancel", "cancel_task", tip="Stop; nothing is changed")
        self.cancel.setStyleSheet("padding: 1px 10px;")
        self.cancel.clicked.connect(self.cancel_asked)
        self._parts = (self.text, self.bar, self.cancel)
        for each in self._parts:
            self.addPermanentWidget(each)
            each.hide()

    def show_task(self, task: Task | None) -> None:
        """Show how far the running task is; None where none runs."""
        shown = task is not None and not (
            task.quiet and time.monotonic() - task.started < QUIET_FOR
        )
        for each in self._parts:
            each.setVisible(shown)
        if task is None or not shown:
            return
        if task.cancel.is_set():
            self.text.setText(f"{task.title}: stopping …")
        else:
            self.text.setText(_words(task))
        self.bar.setValue(round(task.fraction * 1000))
        self.cancel.setEnabled(not task.cancel.is_set())


def _words(task: Task) -> str:
    words = task.message or task.title
    elapsed = time.monotonic() - task.started
    left = task.seconds_left()
    if left is not None and elapsed > 1.0:
        rate = 100 * task.fraction / elapsed
        words += f"  ·  {rate:.0f} %/s, {spoken(left)} left"
    return words


def spoken(seconds: float) -> str:
    """A duration as one says it: ``3 s``, ``2 min 10 s``."""
    whole = max(1, round(seconds))
    return f"{whole} s" if whole < 60 else f"{whole // 60} min {whole % 60:02d} s"
