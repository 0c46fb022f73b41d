"""One's own scanner or INS/GNSS: figures and where they are from."""

from pathlib import Path

from PySide6.QtCore import Signal
from PySide6.QtGui import QFocusEvent
from PySide6.QtWidgets import QCheckBox, QDialog, QFormLayout, QHBoxLayout, QLineEdit, QWidget

from lispac.errors import InputError
from lispac.gui import theme
from lispac.gui.dialogs.import_files.sensor_choice import SOLUTIONS
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.io.sensor_file import STATES, Figures, PosFigures, PosState, ScannerFigures
from lispac.workflow.sensors import keep, require_sound

NEW_SCANNER = ScannerFigures("", 0.005, 0.01, 0.5, "")
NEW_POS = PosFigures("", (PosState("ppk", (0.02, 0.02, 0.03), (0.01, 0.01, 0.015), ""),))


class _Line(QLineEdit):
    """A line of words."""

    left = Signal()
    """By the focus; Qt's own signal tells of edited ones only."""

    def __init__(self, name: str, what: str, text: str) -> None:
        super().__init__(text)
        self.setObjectName(name)
        self.setCursorPosition(0)
        self.setAccessibleName(say(what))

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Also where nothing was typed."""
        super().focusOutEvent(event)
        self.left.emit()


class SensorEditor(QDialog):
    """Judges what is typed while it is typed; kept as a file.

    That something is not filled in yet is said once it was left so, or is to be kept.

    Parameters
    ----------
    folder : of the user's own sensors
    figures : to begin with
    name : of the user's sensor that is edited; empty for a new one
    """

    def __init__(
        self, folder: Path, figures: Figures, name: str, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._folder, self.name = folder, name
        self._left: set[_Line] = set()
        """Where the user was."""
        self.setObjectName("sensor_editor")
        scanner = isinstance(figures, ScannerFigures)
        self.setWindowTitle(say("Scanner" if scanner else "INS/GNSS"))
        self.setMinimumWidth(620)
        layout = widgets.column(self, 16)
        form = QFormLayout()
        form.setVerticalSpacing(theme.SPACE)
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self.title = _Line("sensor_title", "Maker and model", figures.title)
        form.addRow(say("Maker and model"), self.title)
        self.parts: list[_ScannerPart | _StatePart]
        if isinstance(figures, ScannerFigures):
            self.parts = [_ScannerPart(figures, form)]
        else:
            given = {state.name: state for state in figures.states}
            self.parts = [_StatePart(each, given.get(each), form) for each in STATES]
        layout.addLayout(form)
        self.said = widgets.label("", "error", wrap=True, name="sensor_editor_said")
        layout.addWidget(self.said)
        self.keep = widgets.button("OK", "sensor_keep", primary=True)
        self.keep.setDefault(True)
        cancel = widgets.button("Cancel", "sensor_cancel")
        cancel.setAutoDefault(False)
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_order(self.keep, cancel):
            row.addWidget(each)
        layout.addLayout(row)
        cancel.clicked.connect(self.reject)
        self.keep.clicked.connect(self._keep)
        for line in self._lines:
            line.textChanged.connect(self._judge)
            line.left.connect(lambda line=line: self._leave(line))
        for part in self.parts:
            part.moved.connect(self._judge)
        self._judge()

    @property
    def figures(self) -> Figures:
        """What the fields say."""
        title = self.title.text().strip()
        if isinstance(self.parts[0], _ScannerPart):
            return self.parts[0].figures(title)
        states = [part.state() for part in self.parts if isinstance(part, _StatePart)]
        return PosFigures(title, tuple(each for each in states if each is not None))

    @property
    def _lines(self) -> list[_Line]:
        return [self.title, *(part.origin.source for part in self.parts)]

    @property
    def _empty(self) -> _Line | None:
        """The first that is to be filled in."""
        lines = (line for line in self._lines if line.isEnabled())
        return next((line for line in lines if not line.text().strip()), None)

    def _leave(self, line: _Line) -> None:
        self._left.add(line)
        self._judge()

    def _judge(self, *_: object) -> None:
        try:
            require_sound(self._folder, self.figures, self.name)
            wrong = ""
        except InputError as error:
            wrong = str(error)
        if self._empty is not None and self._empty not in self._left:
            wrong = ""  # the user is on the way there
        self.said.setText(say(wrong))
        self.keep.setEnabled(not wrong)

    def _keep(self) -> None:
        if self._empty is not None:
            self._empty.setFocus()
            self._left.update(self._lines)
            self._judge()
            return
        try:
            self.name = keep(self._folder, self.figures, self.name)
        except InputError as error:
            self.said.setText(say(str(error)))
        else:
            self.accept()


class _Origin(QWidget):
    """Where figures come from, and whether they were held against it."""

    def __init__(self, name: str, source: str, from_memory: bool) -> None:
        super().__init__()
        self.source = _Line(f"{name}_source", "Where the figures come from", source)
        self.source.setPlaceholderText(say("Data sheet, with its date"))
        self.from_memory = QCheckBox(say("From memory"))
        self.from_memory.setObjectName(f"{name}_from_memory")
        self.from_memory.setChecked(from_memory)
        self.from_memory.setToolTip(say("Nobody has held the figures against the data sheet"))
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.addWidget(self.source, 1)
        row.addWidget(self.from_memory)


class _ScannerPart:
    def __init__(self, given: ScannerFigures, form: QFormLayout) -> None:
        self.range = widgets.number(
            "sensor_range", suffix=" mm", decimals=2, low=0.01, high=10_000, step=0.5,
            tip="Standard deviation of the range, millimetres",
        )  # fmt: skip
        self.angle = widgets.number(
            "sensor_angle", suffix=" °", decimals=4, low=0.0001, high=10, step=0.001,
            tip="Standard deviation of the beam's direction, both ways across it, degrees",
        )  # fmt: skip
        self.beam = widgets.number(
            "sensor_beam", suffix=" mrad", decimals=2, low=0, high=100, step=0.1,
            tip="How far the beam spreads, full angle in milliradians",
        )  # fmt: skip
        self.range.setValue(1000 * given.range_sigma)
        self.angle.setValue(given.angle_sigma_deg)
        self.beam.setValue(given.divergence_mrad)
        self.origin = _Origin("sensor", given.source, given.from_memory)
        self.moved = self.range.valueChanged
        form.addRow(say("Range (1 σ)"), self.range)
        form.addRow(say("Beam angular noise (1 σ)"), self.angle)
        form.addRow(say("Divergence"), self.beam)
        form.addRow(say("Source"), self.origin)

    def figures(self, title: str) -> ScannerFigures:
        return ScannerFigures(
            title, round(self.range.value() / 1000, 8), self.angle.value(), self.beam.value(),
            self.origin.source.text().strip(), self.origin.from_memory.isChecked(),
        )  # fmt: skip


class _StatePart:
    def __init__(self, name: str, given: PosState | None, form: QFormLayout) -> None:
        self._name = name
        usual = given or NEW_POS.states[0]
        self.stated = QCheckBox(say(f"With {SOLUTIONS[name]}"))
        self.stated.setObjectName(f"sensor_{name}")
        self.position = widgets.Triple(
            ("North", "East", "Down"),
            [_sigma(f"sensor_{name}_{axis}", " m", 100) for axis in ("n", "e", "d")],
        )
        self.attitude = widgets.Triple(
            ("Roll", "Pitch", "Heading"),
            [_sigma(f"sensor_{name}_{angle}", " °", 90) for angle in ("roll", "pitch", "heading")],
        )
        self.position.set_value(usual.position_sigma)
        self.attitude.set_value(usual.attitude_sigma_deg)
        self.origin = _Origin(
            f"sensor_{name}", usual.source if given else "", given is not None and given.from_memory
        )
        self.moved = self.stated.toggled
        form.addRow(self.stated)
        form.addRow(say("Position (1 σ)"), self.position)
        form.addRow(say("Attitude (1 σ)"), self.attitude)
        form.addRow(say("Source"), self.origin)
        for each in (self.position, self.attitude, self.origin):
            self.stated.toggled.connect(each.setEnabled)
            each.setEnabled(False)
        self.stated.setChecked(given is not None)

    def state(self) -> PosState | None:
        if not self.stated.isChecked():
            return None
        return PosState(
            self._name, self.position.value(), self.attitude.value(),
            self.origin.source.text().strip(), self.origin.from_memory.isChecked(),
        )  # fmt: skip


def _sigma(name: str, suffix: str, high: float):
    return widgets.number(name, suffix=suffix, decimals=4, low=0.0001, high=high, step=0.001)
