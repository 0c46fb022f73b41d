"""Page of the import dialogue for the mounting and the accuracies of a new project."""

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import (
    QCheckBox,
    QFormLayout,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QScrollArea,
)

from lispac.adjustment.model.stochastic_model import ASSUMED_LIDAR_SIGMA
from lispac.geometry.frames import LocalFrame
from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.widgets.mounting_sketch import MountingView
from lispac.gui.widgets.pos_sigmas import PosSigmaFields
from lispac.gui.widgets.sensor_choice import SensorChoice
from lispac.io.config.sensor_file import PosAccuracy, ScannerSpecification
from lispac.language import gettext
from lispac.messages import Message
from lispac.project import Settings, Triple
from lispac.survey.lever_arm_warnings import lever_arm_warnings
from lispac.survey.trajectory import TrajectoryAccuracy
from lispac.workflow.planning.sensors import SensorLibrary

GEOGRAPHIC_FIELDS = ("new_latitude", "new_longitude")
"""Names of the fields that are always in degrees, independent of the unit of angles."""


class MountingPage(QScrollArea):
    """Fields for lever arm, prior boresight, origin and standard deviations."""

    changed = Signal()

    def __init__(self, library: SensorLibrary) -> None:
        super().__init__()
        self._mean_position: LocalFrame | None = None
        self.sensors = SensorChoice(library, "new")
        self.setAccessibleName(gettext("Mounting and accuracies"))
        self.setWidgetResizable(True)
        body = widgets.WrappedBody()
        grid = QGridLayout(body)
        grid.setContentsMargins(16, 12, 16, 12)
        grid.setHorizontalSpacing(36)
        grid.setVerticalSpacing(theme.SPACING)
        grid.addWidget(widgets.label(gettext("Mounting"), "heading"), 0, 0)
        grid.addLayout(self._mounting_form(), 1, 0, Qt.AlignmentFlag.AlignTop)
        grid.addWidget(widgets.label(gettext("Uncertainties"), "heading"), 0, 1)
        grid.addLayout(self._uncertainty_form(), 1, 1, Qt.AlignmentFlag.AlignTop)
        grid.setColumnStretch(0, 1)
        grid.setColumnStretch(1, 1)
        grid.setRowStretch(2, 1)
        self.setWidget(body)
        body.setAutoFillBackground(False)
        for field in (*self.lever_arm.fields, *self.boresight.fields):
            field.valueChanged.connect(self.changed)
            field.valueChanged.connect(self._draw_mounting)

    def settings(self) -> Settings:
        """Settings of the project from the fields."""
        noise, angle = self.lidar_sigma.value() / 1000, self.angle_sigma.value()
        lever_arm_sigma = self.lever_arm_sigma.value()
        position, attitude = self._entered or self.pos_sigmas.values()
        return Settings(
            lever_arm=self.lever_arm.value(),
            boresight_deg=self.boresight.value(),
            origin_deg_m=self.origin.value() if self.origin_given.isChecked() else None,
            lever_arm_sigma=lever_arm_sigma if any(lever_arm_sigma) else None,
            beam_divergence_mrad=self.divergence.value() or None,
            position_sigma=position,
            attitude_sigma_deg=attitude,
            lidar_sigma=None if self.lidar_sigma.is_assumed else noise,
            lidar_beam_sigma=(noise, angle) if angle > 0 else None,
        )

    @property
    def mounting_warnings(self) -> tuple[Message, ...]:
        """Warnings about the mounting."""
        return lever_arm_warnings(self.lever_arm.value())

    def set_mean_position(self, frame: LocalFrame | None) -> None:
        """Set the position at which an entered origin begins; None if it is not known."""
        self._mean_position = frame

    def _show_origin(self, is_given: bool) -> None:
        self.origin.setEnabled(is_given)
        frame = self._mean_position
        if is_given and frame is not None and not any(self.origin.value()):
            latitude, longitude = np.degrees([frame.latitude, frame.longitude]).tolist()
            self.origin.set_value((latitude, longitude, frame.height))

    def show_accuracy(self, name: str, accuracy: TrajectoryAccuracy | None) -> None:
        """Show the name and the median values of the accuracy file; if empty, the fields apply."""
        if name and self._entered is None:
            self._entered = self.pos_sigmas.values()
        elif self._entered is not None and not name:
            self.pos_sigmas.show_values(*self._entered)
            self._entered = None
        self.pos_sigmas.set_enabled(not name)
        if name and accuracy is not None:
            self.pos_sigmas.show_medians(accuracy)
        self._source.setText(
            gettext(
                "Position and attitude accuracies are taken from {file}; the medians are shown.",
                file=name,
            )
            if name
            else gettext(
                "There is no accuracy file. The position and attitude accuracies below apply at "
                "all times. Values in grey italics are assumed: enter those of the "
                "processing report."
            )
        )

    def show_prior_needed(self, needed: bool) -> None:
        """Show or hide the text on the mounting of georeferenced lines."""
        self._prior.setVisible(needed)

    def _mounting_form(self) -> QFormLayout:
        form = _create_form()
        self.lever_arm = widgets.lever_arm_fields("new_lever_arm")
        self.boresight = widgets.boresight_fields("new_boresight")
        form.addRow(gettext("Lever arm"), self.lever_arm)
        hint = gettext(
            "From the POS centre to the optical centre of the scanner. Applanix gives Y to "
            "starboard and Z down: enter those two with the opposite sign."
        )
        form.addRow(widgets.label(hint, "muted", wrap=True, name="new_lever_arm_hint"))
        form.addRow(gettext("Prior boresight"), self.boresight)
        self.view = MountingView("new_mounting")
        form.addRow(self.view)
        self._prior = widgets.label(
            gettext(
                "Georeferenced lines are transformed back to the scanner frame. Enter the lever "
                "arm and the boresight with which they were georeferenced."
            ),
            "hint", wrap=True, name="new_prior_hint",
        )  # fmt: skip
        self._prior.hide()
        form.addRow(self._prior)
        self.origin_given = QCheckBox(gettext("Set the origin of the local frame"))
        self.origin_given.setObjectName("new_origin_given")
        self.origin_given.setToolTip(
            gettext("If not ticked, the origin is the mean position of the trajectory")
        )
        self.origin = widgets.TripleField(
            (gettext("Latitude"), gettext("Longitude"), gettext("Height")),
            [
                _number_field("new_latitude", " °", 8, -90, 90),
                _number_field("new_longitude", " °", 8, -180, 360),
                _number_field("new_height", " m", 3, -1000, 10000),
            ],
        )
        self.origin.setEnabled(False)
        self.origin_given.toggled.connect(self._show_origin)
        form.addRow(QLabel(), self.origin_given)
        form.addRow(gettext("Origin"), self.origin)
        return form

    def _uncertainty_form(self) -> QFormLayout:
        form = _create_form()
        self.lidar_sigma = widgets.number(
            "new_lidar_sigma", suffix=" mm", decimals=1, low=0.1, high=1000, step=0.5,
            tip=gettext("Standard deviation of a LiDAR point along each axis, in millimetres"),
        )  # fmt: skip
        self.lidar_sigma.show_assumed(ASSUMED_LIDAR_SIGMA * 1000)
        self.lidar_sigma.setMaximumWidth(140)
        self.pos_sigmas = PosSigmaFields("new_sigma")
        self.pos_sigmas.show_values(None, None)
        self._entered: tuple[Triple | None, Triple | None] | None = None
        """Values that the accuracy file replaces; None without an accuracy file."""
        self.angle_sigma = widgets.angle_noise_field("new_angle_sigma")
        self.angle_sigma.setMaximumWidth(140)
        self.sensors.scanner_chosen.connect(self._set_lidar_noise)
        self.sensors.pos_chosen.connect(self._set_pos_sigmas)
        form.addRow(gettext("Scanner"), self.sensors.scanner)
        form.addRow("", self.sensors.scanner_origin)
        form.addRow(gettext("LiDAR noise (1 σ)"), self._noise_row())
        form.addRow(gettext("Beam angular noise (1 σ)"), self.angle_sigma)
        self.divergence = widgets.divergence_field("new_divergence")
        self.divergence.setMaximumWidth(140)
        form.addRow(gettext("Beam divergence"), self.divergence)
        form.addRow(gettext("INS/GNSS"), self.sensors.pos)
        form.addRow("", self.sensors.pos_origin)
        self._source = widgets.label("", "muted", wrap=True, name="new_sigma_source")
        form.addRow(self._source)
        form.addRow(gettext("Position (1 σ)"), self.pos_sigmas.position)
        form.addRow(gettext("Attitude (1 σ)"), self.pos_sigmas.attitude)
        self.lever_arm_sigma = widgets.lever_arm_sigma_fields("new_lever_arm_sigma")
        form.addRow(gettext("Lever arm (1 σ)"), self.lever_arm_sigma)
        form.addRow(widgets.label(gettext(widgets.LEVER_ARM_SIGMA_HINT), "muted", wrap=True))
        return form

    def _noise_row(self) -> QHBoxLayout:
        """The LiDAR noise, and whether it is only the default."""
        hint = widgets.label(gettext("default, not given"), "muted", name="new_lidar_default")
        policy = hint.sizePolicy()
        policy.setRetainSizeWhenHidden(True)
        hint.setSizePolicy(policy)
        self.lidar_sigma.assumed_changed.connect(hint.setVisible)
        row = QHBoxLayout()
        row.setSpacing(8)
        self.lidar_sigma.setMinimumWidth(self.lidar_sigma.maximumWidth())
        row.addWidget(self.lidar_sigma)
        row.addWidget(hint)
        row.addStretch(1)
        return row

    def _draw_mounting(self) -> None:
        self.view.show_mounting(self.lever_arm.value(), self.boresight.value())

    def _set_lidar_noise(self, scanner: ScannerSpecification) -> None:
        self.lidar_sigma.setValue(scanner.range_sigma * 1000)
        self.angle_sigma.setValue(scanner.angle_sigma_deg)
        self.divergence.setValue(scanner.divergence_mrad)

    def _set_pos_sigmas(self, state: PosAccuracy) -> None:
        chosen = state.position_sigma, state.attitude_sigma_deg
        if self._entered is None:
            self.pos_sigmas.show_values(*chosen)
        else:
            self._entered = chosen


def _create_form() -> QFormLayout:
    form = QFormLayout()
    form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
    form.setLabelAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
    form.setHorizontalSpacing(14)
    form.setVerticalSpacing(theme.SPACING)
    return form


def _number_field(name: str, suffix: str, decimals: int, low: float, high: float):
    return widgets.number(
        name,
        suffix=suffix,
        decimals=decimals,
        low=low,
        high=high,
        step=10.0 ** (1 - decimals),
        fixed=name in GEOGRAPHIC_FIELDS,
    )
