"""Angles in another program: the same boresight as that program wants it typed."""

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtWidgets import (
    QApplication,
    QComboBox,
    QHBoxLayout,
    QVBoxLayout,
    QWidget,
)

from lispac.errors import InputError
from lispac.gui import theme, units
from lispac.gui.language import say
from lispac.gui.panels import widgets
from lispac.gui.panels.convention_inputs import CurrentSettings, GivenBoresight, ImuAxes
from lispac.gui.panels.convention_table import AnglesTable
from lispac.gui.panels.gizmo import Gizmo
from lispac.gui.panels.matrix_field import MatrixField
from lispac.gui.panels.mounting_words import boresight_said, lever_arm_said
from lispac.project import Project
from lispac.survey.conventions.axes import Axes
from lispac.survey.conventions.conversion import Setup, Stated
from lispac.survey.conventions.correction import SUM_MATTERS
from lispac.survey.conventions.present import Replacement, replacement
from lispac.survey.conventions.systems import (
    DIRECTION_WORDS,
    LISPAC,
    SCANNER_WORDS,
    STATUS_WORDS,
    SYSTEMS,
    Convention,
    Scanner,
    Status,
)
from lispac.survey.conventions.words import offsets_words
from lispac.survey.georeferencing import Mounting

TITLE = "Angles in another program"
_COLOURS: dict[Status, str] = {
    "verified": "done",
    "partly": "warning",
    "unverified": "error",
}
_SCANNER_SHORT: dict[Scanner, str] = {
    "turned": "like the body axes",
    "kept": "as in the raw points",
    "mounted": "laid on them by a mounting",
}


