"""Progress, time left and Cancel of the running task, and the last note."""

import re
import time

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QLabel, QProgressBar, QStatusBar

from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.warnings import WarningsButton
from lispac.gui.tasks import Task
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
            self.text.setText(say(f"{task.title}: stopping …"))
        else:
            self.text.setText(_words(task))
        self.bar.setValue(round(task.fraction * 1000))
        self.cancel.setEnabled(not task.cancel.is_set())


LEFT = re.compile(r", [^,]+ left$")
"""Time left as work says it of its own step: of the line that is read, say."""


def _words(task: Task) -> str:
    """What is done and what is left, each said by itself: what is done may end with any name."""
    words = task.message or task.title
    elapsed = time.monotonic() - task.started
    left = task.seconds_left()
    if left is None or elapsed <= 1.0:
        return say(words)
    if LEFT.search(words):  # it says its rate as well; what is left counts for all of the task
        return f"{say(LEFT.sub('', words))}  ·  {say(f'{spoken(left)} left')}"
    rate = 100 * task.fraction / elapsed
    return f"{say(words)}  ·  {say(f'{rate:.0f} %/s, {spoken(left)} left')}"
