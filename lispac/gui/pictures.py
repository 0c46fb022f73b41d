"""Pictures of the view and of the section: written to a file, or copied to be pasted elsewhere."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject
from PySide6.QtGui import QGuiApplication

from lispac.errors import InputError, LispacError
from lispac.gui import units
from lispac.gui.actions import Actions
from lispac.gui.dialogs.service import Dialogs
from lispac.gui.document import Document
from lispac.gui.panels.section import SectionPanel
from lispac.gui.viewport.base import Viewport

NO_SECTION = "There is no section to take a picture of: select a target and press S"


class Pictures(QObject):
    """Takes them as they are shown, and tells where they went."""

    def __init__(
        self,
        document: Document,
        viewport: Viewport,
        section: SectionPanel,
        actions: Actions,
        dialogs: Dialogs,
        note: Callable[[str], None],
        refuse: Callable[[LispacError], None],
    ) -> None:
        super().__init__(actions)
        self._document, self._viewport, self._section = document, viewport, section
        self._dialogs, self._note, self._refuse = dialogs, note, refuse
        actions["picture"].triggered.connect(lambda _=False: self._save_view())
        actions["copy_picture"].triggered.connect(lambda _=False: self._copy_view())
        actions["section_picture"].triggered.connect(lambda _=False: self._save_section())
        actions["copy_section"].triggered.connect(lambda _=False: self._copy_section())
        section.picture_asked.connect(actions["section_picture"].trigger)
        section.copy_asked.connect(actions["copy_section"].trigger)

    def _save_view(self) -> None:
        path = self._dialogs.picture_file(self._start("view"), ("PNG",))
        if path is not None:
            with units.standard():
                self._write(path, self._viewport.screenshot)

    def _copy_view(self) -> None:
        QGuiApplication.clipboard().setImage(self._viewport.picture())
        self._note("The picture of the view is in the clipboard")

    def _save_section(self) -> None:
        if not self._section.shows:
            self._note(NO_SECTION)
            return
        start = self._start(f"section-{self._section.through.text()}")
        path = self._dialogs.picture_file(start, ("PNG", "SVG", "PDF"))
        if path is not None:
            self._write(path, self._section.save)

    def _copy_section(self) -> None:
        if not self._section.shows:
            self._note(NO_SECTION)
            return
        QGuiApplication.clipboard().setImage(self._section.picture())
        self._note("The picture of the section is in the clipboard")

    def _write(self, path: Path, write: Callable[[Path], None]) -> None:
        try:
            write(path)
        except InputError as error:
            self._refuse(error)
            return
        self._note(f"Wrote {path}")

    def _start(self, what: str) -> Path:
        """A name to begin with, in the project's folder."""
        project = self._document.project
        words = "".join(c if c.isalnum() else "-" for c in what.lower())
        if project is None:
            return Path.home() / f"{words}.png"
        return project.folder / f"{project.name}-{words}.png"
