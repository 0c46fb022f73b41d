"""Predicted precision of the plan: computed in the background, and its panel."""

from dataclasses import dataclass
from html import escape

from PySide6.QtCore import QObject, Qt, QTimer, Signal
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QFrame, QGridLayout, QLabel, QScrollArea, QSizePolicy, QWidget

from lispac.adjustment.result import ANGLES
from lispac.design.objective import PlanObjective
from lispac.design.plan import Plan
from lispac.design.plan_choices import have_targets_one_orientation
from lispac.design.plan_search import InformationGain, information_gains
from lispac.design.prediction import predict
from lispac.gui import widgets
from lispac.gui.app.tasks import Task, TaskRunner
from lispac.gui.appearance import theme, units
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.design import edits
from lispac.gui.features.design.workspace import Workspace
from lispac.gui.widgets.diagnostics_table import DiagnosticsTable
from lispac.gui.widgets.result_tables import html_table, local_number, window_columns, window_rows
from lispac.io.config.plan_file import TitledPlan
from lispac.language import N_, Plural, gettext, join_items
from lispac.messages import Message, note
from lispac.present.planning import design_results
from lispac.present.planning.design_results import NOTHING_PREDICTED, PredictionValues
from lispac.present.tables import DEGREES, cell_text, title_text
from lispac.present.text_format import UNKNOWN_TEXT
from lispac.progress import Progress, no_progress
from lispac.workflow.planning.plan_checks import observability_messages, plan_warnings

DEBOUNCE_MS = 250
"""Delay after an edit before the slow results are computed."""
OUT_OF_DATE_MS = 400
"""Delay after which the values of an earlier plan are marked as out of date."""


@dataclass(frozen=True, eq=False)
class PredictedPrecision:
    """Predicted precision, which is also shown while a line is dragged.

    Attributes
    ----------
    refused : whether the adjustment would refuse such a survey
    """

    plan: Plan
    prediction: PredictionValues
    refused: bool

    @classmethod
    def of(cls, plan: Plan) -> "PredictedPrecision":
        """Predict the precision of a plan."""
        if not plan.targets or not plan.lines:
            return cls(plan, NOTHING_PREDICTED, True)
        found = PredictionValues.of(predict(plan))
        return cls(plan, found, not found.determined or have_targets_one_orientation(plan))

    @property
    def sigmas(self) -> tuple[str, ...]:
        """Standard deviations of roll, pitch and yaw as texts, in the unit of the user."""
        sigma = self.prediction.sigma_deg
        if sigma is None:
            return (UNKNOWN_TEXT,) * 3
        return tuple(local_number(value, DEGREES) for value in sigma)


@dataclass(frozen=True, eq=False)
class SlowResults:
    """Results that take longer to compute than the standard deviations.

    Attributes
    ----------
    messages : tuple of Message
        Observability of the angles.
    thesis : PredictedPrecision
        Plan of the thesis on this wall, with this system.
    """

    messages: tuple[Message, ...]
    thesis: PredictedPrecision


