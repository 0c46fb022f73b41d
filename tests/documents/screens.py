"""Make pictures of every panel and of the main dialogues for visual inspection.

``python -m tests.documents.screens FOLDER [PROJECT]`` shows PROJECT or the calibrated built-in
survey in both colour schemes, both languages and two sizes. ``QT_SCALE_FACTOR=2`` makes them for a
fine screen. It needs a screen of at least the largest size, if only a virtual one. PROJECT is not
changed.
"""

import argparse
import os
import shutil
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QDialog, QTabWidget, QWidget

from lispac.errors import InputError
from lispac.gui.app.settings import AppSettings
from lispac.gui.app.tasks import TaskRunner
from lispac.gui.appearance.units import ANGLE_UNITS, LENGTH_UNITS
from lispac.gui.features.estimate.diagnostics_panel import TITLE as DIAGNOSTICS
from lispac.gui.features.inspect.clipping_panel import TITLE as CLIPPING
from lispac.gui.features.inspect.section_panel import TITLE as SECTION
from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from lispac.gui.project.status import STEP_NAMES
from lispac.gui.viewport.vtk_viewport import VtkViewport
from lispac.gui.widgets.idle_tasks import IdleTask
from lispac.gui.window.session import Session
from lispac.workflow.planning.demo import run_demo
from tests.support.screen_findings import Findings

SIZES = ("1600x1000", "1366x768")
THEMES, LANGUAGES = ("light", "dark"), ("en", "fr")
SETTLING_S = 0.4
DIALOGUE_ACTIONS = (
    "about", "keys", "seed_coordinates", "find_again", "lines", "targets", "trajectory", "check",
    "script", "budget", "settings",
)  # fmt: skip
"""Actions that open a dialogue."""
SIMULATED_SURVEYS = 100
"""Number of simulated surveys of the plan."""


