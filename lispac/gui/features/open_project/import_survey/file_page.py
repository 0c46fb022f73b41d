"""Page of the selected file: messages, options, contents and first rows."""

from collections.abc import Sequence

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QAbstractItemView,
    QComboBox,
    QFormLayout,
    QLabel,
    QLineEdit,
    QScrollArea,
    QSplitter,
    QStackedLayout,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.appearance.units import plain_figure
from lispac.gui.features.open_project.import_survey.message_list import MessageList
from lispac.gui.widgets.number_input import parse_number
from lispac.io.format_types import FileFormat, FormatOption
from lispac.language import gettext
from lispac.messages import Action
from lispac.present.survey.input_file import content_facts, option_name, option_value
from lispac.workflow.importing.input_columns import (
    UNUSED_COLUMN,
    has_columns,
    meaning_label,
    possible_meanings,
)
from lispac.workflow.importing.input_file import InputFile
from lispac.workflow.importing.input_file_messages import CHECK_SIGN_CODE, option_to_choose
from lispac.workflow.importing.input_files import InputFiles

_GEOREFERENCED_OPTIONS = ("crs", "height", "height_unit", "trajectory_datum", "epoch")
"""Options that apply only to georeferenced points."""
_SCANNER_FRAME_OPTIONS = ("unit",)
"""Options that apply only to points in the scanner frame."""

NUMBER_OPTIONS = {"max_range": "m", "epoch": ""}
"""Unit of each option that is a number."""


class OptionsForm(QWidget):
    """Fields for the options of a file."""

    option_edited = Signal(str, str)
    """Name and value."""

    def __init__(self) -> None:
        super().__init__()
        self._form = QFormLayout(self)
        self._form.setContentsMargins(0, 0, 6, 0)
        self._form.setVerticalSpacing(5)
        self._form.setHorizontalSpacing(10)
        self._form.setLabelAlignment(Qt.AlignmentFlag.AlignLeft)
        self._form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self._shown: tuple[object, FileFormat | None, tuple[str, ...]] = (None, None, ())
        self.fields: dict[str, QComboBox | QLineEdit] = {}
        self._labels: dict[str, QLabel] = {}
        self.system = widgets.label("", "muted", wrap=True, name="import_system")

    def show_file(self, file: InputFile) -> None:
        """Show the options of a file."""
        options = _visible_options(file)
        shown = (file.path, file.format, tuple(option.name for option in options))
        if shown != self._shown:
            self._shown = shown
            self._build(options)
        resolved, given = file.options, file.given_options or {}
        for option in options:
            field = self.fields[option.name]
            field.blockSignals(True)
            if isinstance(field, QComboBox):
                field.setCurrentIndex(max(0, field.findData(resolved[option.name])))
            elif not field.hasFocus() or not field.isModified():
                field.setText(resolved[option.name])
                field.setCursorPosition(0)
            field.blockSignals(False)
            is_given = option.name in given
            self._labels[option.name].setProperty("role", "heading" if is_given else "")
            self._labels[option.name].style().polish(self._labels[option.name])
            origin = (
                gettext("The value is specified by the user.")
                if is_given
                else gettext("The value was detected in the file or is the default.")
            )
            field.setToolTip(widgets.plain_tip(f"{gettext(option.meaning)}\n{origin}"))
        self._show_system(file)

    def focus_option(self, name: str, *, opens: bool = True) -> None:
        """Set the focus to the field of an option; ``opens`` also opens its list of values."""
        field = self.fields.get(name)
        if field is None:
            return
        field.setFocus(Qt.FocusReason.OtherFocusReason)
        if opens and isinstance(field, QComboBox):
            field.showPopup()

    def _build(self, options: tuple[FormatOption, ...]) -> None:
        self.system.setParent(None)
        while self._form.rowCount():
            self._form.removeRow(0)
        self.fields, self._labels = {}, {}
        for option in options:
            field = self._field(option)
            label = widgets.label(option_name(option.name))
            label.setBuddy(field)
            field.setAccessibleName(option_name(option.name))
            self.fields[option.name], self._labels[option.name] = field, label
            self._form.addRow(label, field)
            if option.name == "crs":
                self._form.addRow("", self.system)

    def _field(self, option: FormatOption) -> QComboBox | QLineEdit:
        name = option.name
        if option.choices:
            combo = widgets.ChoiceBox(f"option_{name}", [""], gettext(option.meaning))
            combo.clear()
            for value in option.choices:
                combo.addItem(option_value(name, value), value)
            combo.setMinimumContentsLength(24)
            combo.setSizeAdjustPolicy(
                QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
            )
            combo.activated.connect(lambda: self.option_edited.emit(name, str(combo.currentData())))
            return combo
        line = QLineEdit()
        line.setObjectName(f"option_{name}")
        if name == "crs":
            line.setPlaceholderText(gettext("for example {code}", code="EPSG:32619"))
        line.editingFinished.connect(lambda: self._on_typed(name, line))
        return line

    def _on_typed(self, name: str, line: QLineEdit) -> None:
        if line.isModified():
            text = line.text().strip()
            number = parse_number(text, NUMBER_OPTIONS[name]) if name in NUMBER_OPTIONS else None
            if number is not None:
                text = plain_figure(number, 10)
                line.setText(text)
            line.setModified(False)
            self.option_edited.emit(name, text)

    def _show_system(self, file: InputFile) -> None:
        if "crs" not in self.fields:
            return
        place = file.place
        if place is None:
            self.system.setText("")
            self.system.setVisible(False)
            return
        self.system.setVisible(True)
        self.system.setText(
            message_text(place.error)
            if place.error
            else gettext("Coordinate system: {system}.", system=place.system)
        )
        self.system.setProperty("role", "error" if place.error else "muted")
        self.system.style().polish(self.system)


