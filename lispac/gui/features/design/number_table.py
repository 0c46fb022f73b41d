"""Editable table of numbers that reports invalid input during typing."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QHeaderView,
    QLineEdit,
    QStyledItemDelegate,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from lispac.errors import InputError
from lispac.gui.appearance import theme, units
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.appearance.units import Base
from lispac.gui.widgets.number_field import BASE_OF_SUFFIX
from lispac.gui.widgets.number_input import NumberEntry, PendingInput, parse_number
from lispac.language import gettext
from lispac.messages import Message, error


@dataclass(frozen=True)
class TableColumn:
    """Column of a table: name, title, unit and range.

    Attributes
    ----------
    title, tip : str
        English texts of the catalogue.
    unit : str
        Unit of the values, below the title; lengths are shown in the unit chosen by the user.
    low, high : float
        Range of the values.
    choices : tuple of str
        Values to choose from instead of typing, as texts of the catalogue.
    empty : str
        Meaning of an empty cell, a text of the catalogue; "" if a cell must not be empty.
    is_text : bool
        Whether the values are names.
    """

    name: str
    title: str
    tip: str
    unit: str = ""
    low: float = -math.inf
    high: float = math.inf
    decimals: int = 2
    choices: tuple[str, ...] = ()
    empty: str = ""
    is_text: bool = False

    @property
    def base(self) -> Base | None:
        """Base unit of lengths and speeds, which the settings convert; None for other values."""
        return BASE_OF_SUFFIX.get(" " + self.unit.removesuffix("/s"))

    @property
    def sign(self) -> str:
        """Symbol of the unit that is shown."""
        if self.base is None:
            return "°" if self.unit == "deg" else self.unit
        return units.shown_unit(self.base).sign + ("/s" if self.unit.endswith("/s") else "")

    def limit(self, value: float) -> str:
        """Limit of the range, in the unit shown."""
        return units.limit_text(value, self.base)

    def read(self, text: str) -> float | str | None:
        """Parse a typed text into a value.

        Raises
        ------
        InputError
            If it is not a number or out of range, or if a name is empty or too long.
        """
        text = text.strip()
        if self.is_text:
            if not text or len(text) > 24:
                raise InputError(error("window.name_length", field=self.title, longest=24))
            return text
        if self.choices:
            return text
        if not text and self.empty:
            return None
        typed = parse_number(text, self.sign)
        if typed is None:
            raise InputError(
                error("window.not_a_number_in", field=self.title, text=text, unit=self.sign)
            )
        value = typed if self.base is None else typed / units.shown_unit(self.base).factor
        value = units.snap_to_limits(value, self.base, self.low, self.high)
        if not self.low <= value <= self.high:
            raise InputError(
                error(
                    "window.out_of_range", field=self.title,
                    text=units.localised(units.plain_figure(typed, 10)),
                    low=units.localised(self.limit(self.low)),
                    high=units.localised(self.limit(self.high)), unit=self.sign,
                )
            )  # fmt: skip
        return value

    def shown(self, value: float | str | None) -> str:
        """Text of a value in the language and unit of the user."""
        if value is None:
            return gettext(self.empty)
        if isinstance(value, str):
            return gettext(value) if self.choices else value
        form = f".{self.decimals}f"
        figure = f"{value:{form}}" if self.base is None else units.figure(value, self.base, form)
        figure = figure if float(figure) else figure.replace("-", "")
        return units.localised(figure)


CELL_MARGIN_PX = 2
"""Width of a column beyond its longest text, for the grid, pixels."""


class NumberTable(QTableWidget):
    """Table with one row for each line or target; emits edits without applying them."""

    edited = Signal(int, str, object)
    """Row, name of the field, and the value; None for an empty cell."""
    row_selected = Signal(int)
    input_error = Signal(str)
    """Message on the error in the typed text; empty if there is none."""

    def __init__(self, name: str, title: str, fields: Sequence[TableColumn]) -> None:
        super().__init__(0, len(fields))
        self.setObjectName(name)
        self.setAccessibleName(title)
        self.fields = tuple(fields)
        self._showing = False
        self.setHorizontalHeaderLabels(
            [
                gettext("{title}\n({unit})", title=gettext(each.title), unit=each.sign)
                if each.unit
                else gettext(each.title)
                for each in fields
            ]
        )
        for k, each in enumerate(fields):
            head = self.horizontalHeaderItem(k)
            head.setToolTip(self._tip(each))
            head.setTextAlignment(_alignment(each))
        self.verticalHeader().setDefaultSectionSize(25)
        self.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        self.verticalHeader().hide()
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        header.setMinimumSectionSize(48)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(
            QAbstractItemView.EditTrigger.DoubleClicked
            | QAbstractItemView.EditTrigger.EditKeyPressed
            | QAbstractItemView.EditTrigger.AnyKeyPressed
        )
        self.setTabKeyNavigation(False)
        self.setItemDelegate(_Delegate(self))
        self.currentCellChanged.connect(self._emit_chosen)

    def _tip(self, field: TableColumn) -> str:
        tip = gettext(field.tip)
        if field.is_text or field.choices:
            return tip
        tip = gettext(
            "{tip}. Allowed values: {low} to {high} {unit}",
            tip=tip, low=units.localised(field.limit(field.low)),
            high=units.localised(field.limit(field.high)), unit=field.sign,
        ).rstrip()  # fmt: skip
        if field.empty:
            tip = gettext("{tip}. If empty: {meaning}", tip=tip, meaning=gettext(field.empty))
        return tip

    def show_rows(self, rows: Sequence[Sequence[float | str | None]], current: int) -> None:
        """Show the values of the rows; "" for a field that does not apply to a row."""
        self._showing = True
        if self.rowCount() != len(rows):
            self.setRowCount(len(rows))
        for r, row in enumerate(rows):
            for c, (field, value) in enumerate(zip(self.fields, row, strict=True)):
                item = self.item(r, c)
                if item is None:
                    item = QTableWidgetItem()
                    item.setTextAlignment(_alignment(field))
                    item.setFont(theme.tabular_font(self.font()))
                    item.setToolTip(self._tip(field))
                    self.setItem(r, c, item)
                text = "" if value == "" else field.shown(value)
                if item.text() != text:
                    item.setText(text)
                flags = Qt.ItemFlag.ItemIsSelectable | Qt.ItemFlag.ItemIsEnabled
                item.setFlags(flags if value == "" else flags | Qt.ItemFlag.ItemIsEditable)
        if 0 <= current < len(rows) and self.currentRow() != current:
            self.setCurrentCell(current, max(self.currentColumn(), 0))
        self._showing = False
        self._fit_columns()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Distribute the width again."""
        super().resizeEvent(event)
        self._fit_columns()

    def _fit_columns(self) -> None:
        """Give each column the width of its texts, and the same share of the remaining width."""
        header, columns = self.horizontalHeader(), range(self.columnCount())
        needed = [
            max(header.sectionSizeHint(k), self.sizeHintForColumn(k) + CELL_MARGIN_PX)
            for k in columns
        ]
        spare, rest = divmod(max(self.viewport().width() - sum(needed), 0), len(needed))
        for k in columns:
            header.resizeSection(k, needed[k] + spare + (k < rest))

    def closeEditor(self, editor: QWidget, hint: QStyledItemDelegate.EndEditHint) -> None:
        """Close an editor; one with a wrong text is closed by Escape only."""
        is_reverted = hint == QStyledItemDelegate.EndEditHint.RevertModelCache
        if is_reverted or not isinstance(editor, _CellEditor) or editor.input_error is None:
            super().closeEditor(editor, hint)

    def _emit_chosen(self, row: int, _column: int, before: int, _was: int) -> None:
        if not self._showing and row != before and row >= 0:
            self.row_selected.emit(row)


