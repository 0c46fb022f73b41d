"""Controller of the survey design: its window, files and long tasks."""

import os
import time
from collections.abc import Callable, Iterable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from PySide6.QtCore import QObject, Qt
from PySide6.QtWidgets import QWidget

from lispac.design.monte_carlo import MIN_SURVEYS, MonteCarloResult
from lispac.design.objective import CRITERION_TEXTS, PlanObjective
from lispac.design.plan import Plan
from lispac.design.plan_search import DesignResult, Mapper, search
from lispac.design.scenarios import (
    SCENARIOS,
    ScenarioOutcome,
    predict_scenarios,
)
from lispac.design.site import Site
from lispac.errors import LispacError, ProjectError
from lispac.gui.app.actions import Actions
from lispac.gui.app.settings import AppSettings
from lispac.gui.app.tasks import TaskRunner, preload_matplotlib
from lispac.gui.features.design import edits
from lispac.gui.features.design.dialogs import DesignDialogs
from lispac.gui.features.design.search import SearchResult
from lispac.gui.features.design.surveys import SimulationRequest
from lispac.gui.features.design.window import DesignWindow
from lispac.gui.features.design.workspace import Workspace
from lispac.gui.project.document import Document
from lispac.gui.viewport.base import Viewport
from lispac.gui.widgets.error_box import exception_text
from lispac.installation_paths import home_folder
from lispac.io.config.plan_file import TitledPlan, read_plan, read_site, write_plan
from lispac.language import N_, gettext, gettext_lazy
from lispac.messages import error
from lispac.present.planning.design_results import PlanComparison, SimulationValues
from lispac.progress import Progress, Step
from lispac.workflow.planning.plan_checks import result_heading, simulate_surveys, write_field_plan
from lispac.workflow.planning.plan_comparison import compare_with_plan
from lispac.workflow.planning.process_pool import process_pool_mapper
from lispac.workflow.project.survey import load_survey

MAX_SERIAL_PLANS = 600
"""Number of evaluations up to which one process is faster than several, which start slowly."""


class CountingMapper:
    """Mapper that counts its results and reports their rate with the progress."""

    def __init__(self, mapper: Mapper, progress: Progress, rate: str) -> None:
        self._mapper, self._progress, self._rate = mapper, progress, rate
        self._count, self._began = 0, time.monotonic()

    def map(self, function: Callable[[Any], Any], values: Iterable[Any]) -> Iterator[Any]:
        """Apply a function to values and yield the results in order."""
        for value in self._mapper(function, values):
            self._count += 1
            if self._count % 10 == 0:  # also checks the cancel flag between reports
                self._progress(self._fraction)
            yield value

    _fraction = 0.0

    def progress(self, fraction: float, step: Step | None = None) -> None:
        """Report the progress with the rate."""
        self._fraction = fraction
        elapsed = time.monotonic() - self._began
        known = elapsed > 0.5 and self._count
        if step is not None and known:
            rate = gettext_lazy(self._rate, rate=self._count / elapsed)
            step = gettext_lazy("{step}, {rate}", step=step, rate=rate)
        self._progress(fraction, step)


def find_best_plan(
    site: Site, objective: PlanObjective, plans: int, start: Plan, progress: Progress
) -> DesignResult:
    """Search for the best plan of a site, on all cores if there are many plans."""
    workers = 1 if plans * len(objective.pos_factors) <= MAX_SERIAL_PLANS else os.cpu_count() or 1
    progress(0.0, gettext_lazy("Starting the search for the best survey plan"))
    with process_pool_mapper(workers) as mapper:
        rated = CountingMapper(mapper, progress, N_("{rate:x} survey plans evaluated/s"))
        return search(
            site, objective, plans=plans, start=start, mapper=rated.map, progress=rated.progress
        )


def compute_scenarios(plan: Plan, progress: Progress) -> tuple[ScenarioOutcome, ...]:
    """Compute the outcomes of all scenarios, each of which changes one property of the plan."""
    return predict_scenarios(plan, tuple(SCENARIOS), progress=progress)


def run_survey_simulation(
    plan: Plan, request: SimulationRequest, progress: Progress
) -> MonteCarloResult:
    """Simulate surveys of a plan on all cores; cancelling keeps the finished ones."""
    progress(0.0, gettext_lazy("Starting the simulated surveys"))
    with process_pool_mapper(os.cpu_count() or 1, at_once=1) as mapper:
        rated = CountingMapper(mapper, progress, N_("{rate:x.1} simulated surveys/s"))
        return simulate_surveys(
            plan, request.surveys, seed=request.seed, flatness_known=request.flatness_known,
            enough=MIN_SURVEYS, mapper=rated.map, progress=rated.progress,
        )  # fmt: skip