def _visible_options(file: InputFile) -> tuple[FormatOption, ...]:
    if file.format is None or file.role is None:
        return ()
    hidden = {"columns"}
    if file.role == "points":
        hidden |= set(_SCANNER_FRAME_OPTIONS if file.is_georeferenced else _GEOREFERENCED_OPTIONS)
    return tuple(option for option in file.format.options if option.name not in hidden)


FORMATS_WITH_COLUMN_NAMES = ("las", "e57")
"""Formats whose files name their columns; these names are not translated."""
MAX_COLUMNS = 60
MIN_MAPPED_COLUMN_PX = 118
_ALIGN_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


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
        self.horizontalHeader().setDefaultAlignment(_ALIGN_RIGHT)
        self._shown: tuple[object, ...] = ()
        self.combos: list[widgets.ChoiceBox] = []

    def show_file(self, file: InputFile) -> None:
        """Show the first rows of a file."""
        rows = () if file.finding is None else file.finding.rows
        columns = min(max((len(row) for row in rows), default=0), MAX_COLUMNS)
        mapped = file.format is not None and file.role is not None and has_columns(file.format)
        shown = (file.path, file.format, rows, mapped)
        if shown != self._shown:
            self._shown = shown
            self._build(file, rows, columns, mapped)
        for k, combo in enumerate(self.combos):
            chosen = file.columns[k] if k < len(file.columns) else UNUSED_COLUMN
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
        elif file.format is not None and file.format.key in FORMATS_WITH_COLUMN_NAMES:
            heads = names
        else:
            heads = [_column_head(file, name) for name in names]
        self.setHorizontalHeaderLabels(heads + [""] * (columns - len(heads)))
        for k in range(columns if mapped else 0):
            self._add_combo(file, k)
        shown = [cells[:columns] for cells in rows[1:]]
        if not mapped:  # the rows of a text file are shown as they are in the file
            shown = _with_equal_decimals(shown)
        for row, cells in enumerate(shown):
            for column, text in enumerate(cells):
                item = QTableWidgetItem(text)
                item.setTextAlignment(_ALIGN_RIGHT)
                item.setFont(theme.tabular_font(self.font()))
                self.setItem(first + row, column, item)
        if self.rowCount():
            self.setRowHeight(0, 30 if mapped else 24)
        self.resizeColumnsToContents()
        for k in range(columns):
            width = self.columnWidth(k) + 10
            self.setColumnWidth(k, max(width, MIN_MAPPED_COLUMN_PX) if mapped else width)

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


_LENGTHS = ("height", "north", "east", "down")
_ANGLES = ("latitude", "longitude", "roll", "pitch", "heading", "wander")


def _column_head(file: InputFile, name: str) -> str:
    """Name of a column of an SBET or smrmsg file, with the unit of its values."""
    is_accuracy = file.role == "accuracy"
    if name == "time":
        unit = "s"
    elif name in _ANGLES:
        degrees = file.options.get("unit") == "degrees"
        unit = "′" if is_accuracy else "°" if degrees else "rad"
    elif name.startswith("velocity"):
        unit = "m/s"
    elif name.startswith("acceleration"):
        unit = "m/s²"
    elif name.startswith("rate"):
        unit = "rad/s"
    elif name in _LENGTHS:
        unit = "m"
    else:
        return gettext(name)
    return gettext("{label} ({unit})", label=gettext(name), unit=unit)


def _with_equal_decimals(rows: Sequence[Sequence[str]]) -> list[list[str]]:
    """Rows with the same number of decimals in all numbers of a column, and no negative zeros."""
    columns = []
    for texts in zip(*rows, strict=False):
        decimals = max(len(text.partition(".")[2]) for text in texts)
        try:
            # Adding zero removes the sign of a negative zero
            columns.append([f"{float(text) + 0.0:.{decimals}f}" for text in texts])
        except ValueError:
            columns.append(list(texts))
        if any("e" in text.lower() for text in texts):  # too small for a fixed number of decimals
            columns[-1] = list(texts)
    return [list(row) for row in zip(*columns, strict=True)]


