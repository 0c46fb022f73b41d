"""Dialogues about seeds and targets."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QFileDialog, QFormLayout, QHBoxLayout, QLayout, QWidget

from lispac.gui import widgets
from lispac.gui.app.actions import dialog_title
from lispac.gui.app.questions import Questions, run_dialog
from lispac.gui.features.pick_targets.actions import ACTIONS
from lispac.gui.features.pick_targets.search_option_fields import SearchOptionFields
from lispac.gui.project.seed_options import SeedOptions
from lispac.gui.widgets.number_input import NumberDialog
from lispac.language import gettext
from lispac.project import Project, Target, Triple
from lispac.targets.finder_settings import FinderChoices

if TYPE_CHECKING:
    from lispac.survey.trajectory import LocalTrajectory
    from lispac.workflow.calibration.seed_lists import ListedSeed, SeedOutcome


class FindAgainDialog(NumberDialog):
    """Dialogue with the settings with which the target was found, to search again."""

    def __init__(self, target: Target, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("find_again_dialog")
        self.setWindowTitle(dialog_title(ACTIONS["find_again"]))
        layout = widgets.vertical_layout(self, 16)
        layout.setSizeConstraint(QLayout.SizeConstraint.SetFixedSize)  # adapts to folding
        introduction = gettext(
            "With these settings, {target} is searched for again on all lines, starting from its "
            "seed. The result is shown before it replaces the current target.",
            target=target.name,
        )
        layout.addWidget(widgets.label(introduction, wrap=True))
        self._threshold = widgets.number(
            "again_threshold", suffix=" mm", decimals=0, low=1, high=1000, step=5,
            tip=gettext(
                "Largest distance between a point of the target and the fitted plane or sphere. A "
                "smaller value excludes rough edges, a larger one accepts rough or noisy surfaces."
            ),
        )  # fmt: skip
        self._threshold.setValue(1000 * target.threshold)
        self._radius = widgets.number(
            "again_radius", suffix=" m", decimals=2, low=0.05, high=100, step=0.25,
            tip=gettext("Largest distance of a point of the target from the seed"),
        )  # fmt: skip
        self._radius.setValue(target.radius)
        form = QFormLayout()
        form.addRow(gettext("Threshold"), self._threshold)
        form.addRow(gettext("Search radius"), self._radius)
        layout.addLayout(form)
        self._search_fields = SearchOptionFields("again")
        self._search_fields.show_value(target.choices)
        layout.addWidget(self._search_fields)
        find = widgets.button(gettext("Find"), "again_find", primary=True)
        find.setDefault(True)
        find.clicked.connect(self.accept)
        cancel = widgets.button(gettext("Cancel"), "again_cancel")
        cancel.clicked.connect(self.reject)
        row = QHBoxLayout()
        row.addStretch(1)
        for each in widgets.in_platform_order(find, cancel):
            row.addWidget(each)
        layout.addLayout(row)

    @property
    def settings(self) -> tuple[float, float, FinderChoices]:
        """Threshold and search radius, metres, and the other settings."""
        return self._threshold.value() / 1000, self._radius.value(), self._search_fields.value


class TargetDialogs(Questions):
    """Dialogues about seeds and targets."""

    def find_again(self, target: Target) -> tuple[float, float, FinderChoices] | None:
        """Ask for threshold and radius (metres) and other settings of a repeated search."""
        dialog = FindAgainDialog(target, self.parent)
        return dialog.settings if run_dialog(dialog) else None

    def seed_coordinates(
        self, project: Project, trajectory: "LocalTrajectory", seed_options: SeedOptions, name: str
    ) -> tuple[str, Triple] | None:
        """Ask for the name and coordinates of a seed; ``name`` is proposed."""
        from lispac.gui.features.pick_targets.seed_coordinates import SeedCoordinatesDialog

        dialog = SeedCoordinatesDialog(project, trajectory, seed_options, name, self.parent)
        return dialog.seed if run_dialog(dialog) else None

    def seed_list_file(self, start: Path) -> Path | None:
        """Ask for the file of a list of target coordinates."""
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
        self, path: Path, project: Project, trajectory: "LocalTrajectory", search_text: str
    ) -> "tuple[ListedSeed, ...]":
        """Ask which seeds of a list are used; ``search_text`` describes the search."""
        from lispac.gui.features.pick_targets.seed_list import SeedListDialog

        dialog = SeedListDialog(path, project, trajectory, search_text, self.parent)
        return dialog.ticked_entries if run_dialog(dialog) else ()

    def seeds_found(self, outcomes: "Sequence[SeedOutcome]", lines: int) -> None:
        """Show which seeds of a list led to a target."""
        from lispac.gui.features.pick_targets.seed_list import SeedsFoundDialog

        run_dialog(SeedsFoundDialog(outcomes, lines, self.parent))
