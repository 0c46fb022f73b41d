"""The answer: angles, their uncertainty, and how well the model fits."""

from collections.abc import Sequence
from html import escape

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QBrush, QColor
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFormLayout,
    QHeaderView,
    QScrollArea,
    QStackedLayout,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from lispac.adjustment.doubts import HIGH_CORRELATION, doubts
from lispac.adjustment.older import refused_since
from lispac.adjustment.result import ANGLES, AdjustmentResult
from lispac.adjustment.stochastic import StochasticModel
from lispac.doubles import project_doubts
from lispac.gui import theme, units
from lispac.gui.language import say, say_all, say_message
from lispac.gui.panels import result_words, widgets
from lispac.gui.panels.mounting_words import boresight_said
from lispac.messages import Message
from lispac.project import Project, Triple

CONVENTION = (
    "The boresight turns the LiDAR frame into the body frame (forward, left, up):<br>"
    "<b>R = R<sub>z</sub>(−yaw) · R<sub>y</sub>(pitch) · R<sub>x</sub>(roll)</b><br>"
    "Roll is positive left side up, pitch positive bow down, yaw positive clockwise seen from "
    "above."
)
EMPTY = (
    "Nothing estimated yet. Pick at least two targets that face different ways, then press "
    "Estimate in step 3. Roll, pitch and yaw appear here with their uncertainties."
)
_TWO_SIDED_95 = 1.96
_ROW = 25
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


