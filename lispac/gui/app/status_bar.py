"""Status bar: progress and time left of the running task, its Cancel button, the last note."""

import time

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QPainter, QPaintEvent
from PySide6.QtWidgets import QLabel, QProgressBar, QSizePolicy, QStatusBar

from lispac.gui import widgets
from lispac.gui.app.tasks import Task
from lispac.language import duration_text, gettext
from lispac.progress import PointProgress

SHOW_DELAY_S = 0.3
"""Seconds after which a quiet task is shown."""


class TaskStatusBar(QStatusBar):
    """Status bar of the window.

    Parameters
    ----------
    is_narrow : whether a running task must not widen the window, so that its text may be elided
    """

    cancel_requested = Signal()

    def __init__(self, *, is_narrow: bool = False) -> None:
        super().__init__()
        self.setSizeGripEnabled(False)
        self.text = _FieldsLabel() if is_narrow else QLabel()
        self.text.setTextFormat(Qt.TextFormat.PlainText)
        self.text.setObjectName("task_text")
        self.bar = QProgressBar()
        self.bar.setObjectName("task_progress")
        self.bar.setRange(0, 1000)
        self.bar.setFixedWidth(100 if is_narrow else 200)
        self.cancel = widgets.button(
            gettext("Cancel"),
            "cancel_task",
            tip=gettext("Cancel the running task; the project stays unchanged"),
        )
        self.cancel.setStyleSheet("padding: 1px 10px;")
        self.cancel.clicked.connect(self.cancel_requested)
        self.point = _FieldsLabel()
        self.point.setObjectName("point_values")
        self.point.setContentsMargins(6, 0, 6, 0)
        self.addWidget(self.point, 1)
        # Qt shows the widget again, over the message, when the height of the bar changes.
        self.messageChanged.connect(lambda message: self.point.setVisible(not message))
        self._parts = (self.text, self.bar, self.cancel)
        for each in self._parts:
            self.addPermanentWidget(each, 2 if is_narrow and each is self.text else 0)
            each.hide()

    def show_task(self, task: Task | None) -> None:
        """Show the progress of the running task; None if none runs."""
        shown = task is not None and not (
            task.quiet and time.monotonic() - task.started < SHOW_DELAY_S
        )
        for each in self._parts:
            each.setVisible(shown)
        if task is None or not shown:
            return
        if task.cancel.is_set():
            self.text.setText(gettext("{task}: stopping…", task=task.title))
        else:
            self.text.setText(_progress_text(task))
        # Setting the value paints at once: without the layout, the new text would be cut
        self.layout().activate()
        self.bar.setValue(round(task.fraction * 1000))
        self.cancel.setEnabled(not task.cancel.is_set())


FIELD_SEPARATOR = "  ·  "
"""Text between the fields of a line of the status bar."""


class _FieldsLabel(QLabel):
    """Label that omits the last fields of its text instead of widening the window."""

    def __init__(self) -> None:
        super().__init__()
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setSizePolicy(QSizePolicy.Policy.Ignored, QSizePolicy.Policy.Preferred)

    @property
    def shown_text(self) -> str:
        """The fields that fit, or the beginning of the first one."""
        width, metrics = self.contentsRect().width(), self.fontMetrics()
        fields = self.text().split(FIELD_SEPARATOR)
        while len(fields) > 1 and metrics.horizontalAdvance(FIELD_SEPARATOR.join(fields)) > width:
            del fields[-1]
        return metrics.elidedText(FIELD_SEPARATOR.join(fields), Qt.TextElideMode.ElideRight, width)

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the fields that fit."""
        flags = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        QPainter(self).drawText(self.contentsRect(), flags, self.shown_text)


def _progress_text(task: Task) -> str:
    """Text of a task: its step, and the time left once it is known."""
    step = task.title if task.step is None else task.step
    text = step.without_time_left() if isinstance(step, PointProgress) else str(step)
    left = task.seconds_left()
    if left is None:
        return text
    return FIELD_SEPARATOR.join((text, gettext("{time} left", time=duration_text(left))))