class SiteDesign(QObject):
    """Controls the design window; has its own worker, so that both windows can be used.

    Attributes
    ----------
    window : DesignWindow or None
        None until it is first opened.
    field_plan_runner : TaskRunner
        Writes field plans, also while a search runs.
    """

    def __init__(
        self,
        document: Document,
        make_viewport: Callable[[], Viewport],
        dialogs: DesignDialogs,
        settings: AppSettings,
        actions: Actions,
        show_keys: Callable[[], None],
        parent: QWidget,
    ) -> None:
        super().__init__(parent)
        self._document, self._make_viewport, self._parent = document, make_viewport, parent
        self._dialogs, self._settings, self._show_keys = dialogs, settings, show_keys
        self.window: DesignWindow | None = None
        self.workspace = Workspace(self)
        self.runner, self.field_plan_runner = TaskRunner(self), TaskRunner(self)
        self._path: Path | None = None
        actions.connect_slots({"design": self.open})

    def copy_state_from(self, former: "SiteDesign") -> None:
        """Take over the plan and the results of a former window."""
        self._path = former._path
        self.workspace.copy_state_from(former.workspace)
        if former.window is not None:
            self.window = self._create_window()
            self.window.copy_state_from(former.window)
            if former.window.isVisible():
                self.window.show()

    def choose_sensors(self) -> None:
        """Ask for sensors of the library and use their standard deviations in the plan."""
        chosen = self._dialogs.sensors_of_plan(self._settings)
        if chosen is None or chosen == (None, None):
            return
        self.workspace.edit(
            gettext_lazy("Sensors"), edits.with_sensors(self.workspace.titled, *chosen)
        )

    def open(self) -> None:
        """Show the window in front."""
        if self.window is None:
            self.window = self._create_window()
        self.window.setWindowState(self.window.windowState() & ~Qt.WindowState.WindowMinimized)
        self.window.show()
        self.window.raise_()
        self.window.activateWindow()

    def _create_window(self) -> DesignWindow:
        window = DesignWindow(self.workspace, self._make_viewport, self._parent)
        window.actions_.connect_slots({
            "new": self.new, "open": self.open_plan, "save": self.save, "save_as": self.save_as,
            "page": self.save_field_plan, "scenarios": self.scenarios, "cancel": self.runner.cancel,
            "compare": self.compare, "keys": self._show_keys,
        })  # fmt: skip
        window.actions_.refused.connect(self._dialogs.show_error)
        guarded = window.actions_.guarded
        window.search.requested.connect(guarded(self.search))
        window.system.library_requested.connect(self.choose_sensors)
        window.search.cancel_requested.connect(self.runner.cancel)
        window.surveys.requested.connect(guarded(self.surveys))
        window.surveys.cancel_requested.connect(self.runner.cancel)
        window.search.file_requested.connect(self.read_site)
        window.task_bar.cancel_requested.connect(self.runner.cancel)
        self.runner.changed.connect(lambda: window.show_busy(self.runner.busy))
        self.runner.progress_changed.connect(lambda: window.task_bar.show_task(self.runner.current))
        self.runner.failed.connect(self._dialogs.show_error)
        self.field_plan_runner.failed.connect(self._dialogs.show_error)
        window.results.predictor.failed.connect(self._dialogs.show_error)
        self.runner.stopped.connect(
            lambda title: window.note(gettext("{task}: cancelled", task=title))
        )
        window.show_busy(False)
        return window

    # -- files -------------------------------------------------------------------------------

    def new(self) -> None:
        """Start a new design with the plan of the thesis."""
        if self._may_discard_plan():
            self._path = None
            self.workspace.start(edits.default_plan())

    def open_plan(self) -> None:
        """Open a plan from its file."""
        if not self._may_discard_plan():
            return
        path = self._dialogs.design_file("open", self._start_folder)
        if path is None:
            return
        try:
            titled = read_plan(path)
        except LispacError as error:
            self._dialogs.show_error(error)
            return
        self._path = path
        self.workspace.start(titled)

    def save(self) -> bool:
        """Save the plan to its file; return whether it was saved."""
        return self.save_as() if self._path is None else self._write(self._path)

    def save_as(self) -> bool:
        """Ask for a file and save the plan; return whether it was saved."""
        path = self._dialogs.design_file("save", self._start_folder / "plan.toml")
        return path is not None and self._write(path)

    def _write(self, path: Path) -> bool:
        try:
            self._require_complete_plan()
            write_plan(path, self.workspace.history.current)  # without a drag that may be cancelled
        except (LispacError, OSError) as error:
            self._dialogs.show_error(error)
            return False
        self._path = path
        self.workspace.history.mark_saved()
        self.workspace.changed.emit()
        self._note(gettext("Saved {file}", file=str(path)))
        return True

    def save_field_plan(self) -> None:
        """Ask for a file and write the field plan."""
        path = self._dialogs.design_file("page", self._start_folder / "field-plan.pdf")
        if path is None:
            return
        try:
            self._require_complete_plan()
        except LispacError as error:
            self._dialogs.show_error(error)
            return
        titled = self.workspace.titled
        self.field_plan_runner.run(
            gettext("Writing the field plan"),
            lambda _progress: write_field_plan(path, titled),
            lambda _nothing: self._note(gettext("Saved {file}", file=str(path))), persistent=True,
        )  # fmt: skip

    def read_site(self) -> None:
        """Ask for a site file and read its limits."""
        assert self.window is not None
        path = self._dialogs.design_file("site", self._start_folder)
        if path is None:
            return
        try:
            self.window.search.limits.use_file(*read_site(path))
        except LispacError as error:
            self._dialogs.show_error(error)

    @property
    def _start_folder(self) -> Path:
        return home_folder() if self._path is None else self._path.parent

    def _require_complete_plan(self) -> None:
        plan = self.workspace.titled.plan
        if not plan.targets or not plan.lines:
            raise LispacError(error("window.plan_incomplete"))

    def _note(self, text: str) -> None:
        if self.window is not None:
            self.window.note(text)

    # -- computations ------------------------------------------------------------------------

    def scenarios(self) -> None:
        """Compute the scenarios in the background."""
        assert self.window is not None
        plan, window = self.workspace.titled.plan, self.window
        try:
            self._require_complete_plan()
        except LispacError as error:
            self._note(exception_text(error))
            return

        def work(progress: Progress) -> tuple[ScenarioOutcome, ...]:
            preload_matplotlib()
            return compute_scenarios(plan, progress)

        def done(result: tuple[ScenarioOutcome, ...]) -> None:
            window.pictures.show_outcomes(result)
            window.show_figures()

        self.runner.run(gettext("Scenarios"), work, done)

    def search(self) -> None:
        """Find the best plan in the background; it is one undo step."""
        assert self.window is not None
        panel, window = self.window.search, self.window
        before = self.workspace.titled
        try:
            title, site = panel.limits.site(before)
        except LispacError as error:
            self._dialogs.show_error(error)
            return
        objective, plans = panel.objective, round(panel.plans.value())

        def work(progress: Progress) -> DesignResult:
            preload_matplotlib()
            return find_best_plan(site, objective, plans, before.plan, progress)

        def done(result: DesignResult) -> None:
            best = TitledPlan(title, result.plan, site.wall)
            self.workspace.edit(gettext_lazy("best survey design"), best)
            value = float(np.degrees(result.value))
            panel.show_found(SearchResult(value, objective, result.evaluated, result.exact))
            window.pictures.show_front(result.front, CRITERION_TEXTS[objective.criterion])

        panel.show_found(None)
        self.runner.run(gettext("Searching for the best survey design"), work, done)

    def surveys(self) -> None:
        """Simulate and adjust many surveys of the plan, in the background."""
        assert self.window is not None
        titled, window, requested = (
            self.workspace.titled,
            self.window,
            self.window.surveys.simulation_request,
        )
        try:
            self._require_complete_plan()
        except LispacError as error:
            self._note(exception_text(error))
            return

        def work(progress: Progress) -> MonteCarloResult:
            preload_matplotlib()
            return run_survey_simulation(titled.plan, requested, progress)

        def done(result: MonteCarloResult) -> None:
            head = result_heading(titled.title, result, requested.surveys)
            values = SimulationValues.of(result)
            window.surveys.result_table.show_result(head, values, titled.plan)
            window.surveys.result_table.set_current_plan(self.workspace.titled.plan)
            window.pictures.show_errors(result)
            window.show_figures()

        # A cancelled simulation has a result if enough surveys were finished.
        self.runner.run(gettext("Simulating surveys"), work, done, persistent=True)

    def compare(self) -> None:
        """Compare the survey of the main window with this plan."""
        assert self.window is not None
        project, survey = self._document.project, self._document.survey
        titled, window = self.workspace.titled, self.window
        try:
            self._require_complete_plan()
            if project is None:
                raise ProjectError(error("window.no_project_to_compare"))
        except LispacError as failure:
            self._dialogs.show_error(failure)
            return

        def work(progress: Progress) -> PlanComparison:
            loaded = load_survey(project, progress=progress) if survey is None else survey
            return compare_with_plan(project, loaded, titled)

        self.runner.run(
            gettext("Comparing the survey design with the survey"), work,
            lambda found: window.show_comparison(found, project.name, titled),
        )  # fmt: skip

    # -- closing -----------------------------------------------------------------------------

    @property
    def runners(self) -> tuple[TaskRunner, TaskRunner]:
        """Task runners of this window."""
        return self.runner, self.field_plan_runner

    def _may_discard_plan(self) -> bool:
        """Whether the plan may be discarded; asks to save unsaved changes."""
        if not self.workspace.history.is_modified:
            return True
        choice = self._dialogs.ask_to_save_changes(self.workspace.titled.title)
        return self.save() if choice == "save" else choice == "discard"

    def leave(self) -> bool:
        """End the design before the program ends; return False if the user cancels."""
        if not self._may_discard_plan():
            return False
        self.end()
        return True

    def end(self) -> None:
        """Stop all work and release the window without asking; may be repeated."""
        if self.window is not None:
            self.window.hide()
        self.runner.close()
        self.field_plan_runner.close()
        if self.window is not None:
            self.window.release()
