"""Search for targets to propose, and the proposal that waits for the user."""

from collections.abc import Collection
from typing import TYPE_CHECKING

from PySide6.QtCore import QSignalBlocker, Signal

from lispac.gui.features.pick_targets.target_actions import SurveyDependentActions, TargetTools
from lispac.gui.project.scene import Scene
from lispac.language import N_, gettext
from lispac.picked_targets import Target, Triple
from lispac.progress import Progress
from lispac.project import Project
from lispac.workflow.project.survey import Survey

if TYPE_CHECKING:
    from lispac.workflow.calibration.proposals import Proposal


class ProposedTargets(SurveyDependentActions):
    """Proposes targets in the panel and the scene, until the user adds or rejects them."""

    shown = Signal()
    """A proposal waits for the user."""

    def __init__(self, tools: TargetTools, scene: Scene) -> None:
        self._found: tuple[Proposal, Survey] | None = None
        self._left: Proposal | None = None
        self._shown: tuple[Project | None, Target | None] = (None, None)
        """Project and candidate for which the proposal was shown."""
        super().__init__(tools, [tools.panel.propose], ["propose"])
        self._scene, self._panel = scene, tools.panel.proposal
        tools.panel.propose_requested.connect(tools.actions["propose"].trigger)
        tools.actions.connect_slots({"propose": self.propose})
        self._panel.accepted.connect(self._accept)
        self._panel.rejected.connect(self._reject)
        self._panel.ticks_changed.connect(self._show_in_scene)
        self._panel.selected.connect(self._scene.select_proposed)
        self._panel.zoom_requested.connect(self._scene.zoom_to_proposed)
        self._document.changed.connect(self._update)
        self._controller.candidate_changed.connect(self._update)
        self._document.about_to_open.connect(self._close)

    def copy_state_from(self, former: "ProposedTargets") -> None:
        """Show what is left of the proposal of a former window, with its ticks and its row."""
        if former._found is not None:
            self._found = former._found
            self._show_remaining(former._unticked_seeds())
            self._panel.table.selectRow(former._panel.table.currentRow())

    def propose(self) -> None:
        """Detect planes in all lines and propose targets."""
        project, survey = self._current_data()
        if project is None or survey is None:
            return

        def work(progress: Progress) -> "Proposal":
            from lispac.workflow.calibration.proposals import propose_targets

            return propose_targets(project, survey, progress=progress)

        task = self._runner.run(
            gettext("Searching for targets to propose"),
            work,
            lambda proposal: self._show(proposal, survey),
            modal=True,
            has_time_left=False,  # the number of rounds is unknown
        )
        self._controller.cancel_on_edit(task)

    def _show(self, proposal: "Proposal", survey: Survey) -> None:
        self._found, self._shown = (proposal, survey), (None, None)
        self._update()
        if self._left is None:
            self._controller.logged.emit(gettext("No other suitable targets were found."))
        else:
            self.shown.emit()
            self._panel.table.setFocus()

    def _update(self) -> None:
        """Show what is left of the proposal after a change of the project or the candidate."""
        project, candidate = self._shown
        if self._found is None or (
            self._document.project is project and self._controller.candidate is candidate
        ):
            return
        if self._document.project is None or self._document.survey is not self._found[1]:
            self._close()  # other points
            return
        self._show_remaining(self._unticked_seeds())

    def _show_remaining(self, unticked: Collection[Triple]) -> None:
        from lispac.workflow.calibration.proposal_acceptance import remove_picked_surfaces

        project, candidate = self._document.project, self._controller.candidate
        if self._found is None or project is None:
            return
        found, _ = self._found
        self._shown = (project, candidate)
        # The candidate has a name of its own and may be on a proposed surface
        used = project if candidate is None else project.with_target(candidate)
        self._left = remove_picked_surfaces(used, found)
        if not self._left.targets:
            self._close() if candidate is None else self._hide()
            return
        existing = [each.name for each in project.targets_of_role("target") if each.used]
        self._targets.show_proposal(True)
        if candidate is None:
            self._panel.show_proposal(self._left, unticked, existing)
            return
        with QSignalBlocker(self._panel):  # the candidate remains selected in the scene
            self._panel.show_proposal(self._left, unticked, existing)
        self._show_in_scene()

    def _unticked_seeds(self) -> set[Triple]:
        ticked = self._panel.ticked_entries
        targets = self._left.targets if self._left is not None else ()
        return {target.seed for target in targets if target.name not in ticked}

    def _show_in_scene(self) -> None:
        if self._left is not None:
            self._scene.show_proposed(self._left.targets, self._panel.ticked_entries)

    def _accept(self) -> None:
        from lispac.workflow.calibration.proposal_acceptance import with_accepted_targets

        project, proposal, names = self._document.project, self._left, self._panel.ticked_entries
        if project is None or proposal is None:
            return
        self._close()
        edited, accepted = with_accepted_targets(project, proposal, names)
        self._document.edit(N_("addition of proposed targets"), edited)
        self._controller.logged.emit(gettext("Accepted {targets:names}", targets=accepted))

    def _reject(self) -> None:
        self._close()
        self._controller.logged.emit(gettext("The proposed targets were rejected."))

    def _close(self) -> None:
        self._found = self._left = None
        self._hide()

    def _hide(self) -> None:
        self._targets.show_proposal(False)
        self._scene.show_proposed((), ())
