"""Table of numbers, sorted by value, with links from rows to targets and lines."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from PySide6.QtCore import QLocale, Qt, Signal
from PySide6.QtGui import QBrush, QColor
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
)

from lispac.gui import widgets
from lispac.gui.appearance import theme, units
from lispac.gui.appearance.units import Base
from lispac.gui.widgets.marked_cells import MarkedCells
from lispac.language import gettext

Key = tuple[str, str]
_ALIGNED_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_ALIGNED_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter


@dataclass(frozen=True)
class Column:
    """Heading and tooltip of a column."""

    title: str
    tip: str
    is_text: bool = False
    """Whether the column contains texts instead of numbers."""
    base: Base | None = None
    """Base unit of the numbers, if the user can choose another unit."""


@dataclass(frozen=True)
class Cell:
    """Text and sort value of a cell."""

    text: str
    value: float | None = None
    figure: tuple[str, float] | None = None
    """Format of the number, and factor from the unit of ``value`` to the column's base unit."""
    shown: str = ""
    """Text shown instead of `text`; a cell without a number is sorted by `text`."""
    colour: str = ""
    """Colour of the scheme in which the cell is highlighted, in bold."""


@dataclass(frozen=True)
class Row:
    """Cells of a row, with its target and line.

    Attributes
    ----------
    key : target and line of the row; line "" for the whole target; None without a link
    marked : whether the row is highlighted because it should be checked
    quality : quality whose icon is shown in the first column; empty without an icon
    current : whether the row is highlighted because it is the one in use, or the total
    """

    cells: Sequence[Cell]
    key: Key | None = None
    marked: bool = False
    tip: str = ""
    quality: str = ""
    current: bool = False


class _IndentedTexts(MarkedCells):
    """Delegate of a column of texts beside numbers aligned to the right, which it keeps apart."""

    def displayText(self, value: object, locale: QLocale | QLocale.Language) -> str:
        """Text with a space before it."""
        return "\N{EM SPACE}" + super().displayText(value, locale)


class _SortedItem(QTableWidgetItem):
    """Item that is sorted by its value, with unknown values last; texts alphabetically."""

    def __init__(self, cell: Cell, base: Base | None) -> None:
        if cell.figure is not None and cell.value is not None:
            form, scale = cell.figure
            value = cell.value * scale
            text = units.localised(
                f"{value:{form}}" if base is None else units.figure(value, base, form)
            )
        else:
            text = cell.shown or cell.text
        super().__init__(text.replace("-", "−") if cell.value is not None else text)
        self.cell = cell

    def __lt__(self, other: QTableWidgetItem) -> bool:
        mine, theirs = self.cell, other.cell
        if mine.value is None and theirs.value is None:
            return mine.text < theirs.text
        if mine.value is None or theirs.value is None:
            return theirs.value is None
        return mine.value < theirs.value


