"""Says that long work has ended, to one who has gone to another window meanwhile."""

import time
from collections.abc import Callable

from PySide6.QtCore import QObject
from PySide6.QtWidgets import QApplication, QMainWindow, QSystemTrayIcon

from lispac.gui import theme
from lispac.gui.language import say
from lispac.gui.tasks import Task, TaskRunner
from lispac.survey.store.pace import spoken

LONG = 10.0
"""Seconds after which nobody sits and waits."""


class Notifying(QObject):
    """Follows a runner.

    Parameters
    ----------
    tell : shows a sentence outside the window; the desktop's notification where it has one
    """

    def __init__(
        self,
        window: QMainWindow,
        runner: TaskRunner,
        tell: Callable[[str], None] | None = None,
    ) -> None:
        super().__init__(window)
        self._window, self._runner = window, runner
        self._tell = tell or self._notify
        self._task: Task | None = None
        self._tray: QSystemTrayIcon | None = None
        runner.changed.connect(self._follow)

    def _follow(self) -> None:
        ended, self._task = self._task, self._runner.current
        if ended is None or ended is self._task or ended.quiet or ended.cancel.is_set():
            return
        took = time.monotonic() - ended.started
        if took >= LONG and not self._window.isActiveWindow():
            how = "failed" if ended.error is not None else "done"
            self._tell(f"{ended.title}: {how} after {spoken(took)}")

    def _notify(self, words: str) -> None:
        QApplication.alert(self._window)  # the window's entry in the task bar asks to be looked at
        if QSystemTrayIcon.isSystemTrayAvailable() and QSystemTrayIcon.supportsMessages():
            if self._tray is None:
                self._tray = QSystemTrayIcon(theme.icon("ferry"), self)
                self._tray.messageClicked.connect(self._window.activateWindow)
            self._tray.show()
            self._tray.showMessage("LISPAC", say(words))
