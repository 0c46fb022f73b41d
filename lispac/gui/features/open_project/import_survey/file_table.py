"""Table of the files to import: role, format, contents and state of each."""

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor, QIcon, QPixmap
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
)

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.open_project.import_survey import file_texts
from lispac.gui.widgets.marked_cells import MarkedCells
from lispac.io.format_types import Kind
from lispac.language import N_, gettext
from lispac.workflow.importing.input_file import InputFile
from lispac.workflow.importing.input_files import InputFiles

FILE, ROLE, FORMAT, COUNT, SPAN, FRAME, STATE = range(7)
"""Indices of the columns."""
_COLUMN_TITLES = (
    N_("File"), N_("Role"), N_("Format"), N_("Points"), N_("Time span (s)"), N_("Frame"),
    N_("Status"),
)  # fmt: skip
_COLUMN_TIPS = (
    N_("Name of the file; the tooltip of the row shows the folder"),
    N_("Role of the file in the project"),
    N_("Format of the file; the list begins with the most likely format"),
    N_("Number of points of a line or of records of a trajectory"),
    N_("First and last time in seconds, in the time base of the file"),
    N_("Coordinate frame of the file"),
    N_("Problems found in the file; select the row to read them"),
)
_ALIGN_LEFT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
_ALIGN_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
ROW_HEIGHT_PX = 28


