"""Prediction in the background: standard deviations at once, the rest after a pause."""

from dataclasses import dataclass

from PySide6.QtCore import QObject, QTimer, Signal

from lispac.gui.design import edits, predicted_precision
from lispac.gui.design.predicted_precision import PredictedPrecision
from lispac.gui.design.workspace import Workspace
from lispac.gui.tasks import Task, TaskRunner
from lispac.language import gettext
from lispac.messages import Message
from lispac.progress import Progress

PAUSE_MS = 250
"""Stillness after which what takes longer is computed."""
LATE_MS = 400
"""Numbers of an earlier plan that stand for longer than this are shown as such."""


@dataclass(frozen=True, eq=False)
class SlowResults:
    """Results that take longer to compute than the standard deviations.

    Attributes
    ----------
    remarks : tuple of Message
        Observability of the angles.
    thesis : PredictedPrecision
        Plan of the thesis on this wall, with this system.
    """

    remarks: tuple[Message, ...]
    thesis: PredictedPrecision


class BackgroundPrediction(QObject):
    """Predicts the precision of the plan in a worker of its own.

    When the worker is free, the plan shown then is predicted next; earlier ones are skipped.

    Attributes
    ----------
    has_said : whether the remarks shown are the plan's
    """

    predicted = Signal(object)
    """The `PredictedPrecision` of a plan, which in a drag may be one of a moment ago."""
    slow_results_ready = Signal(object)
    weighed = Signal(object)
    """Information gain of each target and line; everything has been computed."""
    late = Signal()
    """What is shown is that of an earlier plan."""
    failed = Signal(object)

    def __init__(self, workspace: Workspace, parent: QObject) -> None:
        super().__init__(parent)
        self._work = workspace
        self._titled = workspace.titled
        self._runner = TaskRunner(self)
        self._runner.failed.connect(self._report_failure)
        self._foretelling = self.has_said = False
        self._slow: Task | None = None
        self._pause = QTimer(self, singleShot=True, interval=PAUSE_MS)
        self._pause.timeout.connect(self._check_plan)
        self._late = QTimer(self, singleShot=True, interval=LATE_MS)
        self._late.timeout.connect(self.late)
        workspace.changed.connect(self._on_plan_changed)

    @property
    def is_out_of_date(self) -> bool:
        """Whether the standard deviations shown are those of an earlier plan."""
        return self._foretelling

    @property
    def active(self) -> bool:
        """Whether a prediction is running or waiting."""
        return self._runner.active or self._pause.isActive()

    def start(self) -> None:
        """Predict now and after each change of the plan."""
        self._start_prediction()

    def stop(self) -> None:
        """Stop all predictions."""
        self._pause.stop()
        self._late.stop()
        self._runner.close()

    def _on_plan_changed(self) -> None:
        if self._work.titled.plan is not self._titled.plan:
            self._start_prediction()

    def _start_prediction(self) -> None:
        self._titled, self.has_said = self._work.titled, False
        if self._slow is not None:
            self._slow.cancel.set()
        self._pause.start()
        self._late.start()
        if not self._foretelling:
            self._predict_sigmas()

    def _predict_sigmas(self) -> None:
        self._foretelling = True
        plan = self._titled.plan
        self._runner.run(
            gettext("Predicting the precision"),
            lambda _progress: PredictedPrecision.of(plan),
            self._emit_prediction,
            quiet=True,
        )

    def _emit_prediction(self, prediction: PredictedPrecision) -> None:
        self._foretelling = False
        if prediction.plan is not self._titled.plan:
            self._predict_sigmas()
        self.predicted.emit(prediction)

    def _check_plan(self) -> None:
        if self._foretelling:
            self._pause.start()
            return
        titled = self._titled

        def work(progress: Progress) -> SlowResults:
            thesis = PredictedPrecision.of(edits.thesis_plan_at_wall(titled))
            return SlowResults(predicted_precision.plan_messages(titled.plan, progress), thesis)

        def done(results: SlowResults) -> None:
            self.has_said = True
            self.slow_results_ready.emit(results)
            self._compute_information_gain()

        self._slow = self._runner.run(gettext("Checking the survey plan"), work, done, quiet=True)

    def _compute_information_gain(self) -> None:
        plan = self._titled.plan

        def done(results: object) -> None:
            self._late.stop()
            self.weighed.emit(results)

        self._slow = self._runner.run(
            gettext("Computing the information gain"),
            lambda progress: predicted_precision.plan_information_gains(plan, progress),
            done,
            quiet=True,
        )

    def _report_failure(self, error: BaseException) -> None:
        self._foretelling = False
        self._late.stop()
        self.failed.emit(error)
