"""The angles of one program as a table."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QTableWidget, QTableWidgetItem

from lispac.gui import theme
from lispac.survey.conventions.systems import Convention

_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_ROW = 25
Row = tuple[str, np.ndarray, str, bool]
"""Word at the left, angles in radians, format of the sign, bold."""


def angles_table() -> QTableWidget:
    """An empty table for three angles."""
    table = QTableWidget(1, 3)
    table.setObjectName("convention_table")
    table.setAccessibleName("Angles in the other program")
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setSelectionMode(QAbstractItemView.SelectionMode.ContiguousSelection)
    for policy in (table.setVerticalScrollBarPolicy, table.setHorizontalScrollBarPolicy):
        policy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    side = table.verticalHeader()
    side.setDefaultSectionSize(_ROW)
    side.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
    side.setMinimumWidth(96)
    side.setHighlightSections(False)
    head = table.horizontalHeader()
    head.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
    head.setHighlightSections(False)
    return table


def fill_angles(
    table: QTableWidget,
    convention: Convention,
    rows: Sequence[Row],
    decimals: int,
) -> None:
    """Name the columns as the program does and write the rows in degrees."""
    table.setRowCount(len(rows))
    table.setHorizontalHeaderLabels([name.capitalize() for name in convention.names])
    table.setVerticalHeaderLabels([word for word, *_ in rows])
    table.setFixedHeight(table.horizontalHeader().sizeHint().height() + _ROW * len(rows) + 3)
    for column, turn in enumerate(convention.turns):
        table.horizontalHeaderItem(column).setTextAlignment(_RIGHT)
        table.horizontalHeaderItem(column).setToolTip(turn.meaning.capitalize())
    for row, (_, values, sign, bold) in enumerate(rows):
        for column, value in enumerate(np.round(np.degrees(values), decimals)):
            item = QTableWidgetItem(f"{value + 0.0:{sign}.{decimals}f}".replace("-", "−"))
            item.setTextAlignment(_RIGHT)
            item.setFont(theme.tabular(table.font(), bold=bold))
            table.setItem(row, column, item)