_END_KEYS = (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Tab, Qt.Key.Key_Backtab)
"""Keys that close an editor unless its text is wrong."""


class _CellEditor(NumberEntry, QLineEdit):
    """Editor of a cell; a wrong text is kept and marked."""

    input_checked = Signal(str)
    """Message on the error in the typed text; empty if there is none."""

    def __init__(self, delegate: QStyledItemDelegate, column: TableColumn, parent: QWidget) -> None:
        super().__init__(parent)
        self._delegate, self._column = delegate, column
        self._pending = PendingInput(self)
        self.setFont(theme.tabular_font(self.font()))
        self.textEdited.connect(self._pending.begin)
        self.textEdited.connect(self._check_text)

    @property
    def input_error(self) -> Message | None:
        """Reason why the text is not accepted; None if it is."""
        try:
            self._column.read(self.text())
        except InputError as failure:
            return failure.message
        return None

    def commit(self) -> bool:
        """Edit the cell and close the editor, unless its text is wrong."""
        self._pending.end()
        if self.input_error is not None:
            return False
        self._delegate.commitData.emit(self)
        self._delegate.closeEditor.emit(self)
        return True

    def restore(self) -> None:
        """Close the editor without an edit of the cell."""
        self._pending.end()
        self._delegate.closeEditor.emit(self, QStyledItemDelegate.EndEditHint.RevertModelCache)

    def _check_text(self) -> None:
        problem = self.input_error
        text = "" if problem is None else message_text(problem)
        self._mark(problem is not None, text)
        self.input_checked.emit(text)


