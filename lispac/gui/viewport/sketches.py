"""Sketches, handles and outlines of tools over the picture."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QObject, QPointF, QRectF, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen, QPolygonF

from lispac.gui.appearance import theme, units
from lispac.gui.viewport.base import Array, DragHandle, PickedPoint, Sketch, ViewportSignals
from lispac.gui.viewport.camera import Camera, ViewportSize
from lispac.gui.viewport.navigation import SNAP_RADII_PX, Navigator
from lispac.gui.viewport.overlay import Overlay, has_right_neighbour
from lispac.gui.viewport.point_picker import pick_point
from lispac.language import gettext

GRAB_RADIUS_PX = 9.0
"""Largest distance of the mouse from a handle at which it can be dragged, pixels."""
HOVER_DELAY_MS = 40
"""Time for which the mouse must rest before the point under it is searched for."""
MAX_HOVER_POINTS = 250_000
"""Largest number of drawn points that are searched for the point under the mouse."""
LABEL_TOP_PX = 42.0
"""Smallest distance of a label from the top, pixels, so that the hint does not hide it."""
MIN_AXIS_SINE = 0.25
"""Sine of the angle between axis and view below which a handle cannot be moved."""


@dataclass(eq=False)
class _HandleDrag:
    """Handle during a drag.

    Attributes
    ----------
    sketch, handle : name of the sketch and index of the handle
    place, axis : position at the start of the drag and direction, shape (3,), local frame
    mouse_position : last position of the mouse along the axis, metres from ``place``
    """

    sketch: str
    handle: int
    place: Array
    axis: Array
    mouse_position: float


class SketchLayer(QObject):
    """Draws sketches and outlines on the overlay and moves handles.

    Attributes
    ----------
    share : share of the width of the picture to the left of the dividing line
    """

    divider_moved = Signal()
    """The dividing line was moved."""

    def __init__(self, navigator: Navigator, overlay: Overlay, signals: ViewportSignals) -> None:
        super().__init__(navigator)
        self._navigator, self._overlay, self._signals = navigator, overlay, signals
        self._sketches: dict[str, Sketch] = {}
        self._outline: list[QPointF] = []
        self._drag: _HandleDrag | None = None
        self._picture = navigator.pictures[0]  # in which a handle is dragged
        self._mouse_position: tuple[float, float] | None = None
        self._is_over_point = False
        self.share = 0.5
        self._drags_dividing_line = self._shows_dividing_line = False
        self._hover_timer = QTimer(self, singleShot=True, interval=HOVER_DELAY_MS)
        self._hover_timer.timeout.connect(self._emit_hovered)
        mouse = navigator.mouse
        mouse.try_grab = self._grab_handle
        mouse.handle_dragged.connect(self._drag_handle)
        mouse.handle_released.connect(self._on_handle_released)
        mouse.outlining.connect(self._extend_outline)
        mouse.outlined.connect(self._finish_outline)
        mouse.mouse_moved.connect(self._on_mouse_moved)
        mouse.mouse_left.connect(self.stop_hovering)
        navigator.moved.connect(self._clear_hovered)
        navigator.move_ended.connect(self._search_later)
        mouse.nudged.connect(self._shift_dividing_line)
        overlay.paint_hooks.append(self._paint)

    def show(self, name: str, sketch: Sketch | None) -> None:
        """Draw a sketch; None removes it."""
        self._sketches.pop(name, None)
        if sketch is not None:
            self._sketches[name] = sketch
        self._overlay.update()

    def clear(self) -> None:
        """Remove all sketches."""
        self._sketches, self._outline, self._drag = {}, [], None
        self.stop_hovering()

    def show_dividing_line(self, visible: bool) -> None:
        """Show the line that divides the picture, or hide it and move it to the middle."""
        self._shows_dividing_line = visible
        if not visible:
            self.share = 0.5
        self._overlay.update()

    def stop_hovering(self) -> None:
        """Cancel the search for the point under the mouse, and report that there is none."""
        self._mouse_position = None
        self._clear_hovered()

    def _clear_hovered(self) -> None:
        self._hover_timer.stop()
        if self._is_over_point:
            self._is_over_point = False
            self._signals.hovered.emit(None)

    def _search_later(self) -> None:
        if self._mouse_position is not None:
            self._hover_timer.start()  # restarts while the mouse moves

    # The mouse

    def _handles(self) -> list[tuple[str, int, DragHandle]]:
        return [
            (name, k, handle)
            for name, sketch in self._sketches.items()
            for k, handle in enumerate(sketch.handles)
        ]

    def _grab_handle(self, x: float, y: float) -> bool:
        width = self._navigator.size.width
        self._drags_dividing_line = (
            self._shows_dividing_line and abs(x - self.share * width) <= GRAB_RADIUS_PX
        )
        if self._drags_dividing_line:
            return True
        handles = self._handles()
        if not handles:
            return False
        places = np.array([handle.position for _, _, handle in handles])
        picture = self._navigator.picture_at(x, y)
        size = self._navigator.size_of(picture)
        spots = self._navigator.camera_of(picture).project(places, size)
        self._picture = picture
        x, y = self._navigator.local(picture, x, y)
        distances = np.hypot(spots[:, 0] - x, spots[:, 1] - y)
        distances[~(distances <= GRAB_RADIUS_PX)] = np.inf
        if not np.isfinite(distances).any():
            return False
        # Of overlapping handles, the one in front is used.
        nearest = int(np.argmin(np.where(np.isfinite(distances), spots[:, 2], np.inf)))
        name, k, handle = handles[nearest]
        place, axis = np.array(handle.position), np.array(handle.axis)
        self._drag = _HandleDrag(
            name, k, place, axis, self._distance_along_axis(place, axis, x, y) or 0.0
        )
        return True

    def _drag_handle(self, x: float, y: float) -> None:
        if self._drags_dividing_line:
            self._move_dividing_line(x)
            return
        drag = self._drag
        if drag is None:
            return
        x, y = self._navigator.local(self._picture, x, y)
        now = self._distance_along_axis(drag.place, drag.axis, x, y)
        if now is not None:
            moved, drag.mouse_position = now - drag.mouse_position, now
            self._signals.handle_moved.emit(drag.sketch, drag.handle, moved)

    def _move_dividing_line(self, x: float) -> None:
        self.share = min(max(x / self._navigator.size.width, 0.02), 0.98)
        self.divider_moved.emit()

    def _shift_dividing_line(self, right: float) -> None:
        if self._shows_dividing_line:
            self._move_dividing_line(self.share * self._navigator.size.width + right)

    def _distance_along_axis(self, place: Array, axis: Array, x: float, y: float) -> float | None:
        """Position of the mouse along an axis, metres; None if the axis points at the camera."""
        camera = self._navigator.camera_of(self._picture)
        size = self._navigator.size_of(self._picture)
        eye = camera.point_at(x, y, 0.0, size)
        ray = camera.point_at(x, y, 1.0, size) - eye
        ray /= np.linalg.norm(ray)
        cosine = float(axis @ ray)
        if 1.0 - cosine**2 < MIN_AXIS_SINE**2:
            return None
        # The point of the axis nearest to the ray through the mouse.
        to_eye = eye - place
        return float(axis @ to_eye - cosine * (ray @ to_eye)) / (1.0 - cosine**2)

    def _on_handle_released(self) -> None:
        drag, self._drag, self._drags_dividing_line = self._drag, None, False
        if drag is not None:
            self._signals.handle_released.emit(drag.sketch)

    def _extend_outline(self, x: float, y: float) -> None:
        self._outline.append(QPointF(x, y))
        self._overlay.update()

    def _finish_outline(self) -> None:
        corners = np.array([(spot.x(), spot.y()) for spot in self._outline])
        self._outline = []
        self._overlay.update()
        if len(corners) > 2:
            self._signals.outlined.emit(corners)

    def _on_mouse_moved(self, x: float, y: float) -> None:
        self._mouse_position = (x, y)
        self._search_later()

    def _emit_hovered(self) -> None:
        if self._mouse_position is None:
            return
        navigator = self._navigator
        picture = navigator.picture_at(*self._mouse_position)
        drawn = picture.drawn()
        step = -(-sum(map(len, drawn.values())) // MAX_HOVER_POINTS) or 1
        clouds = {line: points[::step] for line, points in drawn.items()}
        hit = pick_point(
            clouds, navigator.camera_of(picture), *navigator.local(picture, *self._mouse_position),
            navigator.size_of(picture), SNAP_RADII_PX,
        )  # fmt: skip
        if hit is None:
            self._clear_hovered()
            return
        self._is_over_point = True
        place = picture.place_in_view(hit.line, clouds[hit.line][hit.index])
        north, west, up = (float(v) for v in place)
        self._signals.hovered.emit(PickedPoint(hit.line, (north, west, up)))

    # The picture

    def _paint(self, painter: QPainter, camera: Camera, size: ViewportSize) -> None:
        for sketch in self._sketches.values():
            _paint_sketch(painter, sketch, camera, size)
        # Labels last: no line crosses them, and none overlap
        taken = self._overlay.label_boxes
        _paint_labels(painter, list(self._sketches.values()), camera, size, taken)
        if self._shows_dividing_line:
            _paint_dividing_line(painter, self.share * size.width, size)
        if len(self._outline) > 1:
            painter.setBrush(QColor(*theme.CANDIDATE_COLOUR, 45))
            painter.setPen(QPen(QColor(theme.TEXT), 1.4, Qt.PenStyle.DashLine))
            painter.drawPolygon(QPolygonF(self._outline))


def _paint_dividing_line(painter: QPainter, x: float, size: ViewportSize) -> None:
    painter.setPen(QPen(theme.colour("paper", 0.9), 5.0))
    painter.drawLine(QPointF(x, 0.0), QPointF(x, size.height))
    painter.setPen(QPen(QColor(theme.TEXT), 1.6))
    painter.drawLine(QPointF(x, 0.0), QPointF(x, size.height))
    painter.setBrush(theme.colour("paper", 0.88))
    painter.drawEllipse(QPointF(x, 0.5 * size.height), 7.0, 7.0)
    metrics = QFontMetricsF(painter.font())
    for words, sign in ((gettext("Before"), -1), (gettext("After"), 1)):
        width = metrics.horizontalAdvance(words) + 16.0
        box = QRectF(x + (8.0 if sign > 0 else -8.0 - width), 44.0, width, 24.0)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.drawRoundedRect(box, 4.0, 4.0)
        painter.setPen(QColor(theme.TEXT))
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, words)
    painter.setBrush(Qt.BrushStyle.NoBrush)


def label_text(sketch: Sketch) -> str:
    """Label in the unit shown; in metres in a picture for a file."""
    return sketch.metric if sketch.metric and not units.is_converted("m") else sketch.label


def _paint_sketch(painter: QPainter, sketch: Sketch, camera: Camera, size: ViewportSize) -> None:
    colour = QColor(*sketch.colour)
    painter.setBrush(Qt.BrushStyle.NoBrush)
    if sketch.points:
        spots = camera.project(np.array(sketch.points), size)
        for pen in (QPen(theme.colour("paper", 0.86), 4.0), QPen(colour, 2.0)):
            pen.setCapStyle(Qt.PenCapStyle.RoundCap)
            painter.setPen(pen)
            for a, b in sketch.edges:
                if np.isfinite(spots[[a, b], :2]).all() and np.abs(spots[[a, b], :2]).max() < 1e5:
                    painter.drawLine(QPointF(*spots[a, :2]), QPointF(*spots[b, :2]))
        if sketch.dots:
            _paint_dots(painter, spots, colour, 4.0)
    if sketch.handles:
        places = np.array([handle.position for handle in sketch.handles])
        _paint_dots(painter, camera.project(places, size), colour, 6.0)


def _paint_labels(
    painter: QPainter,
    sketches: Sequence[Sketch],
    camera: Camera,
    size: ViewportSize,
    taken: Sequence[QRectF],
) -> None:
    """Paint the labels of sketches beside each other and beside the rectangles ``taken``."""
    labelled = [each for each in sketches if each.label and each.label_point is not None]
    if not labelled:
        return
    spots = camera.project(np.array([each.label_point for each in labelled]), size)[:, :2]
    occupied = list(taken)
    for k, sketch in enumerate(labelled):
        if np.isfinite(spots[k]).all():
            leftwards = has_right_neighbour(spots, k)
            spot, colour = QPointF(*spots[k]), QColor(*sketch.colour)
            box = _label_box(painter, label_text(sketch), spot, size, occupied, leftwards=leftwards)
            _paint_label(painter, label_text(sketch), box, colour)
            occupied.append(box)


def _paint_dots(painter: QPainter, spots: Array, colour: QColor, radius: float) -> None:
    painter.setPen(QPen(QColor(theme.TEXT), 1.4))
    painter.setBrush(colour)
    for x, y, _ in spots:
        if np.isfinite(x) and abs(x) < 1e5 and abs(y) < 1e5:
            painter.drawEllipse(QPointF(x, y), radius, radius)
    painter.setBrush(Qt.BrushStyle.NoBrush)


def _label_box(
    painter: QPainter,
    words: str,
    spot: QPointF,
    size: ViewportSize,
    occupied: Sequence[QRectF],
    *,
    leftwards: bool,
) -> QRectF:
    """Rectangle of a label beside its point, inside the picture and without overlap if possible.

    Parameters
    ----------
    leftwards : whether the left is preferred to the right
    """
    metrics = QFontMetricsF(painter.font())
    lines = words.split("\n")
    width = max(metrics.horizontalAdvance(line) for line in lines) + 16.0
    height = metrics.lineSpacing() * len(lines) + 8.0
    max_x, max_y = max(size.width - width - 4.0, 4.0), max(size.height - height - 4.0, 4.0)
    sides = [spot.x() + 14.0, spot.x() - 14.0 - width]
    places = [
        QRectF(min(max(x, 4.0), max_x), min(max(y, LABEL_TOP_PX), max_y), width, height)
        for y in (spot.y() - height - 10.0, spot.y() + 10.0)
        for x in (sides[::-1] if leftwards else sides)
    ]
    free = (box for box in places if not any(box.intersects(other) for other in occupied))
    return next(free, places[0])


def _paint_label(painter: QPainter, words: str, box: QRectF, colour: QColor) -> None:
    painter.setPen(QPen(colour.darker(115), 1.3))
    painter.setBrush(theme.colour("paper", 0.88))
    painter.drawRoundedRect(box, 4.0, 4.0)
    painter.setPen(QColor(theme.TEXT))
    text = box.adjusted(8.0, 4.0, -8.0, -4.0)
    painter.drawText(text, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, words)
