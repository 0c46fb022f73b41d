"""Form of the survey system: POS, scanner and their errors; choice of sensors of the library."""

from dataclasses import replace
from math import isclose
from pathlib import Path

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QDialog, QFormLayout, QHBoxLayout, QLineEdit, QScrollArea, QWidget

from lispac.design.plan import System
from lispac.design.scenarios import POS_CLASSES
from lispac.gui import widgets
from lispac.gui.appearance import theme
from lispac.gui.features.design import edits
from lispac.gui.features.design.workspace import Workspace
from lispac.gui.widgets.number_field import EQUAL_TOLERANCE
from lispac.gui.widgets.sensor_choice import SensorChoice
from lispac.io.config.sensor_file import PosAccuracy, ScannerSpecification
from lispac.language import N_, LazyText, gettext, gettext_lazy
from lispac.present.calibration.settings import POS_ERROR_MODEL_NAMES
from lispac.workflow.planning.sensors import read_library

USER_DEFINED_TEXT = N_("user-defined")
AXIS_NAMES = {"north": N_("north"), "east": N_("east"), "up": N_("up")}
ATTITUDE_ANGLE_NAMES = {"roll": N_("roll"), "pitch": N_("pitch"), "heading": N_("heading")}


def _number_field(name, unit, decimals, low, high, step, tip):
    return widgets.number(
        name, suffix=f" {unit}", decimals=decimals, low=low, high=high, step=step,
        tip=tip, ranged=True,
    )  # fmt: skip


