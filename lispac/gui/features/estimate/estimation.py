"""Adjustment of the boresight: on request, and automatically after a sighting is excluded."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from time import perf_counter

from PySide6.QtCore import QObject, QTimer, Signal

from lispac.errors import Cancelled, LispacError
from lispac.gui.app.questions import Questions
from lispac.gui.app.tasks import Task, TaskRunner, preload_matplotlib
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.project.controller import ESTIMATE_KEY, Controller
from lispac.gui.project.document import Document, data_key
from lispac.gui.project.scene import Scene
from lispac.gui.widgets.result_tables import local_amount
from lispac.language import N_, Plural, gettext, gettext_lazy
from lispac.messages import Message, error
from lispac.present.tables import MILLIMETRES
from lispac.progress import Progress, sub_progress
from lispac.project import Project, Settings
from lispac.survey.cloud import Cloud
from lispac.workflow.project.survey import Survey

DEBOUNCE_MS = 250
"""Delay of an automatic adjustment, so that several clicks in a row cause only one."""

ESTIMATED_TEXT = Plural(
    "Boresight estimated from {count:n} point in {elapsed:s.2} s; RMS {before} → {after}",
    "Boresight estimated from {count:n} points in {elapsed:s.2} s; RMS {before} → {after}",
)
ESTIMATED_AGAIN_TEXT = Plural(
    "Boresight estimated again from {count:n} point in {elapsed:s.2} s; RMS {before} → {after}",
    "Boresight estimated again from {count:n} points in {elapsed:s.2} s; RMS {before} → {after}",
)


@dataclass(frozen=True, eq=False)
class _PointSelection:
    """Points of the targets, selected again with an estimated boresight.

    Attributes
    ----------
    source : project whose picked points were selected
    selected : the same project with the selected points
    """

    source: Project
    survey: Survey
    selected: Project

    def covers_sightings(self, project: Project, survey: Survey) -> bool:
        """Whether all sightings used in ``project`` are among the selected ones."""
        if survey is not self.survey or project.settings != self.source.settings:
            return False
        known = {
            (target.name, sighting.line): sighting.indices
            for target in self.source.targets_of_role("target")
            for sighting in target.used_sightings
        }
        return all(
            known.get((target.name, sighting.line)) is sighting.indices
            for target in project.targets_of_role("target")
            for sighting in target.used_sightings
        )


@dataclass(frozen=True, eq=False)
class _EstimationResult:
    """Result of an adjustment in the worker."""

    estimated: Project
    selection: _PointSelection
    clouds: Mapping[str, Cloud]
    replaced: Survey | None
    """Survey with points moved by another prior mounting; None if they did not move."""


class Estimation(QObject):
    """Runs the adjustment, and stores the selected points for quick repetitions."""

    estimated = Signal()
    """A requested adjustment has a result."""
    checking = Signal(bool)
    """Whether cross-checks of the last result are being computed."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        scene: Scene,
        controller: Controller,
        questions: Questions,
    ) -> None:
        super().__init__(controller)
        self._document, self._runner, self._questions = document, runner, questions
        self._scene, self._controller = scene, controller
        self._selection: _PointSelection | None = None
        self._automatic: tuple[Task, Project] | None = None
        self._cross_check = False
        self._checking: Task | None = None
        self._is_storing = False
        """Whether a result is being stored, so that its checks have to wait."""
        self._debounce = QTimer(self)
        self._debounce.setSingleShot(True)
        self._debounce.setInterval(DEBOUNCE_MS)
        self._debounce.timeout.connect(self._estimate_again)
        document.changed.connect(self._wait_for_result)
        document.opened.connect(self._on_project_opened)
        runner.idle.connect(self._wait_for_result)
        runner.failed.connect(self._record_refusal)
        self._last_task: Task | None = None
        self._requested: tuple[Project, bool] | None = None
        document.changed.connect(self._start_requested)
        runner.failed.connect(lambda _error: self._discard_request())
        runner.stopped.connect(lambda _title: self._discard_request())

    def request_estimate(self, settings: Settings, cross_check: bool) -> None:
        """Adjust the boresight; asks first about a candidate that is not yet accepted."""
        if self._controller.resolve_candidate(self._questions.ask_about_candidate):
            self.estimate(settings, cross_check)

    def estimate(self, settings: Settings, cross_check: bool) -> None:
        """Adjust the boresight with these settings and show the lines after the adjustment.

        The adjustment starts when the lines are georeferenced with the settings of the project.
        Cross-checks follow when the result is shown.
        """
        project, survey = self._document.current_data
        if project is None:
            return
        if survey is None:
            self._requested = (project, cross_check)
            return
        source = project if settings == project.settings else project.with_settings(settings)
        data_changed = data_key(source) != data_key(project)

        def work(progress: Progress) -> _EstimationResult:
            settings.require_sound()
            placed = survey.with_prior(source.mounting("prior")) if data_changed else survey
            found = _adjust(source, placed, None, progress)
            return replace(found, replaced=placed) if data_changed else found

        def done(found: _EstimationResult) -> None:
            if self._document.project is not project or found.estimated.result is None:
                return
            self._selection, self._cross_check = found.selection, cross_check
            self._scene.keep_estimated(found.estimated.result, found.clouds)
            # Checked when the runner is idle; set first, so that no verdict is shown before
            self._document.unchecked_result = found.estimated.result
            self._is_storing = True
            self._document.edit(N_("boresight estimate"), found.estimated, survey=found.replaced)
            self._is_storing = False
            # Stored again, since the scene releases its data when the survey is replaced.
            self._scene.keep_estimated(found.estimated.result, found.clouds)
            self._scene.show("estimated")
            self._note(found.estimated, ESTIMATED_TEXT)
            self.estimated.emit()

        task = self._runner.run(gettext("Estimating the boresight"), work, done, key=ESTIMATE_KEY)
        self._last_task = task
        self._controller.cancel_on_edit(task)

    def _start_requested(self) -> None:
        """Start an adjustment that was requested while the lines were georeferenced."""
        if self._requested is None:
            return
        project, cross_check = self._requested
        is_current = self._document.is_survey_current
        if is_current or self._document.project is not project:
            self._requested = None
        if is_current and self._document.project is project:
            self.estimate(project.settings, cross_check)

    def _discard_request(self) -> None:
        self._requested = None

    def stop(self) -> None:
        """Stop the timer."""
        self._debounce.stop()

    def _on_project_opened(self) -> None:
        project = self._document.project
        self._selection, self._document.unchecked_result = None, None
        self._cross_check = project is not None and project.cross_checks is not None

    def _record_refusal(self, error: BaseException) -> None:
        """Record why an estimate was refused, so that the reason stays visible."""
        task = self._last_task
        if task is not None and task.error is error and isinstance(error, LispacError):
            self._document.refuse_request(error.reason)

    # -- automatic adjustments ---------------------------------------------------------------

    def _wait_for_result(self) -> None:
        """Start the timer of an automatic adjustment, unless its result is being computed."""
        if not self._document.awaits_result:
            self._debounce.stop()
            self._automatic = None
            self._run_checks()
            return
        task, base = self._automatic or (None, None)
        if base is self._document.project and task is not None:
            if self._runner.active:
                return
            if task.cancel.is_set() and not task.superseded:
                self._document.refuse(error("window.adjustment_cancelled"))
                return
            if task.error is not None and not isinstance(task.error, Cancelled):
                self._document.refuse(error("window.adjustment_failed"))
                return
        self._debounce.start()

    def _estimate_again(self) -> None:
        project, survey = self._document.current_data
        if project is None or survey is None or not self._document.awaits_result:
            return
        if self._runner.busy:
            return  # the runner emits a signal when it is idle
        known = self._selection
        selection = known if known is not None and known.covers_sightings(project, survey) else None

        def work(progress: Progress) -> _EstimationResult | Message | str:
            try:
                return _adjust(project, survey, selection, progress)
            except LispacError as failure:
                return failure.reason

        def done(found: _EstimationResult | Message | str) -> None:
            if self._document.project is not project:
                return
            if not isinstance(found, _EstimationResult):
                self._document.refuse(found)
                text = message_text(found) if isinstance(found, Message) else found
                self._controller.logged.emit(text)
                return
            self._selection = found.selection
            self._scene.keep_estimated(found.estimated.result, found.clouds)
            self._document.unchecked_result = found.estimated.result
            self._document.complete_last_edit(found.estimated)
            self._note(found.estimated, ESTIMATED_AGAIN_TEXT)

        # A request of the user cancels a fast adjustment; a slow one is shown and can be cancelled.
        task = self._runner.run(
            gettext("Estimating the boresight again"),
            work,
            done,
            quiet=selection is not None,
            key="follow",
        )
        self._automatic = (task, project)
        self._last_task = task
        self._controller.cancel_on_edit(task)

    def _run_checks(self) -> None:
        """Compute advice and cross-checks of the last result when no other task runs.

        The advice takes half as long as the adjustment itself, the cross-checks ten times as long.
        """
        if self._runner.active or self._is_storing:
            return
        last, self._checking = self._checking, None
        if last is not None:
            self.checking.emit(False)
            if last.cancel.is_set() and not last.superseded:
                self._document.unchecked_result = None  # cancelled by the user
                self._document.changed.emit()
        (project, survey), selection = self._document.current_data, self._selection
        if project is None or survey is None:
            return
        if project.result is None or project.result is not self._document.unchecked_result:
            return
        if selection is None or not selection.covers_sightings(project, survey):
            self._document.unchecked_result = None  # it cannot be checked any more
            self._document.changed.emit()
            return

        cross_check = self._cross_check

        def work(progress: Progress) -> Project:
            from lispac.workflow.calibration.estimation import complete_result

            return complete_result(
                project, selection.selected, survey, cross_check=cross_check, progress=progress
            )

        def done(checked: Project) -> None:
            if self._document.project is project and checked.result is not None:
                self._document.unchecked_result = None
                self._scene.reassign_estimated(project.result, checked.result)
                self._document.complete_last_edit(checked)

        title = (
            gettext("Cross-checking the result")
            if cross_check
            else gettext("Searching for an additional line that improves the result")
        )
        self._checking = self._runner.run(title, work, done, quiet=True, key="follow")
        self.checking.emit(cross_check)

    def _note(self, project: Project, text: Plural) -> None:
        result = project.result
        assert result is not None
        self._controller.logged.emit(
            gettext(
                text,
                count=result.points,
                elapsed=result.elapsed,
                before=local_amount(result.rms_before, MILLIMETRES),
                after=local_amount(result.rms_after, MILLIMETRES),
            )
        )


def _adjust(
    project: Project,
    survey: Survey,
    selection: _PointSelection | None,
    progress: Progress,
) -> _EstimationResult:
    """Select points if necessary, adjust, and georeference the lines; runs in the worker.

    The result has neither advice nor cross-checks.
    """
    from lispac.workflow.calibration.estimation import adjust_selected, reselect_points

    preload_matplotlib()
    started = perf_counter()
    if selection is None:
        selected = reselect_points(project, survey, progress=sub_progress(progress, 0.0, 0.7))
        selection = _PointSelection(project, survey, selected)
    solved = adjust_selected(
        project, selection.selected, survey,
        cross_check=False, advise=False, progress=sub_progress(progress, 0.7, 0.95),
    )  # fmt: skip
    assert solved.result is not None
    elapsed = perf_counter() - started
    # Only the elapsed time of the result is replaced.
    estimated = replace(solved, result=replace(solved.result, elapsed=elapsed))
    progress(0.95, gettext_lazy("Georeferencing the lines with the estimated boresight"))
    clouds = survey.displayed_clouds(
        estimated, "estimated", progress=sub_progress(progress, 0.95, 1.0)
    )
    return _EstimationResult(estimated, selection, clouds, None)
