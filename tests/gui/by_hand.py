"""Drive the program by mouse and keyboard, with its own dialogues.

Every wait has a time limit. A dialogue that the test does not expect is rejected at once, and its
text becomes the failure message.
"""

from collections import deque
from collections.abc import Callable
from pathlib import Path
from time import monotonic

import numpy as np
from PySide6.QtCore import QCoreApplication, QEvent, QObject, QPoint, Qt, QTimer
from PySide6.QtGui import QGuiApplication, QImage
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QFileDialog,
    QLabel,
    QLineEdit,
    QMenu,
    QMessageBox,
    QWidget,
)
from pytestqt.qtbot import QtBot

from lispac.gui.app.language import set_language
from lispac.gui.app.settings import AppSettings
from lispac.gui.viewport.base import Viewport
from lispac.gui.window.dialogs import Dialogs
from lispac.gui.window.main_window import MainWindow
from lispac.gui.window.session import Session
from tests.gui.support import WAIT_MS, Control, Driver, Key, Left, finish_layouts, in_front, press

POLL_MS = 50
CLOSES_S = 10.0
"""Time that an answered dialogue may take to close."""

Act = Callable[[QDialog], bool]


class DialogAnswers(QObject):
    """Answers the expected dialogues in their order, and rejects all others.

    Attributes
    ----------
    trouble : descriptions of unexpected dialogues and of errors while answering
    """

    def __init__(self) -> None:
        super().__init__()
        self.trouble: list[str] = []
        self._expected: deque[tuple[type[QDialog], Act]] = deque()
        self._acting: QWidget | None = None
        self._used_dialog: QWidget | None = None
        self._until = 0.0
        self._on = True
        self._schedule_poll()

    def expect(self, kind: type[QDialog], act: Act) -> None:
        """Expect a dialogue; call ``act`` on it repeatedly until it returns True."""
        self._expected.append((kind, act))

    def stop(self) -> None:
        """Stop polling, and add the expected dialogues that did not appear to `trouble`."""
        self._on = False
        self.trouble += [f"no {kind.__name__} came" for kind, _ in self._expected]
        self._expected.clear()

    @property
    def all_done(self) -> bool:
        """Whether all expected dialogues have been answered."""
        return not self._expected

    def _schedule_poll(self) -> None:
        # A new timer each time: a timer does not fire while its slot runs a dialogue's event loop
        if self._on:
            QTimer.singleShot(POLL_MS, self._poll)

    def _poll(self) -> None:
        self._schedule_poll()
        dialog = QApplication.activeModalWidget()
        if dialog is None:
            self._used_dialog = None
        if dialog is None or not dialog.isVisible() or dialog is self._acting:
            return
        closes = dialog is self._used_dialog and monotonic() < self._until
        if self.trouble:  # the dialogues under the unexpected one
            _reject(dialog)
        elif self._expected and isinstance(dialog, self._expected[0][0]):
            if in_front(dialog):  # keys typed earlier are lost
                self._use(dialog)
        elif not closes:
            self.trouble.append(f"nobody foresaw {_dialog_text(dialog)}")
            _reject(dialog)

    def _use(self, dialog: QDialog) -> None:
        kind, act = self._expected.popleft()
        former, self._acting = self._acting, dialog
        try:
            if act(dialog):
                self._used_dialog, self._until = dialog, monotonic() + CLOSES_S
            else:
                self._expected.appendleft((kind, act))
        except Exception as error:  # otherwise the event loop drops it and the dialogue stays open
            self.trouble.append(f"{error!r} at {_dialog_text(dialog)}")
        finally:
            self._acting = former


def _dialog_text(dialog: QWidget) -> str:
    words = [label.text() for label in dialog.findChildren(QLabel) if label.isVisible()]
    return f"{type(dialog).__name__} {dialog.windowTitle()!r}: {' '.join(filter(None, words))}"


def _reject(dialog: QWidget) -> None:
    if isinstance(dialog, QDialog):
        dialog.done(QDialog.DialogCode.Rejected)
    else:
        dialog.close()


SETTINGS = "settings.ini"


