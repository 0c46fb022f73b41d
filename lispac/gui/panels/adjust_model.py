"""Seldom-used settings of the adjustment: times, surfaces, stray points, LiDAR noise."""

from dataclasses import replace

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QCheckBox, QFormLayout, QHBoxLayout, QLabel, QWidget

from lispac.adjustment.robust import LossName
from lispac.adjustment.stochastic import PosErrors
from lispac.errors import InputError
from lispac.gui import units
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.fields import OptionalNumber
from lispac.messages import error
from lispac.project import Settings

TIMES = (
    "How long the POS error stays like itself. Position drifts over minutes, attitude more "
    "slowly. Where the processing report states correlation times, use them; too short a time is "
    "safer than too long a one."
)
LOSSES: tuple[tuple[LossName | None, str, str], ...] = (
    (None, "As the model does", "Tukey with correlated POS errors, none with uncorrelated ones"),
    ("none", "All points alike", "No point loses weight, however far it lies off"),
    ("huber", "Far points count less (Huber)", "The weight falls beyond 1.3 σ, never to zero"),
    ("tukey", "Stray points do not count (Tukey)", "Points beyond 4.7 σ have no say"),
)
NOISES = ("Same on all axes", "Along X, Y, Z", "Range and angle")
_MM, _DEG = 1e3, float(np.degrees(1.0))


class _Sentence(QLabel):
    """A wrapped sentence that keeps its height: a form with hidden rows squeezes it."""

    def __init__(self, text: str, name: str) -> None:
        super().__init__(say(text))
        self.setTextFormat(Qt.TextFormat.PlainText)
        self.setObjectName(name)
        self.setProperty("role", "muted")
        self.setWordWrap(True)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        needed = self.heightForWidth(self.width())
        if needed != self.minimumHeight():
            self.setMinimumHeight(needed)


