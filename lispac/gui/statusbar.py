"""Status bar: progress and time left of the running task, its Cancel button, the last note."""

import re
import time

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QLabel, QProgressBar, QStatusBar

from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.warnings import WarningsButton
from lispac.gui.tasks import Task
from lispac.language import gettext
from lispac.survey.store.pace import spoken

QUIET_FOR = 0.3
"""Seconds a quiet task may take before it is shown."""


class TaskBar(QStatusBar):
    """The window's status bar."""

    cancel_asked = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.setSizeGripEnabled(False)
        self.warnings = WarningsButton()
        self.addPermanentWidget(self.warnings)
        self.warnings.hide()
        self.text = QLabel()
        self.text.setTextFormat(Qt.TextFormat.PlainText)
        self.text.setObjectName("task_text")
        self.bar = QProgressBar()
        self.bar.setObjectName("task_progress")
        self.bar.setRange(0, 1000)
        self.bar.setFixedWidth(200)
        self.cancel = widgets.button(
            gettext("Cancel"),
            "cancel_task",
            tip=gettext("Stop the running task; nothing is changed"),
        )
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
            self.text.setText(gettext("{task}: stopping…", task=say(task.title)))
        else:
            self.text.setText(_progress_text(task))
        self.bar.setValue(round(task.fraction * 1000))
        self.cancel.setEnabled(not task.cancel.is_set())


STEP_TIME_LEFT = re.compile(r", [^,]+ left$")
"""Time left for one step of a task, such as a line that is read, at the end of its message."""


def _progress_text(task: Task) -> str:
    """What the task does, its rate and the time left for all of it."""
    message = task.message or task.title
    elapsed = time.monotonic() - task.started
    left = task.seconds_left()
    if left is None or elapsed <= 1.0:
        return say(message)
    time_left = spoken(left)
    if STEP_TIME_LEFT.search(message):  # such a message has a rate as well
        return "  ·  ".join(
            (say(STEP_TIME_LEFT.sub("", message)), gettext("{time} left", time=time_left))
        )
    pace = gettext(
        "{rate:percent.0} %/s, {time} left", rate=task.fraction / elapsed, time=time_left
    )
    return f"{say(message)}  ·  {pace}"
