"""What tools draw over the picture and what the mouse does to it: sketches, handles, outlines."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QObject, QPointF, QRectF, Qt, QTimer, Signal
from PySide6.QtGui import QColor, QFontMetricsF, QPainter, QPen, QPolygonF

from lispac.gui import theme, units
from lispac.gui.viewport.base import Array, Handle, PickedPoint, Sketch, ViewportSignals
from lispac.gui.viewport.camera import Camera, Size
from lispac.gui.viewport.navigation import SNAP, Navigator
from lispac.gui.viewport.overlay import Overlay, right_neighbour
from lispac.gui.viewport.point_picker import pick
from lispac.language import gettext

REACH = 9.0
"""Pixels about a handle within which it is taken."""
HOVER_MS = 40
"""Time at rest after which the point under the mouse is searched for."""
LOOKED_AT = 250_000
"""Drawn points that are searched for the one under the resting mouse."""
BELOW_HINT = 42.0
"""Pixels from the top below which words are not hidden by what the mouse does now."""
END_ON = 0.25
"""Sine between a handle's axis and the view below which the mouse cannot move it."""


@dataclass(eq=False)
class _HandleDrag:
    """A handle in the hand: its axis through where it was, and how far along the mouse is."""

    sketch: str
    handle: int
    place: Array
    axis: Array
    at: float


class Sketches(QObject):
    """Draws sketches and outlines on the overlay and moves handles.

    Attributes
    ----------
    hovering : whether the point under the mouse is emitted
    share : of the picture's width that is on the left of the dividing line
    """

    divided = Signal()
    """The dividing line was moved."""

    def __init__(self, navigator: Navigator, overlay: Overlay, signals: ViewportSignals) -> None:
        super().__init__(navigator)
        self._navigator, self._overlay, self._signals = navigator, overlay, signals
        self._sketches: dict[str, Sketch] = {}
        self._outline: list[QPointF] = []
        self._held: _HandleDrag | None = None
        self._spot = (0.0, 0.0)
        self.hovering = False
        self.share = 0.5
        self._dividing = self._divides = False
        self._still = QTimer(self, singleShot=True, interval=HOVER_MS)
        self._still.timeout.connect(self._look)
        mouse = navigator.mouse
        mouse.grabs = self._grab
        mouse.grabbed.connect(self._move)
        mouse.let_go.connect(self._let_go)
        mouse.outlining.connect(self._extend)
        mouse.outlined.connect(self._close)
        mouse.rested_at.connect(self._rest)
        mouse.left.connect(self.rest)
        mouse.nudged.connect(self._nudge)
        overlay.sheets.append(self._paint)

    def show(self, name: str, sketch: Sketch | None) -> None:
        """Draw a sketch, or take it away."""
        self._sketches.pop(name, None)
        if sketch is not None:
            self._sketches[name] = sketch
        self._overlay.update()

    def clear(self) -> None:
        """Draw nothing."""
        self._sketches, self._outline, self._held = {}, [], None
        self.rest()

    def divide(self, divides: bool) -> None:
        """Show a line that divides the picture, or none."""
        self._divides, self.share = divides, 0.5
        self._overlay.update()

    def rest(self) -> None:
        """Stop watching."""
        self._still.stop()
        if self.hovering:
            self._signals.hovered.emit(None)

    # The mouse

    def _handles(self) -> list[tuple[str, int, Handle]]:
        return [
            (name, k, handle)
            for name, sketch in self._sketches.items()
            for k, handle in enumerate(sketch.handles)
        ]

    def _grab(self, x: float, y: float) -> bool:
        width = self._navigator.size.width
        self._dividing = self._divides and abs(x - self.share * width) <= REACH
        if self._dividing:
            return True
        handles = self._handles()
        if not handles:
            return False
        places = np.array([handle.position for _, _, handle in handles])
        spots = self._navigator.camera.project(places, self._navigator.size)
        away = np.hypot(spots[:, 0] - x, spots[:, 1] - y)
        away[~(away <= REACH)] = np.inf
        if not np.isfinite(away).any():
            return False
        # Of handles above each other the one in front.
        nearest = int(np.argmin(np.where(np.isfinite(away), spots[:, 2], np.inf)))
        name, k, handle = handles[nearest]
        place, axis = np.array(handle.position), np.array(handle.axis)
        self._held = _HandleDrag(name, k, place, axis, self._along(place, axis, x, y) or 0.0)
        return True

    def _move(self, x: float, y: float) -> None:
        if self._dividing:
            self._divide_at(x)
            return
        held = self._held
        if held is None:
            return
        now = self._along(held.place, held.axis, x, y)
        if now is not None:
            moved, held.at = now - held.at, now
            self._signals.handle_moved.emit(held.sketch, held.handle, moved)

    def _divide_at(self, x: float) -> None:
        self.share = min(max(x / self._navigator.size.width, 0.02), 0.98)
        self.divided.emit()

    def _nudge(self, right: float) -> None:
        if self._divides:
            self._divide_at(self.share * self._navigator.size.width + right)

    def _along(self, place: Array, axis: Array, x: float, y: float) -> float | None:
        """Distance of the mouse along an axis through a place, metres; None if undetermined."""
        camera, size = self._navigator.camera, self._navigator.size
        eye = camera.point_at(x, y, 0.0, size)
        ray = camera.point_at(x, y, 1.0, size) - eye
        ray /= np.linalg.norm(ray)
        slant = float(axis @ ray)
        if 1.0 - slant**2 < END_ON**2:
            return None
        # The point of the axis nearest to the ray through the mouse.
        to_eye = eye - place
        return float(axis @ to_eye - slant * (ray @ to_eye)) / (1.0 - slant**2)

    def _let_go(self) -> None:
        held, self._held, self._dividing = self._held, None, False
        if held is not None:
            self._signals.handle_let_go.emit(held.sketch)

    def _extend(self, x: float, y: float) -> None:
        self._outline.append(QPointF(x, y))
        self._overlay.update()

    def _close(self) -> None:
        corners = np.array([(spot.x(), spot.y()) for spot in self._outline])
        self._outline = []
        self._overlay.update()
        if len(corners) > 2:
            self._signals.outlined.emit(corners)

    def _rest(self, x: float, y: float) -> None:
        if self.hovering:
            self._spot = (x, y)
            self._still.start()

    def _look(self) -> None:
        drawn = self._navigator.drawn()
        step = -(-sum(map(len, drawn.values())) // LOOKED_AT) or 1
        clouds = {line: points[::step] for line, points in drawn.items()}
        hit = pick(clouds, self._navigator.camera, *self._spot, self._navigator.size, SNAP)
        if hit is None:
            self._signals.hovered.emit(None)
            return
        north, west, up = (float(v) for v in clouds[hit.line][hit.index])
        self._signals.hovered.emit(PickedPoint(hit.line, (north, west, up)))

    # The picture

    def _paint(self, painter: QPainter, camera: Camera, size: Size) -> None:
        for sketch in self._sketches.values():
            _paint_sketch(painter, sketch, camera, size)
        # Words last: no line goes through them, and none lie on others
        _paint_labels(painter, list(self._sketches.values()), camera, size)
        if self._divides:
            _paint_division(painter, self.share * size.width, size)
        if len(self._outline) > 1:
            painter.setBrush(QColor(*theme.CANDIDATE_COLOUR, 45))
            painter.setPen(QPen(QColor(theme.TEXT), 1.4, Qt.PenStyle.DashLine))
            painter.drawPolygon(QPolygonF(self._outline))


def _paint_division(painter: QPainter, x: float, size: Size) -> None:
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


def words_of(sketch: Sketch) -> str:
    """Its words in the unit shown just now, which is the metre in a picture for a file."""
    return sketch.metric if sketch.metric and not units.differs("m") else sketch.label


def _paint_sketch(painter: QPainter, sketch: Sketch, camera: Camera, size: Size) -> None:
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
    painter: QPainter, sketches: Sequence[Sketch], camera: Camera, size: Size
) -> None:
    labelled = [each for each in sketches if each.label and each.at is not None]
    if not labelled:
        return
    spots = camera.project(np.array([each.at for each in labelled]), size)[:, :2]
    taken: list[QRectF] = []
    for k, sketch in enumerate(labelled):
        if np.isfinite(spots[k]).all():
            leftwards = right_neighbour(spots, k)
            spot, colour = QPointF(*spots[k]), QColor(*sketch.colour)
            box = _words_box(painter, words_of(sketch), spot, size, taken, leftwards=leftwards)
            _paint_words(painter, words_of(sketch), box, colour)
            taken.append(box)


