"""Help > Manual: built in the background if necessary, and opened in the browser."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, QUrl
from PySide6.QtGui import QDesktopServices

from lispac.gui.app.actions import Actions
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.project.controller import Controller
from lispac.language import current_language, gettext
from lispac.progress import Progress

STEPS_PAGE = "panels"
"""Page of the manual with a section for each step; its anchors are ``step-1`` to ``step-5``."""


class Manual(QObject):
    """Opens pages of the manual in the browser.

    Parameters
    ----------
    opened_step : function that returns the step shown in the window, counted from 0
    """

    def __init__(
        self,
        runner: TaskRunner,
        controller: Controller,
        actions: Actions,
        opened_step: Callable[[], int],
    ) -> None:
        super().__init__(actions)
        self._runner, self._controller = runner, controller
        actions.connect_slots(
            {
                "manual": self.open,
                "manual_step": lambda: self.open(STEPS_PAGE, f"step-{opened_step() + 1}"),
            }
        )

    def open(self, page: str = "index", place: str = "") -> None:
        """Show a page of the manual, at the anchor ``place``, in the language of the window."""
        code = current_language()

        def work(progress: Progress) -> Path:
            from lispac.workflow.output.manual import manual_page

            return manual_page(code, page, progress=progress)

        self._runner.run(
            gettext("Opening the manual"), work, lambda file: self._open_in_browser(file, place)
        )

    def _open_in_browser(self, file: Path, place: str) -> None:
        url = QUrl.fromLocalFile(str(file))
        if place:
            url.setFragment(place)
        if not QDesktopServices.openUrl(url):
            self._controller.logged.emit(gettext("No program is set up to open {file}.", file=file))
