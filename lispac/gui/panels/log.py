"""What happened, line by line."""

from datetime import datetime

from PySide6.QtGui import QFontDatabase
from PySide6.QtWidgets import QPlainTextEdit

from lispac.gui.language import say, say_with_capital

MOST_LINES = 2000
EMPTY = "What the program does, takes for granted and cannot do is noted here, with the time."


class LogPanel(QPlainTextEdit):
    """Notes of the program with their time, to read and to copy."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("log")
        self.setAccessibleName(say("Log"))
        self.setReadOnly(True)
        self.setPlaceholderText(say(EMPTY))
        self.setMaximumBlockCount(MOST_LINES)
        self.setFont(QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont))
        self.setFrameShape(QPlainTextEdit.Shape.NoFrame)

    def take_over(self, former: "LogPanel") -> None:
        """Begin with what another one says, for a window made anew."""
        self.setPlainText(former.toPlainText())

    def note(self, text: str) -> None:
        """Add a line."""
        self.appendPlainText(f"{datetime.now():%H:%M:%S}  {say_with_capital(text)}")
