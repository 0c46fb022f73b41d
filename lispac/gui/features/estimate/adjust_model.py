"""Advanced settings: correlation times, form error, outliers, LiDAR noise."""

from dataclasses import replace

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QCheckBox, QFormLayout, QGridLayout, QLabel, QWidget

from lispac.adjustment.model.robust_loss import LossName
from lispac.adjustment.model.stochastic_model import PosErrors
from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.appearance import units
from lispac.gui.widgets.number_input import scroll_to
from lispac.gui.widgets.optional_number import OptionalNumber
from lispac.gui.widgets.result_tables import local_amount
from lispac.language import N_, gettext
from lispac.messages import error
from lispac.present.tables import MILLIMETRES
from lispac.project import Settings

CORRELATION_TIMES_HINT = N_(
    "Time over which the POS error stays correlated: minutes for the position, longer for the "
    "attitude. Take it from the processing report of the trajectory. If in doubt, a shorter "
    "time is safer."
)
LOSSES: tuple[tuple[LossName | None, str, str], ...] = (
    (
        None,
        N_("Automatic"),
        N_("Tukey weights if the POS errors are correlated, full weight if they are uncorrelated"),
    ),
    ("none", N_("Full weight"), N_("Every point keeps its full weight")),
    (
        "huber",
        N_("Less weight (Huber)"),
        N_("The weight of a point decreases if its residual exceeds 1.3 σ, but never reaches zero"),
    ),
    ("tukey", N_("No weight (Tukey)"), N_("Points with a residual above 4.7 σ have zero weight")),
)
"""Name, title and description of each loss."""
LOSS_SUMMARIES: dict[LossName, str] = {
    "none": N_("outliers with full weight"),
    "huber": N_("Huber"),
    "tukey": N_("Tukey"),
}
COMPONENT_CHOICES: tuple[tuple[bool | None, str, str], ...] = (
    (None, N_("Automatic"), N_("Estimate the standard deviations that are assumed")),
    (True, N_("Estimate all"), N_("Estimate all standard deviations, also given ones")),
    (False, N_("None"), N_("Use all standard deviations unchanged")),
)
"""Setting, title and description of each choice of variance components."""
COMPONENT_SUMMARIES = (
    "", N_("variance components estimated"), N_("no variance components"),
)  # fmt: skip
NOISE_TITLES = (N_("One value"), N_("One value per axis"), N_("Range and angle"))
NOISE_SUMMARIES = ("", N_("noise along X, Y, Z"), N_("range and angle noise"))
NOISE_FIELD_WIDTH_PX = 110
"""Width of a field of the LiDAR noise: six digits with their separator and a margin."""
_MM_PER_M = 1e3


