"""With what is surveyed: POS, scanner, and how the adjustment takes the POS errors."""

from dataclasses import replace
from math import isclose

import numpy as np
from PySide6.QtCore import Signal
from PySide6.QtWidgets import QFormLayout, QHBoxLayout, QLineEdit, QScrollArea, QWidget

from lispac.design.plan import System
from lispac.design.scenarios import GRADES
from lispac.gui.design import edits
from lispac.gui.design.workspace import Workspace
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.number_field import ALIKE
from lispac.report.design_words import NAMES

OWN = "own numbers"


def _number(name, unit, decimals, low, high, step, tip):
    return widgets.number(
        name, suffix=f" {unit}", decimals=decimals, low=low, high=high, step=step,
        tip=tip, ranged=True,
    )  # fmt: skip


class SystemPanel(QScrollArea):
    """Every field is an edit of the plan, and follows undo."""

    library_asked = Signal()
    """Sigmas are to come from the sensor library."""

    def __init__(self, workspace: Workspace) -> None:
        super().__init__()
        self.setObjectName("design_system")
        self.setWidgetResizable(True)
        self._work, self._showing = workspace, False
        self.title = QLineEdit()
        self.title.setObjectName("design_title")
        self.title.setAccessibleName(say("Title of the plan"))
        self.title.setToolTip(say("Title of the plan, as it stands on the field plan"))
        self.title.setMaxLength(80)
        self.grade = widgets.Choice(
            "design_grade", [*GRADES, OWN],
            "Class of the POS: what data sheets state for such, rounded",
        )  # fmt: skip
        self.model = widgets.Choice(
            "design_pos_errors", list(NAMES.values()),
            "Stochastic model of the POS errors: correlated in time, or uncorrelated",
        )  # fmt: skip
        for choice in (self.grade, self.model):
            choice.setAccessibleName(choice.toolTip())
            choice.setSizeAdjustPolicy(choice.SizeAdjustPolicy.AdjustToContents)
        self.position = [
            _number(f"design_sigma_{axis}", "mm", 1, 0.1, 10_000.0, 1.0,
                    f"POS error {axis}, 1 sigma")
            for axis in ("north", "east", "up")
        ]  # fmt: skip
        self.attitude = [
            _number(f"design_sigma_{axis}", "°", 4, 0.0001, 10.0, 0.001,
                    f"POS error of {axis}, 1 sigma")
            for axis in ("roll", "pitch", "heading")
        ]  # fmt: skip
        self.times = [
            _number("design_time_position", "s", 0, 1.0, 100_000.0, 10.0,
                    "For how long position errors stay alike"),
            _number("design_time_attitude", "s", 0, 1.0, 100_000.0, 10.0,
                    "For how long attitude errors stay alike"),
        ]  # fmt: skip
        self.flatness = _number("design_flatness", "mm", 2, 0.0, 100.0, 0.1,
                                "How far one line sees a target off its shape")  # fmt: skip
        self.pulses = _number("design_pulses", "kHz", 1, 0.1, 10_000.0, 10.0,
                              "Pulses of the scanner")  # fmt: skip
        self.profiles = _number("design_profiles", "Hz", 1, 0.1, 10_000.0, 10.0,
                                "Profiles of the scanner")  # fmt: skip
        self.range_sigma = _number("design_range_sigma", "mm", 2, 0.01, 1000.0, 0.5,
                                   "Noise of a range, 1 sigma")  # fmt: skip
        self.max_range = _number("design_max_range", "m", 0, 1.0, 10_000.0, 10.0,
                                 "Farthest the scanner sees")  # fmt: skip
        self.minutes = _number("design_minutes_line", "min", 1, 0.1, 600.0, 0.5,
                               "From one line to the next, with the turn")  # fmt: skip
        self.facing = widgets.number(
            "design_facing", suffix=" °", decimals=0, low=0.0, high=359.0, step=5.0,
            tip="Azimuth the wall faces; the whole site turns", ranged=True, fixed=True,
        )  # fmt: skip
        self.library = widgets.button(
            "From the sensor library…", "design_sensors",
            tip="Take the sigmas of a scanner and of an INS/GNSS from the library",
        )  # fmt: skip
        self.library.clicked.connect(lambda _=False: self.library_asked.emit())
        form = QFormLayout()
        form.setFieldGrowthPolicy(form.FieldGrowthPolicy.FieldsStayAtSizeHint)
        self.title.setMinimumWidth(300)
        for label, fields in (
            ("Title", [self.title]), ("Sensors", [self.library]), ("POS", [self.grade]),
            ("Adjustment takes", [self.model]),
            ("North, east, up", self.position), ("Roll, pitch, heading", self.attitude),
            ("Position, attitude drift in", self.times), ("Targets are flat to", [self.flatness]),
            ("Pulses, profiles", [self.pulses, self.profiles]),
            ("Range noise, reach", [self.range_sigma, self.max_range]),
            ("A line takes", [self.minutes]), ("Wall faces", [self.facing]),
        ):  # fmt: skip
            row = QHBoxLayout()
            row.setContentsMargins(0, 0, 0, 0)
            for field in fields:
                row.addWidget(field)
            row.addStretch(1)
            form.addRow(say(label), row)
        body = QWidget()
        body.setLayout(form)
        self.setWidget(body)
        self._numbers = [
            *self.position, *self.attitude, *self.times, self.flatness, self.pulses, self.profiles,
            self.range_sigma, self.max_range, self.minutes,
        ]  # fmt: skip
        for field in self._numbers:
            field.valueChanged.connect(lambda _v, field=field: self._edit(field.objectName()))
        self.grade.activated.connect(self._take_grade)
        self.model.activated.connect(lambda _k: self._edit("POS errors"))
        self.facing.valueChanged.connect(self._turn)
        self.title.textEdited.connect(self._name)
        workspace.changed.connect(self._show)
        self._show()

    def _show(self) -> None:
        titled = self._work.titled
        plan, system, pos = titled.plan, titled.plan.system, titled.plan.system.pos
        values = [
            *(1000 * v for v in pos.sigma_position), *np.degrees(pos.sigma_attitude),
            pos.time_position, pos.time_attitude, 1000 * plan.flatness,
            system.scanner.pulses_per_second / 1000, system.scanner.turns_per_second,
            1000 * system.scanner.range_sigma, system.scanner.max_range, plan.interval / 60,
        ]  # fmt: skip
        self._showing = True
        for field, value in zip(
            [*self._numbers, self.facing], [*values, titled.wall.facing_deg], strict=True
        ):
            if not isclose(field.value(), value, abs_tol=ALIKE):
                field.setValue(float(value))
        grades = [each == pos for each in GRADES.values()]
        self.grade.setCurrentIndex(grades.index(True) if any(grades) else len(grades))
        self.model.setCurrentIndex(list(NAMES).index(system.pos_errors))
        if self.title.text().strip() != titled.title:
            self.title.setText(titled.title)
        self._showing = False

    def _take_grade(self, which: int) -> None:
        if which < len(GRADES):
            system = self._work.titled.plan.system
            pos = list(GRADES.values())[which]
            self._change("POS", replace(system, pos=pos))

    def _edit(self, name: str) -> None:
        """One field changed: the others keep their full digits."""
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
        errors = list(NAMES)[self.model.currentIndex()]
        plan = replace(plan, system=replace(system, scanner=scanner, pos=pos, pos_errors=errors))
        if name == "design_flatness":
            plan = replace(plan, flatness=self.flatness.value() / 1000)
        elif name == "design_minutes_line":
            plan = replace(plan, interval=60 * self.minutes.value())
        self._work.edit("system", replace(self._work.titled, plan=plan), name)

    def _change(self, words: str, system: System) -> None:
        self._work.edit(words, edits.with_system(self._work.titled, system))

    def _turn(self, facing: float) -> None:
        if not self._showing:
            self._work.edit("wall faces", edits.wall_faces(self._work.titled, facing), "facing")

    def _name(self, title: str) -> None:
        if title.strip():
            self._work.edit("title", replace(self._work.titled, title=title.strip()), "title")
        else:
            self._work.refused.emit("Title: give the plan a name.")
