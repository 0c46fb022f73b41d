"""Refresh of the panels from the document, and availability of the actions."""

from collections.abc import Mapping

from PySide6.QtCore import QObject

from lispac.adjustment.diagnostics.cause_warnings import main_wrong_value
from lispac.duplicate_targets import all_warnings
from lispac.gui.app.actions import Actions
from lispac.gui.app.docks import DockLayout
from lispac.gui.app.settings import AppSettings
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.app.unavailable import Reason, Unavailable, first_reason, reason_text
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.inspect.actions import COLOUR_ACTIONS, VIEWS
from lispac.gui.features.validate.validation import VALIDATION_KEY
from lispac.gui.project.computations import Computations, PointCount
from lispac.gui.project.controller import ESTIMATE_KEY, GEOREFERENCING_KEY, Controller
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.project.status import (
    ADJUST,
    DATA,
    REPORT,
    TARGETS,
    VALIDATE,
    ProjectState,
    step_statuses,
    with_input_error,
)
from lispac.gui.widgets.idle_tasks import IdleTask
from lispac.gui.window.central_widget import CentralWidget
from lispac.gui.window.panels import Panels, filled_docks
from lispac.language import gettext
from lispac.messages import Message
from lispac.targets.sighting_quality import SightingQuality
from lispac.workflow.calibration.sighting_assessment import SightingKey

MIN_TARGET_COUNT = 2
"""Number of targets below which a project is opened at the step of the targets."""
TASK_STEPS = {ESTIMATE_KEY: ADJUST, VALIDATION_KEY: VALIDATE}
"""Step of the workflow by the key of its task."""
PROJECT_ACTIONS = (
    "acceptance_criteria", "before", "seed_target", "seed_validation", "hover", "change_role",
    "fit", "fit_selection", *VIEWS, "normal", "orthographic", "larger", "smaller",
    *COLOUR_ACTIONS.values(), "colour_next", "picture", "copy_picture", "section",
    "section_points", "section_forward", "section_backward", "section_picture", "copy_section",
    "measure_distance", "measure_angle", "clip",
)  # fmt: skip
"""Actions that need an open project and nothing else."""


