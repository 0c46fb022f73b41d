"""Seeds from typed coordinates and from lists of coordinates."""

from pathlib import Path
from typing import TYPE_CHECKING

from lispac.gui.app.questions import CandidateChoice
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.pick_targets.target_actions import SurveyDependentActions, TargetTools
from lispac.gui.project.seed_options import SeedOptions
from lispac.language import N_, Plural, gettext
from lispac.progress import Progress
from lispac.project import Project

if TYPE_CHECKING:
    from lispac.workflow.calibration.seed_lists import SeedOutcome

SeedOutcomes = tuple[Project, tuple["SeedOutcome", ...]]


class SeedActions(SurveyDependentActions):
    """Actions that ask for seeds and search for their targets."""

    def __init__(self, tools: TargetTools) -> None:
        super().__init__(
            tools,
            [tools.panel.type_seed, tools.panel.list_seeds],
            ["seed_coordinates", "seed_list"],
        )
        tools.actions.connect_slots(
            {"seed_coordinates": self.type_seed, "seed_list": self.list_seeds}
        )
        tools.panel.type_seed.clicked.connect(tools.actions["seed_coordinates"].trigger)
        tools.panel.list_seeds.clicked.connect(tools.actions["seed_list"].trigger)

    def type_seed(self) -> None:
        """Ask for coordinates and search for the target there."""
        if not self._controller.resolve_candidate(self._ask_about_candidate):
            return
        project, survey = self._current_data()
        if project is None or survey is None:
            return
        from lispac.workflow.calibration.picking import next_name

        seed_options = self._targets.seed_options
        added = seed_options.line is not None and seed_options.selected is not None
        name = seed_options.selected if added else next_name(project, seed_options.role)
        assert name is not None
        entered = self._dialogs.seed_coordinates(project, survey.trajectory, seed_options, name)
        if entered is not None and self._document.project is project:
            named, place = entered
            self._controller.search_at(place, seed_options, name="" if added else named)

    def _ask_about_candidate(self, name: str) -> CandidateChoice:
        return self._dialogs.ask_about_candidate(name, is_search=True)

    def list_seeds(self, path: Path | None = None) -> None:
        """Show a list of coordinates and search for the ticked targets, as one undo step.

        Parameters
        ----------
        path : Path, optional
            File of the list; the user is asked for it if it is not given.
        """
        if not self._controller.resolve_candidate(self._ask_about_candidate):
            return
        project, survey = self._current_data()
        if project is None or survey is None:
            return
        path = path or self._dialogs.seed_list_file(project.folder)
        if path is None:
            return
        seed_options = self._targets.seed_options
        seeds = self._dialogs.seed_list(
            path, project, survey.trajectory, _search_summary(seed_options)
        )
        if not seeds or self._document.project is not project:
            return

        def work(progress: Progress) -> SeedOutcomes:
            from lispac.workflow.calibration.seed_lists import pick_seeds

            return pick_seeds(
                project, survey, seeds, seed_options.finder_arguments, progress=progress
            )

        def done(picked: SeedOutcomes) -> None:
            edited, outcomes = picked
            self._apply_outcomes(path, edited, outcomes)

        title = Plural(
            "Searching for the target of {count:n} seed of {file}",
            "Searching for the targets of {count:n} seeds of {file}",
        )
        text = gettext(title, count=len(seeds), file=path.name)
        task = self._runner.run(text, work, done, modal=True)
        self._controller.cancel_on_edit(task)

    def _apply_outcomes(
        self, path: Path, edited: Project, outcomes: "tuple[SeedOutcome, ...]"
    ) -> None:
        from lispac.workflow.calibration.target_search import thinned_notes

        names = [outcome.seed.name for outcome in outcomes if outcome.target is not None]
        for outcome in outcomes:
            for each in thinned_notes(outcome.target) if outcome.target else ():
                self._controller.logged.emit(message_text(each))
        if names:
            self._document.edit(N_("addition of targets from {file}"), edited, file=path.name)
        found = Plural(
            "{file}: a target was found for {found:n} of {count:n} seed",
            "{file}: targets were found for {found:n} of {count:n} seeds",
        )
        self._controller.logged.emit(
            gettext(found, file=path.name, found=len(names), count=len(outcomes))
        )
        self._dialogs.seeds_found(outcomes, len(edited.lines))


def _search_summary(seed_options: SeedOptions) -> str:
    """Text on how the targets of a list are searched for."""
    if seed_options.shape == "plane":
        return gettext(
            "Planes are searched for in all lines, with the search radius, the threshold and the "
            "other settings of step 2."
        )
    return gettext(
        "Spheres, and planes for validation, are searched for in all lines, with the search "
        "radius, the threshold and the other settings of step 2."
    )
