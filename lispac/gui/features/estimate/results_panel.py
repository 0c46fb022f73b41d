"""Results of the adjustment: boresight angles, their uncertainty and the goodness of fit."""

from collections.abc import Sequence
from html import escape

from PySide6.QtCore import QEvent, QObject, QPoint, Qt, QTimer, Signal
from PySide6.QtGui import QBrush, QColor, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QGridLayout,
    QHBoxLayout,
    QHeaderView,
    QScrollArea,
    QStackedLayout,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from lispac.adjustment.diagnostics.sign_check import ASSUMED_SIGN_CODES
from lispac.adjustment.diagnostics.warnings import (
    HIGH_CORRELATION,
    outdated_result_warning,
    result_warnings,
)
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.result import ANGLES, AdjustmentResult, CrossChecks
from lispac.duplicate_targets import project_warnings
from lispac.gui import widgets
from lispac.gui.appearance import theme, units
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.estimate import result_texts
from lispac.gui.project.status import OUTDATED_RESULT_NOTE, ProjectState
from lispac.gui.widgets.column_flow import ColumnFlow
from lispac.gui.widgets.marked_cells import MarkedCells
from lispac.gui.widgets.mounting_texts import (
    CONVENTION_NAME_TEXT,
    SIGNS_TEXT,
    boresight_sentence,
    convention_html,
)
from lispac.gui.widgets.result_tables import fact_text, local_cell_text, local_number
from lispac.language import N_, gettext, join_items
from lispac.messages import Level
from lispac.present.angles import (
    ANGLE_TITLES,
    CORRELATIONS_TABLE,
    ROTATION_ENTRY,
    angles,
    correlation_rows,
)
from lispac.present.calibration.adjustment import (
    ERROR_FORMAT,
    ESTIMATED_COLUMN,
    SHORT_ANGLE_SIGNS,
    adjustment_values,
    angle_values,
    window_boresight_table,
)
from lispac.present.calibration.adjustment_fit import VARIANCE_FACTOR_FORMAT
from lispac.present.calibration.sigmas import LIDAR_NOISE
from lispac.present.tables import MILLIMETRES, Fact, cell_text, title_text
from lispac.project import Project, Settings, Triple

EMPTY_TEXT = N_(
    "No result yet. Pick at least two targets with different orientations, then press Estimate in "
    "step 3."
)
WAITING_TEXT = N_("Estimating …")
_ROW_HEIGHT_PX = 19
_RIGHT_MARGIN_PX = 4
_SIGNS_HEIGHT_PX = 37
"""Height of a header of two lines."""
_MIN_VALUE_WIDTH_PX = 190
"""Smallest width of a value of the fit; longer texts are wrapped."""
_ALIGN_RIGHT = Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter


MIN_WIDTH_PX = 420
ARRANGEMENTS = (
    (("warnings", "angles", "parameters", "weakest", "fit", "correlation", "convention"),),
    (("angles", "correlation", "convention"), ("warnings", "fit", "parameters", "weakest")),
    (("angles", "correlation"), ("fit", "convention"), ("warnings", "parameters", "weakest")),
    (
        ("angles",), ("fit",), ("warnings", "parameters", "weakest"),
        ("correlation", "convention"),
    ),
)  # fmt: skip
"""Blocks of each column, from one column in a narrow panel to four in a wide one."""


