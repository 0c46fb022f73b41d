"""Entry point of the program with a window: ``lispac-gui [PROJECT]``."""

import argparse
import gc
import os
import sys
import threading
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, Qt, QTimer, Signal
from PySide6.QtGui import QFileOpenEvent, QIcon
from PySide6.QtWidgets import QApplication, QLabel

from lispac import caches
from lispac.installation_paths import resource_path
from lispac.version import __version__

if TYPE_CHECKING:
    from lispac.gui.viewport.base import Viewport

IMPORT_DELAY_MS = 300
"""Delay before packages are imported in the background, so that the window is drawn first."""

SPLASH_SIZE = 256
"""Width and height of the splash screen, pixels."""


class Application(QApplication):
    """Qt application that handles requests of macOS to open a document."""

    document_requested = Signal(Path)

    def event(self, event: QEvent) -> bool:
        """Handle requests of the system to open a document."""
        if isinstance(event, QFileOpenEvent) and event.file():
            self.document_requested.emit(Path(event.file()))
            return True
        return super().event(event)


def main(argv: Sequence[str] | None = None) -> int:
    """Run the program with a window; open a project if one is given."""
    parser = argparse.ArgumentParser(
        prog="lispac-gui", description="Boresight calibration of a LiDAR and an INS/GNSS."
    )
    parser.add_argument(
        "project", nargs="?", type=Path, help="project folder, project.json or project.lispac"
    )
    parser.add_argument("--demo", action="store_true", help="open the demo survey")
    parser.add_argument("--version", action="version", version=f"LISPAC {__version__}")
    arguments = parser.parse_args(argv)

    if _is_screen_missing():
        print("lispac-gui: no display found. Use the command lispac instead.", file=sys.stderr)
        return 1
    application = QApplication.instance() or Application(sys.argv[:1])
    application.setApplicationName("LISPAC")
    application.setApplicationVersion(__version__)
    icon = QIcon(str(resource_path("icons/lispac.png")))
    application.setWindowIcon(icon)
    requested: list[Path] = []  # before the window exists
    if isinstance(application, Application):
        application.document_requested.connect(requested.append)
    splash = show_splash_screen(icon)
    # Wayland takes the icon from the desktop entry of this name
    application.setDesktopFileName("lispac")

    message = caches.set_cache_variables(os.environ)
    gc.disable()  # replaced by `GuiThreadGarbageCollector`
    from lispac.gui.app.garbage_collection import GuiThreadGarbageCollector
    from lispac.gui.app.log_file import LogFile
    from lispac.gui.appearance.message_texts import message_text
    from lispac.gui.viewport.lazy_viewport import LazyViewport
    from lispac.gui.window.session import Session

    collector = GuiThreadGarbageCollector(application)
    session = Session(application, lambda: LazyViewport(_create_viewport))
    splash.close()
    importing = threading.Thread(target=_prepare_in_background, name="lispac-import")
    QTimer.singleShot(IMPORT_DELAY_MS, importing.start)
    if isinstance(application, Application):
        application.document_requested.disconnect(requested.append)
        application.document_requested.connect(lambda path: session.window.open_project(path))
    logbook = LogFile(session.log_folder, session.report_uncaught)
    logbook.begin()
    if message is not None:
        session.window.controller.logged.emit(message_text(message))
    if (project := arguments.project or next(iter(requested), None)) is not None:
        QTimer.singleShot(0, lambda: session.window.open_project(project))
    elif (crashed := session.crashed_project()) is not None:
        QTimer.singleShot(0, lambda: session.window.open_project(crashed))
    elif arguments.demo:
        QTimer.singleShot(0, session.window.controller.open_demo)
    try:
        return application.exec()
    finally:
        logbook.end()
        collector.end()


def _import_viewport() -> "type[Viewport]":
    """Import the VTK viewport; the application must exist, since VTK and Qt share graphics."""
    from lispac.gui.viewport.vtk_viewport import VtkViewport

    return VtkViewport


def show_splash_screen(icon: QIcon) -> QLabel:
    """Show the icon while the modules of the window are imported.

    `QSplashScreen` is not used: it waits up to a second until the system has shown it.
    """
    splash = QLabel()
    splash.setWindowFlags(Qt.WindowType.SplashScreen | Qt.WindowType.FramelessWindowHint)
    splash.setAttribute(Qt.WidgetAttribute.WA_TranslucentBackground)
    splash.setPixmap(icon.pixmap(SPLASH_SIZE))
    splash.adjustSize()
    splash.move(splash.screen().availableGeometry().center() - splash.rect().center())
    splash.show()
    QApplication.processEvents()
    return splash


def _prepare_in_background() -> None:
    """Import what the first project and the first pick need, and compile functions if necessary."""
    _import_viewport()
    from lispac.workflow.calibration import estimation, picking  # noqa: F401
    from lispac.workflow.planning.precompile import start_precompilation

    start_precompilation()


def _create_viewport() -> "Viewport":
    return _import_viewport()()


def _is_screen_missing() -> bool:
    """Whether Linux has no display, without which Qt would abort the process."""
    variables = ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")
    return sys.platform.startswith("linux") and not any(os.environ.get(name) for name in variables)


if __name__ == "__main__":
    sys.exit(main())
