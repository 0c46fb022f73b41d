"""Dialogues about seeds and targets."""

from collections.abc import Sequence
from pathlib import Path

from PySide6.QtWidgets import QFileDialog

from lispac.gui.app.actions import dialog_title
from lispac.gui.app.questions import Questions, run_dialog
from lispac.gui.features.pick_targets.actions import ACTIONS
from lispac.gui.features.pick_targets.find_again_dialog import FindAgainDialog
from lispac.gui.features.pick_targets.proposal_dialog import ProposedTargetsDialog
from lispac.gui.features.pick_targets.seed_at import SeedDialog
from lispac.gui.features.pick_targets.seed_list import SeedListDialog, SeedsFoundDialog
from lispac.gui.project.seed_options import SeedOptions
from lispac.language import gettext
from lispac.project import Project, Target, Triple
from lispac.survey.trajectory import LocalTrajectory
from lispac.targets.finder_settings import FinderChoices
from lispac.workflow.calibration.proposals import Proposal
from lispac.workflow.calibration.seed_lists import ListedSeed, SeedOutcome


class TargetDialogs(Questions):
    """Dialogues about seeds and targets."""

    def proposal(self, proposal: Proposal) -> tuple[str, ...]:
        """Names of the accepted targets of a proposal."""
        dialog = ProposedTargetsDialog(proposal, self.parent)
        return dialog.ticked_entries if run_dialog(dialog) else ()

    def find_again(self, target: Target) -> tuple[float, float, FinderChoices] | None:
        """Threshold and search radius (metres) and other settings to find a target again."""
        dialog = FindAgainDialog(target, self.parent)
        return dialog.settings if run_dialog(dialog) else None

    def seed_at(
        self, project: Project, trajectory: LocalTrajectory, seed_options: SeedOptions, name: str
    ) -> tuple[str, Triple] | None:
        """Name and place of a typed seed; ``name`` is proposed."""
        dialog = SeedDialog(project, trajectory, seed_options, name, self.parent)
        return dialog.seed if run_dialog(dialog) else None

    def seed_list_file(self, start: Path) -> Path | None:
        """A list of target coordinates."""
        name, _ = QFileDialog.getOpenFileName(
            self.parent, dialog_title(ACTIONS["seed_list"]), str(start),
            ";;".join(
                [
                    gettext(
                        "Lists of coordinates ({patterns})",
                        patterns="*.txt *.csv *.asc *.xyz *.pts *.dat",
                    ),
                    gettext("All files (*)"),
                ]
            ),
        )  # fmt: skip
        return Path(name) if name else None

    def seed_list(
        self, path: Path, project: Project, trajectory: LocalTrajectory, how: str
    ) -> tuple[ListedSeed, ...]:
        """Seeds of a list to pick; ``how`` describes the search."""
        dialog = SeedListDialog(path, project, trajectory, how, self.parent)
        return dialog.ticked_entries if run_dialog(dialog) else ()

    def seeds_found(self, outcomes: Sequence[SeedOutcome], lines: int) -> None:
        """Show which seeds of a list led to a target."""
        run_dialog(SeedsFoundDialog(outcomes, lines, self.parent))