class ResultsPanel(QWidget):
    """Result of the adjustment, in the order of page one of the report."""

    estimate_requested = Signal(object)
    """The boresight is to be estimated with these `Settings`."""
    enlarged = Signal(bool)
    """The user wants a higher panel, or the initial height."""
    cross_checks_requested = Signal()
    """The table of the cross-checks is to be shown."""

    def __init__(self) -> None:
        super().__init__()
        self._settings: Settings | None = None
        self._cross_checks: CrossChecks | None = None
        self._is_checking = False
        self._stack = QStackedLayout(self)
        empty = QWidget()
        layout = widgets.vertical_layout(empty)
        self.refusal = widgets.label("", "warning", wrap=True, name="results_refusal")
        layout.addWidget(self.refusal)
        self._empty = widgets.label("", "muted", wrap=True, name="results_empty")
        layout.addWidget(self._empty)
        layout.addStretch(1)
        self._stack.addWidget(empty)
        filled = QWidget()
        self._row = row = QHBoxLayout(filled)
        row.setContentsMargins(0, 0, _RIGHT_MARGIN_PX, 0)
        row.setSpacing(0)
        self._area = self._create_body()
        self._area.widget().installEventFilter(self)
        row.addWidget(self._area, 1)
        self.enlarge = widgets.enlarge_button("enlarge_results")
        self.enlarge.setToolTip(gettext("Enlarge the panel for all results, or restore its height"))
        self.enlarge.toggled.connect(self.enlarged)
        row.addWidget(self.enlarge, 0, Qt.AlignmentFlag.AlignTop)
        self._stack.addWidget(filled)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Keep the rows of the angles whole when they have been laid out."""
        if event.type() in (QEvent.Type.LayoutRequest, QEvent.Type.Resize):
            QTimer.singleShot(0, self, self._hide_cut_rows)
        return super().eventFilter(watched, event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the rows of the angles whole."""
        super().resizeEvent(event)
        self._hide_cut_rows()

    def _hide_cut_rows(self) -> None:
        """Leave a margin below the results instead of a part of a row of the angles."""
        body, table = self._area.widget(), self.angles
        top = table.mapTo(body, QPoint()).y() + table.viewport().y()
        rows = [
            (start := top + table.rowViewportPosition(row), start + table.rowHeight(row))
            for row in range(table.rowCount())
        ]
        cut = [start for start, end in rows if start < self.height() < end]
        margin = self.height() - cut[0] if cut else 0
        self._row.setContentsMargins(0, 0, _RIGHT_MARGIN_PX, margin)

    def show_checking(self, running: bool) -> None:
        """Show whether missing cross-checks are being computed."""
        self._is_checking = running
        self._show_checks()

    def _show_checks(self) -> None:
        is_running = self._is_checking and self._cross_checks is None
        self.checks.setText(
            gettext("being computed")
            if is_running
            else result_texts.cross_checks_text(self._cross_checks)
        )

    def show_state(self, state: ProjectState) -> None:
        """Show the result of the project; while a new one is computed, disable the last one."""
        project, waiting, refusal = state.project, state.is_waiting, state.refusal
        result = None if project is None else project.result
        greyed = waiting and self._stack.currentIndex() == 1
        self._waiting.setVisible(greyed)
        self._body.setEnabled(not greyed)
        if greyed:
            return
        self._stack.setCurrentIndex(0 if result is None else 1)
        self.refusal.setVisible(bool(refusal))
        self.refusal.setText(refusal)
        if waiting:
            self._empty.setText(gettext(WAITING_TEXT))
        else:
            self._empty.setText("" if refusal else self._empty_text(state.is_outdated))
        if project is not None and result is not None:
            _fill_angles(self.angles, result, project.truth_deg)
            self._truth_note.setVisible(project.truth_deg is not None)
            self._fill_rotation(result)
            self._fill_texts(project, result, state)
            _fill_correlation(self.correlation, result)
            self._fill_fit(project, result)

    def _empty_text(self, is_outdated: bool) -> str:
        return message_text(OUTDATED_RESULT_NOTE) if is_outdated else gettext(EMPTY_TEXT)

    def _create_body(self) -> QScrollArea:
        outer = widgets.WrappedBody()
        around = widgets.vertical_layout(outer)
        around.setContentsMargins(12, 2, 12, 2)
        self._waiting = widgets.label(
            gettext("A new estimate is running. The values below are from before the change."),
            "hint", wrap=True, name="results_waiting",
        )  # fmt: skip
        around.addWidget(self._waiting)
        self.warnings = widgets.label("", "warning", wrap=True, name="results_warnings", rich=True)
        unit = units.shown_unit("°").sign
        self.angles = _create_table("angles_table", gettext("Boresight angles"), 4, unit)
        _show_signs(self.angles)
        self._truth_note = widgets.label(
            gettext(
                "Simulated survey with known true angles. Green: the true angle is within the 95 % "
                "interval."
            ),
            "muted", wrap=True,
        )  # fmt: skip
        self.rotation = widgets.label("", wrap=True, name="results_rotation", rich=True)
        self.parameters = widgets.label("", wrap=True, name="results_parameters", rich=True)
        self.weakest = widgets.label("", wrap=True, name="results_weakest")
        self._verdict = widgets.label("", wrap=True, name="chi_square_verdict")
        self.use_noise = widgets.button(
            "", "use_lidar_noise",
            tip=gettext("Estimate the boresight again with the noise found in the residuals"),
        )  # fmt: skip
        self.use_noise.clicked.connect(lambda: self.estimate_requested.emit(self._settings))
        self.correlation = _create_table(
            "correlation_table", gettext("Correlation of the angles"), 3
        )
        convention = widgets.label("", "muted", wrap=True, name="convention", rich=True)
        convention.setText(convention_html(is_named=False))  # the name is below the angles
        self._body = ColumnFlow({
            "warnings": _block(self.warnings),
            "angles": _block(
                self.angles, widgets.label(gettext(CONVENTION_NAME_TEXT), "muted"), self.rotation
            ),
            "parameters": _block(
                widgets.label(gettext("Other estimated parameters"), "heading"), self.parameters
            ),
            "weakest": _block(
                widgets.label(gettext("Weakest direction"), "heading"), self.weakest,
                self._truth_note,
            ),
            "fit": _block(
                widgets.label(gettext("Fit"), "heading"), self._fit_form(), self._verdict,
                self.use_noise,
            ),
            "correlation": _block(
                widgets.label(gettext("Correlation"), "heading"), self.correlation
            ),
            "convention": _block(widgets.label(gettext("Convention"), "heading"), convention),
        }, ARRANGEMENTS)  # fmt: skip
        around.addWidget(self._body)
        around.addStretch(1)
        area = widgets.VerticalScrollArea(outer, MIN_WIDTH_PX)
        area.setObjectName("results_area")
        return area

    def _fill_rotation(self, result: AdjustmentResult) -> None:
        """Show the rotation matrix if a steep pitch makes roll and yaw inseparable."""
        is_shown = result.mounting.axes is not None
        self.rotation.setVisible(is_shown)
        if is_shown:
            rows = "".join(
                f"<tr>{''.join(map(_matrix_cell, row))}</tr>"
                for row in result.mounting.rotation_body_lidar
            )
            sentence = escape(boresight_sentence(result.angles))
            title = escape(gettext("Rotation matrix, LiDAR to body (forward, left, up):"))
            self.rotation.setText(f"{sentence}<br>{title}<table>{rows}</table>")

    def _fill_texts(self, project: Project, result: AdjustmentResult, state: ProjectState) -> None:
        further = list(project_warnings(project))
        if state.is_checking:  # the checks may confirm the signs
            further = [each for each in further if each.code not in ASSUMED_SIGN_CODES]
        if state.refused_since:
            further.insert(0, outdated_result_warning(state.refused_since))
        warnings = result_warnings(result, project.cross_checks, further)
        self.warnings.setText("<br><br>".join(escape(message_text(each)) for each in warnings))
        is_note = all(each.level is Level.NOTE for each in warnings)
        self.warnings.setProperty("role", "hint" if is_note else "warning")
        self.warnings.style().unpolish(self.warnings)
        self.warnings.style().polish(self.warnings)
        self.warnings.parentWidget().setVisible(bool(warnings))
        rows = result_texts.parameters_html(result)
        self.parameters.setText(rows)
        self.parameters.parentWidget().setVisible(bool(rows))
        observability = result.observability
        self.weakest.setText(
            gettext("Not computed.")
            if observability is None
            else message_text(observability.messages[0])
        )

    def _fit_form(self) -> QWidget:
        fit = QWidget()
        # A QFormLayout keeps the former height of a wrapped text after a change of the text.
        form = QGridLayout(fit)
        form.setContentsMargins(0, 0, 0, 0)
        form.setHorizontalSpacing(14)
        form.setVerticalSpacing(2)
        form.setColumnStretch(1, 1)
        self._values = {}
        tips = {
            "factor": gettext(
                "1: the residuals are as large as the standard deviations used predict; above 1 "
                "they are larger, below 1 smaller"
            ),
            "chi": gettext(
                "Compares the sum of the squared residuals with the interval that contains it in "
                "95 % of all surveys if the standard deviations used are correct"
            ),
            "surface": gettext(
                "Displacements and tilts of the surface of a target from line to line. Roughness "
                "and curvature that are the same on all lines are not part of it; they increase "
                "the noise of the target."
            ),
        }
        for key, title in (
            ("rms", gettext("RMS point-to-plane")),
            ("factor", gettext("Variance factor")),
            ("chi", gettext("Chi-square test")),
            ("points", gettext("Points, sightings")),
            ("model", gettext("POS correlation time")),
            ("surface", gettext("Form error of the targets")),
            ("sigmas", gettext("Standard deviations used")),
            ("iterations", gettext("Iterations, time")),
        ):
            value = widgets.label(name=f"result_{key}", wrap=True, rich=True)
            value.setFont(theme.tabular_font(value.font()))
            value.setMinimumWidth(_MIN_VALUE_WIDTH_PX)
            value.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
            self._values[key] = value
            label = widgets.label(title, "muted")
            label.setAlignment(Qt.AlignmentFlag.AlignTop)
            for each in (label, value):
                each.setToolTip(widgets.plain_tip(tips.get(key, "")))
            row = form.rowCount()
            form.addWidget(label, row, 0)
            form.addWidget(value, row, 1)
            if key == "chi":
                form.addWidget(widgets.label(gettext("Cross-checks"), "muted"), row + 1, 0)
                form.addWidget(self._checks_link(), row + 1, 1)
        return fit

    def _checks_link(self) -> QWidget:
        """Button that looks like a link; a label with a link would keep the keyboard focus."""
        self.checks = widgets.button(
            "", "result_checks",
            tip=gettext("Result without each line and each target, and of each half of the lines"),
        )  # fmt: skip
        self.checks.setStyleSheet(
            "QPushButton { border: none; padding: 0px; text-align: left; background: transparent;"
            f" text-decoration: underline; color: {theme.colour('accent').name()}; }}"
            "QPushButton:focus { border: 1px solid; }"
        )
        self.checks.clicked.connect(lambda _on: self.cross_checks_requested.emit())
        return self.checks

    def _fill_fit(self, project: Project, result: AdjustmentResult) -> None:
        before = local_number(result.rms_before, MILLIMETRES)
        after = fact_text(Fact("", result.rms_after, MILLIMETRES))
        texts = {
            "rms": f"{before} → <b>{after}</b>",
            "factor": VARIANCE_FACTOR_FORMAT.text(result.variance_factor),
            "chi": result_texts.chi_square_text(result),
            "points": result_texts.observation_counts(result),
            "model": _correlation_times(result.model),
            "surface": result_texts.form_error_text(result),
            "sigmas": result_texts.sigmas_html(project),
            "iterations": gettext(
                "converged after {iterations:n}, {time:s.2} s",
                iterations=result.iterations,
                time=result.elapsed,
            ),
        }
        for key, text in texts.items():
            # Qt breaks lines at a narrow space, as between the thousands of a French number
            self._values[key].setText(text.replace("\u202f", "\u00a0"))
        self._cross_checks = project.cross_checks
        self._show_checks()
        verdict = result_texts.fit_verdict(result, project.cross_checks, project_warnings(project))
        components = join_items(result_texts.variance_component_texts(project, result))
        if components:
            found = gettext("Estimated variance components: {components}.", components=components)
            verdict = f"{verdict} {found}"
        self._verdict.setText(verdict)
        self._offer_noise(project, result.lidar_noise_ratio)

    def _offer_noise(self, project: Project, ratio: float | None) -> None:
        """Offer the LiDAR noise found in the residuals instead of the given one."""
        self.use_noise.setVisible(ratio is not None)
        if ratio is None:
            return
        given = project.settings
        self._settings = found = given.with_lidar_noise_scaled(ratio)
        if given.lidar_sigma_xyz is None and given.lidar_beam_sigma is None:
            one, other = (
                fact_text(Fact("", each.used_lidar_sigma, LIDAR_NOISE)) for each in (found, given)
            )
            text = gettext("Use LiDAR noise {found} instead of {given}", found=one, given=other)
        else:
            text = gettext("Multiply the LiDAR noise by {ratio:x.2}", ratio=ratio)
        self.use_noise.setText(text)