class ResultsPanel(QWidget):
    """Reads like the first page of the report."""

    def __init__(self) -> None:
        super().__init__()
        self._stack = QStackedLayout(self)
        empty = QWidget()
        layout = widgets.column(empty)
        self.refusal = widgets.label("", "warning", wrap=True, name="results_refusal")
        layout.addWidget(self.refusal)
        self._empty = widgets.label(EMPTY, "muted", wrap=True, name="results_empty")
        layout.addWidget(self._empty)
        layout.addStretch(1)
        self._stack.addWidget(empty)
        self._stack.addWidget(self._scrolled())

    def show_project(
        self,
        project: Project | None,
        *,
        waiting: bool = False,
        refusal: str = "",
        older: Message | str = "",
    ) -> None:
        """Show the result, where there is one.

        Parameters
        ----------
        waiting : bool
            The next result is on its way: the old one stays, greyed.
        refusal : str
            Why there is none.
        older : Message or str
            Why an estimate was refused that was asked for after the result.
        """
        result = None if project is None else project.result
        greyed = waiting and self._stack.currentIndex() == 1
        self._waiting.setVisible(greyed)
        self._body.setEnabled(not greyed)
        if greyed:
            return
        self._stack.setCurrentIndex(0 if result is None else 1)
        self.refusal.setVisible(bool(refusal))
        self.refusal.setText(say(refusal))
        self._empty.setText(say("Estimating …" if waiting else "" if refusal else EMPTY))
        if project is not None and result is not None:
            _fill_angles(self.angles, result, project.truth_deg)
            self._truth_note.setVisible(project.truth_deg is not None)
            self._fill_rotation(result)
            self._fill_words(project, result, older)
            _fill_correlation(self.correlation, result)
            self._fill_fit(project, result)

    def _scrolled(self) -> QScrollArea:
        outer = QWidget()
        around = widgets.column(outer)
        self._waiting = widgets.label(
            "Estimating again; the figures below are those from before the change.", "hint",
            wrap=True, name="results_waiting",
        )  # fmt: skip
        around.addWidget(self._waiting)
        self._body = QWidget()
        around.addWidget(self._body)
        layout = widgets.column(self._body, 0)
        self.warnings = widgets.label("", "warning", wrap=True, name="results_warnings", rich=True)
        layout.addWidget(self.warnings)
        head = widgets.label("Boresight, degrees", "heading")
        head.setText(units.signs(head.text(), "°"))
        layout.addWidget(head)
        self.angles = _table("angles_table", 4)
        layout.addWidget(self.angles)
        self._truth_note = widgets.label(
            "Simulated survey: the truth is known. Green lies within the 95 % interval.",
            "muted", wrap=True,
        )  # fmt: skip
        layout.addWidget(self._truth_note)
        self.rotation = widgets.label("", wrap=True, name="results_rotation", rich=True)
        layout.addWidget(self.rotation)
        self._parameters_head = widgets.label("Also estimated", "heading")
        layout.addWidget(self._parameters_head)
        self.parameters = widgets.label("", wrap=True, name="results_parameters", rich=True)
        layout.addWidget(self.parameters)
        layout.addWidget(widgets.label("Weakest direction", "heading"))
        self.weakest = widgets.label("", wrap=True, name="results_weakest")
        layout.addWidget(self.weakest)
        layout.addWidget(widgets.label("Fit", "heading"))
        layout.addLayout(self._fit_form())
        self._verdict = widgets.label("", wrap=True, name="chi_square_verdict")
        layout.addWidget(self._verdict)
        layout.addWidget(widgets.label("Correlation", "heading"))
        self.correlation = _table("correlation_table", 3)
        layout.addWidget(self.correlation)
        layout.addWidget(widgets.label("Convention", "heading"))
        layout.addWidget(
            widgets.label(CONVENTION, "muted", wrap=True, name="convention", rich=True)
        )
        around.addStretch(1)
        return widgets.TallArea(outer, 380)

    def _fill_rotation(self, result: AdjustmentResult) -> None:
        """The rotation where the pitch is so steep that the three angles do not describe it."""
        is_shown = result.mounting.axes is not None
        self.rotation.setVisible(is_shown)
        if is_shown:
            rows = "".join(
                f"<tr>{''.join(map(_matrix_cell, row))}</tr>"
                for row in result.mounting.rotation_body_lidar
            )
            words = escape(boresight_said(result.angles))
            title = escape(say("Rotation matrix, LiDAR to body (forward, left, up):"))
            self.rotation.setText(f"{words}<br>{title}<table>{rows}</table>")

    def _fill_words(self, project: Project, result: AdjustmentResult, older: Message | str) -> None:
        also = list(project_doubts(project))
        if older:
            also.insert(0, refused_since(older))
        warnings = doubts(result, project.cross_checks, also)
        self.warnings.setText("<br><br>".join(escape(say_message(each)) for each in warnings))
        self.warnings.setVisible(bool(warnings))
        rows = result_words.parameter_rows(result)
        self.parameters.setText(units.signs(say(rows), "m", "°"))
        for each in (self._parameters_head, self.parameters):
            each.setVisible(bool(rows))
        seen = result.observability
        self.weakest.setText(say("Not worked out." if seen is None else seen.sentences[0]))

    def _fit_form(self) -> QFormLayout:
        form = QFormLayout()
        form.setHorizontalSpacing(14)
        form.setVerticalSpacing(4)
        self._values = {}
        for key, words in (
            ("rms", "RMS point-to-plane"),
            ("factor", "Variance factor"),
            ("chi", "Chi-square test"),
            ("points", "Points, sightings"),
            ("model", "POS errors"),
            ("surface", "Surface sigma"),
            ("iterations", "Iterations, time"),
        ):
            value = widgets.label(name=f"result_{key}", rich=True)
            value.setFont(theme.tabular(value.font()))
            value.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
            self._values[key] = value
            form.addRow(widgets.label(words, "muted"), value)
        return form

    def _fill_fit(self, project: Project, result: AdjustmentResult) -> None:
        before, after = (
            units.figure(1000 * each, "mm", ".1f") for each in (result.rms_before, result.rms_after)
        )
        components = result_words.component_words(result)
        texts = {
            "rms": f"{before} → <b>{after} mm</b>",
            "factor": f"{result.variance_factor:.3f}",
            "chi": result_words.test_words(result),
            "points": result_words.taking_part(result),
            "model": _model_words(result.model),
            "surface": result_words.surface_words(result),
            "iterations": f"{result.iterations}, {result.elapsed:.2f} s",
        }
        for key, text in texts.items():
            self._values[key].setText(units.signs(say(text), "mm"))
        words = result_words.verdict(result, project.cross_checks, project_doubts(project))
        self._verdict.setText(
            say(f"{words} Errors by the data: {components}." if components else words)
        )


def _matrix_cell(value: float) -> str:
    number = say(f"{value:+.8f}".replace("-", "−"))
    return f"<td align=right>{number}&nbsp;&nbsp;</td>"


