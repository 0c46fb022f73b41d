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
    """Results that take longer than the standard deviations.

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
    """Has a worker of its own: sigmas follow while a search runs.

    When the worker is free, the plan shown then is predicted next; earlier ones are skipped.

    Attributes
    ----------
    has_said : whether the remarks shown are the plan's
    """

    foretold = Signal(object)
    """The `PredictedPrecision` of a plan, which in a drag may be one of a moment ago."""
    said = Signal(object)
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
        self._runner.failed.connect(self._fail)
        self._foretelling = self.has_said = False
        self._slow: Task | None = None
        self._pause = QTimer(self, singleShot=True, interval=PAUSE_MS)
        self._pause.timeout.connect(self._say)
        self._late = QTimer(self, singleShot=True, interval=LATE_MS)
        self._late.timeout.connect(self.late)
        workspace.changed.connect(self._follow)

    @property
    def behind(self) -> bool:
        """Whether the sigmas shown are not yet the plan's."""
        return self._foretelling

    @property
    def active(self) -> bool:
        """Whether anything is still to be computed."""
        return self._runner.active or self._pause.isActive()

    def start(self) -> None:
        """Follow from now on."""
        self._begin()

    def stop(self) -> None:
        """Stop all computations."""
        self._pause.stop()
        self._late.stop()
        self._runner.close()

    def _follow(self) -> None:
        if self._work.titled.plan is not self._titled.plan:
            self._begin()

    def _begin(self) -> None:
        self._titled, self.has_said = self._work.titled, False
        if self._slow is not None:
            self._slow.cancel.set()
        self._pause.start()
        self._late.start()
        if not self._foretelling:
            self._foretell()

    def _foretell(self) -> None:
        self._foretelling = True
        plan = self._titled.plan
        self._runner.run(
            gettext("Predicting the precision"),
            lambda _progress: PredictedPrecision.of(plan),
            self._tell,
            quiet=True,
        )

    def _tell(self, found: PredictedPrecision) -> None:
        self._foretelling = False
        if found.plan is not self._titled.plan:
            self._foretell()
        self.foretold.emit(found)

    def _say(self) -> None:
        if self._foretelling:
            self._pause.start()
            return
        titled = self._titled

        def work(progress: Progress) -> SlowResults:
            thesis = PredictedPrecision.of(edits.thesis_beside(titled))
            return SlowResults(predicted_precision.remarks(titled.plan, progress), thesis)

        def done(found: SlowResults) -> None:
            self.has_said = True
            self.said.emit(found)
            self._weigh()

        self._slow = self._runner.run(gettext("Checking the survey plan"), work, done, quiet=True)

    def _weigh(self) -> None:
        plan = self._titled.plan

        def done(found: object) -> None:
            self._late.stop()
            self.weighed.emit(found)

        self._slow = self._runner.run(
            gettext("Computing the information gain"),
            lambda progress: predicted_precision.worths(plan, progress),
            done,
            quiet=True,
        )

    def _fail(self, error: BaseException) -> None:
        self._foretelling = False
        self._late.stop()
        self.failed.emit(error)
