"""Prediction in the background: standard deviations at once, the rest after a pause."""

from dataclasses import dataclass

from PySide6.QtCore import QObject, QTimer, Signal

from lispac.gui.app.tasks import Task, TaskRunner
from lispac.gui.features.design import edits, predicted_precision
from lispac.gui.features.design.predicted_precision import PredictedPrecision
from lispac.gui.features.design.workspace import Workspace
from lispac.language import gettext
from lispac.messages import Message
from lispac.progress import Progress

DEBOUNCE_MS = 250
"""Pause after an edit before the slow results are computed."""
OUT_OF_DATE_MS = 400
"""Delay after which the values of an earlier plan are marked as out of date."""


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
    """Predicts the precision of the plan in a worker of its own.

    When the worker is free, the plan shown then is predicted next; earlier ones are skipped.

    Attributes
    ----------
    messages_current : whether the messages shown are those of the plan
    """

    predicted = Signal(object)
    """The `PredictedPrecision` of a plan, which in a drag may be one of a moment ago."""
    slow_results_ready = Signal(object)
    gains_ready = Signal(object)
    """Information gain of each target and line; everything has been computed."""
    out_of_date = Signal()
    """Whether the prediction shown is that of an earlier plan."""
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
            return SlowResults(predicted_precision.plan_messages(titled.plan, progress), thesis)

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
            lambda progress: predicted_precision.plan_information_gains(plan, progress),
            done,
            quiet=True,
        )

    def _report_failure(self, error: BaseException) -> None:
        self._predicting = False
        self._late_timer.stop()
        self.failed.emit(error)
