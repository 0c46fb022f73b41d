"""Actions of the monkey: mouse and key events on visible widgets, sent to the native windows.

Each action is a generator that yields after every event, so that the program can process it before
the next one. Only files in the monkey's folder are named.
"""

import random
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import ClassVar

from PySide6.QtCore import QCoreApplication, QMimeData, QPoint, QPointF, QRect, Qt, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent, QWheelEvent, QWindow
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QDockWidget,
    QFileDialog,
    QHeaderView,
    QLineEdit,
    QMainWindow,
    QMenu,
    QMenuBar,
    QPlainTextEdit,
    QScrollBar,
    QSlider,
    QSplitterHandle,
    QTabBar,
    QTextEdit,
    QWidget,
)
from shiboken6 import isValid

Key, Button, Modifier = Qt.Key, Qt.MouseButton, Qt.KeyboardModifier
Doing = Iterator[None]

TYPED_TEXTS = (
    "1", "0", "12.5", "-3", "0.02", "45", "1e9", "-1e-9", "nan", "inf", "1,5", "12 m", "north",
    "T1", "Mur à l'est", "", " ", "°", "%s {x} \\", "日本", "x" * 80, "2026-02-30", "5/0", "../up",
)  # fmt: skip
PRESSED_KEYS = (
    "F3", "F5", "F6", "F7", "F9", "F9", "F10", "F10", "F11", "F1", "Ctrl+Z", "Ctrl+Z", "Ctrl+Z",
    "Ctrl+Y", "Ctrl+Y", "Ctrl+S", "Ctrl+E", "Ctrl+O", "Ctrl+N", "Ctrl+,", "Ctrl+.", "Ctrl+Shift+D",
    "Return", "Return", "Return", "Escape", "Escape", "B", "Tab", "Tab", "Delete", "Space", "Up",
    "Down", "Left", "Right", "PgUp", "PgDown", "Home", "End", "F2", "Shift+F9", "Shift+F3", "1",
    "2", "3", "Alt+F", "Menu",
)  # fmt: skip


