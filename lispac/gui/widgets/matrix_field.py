"""A text field for a matrix of four rows, in a font of fixed width."""

from PySide6.QtGui import QFontDatabase
from PySide6.QtWidgets import QPlainTextEdit

ROWS = 4
TEXT_PIXELS = 11


class MatrixField(QPlainTextEdit):
    """Shows a matrix, or accepts a typed or pasted one; Tab moves to the next field."""

    def __init__(self, name: str, accessible_name: str, *, read_only: bool = False) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setAccessibleName(accessible_name)
        self.setReadOnly(read_only)
        self.setTabChangesFocus(True)
        self.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        font = QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont)
        font.setPixelSize(TEXT_PIXELS)
        self.setFont(font)
        self.setFixedHeight(ROWS * self.fontMetrics().lineSpacing() + 14)
