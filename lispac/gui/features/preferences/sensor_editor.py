"""Dialogue for a user-defined scanner or INS/GNSS: specifications and their source."""

from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtGui import QFocusEvent
from PySide6.QtWidgets import QCheckBox, QFormLayout, QHBoxLayout, QLineEdit, QWidget

from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.widgets.error_box import exception_text
from lispac.gui.widgets.number_input import NumberDialog
from lispac.io.config.sensor_file import (
    GNSS_SOLUTIONS,
    PosAccuracy,
    PosSpecification,
    ScannerSpecification,
    SensorSpecification,
)
from lispac.language import N_, gettext
from lispac.workflow.planning.sensors import require_storable, store_sensor

NEW_SCANNER = ScannerSpecification("", 0.005, 0.01, 0.5, "")
NEW_POS = PosSpecification("", (PosAccuracy("ppk", (0.02, 0.02, 0.03), (0.01, 0.01, 0.015), ""),))
"""Initial values of a new scanner and of a new INS/GNSS."""
SOLUTION_LABELS = {
    "rtk": N_("Specifications with RTK"),
    "ppk": N_("Specifications with PPK"),
    "degraded": N_("Specifications with degraded GNSS"),
}
"""Labels of the GNSS solutions."""


class _TextField(QLineEdit):
    """Text field that emits `focus_lost` when it loses the focus."""

    focus_lost = Signal()
    """The field has lost the focus, whether or not it was edited."""

    def __init__(self, name: str, label: str, text: str) -> None:
        super().__init__(text)
        self.setObjectName(name)
        self.setCursorPosition(0)
        self.setAccessibleName(label)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Emit `focus_lost`."""
        super().focusOutEvent(event)
        self.focus_lost.emit()


class SensorEditor(NumberDialog):
    """Dialogue that checks the specifications during typing and writes them to a file.

    An empty field is reported after it has lost the focus, or when the sensor is to be saved.

    Parameters
    ----------
    folder : folder of the user-defined sensors
    figures : initial specifications
    name : name of the edited user-defined sensor; empty for a new one
    """

    def __init__(
        self, folder: Path, figures: SensorSpecification, name: str, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._folder, self.name = folder, name
        self._visited_fields: set[_TextField] = set()
        """Fields that have had the focus."""
        self.setObjectName("sensor_editor")
        scanner = isinstance(figures, ScannerSpecification)
        self.setWindowTitle(gettext("Scanner") if scanner else gettext("INS/GNSS"))
        self.setMinimumWidth(620)
        layout = widgets.vertical_layout(self, 16)
        form = QFormLayout()
        form.setVerticalSpacing(theme.SPACING)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self.title = _TextField("sensor_title", gettext("Maker and model"), figures.title)
        form.addRow(gettext("Maker and model"), self.title)
        self.parts: list[_ScannerFields | _PosStateFields]
        if isinstance(figures, ScannerSpecification):
            self.parts = [_ScannerFields(figures, form)]
        else:
            states = {state.name: state for state in figures.states}
            self.parts = [_PosStateFields(each, states.get(each), form) for each in GNSS_SOLUTIONS]
        layout.addLayout(form)
        self.message_label = widgets.label("", "error", wrap=True, name="sensor_editor_message")
        layout.addWidget(self.message_label)
        self.keep = widgets.button(gettext("OK"), "sensor_keep", primary=True)
        self.keep.setDefault(True)
        cancel = widgets.button(gettext("Cancel"), "sensor_cancel")
        cancel.setAutoDefault(False)
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_platform_order(self.keep, cancel):
            row.addWidget(each)
        layout.addLayout(row)
        cancel.clicked.connect(self.reject)
        self.keep.clicked.connect(self._save_sensor)
        for line in self._lines:
            line.textChanged.connect(self._check_input)
            line.focus_lost.connect(lambda line=line: self._on_field_left(line))
        for part in self.parts:
            part.value_changed.connect(self._check_input)
        self._check_input()

    @property
    def figures(self) -> SensorSpecification:
        """Specifications from the fields."""
        title = self.title.text().strip()
        if isinstance(self.parts[0], _ScannerFields):
            return self.parts[0].figures(title)
        states = [part.state() for part in self.parts if isinstance(part, _PosStateFields)]
        return PosSpecification(title, tuple(each for each in states if each is not None))

    @property
    def _lines(self) -> list[_TextField]:
        return [self.title, *(part.origin.source for part in self.parts)]

    @property
    def _first_empty_field(self) -> _TextField | None:
        """The first required field that is empty."""
        lines = (line for line in self._lines if line.isEnabled())
        return next((line for line in lines if not line.text().strip()), None)

    def _on_field_left(self, line: _TextField) -> None:
        self._visited_fields.add(line)
        self._check_input()

    def _check_input(self, *_: object) -> None:
        try:
            require_storable(self._folder, self.figures, self.name)
            problem = ""
        except InputError as error:
            problem = exception_text(error)
        if (
            self._first_empty_field is not None
            and self._first_empty_field not in self._visited_fields
        ):
            problem = ""  # the user has not yet reached this field
        self.message_label.setText(problem)
        self.keep.setEnabled(not problem)

    def _save_sensor(self) -> None:
        if self._first_empty_field is not None:
            self._first_empty_field.setFocus()
            self._visited_fields.update(self._lines)
            self._check_input()
            return
        if self._show_wrong_field():
            return
        try:
            self.name = store_sensor(self._folder, self.figures, self.name)
        except InputError as error:
            self.message_label.setText(exception_text(error))
        else:
            self.accept()


class _SourceFields(QWidget):
    """Source of the specifications, and whether they were checked against it."""

    def __init__(self, name: str, source: str, unverified: bool) -> None:
        super().__init__()
        self.source = _TextField(f"{name}_source", gettext("Source of the specifications"), source)
        self.source.setPlaceholderText(gettext("Data sheet and its date"))
        self.unverified = QCheckBox(gettext("Specifications not verified"))
        self.unverified.setObjectName(f"{name}_from_memory")
        self.unverified.setChecked(unverified)
        self.unverified.setToolTip(
            gettext("Tick if the specifications have not been checked against the data sheet")
        )
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.source, 1)
        row.addWidget(self.unverified)


class _ScannerFields:
    """Fields for the specifications of a scanner."""

    def __init__(self, specification: ScannerSpecification, form: QFormLayout) -> None:
        self.range = widgets.number(
            "sensor_range", suffix=" mm", decimals=2, low=0.01, high=10_000, step=0.5,
            tip=gettext("Standard deviation of a range measurement, in millimetres"),
        )  # fmt: skip
        self.angle = widgets.number(
            "sensor_angle", suffix=" °", decimals=4, low=0.0001, high=10, step=0.001,
            tip=gettext("Standard deviation of the beam direction about each of the two axes "
                        "perpendicular to the beam, in degrees"),
        )  # fmt: skip
        self.beam = widgets.number(
            "sensor_beam", suffix=" mrad", decimals=2, low=0, high=100, step=0.1,
            tip=gettext("Beam divergence as full angle, in milliradians"),
        )  # fmt: skip
        self.range.setValue(1000 * specification.range_sigma)
        self.angle.setValue(specification.angle_sigma_deg)
        self.beam.setValue(specification.divergence_mrad)
        self.origin = _SourceFields("sensor", specification.source, specification.unverified)
        self.value_changed = self.range.valueChanged
        form.addRow(gettext("Range noise (1 σ)"), self.range)
        form.addRow(gettext("Beam angular noise (1 σ)"), self.angle)
        form.addRow(gettext("Beam divergence"), self.beam)
        form.addRow(gettext("Source"), self.origin)

    def figures(self, title: str) -> ScannerSpecification:
        return ScannerSpecification(
            title, round(self.range.value() / 1000, 8), self.angle.value(), self.beam.value(),
            self.origin.source.text().strip(), self.origin.unverified.isChecked(),
        )  # fmt: skip


class _PosStateFields:
    """Fields for the specifications of an INS/GNSS with one kind of GNSS solution."""

    def __init__(self, name: str, specification: PosAccuracy | None, form: QFormLayout) -> None:
        self._name = name
        usual = specification or NEW_POS.states[0]
        self.is_specified = QCheckBox(gettext(SOLUTION_LABELS[name]))
        self.is_specified.setObjectName(f"sensor_{name}")
        self.position = widgets.TripleField(
            (gettext("North"), gettext("East"), gettext("Down")),
            [_sigma_field(f"sensor_{name}_{axis}", " m", 100) for axis in ("n", "e", "d")],
        )
        self.attitude = widgets.TripleField(
            (gettext("Roll"), gettext("Pitch"), gettext("Heading")),
            [
                _sigma_field(f"sensor_{name}_{angle}", " °", 90)
                for angle in ("roll", "pitch", "heading")
            ],
        )
        self.position.set_value(usual.position_sigma)
        self.attitude.set_value(usual.attitude_sigma_deg)
        self.origin = _SourceFields(
            f"sensor_{name}",
            usual.source if specification else "",
            specification is not None and specification.unverified,
        )
        self.value_changed = self.is_specified.toggled
        form.addRow(self.is_specified)
        form.addRow(gettext("Position (1 σ)"), self.position)
        form.addRow(gettext("Attitude (1 σ)"), self.attitude)
        form.addRow(gettext("Source"), self.origin)
        for each in (self.position, self.attitude, self.origin):
            self.is_specified.toggled.connect(each.setEnabled)
            each.setEnabled(False)
        self.is_specified.setChecked(specification is not None)

    def state(self) -> PosAccuracy | None:
        if not self.is_specified.isChecked():
            return None
        return PosAccuracy(
            self._name, self.position.value(), self.attitude.value(),
            self.origin.source.text().strip(), self.origin.unverified.isChecked(),
        )  # fmt: skip


def _sigma_field(name: str, suffix: str, high: float):
    return widgets.number(name, suffix=suffix, decimals=4, low=0.0001, high=high, step=0.001)
