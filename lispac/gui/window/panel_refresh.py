"""Refresh of the panels from the document, and availability of the actions."""

from PySide6.QtCore import QObject

from lispac.gui.app.actions import Actions
from lispac.gui.app.settings import AppSettings
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.project.computations import Computations, PointCount
from lispac.gui.project.controller import GEOREFERENCING_KEY, Controller
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
)
from lispac.gui.window.central_widget import CentralWidget
from lispac.gui.window.panels import Panels
from lispac.message_texts import message_text
from lispac.messages import Message


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
    ) -> None:
        super().__init__(actions)
        self._document, self._runner, self._controller = document, runner, controller
        self._computations, self._settings, self._actions = computations, settings, actions
        self._panels, self._central_widget = panels, central_widget
        self._opening = False
        document.changed.connect(self.refresh)
        document.changed.connect(self._count_points)
        panels.workflow.step_opened.connect(lambda _step: self.refresh())
        document.modified.connect(actions["save"].setEnabled)
        document.opened.connect(self._open_step)
        runner.changed.connect(self._show_task)
        runner.progress_changed.connect(self._show_progress)
        controller.candidate_changed.connect(self._show_candidate)
        computations.counted.connect(self._show_count)
        scene.which_changed.connect(self._show_before_after)
        for name in ("before", "after", "wipe"):
            actions[name].toggled.connect(self._show_chosen_lines)

    def refresh(self) -> None:
        """Show the current document in all panels."""
        if self._opening:
            return
        state = self._project_state()
        self._central_widget.show_view(state.project is not None)
        if state.project is None:
            self._central_widget.start.show_recent(self._settings.recent())
        self._panels.show_state(state)
        self._enable_controls(state)

    def _open_step(self) -> None:
        """Open the first step that is not done, without refreshing the panels twice."""
        self._opening = True
        try:
            self._panels.workflow.open(self._first_open_step())
        finally:
            self._opening = False

    def _project_state(self) -> ProjectState:
        document = self._document
        project, waiting = document.project, document.awaits_result
        survey = document.survey if document.survey_is_current else None
        steps = step_statuses(
            project, survey, waiting=waiting, refusal=document.refusal, reported=document.reported
        )
        return ProjectState(
            project, survey, steps, self._runner.busy, waiting, _reason_text(document.refusal),
            document.refused_since, self._can_estimate(), document.is_result_outdated,
        )  # fmt: skip

    def _can_estimate(self) -> bool:
        """Whether an estimate can be requested, also while the lines are georeferenced again."""
        project = self._document.project
        has_targets = project is not None and any(
            target.used for target in project.targets_of_role("target")
        )
        is_busy = self._runner.is_busy_beside(GEOREFERENCING_KEY)
        return has_targets and self._document.survey is not None and not is_busy

    def _enable_controls(self, state: ProjectState) -> None:
        project, statuses, busy = state.project, state.steps, state.is_busy
        actions = self._actions
        estimated = project is not None and project.result is not None
        for name, enabled in {
            "save": self._document.is_modified,
            "new": not busy,
            "open": not busy,
            "demo": not busy,
            "tour": not busy,
            **dict.fromkeys(("add_lines", "save_as"), statuses[DATA].ready and not busy),
            "report": statuses[REPORT].ready and not busy,
            "accept": self._controller.candidate is not None,
            "reject": self._controller.candidate is not None,
            "estimate": state.can_estimate,
            "validate": statuses[VALIDATE].ready and not busy,
            "cancel": self._runner.active,
            "before": project is not None,
            "after": estimated,
            "toggle": estimated,
        }.items():
            actions[name].setEnabled(enabled)
        actions.submenus["Recent"].setEnabled(not busy)

    def _show_progress(self) -> None:
        task = self._runner.current
        self._panels.adjust.show_task(task if task is not None and task.key == "estimate" else None)

    def _show_task(self) -> None:
        panels, state = self._panels, self._project_state()
        for panel in (panels.adjust, panels.validate, panels.report):
            panel.show_state(state)
        self._enable_controls(state)

    def _show_candidate(self) -> None:
        panels = self._panels
        candidate, project = self._controller.candidate, self._document.project
        if candidate is not None:
            panels.workflow.open(TARGETS)
        panels.targets.show_candidate(candidate, project)
        if candidate is not None:
            panels.workflow.scroll_to(panels.targets.candidate)
        for name in ("accept", "reject"):
            self._actions[name].setEnabled(candidate is not None)

    def _show_count(self, count: PointCount) -> None:
        self._panels.adjust.show_count(count.kept, count.total, count.sightings, count.reason)

    def _count_points(self) -> None:
        self._computations.count(self._panels.adjust.subsample)

    def _show_before_after(self, which: str) -> None:
        if self._actions["wipe"].isChecked() and which == "estimated":
            return  # the split view shows both
        self._actions["after" if which == "estimated" else "before"].setChecked(True)

    def _show_chosen_lines(self) -> None:
        self._panels.validate.show_before_after(
            before=self._actions["before"].isChecked(), after=self._actions["after"].isChecked()
        )

    def _first_open_step(self) -> int:
        project = self._document.project
        if project is None:
            return DATA
        if not project.targets_of_role("target"):
            return TARGETS
        if project.result is None:
            return ADJUST
        return REPORT if project.validation else VALIDATE


def _reason_text(reason: Message | str) -> str:
    return message_text(reason) if isinstance(reason, Message) else reason
