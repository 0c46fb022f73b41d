"""A table whose cells are typed into: a mistake is said while it is typed and never taken."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QEvent, Qt, Signal
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QHeaderView,
    QLineEdit,
    QStyledItemDelegate,
    QTableWidget,
    QTableWidgetItem,
)

from lispac.errors import InputError
from lispac.gui import theme, units
from lispac.gui.language import local_number, say, say_all
from lispac.gui.panels.number_field import BASES
from lispac.gui.units import Base
from lispac.messages import error


@dataclass(frozen=True)
class Field:
    """A column.

    Attributes
    ----------
    unit : of the values, below the title; empty for words. Lengths are shown in the user's
    low, high : what may stand there
    choices : words to choose from, instead of typing
    empty : what an empty cell means, where it may be empty
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
    words: bool = False

    @property
    def base(self) -> Base | None:
        """Of its lengths and speeds; angles are headings and inclinations, in degrees for all."""
        return BASES.get(" " + self.unit.removesuffix("/s"))

    @property
    def sign(self) -> str:
        """Unit that is shown."""
        if self.base is None:
            return self.unit
        return units.unit(self.base).sign + ("/s" if self.unit.endswith("/s") else "")

    def limit(self, value: float) -> str:
        """An end of the range, in the unit shown."""
        return f"{value:g}" if self.base is None else units.limit(value, self.base)

    def read(self, text: str) -> float | str | None:
        """What was typed.

        Raises
        ------
        InputError
            It is no number, or out of range.
        """
        text = text.strip()
        if self.words:
            if not text or len(text) > 24:
                raise InputError(error("window.name_length", field=say(self.title), longest=24))
            return text
        if self.choices:
            return text
        if not text and self.empty:
            return None
        try:
            typed = float(text.replace(",", ".").replace("−", "-"))
        except ValueError:
            typed = math.nan
        if not math.isfinite(typed):
            raise InputError(
                error("window.not_a_number_in", field=say(self.title), text=text, unit=self.sign)
            )
        value = typed if self.base is None else typed / units.unit(self.base).factor
        value = units.ended(value, self.base, self.low, self.high)
        if not self.low <= value <= self.high:
            raise InputError(
                error(
                    "window.out_of_range", field=say(self.title), text=local_number(f"{typed:g}"),
                    low=local_number(self.limit(self.low)),
                    high=local_number(self.limit(self.high)), unit=self.sign,
                )
            )  # fmt: skip
        return value

    def said(self, value: float | str | None) -> str:
        """A value as it is shown."""
        if value is None:
            return self.empty
        if isinstance(value, str):
            return value
        form = f".{self.decimals}f"
        said = f"{value:{form}}" if self.base is None else units.figure(value, self.base, form)
        return said.replace("-", "−") if float(said) else said.replace("-", "")


class NumberTable(QTableWidget):
    """One row a line or target; edits and the choice of a row are told, never made."""

    edited = Signal(int, str, object)
    """Row, name of the field, and the value; None for an empty one."""
    chosen = Signal(int)
    mistake = Signal(str)
    """What is wrong with what is being typed; empty when nothing is any more."""

    def __init__(self, name: str, title: str, fields: Sequence[Field]) -> None:
        super().__init__(0, len(fields))
        self.setObjectName(name)
        self.setAccessibleName(say(title))
        self.fields = tuple(fields)
        self._showing = False
        heads = [f"{each.title}\n({each.unit})" if each.unit else each.title for each in fields]
        self.setHorizontalHeaderLabels(
            [_signed(head, each, False) for head, each in zip(say_all(heads), fields, strict=True)]
        )
        for k, each in enumerate(fields):
            head = self.horizontalHeaderItem(k)
            head.setToolTip(self._tip(each))
            head.setTextAlignment(_side(each))
        self.verticalHeader().setDefaultSectionSize(25)
        self.verticalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        self.verticalHeader().hide()
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        header.setMinimumSectionSize(48)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(
            QAbstractItemView.EditTrigger.DoubleClicked
            | QAbstractItemView.EditTrigger.EditKeyPressed
            | QAbstractItemView.EditTrigger.AnyKeyPressed
        )
        self.setTabKeyNavigation(False)
        self.setItemDelegate(_Delegate(self))
        self.currentCellChanged.connect(self._choose)

    def _tip(self, field: Field) -> str:
        if field.words or field.choices:
            return say(field.tip)
        said = f"{field.tip}, {field.limit(field.low)} to {field.limit(field.high)} {field.unit}"
        return _signed(say(f"{said}. Empty: {field.empty}" if field.empty else said), field)

    def show_rows(self, rows: Sequence[Sequence[float | str | None]], current: int) -> None:
        """Show other values; a cell of a field that does not apply holds an empty string."""
        self._showing = True
        if self.rowCount() != len(rows):
            self.setRowCount(len(rows))
        for r, row in enumerate(rows):
            for c, (field, value) in enumerate(zip(self.fields, row, strict=True)):
                item = self.item(r, c)
                if item is None:
                    item = QTableWidgetItem()
                    item.setTextAlignment(_side(field))
                    item.setFont(theme.tabular(self.font()))
                    item.setToolTip(self._tip(field))
                    self.setItem(r, c, item)
                said = "" if value == "" else _shown(field, value)
                if item.text() != said:
                    item.setText(said)
                flags = Qt.ItemFlag.ItemIsSelectable | Qt.ItemFlag.ItemIsEnabled
                item.setFlags(flags if value == "" else flags | Qt.ItemFlag.ItemIsEditable)
        if 0 <= current < len(rows) and self.currentRow() != current:
            self.setCurrentCell(current, max(self.currentColumn(), 0))
        self._showing = False

    def _choose(self, row: int, _column: int, before: int, _was: int) -> None:
        if not self._showing and row != before and row >= 0:
            self.chosen.emit(row)


