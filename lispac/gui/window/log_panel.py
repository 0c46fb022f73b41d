"""The log of the program."""

from datetime import datetime

from PySide6.QtGui import QFontDatabase
from PySide6.QtWidgets import QPlainTextEdit

from lispac.language import N_, gettext

MAX_LINES = 2000
EMPTY = N_("Actions, assumptions and errors of the program are listed here with their time.")


class LogPanel(QPlainTextEdit):
    """Log messages with their times."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("log")
        self.setAccessibleName(gettext("Log"))
        self.setReadOnly(True)
        self.setPlaceholderText(gettext(EMPTY))
        self.setMaximumBlockCount(MAX_LINES)
        self.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.setFrameShape(QPlainTextEdit.Shape.NoFrame)

    def copy_state_from(self, former: "LogPanel") -> None:
        """Copy the messages of the log of a former window."""
        self.setPlainText(former.toPlainText())

    def note(self, text: str) -> None:
        """Add a line."""
        self.appendPlainText(f"{datetime.now():%H:%M:%S}  {text}")
