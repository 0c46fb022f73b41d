"""Dialogue to enter the coordinates of a seed."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QFormLayout, QHBoxLayout, QLineEdit, QWidget

from lispac.errors import InputError, ProjectError
from lispac.geometry.frames import east_north_up
from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.pick_targets.actions import ACTIONS
from lispac.gui.project.seed_options import SeedOptions
from lispac.gui.widgets.error_box import exception_text
from lispac.gui.widgets.number_input import parse_number
from lispac.gui.widgets.system_choice import CoordinateSystemFields
from lispac.io.text.text_table import find_coordinates, parse_coordinate
from lispac.language import N_, gettext
from lispac.messages import error
from lispac.present.survey.measured_point import AXIS_TITLES, UNIT_SIGNS, copied_point
from lispac.project import Project, Triple, require_target_name
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.project.coordinates import (
    LocalAxes,
    axis_names,
    axis_units,
    distances_from_trajectory,
    require_near_trajectory,
)

ALL_LINES_INTRODUCTIONS = {
    "plane": N_("The program searches all lines for a plane target near these coordinates."),
    "sphere": N_("The program searches all lines for a sphere target near these coordinates."),
    "validation": N_(
        "The program searches all lines for a validation plane near these coordinates."
    ),
}
"""Introduction of the dialogue, by shape of the target or by role."""
ONE_LINE_INTRODUCTIONS = {
    "plane": N_("The program searches only line {line} for a plane target near these coordinates."),
    "sphere": N_(
        "The program searches only line {line} for a sphere target near these coordinates."
    ),
    "validation": N_(
        "The program searches only line {line} for a validation plane near these coordinates."
    ),
}
"""Introduction of the dialogue if only one line is searched."""


LOCAL_AXES: LocalAxes = "east, north, up"
"""Order of coordinates in the local frame, as in the read-out of the view and in the report."""


class SeedCoordinatesDialog(QDialog):
    """Fields for name and coordinates, checked while the user types."""

    def __init__(
        self,
        project: Project,
        trajectory: LocalTrajectory,
        seed_options: SeedOptions,
        name: str,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setObjectName("seed_dialog")
        self.setWindowTitle(dialog_title(ACTIONS["seed_coordinates"]))
        self.setMinimumWidth(530)
        self._project, self._trajectory, self._seed_options = project, trajectory, seed_options
        self._position: Triple | None = None
        layout = widgets.vertical_layout(self, 16)
        layout.addWidget(widgets.label(_introduction(seed_options), wrap=True))
        self.name = QLineEdit(name)
        self.name.setObjectName("seed_name")
        self.name.setToolTip(gettext("Name of the new target"))
        # The sighting is added to the selected target, which keeps its name.
        self._adds_sighting = seed_options.line is not None and name == seed_options.selected
        self.name.setEnabled(not self._adds_sighting)
        self.choice = CoordinateSystemFields(project, trajectory, "seed", self, LOCAL_AXES)
        self.fields = tuple(_field(f"seed_coordinate_{k}") for k in range(3))
        self._form = QFormLayout()
        self._form.setVerticalSpacing(theme.SPACING)
        self._form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self._form.addRow(gettext("Name"), self.name)
        self.choice.add_to(self._form)
        for field in self.fields:
            self._form.addRow(" ", field)
        layout.addLayout(self._form)
        self.message_label = widgets.label("", "muted", wrap=True, name="seed_message")
        self.message_label.setMinimumHeight(3 * self.fontMetrics().lineSpacing())
        self.message_label.setAlignment(Qt.AlignmentFlag.AlignTop)
        layout.addWidget(self.message_label)
        self.find_button = widgets.button(gettext("Find"), "seed_find", primary=True)
        self.find_button.setDefault(True)
        self.find_button.clicked.connect(self.accept)
        cancel = widgets.button(gettext("Cancel"), "seed_cancel")
        cancel.clicked.connect(self.reject)
        cancel.setAutoDefault(False)  # Enter starts the search, wherever the focus is
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_platform_order(self.find_button, cancel):
            row.addWidget(each)
        layout.addLayout(row)
        QWidget.setTabOrder(self.fields[2], self.find_button)
        QWidget.setTabOrder(self.find_button, cancel)
        self.choice.changed.connect(self._check_input)
        self.name.textChanged.connect(self._check_input)
        for field in self.fields:
            field.textChanged.connect(self._on_typed)
        self.fields[0].setFocus()
        self._check_input()

    @property
    def seed(self) -> tuple[str, Triple] | None:
        """Name, and position in the local frame in metres; None if the input is invalid."""
        return None if self._position is None else (self.name.text().strip(), self._position)

    def _on_typed(self, text: str) -> None:
        """Split three pasted numbers, or the copied values of a point, over the three fields."""
        if self.sender() is self.fields[0] and (parts := self._pasted_coordinates(text)):
            for field, part in zip(self.fields, parts, strict=True):
                field.blockSignals(True)
                field.setText(part)
                field.blockSignals(False)
        self._check_input()

    def _pasted_coordinates(self, text: str) -> Sequence[str] | None:
        """Three coordinates in a text; chooses the coordinate system of copied values."""
        point = copied_point(text)
        if point is None:
            return find_coordinates(text)
        self.choice.choose(point.coordinates.keys())
        system = self.choice.system
        axes = axis_names(system, LOCAL_AXES)
        is_other = system is not None and point.system not in ("", system.name)
        if is_other or set(axes) != set(point.coordinates):
            return None
        return [point.coordinates[axis] for axis in axes]

    def _check_input(self) -> None:
        axes, units = axis_names(self.choice.system, LOCAL_AXES), self._units
        for field, axis, unit in zip(self.fields, axes, units, strict=True):
            name = f"{_axis_label(axis)} ({unit})"
            self._form.labelForField(field).setText(name)
            field.setAccessibleName(name)
        self._position = None
        role, text = "muted", ""
        if not self.choice.waiting:
            try:
                text = self._describe_coordinates()
            except (InputError, ProjectError) as failure:
                role, text = "error", exception_text(failure)
        self.message_label.setText(text)
        self.message_label.setProperty("role", role)
        self.message_label.style().unpolish(self.message_label)
        self.message_label.style().polish(self.message_label)
        self.find_button.setEnabled(self._position is not None)

    @property
    def _units(self) -> Sequence[str]:
        """Signs of the units of the three coordinates."""
        if self.choice.system is None:
            return ("m", "m", "m")
        return [UNIT_SIGNS.get(unit, unit) for unit in axis_units(self.choice.system)]

    def _describe_coordinates(self) -> str:
        """Describe the typed coordinates, and set the position if they are complete.

        Raises
        ------
        InputError
            If a coordinate is not a number, the system is unknown or the position too far away.
        ProjectError
            If the name cannot be used.
        """
        if self.choice.problem is not None:
            raise InputError(self.choice.problem.reason)
        name = self.name.text().strip()
        if not self._adds_sighting:
            require_target_name(name)
            if any(target.name == name for target in self._project.targets):
                raise ProjectError(error("window.name_taken", name=name))
        system = self.choice.system
        axes = axis_names(system, LOCAL_AXES)
        values = []
        for field, axis, unit in zip(self.fields, axes, self._units, strict=True):
            text = field.text().strip()
            values.append(_parse_coordinate(text, axis, unit))
            wrong = bool(text) and values[-1] is None
            field.setProperty("wrong", wrong)
            field.style().unpolish(field)
            field.style().polish(field)
        for field, axis, value in zip(self.fields, axes, values, strict=True):
            if value is None and field.text().strip():
                label, text = _axis_label(axis), field.text().strip()
                raise InputError(error("window.not_a_number", field=label, text=text))
        point = np.array([value for value in values if value is not None])
        if len(point) < 3:
            pairs = zip(axes, values, strict=True)
            missing = [_axis_label(axis) for axis, value in pairs if value is None]
            return gettext("Enter {coordinates:names}.", coordinates=missing)
        place = require_near_trajectory(point, system, self._trajectory, name, LOCAL_AXES)
        self._position = (float(place[0]), float(place[1]), float(place[2]))
        distance = float(distances_from_trajectory(place[None], self._trajectory)[0])
        if system is None:
            return gettext("Distance from the trajectory: {distance:m.1} m.", distance=distance)
        east, north, up = east_north_up(self._position)
        text = gettext(
            "Local frame: east {east:m.3} m, north {north:m.3} m, up {up:m.3} m. Distance from "
            "the trajectory: {distance:m.1} m.",
            east=east, north=north, up=up, distance=distance,
        )  # fmt: skip
        return " ".join([text, *map(message_text, system.assumptions)])


def _introduction(seed_options: SeedOptions) -> str:
    """Text on how the seed is used."""
    kind = seed_options.shape if seed_options.role == "target" else "validation"
    if seed_options.line is None:
        first = gettext(ALL_LINES_INTRODUCTIONS[kind])
    else:
        first = gettext(ONE_LINE_INTRODUCTIONS[kind], line=seed_options.line)
    second = gettext(
        "The search uses the settings of step 2, such as search radius and threshold. The result "
        "is shown before it is added."
    )
    return f"{first}\n{second}"


def _parse_coordinate(text: str, axis: str, unit: str) -> float | None:
    """Coordinate in its unit; None if the text is not a number."""
    if axis not in ("longitude", "latitude"):
        return parse_number(text, unit)
    number = parse_number(text, "°")
    return parse_coordinate(text, degrees=True) if number is None else number


def _axis_label(axis: str) -> str:
    return gettext(AXIS_TITLES[axis])


def _field(name: str) -> QLineEdit:
    field = QLineEdit()
    field.setObjectName(name)
    field.setAlignment(Qt.AlignmentFlag.AlignRight)
    field.setFont(theme.tabular_font(field.font()))
    field.setToolTip(
        gettext(
            "Paste three numbers, or a point copied in the 3D view, into the first field to fill "
            "in all three fields"
        )
    )
    return field