class FilePage(QWidget):
    """Page with all details of one file."""

    action_chosen = Signal(object)
    sign_check_requested = Signal(str)
    """Option whose value the user wants to check: roll or pitch."""
    option_edited = Signal(str, str)
    meaning_chosen = Signal(int, str)

    def __init__(self) -> None:
        super().__init__()
        self._stack = QStackedLayout(self)
        none = QWidget()
        widgets.vertical_layout(none).addWidget(
            widgets.label(gettext("Select a file above to see its contents."), "muted")
        )
        none.layout().addStretch(1)
        self._stack.addWidget(none)
        filled = QWidget()
        self._stack.addWidget(filled)
        layout = QVBoxLayout(filled)
        layout.setContentsMargins(10, 8, 10, 8)
        layout.setSpacing(theme.SPACING)
        self.messages = MessageList("import_messages")
        self.messages.action_chosen.connect(self._on_action_chosen)
        layout.addWidget(self.messages)
        split = QSplitter(Qt.Orientation.Horizontal)
        split.setChildrenCollapsible(False)
        self.options = OptionsForm()
        self.options.option_edited.connect(self.option_edited)
        self.facts = QFormLayout()
        self._facts_of: tuple[object, object] = (None, None)
        self.facts.setVerticalSpacing(3)
        self.facts.setHorizontalSpacing(10)
        self.assumptions = widgets.label("", "muted", wrap=True, name="import_assumptions")
        split.addWidget(self._create_left_side())
        right = QWidget()
        beside = QVBoxLayout(right)
        beside.setContentsMargins(6, 0, 0, 0)
        beside.setSpacing(4)
        self.preview_head = widgets.label(gettext("First rows"), "heading")
        beside.addWidget(self.preview_head)
        self.preview = FilePreview()
        self.preview.meaning_chosen.connect(self.meaning_chosen)
        beside.addWidget(self.preview, 1)
        split.addWidget(right)
        split.setStretchFactor(1, 1)
        split.setSizes([400, 700])
        layout.addWidget(split, 1)

    def _create_left_side(self) -> QScrollArea:
        body = widgets.WrappedBody()
        rows = QVBoxLayout(body)
        rows.setContentsMargins(0, 0, 6, 0)
        rows.setSpacing(6)
        self._options_head = widgets.label(gettext("Reading options"), "heading")
        rows.addWidget(self._options_head)
        rows.addWidget(self.options)
        rows.addWidget(widgets.label(gettext("File contents"), "heading"))
        rows.addLayout(self.facts)
        self._assumed_head = widgets.label(gettext("Assumptions"), "heading")
        rows.addWidget(self._assumed_head)
        rows.addWidget(self.assumptions)
        rows.addStretch(1)
        area = widgets.VerticalScrollArea(body, 330)
        area.setAccessibleName(gettext("Reading options and contents of the file"))
        body.setAutoFillBackground(False)
        return area

    def show_file(self, input_files: InputFiles, file: InputFile | None) -> None:
        """Show a file; None if no file is selected."""
        self._stack.setCurrentIndex(0 if file is None else 1)
        if file is None:
            return
        fine = "" if file.pending or file.role is None else gettext("No problems found.")
        self.messages.show_messages(input_files.messages(file), fine)
        self.options.show_file(file)
        for changing in (self.options, self.preview):
            changing.setEnabled(file.project_reading is None)
        self._options_head.setVisible(bool(self.options.fields))
        self._show_facts(file)
        self.preview.show_file(file)
        mapped = bool(self.preview.combos)
        rows = file.finding is not None and len(file.finding.rows) > 1
        self.preview_head.setVisible(rows)
        self.preview.setVisible(rows)
        self.preview_head.setText(
            gettext("First rows – choose the meaning of each column in the list above the column")
            if mapped
            else gettext("First rows")
        )

    def _show_facts(self, file: InputFile) -> None:
        finding = file.finding
        if self._facts_of == (file.path, finding):
            return
        self._facts_of = (file.path, finding)
        while self.facts.rowCount():
            self.facts.removeRow(0)
        assumed = () if finding is None else finding.assumptions
        self._add_fact(gettext("Folder"), str(file.path.parent))
        for fact in content_facts({} if finding is None else finding.facts):
            self._add_fact(fact.name, fact.text)
        self.assumptions.setText("\n".join(map(message_text, assumed)))
        self._assumed_head.setVisible(bool(assumed))
        self.assumptions.setVisible(bool(assumed))

    def _add_fact(self, name: str, text: str) -> None:
        head = widgets.label(role="muted")
        head.setText(name)
        head.setAlignment(Qt.AlignmentFlag.AlignTop)
        value = widgets.label(wrap=True)
        value.setText(text)
        value.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self.facts.addRow(head, value)

    def _on_action_chosen(self, action: Action, _place: int) -> None:
        option = option_to_choose(action)
        if action.code == CHECK_SIGN_CODE:
            self.sign_check_requested.emit(option)
        elif option:
            self.options.focus_option(option)
        else:
            self.action_chosen.emit(action)