class Photographer:
    """Operate the window and write pictures to a folder."""

    def __init__(
        self,
        application: QApplication,
        folder: Path,
        project: Path,
        sizes: Sequence[str],
        units: tuple[str, str],
    ) -> None:
        self._application, self._folder, self._project = application, folder, project
        self._sizes = [tuple(map(int, size.split("x"))) for size in sizes]
        self._settings = AppSettings(project.parent / "settings.ini")
        self._settings.language, self._settings.theme = LANGUAGES[0], THEMES[0]
        self._settings.units = units
        self._session = Session(application, VtkViewport, self._settings)
        self._prefix = ""
        self._watch = QTimer(interval=100)
        self._watch.timeout.connect(self._poll)
        self._last_dialog: QWidget | None = None
        self._dialog_name = ""

    @property
    def window(self):
        """The window on the screen."""
        return self._session.window

    def rest(self, seconds: float = SETTLING_S) -> None:
        """Wait for computations and drawing, and then a short time."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self._application.processEvents()
            time.sleep(0.01)
            drawn = not any(turn.isActive() for turn in self.window.findChildren(IdleTask))
            if self.window.runner.active or not drawn:
                end = time.monotonic() + seconds

    def take(self, widget: QWidget, name: str) -> None:
        """Save a picture of a window on the screen, including its 3D view."""
        self.rest()
        top = widget.frameGeometry()
        picture = widget.screen().grabWindow(0, top.x(), top.y(), top.width(), top.height())
        picture.save(str(self._folder / f"{self._prefix}-{name}.png"))

    def everything(self, themes: Sequence[str], languages: Sequence[str]) -> None:
        """Take all pictures."""
        for _ in self._dressed(themes, languages):
            self.empty()
        self.window.open_project(self._project)
        self.rest(2.0)
        window = self.window
        assert window.document.project is not None
        assert window.document.survey is not None
        self._found = Findings.of(
            window.document.project, window.document.survey, self._project.parent
        )
        for _ in self._dressed(themes, languages):
            self.panels()
        for theme in themes:
            for language in languages:
                self._dress(theme, language)
                self._prefix = f"{theme}-{language}"
                self.dialogues()
                self.design()
        for theme in themes:
            for language in languages:
                self._dress(theme, language)
                self._prefix = f"{theme}-{language}"
                self.tour()

    def _dressed(self, themes: Sequence[str], languages: Sequence[str]) -> Iterator[None]:
        """Set each combination of colour scheme, language and size in turn."""
        for theme in themes:
            for language in languages:
                self._dress(theme, language)
                for width, height in self._sizes:
                    self._prefix = f"{theme}-{language}-{width}x{height}"
                    self.window.setGeometry(0, 0, width, height)
                    yield

    def _dress(self, theme: str, language: str) -> None:
        self._settings.theme, self._settings.language = theme, language
        former = self.window
        self.window.rebuild_window()
        while self.window is former:
            self.rest(0.1)

    def empty(self) -> None:
        """Start page and docks without a project."""
        self.take(self.window, "start")
        for step, name in enumerate(STEP_NAMES):
            self.window.workflow.open(step)
            self.take(self.window, f"empty-step-{step + 1}-{name.lower()}")
        self._docks("empty")

    def panels(self) -> None:
        """Every step and every dock, without and with a selected target."""
        window = self.window
        for step, name in enumerate(STEP_NAMES):
            window.workflow.open(step)
            self.take(window, f"step-{step + 1}-{name.split()[0].lower()}")
        self._docks("dock")
        for row in range(window.diagnostics.list.count()):
            window.diagnostics.list.setCurrentRow(row)
            own = window.panel_windows[DIAGNOSTICS]
            own.bring_to_front()
            self.take(own, f"dock-diagnostics-{row + 1}")
        window.panel_windows[DIAGNOSTICS].close()
        project = window.document.project
        window.scene.select(project.targets[0].name)
        for name in (SECTION, CLIPPING):
            window.docks[name].bring_to_front()
            self.rest()
            if name == CLIPPING:
                window.tools.clipping.panel.about.click()
            self.take(window, f"selected-{name.split()[0].lower()}")
        window.tools.clipping.panel.reset.click()

    def _docks(self, what: str) -> None:
        for name, dock in self.window.docks.items():
            dock.bring_to_front()
            self.take(self.window, f"{what}-{name.split()[0].lower()}")
        for name, own in self.window.panel_windows.items():
            own.bring_to_front()
            self.take(own, f"{what}-{name.split()[0].lower()}")
            own.close()

    def tour(self) -> None:
        """First card of the tour."""
        self.window.actions_["tour"].trigger()
        self.rest(2.0)
        self.take(self.window, "tour")

    def dialogues(self) -> None:
        """Take a picture of each dialogue when it is open, and close it."""
        window, dialogs = self.window, self.window.dialogs
        self._watch.start()
        for name in DIALOGUE_ACTIONS:
            self._open_dialog(name, window.actions_[name].trigger)
        self._open_dialog("details", window.report.details_requested.emit)
        self._open_dialog("preview", window.report.preview_requested.emit)
        bad = InputError(
            "line.las: point 17 has a coordinate or time that is not a number (nan, 2.5, 3.0); "
            "clean or export it again."
        )
        self._open_dialog("error", lambda: dialogs.show_error(bad))
        self._open_dialog(
            "excess_variance", lambda: dialogs.show_error(ValueError("for the picture"))
        )
        self._open_dialog("save-changes", lambda: dialogs.ask_to_save_changes("harbour"))
        raw = [self._project / "raw"]
        self._open_dialog("import-empty", lambda: dialogs.new_project(self._settings))
        self._open_dialog("import", lambda: dialogs.new_project(self._settings, raw))
        document = window.document
        for name, open_dialog in self._found.dialogs_by_name(
            dialogs, self._settings, document.project, document.survey
        ).items():
            self._open_dialog(name, open_dialog)
        self._watch.stop()

    def _open_dialog(self, name: str, open_dialog: Callable[[], object]) -> None:
        self._dialog_name = name
        open_dialog()
        self.rest()

    def _poll(self) -> None:
        dialog = self._application.activeModalWidget()
        if dialog is None or dialog is self._last_dialog:
            return
        self._watch.stop()
        self._last_dialog = dialog
        if isinstance(dialog, ImportDialog):
            while dialog.work.busy:
                self.rest(0.1)
        self.take(dialog, f"dialogue-{self._dialog_name}")
        for tabs in dialog.findChildren(QTabWidget):
            for page in range(1, tabs.count() if tabs.isVisible() else 0):
                tabs.setCurrentIndex(page)
                self.take(dialog, f"dialogue-{self._dialog_name}-{page + 1}")
        if isinstance(dialog, QDialog):
            # some dialogues cannot be closed without a choice
            dialog.done(QDialog.DialogCode.Rejected)
        self._last_dialog = None
        self._watch.start()

    def design(self) -> None:
        """Workspace of a site with its tables and views, before and after the long computations."""
        self.window.actions_["design"].trigger()
        designing = self.window.site_design
        design = designing.window
        for width, height in self._sizes:
            design.setGeometry(0, 0, width, height)
            for tabs in (design.tabs, design.views):
                for page in range(tabs.count()):
                    tabs.setCurrentIndex(page)
                    self.take(design, f"{width}-{tabs.objectName()}-{page + 1}")
        design.surveys.surveys.setValue(SIMULATED_SURVEYS)
        designing.compare()
        self._wait_until_idle(designing.runner)
        self.take(design, "design-compared")
        for name, work in {
            "scenarios": designing.scenarios, "surveys": designing.surveys,
            "best": designing.search,
        }.items():  # fmt: skip
            work()
            self._wait_until_idle(designing.runner)
            self.take(design, f"design-{name}")
        designing.workspace.undo()
        design.close()

    def _wait_until_idle(self, runner: TaskRunner) -> None:
        while runner.active:
            self.rest(0.1)

    def leave(self) -> None:
        """Close the windows and list texts that are not translated."""
        assert self.window.site_design.leave()
        self.window.stop_and_hide()


def main() -> None:
    """Take all pictures."""
    parser = argparse.ArgumentParser(prog="python -m tests.documents.screens", description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("project", type=Path, nargs="?", help="an estimated, validated project")
    parser.add_argument("--themes", nargs="+", default=THEMES, choices=THEMES)
    parser.add_argument("--languages", nargs="+", default=LANGUAGES, choices=LANGUAGES)
    parser.add_argument("--sizes", nargs="+", default=SIZES, metavar="WIDTHxHEIGHT")
    parser.add_argument("--angles", default="degrees", choices=ANGLE_UNITS)
    parser.add_argument("--lengths", default="metres", choices=LENGTH_UNITS)
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory() as scratch:
        # The tour changes the demo, but must not change that of the user
        for variable in ("HOME", "USERPROFILE", "XDG_CACHE_HOME", "LOCALAPPDATA"):
            os.environ[variable] = scratch
        application = QApplication(sys.argv[:1])
        copy = Path(scratch) / "harbour"
        if arguments.project is None:
            run_demo(copy)
        else:
            shutil.copytree(
                arguments.project, copy, ignore=shutil.ignore_patterns("open.lock", "unsaved*")
            )
        photographer = Photographer(
            application, arguments.folder, copy, arguments.sizes,
            (arguments.angles, arguments.lengths),
        )  # fmt: skip
        try:
            photographer.everything(arguments.themes, arguments.languages)
        finally:
            photographer.leave()


if __name__ == "__main__":
    main()
