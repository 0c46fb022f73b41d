"""Refresh of the panels from the document, and availability of the actions."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from lispac.gui.project import status
from lispac.gui.project.computations import PointCount
from lispac.gui.project.status import ADJUST, DATA, REPORT, TARGETS, VALIDATE
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.project import Project
from lispac.workflow.project.survey import Survey

if TYPE_CHECKING:
    from lispac.gui.window.main_window import MainWindow


class PanelRefresh(QObject):
    """Refreshes the panels and enables the actions after every change."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._window = window
        self._opening = False
        window.document.changed.connect(self.refresh)
        window.document.changed.connect(self._count_points)
        window.document.modified.connect(lambda _modified: self._set_window_title())
        window.workflow.step_opened.connect(lambda _step: self.refresh())
        window.document.opened.connect(self._open_step)
        window.runner.changed.connect(self._show_task)
        window.runner.progress_changed.connect(self._show_progress)
        window.controller.candidate_changed.connect(self._show_candidate)
        window.computations.counted.connect(self._show_count)
        window.scene.which_changed.connect(self._show_before_after)

    def refresh(self) -> None:
        """Show the current document in all panels."""
        if self._opening:
            return
        window = self._window
        project, survey, statuses = self._project_state()
        waiting = window.document.awaits_result
        busy = window.runner.busy
        window.central_widget.show_view(project is not None)
        if project is None:
            window.central_widget.start.show_recent(window.settings.recent())
        window.workflow.show_status(statuses)
        window.data.show_project(project, survey)
        window.targets.show_project(project, survey)
        window.adjust.show_project(project, statuses[ADJUST], busy)
        window.validate.show_project(project, statuses[VALIDATE], busy)
        window.report.show_status(statuses[REPORT], survey is not None, busy)
        window.table.show_project(project, survey)
        window.results.show_project(
            project, waiting=waiting, refusal=_reason_text(window.document.refusal),
            refused_since=window.document.refused_since,
        )  # fmt: skip
        window.diagnostics.show_project(project, waiting=waiting)
        window.convention.show_project(project)
        window.histograms.show_project(project)
        self._enable_controls(statuses, busy)
        self._set_window_title()

    def _open_step(self) -> None:
        """Open the first step that is not done, without refreshing the panels twice."""
        self._opening = True
        try:
            self._window.workflow.open(self._first_open_step())
        finally:
            self._opening = False

    def _project_state(self) -> tuple[Project | None, Survey | None, tuple[status.StepStatus, ...]]:
        window = self._window
        document = window.document
        survey = document.survey if document.survey_is_current else None
        statuses = status.step_statuses(
            document.project, survey, waiting=document.awaits_result, refusal=document.refusal,
            reported=document.reported,
        )  # fmt: skip
        return document.project, survey, statuses

    def _enable_controls(self, statuses: tuple[status.StepStatus, ...], busy: bool) -> None:
        window = self._window
        project, actions = window.document.project, window.actions_
        estimated = project is not None and project.result is not None
        for name, enabled in {
            "save": window.document.is_modified,
            "new": not busy,
            "open": not busy,
            "demo": not busy,
            "tour": not busy,
            **dict.fromkeys(("add_lines", "save_as"), statuses[DATA].ready and not busy),
            "report": statuses[REPORT].ready and not busy,
            "accept": window.controller.candidate is not None,
            "reject": window.controller.candidate is not None,
            "estimate": statuses[ADJUST].ready and not busy,
            "validate": statuses[VALIDATE].ready and not busy,
            "cancel": window.runner.active,
            "before": project is not None,
            "after": estimated,
            "toggle": estimated,
        }.items():
            actions[name].setEnabled(enabled)
        actions.recent.setEnabled(not busy)

    def _show_progress(self) -> None:
        window = self._window
        task = window.runner.current
        window.task_bar.show_task(task)
        window.adjust.show_task(task if task is not None and task.key == "estimate" else None)

    def _show_task(self) -> None:
        window = self._window
        project, survey, statuses = self._project_state()
        busy = window.runner.busy
        window.adjust.show_project(project, statuses[ADJUST], busy)
        window.validate.show_project(project, statuses[VALIDATE], busy)
        window.report.show_status(statuses[REPORT], survey is not None, busy)
        self._enable_controls(statuses, busy)

    def _show_candidate(self) -> None:
        window = self._window
        candidate, project = window.controller.candidate, window.document.project
        if candidate is not None:
            window.workflow.open(TARGETS)
        window.targets.show_candidate(candidate, project)
        if candidate is not None:
            window.workflow.scroll_to(window.targets.candidate)
        for name in ("accept", "reject"):
            window.actions_[name].setEnabled(candidate is not None)

    def _show_count(self, count: PointCount) -> None:
        window = self._window
        window.adjust.show_count(count.kept, count.total, count.sightings, count.reason)

    def _count_points(self) -> None:
        window = self._window
        window.computations.count(window.adjust.subsample)

    def _show_before_after(self, which: str) -> None:
        window = self._window
        window.validate.show_before_after(which)
        window.actions_["after" if which == "estimated" else "before"].setChecked(True)

    def _set_window_title(self) -> None:
        window = self._window
        project = window.document.project
        window.setWindowTitle("LISPAC" if project is None else f"{project.name}[*] – LISPAC")
        window.setWindowModified(window.document.is_modified)
        window.actions_["save"].setEnabled(window.document.is_modified)

    def _first_open_step(self) -> int:
        window = self._window
        project = window.document.project
        if project is None:
            return DATA
        if not project.targets_of_role("target"):
            return TARGETS
        if project.result is None:
            return ADJUST
        return REPORT if project.validation else VALIDATE


def _reason_text(reason: Message | str) -> str:
    return message_text(reason) if isinstance(reason, Message) else reason
