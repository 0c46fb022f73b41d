"""Actions that compute and show a study.

Studies: comparison with a reference, history of calibrations, point spacings, error budget,
differences between lines, visibility of errors, and alternative methods.
"""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from lispac.gui.app.actions import Actions
from lispac.gui.app.tasks import TaskRunner, preload_matplotlib
from lispac.gui.app.unavailable import Unavailable, first_reason
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.studies.dialogs import StudyDialogs
from lispac.gui.project.availability import data_reason, result_reason
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.viewport.base import Array, Colour, Sketch, Viewport
from lispac.installation_paths import home_folder
from lispac.language import N_, gettext
from lispac.messages import Message
from lispac.method_comparison import method_results, missing_methods
from lispac.present.calibration.error_budget import ErrorBudgetValues
from lispac.present.calibration.subsampling import SubsamplingValues
from lispac.present.checking.absolute import AbsoluteCheckValues
from lispac.progress import Progress, sub_progress
from lispac.project import Project
from lispac.simulation.thesis_site import SITES
from lispac.simulation.visibility_study import VisibilityStudy, study_visibility
from lispac.workflow.calibration.correspondences import CorrespondenceResult, correspondences
from lispac.workflow.calibration.method_runs import run_missing_methods
from lispac.workflow.checking.absolute_check import check_absolute
from lispac.workflow.checking.budget import error_budget_of
from lispac.workflow.checking.calibration_history import CalibrationHistory, read_histories
from lispac.workflow.checking.line_quality import LineQuality, line_quality
from lispac.workflow.checking.subsampling import (
    DEFAULT_DISTANCES,
    subsampling_study,
)
from lispac.workflow.project.survey import Survey

if TYPE_CHECKING:
    from lispac.gui.features.studies.study_dialog import LineQualityDialog

SKETCH_NAME = "line_differences"
MARK_COLOUR: Colour = (0, 90, 200)
"""Sketch that marks the places of a row of the differences between lines, and its colour."""
MAX_MARKED_PLACES = 400
"""Largest number of marked places."""