class BackgroundPrediction(QObject):
    """Predicts the precision of the plan in a separate worker.

    When the worker is free, it predicts the plan that is shown then and skips earlier plans.

    Attributes
    ----------
    messages_current : whether the messages shown are those of the plan
    """

    predicted = Signal(object)
    """`PredictedPrecision` of a plan; during a drag, it may belong to a slightly earlier plan."""
    slow_results_ready = Signal(object)
    gains_ready = Signal(object)
    """Information gain of each target and line; the last result to be computed."""
    out_of_date = Signal()
    """Some of the values shown are still those of an earlier plan."""
    failed = Signal(object)

    def __init__(self, workspace: Workspace, parent: QObject) -> None:
        super().__init__(parent)
        self._work = workspace
        self._titled = workspace.titled
        self._runner = TaskRunner(self)
        self._runner.failed.connect(self._report_failure)
        self._predicting = self.messages_current = False
        self._slow: Task | None = None
        self._debounce = QTimer(self, singleShot=True, interval=DEBOUNCE_MS)
        self._debounce.timeout.connect(self._check_plan)
        self._late_timer = QTimer(self, singleShot=True, interval=OUT_OF_DATE_MS)
        self._late_timer.timeout.connect(self.out_of_date)
        workspace.changed.connect(self._on_plan_changed)

    @property
    def is_out_of_date(self) -> bool:
        """Whether the standard deviations shown are those of an earlier plan."""
        return self._predicting

    @property
    def active(self) -> bool:
        """Whether a prediction is running or waiting."""
        return self._runner.active or self._debounce.isActive()

    def start(self) -> None:
        """Predict now and after each change of the plan."""
        self._start_prediction()

    def stop(self) -> None:
        """Stop all predictions."""
        self._debounce.stop()
        self._late_timer.stop()
        self._runner.close()

    def _on_plan_changed(self) -> None:
        if self._work.titled.plan is not self._titled.plan:
            self._start_prediction()

    def _start_prediction(self) -> None:
        self._titled, self.messages_current = self._work.titled, False
        if self._slow is not None:
            self._slow.cancel.set()
        self._debounce.start()
        self._late_timer.start()
        if not self._predicting:
            self._predict_sigmas()

    def _predict_sigmas(self) -> None:
        self._predicting = True
        plan = self._titled.plan
        self._runner.run(
            gettext("Predicting the precision"),
            lambda _progress: PredictedPrecision.of(plan),
            self._emit_prediction,
            quiet=True,
        )

    def _emit_prediction(self, prediction: PredictedPrecision) -> None:
        self._predicting = False
        if prediction.plan is not self._titled.plan:
            self._predict_sigmas()
        self.predicted.emit(prediction)

    def _check_plan(self) -> None:
        if self._predicting:
            self._debounce.start()
            return
        titled = self._titled

        def work(progress: Progress) -> SlowResults:
            thesis = PredictedPrecision.of(edits.thesis_plan_at_wall(titled))
            return SlowResults(_plan_messages(titled.plan, progress), thesis)

        def done(results: SlowResults) -> None:
            self.messages_current = True
            self.slow_results_ready.emit(results)
            self._compute_information_gain()

        self._slow = self._runner.run(gettext("Checking the survey plan"), work, done, quiet=True)

    def _compute_information_gain(self) -> None:
        plan = self._titled.plan

        def done(results: object) -> None:
            self._late_timer.stop()
            self.gains_ready.emit(results)

        self._slow = self._runner.run(
            gettext("Computing the information gain"),
            lambda progress: _information_gains(plan, progress),
            done,
            quiet=True,
        )

    def _report_failure(self, error: BaseException) -> None:
        self._predicting = False
        self._late_timer.stop()
        self.failed.emit(error)


REFERENCE_PLAN_TIP = N_(
    "Plan with the targets and lines of Shahraji's thesis, on which the method is based"
)
PLAN_KEYS = ("plan", "thesis")
ANGLE_NAMES = dict(zip(ANGLES, (N_("roll"), N_("pitch"), N_("yaw")), strict=True))