def _model_words(model: StochasticModel) -> str:
    if not model.correlated:
        return "uncorrelated (classical)"
    return f"correlated, {model.position_time:g} s and {model.attitude_time:g} s"


def _table(name: str, rows: int) -> QTableWidget:
    table = QTableWidget(rows, len(ANGLES))
    table.setTabKeyNavigation(False)
    table.setObjectName(name)
    table.setAccessibleName(say(name.replace("_", " ")))
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setSelectionMode(QAbstractItemView.SelectionMode.ContiguousSelection)
    table.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    table.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    table.setHorizontalHeaderLabels(say_all(angle.capitalize() for angle in ANGLES))
    for column in range(len(ANGLES)):
        table.horizontalHeaderItem(column).setTextAlignment(_RIGHT)
    side = table.verticalHeader()
    side.setDefaultSectionSize(_ROW)
    side.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
    side.setMinimumWidth(96)
    side.setHighlightSections(False)
    header = table.horizontalHeader()
    header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
    header.setHighlightSections(False)
    return table


def _set_rows(table: QTableWidget, words: Sequence[str]) -> None:
    table.setRowCount(len(words))
    table.setVerticalHeaderLabels(say_all(list(words)))
    table.setFixedHeight(table.horizontalHeader().sizeHint().height() + _ROW * len(words) + 3)


def _fill_angles(table: QTableWidget, result: AdjustmentResult, truth: Triple | None) -> None:
    prior, value = np.degrees(result.prior_angles), np.degrees(result.angles)
    sigma = np.degrees(result.sigma)
    interval = _TWO_SIDED_95 * sigma
    rows = [
        ("Prior", prior, "+.4f", "Where the adjustment started"),
        ("Estimated", value, "+.4f", "The adjusted boresight"),
        ("± 1 σ", sigma, ".4f", "One standard deviation"),
        ("± 95 %", interval, ".4f", "Half width of the 95 % interval: 1.96 σ"),
    ]
    if truth is not None:
        rows.append(("Truth", np.array(truth), "+.4f", "What the simulator put in"))
    _set_rows(table, [row[0] for row in rows])
    for k, (word, numbers, form, tip) in enumerate(rows):
        _write_row(
            table, k, [units.figure(n, "°", form) for n in numbers], bold=word == "Estimated"
        )
        table.verticalHeaderItem(k).setToolTip(say(tip))
    for column in range(len(ANGLES) if truth is not None else 0):
        off = value[column] - truth[column]
        inside = abs(off) <= interval[column]
        item = table.item(4, column)
        item.setForeground(QBrush(QColor(theme.DONE if inside else theme.WARNING)))
        item.setToolTip(
            units.signs(
                say(
                    f"Estimated minus truth: {units.figure(off, '°', '+.4f')}°, "
                    f"{'inside' if inside else 'outside'} the 95 % interval"
                ),
                "°",
            )
        )


def _fill_correlation(table: QTableWidget, result: AdjustmentResult) -> None:
    _set_rows(table, [angle.capitalize() for angle in ANGLES])
    for row in range(3):
        _write_row(table, row, [f"{value:+.2f}" for value in result.correlation[row]])
        for column in range(3):
            item = table.item(row, column)
            value = float(result.correlation[row, column])
            item.setBackground(QBrush(_heat(value)))
            if row != column and abs(value) > HIGH_CORRELATION:
                item.setToolTip(
                    say("These two angles are hardly told apart: add a target that faces elsewhere")
                )


def _write_row(table: QTableWidget, row: int, texts: Sequence[str], *, bold: bool = False) -> None:
    for column, text in enumerate(texts):
        item = QTableWidgetItem(say(text.replace("-", "−")))
        item.setTextAlignment(_RIGHT)
        item.setFont(theme.tabular(table.font(), bold=bold))
        table.setItem(row, column, item)


def _heat(value: float) -> QColor:
    """Paper at 0, blue towards +1, orange towards -1; text stays readable on both."""
    full = QColor(theme.POSITIVE if value >= 0 else theme.NEGATIVE)
    share = min(abs(value), 1.0)
    ends = zip(QColor(theme.PAPER).getRgb()[:3], full.getRgb()[:3], strict=True)
    return QColor(*(round(none + share * (all_of - none)) for none, all_of in ends))
