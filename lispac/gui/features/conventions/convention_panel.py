"""Boresight in the angle convention of another program."""

from collections.abc import Sequence
from html import escape

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QComboBox,
    QHBoxLayout,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QVBoxLayout,
    QWidget,
)

from lispac.errors import InputError
from lispac.gui import widgets
from lispac.gui.appearance import theme, units
from lispac.gui.features.conventions.convention_inputs import (
    BoresightInputs,
    CurrentSettingsInputs,
    ImuAxes,
    MatrixField,
    program_name,
)
from lispac.gui.project.status import ProjectState
from lispac.gui.widgets.mounting_texts import boresight_sentence, lever_arm_sentence
from lispac.gui.widgets.scanner_axes_view import ScannerAxesView
from lispac.language import N_, capitalised, gettext
from lispac.message_texts import message_text
from lispac.survey.conventions.axes import Axes
from lispac.survey.conventions.conversion import ConventionSetup, MountingInSystem
from lispac.survey.conventions.correction import SUM_TOLERANCE_RAD
from lispac.survey.conventions.mounting_replacement import MountingReplacement, replace_mounting
from lispac.survey.conventions.mounting_texts import offsets_note
from lispac.survey.conventions.systems import (
    LISPAC_CONVENTION,
    SCANNER_WORDS,
    SYSTEMS,
    Convention,
    Direction,
    Scanner,
    Status,
)
from lispac.survey.georeferencing import Mounting

_ALIGN_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_ROW_HEIGHT_PX = 25
Row = tuple[str, np.ndarray, str, bool]
"""Title in the user's language, angles in radians, format of the sign, whether bold."""


