"""A seed whose coordinates are typed."""

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog, QFormLayout, QHBoxLayout, QLineEdit, QWidget

from lispac.errors import InputError, ProjectError
from lispac.gui import theme
from lispac.gui.dialogs.system_choice import SystemChoice
from lispac.gui.language import say, say_sentences
from lispac.gui.panels import widgets
from lispac.gui.wishes import Wishes
from lispac.io.text_table import coordinate, coordinates_in
from lispac.messages import error
from lispac.project import Project, Triple, require_name
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.coordinates import away, axes_of, require_near


class SeedDialog(QDialog):
    """Name and coordinates; what is wrong with them is said while they are typed."""

    def __init__(
        self,
        project: Project,
        trajectory: LocalTrajectory,
        wishes: Wishes,
        name: str,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self.setObjectName("seed_dialog")
        self.setWindowTitle(say("Seed at coordinates"))
        self.setMinimumWidth(530)
        self._project, self._trajectory, self._wishes = project, trajectory, wishes
        self._place: Triple | None = None
        layout = widgets.column(self, 16)
        what = wishes.shape if wishes.role == "target" else "validation plane"
        where = "on every line" if wishes.line is None else f"on {wishes.line} only"
        layout.addWidget(
            widgets.label(
                f"The {what} at this place is searched for {where}, with search radius, threshold "
                "and the rest as set in step 2. What is found is offered.",
                wrap=True,
            )
        )
        self.name = QLineEdit(name)
        self.name.setObjectName("seed_name")
        self.name.setToolTip(say("Name of the new target"))
        # A sighting of its own for the selected target: its name is not to be chosen.
        self._added = wishes.line is not None and name == wishes.selected
        self.name.setEnabled(not self._added)
        self.choice = SystemChoice(project, trajectory, "seed", self)
        self.fields = tuple(_field(f"seed_coordinate_{k}") for k in range(3))
        self._form = QFormLayout()
        self._form.setVerticalSpacing(theme.SPACE)
        self._form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        self._form.addRow(say("Name"), self.name)
        self.choice.add_to(self._form)
        for field in self.fields:
            self._form.addRow(" ", field)
        layout.addLayout(self._form)
        self.said = widgets.label("", "muted", wrap=True, name="seed_said")
        self.said.setMinimumHeight(3 * self.fontMetrics().lineSpacing())
        self.said.setAlignment(Qt.AlignmentFlag.AlignTop)
        layout.addWidget(self.said)
        self.find_button = widgets.button("Find", "seed_find", primary=True)
        self.find_button.setDefault(True)
        self.find_button.clicked.connect(self.accept)
        cancel = widgets.button("Cancel", "seed_cancel")
        cancel.clicked.connect(self.reject)
        cancel.setAutoDefault(False)  # Enter finds, wherever the focus is
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_order(self.find_button, cancel):
            row.addWidget(each)
        layout.addLayout(row)
        QWidget.setTabOrder(self.fields[2], self.find_button)
        QWidget.setTabOrder(self.find_button, cancel)
        self.choice.changed.connect(self._judge)
        self.name.textChanged.connect(self._judge)
        for field in self.fields:
            field.textChanged.connect(self._typed)
        self.fields[0].setFocus()
        self._judge()

    @property
    def seed(self) -> tuple[str, Triple] | None:
        """Name and place in the local frame, metres; None where something is wrong."""
        return None if self._place is None else (self.name.text().strip(), self._place)

    def _typed(self, text: str) -> None:
        """Three numbers at once, as copied from a list, fill the three fields."""
        if self.sender() is self.fields[0] and (parts := coordinates_in(text)):
            for field, part in zip(self.fields, parts, strict=True):
                field.blockSignals(True)
                field.setText(part)
                field.blockSignals(False)
        self._judge()

    def _judge(self) -> None:
        axes = axes_of(self.choice.system)
        units = ("°", "°", "m") if axes[0] == "longitude" else ("m", "m", "m")
        for field, axis, unit in zip(self.fields, axes, units, strict=True):
            self._form.labelForField(field).setText(say(f"{axis[:1].upper()}{axis[1:]} ({unit})"))
            field.setAccessibleName(say(f"{axis}, {unit}"))
        self._place = None
        role, text = "muted", ""
        if not self.choice.waiting:
            try:
                text = self._meaning()
            except (InputError, ProjectError) as failure:
                role, text = "error", say(str(failure))
        self.said.setText(text)
        self.said.setProperty("role", role)
        self.said.style().unpolish(self.said)
        self.said.style().polish(self.said)
        self.find_button.setEnabled(self._place is not None)

    def _meaning(self) -> str:
        """What is typed, in words; sets the place where all is there.

        Raises
        ------
        InputError
        ProjectError
            With what is wrong.
        """
        if self.choice.problem is not None:
            raise InputError(self.choice.problem.reason)
        name = self.name.text().strip()
        if not self._added:
            require_name(name)
            if any(target.name == name for target in self._project.targets):
                raise ProjectError(error("window.name_taken", name=name))
        system = self.choice.system
        axes = axes_of(system)
        values = []
        for field, axis in zip(self.fields, axes, strict=True):
            text = field.text().strip()
            degrees = axis in ("longitude", "latitude")
            values.append(coordinate(text, degrees=degrees) if text else None)
            wrong = bool(text) and values[-1] is None
            field.setProperty("wrong", wrong)
            field.style().unpolish(field)
            field.style().polish(field)
        for field, axis, value in zip(self.fields, axes, values, strict=True):
            if value is None and field.text().strip():
                title = say(f"{axis[:1].upper()}{axis[1:]}")
                raise InputError(
                    error("window.not_a_number", field=title, text=field.text().strip())
                )
        point = np.array([value for value in values if value is not None])
        if len(point) < 3:
            missing = [axis for axis, value in zip(axes, values, strict=True) if value is None]
            return say(f"Still to be given: {', '.join(missing)}.")
        place = require_near(point, system, self._trajectory, name)
        self._place = (float(place[0]), float(place[1]), float(place[2]))
        distance = float(away(place[None], self._trajectory)[0])
        words = say(f"{distance:,.1f} m from the trajectory.")
        if system is not None:
            north, west, up = place
            words = say(
                f"In the local frame {north:.3f} m north, {west:.3f} m west, {up:.3f} m up; "
                f"{distance:,.1f} m from the trajectory."
            )
            words = " ".join([words, *say_sentences(system.assumptions)])
        return words


def _field(name: str) -> QLineEdit:
    field = QLineEdit()
    field.setObjectName(name)
    field.setAlignment(Qt.AlignmentFlag.AlignRight)
    field.setFont(theme.tabular(field.font()))
    field.setToolTip(say("Paste three numbers at once into the first field to fill all three"))
    return field