def _block(*parts: QWidget) -> QWidget:
    block = QWidget()
    layout = widgets.vertical_layout(block, 0)
    layout.setSpacing(4)
    for part in parts:
        layout.addWidget(part)
    return block


def _matrix_cell(value: float) -> str:
    return f"<td align=right>{ROTATION_ENTRY.text(value)}&nbsp;&nbsp;</td>"


def _correlation_times(model: StochasticModel) -> str:
    if not model.correlated:
        return gettext("uncorrelated (classical)")
    return gettext(
        "position {position:s} s, attitude {attitude:s} s",
        position=model.position_time, attitude=model.attitude_time,
    )  # fmt: skip


def _create_table(name: str, title: str, rows: int, unit: str = "") -> QTableWidget:
    """Table with a column for each angle; the unit of its values, if any, is in the headers."""
    table = QTableWidget(rows, len(ANGLES))
    table.setItemDelegate(MarkedCells(table))
    table.setTabKeyNavigation(False)
    table.setObjectName(name)
    table.setAccessibleName(title)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setSelectionMode(QAbstractItemView.SelectionMode.ContiguousSelection)
    table.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    table.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
    heads = [gettext(angle) for angle in ANGLE_TITLES]
    table.setHorizontalHeaderLabels([f"{head} ({unit})" if unit else head for head in heads])
    for column in range(len(ANGLES)):
        table.horizontalHeaderItem(column).setTextAlignment(_ALIGN_RIGHT)
    side = table.verticalHeader()
    side.setDefaultSectionSize(_ROW_HEIGHT_PX)
    side.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
    side.setMinimumWidth(96)
    side.setStyleSheet("QHeaderView::section { padding: 0px 6px; }")  # else descenders are cut off
    side.setHighlightSections(False)
    header = table.horizontalHeader()
    header.setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
    header.setHighlightSections(False)
    header.setFixedHeight(_ROW_HEIGHT_PX + 2)
    # As beside the rows; the padding of the theme leaves no space for descenders.
    header.setStyleSheet("QHeaderView::section { padding: 0px 6px; }")
    return table