class SystemPanel(QScrollArea):
    """Form that edits the system of the plan and follows undo and redo."""

    library_requested = Signal()
    """The user requests the standard deviations of sensors of the library."""

    def __init__(self, workspace: Workspace) -> None:
        super().__init__()
        self.setObjectName("design_system")
        self.setWidgetResizable(True)
        self._work, self._showing = workspace, False
        self.title = QLineEdit()
        self.title.setObjectName("design_title")
        self.title.setAccessibleName(gettext("Title of the survey plan"))
        self.title.setToolTip(gettext("Title of the survey plan, printed on the field plan"))
        self.title.setMaxLength(80)
        self.grade = widgets.ChoiceBox(
            "design_grade", [*map(gettext, POS_CLASSES), gettext(USER_DEFINED_TEXT)],
            gettext("Class of the POS, with typical standard deviations from data sheets"),
        )  # fmt: skip
        self.model = widgets.ChoiceBox(
            "design_pos_errors", list(map(gettext, POS_ERROR_MODEL_NAMES.values())),
            gettext("Stochastic model of the POS errors: correlated or uncorrelated in time"),
        )  # fmt: skip
        for choice in (self.grade, self.model):
            choice.setAccessibleName(choice.toolTip())
            choice.setSizeAdjustPolicy(choice.SizeAdjustPolicy.AdjustToContents)
        self.position = [
            _number_field(f"design_sigma_{axis}", "mm", 1, 0.1, 10_000.0, 1.0,
                    gettext("Standard deviation of the POS position, {axis}", axis=gettext(title)))
            for axis, title in AXIS_NAMES.items()
        ]  # fmt: skip
        self.attitude = [
            _number_field(f"design_sigma_{axis}", "°", 4, 0.0001, 10.0, 0.001,
                    gettext("Standard deviation of the POS attitude, {angle}",
                            angle=gettext(title)))
            for axis, title in ATTITUDE_ANGLE_NAMES.items()
        ]  # fmt: skip
        self.lever_arm = [
            _number_field(f"design_sigma_lever_{axis}", "mm", 1, 0.0, 10_000.0, 1.0,
                    gettext("Lever arm {axis} (1 σ)", axis=axis.upper()))
            for axis in "xyz"
        ]  # fmt: skip
        self.times = [
            _number_field("design_time_position", "s", 0, 1.0, 100_000.0, 10.0,
                    gettext("Correlation time of the position errors")),
            _number_field("design_time_attitude", "s", 0, 1.0, 100_000.0, 10.0,
                    gettext("Correlation time of the attitude errors")),
        ]  # fmt: skip
        self.flatness = _number_field("design_flatness", "mm", 2, 0.0, 100.0, 0.1,
                                gettext("Form error of the targets, 1σ"))  # fmt: skip
        self.pulses = _number_field("design_pulses", "kHz", 1, 0.1, 10_000.0, 10.0,
                              gettext("Pulse rate of the scanner"))  # fmt: skip
        self.profiles = _number_field("design_profiles", "Hz", 1, 0.1, 10_000.0, 10.0,
                                gettext("Profile rate of the scanner"))  # fmt: skip
        self.range_sigma = _number_field("design_range_sigma", "mm", 2, 0.01, 1000.0, 0.5,
                                   gettext("Standard deviation of a range measurement")
                                   )  # fmt: skip
        self.max_range = _number_field("design_max_range", "m", 0, 1.0, 10_000.0, 10.0,
                                 gettext("Maximum range of the scanner"))  # fmt: skip
        self.minutes = _number_field("design_minutes_line", "min", 1, 0.1, 600.0, 0.5,
                               gettext("Time from the start of one line to the start of the next, "
                                       "turn included"))  # fmt: skip
        self.facing = widgets.number(
            "design_facing", suffix=" °", decimals=0, low=0.0, high=359.0, step=5.0,
            tip=gettext("Azimuth of the direction that the wall faces (a change rotates the whole "
                        "site)"),
            ranged=True, fixed=True,
        )  # fmt: skip
        self.library = widgets.button(
            gettext("Choose from sensor library…"), "design_sensors",
            tip=gettext("Use the standard deviations of a scanner and an INS/GNSS from the sensor "
                        "library"),
        )  # fmt: skip
        self.library.clicked.connect(lambda _=False: self.library_requested.emit())
        self._arrange()
        self._numbers = [
            *self.position, *self.attitude, *self.lever_arm, *self.times, self.flatness,
            self.pulses, self.profiles, self.range_sigma, self.max_range, self.minutes,
        ]  # fmt: skip
        for field in self._numbers:
            field.valueChanged.connect(lambda _v, field=field: self._edit(field.objectName()))
        self.grade.activated.connect(self._set_pos_class)
        self.model.activated.connect(lambda _k: self._edit("POS errors"))
        self.facing.valueChanged.connect(self._turn_wall)
        self.title.textEdited.connect(self._set_title)
        workspace.changed.connect(self._show)
        self._show()

    def _arrange(self) -> None:
        """Place the fields in the rows of a form."""
        form = QFormLayout()
        form.setFieldGrowthPolicy(form.FieldGrowthPolicy.FieldsStayAtSizeHint)
        self.title.setMinimumWidth(300)
        for label, fields in (
            (gettext("Title"), [self.title]), (gettext("Sensors"), [self.library]),
            (gettext("POS class"), [self.grade]), (gettext("Stochastic model"), [self.model]),
            (gettext("Position σ (north, east, up)"), self.position),
            (gettext("Attitude σ (roll, pitch, heading)"), self.attitude),
            (gettext("Lever-arm sigma (forward, left, up)"), self.lever_arm),
            (gettext("Correlation time (position, attitude)"), self.times),
            (gettext("Form error of targets"), [self.flatness]),
            (gettext("Pulse rate, profile rate"), [self.pulses, self.profiles]),
            (gettext("Range σ, maximum range"), [self.range_sigma, self.max_range]),
            (gettext("Time per line"), [self.minutes]), (gettext("Wall azimuth"), [self.facing]),
        ):  # fmt: skip
            row = QHBoxLayout()
            row.setContentsMargins(0, 0, 0, 0)
            for field in fields:
                row.addWidget(field)
            row.addStretch(1)
            form.addRow(label, row)
        body = QWidget()
        body.setLayout(form)
        self.setWidget(body)

    def _show(self) -> None:
        titled = self._work.titled
        plan, system, pos = titled.plan, titled.plan.system, titled.plan.system.pos
        values = [
            *(1000 * v for v in pos.sigma_position), *np.degrees(pos.sigma_attitude),
            *(1000 * v for v in system.lever_arm_sigma),
            pos.time_position, pos.time_attitude, 1000 * plan.flatness,
            system.scanner.pulses_per_second / 1000, system.scanner.turns_per_second,
            1000 * system.scanner.range_sigma, system.scanner.max_range, plan.interval / 60,
        ]  # fmt: skip
        self._showing = True
        for field, value in zip(
            [*self._numbers, self.facing], [*values, titled.wall.facing_deg], strict=True
        ):
            if not isclose(field.value(), value, abs_tol=EQUAL_TOLERANCE):
                field.setValue(float(value))
        grades = [each == pos for each in POS_CLASSES.values()]
        self.grade.setCurrentIndex(grades.index(True) if any(grades) else len(grades))
        self.model.setCurrentIndex(list(POS_ERROR_MODEL_NAMES).index(system.pos_errors))
        if self.title.text().strip() != titled.title:
            self.title.setText(titled.title)
        self._showing = False

    def _set_pos_class(self, which: int) -> None:
        if which < len(POS_CLASSES):
            system = self._work.titled.plan.system
            pos = list(POS_CLASSES.values())[which]
            self._set_system(gettext_lazy("POS class"), replace(system, pos=pos))

    def _edit(self, name: str) -> None:
        """Apply one field to the plan; other values of the plan keep all their digits."""
        if self._showing:
            return
        plan = self._work.titled.plan
        system, scanner, pos = plan.system, plan.system.scanner, plan.system.pos
        kept = {
            **{f.objectName(): k for k, f in enumerate(self.position)},
            **{f.objectName(): k for k, f in enumerate(self.attitude)},
        }
        if name in kept and any(f.objectName() == name for f in self.position):
            sigma = list(pos.sigma_position)
            sigma[kept[name]] = self.position[kept[name]].value() / 1000
            pos = replace(pos, sigma_position=tuple(sigma))
        elif name in kept:
            sigma = list(pos.sigma_attitude)
            sigma[kept[name]] = float(np.radians(self.attitude[kept[name]].value()))
            pos = replace(pos, sigma_attitude=tuple(sigma))
        elif any(field.objectName() == name for field in self.lever_arm):
            x, y, z = (field.value() / 1000 for field in self.lever_arm)
            system = replace(system, lever_arm_sigma=(x, y, z))
        elif name == "design_time_position":
            pos = replace(pos, time_position=self.times[0].value())
        elif name == "design_time_attitude":
            pos = replace(pos, time_attitude=self.times[1].value())
        elif name == "design_pulses":
            scanner = replace(scanner, pulses_per_second=1000 * self.pulses.value())
        elif name == "design_profiles":
            scanner = replace(scanner, turns_per_second=self.profiles.value())
        elif name == "design_range_sigma":
            scanner = replace(scanner, range_sigma=self.range_sigma.value() / 1000)
        elif name == "design_max_range":
            scanner = replace(scanner, max_range=self.max_range.value())
        errors = list(POS_ERROR_MODEL_NAMES)[self.model.currentIndex()]
        plan = replace(plan, system=replace(system, scanner=scanner, pos=pos, pos_errors=errors))
        if name == "design_flatness":
            plan = replace(plan, flatness=self.flatness.value() / 1000)
        elif name == "design_minutes_line":
            plan = replace(plan, interval=60 * self.minutes.value())
        self._work.edit(gettext_lazy("Survey system"), replace(self._work.titled, plan=plan), name)

    def _set_system(self, name: LazyText, system: System) -> None:
        self._work.edit(name, edits.with_system(self._work.titled, system))

    def _turn_wall(self, facing: float) -> None:
        if not self._showing:
            turned = edits.with_wall_facing(self._work.titled, facing)
            self._work.edit(gettext_lazy("Orientation of the wall"), turned, "facing")

    def _set_title(self, title: str) -> None:
        if title.strip():
            renamed = replace(self._work.titled, title=title.strip())
            self._work.edit(gettext_lazy("Title"), renamed, "title")
        else:
            self._work.refused.emit(
                gettext("The title is empty. Enter a title for the survey plan.")
            )