class Hands:
    """Chooses a visible widget at random and acts on it.

    Parameters
    ----------
    chance : random.Random
    folder : the only folder whose files it names
    """

    def __init__(self, chance: random.Random, folder: Path) -> None:
        self.chance, self._folder = chance, folder
        self.did = ""

    # -- choice of the action --------------------------------------------------------------------

    @staticmethod
    def front() -> list[QWidget]:
        """Windows that accept mouse and key events at present."""
        popup, modal = QApplication.activePopupWidget(), QApplication.activeModalWidget()
        if popup is not None or modal is not None:
            return [popup or modal]
        return [
            widget
            for widget in QApplication.topLevelWidgets()
            if widget.isVisible() and isinstance(widget, (QMainWindow, QDockWidget))
        ]

    def doing(self) -> Doing | None:
        """Choose an action on a visible window; None if no window is visible."""
        front = self.front()
        if not front:
            return None
        window = self.chance.choice(front)
        self.did = ""
        if isinstance(window, QFileDialog):
            return self._name_a_file(window)
        if isinstance(window, QMenu):
            return self._choose(window)
        if not window.isActiveWindow():
            window.activateWindow()
        draw = self.chance.random()
        if draw < 0.12:
            return self.press(window, self.chance.choice(PRESSED_KEYS))
        if draw < 0.15 and isinstance(window, QMainWindow):
            return self._drop(window)
        if draw < 0.22 and window.isModal():
            return self.press(window, "Escape")
        if draw < 0.25:
            return self._anywhere(window)
        return self._something(window)

    def _something(self, window: QWidget) -> Doing:
        """Choose a kind of widget in a window, then a widget of that kind."""
        by_kind: dict[type, list[QWidget]] = {}
        for widget in window.findChildren(QWidget):
            if widget.isVisible() and widget.isEnabled() and widget.window() is window:
                kind = next((kind for kind in self._doings if isinstance(widget, kind)), None)
                if kind is None and {c.__name__ for c in type(widget).__mro__} & CANVASES:
                    kind = QWidget
                if kind is not None:
                    by_kind.setdefault(kind, []).append(widget)
        if not by_kind:
            return self._anywhere(window)
        kinds = sorted(by_kind, key=lambda kind: kind.__name__)
        for _ in range(20):
            kind = self.chance.choices(kinds, [WEIGHTS.get(kind, 2) for kind in kinds])[0]
            widget = self.chance.choice(by_kind[kind])
            visible_area = widget.visibleRegion().boundingRect()
            if not visible_area.isEmpty():
                return self._doings.get(kind, Hands._draw)(self, widget, visible_area)
        return self._anywhere(window)

    # -- mouse and keys --------------------------------------------------------------------------

    def _record(self, what: str, widget: QWidget) -> None:
        name = widget.objectName() or type(widget).__name__
        shown = widget.text() if isinstance(widget, QAbstractButton) else ""
        top = widget.window()
        self.did = f"{what} {name} {shown!r} in {top.objectName() or type(top).__name__}"

    def _within(self, area: QRect) -> QPoint:
        return QPoint(
            self.chance.randint(area.left(), area.right()),
            self.chance.randint(area.top(), area.bottom()),
        )

    def _at(self, widget: QWidget, spot: QPoint) -> tuple[QWindow | None, QPoint]:
        return widget.window().windowHandle(), widget.mapTo(widget.window(), spot)

    def click(
        self,
        widget: QWidget,
        spot: QPoint,
        button: Button = Button.LeftButton,
        modifier: Modifier = Modifier.NoModifier,
    ) -> None:
        """Click a spot of a widget."""
        handle, place = self._at(widget, spot)
        if handle is not None:
            QTest.mouseMove(handle, place)
            QTest.mouseClick(handle, button, modifier, place)

    def _double_click(self, widget: QWidget, spot: QPoint) -> None:
        handle, place = self._at(widget, spot)
        if handle is not None:
            QTest.mouseDClick(handle, Button.LeftButton, Modifier.NoModifier, place)

    def _drag(
        self, widget: QWidget, start: QPoint, end: QPoint, button: Button, modifier: Modifier
    ) -> Doing:
        handle, first = self._at(widget, start)
        last = self._at(widget, end)[1]
        if handle is None:
            return
        QTest.mousePress(handle, button, modifier, first)
        try:
            for k in range(1, 6):
                yield
                if not isValid(handle):  # the window was closed during the drag
                    return
                QTest.mouseMove(handle, first + (last - first) * (k / 5))
        finally:
            if isValid(handle):
                QTest.mouseRelease(handle, button, modifier, last)

    def _wheel(self, widget: QWidget, spot: QPoint) -> None:
        turn = self.chance.choice((-360, -120, 120, 360))
        event = QWheelEvent(
            QPointF(spot), QPointF(widget.mapToGlobal(spot)), QPoint(), QPoint(0, turn),
            Button.NoButton, Modifier.NoModifier, Qt.ScrollPhase.NoScrollPhase, False,
        )  # fmt: skip
        QCoreApplication.sendEvent(widget, event)

    def press(self, window: QWidget, keys: str) -> Doing:
        """Press a key with its modifiers."""
        self._record(f"key {keys}", window)
        handle = window.windowHandle()
        *modifiers, name = keys.split("+")
        modifier = Modifier.NoModifier
        for each in modifiers:
            modifier |= {
                "Ctrl": Modifier.ControlModifier,
                "Shift": Modifier.ShiftModifier,
                "Alt": Modifier.AltModifier,
            }[each]
        names = {"PgUp": "PageUp", "PgDown": "PageDown", ",": "Comma", ".": "Period"}
        if handle is not None:
            QTest.keyClick(handle, getattr(Key, f"Key_{names.get(name, name)}"), modifier)
        yield

    def _type(self, widget: QWidget, text: str) -> Doing:
        """Type a text into the widget that has the focus."""
        for letter in text:
            handle = widget.window().windowHandle()
            if handle is None or not widget.isVisible():
                return
            if ord(letter) < 128:
                QTest.keyClick(handle, letter)
            else:
                QTest.sendKeyEvent(
                    QTest.KeyAction.Click, widget, Key.Key_unknown, letter, Modifier.NoModifier
                )
            yield

    # -- actions for each kind of widget ---------------------------------------------------------

    def _anywhere(self, window: QWidget) -> Doing:
        self._record("anywhere", window)
        area = window.rect()
        start = self._within(area)
        button = self.chance.choice((Button.LeftButton, Button.LeftButton, Button.RightButton))
        if self.chance.random() < 0.5:
            self.click(window, start, button)
            yield
        else:
            yield from self._drag(window, start, self._within(area), button, Modifier.NoModifier)

    def _push(self, widget: QWidget, visible_area: QRect) -> Doing:
        self._record("click", widget)
        self.click(widget, visible_area.center())
        yield

    def _choose(self, menu: QMenu) -> Doing:
        actions = [a for a in menu.actions() if a.isEnabled() and a.isVisible() and a.text()]
        if not actions or self.chance.random() < 0.1:
            yield from self.press(menu, "Escape")
            return
        action = self.chance.choice(actions)
        self._record(f"menu {action.text()!r}", menu)
        self.click(menu, menu.actionGeometry(action).center())
        yield

    def _open_menu(self, bar: QMenuBar, _visible_area: QRect) -> Doing:
        action = self.chance.choice(bar.actions())
        self._record(f"menu {action.text()!r}", bar)
        self.click(bar, bar.actionGeometry(action).center())
        yield

    def _turn_to(self, tabs: QTabBar, _visible_area: QRect) -> Doing:
        self._record("tab", tabs)
        self.click(tabs, tabs.tabRect(self.chance.randrange(max(tabs.count(), 1))).center())
        yield

    def _touch_cell(self, view: QAbstractItemView, visible_area: QRect) -> Doing:
        self._record("cell", view)
        spot = self._within(visible_area)
        index = view.indexAt(spot)
        cell = view.visualRect(index) if index.isValid() else visible_area
        draw = self.chance.random()
        if draw < 0.3:
            self.click(view.viewport(), QPoint(cell.left() + 10, cell.center().y()))
        elif draw < 0.6:
            self.click(view.viewport(), cell.center())
        elif draw < 0.75:
            self._double_click(view.viewport(), cell.center())
            yield
            editor = QApplication.focusWidget()
            if isinstance(editor, QLineEdit):
                yield from self._fill(editor, editor.rect())
        elif draw < 0.85:
            self.click(view.viewport(), cell.center(), Button.RightButton)
        else:
            self.click(view.viewport(), cell.center())
            yield
            yield from self.press(
                view.window(), self.chance.choice(("F2", "Space", "Delete", "Down", "Up", "A"))
            )
        yield

    def _fill(self, field: QWidget, visible_area: QRect) -> Doing:
        text = self.chance.choice(TYPED_TEXTS)
        self._record(f"type {text!r} into", field)
        self.click(field, visible_area.center())
        yield
        if self.chance.random() < 0.8 and (handle := field.window().windowHandle()) is not None:
            QTest.keyClick(handle, Key.Key_A, Modifier.ControlModifier)
            yield
        yield from self._type(field, text)
        if field.isVisible():
            yield from self.press(field.window(), self.chance.choice(("Return", "Tab", "Tab")))

    def _pull_down(self, combo: QComboBox, visible_area: QRect) -> Doing:
        self._record("pull down", combo)
        if self.chance.random() < 0.5:
            self.click(combo, visible_area.center())
        else:
            self._wheel(combo, visible_area.center())
        yield

    def _slide(self, slider: QWidget, visible_area: QRect) -> Doing:
        self._record("slide", slider)
        yield from self._drag(
            slider,
            self._within(visible_area),
            self._within(visible_area),
            Button.LeftButton,
            Modifier.NoModifier,
        )

    def _draw(self, canvas: QWidget, visible_area: QRect) -> Doing:
        """Act on a widget that shows the lines, a plan or a diagram."""
        self._record("canvas", canvas)
        spot, draw = self._within(visible_area), self.chance.random()
        if draw < 0.35:
            self.click(canvas, spot, modifier=Modifier.ControlModifier)
        elif draw < 0.5:
            self.click(canvas, spot)
        elif draw < 0.6:
            self._double_click(canvas, spot)
        elif draw < 0.75:
            self._wheel(canvas, spot)
        elif draw < 0.8:
            self.click(canvas, spot)
            yield
            yield from self.press(canvas.window(), self.chance.choice(("Up", "Left", "PgUp")))
        else:
            button = self.chance.choice(
                (Button.LeftButton, Button.LeftButton, Button.MiddleButton, Button.RightButton)
            )
            modifier = self.chance.choice(
                (Modifier.NoModifier, Modifier.ShiftModifier, Modifier.ControlModifier)
            )
            yield from self._drag(canvas, spot, self._within(visible_area), button, modifier)
        yield

    # -- files -----------------------------------------------------------------------------------

    def files(self) -> list[Path]:
        """Files that the monkey may drop and open."""
        return sorted(
            path
            for path in self._folder.rglob("*")
            if path.is_file() and not {"cache", "home"} & {*path.relative_to(self._folder).parts}
        )

    def _name_a_file(self, dialog: QFileDialog) -> Doing:
        """Answer a file dialogue with an existing or new name in the folder, or cancel it."""
        opening = dialog.acceptMode() == QFileDialog.AcceptMode.AcceptOpen
        draw = self.chance.random()
        name = dialog.findChild(QLineEdit, "fileNameEdit")
        if draw < 0.25 or name is None:
            yield from self.press(dialog, "Escape")
            return
        files = self.files()
        if opening and dialog.fileMode() == QFileDialog.FileMode.Directory:
            path = self._folder / self.chance.choice(("harbour", "away", "."))
        elif opening:
            projects = [path for path in files if path.name == "project.json"]
            path = self.chance.choice(projects if draw < 0.5 and projects else files)
        else:
            path = self._folder / "written" / self.chance.choice(("a", "b.pdf", "c.html", "d.csv"))
        self._record(f"file {path.relative_to(self._folder)}", dialog)
        name.setFocus()
        name.selectAll()
        yield
        yield from self._type(name, str(path))
        if dialog.isVisible():
            yield from self.press(dialog, "Return")

    def _drop(self, window: QWidget) -> Doing:
        files = self.files()
        raw = [path for path in files if path.parent.name == "raw"]
        projects = [path.parent for path in files if path.name == "project.json"]

        def some(paths: Sequence[Path]) -> list[Path]:
            return self.chance.sample(paths, min(len(paths), self.chance.randint(1, 3)))

        paths = self.chance.choice((raw, some(raw), some(files), some(projects), some(projects)))
        self._record(f"drop {[str(p.relative_to(self._folder)) for p in paths]}", window)
        mime = QMimeData()
        mime.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
        spot, copy = window.rect().center(), Qt.DropAction.CopyAction
        kind = (copy, mime, Button.LeftButton, Modifier.NoModifier)
        QCoreApplication.sendEvent(window, QDragEnterEvent(spot, *kind))
        QCoreApplication.sendEvent(window, QDropEvent(QPointF(spot), *kind))
        yield

    _doings: ClassVar[dict[type, Callable[..., Doing]]] = {
        QAbstractButton: _push, QMenuBar: _open_menu, QTabBar: _turn_to, QHeaderView: _slide,
        QAbstractItemView: _touch_cell, QComboBox: _pull_down, QAbstractSpinBox: _fill,
        QLineEdit: _fill, QPlainTextEdit: _fill, QTextEdit: _fill, QSlider: _slide,
        QScrollBar: _slide, QSplitterHandle: _slide,
    }  # fmt: skip


CANVASES = {"Chart", "Canvas", "Gizmo", "TimelineView"}
WEIGHTS = {QAbstractButton: 6, QMenuBar: 5, QWidget: 6, QAbstractItemView: 4, QTabBar: 3}