class ConventionPanel(QWidget):
    """Shows a boresight in the convention of a chosen program, with what is assumed of it."""

    def __init__(self) -> None:
        super().__init__()
        self._all_digits = self._all_angles = ""
        self.given, self.current, self.imu = GivenBoresight(), CurrentSettings(), ImuAxes()
        self._build()
        for inputs in (self.given, self.current, self.imu):
            inputs.changed.connect(self._refresh)
        self.system.currentIndexChanged.connect(self._choose)
        self._choose(1)

    @property
    def convention(self) -> Convention:
        """The chosen system."""
        return SYSTEMS[self.system.currentIndex()]

    def show_project(self, project: Project | None) -> None:
        """Take over the project's boresight and lever arm where they changed."""
        self.given.show_project(project)

    # -- assembly ----------------------------------------------------------------------------

    def _build(self) -> None:
        body = QWidget()
        layout = widgets.column(body)
        layout.addWidget(widgets.label("Program", "heading"))
        self.system = QComboBox()
        self.system.setObjectName("convention_system")
        self.system.setAccessibleName(say("Program the angles are for"))
        for each in SYSTEMS:
            self.system.addItem(say(f"{each.name} ({STATUS_WORDS[each.status].lower()})"))
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
        self.table = AnglesTable()
        layout.addWidget(self.table)
        self.remarks = widgets.label("", "muted", wrap=True, name="convention_remarks", rich=True)
        layout.addWidget(self.remarks)
        self.rules = widgets.label("", "muted", wrap=True, name="convention_rules", rich=True)
        self.lever = widgets.label(wrap=True, name="convention_lever", rich=True)
        self.lever.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        layout.addWidget(self.lever)
        self.words = widgets.label(wrap=True, name="convention_words", rich=True)
        layout.addWidget(self.words)
        self.gizmo = Gizmo()
        layout.addWidget(self.gizmo)
        layout.addWidget(self.rules)
        layout.addWidget(self.current)
        layout.addWidget(self.given)
        layout.addWidget(self._matrix_box())
        layout.addStretch(1)
        area = widgets.TallArea(body, 380)
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
            say("How that program's scanner axes lie to those of the raw points")
        )
        self.scanner.setMinimumContentsLength(16)
        self.scanner.setSizeAdjustPolicy(
            QComboBox.SizeAdjustPolicy.AdjustToMinimumContentsLengthWithIcon
        )
        self.scanner.currentIndexChanged.connect(self._refresh)
        # One above the other: a French choice is as wide as the panel
        layout.addWidget(widgets.label("Scanner axes there", "muted"))
        layout.addWidget(self.scanner)
        self.matrix_head = widgets.label("", "heading", wrap=True)
        layout.addWidget(self.matrix_head)
        self.matrix = MatrixField(
            "convention_matrix", "Matrix from scanner to body", read_only=True
        )
        layout.addWidget(self.matrix)
        self.copy = widgets.button(
            "Copy matrix", "convention_copy", icon="content-copy",
            tip="Copy the sixteen numbers, row by row, to the clipboard",
        )  # fmt: skip
        self.copy.clicked.connect(lambda: QApplication.clipboard().setText(self._all_digits))
        self.copy_angles = widgets.button(
            "Copy angles", "convention_copy_angles", icon="content-copy",
            tip="Copy the angles to type in, one a line with its name, to the clipboard",
        )  # fmt: skip
        self.copy_angles.clicked.connect(lambda: QApplication.clipboard().setText(self._all_angles))
        row = QHBoxLayout()
        row.addWidget(self.copy)
        row.addWidget(self.copy_angles)
        row.addStretch(1)
        layout.addLayout(row)
        return box

    # -- what the user does ------------------------------------------------------------------

    def _choose(self, index: int) -> None:
        if self.system.currentIndex() != index:
            self.system.setCurrentIndex(index)
            return
        convention = self.convention
        self.scanner.blockSignals(True)
        self.scanner.clear()
        for kind, words in _SCANNER_SHORT.items():
            usual = " (usual)" if kind == convention.scanner else ""
            self.scanner.addItem(say(f"{words}{usual}"), kind)
        self.scanner.setCurrentIndex(self.scanner.findData(convention.scanner))
        self.scanner.blockSignals(False)
        self.scanner.setEnabled(convention.key != LISPAC.key)
        self.imu.setVisible(convention.open_axes)
        self.current.show_convention(convention)
        self._refresh()

    # -- what is shown -----------------------------------------------------------------------

    def _refresh(self) -> None:
        convention, given = self.convention, self.given
        try:
            body_axes = self.imu.axes if convention.open_axes else None
            setup = Setup(convention, body_axes, self.scanner.currentData())
            new = replacement(
                setup, given.mounting, given.covariance, self.current.of(setup),
                applied=self.current.applied.isChecked(), has_lever_arm=given.has_lever_arm,
            )  # fmt: skip
        except InputError as error:
            self._show_refusal(str(error))
            return
        self._show_rules(setup, new.mounting)
        self._show_values(new)
        self._show_words(new.mounting)
        self._show_matrix(new.stated)

    def _show_refusal(self, sentence: str) -> None:
        self.assumption.setText(say(sentence))
        self.assumption.show()
        for widget in (self.table, self.remarks, self.lever, self.rules, self.matrix):
            widget.setVisible(False)
        self.values_head.setText(say("No values"))
        for button in (self.copy, self.copy_angles):
            button.setEnabled(False)

    def _show_rules(self, setup: Setup, mounting: Mounting) -> None:
        convention = setup.convention
        word = STATUS_WORDS[setup.status].capitalize()
        colour = theme.colour(_COLOURS[setup.status]).name()
        x, y, z = setup.axes
        self.status.setText(say(f'<b style="color:{colour}">{word}</b>: {convention.source}.'))
        rules = f"Body axes there: X {x}, Y {y}, Z {z}."
        if convention.has_angles:
            formula = convention.formula.replace("-", "−")
            rules = f"{formula}, {DIRECTION_WORDS[convention.direction]}. {rules}"
        if convention.key != LISPAC.key:
            rules += f" {setup.scanner_words(mounting.rotation_body_lidar)}"
        self.rules.setText(say(rules))
        self.imu.show_z(z)
        self.assumption.setText(f"<b>{say('Assumed:')}</b> {say(setup.assumption)}")
        self.assumption.setVisible(bool(setup.assumption))

    def _show_values(self, new: Replacement) -> None:
        stated, correction = new.stated, new.correction
        setup = stated.setup
        convention = setup.convention
        sure = setup.status == "verified"
        for widget in (self.remarks, self.lever, self.rules, self.matrix):
            widget.setVisible(True)
        self.copy.setEnabled(True)
        self.copy_angles.setEnabled(stated.angles is not None)
        self.table.setVisible(convention.has_angles)
        if stated.angles is None:
            self.values_head.setText(say("Taken as a matrix only: see below"))
            self.remarks.setVisible(correction is not None)
            if correction is not None:
                self.remarks.setText(_matrix_words(correction.rotation, new.transform))
        else:
            self.values_head.setText(
                say("Type in there, degrees" if sure else "If the assumption holds, degrees")
            )
            decimals = 8 if stated.note else 4
            last = ("Type in" if sure else "If so", stated.angles, "+", True)
            rows: list[tuple[str, np.ndarray, str, bool]] = [last]
            if correction is not None:
                assert correction.current is not None
                assert correction.correction is not None
                rows = [("Now set", correction.current, "+", False),
                        ("Correction", correction.correction, "+", False), last]  # fmt: skip
            if stated.sigmas is not None:
                rows.append(("± 1 σ", stated.sigmas, "", False))
            self.table.fill(convention, rows, decimals)
            self._all_angles = _lines(convention, stated.angles, decimals)
            self._show_remarks(new)
        arm = _lever_words(setup.axes, stated.lever_arm)
        said = [f"Lever arm there, from the POS centre: {arm}"]
        if new.present is not None and new.present.lever_arm is not None:
            said.append(f"Present: {_lever_words(setup.axes, new.present.lever_arm)}")
            said.append(new.lever_arm_words)
        self.lever.setText(say("<br>".join(said)))

    def _show_remarks(self, new: Replacement) -> None:
        stated, correction = new.stated, new.correction
        signs = say(f"{stated.setup.signs}.")
        lines = [f"{signs[0].upper()}{signs[1:]}"]
        if correction is not None:
            lines.append(
                say("The matrix of the correction stands on the left: new = correction · present.")
            )
            error = correction.sum_error
            if error > SUM_MATTERS:
                lines.append(_off(error))
        if new.transform is not None:
            lines.append(f"{say('The correction of the 4x4 matrix:')}<br>{_code(new.transform)}")
        if stated.note:
            lines.append(f"<b>{say(stated.note)}</b>")
        if stated.sigmas is not None and self.given.caution:
            lines.append(say(self.given.caution))
        self.remarks.setText("<br>".join(lines))

    def _show_words(self, mounting: Mounting) -> None:
        sentences = (
            f"<b>{boresight_said(mounting.plain.boresight)}</b>",
            lever_arm_said(mounting.lever_arm),
            say(offsets_words(mounting)),
        )
        self.words.setText("<br>".join(sentence for sentence in sentences if sentence))
        self.gizmo.show_boresight(np.asarray(mounting.plain.boresight, dtype=float))

    def _show_matrix(self, stated: Stated) -> None:
        name = stated.setup.convention.name
        self.matrix_head.setText(say(f"Scanner to body there, with the lever arm ({name})"))
        self.matrix.setPlainText(_rows(stated.transform, 7))
        self._all_digits = _rows(stated.transform, 12)
        self.matrix.setToolTip(say(SCANNER_WORDS[stated.setup.scanner_frame]))