class PredictionPanel(QScrollArea):
    """Standard deviations beside those of the reference plan, correlations and information gain."""

    def __init__(self, workspace: Workspace) -> None:
        super().__init__()
        self.setObjectName("design_results")
        self.setWidgetResizable(True)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setMinimumWidth(330)
        self._work = workspace
        self.predictor = BackgroundPrediction(workspace, self)
        self._last = PredictedPrecision(workspace.titled.plan, NOTHING_PREDICTED, True)
        body = QWidget()
        layout = widgets.vertical_layout(body, 12)
        unit = units.shown_unit("°").sign
        layout.addWidget(
            widgets.label(gettext("Predicted standard deviations ({unit})", unit=unit), "heading")
        )
        layout.addLayout(self._sigma_grid(unit))
        self.correlation = widgets.label("", "muted", wrap=True, name="design_correlation")
        self.correlation.setToolTip(
            gettext(
                "Correlations between the angles. Two angles cannot be separated if their "
                "correlation is close to 1 or −1."
            )
        )
        layout.addWidget(self.correlation)
        self.minutes = widgets.label("", "muted", wrap=True, name="design_minutes")
        layout.addWidget(self.minutes)
        self.warnings = widgets.label("", "warning", wrap=True, name="design_warnings")
        layout.addWidget(self.warnings)
        self.messages = widgets.label("", "hint", wrap=True, name="design_text")
        self.messages.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Minimum)
        layout.addWidget(self.messages)
        layout.addWidget(widgets.label(gettext("Points per sighting"), "heading"))
        self.points = widgets.label("", name="design_points", rich=True)
        self.points.setAccessibleName(gettext("Points per sighting"))
        self._points_area = QScrollArea()
        self._points_area.setFrameShape(QFrame.Shape.NoFrame)
        self._points_area.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self._points_area.setWidgetResizable(True)
        self._points_area.setWidget(self.points)
        layout.addWidget(self._points_area)
        layout.addWidget(widgets.label(gettext("Information gain"), "heading"))
        self.gain_table = DiagnosticsTable(
            "design_gain",
            title_text(design_results.WINDOW_GAINS_TABLE.title),
            window_columns(design_results.WINDOW_GAINS_TABLE),
        )
        self.gain_table.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.gain_table.setMinimumHeight(170)
        layout.addWidget(self.gain_table)
        layout.addStretch(1)
        self.setWidget(body)
        self.predictor.predicted.connect(self._show_sigmas)
        self.predictor.slow_results_ready.connect(self._show_messages)
        self.predictor.gains_ready.connect(self._show_information_gains)
        self.predictor.out_of_date.connect(self._mark_out_of_date)
        workspace.changed.connect(self._show)
        self._show()
        self.predictor.start()

    def _sigma_grid(self, unit: str) -> QGridLayout:
        """Labels of the standard deviations, of this plan and of the reference plan."""
        grid = QGridLayout()
        grid.setHorizontalSpacing(14)
        grid.setVerticalSpacing(4)
        for column, title in enumerate(map(gettext, design_results.PLAN_TITLES), start=1):
            head = widgets.label(title, "muted")
            if column == 2:
                head.setToolTip(gettext(REFERENCE_PLAN_TIP))
            grid.addWidget(head, 0, column, Qt.AlignmentFlag.AlignRight)
        self.sigma: dict[str, QLabel] = {}
        self.thesis: dict[str, QLabel] = {}
        for row, angle in enumerate(ANGLES, start=1):
            named = gettext(ANGLE_NAMES[angle])
            grid.addWidget(widgets.label(named), row, 0)
            for column, (labels, size) in enumerate(((self.sigma, 20), (self.thesis, 14)), start=1):
                shown = widgets.label("", name=f"design_{PLAN_KEYS[column - 1]}_{angle}")
                font = theme.tabular_font(shown.font(), bold=column == 1)
                font.setPixelSize(size)
                shown.setFont(font)
                # Keeps the width constant when the first numbers are shown.
                shown.setMinimumWidth(QFontMetrics(font).horizontalAdvance("0.0000") + 4)
                shown.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                shown.setAccessibleName(
                    gettext(
                        "Standard deviation of {angle} ({plan}), in {unit}",
                        angle=named, unit=unit,
                        plan=gettext(design_results.PLAN_TITLES[column - 1]),
                    )
                )  # fmt: skip
                grid.addWidget(shown, row, column, Qt.AlignmentFlag.AlignRight)
                labels[angle] = shown
        grid.setColumnStretch(3, 1)
        return grid

    def _show(self) -> None:
        """Show the values that need no computation."""
        titled = self._work.titled
        self.minutes.setText(_time_on_site_text(titled))
        found = plan_warnings(titled)
        self.warnings.setText("\n".join(map(message_text, found)))
        self.warnings.setVisible(bool(found))

    def _mark_out_of_date(self) -> None:
        """Mark the values of the former plan as out of date."""
        if self.predictor.is_out_of_date:
            for label in self.sigma.values():
                label.setStyleSheet(f"color: {theme.MUTED};")
        if not self.predictor.messages_current:
            self.messages.setText(gettext("Computing…"))
        self.gain_table.show_rows([])

    def _show_sigmas(self, prediction: PredictedPrecision) -> None:
        """Show standard deviations and correlations, also during a drag."""
        self._last = prediction
        for angle, sigma in zip(ANGLES, self._last.sigmas, strict=True):
            self.sigma[angle].setText(sigma)
            self.sigma[angle].setStyleSheet(f"color: {theme.ERROR};" if self._last.refused else "")
        pairs = [
            f"{title_text(column.title)} {cell_text(column, self._last.prediction)}"
            for column in design_results.PREDICTED_CORRELATIONS_TABLE.columns
        ]
        self.correlation.setText(gettext("Correlations: {pairs}", pairs=join_items(pairs)))
        self._show_point_counts()

    def _show_point_counts(self) -> None:
        table, rows = design_results.points_table(self._last.plan, self._last.prediction)
        heads = ["", *(escape(title_text(column.title)) for column in table.columns[1:])]
        cells = [[escape(cell_text(column, row)) for column in table.columns] for row in rows]
        self.points.setText(html_table(heads, cells))
        size = self.points.sizeHint()
        bar = self._points_area.horizontalScrollBar().sizeHint().height()
        self._points_area.setFixedHeight(size.height() + bar)

    def _show_messages(self, results: SlowResults) -> None:
        refused = self._last.refused
        self.messages.setProperty("role", "warning" if refused else "hint")
        self.messages.style().unpolish(self.messages)
        self.messages.style().polish(self.messages)
        self.messages.setText("\n".join(map(message_text, results.messages)))
        for angle, sigma in zip(ANGLES, results.thesis.sigmas, strict=True):
            self.thesis[angle].setText(sigma)

    def _show_information_gains(self, gains: tuple[InformationGain, ...]) -> None:
        rows = design_results.gain_rows(gains, self._last.prediction.sigma_deg)
        table = self.gain_table
        table.show_rows(window_rows(design_results.WINDOW_GAINS_TABLE, rows))
        # The panel scrolls; a second scroll bar in it would be in the way
        heads = table.horizontalHeader().sizeHint().height()
        table.setFixedHeight(heads + table.verticalHeader().length() + 2 * table.frameWidth())

    def stop(self) -> None:
        """Stop all computations."""
        self.predictor.stop()


def _plan_messages(plan: Plan, progress: Progress = no_progress) -> tuple[Message, ...]:
    """Messages on the observability of the angles, as after an adjustment."""
    if not plan.targets or not plan.lines:
        return (note("plan.empty"),)
    return observability_messages(plan, progress=progress)


def _time_on_site_text(titled: TitledPlan) -> str:
    """Text of the time on site."""
    plan = titled.plan
    return gettext(
        Plural(
            "Time on site: {minutes:n} min for {count:n} line, turns included",
            "Time on site: {minutes:n} min for {count:n} lines, turns included",
        ),
        minutes=round(plan.duration / 60) if plan.lines else 0,
        count=len(plan.lines),
    )


def _information_gains(plan: Plan, progress: Progress = no_progress) -> tuple[InformationGain, ...]:
    """Information gain of each target and line; empty if the plan lacks targets or lines."""
    return (
        information_gains(plan, PlanObjective(), progress=progress)
        if plan.targets and plan.lines
        else ()
    )