def _show_signs(table: QTableWidget) -> None:
    """Show the directions of positive angles in a second line of the headers."""
    for column, text in enumerate(SHORT_ANGLE_SIGNS):
        head = table.horizontalHeaderItem(column)
        head.setText(f"{head.text()}\n{gettext(text)}")
        head.setToolTip(widgets.plain_tip(gettext(SIGNS_TEXT)))
    header = table.horizontalHeader()
    header.setFixedHeight(_SIGNS_HEIGHT_PX)
    # The padding is that of the values; bold texts would be cut off
    header.setStyleSheet("QHeaderView::section { padding: 0px 4px; font-weight: normal; }")


def _set_row_titles(table: QTableWidget, titles: Sequence[str]) -> None:
    table.setRowCount(len(titles))
    table.setVerticalHeaderLabels(list(titles))
    table.setFixedHeight(table.horizontalHeader().height() + _ROW_HEIGHT_PX * len(titles) + 3)


def _fill_angles(table: QTableWidget, result: AdjustmentResult, truth: Triple | None) -> None:
    values = adjustment_values(result)
    true = None if truth is None else angles(truth)
    shown = angle_values(values.prior_boresight_deg, values, true)
    columns = window_boresight_table(simulated=true is not None).columns
    _set_row_titles(table, [title_text(column.title) for column in columns])
    for row, column in enumerate(columns):
        texts = [local_cell_text(column, each) for each in shown]
        _write_row(table, row, texts, bold=column is ESTIMATED_COLUMN)
        table.verticalHeaderItem(row).setToolTip(title_text(column.tip))
    for column, each in enumerate(shown):
        if each.error_deg is not None and each.interval95_deg is not None:
            _mark_true_value(table.item(len(columns) - 1, column), each.error_deg,
                             is_inside=abs(each.error_deg) <= each.interval95_deg)  # fmt: skip


