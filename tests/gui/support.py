"""Support for window tests: scripted dialogues, and a driver that closes its window cleanly."""

import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from PySide6.QtCore import (
    QCoreApplication,
    QEvent,
    QModelIndex,
    QObject,
    QPoint,
    Qt,
    QTimer,
    SignalInstance,
)
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QFormLayout,
    QLabel,
    QMessageBox,
    QTableView,
    QWidget,
)
from pytestqt.qtbot import QtBot

from lispac.gui.app.docks import raise_panel
from lispac.gui.app.questions import CandidateChoice, DropChoice, SaveChoice
from lispac.gui.app.settings import AppSettings
from lispac.gui.viewport.base import PickedPoint, Viewport
from lispac.gui.widgets.idle_tasks import IdleTask
from lispac.gui.window.dialogs import Dialogs
from lispac.gui.window.main_window import MainWindow
from lispac.identity import Identity
from lispac.project import BoresightChoice, LineSource, Project, Role
from lispac.survey.trajectory import LocalTrajectory
from lispac.workflow.importing.input_files import ImportRequest
from lispac.workflow.output.export_request import ExportContent, ExportRequest
from lispac.workflow.output.installation import InstallationFormat
from lispac.workflow.planning.demo import demo_seeds
from lispac.workflow.project.survey import Survey

WAIT_MS = 120_000
DIALOG_POLL_MS = 20
Key, Left = Qt.Key, Qt.MouseButton.LeftButton
Control = Qt.KeyboardModifier.ControlModifier


def show_panel(window: MainWindow, title: str) -> QWidget:
    """Bring a panel to the front, in its dock or its own window; return the dock or window."""
    container = {**window.docks, **window.panel_windows}[title]
    is_dock = title in window.docks
    raise_panel(container.widget() if is_dock else container.centralWidget())
    finish_layouts()
    return container


class PatientBot(QtBot):
    """The bot of pytest-qt with limits of waits that suffice on a busy computer."""

    def waitUntil(self, callback: Callable[[], bool | None], *, timeout: int = WAIT_MS) -> None:
        super().waitUntil(callback, timeout=timeout)

    def waitSignal(self, signal: SignalInstance, *, timeout: int = WAIT_MS, **options):
        return super().waitSignal(signal, timeout=timeout, **options)

    def waitExposed(self, widget: QWidget, *, timeout: int = WAIT_MS):
        return super().waitExposed(widget, timeout=timeout)


class ScriptedDialogs(Dialogs):
    """Dialogues that return preset answers and record the requests."""

    def __init__(self) -> None:
        super().__init__()
        self.path: Path | None = None
        self.request: ImportRequest | None = None
        self.export_request: ExportRequest | None = None
        self.dropped: list[Path] = []
        self.save_choice: SaveChoice = "discard"
        self.drop_choice: DropChoice = "cancel"
        self.lines: tuple[LineSource, ...] | None = None
        self.candidate_choice: CandidateChoice = "cancel"
        self.folders: list[Path] = []
        """Where the files of a moved project are now, one folder for each request."""
        self.safety: list[str] = []
        """Asked about unsaved work and other windows; tests in other processes share the demo."""
        self.recovers, self.opens_twice, self.overwrites, self.stops = False, True, True, True
        self.removes_targets = True
        self.requests: list[str] = []
        self.proposed = Path()
        self.opened: list[Path] = []
        self.fills_in_details = False
        """Whether the missing details of a report are asked for at its export."""
        self.can_open = True
        self.errors: list[BaseException] = []

    def new_project(
        self, settings: AppSettings, paths: Sequence[Path] = ()
    ) -> ImportRequest | Path | None:
        self.dropped = list(paths)
        return self.request

    def ask_to_add(self, name: str) -> DropChoice:
        self.requests.append(name)
        return self.drop_choice

    def add_lines(
        self, settings: AppSettings, project: Project, paths: Sequence[Path] = ()
    ) -> tuple[LineSource, ...] | Path | None:
        self.dropped = list(paths)
        return self.lines

    def project_to_open(self, start: Path) -> Path | None:
        return self.path

    def folder_to_save_in(self, start: Path) -> Path | None:
        return self.path

    def report_file(self, start: Path) -> Path | None:
        self.proposed = start
        return self.path

    def correspondence_file(self, start: Path) -> Path | None:
        return self.path

    def open_file(self, path: Path) -> bool:
        self.opened.append(path)
        return self.can_open

    def pdf_file(self, start: Path) -> Path | None:
        self.requests.append(start.name)
        return self.path

    def script_file(self, start: Path) -> Path | None:
        self.requests.append(start.name)
        return self.path

    def identity(
        self,
        identity: Identity,
        dates: Callable[[], str] | None,
        companies: Mapping[str, Mapping[str, str]],
        suggestions: Mapping[str, str],
        missing: Sequence[str] = (),
        equipment: Mapping[str, Sequence[str]] | None = None,
        continues: bool = False,
    ) -> Identity | None:
        if continues and not self.fills_in_details:
            return identity
        return super().identity(
            identity, dates, companies, suggestions, missing, equipment, continues
        )

    def report_template(self, start: Path) -> Path | None:
        return self.path

    def seed_list_file(self, start: Path) -> Path | None:
        return self.path

    def folder_of_projects(self, start: Path) -> Path | None:
        return self.path

    def design_file(self, what: str, start: Path) -> Path | None:
        return self.path

    def picture_file(self, start: Path, kinds: Sequence[str]) -> Path | None:
        self.requests.append(start.name)
        return self.path

    def installation_file(
        self, start: Path, formats: Sequence[InstallationFormat]
    ) -> tuple[Path, InstallationFormat] | None:
        self.requests.append(start.name)
        fitting = [each for each in formats if self.path and self.path.suffix == each.ending]
        return (self.path, fitting[-1]) if self.path and fitting else None

    def export(
        self,
        what: ExportContent,
        which: BoresightChoice,
        project: Project,
        trajectory: LocalTrajectory,
    ) -> ExportRequest | None:
        self.requests.append(what)
        return self.export_request

    def ask_to_save_changes(self, name: str) -> SaveChoice:
        self.requests.append(name)
        return self.save_choice

    def ask_to_stop(self, task: str) -> bool:
        self.safety.append(f"stop {task}")
        return self.stops

    def ask_to_recover(self, name: str, when: str) -> bool:
        self.safety.append(f"recover {name}")
        return self.recovers

    def ask_files_folder(self, name: str, missing: Sequence[Path], start: Path) -> Path | None:
        self.requests.append(f"{name}: {len(missing)}")
        return self.folders.pop(0) if self.folders else None

    def ask_to_open_locked(self, name: str, where: str) -> bool:
        self.safety.append(f"{name} is open in {where}")
        return self.opens_twice

    def ask_to_overwrite(self, name: str) -> bool:
        self.safety.append(f"overwrite {name}")
        return self.overwrites

    def ask_to_remove_targets(self, count: int) -> bool:
        self.requests.append(f"remove {count} targets")
        return self.removes_targets

    def ask_about_candidate(self, name: str, *, is_search: bool = False) -> CandidateChoice:
        self.requests.append(name)
        return self.candidate_choice

    def show_error(self, error: BaseException) -> None:
        self.errors.append(error)


