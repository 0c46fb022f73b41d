"""Actions on targets besides picking: rate, search again, change the role."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from PySide6.QtCore import QObject, Signal

from lispac.errors import LispacError
from lispac.gui.app.actions import Actions
from lispac.gui.app.tasks import Task, TaskRunner
from lispac.gui.app.unavailable import Unavailable, first_reason, reason_text
from lispac.gui.features.pick_targets.dialogs import TargetDialogs
from lispac.gui.features.pick_targets.sightings_table import SightingsTable
from lispac.gui.features.pick_targets.targets_panel import TargetsPanel
from lispac.gui.project.availability import data_reason
from lispac.gui.project.controller import Controller
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.widgets import Button
from lispac.language import N_, gettext
from lispac.progress import Progress
from lispac.project import Project, Target
from lispac.targets.sighting_quality import SightingQuality
from lispac.workflow.calibration import edits
from lispac.workflow.calibration.sighting_assessment import (
    AssessedQuality,
    SightingKey,
    assess_sightings,
)
from lispac.workflow.project.survey import Survey


class QualityComputation(QObject):
    """Updates the quality of every sighting after changes of the project."""

    qualities_changed = Signal(object)
    """Qualities known so far, by the names of target and line."""
    candidate_rated = Signal(object)
    """Qualities of the candidate, by line."""

    def __init__(self, document: Document, runner: TaskRunner, parent: QObject) -> None:
        super().__init__(parent)
        self._document, self._runner = document, runner
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
        known = self._document.qualities
        current: dict[SightingKey, SightingQuality] = {}
        for target in () if project is None else project.targets:
            for sighting in target.sightings:
                each = known.get((target.name, sighting.line))
                if each is None or each.indices is not sighting.indices:
                    continue
                if waits or each.is_current(project, target, sighting):
                    current[target.name, sighting.line] = each.quality
        return current

    def _emit_qualities(self) -> None:
        self.qualities_changed.emit(self._current_qualities())

    def _rate_sightings(self) -> None:
        document, known = self._document, self._document.qualities
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
            document.keep_qualities(survey, rated)
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
            # They remain valid after acceptance
            self._document.keep_qualities(survey, {**rated, **self._document.qualities})
            self.candidate_rated.emit({line: each.quality for (_, line), each in rated.items()})

        title = gettext("Computing the quality of {target}", target=candidate.name)
        task = self._runner.run(title, work, done, quiet=True, key="candidate")
        self._candidate_request = task, candidate
        return True


@dataclass(frozen=True, eq=False)
class TargetTools:
    """Objects that all actions on targets use."""

    document: Document
    runner: TaskRunner
    controller: Controller
    dialogs: TargetDialogs
    actions: Actions
    panel: TargetsPanel


class SurveyDependentActions(QObject):
    """Actions that need a loaded survey and an idle program, with their buttons.

    Parameters
    ----------
    buttons, names : buttons, and names of actions, that are enabled in that case
    """

    def __init__(self, tools: TargetTools, buttons: Sequence[Button], names: Sequence[str]) -> None:
        super().__init__(tools.actions)
        self._buttons, self._names = buttons, names
        self._document, self._runner = tools.document, tools.runner
        self._controller, self._dialogs = tools.controller, tools.dialogs
        self._targets, self._actions = tools.panel, tools.actions
        for changed in (
            self._document.changed, self._document.survey_changed, self._runner.changed,
            self._targets.current_changed,
        ):  # fmt: skip
            changed.connect(self._enable_controls)
        self._enable_controls()

    def _current_data(self) -> tuple[Project | None, Survey | None]:
        project, survey = self._document.current_data
        return project, None if self._runner.busy else survey

    def _enable_controls(self) -> None:
        reason = data_reason(self._document, self._runner)
        for button in self._buttons:
            button.set_reason(reason_text(reason))
        for name in self._names:
            self._actions.set_reason(name, reason)


class TargetActions(SurveyDependentActions):
    """Controls repeated searches and the quality of targets."""

    def __init__(self, tools: TargetTools, table: SightingsTable) -> None:
        super().__init__(tools, [], [])
        controller, panel, actions = tools.controller, tools.panel, tools.actions
        self.quality_computation = QualityComputation(tools.document, tools.runner, self)
        self.quality_computation.qualities_changed.connect(table.sightings.show_qualities)
        self.quality_computation.candidate_rated.connect(panel.candidate.show_qualities)
        controller.candidate_changed.connect(
            lambda: self.quality_computation.rate_candidate(controller.candidate)
        )
        panel.accepted.connect(controller.accept)
        panel.rejected.connect(controller.reject)
        panel.removed.connect(controller.remove)
        panel.used_changed.connect(controller.use_target)
        panel.role_changed.connect(
            lambda role: actions[
                "seed_validation" if role == "validation" else "seed_target"
            ].setChecked(True)
        )
        table.sightings.target_use_changed.connect(controller.use_target)
        table.sightings.sighting_use_changed.connect(controller.use_sighting)
        table.sightings.line_use_changed.connect(controller.use_line)
        actions.connect_slots(
            {
                "find_again": self.find_again,
                "accept": controller.accept,
                "reject": controller.reject,
            }
        )

    def find_again(self) -> None:
        """Search for the selected target at its seed with other settings."""
        project, survey = self._current_data()
        name = self._targets.current
        if project is None or survey is None or name is None:
            return
        target = project.target(name)
        settings = self._dialogs.find_again(target)
        if settings is None:
            return
        threshold, radius, choices = settings

        def work(progress: Progress) -> Target:
            from lispac.workflow.calibration import picking

            found = picking.find_target(
                project, survey, target.seed, name=target.name, role=target.role,
                shape=target.shape, sphere_radius=target.sphere_radius, threshold=threshold,
                radius=radius, expected=target.expected, choices=choices, progress=progress,
            )  # fmt: skip
            return _with_exclusions_of(found, target)

        title = gettext("Searching for {target} again", target=name)
        task = self._runner.run(title, work, self._controller.set_candidate)
        self._controller.cancel_on_edit(task)

    def _enable_controls(self) -> None:
        super()._enable_controls()
        nothing_selected = self._targets.current is None
        self._actions.set_reason(
            "find_again",
            data_reason(self._document, self._runner)
            or first_reason((nothing_selected, Unavailable.NO_SELECTION)),
        )


def _with_exclusions_of(target: Target, before: Target) -> Target:
    """Exclude ``target`` and its sightings as they are excluded in ``before``."""
    excluded = {sighting.line for sighting in before.sightings if not sighting.used}
    sightings = tuple(replace(s, used=s.line not in excluded) for s in target.sightings)
    return replace(target, used=before.used, sightings=sightings)


NOTHING_SELECTED_TEXT = N_("Select a target or validation plane first, then change its role.")


class TargetRoles(QObject):
    """Changes a target into a validation plane, or the reverse."""

    def __init__(
        self,
        document: Document,
        scene: Scene,
        actions: Actions,
        note: Callable[[str], None],
        refuse: Callable[[LispacError], None],
    ) -> None:
        super().__init__(actions)
        self._document, self._scene = document, scene
        self._note, self._refuse = note, refuse
        actions["change_role"].triggered.connect(lambda _=False: self._change_role())

    def _change_role(self) -> None:
        project, selected = self._document.project, self._scene.selected
        if project is None or selected is None or not self._scene.selected_points:
            self._note(gettext(NOTHING_SELECTED_TEXT))
            return
        name = selected[0]
        try:
            edited = edits.with_switched_role(project, name)
        except LispacError as error:
            self._refuse(error)
            return
        self._document.edit(N_("change of role of {target}"), edited, target=name)
        if edited.target(name).role == "validation":
            self._note(gettext("{target} is now a validation plane.", target=name))
        else:
            self._note(gettext("{target} is now a target.", target=name))