def _signed(said: str, field: Field, figures: bool = True) -> str:
    """A text with the sign of the unit shown; ``figures``, where they are in that unit."""
    if field.base is None:
        return said
    if field.unit.endswith("/s"):
        return said.replace(field.unit, field.sign)
    return units.signs(said, field.base, figures=figures)


def _shown(field: Field, value: float | str | None) -> str:
    """A value in the user's language; a name as it is."""
    return field.said(value) if field.words else say(field.said(value))


class _Delegate(QStyledItemDelegate):
    """Editors that say what is wrong; Enter does not close one that is."""

    def __init__(self, table: NumberTable) -> None:
        super().__init__(table)
        self._table = table

    def createEditor(self, parent, option, index):
        field = self._table.fields[index.column()]
        if field.choices:
            box = QComboBox(parent)
            for choice in field.choices:
                box.addItem(say(choice), choice)
            box.activated.connect(lambda _index: (self.commitData.emit(box),
                                                  self.closeEditor.emit(box)))  # fmt: skip
        else:
            box = QLineEdit(parent)
            box.setFont(theme.tabular(box.font()))
            box.textEdited.connect(lambda _text: self._judge(box, field))
            box.destroyed.connect(self._closed)
        said = say(f"{field.title}, {field.unit}" if field.unit else field.title)
        box.setAccessibleName(_signed(said, field, False))
        return box

    def _closed(self) -> None:
        try:
            self._table.mistake.emit("")
        except RuntimeError:  # the table went first
            return

    def _judge(self, editor: QLineEdit, field: Field) -> bool:
        try:
            field.read(editor.text())
            said = ""
        except InputError as error:
            said = str(error)
        editor.setProperty("wrong", bool(said))
        editor.style().unpolish(editor)
        editor.style().polish(editor)
        self._table.mistake.emit(said)
        return not said

    def setEditorData(self, editor, index) -> None:
        if isinstance(editor, QComboBox):
            editor.setCurrentText(index.data())
        elif not editor.isModified():
            field, said = self._table.fields[index.column()], index.data() or ""
            editor.setText("" if field.empty and said == say(field.empty) else said)

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
        if _shown(field, value) != index.data():
            self._table.edited.emit(index.row(), field.name, value)

    def eventFilter(self, editor, event) -> bool:
        if (
            event.type() == QEvent.Type.KeyPress
            and event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
            and isinstance(editor, QLineEdit)
            and editor.property("wrong")
        ):
            return True
        return super().eventFilter(editor, event)


def _side(field: Field) -> Qt.AlignmentFlag:
    """Words to the left, numbers to the right, and their heading above them."""
    words = bool(field.words or field.choices)
    side = Qt.AlignmentFlag.AlignLeft if words else Qt.AlignmentFlag.AlignRight
    return side | Qt.AlignmentFlag.AlignVCenter
