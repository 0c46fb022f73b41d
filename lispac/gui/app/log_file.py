"""Log file of the program, since a program without a console cannot print.

The log file contains the notes and errors that the window shows, unexpected errors with their
traceback, and warnings of libraries and of Qt. A second file contains the traceback of a crash.
"""

import faulthandler
import logging
import sys
import threading
from collections.abc import Callable
from logging.handlers import RotatingFileHandler
from pathlib import Path
from types import TracebackType
from typing import Any

from PySide6.QtCore import QMessageLogContext, QtMsgType, qInstallMessageHandler

LOGGER = logging.getLogger("lispac")
LOG_NAME, CRASH_LOG_NAME = "lispac.log", "lispac-crash.log"
MAX_LOG_BYTES, OLD_LOG_FILES_KEPT = 1_000_000, 3
"""Largest size of the log file, bytes, and number of older files that are kept."""
_LEVEL_OF_QT_TYPE = {
    QtMsgType.QtDebugMsg: logging.DEBUG, QtMsgType.QtInfoMsg: logging.INFO,
    QtMsgType.QtWarningMsg: logging.WARNING, QtMsgType.QtCriticalMsg: logging.ERROR,
    QtMsgType.QtFatalMsg: logging.CRITICAL,
}  # fmt: skip


class LogFile:
    """Writes the log file between `begin` and `end`.

    Parameters
    ----------
    folder : folder of the log files
    on_uncaught : function that logs an uncaught exception and shows it to the user
    """

    def __init__(self, folder: Path, on_uncaught: Callable[[BaseException], None]) -> None:
        self.file = folder / LOG_NAME
        self._on_uncaught = on_uncaught
        self._handler: logging.Handler | None = None
        self._crash: Any = None

    def begin(self) -> None:
        """Open the log file; without write access the program runs without it."""
        try:
            self.file.parent.mkdir(parents=True, exist_ok=True)
            self._handler = RotatingFileHandler(
                self.file,
                maxBytes=MAX_LOG_BYTES,
                backupCount=OLD_LOG_FILES_KEPT,
                encoding="utf-8",
                delay=False,
            )
            self._crash = (self.file.with_name(CRASH_LOG_NAME)).open("w", encoding="utf-8")
        except OSError:
            self._handler = logging.NullHandler()
        self._handler.setFormatter(logging.Formatter("%(asctime)s %(levelname)s %(message)s"))
        for logger in (LOGGER, logging.getLogger("py.warnings")):
            logger.addHandler(self._handler)
        LOGGER.setLevel(logging.INFO)
        logging.captureWarnings(True)
        if self._crash is not None:
            faulthandler.enable(self._crash)
        qInstallMessageHandler(_log_qt_message)
        sys.excepthook = self._report_uncaught
        threading.excepthook = lambda details: self._report_uncaught(
            details.exc_type, details.exc_value, details.exc_traceback
        )

    def end(self) -> None:
        """Close the log file and remove all handlers."""
        sys.excepthook, threading.excepthook = sys.__excepthook__, threading.__excepthook__
        qInstallMessageHandler(None)
        logging.captureWarnings(False)
        for logger in (LOGGER, logging.getLogger("py.warnings")):
            logger.removeHandler(self._handler)
        self._handler.close()
        if self._crash is not None:
            faulthandler.disable()
            self._crash.close()

    def _report_uncaught(
        self,
        _kind: type[BaseException],
        error: BaseException | None,
        _trace: TracebackType | None,
    ) -> None:
        if error is not None:
            self._on_uncaught(error)


def _log_qt_message(kind: QtMsgType, _context: QMessageLogContext, text: str) -> None:
    LOGGER.log(_LEVEL_OF_QT_TYPE[kind], "Qt: %s", text)
