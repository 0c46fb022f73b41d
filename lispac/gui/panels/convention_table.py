"""The angles of one program as a table."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableWidget, QTableWidgetItem

from lispac.gui import theme
from lispac.gui.language import say, say_all
from lispac.survey.conventions.systems import Convention

_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_ROW = 25
Row = tuple[str, np.ndarray, str, bool]
"""Word at the left, angles in radians, format of the sign, bold."""


class AnglesTable(QTableWidget):
    """Three angles in a row; every digit can be read, by a scroll bar where they are many."""

    def __init__(self) -> None:
        super().__init__(1, 3)
        self.setTabKeyNavigation(False)
        self.setObjectName("convention_table")
        self.setAccessibleName(say("Angles in the other program"))
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ContiguousSelection)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        side = self.verticalHeader()
        side.setDefaultSectionSize(_ROW)
        side.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        side.setHighlightSections(False)
        head = self.horizontalHeader()
        head.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        head.setHighlightSections(False)

    def fill(self, convention: Convention, rows: Sequence[Row], decimals: int) -> None:
        """Name the columns as the program does and write the rows in degrees."""
        self.setRowCount(len(rows))
        self.setHorizontalHeaderLabels(say_all(name.capitalize() for name in convention.names))
        self.setVerticalHeaderLabels(say_all([word for word, *_ in rows]))
        for column, turn in enumerate(convention.turns):
            self.horizontalHeaderItem(column).setTextAlignment(_RIGHT)
            self.horizontalHeaderItem(column).setToolTip(say(turn.meaning.capitalize()))
        for row, (_, values, sign, bold) in enumerate(rows):
            for column, value in enumerate(np.round(np.degrees(values), decimals)):
                item = QTableWidgetItem(say(f"{value + 0.0:{sign}.{decimals}f}".replace("-", "−")))
                item.setTextAlignment(_RIGHT)
                item.setFont(theme.tabular(self.font(), bold=bold))
                self.setItem(row, column, item)
        self._lay_out()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Share the new width out among the columns."""
        super().resizeEvent(event)
        self._lay_out()

    def _lay_out(self) -> None:
        """Give each column what its numbers need, and share out what is left."""
        head = self.horizontalHeader()
        needed = [
            max(self.sizeHintForColumn(k), head.sectionSizeHint(k)) for k in range(head.count())
        ]
        inside = self.width() - 2 * self.frameWidth() - self.verticalHeader().sizeHint().width()
        spare, rest = divmod(max(inside - sum(needed), 0), len(needed))
        for column, width in enumerate(needed):
            self.setColumnWidth(column, width + spare + (column < rest))
        bar = self.horizontalScrollBar().sizeHint().height() if sum(needed) > inside else 0
        self.setFixedHeight(head.sizeHint().height() + _ROW * self.rowCount() + 3 + bar)