class PanelRefresh(QObject):
    """Refreshes the panels and enables the actions after every change."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        controller: Controller,
        computations: Computations,
        scene: Scene,
        settings: AppSettings,
        actions: Actions,
        panels: Panels,
        central_widget: CentralWidget,
        dock_layout: DockLayout,
    ) -> None:
        super().__init__(actions)
        self._document, self._runner, self._controller = document, runner, controller
        self._computations, self._settings, self._actions = computations, settings, actions
        self._panels, self._central_widget = panels, central_widget
        self._dock_layout = dock_layout
        self._opening, self._is_new_project = False, True
        self._poor_sightings: tuple[str, ...] = ()
        document.changed.connect(self.refresh)
        document.changed.connect(self._count_points)
        panels.workflow.step_opened.connect(lambda _step: self.refresh())
        # Later, since a field may be marked while the panels are refreshed
        panels.workflow.input_checked.connect(IdleTask(self._show_task, self).start)
        document.modified.connect(lambda _modified: self._enable_save())
        document.opened.connect(self._open_step)
        runner.changed.connect(self._show_task)
        runner.progress_changed.connect(self._show_progress)
        controller.candidate_changed.connect(self._show_candidate)
        panels.targets.candidate.grown.connect(self._scroll_to_candidate)
        panels.targets.candidate.rated.connect(self._enable_candidate)
        computations.counted.connect(self._show_count)
        scene.which_changed.connect(self._show_before_after)

    def refresh(self) -> None:
        """Show the current document in all panels."""
        if self._opening:
            return
        state = self._project_state()
        self._central_widget.show_view(state.project is not None)
        if state.project is None:
            self._central_widget.start.show_recent(self._settings.recent())
            self._central_widget.start.show_task(self._task_title())
        self._panels.show_state(state)
        self._dock_layout.show_filled(filled_docks(state), is_new_project=self._is_new_project)
        self._is_new_project = False
        self._enable_controls(state)

    def show_qualities(self, qualities: Mapping[SightingKey, SightingQuality]) -> None:
        """Show in step 2 whether sightings of the adjustment are rated poor."""
        project = self._document.project
        targets = () if project is None else project.targets_of_role("target")
        if project is not None and main_wrong_value(all_warnings(project)) is not None:
            targets = ()  # it explains the poor qualities
        poor = tuple(
            gettext("{target} on {line}", target=target.name, line=sighting.line)
            for target in targets if target.used
            for sighting in target.used_sightings
            if (quality := qualities.get((target.name, sighting.line))) is not None
            and quality.rating == "poor"
        )  # fmt: skip
        if poor != self._poor_sightings:
            self._poor_sightings = poor
            self.refresh()

    def _open_step(self) -> None:
        """Open the first step that is not done, without refreshing the panels twice."""
        self._opening = self._is_new_project = True
        try:
            self._panels.workflow.open(self._first_open_step())
        finally:
            self._opening = False

    def _project_state(self) -> ProjectState:
        document = self._document
        project, waiting = document.project, document.awaits_result
        survey = document.survey if document.is_survey_current else None
        steps = step_statuses(
            project,
            survey,
            waiting=waiting,
            refusal=document.refusal,
            report=document.report,
            running=self._running_step(),
            checking=document.awaits_checks,
            poor_sightings=self._poor_sightings,
            opening=project is None and self._runner.busy,
        )
        errors = self._panels.workflow.input_errors()
        steps = tuple(map(with_input_error, steps, errors))
        return ProjectState(
            project, survey, steps, self._runner.busy, waiting, _reason_text(document.refusal),
            document.refused_since, self._estimate_reason(), document.is_result_outdated,
            self._running_step() == VALIDATE, document.awaits_checks, document.report,
        )  # fmt: skip

    def _running_step(self) -> int | None:
        """Step whose task is running; None for none."""
        task = self._runner.current
        return None if task is None else TASK_STEPS.get(task.key)

    def _estimate_reason(self) -> Reason:
        """Reason why no estimate can be requested; it can while lines are georeferenced again."""
        project = self._document.project
        targets = () if project is None else project.targets_of_role("target")
        return first_reason(
            (project is None, Unavailable.NO_PROJECT),
            (not any(target.used for target in targets), Unavailable.NO_TARGET),
            (self._document.survey is None, Unavailable.READING),
            (self._runner.is_busy_beside(GEOREFERENCING_KEY), Unavailable.BUSY),
        )

    def _enable_save(self) -> None:
        document = self._document
        self._actions.set_reason(
            "save",
            first_reason(
                (document.project is None, Unavailable.NO_PROJECT),
                (not document.is_modified, Unavailable.SAVED),
            ),
        )

    def _enable_controls(self, state: ProjectState) -> None:
        steps = state.steps
        busy = first_reason((state.is_busy, Unavailable.BUSY))
        no_project = first_reason((state.project is None, Unavailable.NO_PROJECT))
        no_result = no_project or first_reason(
            (state.project is not None and state.project.result is None, Unavailable.NO_RESULT)
        )
        for name, reason in {
            **dict.fromkeys(("new", "open", "demo", "tour", "Recent"), busy),
            "close_project": no_project or busy,
            **dict.fromkeys(("add_lines", "save_as"), steps[DATA].reason or busy),
            "report": steps[REPORT].reason or busy,
            "estimate": self._estimate_reason(),
            "validate": steps[VALIDATE].reason or busy,
            "cancel": first_reason((not self._runner.active, Unavailable.NO_TASK)),
            **dict.fromkeys(PROJECT_ACTIONS, no_project),
            **dict.fromkeys(("after", "toggle", "wipe"), no_result),
        }.items():
            self._actions.set_reason(name, reason)
        self._central_widget.start.set_reason(reason_text(busy))
        self._enable_save()
        self._enable_candidate()

    def _enable_candidate(self) -> None:
        waits = self._controller.candidate is not None
        none = (not waits, Unavailable.NO_CANDIDATE)
        poor = (self._panels.targets.candidate.is_poor, Unavailable.POOR_CANDIDATE)
        self._actions.set_reason("accept", first_reason(none, poor))
        self._actions.set_reason("reject", first_reason(none))

    def _show_progress(self) -> None:
        task = self._runner.current
        self._panels.adjust.show_task(
            task if task is not None and task.key == ESTIMATE_KEY else None
        )

    def _task_title(self) -> str:
        """Title of the running task; empty if none runs."""
        task = self._runner.current
        return task.title if task is not None and self._runner.busy else ""

    def _show_task(self) -> None:
        panels, state = self._panels, self._project_state()
        self._central_widget.start.show_task(self._task_title())
        for panel in (panels.workflow, panels.adjust, panels.validate, panels.report):
            panel.show_state(state)
        self._enable_controls(state)

    def _show_candidate(self) -> None:
        panels = self._panels
        candidate, project = self._controller.candidate, self._document.project
        if candidate is not None:
            panels.workflow.open(TARGETS)
        panels.targets.show_candidate(candidate, project)
        if candidate is not None:
            self._scroll_to_candidate()
        self._enable_candidate()

    def _scroll_to_candidate(self) -> None:
        """Scroll to the detected target, and at least to its buttons."""
        workflow, candidate = self._panels.workflow, self._panels.targets.candidate
        workflow.scroll_to(candidate)
        workflow.scroll_to(candidate.accept)

    def _show_count(self, count: PointCount) -> None:
        self._panels.adjust.show_count(count.kept, count.total, count.sightings, count.reason)

    def _count_points(self) -> None:
        self._computations.count(self._panels.adjust.subsample)

    def _show_before_after(self, which: str) -> None:
        shows_both = self._actions["wipe"].isChecked() or not self._actions["one_view"].isChecked()
        if shows_both and which == "estimated":
            return  # in a split view or beside each other
        self._actions["after" if which == "estimated" else "before"].setChecked(True)

    def _first_open_step(self) -> int:
        project = self._document.project
        if project is None:
            return DATA
        if project.result is None:
            used = [target for target in project.targets_of_role("target") if target.used]
            return ADJUST if len(used) >= MIN_TARGET_COUNT else TARGETS
        return REPORT if project.validation else VALIDATE


def _reason_text(reason: Message | str) -> str:
    return message_text(reason) if isinstance(reason, Message) else reason
