"""Base class of the dialogues with the result of a study: text, table and plot to copy."""

from collections.abc import Sequence

from PySide6.QtCore import QSize
from PySide6.QtGui import QGuiApplication, QShowEvent
from PySide6.QtWidgets import QDialog, QHBoxLayout, QVBoxLayout, QWidget

from lispac.gui import widgets
from lispac.gui.widgets.diagnostics_table import DiagnosticsTable, Row
from lispac.language import gettext

HEADER_HEIGHT_PX, ROW_HEIGHT_PX, MAX_ROWS = 64, 24, 10
"""Height of the table header and of a row, pixels, and limit of rows for the table height."""
SCREEN_MARGIN_PX = 40
"""Part of the width and of the height of the screen that a dialogue does not use, pixels."""
MIN_TABLE_HEIGHT_PX, MIN_PLOT_HEIGHT_PX = HEADER_HEIGHT_PX + 3 * ROW_HEIGHT_PX, 180
"""Smallest heights of table and plot on a small screen, pixels."""


class StudyDialog(QDialog):
    """Dialogue with a table and optional text and plot; it does not change the project.

    Parameters
    ----------
    name : name of the dialogue, used in the names of its widgets
    title, introduction : texts in the language of the user
    """

    def __init__(
        self,
        name: str,
        title: str,
        introduction: str,
        table: DiagnosticsTable,
        parent: QWidget | None,
    ) -> None:
        super().__init__(parent)
        self.setObjectName(f"{name}_dialog")
        self.setWindowTitle(title)
        self.table = table
        self.body: QVBoxLayout = widgets.vertical_layout(self, 16)
        self.body.addWidget(widgets.label(introduction, wrap=True))
        self.body.addWidget(table, 1)
        self.message_label = widgets.label("", wrap=True, name=f"{name}_message")
        self.body.addWidget(self.message_label)
        self.canvas: QWidget | None = None
        self.copy_numbers = widgets.button(
            gettext("Copy numbers"),
            f"{name}_numbers",
            tip=gettext("Copy the table to the clipboard for a spreadsheet"),
        )
        self.copy_numbers.clicked.connect(
            lambda: QGuiApplication.clipboard().setText(self.numbers())
        )
        self.copy_picture = widgets.button(
            gettext("Copy picture"),
            f"{name}_picture",
            tip=gettext("Copy the plot to the clipboard as displayed"),
        )
        self.copy_picture.clicked.connect(self._copy_picture)
        self.copy_picture.hide()
        close = widgets.button(gettext("Close"), f"{name}_close", primary=True)
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
    def available_size(self) -> QSize:
        """Size of the screen without its margin, pixels."""
        return self.screen().availableGeometry().size() - QSize(SCREEN_MARGIN_PX, SCREEN_MARGIN_PX)

    def show_rows(self, rows: Sequence[Row]) -> None:
        """Show rows in the table, whose height grows with their number up to a limit."""
        self.table.show_rows(rows)
        self.table.setMinimumHeight(HEADER_HEIGHT_PX + ROW_HEIGHT_PX * min(len(rows), MAX_ROWS))
        if self.isVisible():
            self._fit_width()

    def showEvent(self, event: QShowEvent) -> None:
        """Fit the dialogue to the table and to the screen."""
        super().showEvent(event)
        self._fit_width()
        self._fit_height()

    def _fit_width(self) -> None:
        """Widen the dialogue to the table, but not beyond the screen."""
        around, header = self.body.contentsMargins(), self.table.horizontalHeader()
        frame = 2 * self.table.frameWidth() + self.table.verticalScrollBar().sizeHint().width()
        # The sections do not have their final widths yet; the last one is stretched and not
        # narrower than the default.
        widths = [
            max(header.sectionSizeHint(column), self.table.sizeHintForColumn(column)) + 1
            for column in range(header.count())
        ]
        width = sum(widths[:-1]) + max(widths[-1], header.defaultSectionSize())
        width += frame + around.left() + around.right()
        width = min(width, self.available_size.width())
        if width > self.width():
            self.resize(width, self.height())

    def _fit_height(self) -> None:
        """Lower the dialogue to the height of the screen, so that its buttons are visible."""
        available = self.available_size.height()
        parts = [(self.table, MIN_TABLE_HEIGHT_PX)]
        if self.canvas is not None:
            parts.insert(0, (self.canvas, MIN_PLOT_HEIGHT_PX))
        for part, min_height in parts:
            excess = self.body.minimumHeightForWidth(self.width()) - available
            if excess > 0:
                part.setMinimumHeight(max(min_height, part.minimumHeight() - excess))
                self.body.invalidate()
        # The minimum of Qt assumes that texts are wrapped at the smallest width
        self.setMinimumHeight(min(self.body.minimumHeightForWidth(self.width()), available))
        if self.height() > available:
            self.resize(self.width(), available)

    def numbers(self) -> str:
        """Table as text for a spreadsheet."""
        return self.table.as_text()

    def figure(self):
        """The figure of the plot below the table."""
        if self.canvas is None:
            from lispac.gui.widgets.chart import Chart

            self.canvas = Chart(560, 340)
            self.body.insertWidget(self.body.indexOf(self._buttons), self.canvas, 2)
            self.copy_picture.show()
        return self.canvas.figure

    def _copy_picture(self) -> None:
        if self.canvas is not None:
            QGuiApplication.clipboard().setPixmap(self.canvas.picture())