class _WrappedText(QLabel):
    """Wrapped text that keeps its whole height, which a form with hidden rows would reduce."""

    def __init__(self, text: str, name: str) -> None:
        super().__init__(text)
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
    """Fields of the stochastic model."""

    changed = Signal()
    """A value is being changed."""
    committed = Signal()
    """A value was changed."""

    def __init__(self) -> None:
        super().__init__()
        form = QFormLayout(self)
        form.setContentsMargins(18, 0, 0, 4)
        form.setHorizontalSpacing(8)
        form.setVerticalSpacing(5)
        form.setRowWrapPolicy(QFormLayout.RowWrapPolicy.WrapLongRows)
        self.position_time = self._time_field(
            "position_time", gettext("Correlation time of the position error of the POS")
        )
        self.attitude_time = self._time_field(
            "attitude_time", gettext("Correlation time of the attitude error of the POS")
        )
        form.addRow(gettext("Correlation time, position"), self.position_time)
        form.addRow(gettext("Correlation time, attitude"), self.attitude_time)
        self.times = _WrappedText(gettext(CORRELATION_TIMES_HINT), "times_sentence")
        form.addRow(self.times)
        self.surface = self._optional_field(
            "surface", gettext("Form error of the targets"), "mm", _MM_PER_M, gettext("estimated"),
            gettext(
                "Standard deviation of the offset and tilt of a target in one line relative to its "
                "surface in all lines"
            ),
        )  # fmt: skip
        form.addRow(gettext("Form error, {unit}", unit=units.shown_unit("mm").sign), self.surface)
        self.loss = widgets.ChoiceBox(
            "loss", [gettext(title) for _, title, _ in LOSSES],
            gettext("Weight of outliers: points far from the surface of their target"),
        )  # fmt: skip
        for k, (_, _, tip) in enumerate(LOSSES):
            self.loss.setItemData(k, gettext(tip), Qt.ItemDataRole.ToolTipRole)
        self.loss.currentIndexChanged.connect(self.committed)
        form.addRow(gettext("Outliers"), self.loss)
        self._add_noise_rows(form)
        self.components = widgets.ChoiceBox(
            "variance_components", [gettext(title) for _, title, _ in COMPONENT_CHOICES],
            gettext(
                "Estimate from the residuals a scale factor for the standard deviations of "
                "LiDAR, POS position and POS attitude. With few sightings, the factors of the "
                "POS are uncertain."
            ),
        )  # fmt: skip
        for k, (_, _, tip) in enumerate(COMPONENT_CHOICES):
            self.components.setItemData(k, gettext(tip), Qt.ItemDataRole.ToolTipRole)
        self.components.currentIndexChanged.connect(self.committed)
        form.addRow(gettext("Variance components"), self.components)
        self.accept_single_orientation = QCheckBox(gettext("Accept a single orientation"))
        self.accept_single_orientation.setObjectName("accept_single_orientation")
        self.accept_single_orientation.setToolTip(
            gettext(
                "Tick this if all targets are on one wall, or if there is only one target. The "
                "angles are then separated only by the headings of the lines, and a bent or "
                "moved target is not detected. A target with another inclination, or a sphere, "
                "is better."
            )
        )
        self.accept_single_orientation.toggled.connect(self.committed)
        form.addRow(self.accept_single_orientation)
        self._form = form
        self._show_noise()

    def _add_noise_rows(self, form: QFormLayout) -> None:
        """Add the model of the LiDAR noise, and one row of fields for each model."""
        self.noise = widgets.ChoiceBox(
            "lidar_noise", [gettext(noise) for noise in NOISE_TITLES],
            gettext("Model of the LiDAR noise: one value, one value per axis, or range and "
                    "angle"),
        )  # fmt: skip
        self.noise.currentIndexChanged.connect(self._show_noise)
        form.addRow(gettext("LiDAR noise"), self.noise)
        self._single_sigma_row = widgets.label("", "muted", wrap=True, name="lidar_same")
        self.axes = []
        for axis in "XYZ":
            self.axes.append(
                self._optional_field(
                    f"lidar_{axis.lower()}", gettext("LiDAR noise along {axis}", axis=axis), "mm",
                    _MM_PER_M, "",
                    gettext("Standard deviation of a LiDAR point along {axis}", axis=axis), True,
                )
            )  # fmt: skip
        self.range = self._optional_field(
            "lidar_range", gettext("LiDAR range noise (1 σ)"), "mm", _MM_PER_M, "",
            gettext("Standard deviation of the range"), True,
        )  # fmt: skip
        self.angle = self._optional_field(
            "lidar_angle", gettext("Beam angular noise (1 σ)"), "°", 1.0, "",
            gettext("Standard deviation of the beam direction"), True,
        )  # fmt: skip
        self._axis_sigmas_row, self._beam_sigmas_row = (
            _labelled_fields(*self.axes),
            _labelled_fields(self.range, self.angle),
        )
        form.addRow("", self._single_sigma_row)
        for each in (self._axis_sigmas_row, self._beam_sigmas_row):
            form.addRow(each)

    def with_chosen_values(self, settings: Settings) -> Settings:
        """Settings with the values of these fields.

        Raises
        ------
        InputError
            If a field contains an invalid value.
        """
        kind = self.noise.currentIndex()
        is_single = settings.lidar_sigma_xyz is None and settings.lidar_beam_sigma is None
        noise = replace(
            settings,
            # One value in place of several is the one shown
            lidar_sigma=settings.lidar_sigma if kind or is_single else settings.used_lidar_sigma,
            lidar_sigma_xyz=self._all_values(self.axes, "window.lidar_axes_incomplete")
            if kind == 1
            else None,
            lidar_beam_sigma=self._all_values(
                (self.range, self.angle), "window.lidar_beam_incomplete"
            )
            if kind == 2
            else None,
        )
        return replace(
            noise,
            lidar_noise_source=settings.lidar_noise_source if noise == settings else "given",
            position_time=_unrounded_value(
                self.position_time.value(), settings.position_time, 0.051
            ),
            attitude_time=_unrounded_value(
                self.attitude_time.value(), settings.attitude_time, 0.051
            ),
            surface=self.surface.value(),
            loss=LOSSES[self.loss.currentIndex()][0],
            variance_components=COMPONENT_CHOICES[self.components.currentIndex()][0],
            accept_single_orientation=self.accept_single_orientation.isChecked(),
        )

    def show_settings(self, settings: Settings) -> None:
        """Fill in the settings without emitting `changed`."""
        self.blockSignals(True)
        self.position_time.setValue(settings.position_time)
        self.attitude_time.setValue(settings.attitude_time)
        self.surface.show_value(settings.surface)
        self.loss.setCurrentIndex([loss for loss, _, _ in LOSSES].index(settings.loss))
        sigma = local_amount(settings.used_lidar_sigma, MILLIMETRES)
        self._single_sigma_row.setText(gettext("{sigma}, as in step 1", sigma=sigma))
        for field, value in zip(
            self.axes, settings.lidar_sigma_xyz or (settings.used_lidar_sigma,) * 3, strict=True
        ):
            field.show_value(value)
        beam = settings.lidar_beam_sigma or (settings.used_lidar_sigma, None)
        self.range.show_value(beam[0])
        self.angle.show_value(beam[1])
        kind = 1 if settings.lidar_sigma_xyz else 2 if settings.lidar_beam_sigma else 0
        self.noise.setCurrentIndex(kind)
        chosen = [value for value, _, _ in COMPONENT_CHOICES].index(settings.variance_components)
        self.components.setCurrentIndex(chosen)
        self.accept_single_orientation.setChecked(settings.accept_single_orientation)
        self.blockSignals(False)

    def show_model(self, pos_errors: PosErrors) -> None:
        """Disable the fields that do not apply to uncorrelated POS errors."""
        for each in (self.position_time, self.attitude_time, self.surface, self.components):
            each.setEnabled(pos_errors == "correlated")

    @property
    def summary(self) -> str:
        """Settings that differ from the defaults."""
        settings = []
        if self.noise.currentIndex():
            settings.append(gettext(NOISE_SUMMARIES[self.noise.currentIndex()]))
        if loss := LOSSES[self.loss.currentIndex()][0]:
            settings.append(gettext(LOSS_SUMMARIES[loss]))
        if self.surface.text().strip():
            settings.append(gettext("given form error"))
        if summary := COMPONENT_SUMMARIES[self.components.currentIndex()]:
            settings.append(gettext(summary))
        if self.accept_single_orientation.isChecked():
            settings.append(gettext("targets of one orientation accepted"))
        return ", ".join(settings)

    @property
    def missing_fields(self) -> list[OptionalNumber]:
        """Empty fields of the chosen model of the LiDAR noise."""
        needed = ([], self.axes, [self.range, self.angle])[self.noise.currentIndex()]
        return [field for field in needed if not field.text().strip()]

    def _all_values(self, fields, code: str):
        if missing := [field for field in fields if field.value() is None]:
            names = tuple(field.accessibleName() for field in missing)
            raise InputError(error(code, fields=names))
        return tuple(field.value() for field in fields)

    def _time_field(self, name: str, tip: str):
        field = widgets.number(name, suffix=" s", decimals=1, low=0, high=1e6, step=30, tip=tip)
        field.lineEdit().textChanged.connect(self.changed)
        field.committed.connect(self.committed)
        return field

    def _optional_field(self, *parts) -> OptionalNumber:
        field = OptionalNumber(*parts)
        field.textChanged.connect(self.changed)
        field.committed.connect(self.committed)
        return field

    def _show_noise(self) -> None:
        kind = self.noise.currentIndex()
        for k, each in enumerate(
            (self._single_sigma_row, self._axis_sigmas_row, self._beam_sigmas_row)
        ):
            self._form.setRowVisible(each, k == kind)
        self.committed.emit()
        if self.missing_fields:  # once the new rows have their places
            QTimer.singleShot(0, self, self._show_missing_field)

    def _show_missing_field(self) -> None:
        """Scroll to the first missing field."""
        if (missing := self.missing_fields) and missing[0].isVisible():
            scroll_to(missing[0])


def _labelled_fields(*fields: OptionalNumber) -> QWidget:
    """Fields below each other, each with its name and unit at its left."""
    widget = QWidget()
    grid = QGridLayout(widget)
    grid.setContentsMargins(0, 0, 0, 0)
    grid.setHorizontalSpacing(8)
    grid.setVerticalSpacing(5)
    grid.setColumnStretch(0, 1)
    for row, field in enumerate(fields):
        title = widgets.label(field.accessibleName(), wrap=True)
        title.setBuddy(field)
        field.setFixedWidth(NOISE_FIELD_WIDTH_PX)
        grid.addWidget(title, row, 0)
        grid.addWidget(field, row, 1)
    return widget


def _unrounded_value(displayed: float, before: float, step: float) -> float:
    """Value with all its digits if the field, which shows it rounded, was not changed."""
    return before if abs(displayed - before) < step else displayed
