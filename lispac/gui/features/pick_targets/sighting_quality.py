"""Quality of the sightings, computed in the background while no other task runs."""

from collections.abc import Mapping
from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from lispac.gui.app.tasks import Task, TaskRunner
from lispac.gui.project.document import Document
from lispac.language import gettext
from lispac.progress import Progress
from lispac.project import Project, Target
from lispac.targets.sighting_quality import SightingQuality
from lispac.workflow.calibration.sighting_assessment import AssessedQuality, assess_sightings
from lispac.workflow.project.survey import Survey

SightingKey = tuple[str, str]


class QualityComputation(QObject):
    """Updates the quality of every sighting after changes of the project."""

    qualities_changed = Signal(object)
    """Qualities known so far, by the names of target and line."""
    candidate_rated = Signal(object)
    """Qualities of the candidate, by line."""

    def __init__(self, document: Document, runner: TaskRunner, parent: QObject) -> None:
        super().__init__(parent)
        self._document, self._runner = document, runner
        self._known: Mapping[SightingKey, AssessedQuality] = {}
        self._request: tuple[Task, Project] | None = None
        self._candidate: Target | None = None
        self._candidate_request: tuple[Task, Target] | None = None
        document.changed.connect(self._on_document_changed)
        runner.idle.connect(self._rate_sightings)

    def _on_document_changed(self) -> None:
        self._emit_qualities()
        if not self._runner.active:
            self._rate_sightings()

    def rate_candidate(self, candidate: Target | None) -> None:
        """Rate a candidate before it is accepted."""
        self._candidate = candidate
        if not self._runner.active:
            self._rate_sightings()

    def _current_qualities(self) -> dict[SightingKey, SightingQuality]:
        """Known qualities that are valid for the current sightings.

        While a new result is being computed, the qualities for the last result are kept, since a
        new result changes them little.
        """
        project, waits = self._document.project, self._document.awaits_result
        current: dict[SightingKey, SightingQuality] = {}
        for target in () if project is None else project.targets:
            for sighting in target.sightings:
                each = self._known.get((target.name, sighting.line))
                if each is None or each.indices is not sighting.indices:
                    continue
                if waits or each.is_current(project, target, sighting):
                    current[target.name, sighting.line] = each.quality
        return current

    def _emit_qualities(self) -> None:
        self.qualities_changed.emit(self._current_qualities())

    def _rate_sightings(self) -> None:
        document, known = self._document, self._known
        project, survey = document.project, document.survey
        if project is None or survey is None or not document.is_survey_current:
            return
        if self._runner.active or document.awaits_result:
            return  # the runner emits a signal when it is idle
        if self._candidate is not None and self._start_candidate_rating(
            self._candidate, project, survey
        ):
            return
        task, requested = self._request or (None, None)
        if task is not None and requested is project and not task.superseded:
            return  # it failed, or was cancelled by the user
        if len(self._current_qualities()) == sum(
            len(target.sightings) for target in project.targets
        ):
            return

        def work(progress: Progress) -> dict[SightingKey, AssessedQuality]:
            return assess_sightings(project, survey, known=known, progress=progress)

        def done(rated: dict[SightingKey, AssessedQuality]) -> None:
            self._known = rated
            self._emit_qualities()

        title = gettext("Computing the quality of the sightings")
        task = self._runner.run(title, work, done, quiet=True, key="quality")
        self._request = (task, project)

    def _start_candidate_rating(self, candidate: Target, project: Project, survey: Survey) -> bool:
        """Start to rate the candidate, unless done or failed; return whether it was started."""
        task, requested = self._candidate_request or (None, None)
        if task is not None and requested is candidate and not task.superseded:
            return False

        def work(progress: Progress) -> dict[SightingKey, AssessedQuality]:
            alone = replace(project, targets=(candidate,))
            return assess_sightings(alone, survey, progress=progress)

        def done(rated: dict[SightingKey, AssessedQuality]) -> None:
            if self._candidate is not candidate:
                return
            self._known = {**rated, **self._known}  # remains valid after acceptance
            self.candidate_rated.emit({line: each.quality for (_, line), each in rated.items()})

        title = gettext("Computing the quality of {target}", target=candidate.name)
        task = self._runner.run(title, work, done, quiet=True, key="candidate")
        self._candidate_request = task, candidate
        return True
