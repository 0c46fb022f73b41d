"""Help > Manual: built in the background where it has to be, and opened in the browser."""

from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QUrl
from PySide6.QtGui import QDesktopServices

from lispac.gui.language import language
from lispac.progress import Progress

if TYPE_CHECKING:
    from lispac.gui.main_window import MainWindow


class Manual(QObject):
    """Joined to the window's parts."""

    def __init__(self, window: "MainWindow") -> None:
        super().__init__(window)
        self._runner, self._controller = window.runner, window.controller
        window.actions_["manual"].triggered.connect(lambda _=False: self.open())

    def open(self) -> None:
        """Show its first page, in the language of the window."""
        wanted = language()

        def work(progress: Progress) -> Path:
            from lispac.workflow.manual import manual_page

            return manual_page(wanted, progress=progress)

        self._runner.run("Opening the manual", work, self._show)

    def _show(self, file: Path) -> None:
        if not QDesktopServices.openUrl(QUrl.fromLocalFile(str(file))):
            self._controller.noted.emit(f"No program is set up to open {file}")
