"""Pictures of the view and of the section, saved to a file or copied to the clipboard."""

from collections.abc import Callable
from io import BytesIO
from pathlib import Path

from PySide6.QtCore import QObject
from PySide6.QtGui import QGuiApplication, QImage

from lispac.errors import InputError
from lispac.gui.app.actions import Actions
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.appearance import units
from lispac.gui.features.inspect.dialogs import PictureDialogs
from lispac.gui.features.inspect.section_panel import SectionPanel
from lispac.gui.project.document import Document
from lispac.gui.viewport.base import Viewport
from lispac.installation_paths import home_folder
from lispac.io.files import atomic_write
from lispac.language import N_, gettext
from lispac.messages import error
from lispac.progress import Progress

NO_SECTION_TEXT = N_("No section is shown. Select a target and press S.")


class PictureExport(QObject):
    """Saves or copies the view and the section as displayed."""

    def __init__(
        self,
        document: Document,
        runner: TaskRunner,
        viewport: Viewport,
        section: SectionPanel,
        actions: Actions,
        dialogs: PictureDialogs,
        note: Callable[[str], None],
    ) -> None:
        super().__init__(actions)
        self._document, self._runner = document, runner
        self._viewport, self._section = viewport, section
        self._dialogs, self._note = dialogs, note
        actions["picture"].triggered.connect(lambda _=False: self._save_view())
        actions["copy_picture"].triggered.connect(lambda _=False: self._copy_view())
        actions["section_picture"].triggered.connect(lambda _=False: self._save_section())
        actions["copy_section"].triggered.connect(lambda _=False: self._copy_section())
        section.picture_requested.connect(actions["section_picture"].trigger)
        section.copy_requested.connect(actions["copy_section"].trigger)

    def _save_view(self) -> None:
        path = self._dialogs.picture_file(self._proposed_file("view"), ("PNG",))
        if path is None:
            return
        with units.standard_units():
            image = self._viewport.picture()

        def write(part: Path) -> None:
            if not image.save(str(part), "PNG"):
                raise InputError(error("window.picture_not_written", file=str(path)))

        self._write_file(path, write)

    def _copy_view(self) -> None:
        QGuiApplication.clipboard().setImage(self._viewport.picture())
        self._note(gettext("The view was copied to the clipboard."))

    def _save_section(self) -> None:
        if not self._section.has_section:
            self._note(gettext(NO_SECTION_TEXT))
            return
        start = self._proposed_file(f"section-{self._section.through.text()}")
        path = self._dialogs.picture_file(start, ("PNG", "SVG", "PDF"))
        if path is None:
            return
        with units.standard_units():
            printed = self._section.figure_for_print()
        self._write_file(path, lambda part: printed.savefig(part, format=path.suffix[1:].lower()))

    def _copy_section(self) -> None:
        if not self._section.has_section:
            self._note(gettext(NO_SECTION_TEXT))
            return
        printed = self._section.figure_for_print()

        def work(_progress: Progress) -> bytes:
            stream = BytesIO()
            printed.savefig(stream, format="png")
            return stream.getvalue()

        def done(picture: bytes) -> None:
            QGuiApplication.clipboard().setImage(QImage.fromData(picture))
            self._note(gettext("The section was copied to the clipboard."))

        self._runner.run(gettext("Copying the section"), work, done)

    def _write_file(self, path: Path, write: Callable[[Path], None]) -> None:
        """Write the picture in the worker, first under a temporary name."""

        def work(_progress: Progress) -> None:
            with atomic_write(path) as part:
                write(part)

        self._runner.run(
            gettext("Writing the picture"),
            work,
            lambda _nothing: self._note(gettext("Wrote {path}", path=path)),
            persistent=True,
        )

    def _proposed_file(self, what: str) -> Path:
        """Proposed file name in the folder of the project."""
        project = self._document.project
        stem = "".join(c if c.isalnum() else "-" for c in what.lower())
        if project is None:
            return home_folder() / f"{stem}.png"
        return project.folder / f"{project.name}-{stem}.png"