class FileTable(QTableWidget):
    """Shows the files of an import; roles and formats are chosen in the table."""

    role_chosen = Signal(object, object)
    """Path, and role or None."""
    format_chosen = Signal(object, str)
    """Path, and key of the format."""
    file_selected = Signal(object)
    """Path, or None."""

    def __init__(self) -> None:
        super().__init__(0, len(_COLUMN_TITLES))
        self.setObjectName("import_files")
        self.setAccessibleName(gettext("Files to import"))
        self.setHorizontalHeaderLabels([gettext(head) for head in _COLUMN_TITLES])
        for column, tip in enumerate(_COLUMN_TIPS):
            head = self.horizontalHeaderItem(column)
            head.setToolTip(gettext(tip))
            head.setTextAlignment(_ALIGN_RIGHT if column in (COUNT, SPAN) else _ALIGN_LEFT)
        self.verticalHeader().hide()
        self.verticalHeader().setDefaultSectionSize(ROW_HEIGHT_PX)
        self.setShowGrid(False)
        self.setItemDelegateForColumn(STATE, MarkedCells(self))
        self.setStyleSheet("QTableWidget::item { padding: 0 6px; }")
        self.setAlternatingRowColors(True)
        self.setTabKeyNavigation(False)
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        header = self.horizontalHeader()
        header.setHighlightSections(False)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        header.setSectionResizeMode(FILE, QHeaderView.ResizeMode.Stretch)
        for column, width in ((ROLE, 128), (FORMAT, 194), (COUNT, 96), (SPAN, 200), (FRAME, 180),
                              (STATE, 136)):  # fmt: skip
            self.setColumnWidth(column, width)
        self._paths: list[Path] = []
        self.itemSelectionChanged.connect(lambda: self.file_selected.emit(self.current))

    @property
    def current(self) -> Path | None:
        """The selected file."""
        rows = self.selectionModel().selectedRows()
        return self._paths[rows[0].row()] if rows else None

    @property
    def rows_height(self) -> int:
        """Height of the table in which all rows are visible, pixels."""
        head = self.horizontalHeader().sizeHint().height()
        return head + self.verticalHeader().length() + 2 * self.frameWidth()

    def select(self, path: Path) -> None:
        """Select a file's row."""
        if path in self._paths:
            self.selectRow(self._paths.index(path))

    def show_files(self, input_files: InputFiles) -> None:
        """Show the files; rows that exist already keep their widgets and the focus."""
        self._update_rows([file.path for file in input_files.files])
        colours = theme.line_colours([str(file.path) for file in input_files.lines])
        for row, file in enumerate(input_files.files):
            name = self.item(row, FILE)
            colour = colours.get(str(file.path))
            name.setIcon(theme.swatch(colour) if colour else _transparent_icon())
            self._fill_role(row, file)
            self._fill_format(row, file)
            for column, text in (
                (COUNT, file_texts.count_text(file)),
                (SPAN, file_texts.time_span_text(file)),
                (FRAME, file_texts.frame_text(file)),
            ):
                self.item(row, column).setText(text)
                self.item(row, column).setToolTip(widgets.plain_tip(text))
            state, colour = file_texts.state_text(input_files, file)
            item = self.item(row, STATE)
            item.setText(state)
            item.setForeground(QColor(colour))
            item.setIcon(file_texts.state_icon(input_files, file))
            tip = "\n".join(map(message_text, input_files.messages(file))) or state
            item.setToolTip(widgets.plain_tip(tip))
            is_excluded = input_files.state_of_file(file) == "out"
            for column in (FILE, COUNT, SPAN, FRAME):
                text_colour = theme.MUTED if is_excluded else theme.TEXT
                self.item(row, column).setForeground(QColor(text_colour))
        self.setColumnWidth(STATE, max(self.columnWidth(STATE), self.sizeHintForColumn(STATE)))
        if self.current is None and self._paths:
            self.selectRow(0)

    def _update_rows(self, paths: Sequence[Path]) -> None:
        if self._paths == list(paths):
            return
        for row in reversed(range(len(self._paths))):
            if self._paths[row] not in paths:
                self.removeRow(row)  # the changing selection still reads the path
                del self._paths[row]
        for path in paths:
            if path not in self._paths:
                self._paths.append(path)
                self._add_row(path)

    def _add_row(self, path: Path) -> None:
        row = self.rowCount()
        self.insertRow(row)
        for column in range(len(_COLUMN_TITLES)):
            item = QTableWidgetItem(path.name if column == FILE else "")
            item.setToolTip(widgets.plain_tip(str(path)))
            if column in (COUNT, SPAN):
                item.setTextAlignment(_ALIGN_RIGHT)
                item.setFont(theme.tabular_font(self.font()))
            self.setItem(row, column, item)

    def _fill_role(self, row: int, file: InputFile) -> None:
        roles: tuple[Kind | None, ...] = (*file.roles, None)
        if file.project_reading is not None:
            roles = (file.role,)
        if file.pending and not file.roles:
            items: list[tuple[str, object]] = [(file_texts.NO_VALUE, None)]  # not known yet
        else:
            items = [(gettext(file_texts.ROLE_NAMES[role]), role) for role in roles]
        self._fill_choice(row, ROLE, file, items, file.role, self.role_chosen)

    def _fill_format(self, row: int, file: InputFile) -> None:
        formats = file.formats if file.project_reading is None else (file.format,)
        items: list[tuple[str, object]] = [
            (message_text(each.name), each.key) for each in formats if each
        ]
        chosen = file.format.key if file.format is not None and items else None
        items = items or [(file_texts.NO_VALUE, None)]
        self._fill_choice(row, FORMAT, file, items, chosen, self.format_chosen)

    def _fill_choice(self, row: int, column: int, file: InputFile, items, chosen, signal) -> None:
        """Show a list if there are several items, otherwise plain text."""
        path, item = file.path, self.item(row, column)
        text = next((text for text, data in items if data == chosen), items[0][0])
        item.setToolTip(widgets.plain_tip(text))
        combo = self.cellWidget(row, column)
        if len(items) < 2:
            if combo is not None:
                self.removeCellWidget(row, column)
            item.setText(text)
            item.setForeground(QColor(theme.MUTED if chosen is None else theme.TEXT))
            return
        item.setText("")
        if combo is None:
            name, label = (
                ("role", N_("Role of {file}")) if column == ROLE else
                ("format", N_("Format of {file}"))
            )  # fmt: skip
            combo = widgets.ChoiceBox(
                f"{name}_{path.name}", [file_texts.NO_VALUE], gettext(_COLUMN_TIPS[column])
            )
            combo.setAccessibleName(gettext(label, file=path.name))
            combo.setSizeAdjustPolicy(
                QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
            )
            combo.activated.connect(lambda: self.select(path))
            combo.activated.connect(lambda: signal.emit(path, combo.currentData()))
            self.setCellWidget(row, column, combo)
        _fill_combo(combo, items, chosen)


def _transparent_icon() -> QIcon:
    """Transparent icon, which aligns the names of files that are not lines."""
    pixmap = QPixmap(12, 12)
    pixmap.fill(Qt.GlobalColor.transparent)
    return QIcon(pixmap)


def _fill_combo(combo: QComboBox, items: Sequence[tuple[str, object]], chosen: object) -> None:
    """Fill a list without emitting signals."""
    present = [(combo.itemText(k), combo.itemData(k)) for k in range(combo.count())]
    combo.blockSignals(True)
    if present != list(items):
        combo.clear()
        for text, data in items:
            combo.addItem(text, data)
    combo.setCurrentIndex(next((k for k, (_, data) in enumerate(items) if data == chosen), 0))
    combo.blockSignals(False)