class Studies(QObject):
    """Runs the studies and shows their results in dialogues."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        scene: Scene,
        viewport: Viewport,
        controller: Controller,
        dialogs: StudyDialogs,
        actions: Actions,
    ) -> None:
        super().__init__(actions)
        self._document, self._runner = document, runner
        self._controller, self._dialogs = controller, dialogs
        self._actions, self._scene = actions, scene
        self._differences = LineDifferences(document, viewport, dialogs, self)
        actions.connect_slots(
            {
                "check": self.check,
                "history": self.history,
                "subsampling": self.subsampling,
                "budget": self.budget,
                "line_quality": self.line_quality,
                "visibility": self.visibility,
            }
        )
        for moved in (self._document.changed, self._document.survey_changed, self._runner.changed):
            moved.connect(self._enable_controls)
        self._enable_controls()

    def copy_state_from(self, former: "Studies") -> None:
        """Show the dialogue that the former window shows beside the view."""
        self._differences.copy_state_from(former._differences)

    def history(self) -> None:
        """Show the calibrations of a vessel's system in a folder of projects."""
        project = self._document.project
        start = home_folder() if project is None else project.folder.parent
        folder = self._dialogs.folder_of_projects(start)
        if folder is None:
            return

        def work(progress: Progress) -> tuple[tuple[CalibrationHistory, ...], tuple[Message, ...]]:
            preload_matplotlib()
            # Includes a result that is not yet saved.
            current = [] if project is None or project.result is None else [project]
            return read_histories([folder], also=current, progress=progress)

        self._runner.run(
            gettext("Reading the calibrations"),
            work,
            lambda found: self._dialogs.history(*found),
            modal=True,
        )

    def check(self) -> None:
        """Compare the lines with a static scan or surveyed points, as one undo step."""
        project, survey = self._document.current_data
        if project is None or survey is None:
            return
        request = self._dialogs.check(project, survey.trajectory)
        if request is None:
            return

        def work(progress: Progress) -> tuple[Project, tuple[Message, ...]]:
            preload_matplotlib()
            return check_absolute(
                project, survey, request.path, crs=request.crs, height=request.height,
                sigma=request.sigma, search_distance=request.search_distance, progress=progress,
            )  # fmt: skip

        def done(checked: tuple[Project, tuple[Message, ...]]) -> None:
            found, notes = checked
            self._document.edit(N_("check against {file}"), found, file=request.path.name)
            for note in notes:
                self._controller.logged.emit(message_text(note))
            assert found.absolute is not None
            self._dialogs.show_check_result(AbsoluteCheckValues.of(found.absolute))

        title = gettext("Checking against {file}", file=request.path.name)
        task = self._runner.run(title, work, done, modal=True)
        self._controller.cancel_on_edit(task)

    def budget(self) -> None:
        """Show the effect of each source of error on a point."""
        project, survey = self._document.current_data
        if project is None or survey is None:
            return
        task = self._runner.run(
            gettext("Computing the error budget"),
            lambda _progress: ErrorBudgetValues.of(error_budget_of(project, survey)),
            self._dialogs.budget,
            modal=True,
        )
        self._controller.cancel_on_edit(task)

    def line_quality(self) -> None:
        """Show the differences between the lines with the boresight used in the view."""
        project, survey = self._document.current_data
        if project is None or survey is None:
            return
        which = self._scene.which

        def work(progress: Progress) -> LineQuality:
            preload_matplotlib()
            return line_quality(project, survey, which=which, progress=progress)

        task = self._runner.run(
            gettext("Comparing the lines"),
            work,
            lambda found: self._differences.show(found, project, survey),
            modal=True,
        )
        self._controller.cancel_on_edit(task)

    def subsampling(self) -> None:
        """Adjust with smaller and larger point spacings."""
        project, survey = self._document.current_data
        if project is None or survey is None:
            return
        used = project.settings.subsample

        def work(progress: Progress) -> tuple[SubsamplingValues, ...]:
            return subsampling_study(
                project, survey, sorted({*DEFAULT_DISTANCES, used}), progress=progress
            )

        task = self._runner.run(
            gettext("Point spacing study"), work,
            lambda found: self._dialogs.subsampling(found, used), modal=True,
        )  # fmt: skip
        self._controller.cancel_on_edit(task)

    def visibility(self) -> None:
        """Show the boards and lines that make each error visible; no project is needed."""

        def work(progress: Progress) -> list[VisibilityStudy]:
            preload_matplotlib()
            sites = list(SITES.values())
            return [
                study_visibility(
                    site, progress=sub_progress(progress, k / len(sites), (k + 1) / len(sites))
                )
                for k, site in enumerate(sites)
            ]

        self._runner.run(gettext("Simulating boards"), work, self._dialogs.visibility, modal=True)

    def _enable_controls(self) -> None:
        document, runner = self._document, self._runner
        project, data = document.project, data_reason(document, runner)
        picked = project is not None and bool(project.targets_of_role("target"))
        for name in ("history", "visibility"):
            self._actions.set_reason(name, first_reason((runner.busy, Unavailable.BUSY)))
        self._actions.set_reason(
            "subsampling", data or first_reason((not picked, Unavailable.NO_TARGET))
        )
        self._actions.set_reason("line_quality", data)
        for name in ("check", "budget"):
            self._actions.set_reason(name, result_reason(document, runner))


