"""Drawing to scale with draggable objects: base class of the plan view and the wall view."""

from abc import abstractmethod

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QPainter, QPen
from PySide6.QtWidgets import QWidget

from lispac.gui.appearance import theme, units
from lispac.gui.features.design.workspace import Workspace
from lispac.io.config.plan_file import TitledPlan
from lispac.language import LazyText

Array = NDArray[np.float64]

MARGIN_PX = 34.0
"""Margin around the points of `DesignCanvas.bounds`, pixels."""
GRAB_RADIUS_PX = 9.0
"""Largest distance of the mouse from an object at which it can be dragged, pixels."""
GRID_STEPS = (0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0)
"""Grid intervals in the unit shown; the smallest one of at least `MIN_GRID_INTERVAL_PX` is used."""
MIN_GRID_INTERVAL_PX = 42.0


class DesignCanvas(QWidget):
    """Widget with scale, grid, mouse and keys for a drawing of the site.

    Parameters
    ----------
    title : str
        Accessible name.
    axes : tuple of str
        Labels of the horizontal and the vertical axis, with their unit.
    """

    def __init__(self, name: str, title: str, workspace: Workspace, axes: tuple[str, str]) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setAccessibleName(title)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setMouseTracking(True)
        self.setMinimumSize(240, 180)
        self.workspace, self._axes = workspace, axes
        self._drag_view: tuple[float, Array] | None = None
        self._cached_view: tuple[tuple[TitledPlan, int, int], tuple[float, Array]] | None = None
        workspace.changed.connect(self._on_plan_changed)
        workspace.selected.connect(self.update)

    def sizeHint(self) -> QSize:
        """Preferred size, in pixels."""
        return QSize(460, 340)

    def _on_plan_changed(self) -> None:
        """Redraw the plan; a drag ends if the plan was replaced."""
        if self._drag_view is not None and not self.workspace.is_dragging:
            self._end_drag()
        self.update()

    def _end_drag(self) -> LazyText:
        """End the drag and return the name of the undo step."""
        self._drag_view = None
        return self.end_edit()

    def hideEvent(self, event) -> None:
        """Cancel the drag."""
        if self._drag_view is not None:
            self._end_drag()
            self.workspace.cancel_drag()
        super().hideEvent(event)

    # -- scale -------------------------------------------------------------------------------

    @abstractmethod
    def bounds(self) -> Array:
        """Points that must be visible, shape (n, 2), metres."""

    @property
    def _view(self) -> tuple[float, Array]:
        """Pixels per metre and position of the centre, metres; both are fixed during a drag."""
        if self._drag_view is not None:
            return self._drag_view
        key = (self.workspace.titled, self.width(), self.height())
        if self._cached_view is None or self._cached_view[0] != key:
            self._cached_view = key, self._fitted_view()
        return self._cached_view[1]

    def _fitted_view(self) -> tuple[float, Array]:
        places = self.bounds()
        low, high = places.min(axis=0), places.max(axis=0)
        available = np.array([self.width(), self.height()]) - 2 * MARGIN_PX
        scale = float((np.maximum(available, 20.0) / np.maximum(high - low, 2.0)).min())
        return scale, (low + high) / 2

    def pixel(self, place: Array) -> QPointF:
        """Pixel of a position, shape (2,), metres."""
        scale, middle = self._view
        x, y = scale * (np.asarray(place) - middle)
        return QPointF(self.width() / 2 + float(x), self.height() / 2 - float(y))

    def place(self, pixel: QPointF) -> Array:
        """Position, shape (2,), metres, of a pixel; inverse of `pixel`."""
        scale, middle = self._view
        offset = np.array([pixel.x() - self.width() / 2, self.height() / 2 - pixel.y()])
        return np.asarray(middle + offset / scale)

    # -- drawing -----------------------------------------------------------------------------

    @abstractmethod
    def draw(self, painter: QPainter) -> None:
        """Draw the plan over the grid."""

    def paintEvent(self, event) -> None:
        """Paint grid and plan, in a frame that shows the focus."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), QColor(theme.PAPER))
        self._draw_grid(painter)
        self.draw(painter)
        painter.setPen(QPen(QColor(theme.ACCENT if self.hasFocus() else theme.BORDER), 1))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRect(QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5))
        painter.end()

    def _draw_grid(self, painter: QPainter) -> None:
        factor = units.shown_unit("m").factor
        scale = self._view[0] / factor
        shown = next((s for s in GRID_STEPS if s * scale >= MIN_GRID_INTERVAL_PX), GRID_STEPS[-1])
        step = shown / factor
        low = self.place(QPointF(0, self.height()))
        high = self.place(QPointF(self.width(), 0))
        font = theme.tabular_font(self.font())
        font.setPixelSize(10)
        painter.setFont(font)
        across, up = self._axes
        clear = self.width() - painter.fontMetrics().horizontalAdvance(across) - 30
        for axis in (0, 1):
            for k in range(int(np.ceil(low[axis] / step)), int(np.floor(high[axis] / step)) + 1):
                at = np.array([k * step, k * step])
                spot = self.pixel(at)
                painter.setPen(QPen(QColor(theme.GRID), 1))
                figure = units.localised(f"{k * shown:g}")
                if axis == 0:
                    painter.drawLine(QPointF(spot.x(), 0), QPointF(spot.x(), self.height()))
                    painter.setPen(QColor(theme.MUTED))
                    if 26 < spot.x() < clear:
                        painter.drawText(QPointF(spot.x() + 2, self.height() - 4), figure)
                else:
                    painter.drawLine(QPointF(0, spot.y()), QPointF(self.width(), spot.y()))
                    painter.setPen(QColor(theme.MUTED))
                    if 26 < spot.y() < self.height() - 18:
                        painter.drawText(QPointF(4, spot.y() - 2), figure)
        painter.setPen(QColor(theme.MUTED))
        corner = QRectF(0, self.height() - 17, self.width() - 4, 15)
        painter.drawText(corner, Qt.AlignmentFlag.AlignRight, across)
        painter.drawText(QPointF(4, 13), up)

    def draw_text(self, painter: QPainter, at: QPointF, text: str, colour: str = "") -> None:
        """Draw a text on a background that keeps it readable over lines."""
        font = QFont(self.font())
        font.setPixelSize(11)
        painter.setFont(font)
        box = painter.fontMetrics().boundingRect(text)
        ground = QRectF(at.x() - 2, at.y() - box.height() + 2, box.width() + 5, box.height())
        painter.fillRect(ground, theme.colour("paper", 0.8))
        painter.setPen(QColor(colour or theme.TEXT))
        painter.drawText(at, text)

    # -- mouse and keys ----------------------------------------------------------------------

    @abstractmethod
    def start_drag(self, at: QPointF) -> bool:
        """Start a drag of the object at a pixel; return whether there is one."""

    @abstractmethod
    def drag_to(self, at: QPointF, free: bool) -> None:
        """Drag the object to a pixel; ``free`` turns snapping off."""

    @abstractmethod
    def end_edit(self) -> LazyText:
        """Release the object and return the name of the undo step."""

    @abstractmethod
    def handle_key(self, key: Qt.Key, free: bool) -> bool:
        """Carry out the action of a key; return whether it has one."""

    @abstractmethod
    def cursor_shape_at(self, at: QPointF) -> Qt.CursorShape:
        """Shape of the mouse cursor at a pixel."""

    def mousePressEvent(self, event) -> None:
        """Start to drag the object under the mouse, and fix the scale."""
        if event.button() == Qt.MouseButton.LeftButton and self.start_drag(event.position()):
            self._drag_view = self._view

    def mouseMoveEvent(self, event) -> None:
        """Drag the object, or set the cursor for the object under the mouse."""
        if self._drag_view is not None and event.buttons() & Qt.MouseButton.LeftButton:
            free = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
            self.drag_to(event.position(), free)
        else:
            self.setCursor(self.cursor_shape_at(event.position()))

    def mouseReleaseEvent(self, event) -> None:
        """End the drag as one undo step."""
        if event.button() == Qt.MouseButton.LeftButton and self._drag_view is not None:
            self.workspace.end_drag(self._end_drag())
            self.update()

    def keyPressEvent(self, event) -> None:
        """Cancel a drag with Escape; pass other keys to `handle_key`, with Shift as ``free``."""
        free = bool(event.modifiers() & Qt.KeyboardModifier.ShiftModifier)
        if event.key() == Qt.Key.Key_Escape and self._drag_view is not None:
            self._end_drag()
            self.workspace.cancel_drag()
        elif event.modifiers() & ~(
            Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.KeypadModifier
        ) or not self.handle_key(Qt.Key(event.key()), free):
            super().keyPressEvent(event)
