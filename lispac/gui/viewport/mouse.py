"""Mouse and keys of the viewport, converted to signals.

Left drag: rotate. Middle, right or Shift+left drag: pan. Wheel: zoom. Ctrl+click: pick. Double
click: centre the view on a point. Arrows: rotate. Shift+arrows: pan. Ctrl+left and Ctrl+right: move
the dividing line. Page up and Page down: zoom at the centre. A Ctrl+drag has no effect. In the mode
"point", a click emits a point and a drag still rotates; in the mode "outline", a left drag draws.
If `try_grab` accepts the press of the left button, the drag moves a handle. A right click without
a movement requests a menu, Ctrl+C a copy. The side buttons go to the previous and next view.
"""

from collections.abc import Callable
from enum import Enum, auto

from PySide6.QtCore import QEvent, QObject, QPointF, Qt, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QApplication, QToolTip, QWidget

from lispac.gui.viewport.base import MouseMode

WHEEL_NOTCH_ANGLE = 120.0
"""Angle of one notch of a wheel, eighths of a degree as in Qt; touch pads send smaller angles."""


KEY_STEP_PX = 24.0
"""Length of a drag that is equivalent to one press of an arrow key."""

_ARROW_KEY_DRAGS = {
    Qt.Key.Key_Left: (-KEY_STEP_PX, 0.0),
    Qt.Key.Key_Right: (KEY_STEP_PX, 0.0),
    Qt.Key.Key_Up: (0.0, -KEY_STEP_PX),
    Qt.Key.Key_Down: (0.0, KEY_STEP_PX),
}
_PAGE_KEY_NOTCHES = {Qt.Key.Key_PageUp: 1.0, Qt.Key.Key_PageDown: -1.0}

_HISTORY_STEPS = {Qt.MouseButton.BackButton: -1, Qt.MouseButton.ForwardButton: 1}


class _Drag(Enum):
    """Action of a pressed mouse button."""

    NONE = auto()
    ROTATE = auto()
    PAN = auto()
    PICK = auto()
    OUTLINE = auto()
    GRAB = auto()


