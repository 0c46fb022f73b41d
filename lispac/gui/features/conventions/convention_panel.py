"""Boresight in the angle convention of another program."""

from collections.abc import Sequence
from html import escape

import numpy as np
from PySide6.QtCore import Qt, Signal
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
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.conventions.convention_inputs import (
    BoresightInputs,
    CurrentSettingsInputs,
    ImuAxes,
    MatrixField,
    program_name,
)
from lispac.gui.project.status import ProjectState
from lispac.gui.widgets.error_box import exception_text
from lispac.gui.widgets.field_transfer import copy_fields
from lispac.gui.widgets.mounting_texts import boresight_sentence, lever_arm_sentence
from lispac.gui.widgets.number_input import require_accepted_texts
from lispac.gui.widgets.result_tables import local_amount
from lispac.gui.widgets.scanner_axes_view import ScannerAxesView
from lispac.language import N_, capitalised, gettext, in_english
from lispac.present.output.conventions import (
    SUM_ERROR_MILLIMETRES,
    SUM_ERROR_RANGE_M,
    ConventionAngle,
    ConventionValues,
    CorrectionValues,
    Matrix,
    angle_format,
    angles_table,
    angles_title,
    lever_arm_text,
    matrix_text,
    rotation_facts,
    signs_text,
)
from lispac.present.tables import DEGREES, Format, Table, cell_text, title_text
from lispac.survey.conventions.axes import FORWARD_PORT_UP
from lispac.survey.conventions.conversion import ConventionSetup
from lispac.survey.conventions.mounting_replacement import (
    MountingReplacement,
    replace_mounting,
)
from lispac.survey.conventions.mounting_texts import offsets_note
from lispac.survey.conventions.systems import (
    LISPAC_CONVENTION,
    SCANNER_WORDS,
    SYSTEMS,
    Convention,
    Scanner,
    Status,
)
from lispac.survey.georeferencing import Mounting

