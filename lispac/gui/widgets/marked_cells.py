"""Cells of tables with a colour of their own, which a selected row keeps."""

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, Qt
from PySide6.QtGui import QBrush, QPalette
from PySide6.QtWidgets import QStyledItemDelegate, QStyleOptionViewItem


class MarkedCells(QStyledItemDelegate):
    """Delegate of a table whose coloured texts have their colour in selected rows too."""

    def initStyleOption(
        self, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        """Use the colour of the text, if it has one, for selected text."""
        super().initStyleOption(option, index)
        colour = index.data(Qt.ItemDataRole.ForegroundRole)
        if isinstance(colour, QBrush) and colour.style() != Qt.BrushStyle.NoBrush:
            option.palette.setBrush(QPalette.ColorRole.HighlightedText, colour)