@dataclass(frozen=True)
class Demo:
    """The demo survey: as made, and with targets and a validation plane picked."""

    project: Project
    picked: Project
    survey: Survey


class Driver:
    """A window, with methods to wait for it and to close it."""

    def __init__(
        self, qtbot: QtBot, viewport: Viewport, folder: Path, dialogs: Dialogs | None = None
    ) -> None:
        self.bot = qtbot
        self.dialogs = dialogs or ScriptedDialogs()
        self.viewport = viewport
        self.window = MainWindow(viewport, AppSettings(folder / "settings.ini"), self.dialogs)
        self.window.show()
        qtbot.waitUntil(lambda: in_front(self.window), timeout=WAIT_MS)

    @property
    def project(self) -> Project:
        """The project in the window."""
        assert self.window.document.project is not None
        return self.window.document.project

    def rest(self) -> None:
        """Wait until no task is active, all results are drawn and all widgets have their place."""
        QCoreApplication.processEvents()
        self.bot.waitUntil(lambda: not self.window.runner.active, timeout=WAIT_MS)
        self.bot.waitUntil(lambda: not self._turns, timeout=WAIT_MS)
        finish_layouts()

    @property
    def _turns(self) -> list[IdleTask]:
        return [turn for turn in self.window.findChildren(IdleTask) if turn.isActive()]

    def leave(self) -> None:
        """Close the window and check that nothing of it is left."""
        self.dialogs.save_choice = "discard"
        assert self.window.close()
        assert self.window.runner.current is None
        self.window.deleteLater()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        QCoreApplication.processEvents()
        assert [w for w in QApplication.topLevelWidgets() if w.isVisible()] == []
        assert [t.name for t in threading.enumerate() if t.name == "lispac-worker"] == []


class _LayoutRequests(QObject):
    """Counter of the layout requests that the application handles."""

    def __init__(self) -> None:
        super().__init__()
        self.count = 0

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        self.count += event.type() == QEvent.Type.LayoutRequest
        return False


def finish_layouts() -> None:
    """Handle events until all widgets have their size.

    A widget requests a layout by an event, which may lead to a request of its parent in a later
    turn, so that texts are cut for some turns after a change.
    """
    application = QCoreApplication.instance()
    assert application is not None
    requests = _LayoutRequests()
    application.installEventFilter(requests)
    try:
        is_first = True
        while requests.count or is_first:
            is_first = False
            requests.count = 0
            QCoreApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest)
            QCoreApplication.processEvents()
    finally:
        application.removeEventFilter(requests)