class ViewportMouse(QObject):
    """Converts mouse and key events of a widget to signals; positions are in its pixels."""

    drag_started = Signal(float, float)
    rotated = Signal(float, float)  # dx, dy since the last signal
    panned = Signal(float, float)
    drag_ended = Signal()
    zoomed = Signal(float, float, float)  # notches (positive zooms in), x, y
    picked = Signal(float, float)
    centred = Signal(float, float)
    pointed = Signal(float, float)
    outlining = Signal(float, float)
    outlined = Signal()
    handle_dragged = Signal(float, float)  # new position of the mouse
    handle_released = Signal()
    mouse_moved = Signal(float, float)  # position, without a button pressed
    mouse_left = Signal()
    nudged = Signal(float)  # pixels to the right, by Ctrl+arrow
    menu_requested = Signal(float, float)
    copy_requested = Signal()
    history_requested = Signal(int)  # steps forward, by the side buttons of the mouse

    def __init__(self, widget: QWidget) -> None:
        super().__init__(widget)
        self._widget = widget
        self._drag = _Drag.NONE
        self._press = QPointF()
        self._last = QPointF()
        self.mode: MouseMode = "navigate"
        self.key_position: Callable[[], tuple[float, float]] = lambda: (
            0.5 * widget.width(), 0.5 * widget.height()
        )  # fmt: skip
        """Function that returns the pixel at which keys act."""
        self.try_grab: Callable[[float, float], bool] = lambda _x, _y: False
        widget.setMouseTracking(True)
        widget.installEventFilter(self)

    def set_mode(self, mode: MouseMode) -> None:
        """Set the mode of the left mouse button."""
        self.mode = mode
        self._show_cursor(False)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Handle the events of the viewport; leave others to the widget."""
        kind = event.type()
        if isinstance(event, QMouseEvent):
            if kind == QEvent.Type.MouseButtonPress:
                self._pressed(event)
            elif kind == QEvent.Type.MouseMove:
                self._moved(event)
            elif kind == QEvent.Type.MouseButtonRelease:
                self._released(event)
            elif kind == QEvent.Type.MouseButtonDblClick:
                self._double_clicked(event)
            event.accept()
            return True
        if isinstance(event, QWheelEvent):
            notches = event.angleDelta().y() / WHEEL_NOTCH_ANGLE
            if notches:
                self.zoomed.emit(notches, event.position().x(), event.position().y())
            event.accept()
            return True
        if isinstance(event, QKeyEvent) and kind in (
            QEvent.Type.KeyPress,
            QEvent.Type.KeyRelease,
        ):
            if event.key() == Qt.Key.Key_Control:
                self._show_cursor(kind == QEvent.Type.KeyPress)
                # A tooltip covers the points to pick; the one after a click stays for reading.
                if kind == QEvent.Type.KeyPress and not event.isAutoRepeat():
                    QToolTip.hideText()
            elif kind == QEvent.Type.KeyPress and self._handle_key(event):
                event.accept()
                return True
            # Keep keys from VTK (q quits, w shows wireframes); the window may use them.
            event.ignore()
            return True
        if kind == QEvent.Type.Leave:
            self.mouse_left.emit()
        if kind in (QEvent.Type.Enter, QEvent.Type.Leave, QEvent.Type.FocusOut):
            self._show_cursor(
                kind == QEvent.Type.Enter and _is_control_pressed(QApplication.keyboardModifiers())
            )
            return kind != QEvent.Type.FocusOut
        return False

    def _handle_key(self, event: QKeyEvent) -> bool:
        """Move the view with a key; return whether the key was used."""
        if self._drag is not _Drag.NONE:
            return False
        if event.matches(QKeySequence.StandardKey.Copy):
            self.copy_requested.emit()
            return True
        key = Qt.Key(event.key())
        x, y = self.key_position()
        if key in _PAGE_KEY_NOTCHES:
            self.zoomed.emit(_PAGE_KEY_NOTCHES[key], x, y)
            return True
        if key not in _ARROW_KEY_DRAGS or event.modifiers() & Qt.KeyboardModifier.AltModifier:
            return False
        right, down = _ARROW_KEY_DRAGS[key]
        if _is_control_pressed(event.modifiers()):
            self.nudged.emit(right)
            return True
        self.drag_started.emit(x, y)
        shifted = event.modifiers() & Qt.KeyboardModifier.ShiftModifier
        (self.panned if shifted else self.rotated).emit(right, down)
        self.drag_ended.emit()
        return True

    def _pressed(self, event: QMouseEvent) -> None:
        if self._drag is not _Drag.NONE and event.buttons() != event.button():
            return  # a second button during a drag
        self._end_drag()
        if event.button() in _HISTORY_STEPS:
            self.history_requested.emit(_HISTORY_STEPS[event.button()])
            return
        self._press = self._last = event.position()
        self._drag = _drag_kind(event)
        x, y = self._press.x(), self._press.y()
        plain = event.button() == Qt.MouseButton.LeftButton and self._drag is _Drag.ROTATE
        if plain and self.try_grab(x, y):
            self._drag = _Drag.GRAB
        elif plain and self.mode == "outline":
            self._drag = _Drag.OUTLINE
            self.outlining.emit(x, y)
        if self._drag in (_Drag.ROTATE, _Drag.PAN):
            self.drag_started.emit(self._press.x(), self._press.y())

    def _moved(self, event: QMouseEvent) -> None:
        if event.buttons() == Qt.MouseButton.NoButton:
            self._end_drag()
        self._show_cursor(_is_control_pressed(event.modifiers()))
        step = event.position() - self._last
        self._last = event.position()
        if self._drag is _Drag.ROTATE:
            self.rotated.emit(step.x(), step.y())
        elif self._drag is _Drag.PAN:
            self.panned.emit(step.x(), step.y())
        elif self._drag is _Drag.OUTLINE:
            self.outlining.emit(self._last.x(), self._last.y())
        elif self._drag is _Drag.GRAB:
            self.handle_dragged.emit(self._last.x(), self._last.y())
        elif self._drag is _Drag.NONE:
            self.mouse_moved.emit(self._last.x(), self._last.y())

    def _released(self, event: QMouseEvent) -> None:
        if event.buttons() != Qt.MouseButton.NoButton:
            return
        drag = self._end_drag()
        distance = (event.position() - self._press).manhattanLength()
        if distance < QApplication.startDragDistance():
            if drag is _Drag.PICK:
                self.picked.emit(self._press.x(), self._press.y())
            elif drag is _Drag.ROTATE and self.mode == "point":
                self.pointed.emit(self._press.x(), self._press.y())
            elif event.button() == Qt.MouseButton.RightButton:
                self.menu_requested.emit(self._press.x(), self._press.y())

    def _end_drag(self) -> _Drag:
        """End the drag and return its kind.

        A dialogue that opens while a button is pressed receives the release of the button.
        """
        drag, self._drag = self._drag, _Drag.NONE
        if drag in (_Drag.ROTATE, _Drag.PAN):
            self.drag_ended.emit()
        elif drag is _Drag.OUTLINE:
            self.outlined.emit()
        elif drag is _Drag.GRAB:
            self.handle_released.emit()
        return drag

    def _double_clicked(self, event: QMouseEvent) -> None:
        plain = event.button() == Qt.MouseButton.LeftButton and not _is_control_pressed(
            event.modifiers()
        )
        if plain and self.mode == "navigate":
            self.centred.emit(event.position().x(), event.position().y())
        else:
            self._pressed(event)  # two quick clicks are two picks

    def _show_cursor(self, picking: bool) -> None:
        has_cross = picking or self.mode != "navigate"
        shape = Qt.CursorShape.CrossCursor if has_cross else Qt.CursorShape.ArrowCursor
        if self._widget.cursor().shape() != shape:
            self._widget.setCursor(shape)


def _is_control_pressed(modifiers: Qt.KeyboardModifier) -> bool:
    return bool(modifiers & Qt.KeyboardModifier.ControlModifier)


def _drag_kind(event: QMouseEvent) -> _Drag:
    button = event.button()
    if button == Qt.MouseButton.LeftButton:
        if _is_control_pressed(event.modifiers()):
            return _Drag.PICK
        shifted = event.modifiers() & Qt.KeyboardModifier.ShiftModifier
        return _Drag.PAN if shifted else _Drag.ROTATE
    if button in (Qt.MouseButton.MiddleButton, Qt.MouseButton.RightButton):
        return _Drag.PAN
    return _Drag.NONE
