"""Inputs of a conversion: boresight, current settings of the other program, and IMU axes."""

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QFontDatabase
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QHBoxLayout,
    QPlainTextEdit,
    QVBoxLayout,
    QWidget,
)

from lispac.gui import widgets
from lispac.gui.widgets.field_transfer import copy_fields
from lispac.gui.widgets.number_input import require_accepted_texts
from lispac.language import N_, capitalised, gettext
from lispac.messages import Message
from lispac.project import Project
from lispac.survey.conventions.axes import DIRECTIONS, Axes, complete_axes
from lispac.survey.conventions.conversion import ConventionSetup
from lispac.survey.conventions.matrix_input import matrix_of_text
from lispac.survey.conventions.mounting_replacement import (
    CurrentMountingInSystem,
    current_mounting_of_matrix,
)
from lispac.survey.conventions.mounting_texts import UNCORRELATED_WARNING
from lispac.survey.conventions.systems import Convention
from lispac.survey.georeferencing import Mounting

USER_DEFINED_TEXT = N_("User-defined values.")
NO_VALUES_TEXT = N_("Type the values, or open a project.")
ANGLE_SIGN_TEXTS = (
    N_("Roll is positive with the port side up"),
    N_("Pitch is positive with the bow down"),
    N_("Yaw is positive clockwise seen from above"),
)
"""Sign conventions of roll, pitch and yaw."""
TRANSLATED_PROGRAM_NAMES = (
    N_("LISPAC (as iXblue)"),
    N_("Phoenix SpatialExplorer 6 and later"),
    N_("Phoenix SpatialExplorer 1 to 5"),
)
"""Names of programs that the catalogue translates; all others are the same in each language."""


def program_name(convention: Convention) -> str:
    """Name of a program in the user's language."""
    return gettext(convention.name)


