"""Studies that change nothing: calibrations over the years, and the distance between points."""

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject

from lispac.gui.panels.histograms import preload
from lispac.progress import Progress
from lispac.workflow.history import History, histories
from lispac.workflow.subsampling import USUAL, Subsampled, subsampling_study

if TYPE_CHECKING:
    from lispac.gui.main_window import MainWindow


class Studies(QObject):
    """Joined to the window's parts."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._document, self._runner = window.document, window.runner
        self._controller, self._dialogs = window.controller, window.dialogs
        self._actions = window.actions_
        self._actions["history"].triggered.connect(lambda _=False: self.history())
        self._actions["subsampling"].triggered.connect(lambda _=False: self.subsampling())
        for moved in (self._document.changed, self._document.survey_changed, self._runner.changed):
            moved.connect(self._enable)
        self._enable()

    def history(self) -> None:
        """Show the calibrations of a vessel's system in a folder of projects."""
        project = self._document.project
        start = Path.home() if project is None else project.folder.parent
        folder = self._dialogs.folder_of_projects(start)
        if folder is None:
            return

        def work(progress: Progress) -> tuple[tuple[History, ...], tuple[str, ...]]:
            preload()
            # An answer that is not saved yet counts too.
            current = [] if project is None or project.result is None else [project]
            return histories([folder], also=current, progress=progress)

        self._runner.run(
            "Reading the calibrations", work, lambda found: self._dialogs.history(*found)
        )

    def subsampling(self) -> None:
        """Adjust with points nearer together and farther apart."""
        project = self._document.project
        survey = self._document.survey if self._document.survey_is_current else None
        if project is None or survey is None:
            return
        used = project.settings.subsample

        def work(progress: Progress) -> tuple[Subsampled, ...]:
            return subsampling_study(project, survey, sorted({*USUAL, used}), progress=progress)

        task = self._runner.run(
            "Studying the distance between points", work,
            lambda found: self._dialogs.subsampling(found, used),
        )  # fmt: skip
        self._controller.based_on_project(task)

    def _enable(self) -> None:
        project, busy = self._document.project, self._runner.busy
        picked = project is not None and bool(project.of_role("target"))
        self._actions["history"].setEnabled(not busy)
        self._actions["subsampling"].setEnabled(
            picked and self._document.survey_is_current and not busy
        )
