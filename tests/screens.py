"""Pictures of every panel and the main dialogues, to be looked at.

``python -m tests.screens FOLDER [PROJECT]`` shows PROJECT, or else the built-in survey, calibrated;
in both looks, both languages and two sizes. ``QT_SCALE_FACTOR=2`` makes them for a fine screen. It
needs a screen of at least 1600 x 1000, if only a virtual one. PROJECT is not changed.
"""

import argparse
import shutil
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QDialog, QMessageBox, QTabWidget, QWidget

from lispac.errors import InputError
from lispac.gui.dialogs.import_files.dialog import ImportDialog
from lispac.gui.session import Session
from lispac.gui.settings import AppSettings
from lispac.gui.status import STEPS
from lispac.gui.viewport.vtk import VtkViewport
from lispac.workflow.demo import run_demo

SIZES = ((1600, 1000), (1366, 768))
LOOKS, LANGUAGES = ("light", "dark"), ("en", "fr")
SETTLING_S = 0.4
ASKING = (
    "about", "keys", "seed_at", "find_again", "lines", "targets", "trajectory", "check", "script",
    "budget",
)  # fmt: skip
"""Actions that end in a dialogue."""


class Photographer:
    """Drives a session and writes pictures into a folder."""

    def __init__(self, application: QApplication, folder: Path, project: Path) -> None:
        self._application, self._folder, self._project = application, folder, project
        self._settings = AppSettings(folder / "settings.ini")
        self._settings.language, self._settings.theme = LANGUAGES[0], LOOKS[0]
        self._session = Session(application, VtkViewport, self._settings)
        self._prefix = ""
        self._watch = QTimer(interval=100)
        self._watch.timeout.connect(self._look)
        self._seen: QWidget | None = None
        self._asked = ""

    @property
    def window(self):
        """The window on the screen."""
        return self._session.window

    def rest(self, seconds: float = SETTLING_S) -> None:
        """Wait for work, and then a little."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self._application.processEvents()
            time.sleep(0.01)
            if self.window.runner.active:
                end = time.monotonic() + seconds

    def take(self, widget: QWidget, name: str) -> None:
        """A picture of what the screen shows of a window, its 3D view too."""
        self.rest()
        top = widget.frameGeometry()
        picture = widget.screen().grabWindow(0, top.x(), top.y(), top.width(), top.height())
        picture.save(str(self._folder / f"{self._prefix}-{name}.png"))

    def everything(self, looks: tuple[str, ...], languages: tuple[str, ...]) -> None:
        """All pictures."""
        for look in looks:
            for language in languages:
                self._dress(look, language)
                for size in SIZES:
                    self._resize(look, language, size)
                    self.take(self.window, "start")
        self.window.open_project(self._project)
        self.rest(2.0)
        for look in looks:
            for language in languages:
                self._dress(look, language)
                for size in SIZES:
                    self._resize(look, language, size)
                    self.panels()
                self._prefix = f"{look}-{language}"
                self.dialogues()
                self.design()

    def _dress(self, look: str, language: str) -> None:
        self._settings.theme, self._settings.language = look, language
        former = self.window
        self.window.renew()
        while self.window is former:
            self.rest(0.1)

    def _resize(self, look: str, language: str, size: tuple[int, int]) -> None:
        self._prefix = f"{look}-{language}-{size[0]}x{size[1]}"
        self.window.setGeometry(0, 0, *size)

    def panels(self) -> None:
        """Every step and every dock."""
        window = self.window
        for step, name in enumerate(STEPS):
            window.workflow.open(step)
            self.take(window, f"step-{step + 1}-{name.split()[0].lower()}")
        for name, dock in window.docks.items():
            dock.show()
            dock.raise_()
            self.take(window, f"dock-{name.split()[0].lower()}")
            if dock.widget() is window.diagnostics:
                for row in range(1, window.diagnostics.list.count()):
                    window.diagnostics.list.setCurrentRow(row)
                    self.take(window, f"dock-diagnostics-{row + 1}")

    def dialogues(self) -> None:
        """Each is photographed when it is up, and closed."""
        window, dialogs = self.window, self.window.dialogs
        self._watch.start()
        for name in ASKING:
            self._ask(name, window.actions_[name].trigger)
        self._ask("details", window.report.details_asked.emit)
        self._ask("preview", window.report.preview_asked.emit)
        bad = InputError("trajectory.txt, line 17: “12.x” is no number; mend the line.")
        self._ask("error", lambda: dialogs.show_error(bad))
        self._ask("unforeseen", lambda: dialogs.show_error(ValueError("for the picture")))
        self._ask("save-changes", lambda: dialogs.save_changes("harbour"))
        raw = [self._project / "raw"]
        self._ask("import-empty", lambda: dialogs.new_project(self._settings))
        self._ask("import", lambda: dialogs.new_project(self._settings, raw))
        self._watch.stop()

    def _ask(self, name: str, ask: Callable[[], object]) -> None:
        self._asked = name
        ask()
        self.rest()

    def _look(self) -> None:
        dialog = self._application.activeModalWidget()
        if dialog is None or dialog is self._seen:
            return
        self._watch.stop()
        self._seen = dialog
        if isinstance(dialog, ImportDialog):
            while dialog.work.busy:
                self.rest(0.1)
            for page in range(1, dialog.findChild(QTabWidget, "import_tabs").count()):
                dialog.tabs.setCurrentIndex(page)
                self.take(dialog, f"dialogue-{self._asked}-{page + 1}")
            dialog.tabs.setCurrentIndex(0)
        self.take(dialog, f"dialogue-{self._asked}")
        if isinstance(dialog, QMessageBox):
            dialog.close()
        elif isinstance(dialog, QDialog):
            dialog.reject()
        self._seen = None
        self._watch.start()

    def design(self) -> None:
        """The workspace of a site, its tables and views."""
        self.window.actions_["design"].trigger()
        design = self.window.designing.window
        for width, height in SIZES:
            design.setGeometry(0, 0, width, height)
            for tabs in (design.tabs, design.views):
                for page in range(tabs.count()):
                    tabs.setCurrentIndex(page)
                    self.take(design, f"{width}-{tabs.objectName()}-{page + 1}")
        design.close()

    def leave(self) -> None:
        """Close the window."""
        self.window.retire()


def main() -> None:
    """Take all pictures."""
    parser = argparse.ArgumentParser(prog="python -m tests.screens", description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("project", type=Path, nargs="?", help="an estimated, validated project")
    parser.add_argument("--looks", nargs="+", default=LOOKS, choices=LOOKS)
    parser.add_argument("--languages", nargs="+", default=LANGUAGES, choices=LANGUAGES)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    application = QApplication(sys.argv[:1])
    with tempfile.TemporaryDirectory() as scratch:
        copy = Path(scratch) / "harbour"
        if arguments.project is None:
            run_demo(copy)
        else:
            shutil.copytree(arguments.project, copy)
        photographer = Photographer(application, arguments.folder, copy)
        try:
            photographer.everything(tuple(arguments.looks), tuple(arguments.languages))
        finally:
            photographer.leave()


if __name__ == "__main__":
    main()
