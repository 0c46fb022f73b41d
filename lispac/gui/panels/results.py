"""The answer: angles, their uncertainty, and how well the model fits."""

from collections.abc import Sequence

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QBrush, QColor
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFormLayout,
    QFrame,
    QHeaderView,
    QScrollArea,
    QStackedLayout,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from lispac.adjustment.result import ANGLES, AdjustmentResult
from lispac.gui import theme
from lispac.gui.panels import widgets
from lispac.project import Project, Triple

CONVENTION = (
    "The boresight turns the LiDAR frame into the body frame (forward, left, up):<br>"
    "<b>R = R<sub>z</sub>(−yaw) · R<sub>y</sub>(pitch) · R<sub>x</sub>(roll)</b><br>"
    "Roll is positive left side up, pitch positive bow down, yaw positive clockwise seen from "
    "above."
)
_TWO_SIDED_95 = 1.96
_ROW = 25
_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


class ResultsPanel(QWidget):
    """Reads like the first page of the report."""

    def __init__(self) -> None:
        super().__init__()
        self.setMinimumWidth(380)
        self._stack = QStackedLayout(self)
        empty = QWidget()
        layout = widgets.column(empty)
        layout.addWidget(
            widgets.label(
                "Nothing estimated yet. Pick at least two targets that face different ways, "
                "then press Estimate in step 3. Roll, pitch and yaw appear here with their "
                "uncertainties.", "muted", wrap=True, name="results_empty",
            )
        )  # fmt: skip
        layout.addStretch(1)
        self._stack.addWidget(empty)
        self._stack.addWidget(self._scrolled())

    def show_project(self, project: Project | None) -> None:
        """Show the result, where there is one."""
        result = None if project is None else project.result
        self._stack.setCurrentIndex(0 if result is None else 1)
        if project is not None and result is not None:
            _fill_angles(self.angles, result, project.truth_deg)
            self._truth_note.setVisible(project.truth_deg is not None)
            _fill_correlation(self.correlation, result)
            self._fill_fit(result)

    def _scrolled(self) -> QScrollArea:
        body = QWidget()
        layout = widgets.column(body)
        layout.addWidget(widgets.label("Boresight, degrees", "heading"))
        self.angles = _table("angles_table", 4)
        layout.addWidget(self.angles)
        self._truth_note = widgets.label(
            "Simulated survey: the truth is known. Green lies within the 95 % interval.",
            "muted", wrap=True,
        )  # fmt: skip
        layout.addWidget(self._truth_note)
        layout.addWidget(widgets.label("Correlation", "heading"))
        self.correlation = _table("correlation_table", 3)
        layout.addWidget(self.correlation)
        layout.addWidget(widgets.label("Fit", "heading"))
        layout.addLayout(self._fit_form())
        self._verdict = widgets.label("", wrap=True, name="chi_square_verdict")
        layout.addWidget(self._verdict)
        layout.addWidget(widgets.label("Convention", "heading"))
        layout.addWidget(widgets.label(CONVENTION, "muted", wrap=True, name="convention"))
        layout.addStretch(1)
        area = QScrollArea()
        area.setWidgetResizable(True)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        area.setWidget(body)
        return area

    def _fit_form(self) -> QFormLayout:
        form = QFormLayout()
        form.setHorizontalSpacing(14)
        form.setVerticalSpacing(4)
        self._values = {}
        for key, words in (
            ("rms", "RMS to joint planes"),
            ("factor", "Variance factor"),
            ("chi", "Chi-square test"),
            ("points", "Points, sightings"),
            ("model", "POS errors"),
            ("iterations", "Iterations, time"),
        ):
            value = widgets.label(name=f"result_{key}")
            value.setFont(theme.tabular(value.font()))
            value.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
            self._values[key] = value
            form.addRow(widgets.label(words, "muted"), value)
        return form

    def _fill_fit(self, result: AdjustmentResult) -> None:
        test = result.chi_square
        word, colour = ("passed", theme.DONE) if test.passed else ("failed", theme.WARNING)
        texts = {
            "rms": f"{result.rms_before * 1000:.1f} mm before → "
            f"<b>{result.rms_after * 1000:.1f} mm after</b>",
            "factor": f"{result.variance_factor:.3f}",
            "chi": f"<b style='color:{colour}'>{word}</b>: {test.statistic:.4g} in "
            f"[{test.lower:.4g}, {test.upper:.4g}]"
            if test.passed
            else f"<b style='color:{colour}'>{word}</b>: {test.statistic:.4g} not in "
            f"[{test.lower:.4g}, {test.upper:.4g}]",
            "points": f"{result.points:,} points, {len(result.sightings)} sightings",
            "model": "correlated in time"
            if result.model.pos_errors == "correlated"
            else "independent for each point",
            "iterations": f"{result.iterations}, {result.elapsed:.2f} s",
        }
        for key, text in texts.items():
            self._values[key].setText(text)
        self._verdict.setText(verdict(result))