Sensors = tuple[ScannerSpecification | None, PosAccuracy | None]


class PlanSensorsDialog(QDialog):
    """Choice of scanner and INS/GNSS; without a choice, the plan keeps its values.

    Parameters
    ----------
    folder : folder of the user-defined sensors
    """

    def __init__(self, folder: Path, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("plan_sensors")
        self.setWindowTitle(gettext("Sensors of the survey plan"))
        self.setMinimumWidth(520)
        self._scanner: ScannerSpecification | None = None
        self._pos: PosAccuracy | None = None
        layout = widgets.vertical_layout(self, 16)
        layout.addWidget(
            widgets.label(
                gettext(
                    "The standard deviations of the chosen sensors are copied to the survey plan. "
                    "If no sensor is chosen, the survey plan keeps its values."
                ),
                wrap=True,
            )
        )
        self.choice = SensorChoice(read_library(folder), "plan")
        self.choice.scanner_chosen.connect(self._set_scanner)
        self.choice.pos_chosen.connect(self._set_pos)
        form = QFormLayout()
        form.setVerticalSpacing(theme.SPACING)
        form.addRow(gettext("Scanner"), self.choice.scanner)
        form.addRow("", self.choice.scanner_origin)
        form.addRow(gettext("INS/GNSS"), self.choice.pos)
        form.addRow("", self.choice.pos_origin)
        layout.addLayout(form)
        self.take = widgets.button(gettext("Use these sensors"), "plan_sensors_take", primary=True)
        self.take.setDefault(True)
        self.take.clicked.connect(self.accept)
        cancel = widgets.button(gettext("Cancel"), "plan_sensors_cancel")
        cancel.setAutoDefault(False)
        cancel.clicked.connect(self.reject)
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_platform_order(self.take, cancel):
            row.addWidget(each)
        layout.addLayout(row)

    @property
    def sensors(self) -> Sensors:
        """The chosen sensors; None if the plan keeps its values."""
        scanner, pos = self.choice.names
        return (self._scanner if scanner else None, self._pos if pos else None)

    def _set_scanner(self, figures: ScannerSpecification) -> None:
        self._scanner = figures

    def _set_pos(self, state: PosAccuracy) -> None:
        self._pos = state
