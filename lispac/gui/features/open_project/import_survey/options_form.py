"""Form with the reading options of a file, preset with detected or default values."""

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QFormLayout, QLabel, QLineEdit, QWidget

from lispac.gui import widgets
from lispac.io.format_types import FileFormat, FormatOption
from lispac.language import gettext
from lispac.message_texts import message_text
from lispac.present.input_file import option_name, option_value
from lispac.workflow.importing.input_file import InputFile

_GEOREFERENCED_OPTIONS = ("crs", "height", "height_unit", "trajectory_datum", "epoch")
"""Options that apply only to georeferenced points."""
_SCANNER_FRAME_OPTIONS = ("unit",)
"""Options that apply only to points in the scanner frame."""


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

    def focus_option(self, name: str) -> None:
        """Set the focus to the field of an option."""
        if name in self.fields:
            self.fields[name].setFocus(Qt.FocusReason.OtherFocusReason)

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
            line.setModified(False)
            self.option_edited.emit(name, line.text().strip())

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
