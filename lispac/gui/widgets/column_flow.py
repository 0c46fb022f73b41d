"""Blocks in as many columns as fit into the width."""

from collections.abc import Mapping, Sequence

from PySide6.QtCore import QSize
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QVBoxLayout, QWidget

COLUMN_SPACING_PX = 24
MIN_COLUMN_WIDTH_PX = 300
Arrangement = Sequence[Sequence[str]]
"""Names of the blocks of each column, from top to bottom."""


class ColumnFlow(QWidget):
    """Blocks in columns; the number of columns follows the width.

    Parameters
    ----------
    blocks : widgets by name
    arrangements : arrangements of the blocks with one column, two columns and so on
    """

    def __init__(self, blocks: Mapping[str, QWidget], arrangements: Sequence[Arrangement]) -> None:
        super().__init__()
        self._blocks, self._arrangements = blocks, arrangements
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(COLUMN_SPACING_PX)
        self._columns: list[QVBoxLayout] = []
        for _ in arrangements[-1]:
            column = QVBoxLayout()
            column.setContentsMargins(0, 0, 0, 0)
            row.addLayout(column, 1)
            self._columns.append(column)
        self._arrangement: Arrangement = ()
        self._arrange(arrangements[0])

    def minimumSizeHint(self) -> QSize:
        """Smallest size: that of the widest block, in pixels."""
        widths = [block.minimumSizeHint().width() for block in self._blocks.values()]
        return QSize(max(widths), super().minimumSizeHint().height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Choose the largest number of columns whose blocks fit."""
        super().resizeEvent(event)
        fitting = [each for each in self._arrangements if self._fits(each, event.size().width())]
        self._arrange(fitting[-1] if fitting else self._arrangements[0])

    def _fits(self, arrangement: Arrangement, width: int) -> bool:
        """Whether equally wide columns are wide enough for their blocks."""
        count = len(arrangement)
        column = (width - (count - 1) * COLUMN_SPACING_PX) / count
        return column >= max(MIN_COLUMN_WIDTH_PX, self.minimumSizeHint().width())

    def _arrange(self, arrangement: Arrangement) -> None:
        if arrangement == self._arrangement:
            return
        self._arrangement = arrangement
        for column in self._columns:
            # `takeAt` would keep the item of a block alive, and the next one a height that is not
            # updated when a text in the block changes.
            for block in self._blocks.values():
                column.removeWidget(block)
            while column.count():
                column.takeAt(0)  # the stretch
        for k, column in enumerate(self._columns):
            names = arrangement[k] if k < len(arrangement) else ()
            self.layout().setStretch(k, 1 if names else 0)
            for name in names:
                column.addWidget(self._blocks[name])
            if names:
                column.addStretch(1)
