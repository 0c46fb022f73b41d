"""Desktop notifications that a long task has ended, while another window is in use."""

import time
from collections.abc import Callable

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QApplication, QMainWindow, QSystemTrayIcon

from lispac.gui.app.tasks import Task, TaskRunner
from lispac.gui.appearance import theme
from lispac.language import N_, duration_text, gettext

MIN_TASK_S = 10.0
"""Shortest task, seconds, whose end is notified."""


class DesktopNotifications(QObject):
    """Notifies the user when a long task of a runner has ended.

    Parameters
    ----------
    show : function that shows a text outside the window; by default a desktop notification
    """

    def __init__(
        self,
        window: QMainWindow,
        runner: TaskRunner,
        show: Callable[[str], None] | None = None,
    ) -> None:
        super().__init__(window)
        self._window, self._runner = window, runner
        self._show = show or self._notify
        self._task: Task | None = None
        self._tray: QSystemTrayIcon | None = None
        runner.changed.connect(self._on_tasks_changed)

    def _on_tasks_changed(self) -> None:
        ended, self._task = self._task, self._runner.current
        if ended is None or ended is self._task or ended.quiet or ended.cancel.is_set():
            return
        duration = time.monotonic() - ended.started
        if duration >= MIN_TASK_S and not self._window.isActiveWindow():
            if ended.error is None:
                template = N_("{task}: completed after {time}")
            else:
                template = N_("{task}: failed after {time}")
            self._show(gettext(template, task=ended.title, time=duration_text(duration)))

    def _notify(self, text: str) -> None:
        QApplication.alert(self._window)  # highlights the window's entry in the task bar
        if QSystemTrayIcon.isSystemTrayAvailable() and QSystemTrayIcon.supportsMessages():
            if self._tray is None:
                self._tray = QSystemTrayIcon(theme.icon("ferry"), self)
                self._tray.messageClicked.connect(self._window.activateWindow)
            self._tray.show()
            self._tray.showMessage("LISPAC", text)