class _Delegate(QStyledItemDelegate):
    """Delegate whose editors report invalid input, and are not closed by Enter while invalid."""

    def __init__(self, table: NumberTable) -> None:
        super().__init__(table)
        self._table = table

    def createEditor(self, parent, option, index):
        field = self._table.fields[index.column()]
        if field.choices:
            box = QComboBox(parent)
            for choice in field.choices:
                box.addItem(gettext(choice), choice)
            box.activated.connect(lambda _index: (self.commitData.emit(box),
                                                  self.closeEditor.emit(box)))  # fmt: skip
        else:
            box = _CellEditor(self, field, parent)
            box.input_checked.connect(self._table.input_error)
        title = gettext(field.title)
        box.setAccessibleName(f"{title}, {field.sign}" if field.unit else title)
        return box

    def destroyEditor(self, editor, index) -> None:
        """Destroy a closed editor, whose text is not wrong any more."""
        self._table.input_error.emit("")
        super().destroyEditor(editor, index)

    def setEditorData(self, editor, index) -> None:
        if isinstance(editor, QComboBox):
            editor.setCurrentText(index.data())
        elif not editor.isModified():
            field, text = self._table.fields[index.column()], index.data() or ""
            editor.setText("" if field.empty and text == gettext(field.empty) else text)

    def setModelData(self, editor, model, index) -> None:
        field = self._table.fields[index.column()]
        if isinstance(editor, QComboBox):
            if editor.currentText() != index.data():
                self._table.edited.emit(index.row(), field.name, editor.currentData())
            return
        if not editor.isModified():
            return
        try:
            value = field.read(editor.text())
        except InputError:
            return
        if field.shown(value) != index.data():
            self._table.edited.emit(index.row(), field.name, value)

    def eventFilter(self, editor, event) -> bool:
        if isinstance(editor, _CellEditor) and editor.property("wrong"):
            if event.type() == QEvent.Type.FocusOut:
                return False  # it stays open
            if event.type() == QEvent.Type.KeyPress and event.key() in _END_KEYS:
                return True
        return super().eventFilter(editor, event)


def _alignment(field: TableColumn) -> Qt.AlignmentFlag:
    """Alignment of a column: names to the left, numbers to the right."""
    is_text = bool(field.is_text or field.choices)
    side = Qt.AlignmentFlag.AlignLeft if is_text else Qt.AlignmentFlag.AlignRight
    return side | Qt.AlignmentFlag.AlignVCenter
