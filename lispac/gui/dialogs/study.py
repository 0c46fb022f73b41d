"""What a study found: a table, sentences, a plot where there is one, and both to copy."""

from collections.abc import Sequence

from PySide6.QtCore import QSize
from PySide6.QtGui import QGuiApplication, QShowEvent
from PySide6.QtWidgets import QDialog, QHBoxLayout, QVBoxLayout, QWidget

from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.diagnostics_table import DiagnosticsTable, Row

HEAD, ROW, MOST_SHOWN = 64, 24, 10
"""Pixels of the table's headings and of a row, and rows shown at the least."""
OFF_THE_EDGE = 40
"""Pixels of the screen that are left beside the dialogue."""
TABLE_AT_LEAST, PLOT_AT_LEAST = HEAD + 3 * ROW, 180
"""Pixels, on a screen too low for all of it."""


class StudyDialog(QDialog):
    """Shown until it is closed; nothing in it changes the project.

    Parameters
    ----------
    name : of the dialogue, for its widgets
    """

    def __init__(
        self, name: str, title: str, words: str, table: DiagnosticsTable, parent: QWidget | None
    ) -> None:
        super().__init__(parent)
        self.setObjectName(f"{name}_dialog")
        self.setWindowTitle(say(title))
        self.table = table
        self.body: QVBoxLayout = widgets.column(self, 16)
        self.body.addWidget(widgets.label(words, wrap=True))
        self.body.addWidget(table, 1)
        self.said = widgets.label("", wrap=True, name=f"{name}_said")
        self.body.addWidget(self.said)
        self.canvas: QWidget | None = None
        self.copy_numbers = widgets.button(
            "Copy numbers", f"{name}_numbers", tip="Copy the table for a spreadsheet"
        )
        self.copy_numbers.clicked.connect(
            lambda: QGuiApplication.clipboard().setText(self.numbers())
        )
        self.copy_picture = widgets.button(
            "Copy picture", f"{name}_picture", tip="Copy the plot as it is shown"
        )
        self.copy_picture.clicked.connect(self._copy_picture)
        self.copy_picture.hide()
        close = widgets.button("Close", f"{name}_close", primary=True)
        close.setDefault(True)
        close.clicked.connect(self.accept)
        row = QHBoxLayout()
        row.addWidget(self.copy_numbers)
        row.addWidget(self.copy_picture)
        row.addStretch(1)
        row.addWidget(close)
        self._buttons = row
        self.body.addLayout(row)

    @property
    def room(self) -> QSize:
        """What the screen has for it, pixels."""
        return self.screen().availableGeometry().size() - QSize(OFF_THE_EDGE, OFF_THE_EDGE)

    def show_rows(self, rows: Sequence[Row]) -> None:
        """Show rows in the table, all of them where they are few."""
        self.table.show_rows(rows)
        self.table.setMinimumHeight(HEAD + ROW * min(len(rows), MOST_SHOWN))
        if self.isVisible():
            self._widen()

    def showEvent(self, event: QShowEvent) -> None:
        """Find room for the table, on the screen that there is."""
        super().showEvent(event)
        self._widen()
        self._lower()

    def _widen(self) -> None:
        """As wide as the table, where the screen is: else its last column would be cut off."""
        around, header = self.body.contentsMargins(), self.table.horizontalHeader()
        frame = 2 * self.table.frameWidth() + self.table.verticalScrollBar().sizeHint().width()
        # Sections have not yet the width they get, and the last is stretched to what there is
        wanted = sum(
            max(header.sectionSizeHint(column), self.table.sizeHintForColumn(column)) + 1
            for column in range(header.count())
        )
        wanted += frame + around.left() + around.right()
        wanted = min(wanted, self.room.width())
        if wanted > self.width():
            self.resize(wanted, self.height())

    def _lower(self) -> None:
        """No higher than the screen: else the buttons would be below its edge."""
        room = self.room.height()
        parts = [(self.table, TABLE_AT_LEAST)]
        if self.canvas is not None:
            parts.insert(0, (self.canvas, PLOT_AT_LEAST))
        for part, least in parts:
            excess = self.body.minimumHeightForWidth(self.width()) - room
            if excess > 0:
                part.setMinimumHeight(max(least, part.minimumHeight() - excess))
                self.body.invalidate()
        # Qt would take the words for as many lines as they have where the dialogue is narrowest
        self.setMinimumHeight(min(self.body.minimumHeightForWidth(self.width()), room))
        if self.height() > room:
            self.resize(self.width(), room)

    def numbers(self) -> str:
        """What is copied for a spreadsheet."""
        return self.table.as_text()

    def figure(self):
        """The figure of the plot, which stands below the table."""
        if self.canvas is None:
            from lispac.gui.panels.chart import Chart

            self.canvas = Chart(560, 340)
            self.body.insertWidget(self.body.indexOf(self._buttons), self.canvas, 2)
            self.copy_picture.show()
        return self.canvas.figure

    def _copy_picture(self) -> None:
        if self.canvas is not None:
            QGuiApplication.clipboard().setPixmap(self.canvas.picture())