def labels_that_guess(window: QWidget) -> list[str]:
    """Labels that guess from their text whether it is HTML; a file name may look like HTML.

    Labels of forms contain only texts of the program; tooltips are escaped where they are set.
    """
    heads = {
        item.widget().text()
        for form in window.findChildren(QFormLayout)
        for row in range(form.rowCount())
        if (item := form.itemAt(row, QFormLayout.ItemRole.LabelRole)) is not None
        and isinstance(item.widget(), QLabel)
    }
    return [
        label.text()
        for label in window.findChildren(QLabel)
        if label.textFormat() == Qt.TextFormat.AutoText
        and label.text() not in {"", *heads}
        and label.metaObject().className() != "QTipLabel"
    ]


def in_front(window: QWidget) -> bool:
    """Whether a window has the keyboard focus; if not, request it again.

    There is no window manager to do so, and the window system may lose a request while it is busy
    with another window.
    """
    if not window.isActiveWindow():
        window.activateWindow()
    return window.isActiveWindow()


def use_next_dialog(use_dialog: Callable[[Any], object]) -> list[QDialog]:
    """Call ``use_dialog`` with the next modal dialogue; errors, and no dialogue, fail the test.

    A dialogue that is still open afterwards is rejected, so that no error leaves the test waiting
    for it.

    Returns
    -------
    list of QDialog
        Filled with the dialogue when it appears.
    """
    dialogs: list[QDialog] = []
    until = time.monotonic() + WAIT_MS / 1000

    def look_for_dialog() -> None:
        dialog = QApplication.activeModalWidget()
        is_ready = isinstance(dialog, QDialog) and in_front(dialog)
        if not is_ready and time.monotonic() < until:
            QTimer.singleShot(DIALOG_POLL_MS, look_for_dialog)
            return
        try:
            assert is_ready, f"no dialogue in front, but {dialog}"
            dialogs.append(dialog)
            use_dialog(dialog)
        finally:
            if isinstance(dialog, QDialog) and dialog.isVisible():
                dialog.reject()

    QTimer.singleShot(DIALOG_POLL_MS, look_for_dialog)
    return dialogs


def click_in_box(box: QMessageBox, text: str) -> None:
    """Click the button with ``text`` in a message box."""
    (button,) = (each for each in box.buttons() if each.text().replace("&", "") == text)
    QTest.mouseClick(button, Left)


def press(driver: Driver, key: Qt.Key, modifier=Qt.KeyboardModifier.NoModifier) -> None:
    """Press a key in the main window, which gets the focus back if a dialogue was closed."""
    if QApplication.activeModalWidget() is None:  # Qt ignores shortcuts of inactive windows
        driver.bot.waitUntil(lambda: in_front(driver.window))
    driver.bot.keyClick(driver.window, key, modifier)


def click(driver: Driver, widget: QWidget) -> None:
    assert widget.isVisible()
    assert widget.isEnabled()
    finish_layouts()  # a step that was just opened moves the widgets below it
    driver.bot.mouseClick(widget, Left)


def double_click(driver: Driver, table: QTableView, row: int, column: int = 0) -> None:
    """Double-click a cell: a click and a double click, as the mouse sends them."""
    table.scrollTo(table.model().index(row, column))
    place = table.visualRect(table.model().index(row, column)).center()
    driver.bot.mouseClick(table.viewport(), Left, pos=place)
    driver.bot.mouseDClick(table.viewport(), Left, pos=place)


def type_into(driver: Driver, field: QWidget, text: str) -> None:
    """Replace the content of a field by typing."""
    field.setFocus()
    field.selectAll()
    driver.bot.keyClick(field, Key.Key_Delete)
    driver.bot.keyClicks(field, text)


def wait_until_idle(driver: Driver) -> None:
    """Wait until the results that follow from an edit are there and drawn."""
    driver.bot.waitUntil(lambda: not driver.window.document.awaits_result, timeout=WAIT_MS)
    driver.rest()
    driver.bot.waitUntil(lambda: driver.window.scene.is_drawn, timeout=WAIT_MS)


def click_check(driver: Driver, table: QTableView, index: QModelIndex) -> None:
    """Click the check box of a cell: its leftmost ten pixels."""
    place = table.visualRect(index)
    driver.bot.mouseClick(table.viewport(), Left, pos=QPoint(place.left() + 10, place.center().y()))


def seed(driver: Driver, name: str, role: Role | None = None) -> None:
    """Seed a plane of the demo at its middle, as a Ctrl+click does."""
    usual, position = demo_seeds()[name]
    driver.window.targets.set_role(role or usual)
    first = driver.window.document.survey.lines[0]
    driver.viewport.signals.seed_clicked.emit(PickedPoint(first, position))
    driver.rest()


def estimate(driver: Driver) -> None:
    """Estimate without the cross-checks, which take most of the time."""
    driver.window.adjust.cross_check.setChecked(False)
    press(driver, Key.Key_F9)
    driver.rest()


def sentence(driver: Driver, step: int) -> str:
    return driver.window.workflow.headers[step].sentence.text()


def open_step(driver: Driver, step: int) -> None:
    click(driver, driver.window.workflow.headers[step])