class LineDifferences(QObject):
    """Shows the differences between the lines, and marks their places in the view."""

    def __init__(
        self, document: Document, viewport: Viewport, dialogs: StudyDialogs, parent: QObject
    ) -> None:
        super().__init__(parent)
        self._document, self._viewport, self._dialogs = document, viewport, dialogs
        self._dialog: LineQualityDialog | None = None
        self._compared: tuple[Survey, object] | None = None
        """Survey and result with which the lines were compared."""
        document.changed.connect(self._close_outdated)
        document.survey_changed.connect(self._close_outdated)

    def show(self, quality: LineQuality, project: Project, survey: Survey) -> None:
        """Show the differences instead of earlier ones."""
        self._close()
        self._compared = survey, project.result
        self._dialog = self._dialogs.line_quality(quality)
        self._dialog.row_selected.connect(self._mark)
        self._dialog.finished.connect(self._on_closed)

    def copy_state_from(self, former: "LineDifferences") -> None:
        """Show the dialogue of a former window of the same document."""
        project, survey = self._document.project, self._document.survey
        if former._dialog is not None and project is not None and survey is not None:
            self.show(former._dialog.quality, project, survey)
            assert self._dialog is not None
            self._dialog.copy_state_from(former._dialog)

    def _mark(self, title: str, places: Array) -> None:
        """Mark at most `MAX_MARKED_PLACES` of some places, evenly."""
        marked = places[:: -(-len(places) // MAX_MARKED_PLACES)]
        points = tuple((float(x), float(y), float(z)) for x, y, z in marked)
        sketch = Sketch(points, (), MARK_COLOUR, True, title, points[len(points) // 2])
        self._viewport.show_sketch(SKETCH_NAME, sketch)

    def _close_outdated(self) -> None:
        """Close the dialogue if the lines were compared with other data or another boresight."""
        project, survey = self._document.project, self._document.survey
        if self._compared is not None and (
            project is None
            or survey is not self._compared[0]
            or project.result is not self._compared[1]
        ):
            self._close()

    def _close(self) -> None:
        if self._dialog is not None:
            self._dialog.close()

    def _on_closed(self) -> None:
        self._dialog = self._compared = None
        self._viewport.show_sketch(SKETCH_NAME, None)


MethodRuns = tuple[Project, Mapping[str, Message]]
"""Project with the new results, and the reason why a method has no result, by method."""


class AlternativeMethods(QObject):
    """Shows the results of alternative methods and runs those that have none."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        controller: Controller,
        dialogs: StudyDialogs,
        actions: Actions,
    ) -> None:
        super().__init__(actions)
        self._document, self._runner = document, runner
        self._controller, self._dialogs = controller, dialogs
        self._actions = actions
        actions.connect_slots(
            {"methods": self.compare, "correspondences": self.adjust_correspondences}
        )
        for moved in (self._document.changed, self._document.survey_changed, self._runner.changed):
            moved.connect(self._enable_controls)
        self._enable_controls()

    def compare(self, refused: Mapping[str, Message] | None = None) -> None:
        """Show the available results, and run the other methods on request.

        Parameters
        ----------
        refused : reason why a method has no result, by method
        """
        project, survey = self._document.current_data
        if project is None or survey is None:
            return
        run_missing = self._dialogs.methods(
            method_results(project), missing_methods(project), refused or {}
        )
        if run_missing and self._document.project is project:
            self._run_missing(project, survey)

    def adjust_correspondences(self) -> None:
        """Ask for a file of point correspondences, adjust them and compare the result."""
        project, survey = self._document.current_data
        if project is None or survey is None:
            return
        path = self._dialogs.correspondence_file(project.folder)
        if path is None or self._document.project is not project:
            return

        def work(progress: Progress) -> CorrespondenceResult:
            return correspondences(project, survey, path, progress=progress)

        def done(found: CorrespondenceResult) -> None:
            changed = project.with_alternative_result(found.alternative)
            self._document.edit(N_("result of point correspondences"), changed)
            self.compare()

        title = gettext("Adjusting point correspondences")
        task = self._runner.run(title, work, done, modal=True)
        self._controller.cancel_on_edit(task)

    def _run_missing(self, project: Project, survey: Survey) -> None:
        def work(progress: Progress) -> MethodRuns:
            return run_missing_methods(project, survey, progress=progress)

        def done(results: MethodRuns) -> None:
            found, refused = results
            if found is not project:
                self._document.edit(N_("results of alternative methods"), found)
            self.compare(refused)

        task = self._runner.run(gettext("Running alternative methods"), work, done, modal=True)
        self._controller.cancel_on_edit(task)

    def _enable_controls(self) -> None:
        for name in ("methods", "correspondences"):
            self._actions.set_reason(name, data_reason(self._document, self._runner))
