"""Seeds that are not clicked: typed coordinates."""

from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from lispac.project import Project
from lispac.workflow.survey import Survey

if TYPE_CHECKING:
    from lispac.gui.main_window import MainWindow


class Seeding(QObject):
    """Joined to the window's parts."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._document, self._runner = window.document, window.runner
        self._controller, self._dialogs = window.controller, window.dialogs
        self._targets, self._actions = window.targets, window.actions_
        window.actions_["seed_at"].triggered.connect(lambda _=False: self.type_seed())
        window.targets.type_seed.clicked.connect(lambda: self.type_seed())
        for changed in (
            window.document.changed, window.document.survey_changed, window.runner.changed,
        ):  # fmt: skip
            changed.connect(self._enable)
        self._enable()

    def type_seed(self) -> None:
        """Ask for coordinates, and seek the target there."""
        project, survey = self._ready()
        if project is None or survey is None:
            return
        from lispac.workflow.picking import next_name

        wishes = self._targets.wishes
        added = wishes.line is not None and wishes.selected is not None
        name = wishes.selected if added else next_name(project, wishes.role)
        assert name is not None
        answer = self._dialogs.seed_at(project, survey.trajectory, wishes, name)
        if answer is not None and self._document.project is project:
            named, place = answer
            self._controller.seek(place, wishes, name="" if added else named)

    def _ready(self) -> tuple[Project | None, Survey | None]:
        current = self._document.survey_is_current and not self._runner.busy
        return self._document.project, self._document.survey if current else None

    def _enable(self) -> None:
        ready = self._ready()[1] is not None
        self._targets.type_seed.setEnabled(ready)
        self._actions["seed_at"].setEnabled(ready)
