"""Help > Manual: built in the background if necessary, and opened in the browser."""

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QUrl
from PySide6.QtGui import QDesktopServices

from lispac.language import current_language, gettext
from lispac.progress import Progress

if TYPE_CHECKING:
    from lispac.gui.window.main_window import MainWindow

PANELS = "panels"
"""The page that has a part for each step, called ``step-1`` to ``step-5``."""


class Manual(QObject):
    """Opens pages of the manual in the browser."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._runner, self._controller = window.runner, window.controller
        window.actions_["manual"].triggered.connect(lambda _=False: self.open())
        window.actions_["manual_step"].triggered.connect(
            lambda _=False: self.open(PANELS, f"step-{window.workflow.opened + 1}")
        )

    def open(self, page: str = "index", place: str = "") -> None:
        """Show a page of the manual, or a place on it, in the language of the window."""
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
