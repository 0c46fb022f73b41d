"""Computations in the background: point counts, georeferencing of the lines."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace

from PySide6.QtCore import QObject, Signal

from lispac.errors import AdjustmentError, Cancelled
from lispac.gui.app.tasks import Task, TaskRunner
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.gui.project.scene import PriorOrEstimated, Scene
from lispac.language import gettext
from lispac.progress import Progress
from lispac.project import Project
from lispac.survey.cloud import Cloud
from lispac.workflow.project.survey import Survey


@dataclass(frozen=True)
class PointCount:
    """Number of points that a point spacing keeps.

    Attributes
    ----------
    kept : number of points kept; None while they are counted, and if they cannot be counted
    total : number of points of the used sightings
    sightings : number of used sightings
    reason : reason why the points cannot be counted, in the language of the window
    """

    kept: int | None
    total: int
    sightings: int
    reason: str = ""


class Computations(QObject):
    """Counts points and georeferences lines in the background."""

    counted = Signal(object)
    """`PointCount` of the current settings."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        scene: Scene,
        controller: Controller,
    ) -> None:
        super().__init__(controller)
        self._document, self._runner, self._scene = document, runner, scene
        self._controller = controller
        self._subsample = 0.0
        self._outdated_count = False
        self._counting: Task | None = None
        runner.idle.connect(self._count_again)

    def count(self, subsample: float) -> None:
        """Count the points that a point spacing, metres, would keep; emits `counted`."""
        self._subsample = subsample
        project, survey = self._document.current_data
        sightings = _used_sightings(project)
        total = sum(len(sighting.indices) for sighting in sightings)
        if project is None or survey is None or not sightings or subsample <= 0:
            self._outdated_count = False
            self.counted.emit(PointCount(total, total, len(sightings)))
            return
        self._outdated_count = True
        self.counted.emit(PointCount(None, total, len(sightings)))
        if self._runner.busy or self._document.awaits_result:
            return  # counted later, when the runner is idle

        def work(_progress: Progress) -> PointCount:
            from lispac.workflow.calibration.estimation import count_points

            try:
                settings = replace(project.settings, subsample=subsample)
                return PointCount(count_points(project, survey, settings), total, len(sightings))
            except AdjustmentError as error:
                return PointCount(None, total, len(sightings), str(error))

        def done(count: PointCount) -> None:
            self._outdated_count = False
            self.counted.emit(count)

        title = gettext("Counting points")
        self._counting = self._runner.run(title, work, done, quiet=True, key="count")

    def show(self, which: PriorOrEstimated) -> None:
        """Show the lines before or after the adjustment; georeference them first if necessary."""
        project, survey = self._document.current_data
        if which == "prior" or self._scene.has_estimated:
            self._scene.show(which)
            return
        if project is None or survey is None or project.result is None:
            self._scene.show("prior")
            return
        # Again if the result has changed meanwhile, as after the recovery of unsaved changes
        self._place_lines(project, survey, lambda: self.show("estimated"), "placed")

    def run_with_placed_lines(
        self, project: Project, survey: Survey, then: Callable[[], None]
    ) -> None:
        """Georeference the lines with the estimated boresight if necessary, then call ``then``.

        An edit of the project cancels the computation.
        """
        if project.result is None or self._scene.has_estimated:
            then()
            return
        task = self._place_lines(project, survey, then)
        self._controller.cancel_on_edit(task)

    def _place_lines(
        self, project: Project, survey: Survey, then: Callable[[], None], key: str = ""
    ) -> Task:
        def done(clouds: Mapping[str, Cloud]) -> None:
            if self._document.project is not None and self._document.survey is survey:
                self._scene.keep_estimated(project.result, clouds)
                then()

        return self._runner.run(
            gettext("Georeferencing the lines with the estimated boresight"),
            lambda progress: survey.displayed_clouds(project, "estimated", progress=progress),
            done,
            key=key,
        )

    def _count_again(self) -> None:
        last = self._counting
        if last is not None and last.error is not None and not isinstance(last.error, Cancelled):
            return  # it would fail again with the same message
        if self._outdated_count:
            self.count(self._subsample)


def _used_sightings(project: Project | None):
    targets = () if project is None else project.targets_of_role("target")
    return [sighting for target in targets for sighting in target.used_sightings]