_ALIGN_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
_ROW_HEIGHT_PX = 25


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

    def fill(self, table: Table[ConventionAngle], angles: Sequence[ConventionAngle]) -> None:
        """Show a table of angles with a column for each angle, named as in the program."""
        name, *rows, sign = table.columns
        self.setRowCount(len(rows))
        self.setHorizontalHeaderLabels([cell_text(name, angle) for angle in angles])
        self.setVerticalHeaderLabels([title_text(each.title) for each in rows])
        for column, angle in enumerate(angles):
            self.horizontalHeaderItem(column).setTextAlignment(_ALIGN_RIGHT)
            self.horizontalHeaderItem(column).setToolTip(capitalised(cell_text(sign, angle)))
            for row, each in enumerate(rows):
                item = QTableWidgetItem(cell_text(each, angle))
                item.setTextAlignment(_ALIGN_RIGHT)
                is_new = each.value == "value_deg"
                item.setFont(theme.tabular_font(self.font(), bold=is_new))
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
    """Boresight in the convention of a chosen program, with its assumptions.

    Attributes
    ----------
    replacement : MountingReplacement or None
        Mounting that is shown.
    """

    save_requested = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.replacement: MountingReplacement | None = None
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

    def clear_current_settings(self) -> None:
        """Clear the settings of the other program, which belong to the project being left."""
        self.current.clear()

    def copy_state_from(self, former: "ConventionPanel") -> None:
        """Copy the program, the values and the notes of a former window of the same project."""
        copy_fields(former, self)
        self.inputs.copy_state_from(former.inputs)

    # -- assembly ----------------------------------------------------------------------------

    def _build(self) -> None:
        body = widgets.WrappedBody()
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
        self.save = widgets.button(
            gettext("Save for this program…"), "convention_save", icon="content-save",
            tip=gettext(
                "Write boresight and lever arm into a file that this program reads, or as text"
            ),
        )  # fmt: skip
        self.save.clicked.connect(self.save_requested)
        layout.addWidget(self.save, alignment=Qt.AlignmentFlag.AlignLeft)
        self.saved = widgets.label("", "muted", wrap=True, name="convention_saved", rich=True)
        self.saved.hide()
        layout.addWidget(self.saved)
        return box

    def show_saved(self, texts: Sequence[str]) -> None:
        """Show the name of the file that was written, and the notes on it."""
        self.saved.setText("<br>".join(map(escape, texts)))
        self.saved.show()

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
        self.replacement = None
        self.saved.hide()
        has_values = inputs.has_values or self.current.has_values
        for widget in (self.status, self.mounting_text, self.gizmo):
            widget.setVisible(has_values)
        try:
            require_accepted_texts(inputs)
            body_axes = self.imu.axes if convention.open_axes else None
            setup = ConventionSetup(convention, body_axes, self.scanner.currentData())
            new = replace_mounting(
                setup, inputs.mounting, inputs.covariance, self.current.of(setup),
                applied=self.current.applied.isChecked(), has_lever_arm=inputs.has_lever_arm,
            )  # fmt: skip
        except InputError as error:
            self._show_refusal(exception_text(error))
            return
        if not has_values:
            self.assumption.hide()
            self._show_no_angles()
            return
        values = ConventionValues.of_mounting(
            new.in_system, new.mounting,
            has_lever_arm=new.has_lever_arm, warning=inputs.sigma_warning,
        )  # fmt: skip
        correction = CorrectionValues.of(new)
        self.replacement = new
        self.imu.show_z(setup.axes[2])
        self._show_rules(values)
        self._show_values(values, correction)
        self._show_notes(values, correction)
        self._show_mounting_text(new.mounting, setup)
        self._show_matrix(setup, values)

    def _show_refusal(self, text: str) -> None:
        self.assumption.setText(escape(text))
        self.assumption.show()
        for widget in (self.status, self.mounting_text, self.gizmo):  # of the former program
            widget.hide()
        self._show_no_angles()

    def _show_no_angles(self) -> None:
        matrix = self.matrix_head, self.matrix
        for widget in (self.table, self.notes, self.lever, self.rules, *matrix):
            widget.hide()
        self.values_head.setText(gettext("No angles computed"))
        for button in (self.copy, self.copy_angles, self.save):
            button.setEnabled(False)

    def _show_rules(self, values: ConventionValues) -> None:
        colour = theme.colour(_STATUS_COLOURS[values.status]).name()
        status = f'<b style="color:{colour}">{gettext(_STATUS_TEXTS[values.status][0])}</b>'
        self.status.setText(gettext("{status}: {source}.", status=status, source=values.source))
        self.rules.setText(
            "<br>".join(f"<b>{fact.name}</b> {fact.text}" for fact in rotation_facts(values))
        )
        title = gettext("Assumption:")
        self.assumption.setText(f"<b>{title}</b> {values.assumption}")
        self.assumption.setVisible(values.assumption is not None)

    def _show_values(self, values: ConventionValues, correction: CorrectionValues | None) -> None:
        for widget in (self.lever, self.rules, self.matrix_head, self.matrix):
            widget.setVisible(True)
        for button in (self.copy, self.save):
            button.setEnabled(True)
        self.copy_angles.setEnabled(bool(values.angles))
        self.table.setVisible(bool(values.angles))
        self.values_head.setText(angles_title(values))
        if values.angles:
            table = angles_table(values, "", correction=correction)
            self.table.fill(table, values.angles)
            self._all_angles = _angle_lines(values)
        texts = []
        if values.lever_arm_m is not None:
            arm = lever_arm_text(values, values.lever_arm_m)
            texts.append(
                gettext(
                    "Lever arm in that program, from the POS centre: {lever_arm}",
                    lever_arm=f"<b>{arm}</b>",
                )
            )
        if correction is not None and correction.current_lever_arm_m is not None:
            arm = lever_arm_text(values, correction.current_lever_arm_m)
            texts.append(gettext("Current lever arm: {lever_arm}", lever_arm=f"<b>{arm}</b>"))
            texts += map(message_text, filter(None, [correction.lever_arm_text]))
        self.lever.setText("<br>".join(texts))

    def _show_notes(self, values: ConventionValues, correction: CorrectionValues | None) -> None:
        lines = [f"{capitalised(signs_text(values))}."] if values.angles else []
        if correction is not None and values.angles:
            lines.append(
                gettext(
                    "Multiply the current matrix by the correction from the left: new = "
                    "correction · current."
                )
            )
            if correction.is_sum_inaccurate:
                lines.append(_sum_error_text(correction))
            if correction.transform is not None:
                title = gettext("Correction of the 4x4 matrix:")
                lines.append(f"{title}<br>{_matrix_html(correction.transform)}")
        elif correction is not None:
            text = gettext(
                "The matrix below replaces the current matrix: new = correction · current. "
                "Correction:"
            )
            lines.append(f"{text}<br>{_matrix_html(correction.transform or correction.matrix)}")
        if values.note is not None:
            lines.append(f"<b>{message_text(values.note)}</b>")
        if values.warning is not None and any(angle.sigma_deg for angle in values.angles):
            lines.append(message_text(values.warning))
        self.notes.setText("<br>".join(lines))
        self.notes.setVisible(bool(lines))

    def _show_mounting_text(self, mounting: Mounting, setup: ConventionSetup) -> None:
        sentences = (
            f"<b>{boresight_sentence(mounting.without_nominal_axes.boresight)}</b>",
            lever_arm_sentence(mounting.lever_arm),
            *map(message_text, filter(None, [offsets_note(mounting)])),
        )
        self.mounting_text.setText("<br>".join(sentence for sentence in sentences if sentence))
        boresight = np.asarray(mounting.without_nominal_axes.boresight, dtype=float)
        is_turned = setup.scanner_frame == "turned"
        self.gizmo.show_boresight(
            boresight, setup.axes, setup.axes if is_turned else FORWARD_PORT_UP
        )

    def _show_matrix(self, setup: ConventionSetup, values: ConventionValues) -> None:
        self.matrix_head.setText(
            gettext(
                "Matrix from scanner to body in {program}, with the lever arm",
                program=program_name(setup.convention),
            )
        )
        self.matrix.setPlainText(matrix_text(values.transform, 7))
        self._all_digits = matrix_text(values.transform, 12)
        self.matrix.setToolTip(gettext(SCANNER_WORDS[setup.scanner_frame]))


def _sum_error_text(correction: CorrectionValues) -> str:
    """Warning not to add correction and current angles."""
    return gettext(
        "<b>Do not add the correction to the current angles.</b> The sum would be wrong by "
        "{angle}, which is {distance} at {range}.",
        angle=local_amount(correction.sum_error_deg, DEGREES),
        distance=local_amount(correction.sum_error_m, SUM_ERROR_MILLIMETRES),
        range=local_amount(SUM_ERROR_RANGE_M, Format("m")),
    )


def _matrix_html(matrix: Matrix) -> str:
    rows = matrix_text(matrix, 7).replace(" ", "&nbsp;").replace("\n", "<br>")
    return f"<code>{rows}</code>"


def _angle_lines(values: ConventionValues) -> str:
    decimals = angle_format(values).decimals
    return "\n".join(
        f"{in_english(angle.name)}\t{round(angle.value_deg, decimals) + 0.0:.{decimals}f}"
        for angle in values.angles
    )
