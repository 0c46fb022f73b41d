"""The angles of one program as a table."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableWidget, QTableWidgetItem

from lispac.adjustment.display_text import capitalised
from lispac.gui.appearance import theme, units
from lispac.language import gettext
from lispac.survey.conventions.systems import Convention

_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_ROW_PX = 25
Row = tuple[str, np.ndarray, str, bool]
"""Title in the user's language, angles in radians, format of the sign, bold."""


class ConventionAnglesTable(QTableWidget):
    """Table of three angles, which scrolls if their digits need more space."""

    def __init__(self) -> None:
        super().__init__(1, 3)
        self.setTabKeyNavigation(False)
        self.setObjectName("convention_table")
        self.setAccessibleName(gettext("Angles in the other program"))
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ContiguousSelection)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        side = self.verticalHeader()
        side.setDefaultSectionSize(_ROW_PX)
        side.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        side.setHighlightSections(False)
        head = self.horizontalHeader()
        head.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        head.setHighlightSections(False)

    def fill(self, convention: Convention, rows: Sequence[Row], decimals: int) -> None:
        """Show the rows in degrees, with columns named as in the program."""
        self.setRowCount(len(rows))
        self.setHorizontalHeaderLabels([capitalised(gettext(name)) for name in convention.names])
        self.setVerticalHeaderLabels([title for title, *_ in rows])
        for column, turn in enumerate(convention.turns):
            self.horizontalHeaderItem(column).setTextAlignment(_RIGHT)
            self.horizontalHeaderItem(column).setToolTip(capitalised(gettext(turn.meaning)))
        for row, (_, values, sign, bold) in enumerate(rows):
            for column, value in enumerate(np.round(np.degrees(values), decimals)):
                item = QTableWidgetItem(units.localised(f"{value + 0.0:{sign}.{decimals}f}"))
                item.setTextAlignment(_RIGHT)
                item.setFont(theme.tabular_font(self.font(), bold=bold))
                self.setItem(row, column, item)
        self._set_column_widths()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Distribute the new width over the columns."""
        super().resizeEvent(event)
        self._set_column_widths()

    def _set_column_widths(self) -> None:
        """Give each column the width of its numbers, and distribute the rest."""
        head = self.horizontalHeader()
        needed = [
            max(self.sizeHintForColumn(k), head.sectionSizeHint(k)) for k in range(head.count())
        ]
        inside = self.width() - 2 * self.frameWidth() - self.verticalHeader().sizeHint().width()
        spare, rest = divmod(max(inside - sum(needed), 0), len(needed))
        for column, width in enumerate(needed):
            self.setColumnWidth(column, width + spare + (column < rest))
        bar = self.horizontalScrollBar().sizeHint().height() if sum(needed) > inside else 0
        self.setFixedHeight(head.sizeHint().height() + _ROW_PX * self.rowCount() + 3 + bar)