def verdict(result: AdjustmentResult) -> str:
    """What the chi-square test means, in words."""
    if result.chi_square.passed:
        return "The residuals are as large as the stated sigmas say: the uncertainties can be used."
    if result.variance_factor > 1:
        return (
            "The residuals are larger than the stated sigmas say. Look for a target that is not "
            "flat or a sighting that holds other points, or state larger sigmas."
        )
    return (
        "The residuals are smaller than the stated sigmas say: the sigmas of LiDAR or POS are "
        "stated too large, so the uncertainties are on the safe side."
    )


def _table(name: str, rows: int) -> QTableWidget:
    table = QTableWidget(rows, len(ANGLES))
    table.setObjectName(name)
    table.setAccessibleName(name.replace("_", " "))
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setSelectionMode(QAbstractItemView.SelectionMode.ContiguousSelection)
    table.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    table.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    table.setHorizontalHeaderLabels([angle.capitalize() for angle in ANGLES])
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
    table.setVerticalHeaderLabels(list(words))
    table.setFixedHeight(table.horizontalHeader().sizeHint().height() + _ROW * len(words) + 3)


def _fill_angles(table: QTableWidget, result: AdjustmentResult, truth: Triple | None) -> None:
    prior, value = np.degrees(result.prior_boresight), np.degrees(result.boresight)
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
        _write_row(table, k, [f"{n:{form}}" for n in numbers], bold=word == "Estimated")
        table.verticalHeaderItem(k).setToolTip(tip)
    for column in range(len(ANGLES) if truth is not None else 0):
        off = value[column] - truth[column]
        inside = abs(off) <= interval[column]
        item = table.item(4, column)
        item.setForeground(QBrush(QColor(theme.DONE if inside else theme.WARNING)))
        item.setToolTip(
            f"Estimated minus truth: {off:+.4f}°, "
            f"{'inside' if inside else 'outside'} the 95 % interval"
        )


def _fill_correlation(table: QTableWidget, result: AdjustmentResult) -> None:
    _set_rows(table, [angle.capitalize() for angle in ANGLES])
    for row in range(3):
        _write_row(table, row, [f"{value:+.2f}" for value in result.correlation[row]])
        for column in range(3):
            item = table.item(row, column)
            value = float(result.correlation[row, column])
            item.setBackground(QBrush(_heat(value)))
            if row != column and abs(value) > 0.9:
                item.setToolTip(
                    "These two angles are hardly told apart: add a target that faces elsewhere"
                )


def _write_row(table: QTableWidget, row: int, texts: Sequence[str], *, bold: bool = False) -> None:
    for column, text in enumerate(texts):
        item = QTableWidgetItem(text.replace("-", "−"))
        item.setTextAlignment(_RIGHT)
        item.setFont(theme.tabular(table.font(), bold=bold))
        table.setItem(row, column, item)


def _heat(value: float) -> QColor:
    """White at 0, blue towards +1, orange towards -1; black text stays readable on both."""
    full = QColor("#7fb0e2") if value >= 0 else QColor("#f0b26b")
    share = min(abs(value), 1.0)
    return QColor(*(round(255 + share * (c - 255)) for c in full.getRgb()[:3]))
