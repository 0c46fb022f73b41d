"""Follow the steps of a page of the manual literally, by mouse and keys.

A step may open a modal dialogue that blocks its caller, so each step is started from the event loop
and the next one from a timer.
"""

import re
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import shiboken6
from PySide6.QtCore import QObject, QPoint, Qt, QTimer
from PySide6.QtGui import QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QComboBox,
    QDialog,
    QDockWidget,
    QFileDialog,
    QFormLayout,
    QLabel,
    QLineEdit,
    QListView,
    QMenu,
    QPlainTextEdit,
    QScrollArea,
    QTabBar,
    QTableWidget,
    QWidget,
)

from lispac.gui.window.main_window import MainWindow
from tests.support.tutorial_steps import Step

BEAT_MS = 30
TIMEOUT_S, TASK_TIMEOUT_S = 20.0, 150.0
"""Time limits for a named widget to appear, and for a started task to end."""
CTRL_CLICK = ("Ctrl+click", "Ctrl+clic")
KEY_NAMES = {"Entrée": "Return", "Enter": "Return"}
"""Qt names of the keys whose names in a page differ."""
Left, Control = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.ControlModifier
Act = Callable[[], None]


class StepError(AssertionError):
    """The page names something that the window does not show."""


class Reader(QObject):
    """Follows steps in a window until they are done or one of them fails.

    Parameters
    ----------
    take_picture : called with the window in front and the path of each picture of the page
    """

    def __init__(
        self, window: MainWindow, steps: list[Step], take_picture: Callable[[QWidget, str], None]
    ) -> None:
        super().__init__()
        self._window, self._take_picture = window, take_picture
        self.at: Step | None = None
        self.error: BaseException | None = None
        self.done = False
        self._course = self._through(steps)
        self._begun = 0
        self._timer = QTimer(self, interval=BEAT_MS)
        self._timer.timeout.connect(self._beat)
        self._timer.start()

    def follow(self) -> None:
        """Perform all steps.

        Raises
        ------
        StepError
            If something that the page names does not appear.
        """
        while not self.done:
            QApplication.processEvents()
            time.sleep(0.005)
        if self.error is not None:
            raise self.error

    # -- sequence of the steps -------------------------------------------------------------------

    def _beat(self) -> None:
        if self._begun:
            return
        try:
            act = next(self._course)
        except StopIteration:
            self._end(None)
        except BaseException as error:
            self._end(error)
        else:
            if act is not None:
                self._begun += 1
                QTimer.singleShot(0, lambda: self._do(act))

    def _do(self, act: Act) -> None:
        self._begun -= 1  # first, because act may open a dialogue and return when that is closed
        try:
            act()
        except BaseException as error:
            self._end(error)

    def _end(self, error: BaseException | None) -> None:
        if self.done:
            return
        self._timer.stop()
        if error is not None and self.at is not None:
            error.add_note(f"at line {self.at.line} of the page: {self.at.kind} {self.at.text!r}")
        self.error, self.done = error, True
        while (dialog := QApplication.activeModalWidget()) is not None:
            dialog.done(0) if isinstance(dialog, QDialog) else dialog.close()

    def _through(self, steps: list[Step]) -> Iterator[Act | None]:
        for step in steps:
            self.at = step
            yield from self._rest()
            if step.kind == "click":
                yield from self._click(step.text)
            elif step.kind == "menu":
                yield from self._choose(step.text.split(" > "))
            elif step.kind == "press":
                yield from self._press(step.text)
            elif step.kind == "type":
                yield from self._type(step.text)
            elif step.kind == "see":
                yield from self._until(lambda text=step.text: self._is_visible(text), "is not seen")
            else:
                for _ in range(12):
                    yield None
                self._take_picture(self.front, step.text)
        yield from self._rest()

    def _rest(self) -> Iterator[None]:
        """Wait until no task is active and no result is awaited."""
        yield None
        yield from self._until(
            lambda: not (self._window.runner.active or self._window.document.awaits_result),
            "waits for work without end",
            TASK_TIMEOUT_S,
        )

    def _until(
        self, there: Callable[[], object], problem: str, timeout_s: float | None = None
    ) -> Iterator[None]:
        end = time.monotonic() + (timeout_s or TIMEOUT_S)
        while not there():
            if time.monotonic() > end:
                assert self.at is not None
                raise StepError(f"{self.at.text!r} {problem}")
            yield None

    # -- visible widgets -------------------------------------------------------------------------

    @property
    def front(self) -> QWidget:
        """Window that receives mouse and key events."""
        return QApplication.activeModalWidget() or self._window

    def _all(self, kind: type) -> list:
        found = self.front.findChildren(kind)
        return [each for each in found if shiboken6.isValid(each) and each.isVisible()]

    def _is_visible(self, text: str) -> bool:
        if text in self.front.windowTitle():
            return True
        for widget in self._all(QWidget):
            if isinstance(widget, (QLabel, QAbstractButton, QLineEdit)) and text in _plain(widget):
                return True
            if isinstance(widget, QTableWidget):
                items = (
                    widget.item(row, column)
                    for row in range(widget.rowCount())
                    for column in range(widget.columnCount())
                )
                if any(item is not None and text in item.text() for item in items):
                    return True
        return any(text in widget.windowTitle() for widget in self._all(QDockWidget))

    def _called(self, text: str) -> list[tuple[QWidget, QPoint]]:
        """Visible widgets with a text, each with the point to click."""
        popup = QApplication.activePopupWidget()
        if popup is not None:
            return [place for view in popup.findChildren(QListView) for place in _rows(view, text)]
        found: list[tuple[QWidget, QPoint]] = []
        for button in self._all(QAbstractButton):
            if text in {_plain(button), *(_plain(each) for each in button.findChildren(QLabel))}:
                found.append((button, button.rect().center()))
        for bar in self._all(QTabBar):
            for k in range(bar.count()):
                if bar.tabText(k).replace("&", "") == text:
                    found.append((bar, bar.tabRect(k).center()))
        for label in self._all(QLabel):
            # An asterisk marks a needed field
            name = _plain(label).removesuffix(" *")
            if name == text and (field := _field_of(label)) is not None:
                found.append((field, field.rect().center()))
        return found

    # -- by mouse and keys -----------------------------------------------------------------------

    def _click(self, text: str) -> Iterator[Act | None]:
        yield from self._until(lambda: self._called(text), "is not there to be clicked")
        found = self._called(text)
        if len(found) > 1:
            raise StepError(f"{text!r} stands there {len(found)} times")
        widget, place = found[0]
        if not widget.isEnabled():
            raise StepError(f"{text!r} is greyed")
        parent = widget.parent()
        while parent is not None:
            if isinstance(parent, QScrollArea):
                parent.ensureWidgetVisible(widget)
            parent = parent.parent()
        yield None
        if widget.visibleRegion().isEmpty():
            raise StepError(f"{text!r} is out of sight")
        yield lambda: QTest.mouseClick(widget, Left, Qt.KeyboardModifier.NoModifier, place)
        if isinstance(widget, QComboBox):
            for _ in range(30):  # Qt would take a sooner click as part of a double click
                yield None

    def _choose(self, names: list[str]) -> Iterator[Act | None]:
        bar = self._window.menuBar()
        menu: QWidget = bar
        for name in names:
            found = [a for a in menu.actions() if a.text().replace("&", "") == name]
            if not found:
                raise StepError(f"no menu has {name!r}")
            (action,) = found
            if not action.isEnabled():
                raise StepError(f"{name!r} is greyed")
            place = menu.actionGeometry(action).center()

            def act(menu: QWidget = menu, place: QPoint = place) -> None:
                QTest.mouseClick(menu, Left, Qt.KeyboardModifier.NoModifier, place)

            yield act
            yield None
            if action.menu() is not None:
                menu = action.menu()
                yield from self._until(menu.isVisible, "does not open")
                assert isinstance(menu, QMenu)

    def _press(self, keys: str) -> Iterator[Act | None]:
        if keys in CTRL_CLICK:
            canvas = self._window.viewport.canvas
            middle = canvas.rect().center()
            yield lambda: QTest.mouseClick(canvas, Left, Control, middle)
            yield from self._rest()
            return
        sequence = QKeySequence(KEY_NAMES.get(keys, keys))[0]
        key, modifiers = sequence.key(), sequence.keyboardModifiers()
        front = self.front
        # In a dialogue, keys go to its focused widget (in a file dialogue, the line for the name)
        target = front if front is self._window else (front.focusWidget() or front)
        yield lambda: QTest.keyClick(target, key, modifiers)

    def _type(self, text: str) -> Iterator[Act | None]:
        front = self.front
        if isinstance(front, QFileDialog):
            field: QWidget | None = front.findChild(QLineEdit, "fileNameEdit")
        else:
            field = front.focusWidget()
        if not isinstance(field, (QLineEdit, QPlainTextEdit)):
            raise StepError(f"nothing is there to type {text!r} into")
        field.selectAll()

        def act() -> None:
            for letter in text:
                if ord(letter) < 128:
                    QTest.keyClick(field, letter)
                else:
                    QTest.sendKeyEvent(
                        QTest.KeyAction.Click, field, Qt.Key.Key_unknown, letter,
                        Qt.KeyboardModifier.NoModifier,
                    )  # fmt: skip

        yield act


def _plain(widget: QWidget) -> str:
    """Text of a widget without mnemonics and tags, with uniform blanks."""
    text = widget.text().replace("&&", "\0").replace("&", "").replace("\0", "&")
    return " ".join(re.sub(r"<[^>]+>", " ", text).split())


def _rows(view: QListView, text: str) -> list[tuple[QWidget, QPoint]]:
    """Entries of an open list with the given text."""
    model = view.model()
    entries = [model.index(row, 0) for row in range(model.rowCount())]
    return [
        (view.viewport(), view.visualRect(each).center()) for each in entries if each.data() == text
    ]


def _field_of(label: QLabel) -> QWidget | None:
    """Field beside a label in a form."""
    for form in label.parentWidget().findChildren(QFormLayout):
        row, role = form.getWidgetPosition(label)
        if row >= 0 and role == QFormLayout.ItemRole.LabelRole:
            item = form.itemAt(row, QFormLayout.ItemRole.FieldRole)
            if item.widget() is not None:
                return item.widget()
            inside = item.layout()
            return inside.itemAt(0).widget() if inside is not None else None
    return None


def picture_file(page: Path, name: str) -> Path:
    """Path of a picture of a page."""
    return page.parent / name