class ConventionAnglesTable(QTableWidget):
    """Table of three angles, which scrolls if their digits need more space."""

    def __init__(self) -> None:
        super().__init__(1, 3)
        self.setTabKeyNavigation(False)
        self.setObjectName("convention_table")
        self.setAccessibleName(gettext("Angles in the other program"))
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ContiguousSelection)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setHorizontalScrollMode(QAbstractItemView.ScrollMode.ScrollPerPixel)
        side = self.verticalHeader()
        side.setDefaultSectionSize(_ROW_HEIGHT_PX)
        side.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        side.setHighlightSections(False)
        head = self.horizontalHeader()
        head.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        head.setHighlightSections(False)

    def fill(self, convention: Convention, rows: Sequence[Row], decimals: int) -> None:
        """Show the rows in degrees, with columns named as in the program."""
        self.setRowCount(len(rows))
        self.setHorizontalHeaderLabels([capitalised(gettext(name)) for name in convention.names])
        self.setVerticalHeaderLabels([title for title, *_ in rows])
        for column, turn in enumerate(convention.turns):
            self.horizontalHeaderItem(column).setTextAlignment(_ALIGN_RIGHT)
            self.horizontalHeaderItem(column).setToolTip(capitalised(gettext(turn.meaning)))
        for row, (_, values, sign, bold) in enumerate(rows):
            for column, value in enumerate(np.round(np.degrees(values), decimals)):
                item = QTableWidgetItem(units.localised(f"{value + 0.0:{sign}.{decimals}f}"))
                item.setTextAlignment(_ALIGN_RIGHT)
                item.setFont(theme.tabular_font(self.font(), bold=bold))
                self.setItem(row, column, item)
        self._set_column_widths()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Distribute the new width over the columns."""
        super().resizeEvent(event)
        self._set_column_widths()

    def _set_column_widths(self) -> None:
        """Give each column the width of its numbers, and distribute the rest."""
        head = self.horizontalHeader()
        needed = [
            max(self.sizeHintForColumn(k), head.sectionSizeHint(k)) for k in range(head.count())
        ]
        inside = self.width() - 2 * self.frameWidth() - self.verticalHeader().sizeHint().width()
        spare, rest = divmod(max(inside - sum(needed), 0), len(needed))
        for column, width in enumerate(needed):
            self.setColumnWidth(column, width + spare + (column < rest))
        bar = self.horizontalScrollBar().sizeHint().height() if sum(needed) > inside else 0
        self.setFixedHeight(head.sizeHint().height() + _ROW_HEIGHT_PX * self.rowCount() + 3 + bar)


TITLE = N_("Angles in another program")
_STATUS_COLOURS: dict[Status, str] = {
    "verified": "done",
    "partly": "warning",
    "unverified": "error",
}
_STATUS_TEXTS: dict[Status, tuple[str, str]] = {
    "verified": (N_("Convention verified"), N_("{program} (verified)")),
    "partly": (N_("Convention partly verified"), N_("{program} (partly verified)")),
    "unverified": (N_("Convention not verified"), N_("{program} (not verified)")),
}
"""Title of each status, and name of a program with its status."""
_FORMULA_TEXTS: dict[Direction, str] = {
    "lidar_to_body": N_("Rotation from LiDAR to body: {formula}."),
    "body_to_lidar": N_("Rotation from body to LiDAR: {formula}."),
}
_SCANNER_AXES_TEXTS: dict[Scanner, tuple[str, str]] = {
    "turned": (N_("parallel to the body axes"), N_("parallel to the body axes (usual)")),
    "kept": (N_("as in the raw points"), N_("as in the raw points (usual)")),
    "mounted": (
        N_("rotated to the mounting orientation"),
        N_("rotated to the mounting orientation (usual)"),
    ),
}
"""Text of each orientation of the scanner axes, and text if it is usual in the program."""


class ConventionPanel(QWidget):
    """Boresight in the convention of a chosen program, with its assumptions."""

    def __init__(self) -> None:
        super().__init__()
        self._all_digits = self._all_angles = ""
        self.inputs, self.current, self.imu = BoresightInputs(), CurrentSettingsInputs(), ImuAxes()
        self._build()
        for inputs in (self.inputs, self.current, self.imu):
            inputs.changed.connect(self._refresh)
        self.system.currentIndexChanged.connect(self._set_program)
        self._set_program(1)

    @property
    def convention(self) -> Convention:
        """Convention of the chosen program."""
        return SYSTEMS[self.system.currentIndex()]

    def show_state(self, state: ProjectState) -> None:
        """Use the boresight and lever arm of the project if they have changed."""
        self.inputs.show_project(state.project)

    # -- assembly ----------------------------------------------------------------------------

    def _build(self) -> None:
        body = QWidget()
        layout = widgets.vertical_layout(body)
        layout.addWidget(widgets.label(gettext("Program"), "heading"))
        self.system = QComboBox()
        self.system.setObjectName("convention_system")
        self.system.setAccessibleName(gettext("Program for which the angles are computed"))
        for each in SYSTEMS:
            self.system.addItem(gettext(_STATUS_TEXTS[each.status][1], program=program_name(each)))
        self.system.setMinimumContentsLength(24)
        self.system.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        layout.addWidget(self.system)
        self.status = widgets.label(wrap=True, name="convention_status", rich=True)
        layout.addWidget(self.status)
        self.assumption = widgets.label(
            role="hint", wrap=True, name="convention_assumption", rich=True
        )
        layout.addWidget(self.assumption)
        layout.addWidget(self.imu)
        self.values_head = widgets.label("", "heading", wrap=True)
        layout.addWidget(self.values_head)
        self.table = ConventionAnglesTable()
        layout.addWidget(self.table)
        self.notes = widgets.label("", "muted", wrap=True, name="convention_notes", rich=True)
        layout.addWidget(self.notes)
        self.rules = widgets.label("", "muted", wrap=True, name="convention_rules", rich=True)
        self.lever = widgets.label(wrap=True, name="convention_lever", rich=True)
        self.lever.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        layout.addWidget(self.lever)
        self.mounting_text = widgets.label(wrap=True, name="convention_text", rich=True)
        layout.addWidget(self.mounting_text)
        self.gizmo = ScannerAxesView()
        layout.addWidget(self.gizmo)
        layout.addWidget(self.rules)
        layout.addWidget(self.current)
        layout.addWidget(self.inputs)
        layout.addWidget(self._matrix_box())
        layout.addStretch(1)
        area = widgets.VerticalScrollArea(body, 380)
        outer = QVBoxLayout(self)
        outer.setContentsMargins(0, 0, 0, 0)
        outer.addWidget(area)

    def _matrix_box(self) -> QWidget:
        box = QWidget()
        layout = QVBoxLayout(box)
        layout.setContentsMargins(0, 0, 0, 0)
        self.scanner = QComboBox()
        self.scanner.setObjectName("convention_scanner")
        self.scanner.setToolTip(
            gettext(
                "Orientation of the scanner axes in that program, relative to the axes of the "
                "raw points"
            )
        )
        self.scanner.setMinimumContentsLength(16)
        self.scanner.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self.scanner.currentIndexChanged.connect(self._refresh)
        # One above the other, since French texts are as wide as the panel
        layout.addWidget(widgets.label(gettext("Scanner axes in that program"), "muted"))
        layout.addWidget(self.scanner)
        self.matrix_head = widgets.label("", "heading", wrap=True)
        layout.addWidget(self.matrix_head)
        self.matrix = MatrixField(
            "convention_matrix", gettext("Matrix from scanner to body"), read_only=True
        )
        layout.addWidget(self.matrix)
        self.copy = widgets.button(
            gettext("Copy matrix"), "convention_copy", icon="content-copy",
            tip=gettext("Copy the 16 numbers to the clipboard, row by row"),
        )  # fmt: skip
        self.copy.clicked.connect(lambda: QApplication.clipboard().setText(self._all_digits))
        self.copy_angles = widgets.button(
            gettext("Copy angles"), "convention_copy_angles", icon="content-copy",
            tip=gettext("Copy the angles with their names to the clipboard, one per row"),
        )  # fmt: skip
        self.copy_angles.clicked.connect(lambda: QApplication.clipboard().setText(self._all_angles))
        row = QHBoxLayout()
        row.addWidget(self.copy)
        row.addWidget(self.copy_angles)
        row.addStretch(1)
        layout.addLayout(row)
        return box

    # -- actions of the user ------------------------------------------------------------------

    def _set_program(self, index: int) -> None:
        if self.system.currentIndex() != index:
            self.system.setCurrentIndex(index)
            return
        convention = self.convention
        self.scanner.blockSignals(True)
        self.scanner.clear()
        for kind, (title, usual) in _SCANNER_AXES_TEXTS.items():
            is_usual = kind == convention.scanner
            self.scanner.addItem(gettext(usual if is_usual else title), kind)
        self.scanner.setCurrentIndex(self.scanner.findData(convention.scanner))
        self.scanner.blockSignals(False)
        self.scanner.setEnabled(convention.key != LISPAC_CONVENTION.key)
        self.imu.setVisible(convention.open_axes)
        self.current.show_convention(convention)
        self._refresh()

    # -- display -----------------------------------------------------------------------------

    def _refresh(self) -> None:
        convention, inputs = self.convention, self.inputs
        try:
            body_axes = self.imu.axes if convention.open_axes else None
            setup = ConventionSetup(convention, body_axes, self.scanner.currentData())
            new = replace_mounting(
                setup, inputs.mounting, inputs.covariance, self.current.of(setup),
                applied=self.current.applied.isChecked(), has_lever_arm=inputs.has_lever_arm,
            )  # fmt: skip
        except InputError as error:
            self._show_refusal(str(error))
            return
        self._show_rules(setup, new.mounting)
        self._show_values(new)
        self._show_mounting_text(new.mounting)
        self._show_matrix(new.in_system)

    def _show_refusal(self, text: str) -> None:
        self.assumption.setText(escape(text))
        self.assumption.show()
        for widget in (self.table, self.notes, self.lever, self.rules, self.matrix):
            widget.setVisible(False)
        self.values_head.setText(gettext("No angles computed"))
        for button in (self.copy, self.copy_angles):
            button.setEnabled(False)

    def _show_rules(self, setup: ConventionSetup, mounting: Mounting) -> None:
        convention = setup.convention
        colour = theme.colour(_STATUS_COLOURS[setup.status]).name()
        x, y, z = setup.axes
        status = f'<b style="color:{colour}">{gettext(_STATUS_TEXTS[setup.status][0])}</b>'
        self.status.setText(
            gettext("{status}: {source}.", status=status, source=gettext(convention.source))
        )
        rules = [
            gettext(
                "Body axes in that program: X {x}, Y {y}, Z {z}.",
                x=gettext(x),
                y=gettext(y),
                z=gettext(z),
            )
        ]
        if convention.has_angles:
            formula = str(convention.formula).replace("-", "−")
            rules.insert(0, gettext(_FORMULA_TEXTS[convention.direction], formula=formula))
        if convention.key != LISPAC_CONVENTION.key:
            rules.append(str(setup.scanner_axes(mounting.rotation_body_lidar)))
        self.rules.setText(" ".join(rules))
        self.imu.show_z(z)
        title = gettext("Assumption:")
        self.assumption.setText(f"<b>{title}</b> {setup.assumption}")
        self.assumption.setVisible(setup.assumption is not None)

    def _show_values(self, new: MountingReplacement) -> None:
        in_system, correction = new.in_system, new.correction
        setup = in_system.setup
        convention = setup.convention
        is_verified = setup.status == "verified"
        for widget in (self.notes, self.lever, self.rules, self.matrix):
            widget.setVisible(True)
        self.copy.setEnabled(True)
        self.copy_angles.setEnabled(in_system.angles is not None)
        self.table.setVisible(convention.has_angles)
        if in_system.angles is None:
            self.values_head.setText(
                gettext("This program uses a matrix instead of angles: see below")
            )
            self.notes.setVisible(correction is not None)
            if correction is not None:
                self.notes.setText(_correction_text(correction.rotation, new.transform))
        else:
            self.values_head.setText(
                gettext("Angles to enter, degrees")
                if is_verified
                else gettext("Angles to enter if the assumption is correct, degrees")
            )
            decimals = 4 if in_system.note is None else 8
            title = gettext("New angles") if is_verified else gettext("Assumed angles")
            last = (title, in_system.angles, "+", True)
            rows: list[tuple[str, np.ndarray, str, bool]] = [last]
            if correction is not None:
                assert correction.current is not None
                assert correction.correction is not None
                rows = [
                    (gettext("Current angles"), correction.current, "+", False),
                    (gettext("Correction"), correction.correction, "+", False),
                    last,
                ]
            if in_system.sigmas is not None:
                rows.append((gettext("± 1 σ"), in_system.sigmas, "", False))
            self.table.fill(convention, rows, decimals)
            self._all_angles = _angle_lines(convention, in_system.angles, decimals)
            self._show_notes(new)
        arm = _lever_arm_text(setup.axes, in_system.lever_arm)
        texts = [
            gettext("Lever arm in that program, from the POS centre: {lever_arm}", lever_arm=arm)
        ]
        if new.current is not None and new.current.lever_arm is not None:
            arm = _lever_arm_text(setup.axes, new.current.lever_arm)
            texts.append(gettext("Current lever arm: {lever_arm}", lever_arm=arm))
            texts += map(message_text, filter(None, [new.lever_arm_note]))
        self.lever.setText("<br>".join(texts))

    def _show_notes(self, new: MountingReplacement) -> None:
        in_system, correction = new.in_system, new.correction
        signs = str(in_system.setup.signs)
        lines = [f"{signs[:1].upper()}{signs[1:]}."]
        if correction is not None:
            lines.append(
                gettext(
                    "Multiply the current matrix by the correction from the left: new = "
                    "correction · current."
                )
            )
            error = correction.sum_error
            if error > SUM_TOLERANCE_RAD:
                lines.append(_sum_error_text(error))
        if new.transform is not None:
            title = gettext("Correction of the 4x4 matrix:")
            lines.append(f"{title}<br>{_matrix_html(new.transform)}")
        if in_system.note is not None:
            lines.append(f"<b>{message_text(in_system.note)}</b>")
        if in_system.sigmas is not None and self.inputs.sigma_warning:
            lines.append(self.inputs.sigma_warning)
        self.notes.setText("<br>".join(lines))

    def _show_mounting_text(self, mounting: Mounting) -> None:
        sentences = (
            f"<b>{boresight_sentence(mounting.without_nominal_axes.boresight)}</b>",
            lever_arm_sentence(mounting.lever_arm),
            *map(message_text, filter(None, [offsets_note(mounting)])),
        )
        self.mounting_text.setText("<br>".join(sentence for sentence in sentences if sentence))
        self.gizmo.show_boresight(np.asarray(mounting.without_nominal_axes.boresight, dtype=float))

    def _show_matrix(self, in_system: MountingInSystem) -> None:
        name = program_name(in_system.setup.convention)
        self.matrix_head.setText(
            gettext("Matrix from scanner to body in {program}, with the lever arm", program=name)
        )
        self.matrix.setPlainText(_matrix_rows(in_system.transform, 7))
        self._all_digits = _matrix_rows(in_system.transform, 12)
        self.matrix.setToolTip(gettext(SCANNER_WORDS[in_system.setup.scanner_frame]))


def _correction_text(rotation: np.ndarray, transform: np.ndarray | None) -> str:
    text = gettext(
        "The matrix below replaces the current matrix: new = correction · current. Correction:"
    )
    return f"{text}<br>{_matrix_html(rotation if transform is None else transform)}"


def _sum_error_text(error: float) -> str:
    """Warning not to add correction and current angles; ``error`` of the sum in radians."""
    return gettext(
        "<b>Do not add the correction to the current angles.</b> The sum would be wrong by "
        "{angle}, which is {distance} at {range}.",
        angle=units.local_amount(float(np.degrees(error)), "°", ".4f"),
        distance=units.local_amount(error * 1e5, "mm", ".0f"),
        range=units.local_amount(100.0, "m", ".0f"),
    )


def _matrix_html(matrix: np.ndarray) -> str:
    rows = _matrix_rows(matrix, 7).replace(" ", "&nbsp;").replace("\n", "<br>")
    return f"<code>{rows}</code>"


def _lever_arm_text(axes: Axes, values: np.ndarray) -> str:
    # Non-breaking spaces, so that lines are broken between two axes only.
    return ", ".join(
        f"{letter} {gettext(axis)} <b>{units.localised(f'{value + 0.0:+.4f}')}</b> m".replace(
            " ", "&nbsp;"
        )
        for letter, axis, value in zip("XYZ", axes, np.round(values, 4), strict=True)
    )


def _angle_lines(convention: Convention, angles: np.ndarray, decimals: int) -> str:
    values = np.round(np.degrees(angles), decimals) + 0.0
    named = zip(convention.names, values, strict=True)
    return "\n".join(f"{name}\t{value:.{decimals}f}" for name, value in named)


def _matrix_rows(matrix: np.ndarray, decimals: int) -> str:
    return "\n".join(
        " ".join(f"{value + 0.0:{decimals + 4}.{decimals}f}" for value in np.round(row, decimals))
        for row in matrix
    )