class BoresightInputs(QWidget):
    """Fields for the boresight and lever arm to convert, from the project or user-defined.

    Attributes
    ----------
    mounting : Mounting
        Mounting to convert, with all digits if it is that of the project.
    covariance : ndarray of shape (3, 3), radians squared, or None
    sigma_warning : warning about the sigmas
    has_lever_arm : whether a project or the user has given the lever arm
    has_values : whether a project or the user has given any value
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.mounting = Mounting(np.zeros(3), np.zeros(3))
        self.covariance: np.ndarray | None = None
        self.sigma_warning: Message | None = None
        self.has_lever_arm = self.has_values = False
        self._is_user_defined = False
        self._project_values: tuple[Mounting, np.ndarray | None, Message | None, str] | None = None
        self._key: tuple[object, ...] = ()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(widgets.label(gettext("Boresight and lever arm in LISPAC"), "heading"))
        self.source = widgets.label(
            gettext(NO_VALUES_TEXT), "muted", wrap=True, name="convention_source"
        )
        layout.addWidget(self.source)
        self.boresight = widgets.boresight_fields("convention_boresight")
        self.lever_arm = widgets.lever_arm_fields("convention_lever_arm")
        for field, meaning in zip(self.boresight.fields, ANGLE_SIGN_TEXTS, strict=True):
            field.setToolTip(gettext(meaning))
        for field in (*self.boresight.fields, *self.lever_arm.fields):
            field.valueChanged.connect(self._on_typed)
            field.lineEdit().textEdited.connect(self._on_edited)
            field.lineEdit().textChanged.connect(self.changed)
        layout.addWidget(self.boresight)
        layout.addWidget(self.lever_arm)
        self.use_project = widgets.button(
            gettext("Use project values"), "convention_take",
            tip=gettext(
                "Use the estimated boresight of the project, or the prior boresight if nothing "
                "has been estimated"
            ),
        )  # fmt: skip
        self.use_project.clicked.connect(self._use_project)
        self.use_project.setEnabled(False)
        layout.addWidget(self.use_project, alignment=Qt.AlignmentFlag.AlignLeft)

    def show_project(self, project: Project | None) -> None:
        """Fill in the boresight of the project if it has changed; clear that of a closed one."""
        self._project_values = None if project is None else _project_boresight(project)
        self.use_project.setEnabled(self._project_values is not None)
        key: tuple[object, ...] = ()
        if project is not None:
            key = (project.folder, project.result, *project.mounting("prior").values)
        # Other edits of the project keep the typed values.
        if key != self._key:
            self._key = key
            if project is None:
                self._clear()
            else:
                self._use_project()

    def copy_state_from(self, former: "BoresightInputs") -> None:
        """Copy the values of a former window with the same project."""
        copy_fields(former, self)
        if former._is_user_defined:
            self._on_typed()
        self.has_values = former.has_values
        self.changed.emit()

    def _clear(self) -> None:
        self.boresight.set_value((0.0, 0.0, 0.0))
        self.lever_arm.set_value((0.0, 0.0, 0.0))
        self._on_typed()
        self._is_user_defined = self.has_values = False
        self.source.setText(gettext(NO_VALUES_TEXT))
        self.changed.emit()

    def _use_project(self) -> None:
        if self._project_values is None:
            return
        self.mounting, self.covariance, self.sigma_warning, source = self._project_values
        self.boresight.set_value(np.degrees(self.mounting.boresight))
        self.lever_arm.set_value(self.mounting.lever_arm)
        self.has_lever_arm = self.has_values = True
        self._is_user_defined = False
        self.source.setText(source)
        self.changed.emit()

    def _on_edited(self) -> None:
        # Zero is a value too, although it does not change the field
        self.has_values = True

    def _on_typed(self) -> None:
        self.has_values = self._is_user_defined = True
        self.mounting = Mounting(
            np.array(self.lever_arm.value()), np.radians(self.boresight.value())
        )
        self.covariance = self.sigma_warning = None
        self.has_lever_arm = bool(np.any(self.mounting.lever_arm))
        self.source.setText(gettext(USER_DEFINED_TEXT))
        self.changed.emit()


class CurrentSettingsInputs(QWidget):
    """Fields for the current settings of the other program, if they are to be corrected."""

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self.known = QCheckBox(gettext("Correct the settings of the other program"))
        self.known.setObjectName("convention_has_current")
        self.known.setToolTip(
            gettext("Enter the boresight now set in the other program to compute its correction")
        )
        layout.addWidget(self.known)
        self._box = QWidget()
        inner = QVBoxLayout(self._box)
        inner.setContentsMargins(22, 0, 0, 0)
        fields = [
            widgets.number(
                f"convention_current_{k}", suffix=" °", decimals=4, low=-360, high=360, step=0.1
            )
            for k in range(3)
        ]
        self.fields = widgets.TripleField(("", "", ""), fields)
        self._angle_labels = [
            self.fields.layout().itemAtPosition(0, column).widget() for column in range(3)
        ]
        inner.addWidget(self.fields)
        self.as_matrix = QCheckBox(gettext("Enter the boresight as a matrix"))
        self.as_matrix.setObjectName("convention_as_matrix")
        self.as_matrix.setToolTip(
            gettext(
                "Enter the boresight of the other program as a rotation matrix instead of angles"
            )
        )
        inner.addWidget(self.as_matrix)
        self.matrix = MatrixField(
            "convention_current_matrix", gettext("Rotation matrix from scanner to body")
        )
        self.matrix.setToolTip(
            gettext(
                "Rotation matrix from scanner to body in the other program, row by row: 3x3 "
                "numbers, or 4x4 with the lever arm in metres"
            )
        )
        self.matrix.setPlaceholderText("1 0 0\n0 1 0\n0 0 1")
        inner.addWidget(self.matrix)
        self.applied = QCheckBox(gettext("Settings already applied to the lines"))
        self.applied.setObjectName("convention_applied")
        self.applied.setToolTip(
            gettext(
                "Tick if that program applied these settings before it wrote the lines. The "
                "estimated boresight is then a correction to them."
            )
        )
        inner.addWidget(self.applied)
        layout.addWidget(self._box)
        self._box.hide()
        self.known.toggled.connect(self._box.setVisible)
        self.known.toggled.connect(self.changed)
        self.applied.toggled.connect(self.changed)
        self.as_matrix.toggled.connect(self._show_fields)
        self.as_matrix.toggled.connect(self.changed)
        self.matrix.textChanged.connect(self.changed)
        self._show_fields()
        for field in fields:
            field.lineEdit().textChanged.connect(self.changed)

    @property
    def has_values(self) -> bool:
        """Whether the user has given a value to correct."""
        if not self.known.isChecked():
            return False
        if self.as_matrix.isChecked():
            return bool(self.matrix.toPlainText().strip())
        return any(self.fields.value())

    def of(self, setup: ConventionSetup) -> CurrentMountingInSystem | None:
        """Mounting set in the other program; None if it is not to be corrected.

        Raises
        ------
        InputError
            If a typed text is not a number or not a matrix.
        """
        if not self.known.isChecked():
            return None
        if not self.as_matrix.isChecked():
            require_accepted_texts(self.fields)
            return CurrentMountingInSystem(np.radians(self.fields.value()))
        return current_mounting_of_matrix(
            setup, *matrix_of_text(self.matrix.toPlainText(), gettext("Current matrix"))
        )

    def clear(self) -> None:
        """Clear the settings of the other program."""
        self.fields.set_value((0.0, 0.0, 0.0))
        self.matrix.clear()
        self.applied.setChecked(False)
        self.known.setChecked(False)

    def _show_fields(self) -> None:
        self.fields.setVisible(not self.as_matrix.isChecked())
        self.matrix.setVisible(self.as_matrix.isChecked())

    def show_convention(self, convention: Convention) -> None:
        """Label the fields as in the program, or show the matrix field if it has no angles."""
        for box in (self.as_matrix, self.matrix):
            box.blockSignals(True)
        self.as_matrix.setChecked(not convention.has_angles)
        self.as_matrix.setVisible(convention.has_angles)
        self.matrix.clear()
        for box in (self.as_matrix, self.matrix):
            box.blockSignals(False)
        self._show_fields()
        for label, field, turn in zip(
            self._angle_labels, self.fields.fields, convention.turns, strict=False
        ):
            label.setText(capitalised(gettext(turn.name)))
            field.setToolTip(
                gettext(
                    "Current {angle} in {program}, {meaning}",
                    angle=gettext(turn.name),
                    program=program_name(convention),
                    meaning=gettext(turn.meaning),
                )
            )  # fmt: skip
            field.setAccessibleName(gettext("Current {angle}", angle=gettext(turn.name)))
        # Settings of one program do not apply to another.
        self.fields.set_value((0.0, 0.0, 0.0))


class ImuAxes(QWidget):
    """Fields for the directions of the IMU axes, for programs whose body axes are those axes."""

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        self.x, self.y = QComboBox(), QComboBox()
        for letter, box in (("X", self.x), ("Y", self.y)):
            box.setObjectName(f"imu_{letter.lower()}")
            box.setToolTip(
                gettext("Direction of the {axis} axis of the IMU on the vessel", axis=letter)
            )
            box.setAccessibleName(gettext("IMU {axis} axis", axis=letter))
            box.addItems(list(map(gettext, DIRECTIONS)))
            row.addWidget(widgets.label(gettext("IMU {axis}", axis=letter), "muted"))
            row.addWidget(box)
        self._z = widgets.label("", "muted", name="imu_z")
        row.addWidget(self._z, 1)
        self.y.setCurrentIndex(DIRECTIONS.index("port"))
        for box in (self.x, self.y):
            box.currentIndexChanged.connect(self.changed)

    @property
    def axes(self) -> Axes:
        """Right-handed axes; raises `InputError` if X and Y are parallel."""
        return complete_axes(DIRECTIONS[self.x.currentIndex()], DIRECTIONS[self.y.currentIndex()])

    def show_z(self, direction: str) -> None:
        """Show the direction of the third axis."""
        self._z.setText(gettext("Z {direction}", direction=gettext(direction)))


def _project_boresight(project: Project) -> tuple[Mounting, np.ndarray | None, Message | None, str]:
    """Mounting, covariance, warning and source text of a project."""
    result = project.result
    if result is None:
        return project.mounting("prior"), None, None, (
            gettext(
                "Prior boresight of {project}. Nothing has been estimated yet.",
                project=project.name,
            )
        )  # fmt: skip
    return (
        project.mounting("estimated"),
        np.asarray(result.covariance)[:3, :3],
        None if result.model.correlated else UNCORRELATED_WARNING,
        gettext("Estimated boresight of {project}.", project=project.name),
    )


MATRIX_FIELD_ROWS = 4
MATRIX_TEXT_PX = 11


class MatrixField(QPlainTextEdit):
    """Shows a matrix, or accepts a typed or pasted one; Tab moves to the next field."""

    def __init__(self, name: str, accessible_name: str, *, read_only: bool = False) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setAccessibleName(accessible_name)
        self.setReadOnly(read_only)
        self.setTabChangesFocus(True)
        self.setLineWrapMode(QPlainTextEdit.LineWrapMode.NoWrap)
        font = QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont)
        font.setPixelSize(MATRIX_TEXT_PX)
        self.setFont(font)
        self.setFixedHeight(MATRIX_FIELD_ROWS * self.fontMetrics().lineSpacing() + 14)