def _matrix_words(rotation: np.ndarray, transform: np.ndarray | None) -> str:
    words = "The matrix below replaces the present one: new = correction · present. The correction:"
    return f"{say(words)}<br>{_code(rotation if transform is None else transform)}"


def _off(error: float) -> str:
    """What the sum of the angles would be wrong by, radians."""
    angle = units.figure(float(np.degrees(error)), "°", ".4f")
    off, far = units.figure(error * 1e5, "mm", ".0f"), units.limit(100.0, "m")
    said = say(f"<b>Do not add the angles:</b> the sum would be {angle}° off, {off} mm at {far} m.")
    return units.signs(said, "°", "mm", "m")


def _code(matrix: np.ndarray) -> str:
    rows = _rows(matrix, 7).replace(" ", "&nbsp;").replace("\n", "<br>")
    return f"<code>{rows}</code>"


def _lever_words(axes: Axes, values: np.ndarray) -> str:
    # Unbreakable, so that a line ends between two axes and never before a number.
    return ", ".join(
        f"{letter} {say(axis)} <b>{say(f'{value + 0.0:+.4f}')}</b> m".replace("-", "−").replace(
            " ", "&nbsp;"
        )
        for letter, axis, value in zip("XYZ", axes, np.round(values, 4), strict=True)
    )


def _lines(convention: Convention, angles: np.ndarray, decimals: int) -> str:
    values = np.round(np.degrees(angles), decimals) + 0.0
    named = zip(convention.names, values, strict=True)
    return "\n".join(f"{name}\t{value:.{decimals}f}" for name, value in named)


def _rows(matrix: np.ndarray, decimals: int) -> str:
    return "\n".join(
        " ".join(f"{value + 0.0:{decimals + 4}.{decimals}f}" for value in np.round(row, decimals))
        for row in matrix
    )