class Hands(Driver):
    """Driver of the complete program, with its session of windows and its real dialogues.

    Parameters
    ----------
    viewport : makes the viewport of a window
    folder : folder of the settings file, which is that of a new user in English
    """

    def __init__(self, qtbot: QtBot, viewport: Callable[[], Viewport], folder: Path) -> None:
        self.bot, self.dialogs, self.answers = qtbot, Dialogs(), DialogAnswers()
        self.settings = AppSettings(folder / SETTINGS)
        self.settings.language = "en"
        application = QApplication.instance()
        # Native dialogues of the system cannot be driven by Qt
        application.setAttribute(Qt.ApplicationAttribute.AA_DontUseNativeDialogs)
        self.session = Session(application, viewport, self.settings, self.dialogs)
        self._take()

    def _take(self) -> None:
        self.window, self.viewport = self.session.window, self.session.window.viewport
        self.until(lambda: in_front(self.window))

    def until(self, done: Callable[[], bool]) -> None:
        """Wait until a condition holds; fail at once on an unexpected dialogue."""
        self.bot.waitUntil(lambda: bool(self.answers.trouble) or done(), timeout=WAIT_MS)
        assert not self.answers.trouble, "; ".join(self.answers.trouble)

    def rest(self) -> None:
        """Wait until no task is active and the window has the focus.

        The window loses the focus when it gets its first 3D view: Qt then replaces its native
        window.
        """
        QCoreApplication.processEvents()
        self.until(lambda: not self.window.runner.active)
        self.until(lambda: in_front(self.window))
        finish_layouts()

    def until_dialogs_used(self) -> None:
        """Wait until all expected dialogues have been answered."""
        self.until(lambda: self.answers.all_done)

    def to_next_window(self) -> None:
        """Wait for the window that replaces this one, and continue in it."""
        self.until(lambda: self.session.window is not self.window)
        self._take()
        QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        self.rest()

    def leave(self) -> None:
        """Close the window without a question, and check that nothing of it is left."""
        self.window = self.session.window
        self.window.document.undo_stack.setClean()
        self.window.site_design.workspace.history.mark_saved()
        try:
            super().leave()
        finally:
            self.answers.stop()
            self.session.deleteLater()
            self.answers.deleteLater()
            QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
            set_language("en")
        assert not self.answers.trouble, "; ".join(self.answers.trouble)


def push(hands: Hands, text: str) -> None:
    """Click a button of the next message box."""

    def act(box: QMessageBox) -> bool:
        found = next(b for b in box.buttons() if text in b.text().replace("&", ""))
        hands.bot.mouseClick(found, Left)
        return True

    hands.answers.expect(QMessageBox, act)


def name_project(hands: Hands, folder: Path) -> None:
    """Type the path of the project file into the next file dialogue."""
    path = str(folder / "project.json")

    def act(dialog: QFileDialog) -> bool:
        name = dialog.findChild(QLineEdit, "fileNameEdit")
        if name.text() != path:
            # Pasted: the completion of each typed letter of a long path takes a second
            QGuiApplication.clipboard().setText(path)
            name.selectAll()
            hands.bot.keyClick(name, Key.Key_V, Control)
            return False
        hands.bot.keyClick(name, Key.Key_Return)
        return True

    hands.answers.expect(QFileDialog, act)


def open_by_keys(hands: Hands, folder: Path, then: str = "") -> None:
    """Open a project with Ctrl+O; ``then`` is the button to press in a question that follows."""
    name_project(hands, folder)
    if then:
        push(hands, then)
    press(hands, Key.Key_O, Control)
    hands.until(lambda: hands.window.document.project is not None)
    hands.until_dialogs_used()
    hands.rest()


def rename(hands: Hands, row: int, to: str) -> None:
    """Rename a target with F2 in the list of targets."""
    table = hands.window.targets.table
    hands.bot.mouseClick(
        table.viewport(), Left, pos=table.visualItemRect(table.item(row, 0)).center()
    )
    hands.bot.keyClick(table, Key.Key_F2)
    editor = table.findChild(QLineEdit)
    editor.selectAll()
    hands.bot.keyClicks(editor, to)
    hands.bot.keyClick(editor, Key.Key_Return)
    hands.until(lambda: to in [target.name for target in hands.project.targets])
    hands.rest()


def ctrl_click(hands: Hands, place: QPoint) -> None:
    """Ctrl+click at a pixel of the drawn lines, and check that a plane is found there."""
    hands.bot.mouseClick(hands.viewport.canvas, Left, Control, place)
    hands.rest()
    assert hands.window.controller.candidate is not None


def open_menu(bot: QtBot, window: MainWindow, name: str) -> QMenu:
    """Open a menu of the menu bar with a click."""
    bar = window.menuBar()
    action = next(a for a in bar.actions() if name in a.text().replace("&", ""))
    bot.mouseClick(bar, Left, pos=bar.actionGeometry(action).center())
    bot.waitUntil(action.menu().isVisible, timeout=WAIT_MS)
    return action.menu()


def choose(bot: QtBot, menu: QMenu, *names: str) -> None:
    """Choose a menu entry with clicks, through submenus where needed."""
    for name in names:
        action = next(a for a in menu.actions() if name in a.text().replace("&", ""))
        place = menu.actionGeometry(action).center()
        bot.mouseClick(menu, Left, pos=place)
        if action.menu() is not None:
            former, menu = menu, action.menu()
            _open_submenu(bot, former, place, menu)


def _open_submenu(bot: QtBot, menu: QMenu, place: QPoint, submenu: QMenu) -> None:
    """Wait until a clicked submenu is open; click again if it does not open.

    A late event of the pointer of the screen, which is elsewhere, may deselect the entry in the
    short time before the submenu opens.
    """
    until = monotonic() + WAIT_MS / 1000
    while not submenu.isVisible() and monotonic() < until:
        for _ in range(100):
            bot.wait(10)
            if submenu.isVisible():
                return
        bot.mouseClick(menu, Left, pos=place)
    assert submenu.isVisible()


def shows_something(hands: Hands, file: Path) -> None:
    """Save a picture of the window, and check that it is not blank."""
    hands.bot.wait(300)
    assert hands.window.grab().save(str(file))
    image = QImage(str(file)).convertToFormat(QImage.Format.Format_RGB32)
    assert len(np.unique(np.frombuffer(image.constBits(), np.uint32))) > 50