class ModelSettings(QWidget):
    """What the stochastic model leaves to choose."""

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        form = QFormLayout(self)
        form.setContentsMargins(18, 0, 0, 4)
        form.setHorizontalSpacing(8)
        form.setVerticalSpacing(5)
        form.setRowWrapPolicy(QFormLayout.RowWrapPolicy.DontWrapRows)
        self.position_time = self._time("position_time", "position")
        self.attitude_time = self._time("attitude_time", "attitude")
        form.addRow(say("Position time"), self.position_time)
        form.addRow(say("Attitude time"), self.attitude_time)
        self.times = _Sentence(TIMES, "times_sentence")
        form.addRow(self.times)
        self.surface = self._optional(
            "surface", "Surface sigma", "mm", _MM, "from the data",
            "How far what one line sees of a target may lie off the shape all lines share",
        )  # fmt: skip
        form.addRow(units.signs(say("Surface σ, mm"), "mm"), self.surface)
        self.loss = widgets.Choice(
            "loss", [title for _, title, _ in LOSSES],
            "What is done with points that lie far off their surface",
        )  # fmt: skip
        for k, (_, _, tip) in enumerate(LOSSES):
            self.loss.setItemData(k, say(tip), Qt.ItemDataRole.ToolTipRole)
        self.loss.currentIndexChanged.connect(self.changed)
        form.addRow(say("Stray points"), self.loss)
        self.noise = widgets.Choice(
            "lidar_noise", NOISES, "How the noise of a LiDAR point is stated"
        )
        self.noise.currentIndexChanged.connect(self._show_noise)
        form.addRow(say("LiDAR noise"), self.noise)
        self._same = widgets.label("", "muted", wrap=True, name="lidar_same")
        self.axes = []
        for axis in "XYZ":
            tip = f"Noise along {axis} of the LiDAR, one standard deviation"
            what, empty = f"LiDAR noise along {axis}", f"{axis}, mm"
            name = f"lidar_{axis.lower()}"
            self.axes.append(self._optional(name, what, "mm", _MM, empty, tip, True))
        self.range = self._optional(
            "lidar_range", "LiDAR range noise", "mm", _MM, "range, mm",
            "Noise of the range, one standard deviation", True,
        )  # fmt: skip
        self.angle = self._optional(
            "lidar_angle", "LiDAR angle noise", "°", 1.0, "angle, °",
            "Noise of the beam's direction, one standard deviation", True,
        )  # fmt: skip
        self._three, self._two = _row(*self.axes), _row(self.range, self.angle)
        for each in (self._same, self._three, self._two):
            form.addRow("", each)
        self.components = QCheckBox(say("Find how large the errors are"))
        self.components.setObjectName("variance_components")
        self.components.setToolTip(
            say(
                "Variance components: the sigmas of LiDAR, POS position and POS attitude "
                "are scaled "
                "by what the data say. With few sightings the data say little of the POS."
            )
        )
        self.components.toggled.connect(self.changed)
        form.addRow(self.components)
        self.one_facing = QCheckBox(say("Accept targets that all face one way"))
        self.one_facing.setObjectName("accept_one_facing")
        self.one_facing.setToolTip(
            say(
                "For boards that all hang on one wall, or a single one. Only the headings "
                "of the lines "
                "tell the angles apart then, and nothing shows whether a board is bent or moved. A "
                "target of another inclination, or a sphere, is better."
            )
        )
        self.one_facing.toggled.connect(self.changed)
        form.addRow(self.one_facing)
        self._form = form
        self._show_noise()

    def settings_of(self, settings: Settings) -> Settings:
        """The settings with what is chosen here.

        Raises
        ------
        InputError
        """
        kind = self.noise.currentIndex()
        return replace(
            settings,
            position_time=_kept(self.position_time.value(), settings.position_time, 0.051),
            attitude_time=_kept(self.attitude_time.value(), settings.attitude_time, 0.051),
            surface=self.surface.value(),
            loss=LOSSES[self.loss.currentIndex()][0],
            lidar_sigma_xyz=self._all(self.axes, "window.lidar_axes_incomplete")
            if kind == 1
            else None,
            lidar_beam_sigma=self._all((self.range, self.angle), "window.lidar_beam_incomplete")
            if kind == 2
            else None,
            variance_components=self.components.isChecked(),
            accept_one_facing=self.one_facing.isChecked(),
        )

    def show_settings(self, settings: Settings) -> None:
        """Fill in, without telling anyone."""
        self.blockSignals(True)
        self.position_time.setValue(settings.position_time)
        self.attitude_time.setValue(settings.attitude_time)
        self.surface.show_value(settings.surface)
        self.loss.setCurrentIndex([loss for loss, _, _ in LOSSES].index(settings.loss))
        sigma = units.figure(settings.lidar_sigma * _MM, "mm", ".1f")
        self._same.setText(units.signs(say(f"{sigma} mm, as typed in step 1"), "mm"))
        for field, value in zip(
            self.axes, settings.lidar_sigma_xyz or (settings.lidar_sigma,) * 3, strict=True
        ):
            field.show_value(value)
        beam = settings.lidar_beam_sigma or (settings.lidar_sigma, None)
        self.range.show_value(beam[0])
        self.angle.show_value(beam[1])
        kind = 1 if settings.lidar_sigma_xyz else 2 if settings.lidar_beam_sigma else 0
        self.noise.setCurrentIndex(kind)
        self.components.setChecked(settings.variance_components)
        self.one_facing.setChecked(settings.accept_one_facing)
        self.blockSignals(False)

    def show_model(self, pos_errors: PosErrors) -> None:
        """Switch off what thesis mode does not know."""
        for each in (self.position_time, self.attitude_time, self.surface, self.components):
            each.setEnabled(pos_errors == "correlated")

    @property
    def summary(self) -> str:
        """What differs from the usual, in a few words."""
        words = []
        if self.noise.currentIndex():
            words.append(f"LiDAR {NOISES[self.noise.currentIndex()].lower()}")
        if self.loss.currentIndex():
            words.append(LOSSES[self.loss.currentIndex()][0] or "")
        if self.surface.text().strip():
            words.append("surface σ typed")
        if self.components.isChecked():
            words.append("variance components")
        if self.one_facing.isChecked():
            words.append("one facing accepted")
        return ", ".join(map(say, words))

    def _all(self, fields, code: str):
        values = [field.value() for field in fields]
        if any(value is None for value in values):
            raise InputError(error(code))
        return tuple(values)

    def _time(self, name: str, what: str):
        field = widgets.number(
            name, suffix=" s", decimals=1, low=0, high=1e6, step=30,
            tip=f"Correlation time of the {what} error of the POS, seconds",
        )  # fmt: skip
        field.valueChanged.connect(self.changed)
        return field

    def _optional(self, *parts) -> OptionalNumber:
        field = OptionalNumber(*parts)
        field.textChanged.connect(self.changed)
        return field

    def _show_noise(self) -> None:
        kind = self.noise.currentIndex()
        for k, each in enumerate((self._same, self._three, self._two)):
            self._form.setRowVisible(each, k == kind)
        self.changed.emit()


def _row(*fields: QWidget) -> QWidget:
    made = QWidget()
    row = QHBoxLayout(made)
    row.setContentsMargins(0, 0, 0, 0)
    row.setSpacing(4)
    for field in fields:
        row.addWidget(field)
    return made


def _kept(shown: float, before: float, step: float) -> float:
    """What was not moved keeps all its figures."""
    return before if abs(shown - before) < step else shown
