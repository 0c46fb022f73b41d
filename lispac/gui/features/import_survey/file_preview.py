"""Table with the first rows of a file, and lists for the meanings of text columns."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QAbstractItemView, QTableWidget, QTableWidgetItem

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.language import gettext
from lispac.workflow.importing.input_columns import (
    PASSED_OVER,
    has_columns,
    meaning_label,
    possible_meanings,
)
from lispac.workflow.importing.input_file import InputFile

NAMED_FORMATS = ("las", "e57")
"""Formats whose files name their columns; these names are not translated."""
MAX_COLUMNS = 60
MIN_MAPPED_WIDTH = 118
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


class FilePreview(QTableWidget):
    """Rows as text; for text files, the first row has a list for the meaning of each column."""

    meaning_chosen = Signal(int, str)
    """Column and its meaning."""

    def __init__(self) -> None:
        super().__init__(0, 0)
        self.setObjectName("import_preview")
        self.setAccessibleName(gettext("First rows of the file"))
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(24)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        self.setTabKeyNavigation(False)
        self.horizontalHeader().setHighlightSections(False)
        self.horizontalHeader().setDefaultAlignment(_RIGHT)
        self._shown: tuple[object, ...] = ()
        self.combos: list[widgets.ChoiceBox] = []

    def show_file(self, file: InputFile) -> None:
        """Show the first rows of a file."""
        rows = () if file.finding is None else file.finding.rows
        columns = min(max((len(row) for row in rows), default=0), MAX_COLUMNS)
        mapped = file.format is not None and file.role is not None and has_columns(file.format)
        which = (file.path, file.format, rows, mapped)
        if which != self._shown:
            self._shown = which
            self._build(file, rows, columns, mapped)
        for k, combo in enumerate(self.combos):
            chosen = file.columns[k] if k < len(file.columns) else PASSED_OVER
            combo.blockSignals(True)
            if combo.findData(chosen) < 0:
                combo.addItem(chosen, chosen)
            combo.setCurrentIndex(combo.findData(chosen))
            combo.blockSignals(False)

    def _build(self, file: InputFile, rows, columns: int, mapped: bool) -> None:
        self.clear()
        self.combos = []
        first = 1 if mapped else 0
        self.setRowCount(first + max(len(rows) - 1, 0))
        self.setColumnCount(columns)
        names = list(rows[0][:columns]) if rows else []
        if mapped:
            heads = [gettext("Column {number:n}", number=k + 1) for k in range(columns)]
        elif file.format is not None and file.format.key in NAMED_FORMATS:
            heads = names
        else:
            heads = list(map(gettext, names))
        self.setHorizontalHeaderLabels(heads + [""] * (columns - len(heads)))
        for k in range(columns if mapped else 0):
            self._add_combo(file, k)
        for row, cells in enumerate(rows[1:]):
            for column, text in enumerate(cells[:columns]):
                item = QTableWidgetItem(text)
                item.setTextAlignment(_RIGHT)
                item.setFont(theme.tabular_font(self.font()))
                self.setItem(first + row, column, item)
        if self.rowCount():
            self.setRowHeight(0, 30 if mapped else 24)
        self.resizeColumnsToContents()
        for k in range(columns):
            width = self.columnWidth(k) + 10
            self.setColumnWidth(k, max(width, MIN_MAPPED_WIDTH) if mapped else width)

    def _add_combo(self, file: InputFile, column: int) -> None:
        assert file.format is not None
        combo = widgets.ChoiceBox(f"column_{column + 1}", [""], gettext("Meaning of this column"))
        combo.clear()
        for meaning in possible_meanings(file.format):
            combo.addItem(gettext(meaning_label(meaning)), meaning)
        combo.setAccessibleName(gettext("Meaning of column {number:n}", number=column + 1))
        combo.setItemData(0, QColor(theme.MUTED), Qt.ItemDataRole.ForegroundRole)
        combo.activated.connect(lambda: self.meaning_chosen.emit(column, combo.currentData()))
        self.setCellWidget(0, column, combo)
        self.combos.append(combo)