class DiagnosticsTable(QTableWidget):
    """Table sortable by any column; a double click or Enter emits `row_activated`."""

    row_activated = Signal(str, str)

    def __init__(self, name: str, title: str, columns: Sequence[Column]) -> None:
        super().__init__(0, len(columns))
        self.setTabKeyNavigation(False)
        self.setObjectName(name)
        self.setAccessibleName(title)
        self._columns = tuple(columns)
        self._rows: list[Row] = []
        # Units in a second line, so that the columns are narrow enough to be visible together.
        self.setHorizontalHeaderLabels(
            [_column_title(column).replace(" (", "\n(") for column in columns]
        )
        sorting = gettext("Click to sort")
        for k, column in enumerate(columns):
            head = self.horizontalHeaderItem(k)
            tip = _convert_units(column.tip, column)
            head.setToolTip(widgets.wrapped_tip(f"{tip}\n{sorting}"))
            head.setTextAlignment(_ALIGNED_LEFT if column.is_text else _ALIGNED_RIGHT)
        self.setItemDelegate(MarkedCells(self))
        for k, (before, column) in enumerate(pairwise(columns), start=1):
            if column.is_text and not before.is_text:
                self.setItemDelegateForColumn(k, _IndentedTexts(self))
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(24)
        self.setShowGrid(False)
        self.setProperty("rows", True)  # no focus frame around a single cell
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setWordWrap(False)
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        header.setSortIndicatorClearable(True)
        header.setSortIndicator(-1, Qt.SortOrder.AscendingOrder)
        self.setSortingEnabled(True)
        header.sortIndicatorChanged.connect(self._show_sort_arrow)
        self._show_sort_arrow(-1)
        self.activated.connect(lambda index: self._emit_row_activated(index.row()))

    def show_rows(self, rows: Sequence[Row]) -> None:
        """Show rows, sorted as before."""
        selected, header = self.key(self.currentRow()), self.horizontalHeader()
        self.setSortingEnabled(False)
        self._rows = list(rows)
        self.setRowCount(len(rows))
        font = theme.tabular_font(self.font())
        for number, row in enumerate(rows):
            for column, cell in enumerate(row.cells):
                item = _SortedItem(cell, self._columns[column].base)
                item.setData(Qt.ItemDataRole.UserRole, number)
                item.setTextAlignment(
                    _ALIGNED_LEFT if self._columns[column].is_text else _ALIGNED_RIGHT
                )
                item.setFont(font)
                if cell.colour:
                    item.setFont(theme.tabular_font(self.font(), bold=True))
                    item.setForeground(theme.colour(cell.colour))
                if row.quality and not column:
                    item.setIcon(theme.quality_icon(row.quality))
                if row.marked:
                    item.setBackground(QBrush(QColor(theme.WARNING_GROUND)))
                    item.setForeground(QBrush(QColor(theme.WARNING_TEXT)))
                if row.current:
                    item.setFont(theme.tabular_font(self.font(), bold=True))
                    item.setBackground(QBrush(QColor(theme.CURRENT)))
                if row.tip:
                    item.setToolTip(widgets.wrapped_tip(row.tip))
                self.setItem(number, column, item)
        for column in range(1, len(self._columns)):
            texts = (self.item(number, column).text() for number in range(len(rows)))
            self.setColumnHidden(column, bool(rows) and not any(texts))
        last = max(k for k in range(header.count()) if not header.isSectionHidden(k))
        header.setStretchLastSection(self._columns[last].is_text)
        header.setSortIndicatorShown(False)  # the arrow does not widen the columns
        header.resizeSections(QHeaderView.ResizeMode.ResizeToContents)
        self.setSortingEnabled(True)
        self._show_sort_arrow(header.sortIndicatorSection())
        if selected is not None:
            self.select(*selected)

    def as_text(self) -> str:
        """The table as text, with tabs between the columns for a spreadsheet."""
        heads = [_column_title(column).replace("\n", " ") for column in self._columns]
        rows = [
            [spreadsheet_number(self.item(row, column).text()) for column in range(len(heads))]
            for row in range(self.rowCount())
        ]
        return "".join("\t".join(row) + "\n" for row in [heads, *rows])

    def key(self, row: int) -> Key | None:
        """Target and line of a row."""
        item = self.item(row, 0)
        return None if item is None else self._rows[item.data(Qt.ItemDataRole.UserRole)].key

    @property
    def selected_row(self) -> int | None:
        """Index of the selected row in the rows shown, whatever the sorting; None without one."""
        rows = self.selectionModel().selectedRows()
        return self.item(rows[0].row(), 0).data(Qt.ItemDataRole.UserRole) if rows else None

    def select(self, target: str, line: str) -> None:
        """Select the row of a target and line without emitting a signal."""
        for row in range(self.rowCount()):
            if self.key(row) == (target, line):
                self.blockSignals(True)
                self.setCurrentCell(row, 0)
                self.blockSignals(False)
                return

    def _show_sort_arrow(self, section: int) -> None:
        """Show the sort arrow only while a column is sorted."""
        self.horizontalHeader().setSortIndicatorShown(section >= 0)

    def _emit_row_activated(self, row: int) -> None:
        key = self.key(row)
        if key is not None:
            self.row_activated.emit(*key)


def spreadsheet_number(text: str) -> str:
    """Text for a spreadsheet in the user's language, without thousands separators."""
    return text.replace("−", "-").replace("\N{NARROW NO-BREAK SPACE}", "")


def _column_title(column: Column) -> str:
    return _convert_units(column.title, column)


def _convert_units(text: str, column: Column) -> str:
    return (
        text if column.base is None else units.convert_unit_signs(text, column.base, figures=False)
    )


def number_cell(value: float | None, form: str, scale: float = 1.0) -> Cell:
    """Cell with a number, or with a dash for None."""
    if value is None:
        return Cell("–")
    return Cell(f"{value * scale:{form}}", float(value), figure=(form, scale))