def _mark_true_value(item: QTableWidgetItem, error_deg: float, *, is_inside: bool) -> None:
    item.setForeground(QBrush(QColor(theme.DONE if is_inside else theme.WARNING)))
    item.setToolTip(
        gettext(
            N_("Estimated minus true angle: {difference}, inside the 95 % interval")
            if is_inside
            else N_("Estimated minus true angle: {difference}, outside the 95 % interval"),
            difference=fact_text(Fact("", error_deg, ERROR_FORMAT)),
        )
    )


def _fill_correlation(table: QTableWidget, result: AdjustmentResult) -> None:
    _, *columns = CORRELATIONS_TABLE.columns
    rows = correlation_rows(result.correlation)
    _set_row_titles(table, [each.name for each in rows])
    for row, each in enumerate(rows):
        _write_row(table, row, [cell_text(column, each) for column in columns])
        for column in range(3):
            item = table.item(row, column)
            value = float(result.correlation[row, column])
            item.setBackground(QBrush(_correlation_colour(value)))
            if row != column and abs(value) > HIGH_CORRELATION:
                item.setToolTip(
                    gettext(
                        "These two angles are highly correlated. Add a target with another "
                        "orientation to separate them."
                    )
                )


def _write_row(table: QTableWidget, row: int, texts: Sequence[str], *, bold: bool = False) -> None:
    for column, text in enumerate(texts):
        item = QTableWidgetItem(text)
        item.setTextAlignment(_ALIGN_RIGHT)
        item.setFont(theme.tabular_font(table.font(), bold=bold))
        table.setItem(row, column, item)


def _correlation_colour(value: float) -> QColor:
    """Background colour of a correlation: paper colour at 0, full colour of its sign at ±1."""
    full = QColor(theme.POSITIVE if value >= 0 else theme.NEGATIVE)
    share = min(abs(value), 1.0)
    ends = zip(QColor(theme.PAPER).getRgb()[:3], full.getRgb()[:3], strict=True)
    return QColor(*(round(none + share * (all_of - none)) for none, all_of in ends))