def _paint_dots(painter: QPainter, spots: Array, colour: QColor, radius: float) -> None:
    painter.setPen(QPen(QColor(theme.TEXT), 1.4))
    painter.setBrush(colour)
    for x, y, _ in spots:
        if np.isfinite(x) and abs(x) < 1e5 and abs(y) < 1e5:
            painter.drawEllipse(QPointF(x, y), radius, radius)
    painter.setBrush(Qt.BrushStyle.NoBrush)


def _words_box(
    painter: QPainter,
    words: str,
    spot: QPointF,
    size: Size,
    taken: Sequence[QRectF],
    *,
    leftwards: bool,
) -> QRectF:
    """Beside the spot, inside the picture, and where no other words are, if there is such a place.

    Parameters
    ----------
    leftwards : on the left rather than on the right
    """
    metrics = QFontMetricsF(painter.font())
    lines = words.split("\n")
    width = max(metrics.horizontalAdvance(line) for line in lines) + 16.0
    height = metrics.lineSpacing() * len(lines) + 8.0
    most_x, most_y = max(size.width - width - 4.0, 4.0), max(size.height - height - 4.0, 4.0)
    sides = [spot.x() + 14.0, spot.x() - 14.0 - width]
    places = [
        QRectF(min(max(x, 4.0), most_x), min(max(y, BELOW_HINT), most_y), width, height)
        for y in (spot.y() - height - 10.0, spot.y() + 10.0)
        for x in (sides[::-1] if leftwards else sides)
    ]
    free = (box for box in places if not any(box.intersects(other) for other in taken))
    return next(free, places[0])


def _paint_words(painter: QPainter, words: str, box: QRectF, colour: QColor) -> None:
    painter.setPen(QPen(colour.darker(115), 1.3))
    painter.setBrush(theme.colour("paper", 0.88))
    painter.drawRoundedRect(box, 4.0, 4.0)
    painter.setPen(QColor(theme.TEXT))
    text = box.adjusted(8.0, 4.0, -8.0, -4.0)
    painter.drawText(text, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, words)
