"""Overlay of the 3D picture: labels, axes, scale bar and hints.

The overlay is painted by Qt instead of the 3D library, so that it has the fonts of the window, is
sharp on every screen and is never hidden by the scene.
"""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from PySide6.QtCore import QLineF, QPointF, QRectF, Qt, QTimeLine, Signal
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QLinearGradient,
    QPainter,
    QPaintEvent,
    QPen,
    QResizeEvent,
)
from PySide6.QtWidgets import QVBoxLayout, QWidget

from lispac.geometry.frames import east_north_up
from lispac.gui.appearance import theme, units
from lispac.gui.appearance.colour_schemes import LIGHT_SCHEME, Colour
from lispac.gui.viewport.base import Array, Marker, PointColouring
from lispac.gui.viewport.camera import Camera, ViewportSize
from lispac.gui.viewport.clipping import Box
from lispac.language import N_, gettext
from lispac.picked_targets import Role
from lispac.present.line_colours import LINE_COLOURS

EMPTY_TITLE = N_("No lines are shown")
EMPTY_HINT = N_("The lines appear here when they have been read")
MOUSE_HELP: Mapping[Role, str] = {
    "target": N_(
        "Drag: rotate   ·   Shift+drag: pan   ·   Wheel: zoom   ·   Ctrl+click: pick a target"
    ),
    "validation": N_(
        "Drag: rotate   ·   Shift+drag: pan   ·   Wheel: zoom   ·   Ctrl+click: pick a validation "
        "plane"
    ),
}
"""Help on the mouse, by the role of a picked surface."""

AXIS_LABELS = ((N_("E"), "axis_x"), (N_("N"), "axis_y"), (N_("Up"), "axis_z"))
"""Labels of the axes east, north and up, with the names of their colours in the scheme."""

CENTRAL_SCALE = N_("{length} at the centre")
"""Label of the scale bar in perspective, valid at the depth of the surface in the middle."""
HELP_FADE_MS = 2500
"""Time in which the help on the mouse fades after its first use."""
MARGIN_PX = 14.0
"""Distance of axes, scale bar, legend and help from the edges."""
SCALE_PX = 110.0
"""Smallest length of the colour scale of the legend."""
LEGEND_LINES = len(LINE_COLOURS)
"""Largest number of lines in the legend; the colours of later ones repeat."""
LEGEND_ROW_PX, LEGEND_NAME_PX = 17.0, 140.0
"""Height of a line in the legend, and largest width of its name."""
AXES_PX = 86.0
"""Width and height of the picture of the axes."""
DOT_PX = 7.0
"""Radius of the dot of a marker with its rings, pixels."""
LABEL_RINGS = 6
"""Number of distances from its point at which a place for a label is searched for."""
NEIGHBOUR_RADIUS_PX = 40.0
"""Distance of two points on the screen below which their labels would overlap."""


def scale_bar_length(metres_per_pixel: float, longest: float = 150.0) -> float:
    """Length, metres, of the longest scale bar of at most ``longest`` pixels.

    The length is 1, 2 or 5 times a power of ten in the unit shown.
    """
    factor = units.shown_unit("m").factor
    limit = metres_per_pixel * longest * factor
    power = 10.0 ** np.floor(np.log10(limit))
    fitting = [step * power for step in (1.0, 2.0, 5.0) if step * power <= limit * 1.000001]
    return float(max(fitting)) / factor


def legend_texts(shading: PointColouring) -> tuple[str, str, str]:
    """Title and end values of the colour scale, in the unit shown."""
    ends = (shading.low, shading.high)
    if shading.metric is not None and not units.is_converted("m"):
        ends = shading.metric
    return units.convert_unit_signs(shading.title, "mm", "m"), *ends


def length_text(metres: float) -> str:
    """Text of a round length in the unit shown."""
    if units.is_converted("m"):
        shown = units.localised(f"{metres * units.shown_unit('m').factor:.6g}")
        return f"{shown} {units.shown_unit('m').sign}"
    factor, unit = next(
        (factor, unit)
        for least, factor, unit in (
            (1000.0, 1e-3, "km"), (1.0, 1.0, "m"), (0.01, 1e2, "cm"), (0.0, 1e3, "mm")
        )
        if metres >= least
    )  # fmt: skip
    return f"{units.localised(f'{metres * factor:g}')} {unit}"


@dataclass(frozen=True, eq=False)
class OverlaidPicture:
    """Pixels, camera and title of a picture, and the box to which it is limited.

    Attributes
    ----------
    scale_depth : depth at which the scale bar is valid, metres; None without a scale bar
    """

    rect: QRectF
    camera: Camera
    title: str = ""
    box: Box | None = None
    scale_depth: float | None = None


class Overlay(QWidget):
    """Transparent widget over the picture, which ignores the mouse."""

    help_used = Signal()
    """The mouse was used for the first time while the help is shown, which now fades."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.pictures: Sequence[OverlaidPicture] = ()
        """Pictures under the overlay; an empty view shows a hint."""
        self.markers: Sequence[Marker] = ()
        self.shading: PointColouring | None = None
        self.lines: Mapping[str, Colour] = {}
        """Colours of the lines that are drawn in them."""
        self.has_line_legend = True
        """Whether the colours of the lines are explained."""
        self.hint = ""
        """Text on the action of the mouse, shown instead of the usual help."""
        self.seed_role: Role = "target"
        """Role of the surface that Ctrl+click picks."""
        self.help_opacity = 1.0
        self._fading = QTimeLine(HELP_FADE_MS, self)
        self._fading.setUpdateInterval(80)
        self._fading.valueChanged.connect(lambda share: self._set_help_opacity(1.0 - share))
        self.paint_hooks: list[Callable[[QPainter, Camera, ViewportSize], None]] = []
        """Functions that paint after axes, scale and markers and before the help."""
        self.label_boxes: list[QRectF] = []
        """Labels of the markers in the picture being painted."""

    def show_help(self, shown: bool) -> None:
        """Show or hide the help on the mouse."""
        self._fading.stop()
        self._set_help_opacity(float(shown))

    def fade_help(self) -> None:
        """Fade the help on the mouse, which has been used."""
        if self.help_opacity == 1.0 and self._fading.state() == QTimeLine.State.NotRunning:
            self._fading.start()
            self.help_used.emit()

    def _set_help_opacity(self, opacity: float) -> None:
        self.help_opacity = opacity
        self.update()

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint on the screen."""
        painter = QPainter(self)
        self.paint(painter)
        if len(self.pictures) == 1 or (self.pictures and self.hint):
            self._paint_help(painter)
        painter.end()

    def paint(self, painter: QPainter, scale: float = 1.0) -> None:
        """Paint on any device of the size of this widget, such as a picture to save.

        The help text on the mouse is painted on the screen only.

        Parameters
        ----------
        scale : size of labels, axes and scale bar relative to that on the screen
        """
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setFont(self.font())
        if not self.pictures:
            self._paint_hint(painter)
            return
        for picture in self.pictures:
            painter.save()
            if len(self.pictures) > 1:
                painter.setClipRect(picture.rect)
                painter.translate(picture.rect.topLeft())
            painter.scale(scale, scale)
            size = ViewportSize(picture.rect.width() / scale, picture.rect.height() / scale)
            self._paint_picture(painter, picture, size)
            if picture.title:
                self._paint_title(painter, picture.rect, picture.title)
            painter.restore()
        if self.shading is not None:
            self._paint_legend(painter, self.shading)
        elif self._legend_lines():
            painter.save()
            painter.scale(scale, scale)
            self._paint_line_legend(painter)
            painter.restore()

    def _paint_picture(
        self, painter: QPainter, picture: OverlaidPicture, size: ViewportSize
    ) -> None:
        camera = picture.camera
        # Axes and scale bar do not cover a marker.
        self._paint_axes(painter, camera, size)
        if picture.scale_depth is not None:
            self._paint_scale(painter, picture, picture.scale_depth, size)
        self._paint_markers(painter, camera, size, picture.box)
        painter.setFont(self.font())
        for paint in self.paint_hooks:
            paint(painter, camera, size)

    def _paint_title(self, painter: QPainter, rect: QRectF, title: str) -> None:
        """Paint the frame of one of several pictures, and its title in the upper right corner."""
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(theme.colour("edge_strong"), 2.0))
        painter.drawRect(QRectF(0.0, 0.0, rect.width(), rect.height()))
        painter.setFont(self.font())
        width = QFontMetricsF(self.font()).horizontalAdvance(title) + 20.0
        box = QRectF(rect.width() - width - 10.0, 10.0, width, 24.0)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.colour("paper", 0.88))
        painter.drawRoundedRect(box, 4.0, 4.0)
        painter.setPen(QColor(theme.TEXT))
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, title)

    def _paint_hint(self, painter: QPainter) -> None:
        middle = QRectF(self.rect()).center()
        width = float(self.width())
        painter.setFont(_scaled_font(self.font(), 1.5))
        painter.setPen(QColor(theme.TEXT))
        flags = Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignBottom
        painter.drawText(QRectF(0.0, middle.y() - 60.0, width, 56.0), flags, gettext(EMPTY_TITLE))
        painter.setFont(_scaled_font(self.font(), 1.1))
        painter.setPen(QColor(theme.MUTED))
        flags = Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop
        painter.drawText(QRectF(0.0, middle.y() + 4.0, width, 56.0), flags, gettext(EMPTY_HINT))

    def _paint_markers(
        self, painter: QPainter, camera: Camera, size: ViewportSize, box: Box | None
    ) -> None:
        markers = [
            each for each in self.markers
            if box is None or len(box.inside(np.array([each.position])))
        ]  # fmt: skip
        self.label_boxes.clear()
        if not markers:
            return
        font = QFont(self.font())
        font.setBold(True)
        painter.setFont(font)
        metrics = QFontMetricsF(font)
        spots = camera.project(np.array([m.position for m in markers]), size)
        picture = QRectF(0.0, 0.0, size.width, size.height)
        # Labels of targets are placed before those of candidates, so that they keep their place;
        # then near ones first. They are painted in the opposite order.
        placed: list[tuple[QPointF, QRectF, Marker]] = []
        dots = [
            QRectF(x - DOT_PX, y - DOT_PX, 2 * DOT_PX, 2 * DOT_PX)
            for x, y, depth in spots
            if depth > 0.0 and picture.contains(x, y)
        ]
        occupied = [*self.occupied(size), *dots]
        leaders: list[QLineF] = []
        for k in np.lexsort((spots[:, 2], [each.is_provisional for each in markers])):
            x, y, depth = spots[k]
            # The label of a point outside the picture would have a line to nowhere.
            if depth > 0.0 and picture.contains(x, y):
                spot = QPointF(x, y)
                crowded = has_right_neighbour(spots[:, :2], k)
                box = free_label_place(
                    spot, metrics, markers[k].label, occupied, picture, leftwards=crowded,
                    labels=self.label_boxes, leaders=leaders,
                )  # fmt: skip
                occupied.append(box)
                leaders.append(leader_line(spot, box))
                self.label_boxes.append(box)
                placed.append((spot, box, markers[k]))
        for spot, box, marker in reversed(placed):  # no line crosses a label
            _paint_leader(painter, leader_line(spot, box), marker)
        for spot, box, marker in reversed(placed):
            _paint_marker(painter, spot, box, marker)

    def _paint_axes(self, painter: QPainter, camera: Camera, size: ViewportSize) -> None:
        centre = QPointF(MARGIN_PX + 42.0, size.height - MARGIN_PX - 42.0)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.colour("paper", 0.8))
        painter.drawEllipse(centre, 44.0, 44.0)
        # columns: east, north and up as seen on the screen
        directions = east_north_up(camera.axes)
        font = _scaled_font(self.font(), 0.95)
        font.setBold(True)
        painter.setFont(font)
        for k in np.argsort(-directions[2]):  # axes that point away are painted first
            name, colour = AXIS_LABELS[k]
            direction = QPointF(directions[0, k], -directions[1, k])
            tip = centre + direction * 28.0
            # At a constant distance beyond the tip, even if the axis nearly points at the viewer
            middle = tip + direction * (
                9.0 / max(float(np.hypot(direction.x(), direction.y())), 1e-3)
            )
            pen = QPen(theme.colour(colour), 2.4)
            pen.setCapStyle(Qt.PenCapStyle.RoundCap)
            painter.setPen(pen)
            painter.drawLine(centre, tip)
            box = QRectF(middle.x() - 20.0, middle.y() - 10.0, 40.0, 20.0)
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, gettext(name))

    def _paint_scale(
        self, painter: QPainter, picture: OverlaidPicture, depth: float, size: ViewportSize
    ) -> None:
        """Paint the scale bar; in perspective, its label names the depth at which it is valid."""
        metres_per_pixel = depth / size.pixels_per_tangent
        metres = scale_bar_length(metres_per_pixel)
        pixels = metres / metres_per_pixel
        font = _scaled_font(self.font(), 0.95)
        painter.setFont(font)
        text = length_text(metres)
        if not picture.camera.parallel:
            text = gettext(CENTRAL_SCALE, length=text)
        width = max(pixels, QFontMetricsF(font).horizontalAdvance(text))
        right, base = size.width - MARGIN_PX - 4.0, size.height - MARGIN_PX - 6.0
        middle = right - 0.5 * width
        left, end = middle - 0.5 * pixels, middle + 0.5 * pixels
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.colour("paper", 0.85))
        painter.drawRoundedRect(
            QRectF(right - width - 10.0, base - 28.0, width + 20.0, 38.0), 8.0, 8.0
        )
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QPen(QColor(theme.TEXT), 1.6))
        painter.drawPolyline(
            [
                QPointF(left, base - 6.0),
                QPointF(left, base),
                QPointF(end, base),
                QPointF(end, base - 6.0),
            ]
        )
        box = QRectF(middle - 100.0, base - 26.0, 200.0, 20.0)
        painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)

    def occupied(self, size: ViewportSize) -> list[QRectF]:
        """Rectangles of axes, scale bar and colour scale, where no label of a target is placed."""
        base = size.height - MARGIN_PX
        axes = QRectF(MARGIN_PX, base - AXES_PX, AXES_PX, AXES_PX)
        scale = QRectF(size.width - MARGIN_PX - 170.0, base - 34.0, 170.0, 38.0)
        legend = []
        if self.shading is not None:
            legend = [self.legend_rect(self.shading)]
        elif self._legend_lines():
            legend = [self.line_legend_rect()]
        return [axes, scale, *legend]

    def _legend_lines(self) -> list[str]:
        """Names of the lines in the legend; none if there is only one line."""
        space = self.height() - 3 * MARGIN_PX - AXES_PX - 8.0  # above the axes
        count = min(LEGEND_LINES, int(space / LEGEND_ROW_PX) - 1)
        has_legend = self.has_line_legend and len(self.lines) > 1 and count > 1
        return list(self.lines)[:count] if has_legend else []

    def line_legend_rect(self) -> QRectF:
        """Rectangle of the legend of the lines."""
        metrics = QFontMetricsF(_scaled_font(self.font(), 0.9))
        names = self._legend_lines()
        rows = len(names) + (len(self.lines) > len(names))
        width = min(max(map(metrics.horizontalAdvance, names)), LEGEND_NAME_PX)
        return QRectF(MARGIN_PX, MARGIN_PX, width + 36.0, rows * LEGEND_ROW_PX + 8.0)

    def _paint_line_legend(self, painter: QPainter) -> None:
        """Paint the names of the lines in one column, each beside its colour."""
        font = _scaled_font(self.font(), 0.9)
        painter.setFont(font)
        metrics = QFontMetricsF(font)
        box, names = self.line_legend_rect(), self._legend_lines()
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.colour("paper", 0.88))
        painter.drawRoundedRect(box, 8.0, 8.0)
        left_aligned = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter
        row = QRectF(box.left() + 26.0, box.top() + 4.0, box.width() - 32.0, LEGEND_ROW_PX)
        for name in names:
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(*self.lines[name]))
            painter.drawRect(QRectF(box.left() + 10.0, row.center().y() - 4.0, 9.0, 9.0))
            painter.setPen(QColor(theme.TEXT))
            text = metrics.elidedText(name, Qt.TextElideMode.ElideMiddle, row.width())
            painter.drawText(row, left_aligned, text)
            row.translate(0.0, LEGEND_ROW_PX)
        if len(self.lines) > len(names):
            painter.setPen(QColor(theme.TEXT))
            painter.drawText(row, left_aligned, f"+ {len(self.lines) - len(names)}")

    def legend_rect(self, shading: PointColouring) -> QRectF:
        """Rectangle of the colour scale."""
        metrics = QFontMetricsF(_scaled_font(self.font(), 0.95))
        title, low, high = legend_texts(shading)
        ends = metrics.horizontalAdvance(low) + metrics.horizontalAdvance(high)
        width = max(metrics.horizontalAdvance(title), ends + SCALE_PX + 12.0)
        return QRectF(MARGIN_PX, MARGIN_PX, width + 20.0, 46.0)

    def _paint_legend(self, painter: QPainter, shading: PointColouring) -> None:
        painter.setFont(_scaled_font(self.font(), 0.95))
        box = self.legend_rect(shading)
        title, low, high = legend_texts(shading)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme.colour("paper", 0.88))
        painter.drawRoundedRect(box, 8.0, 8.0)
        metrics = QFontMetricsF(painter.font())
        text = box.adjusted(10.0, 4.0, -10.0, 0.0)
        text.setHeight(18.0)
        ends = text.translated(0.0, 19.0)
        bar = ends.adjusted(
            metrics.horizontalAdvance(low) + 6.0, 4.0, -metrics.horizontalAdvance(high) - 6.0, -3.0
        )
        gradient = QLinearGradient(bar.topLeft(), bar.topRight())
        for share in np.linspace(0.0, 1.0, 33):
            red, green, blue = shading.scale[round(share * (len(shading.scale) - 1))].tolist()
            gradient.setColorAt(float(share), QColor(red, green, blue))
        painter.fillRect(bar, gradient)
        painter.setPen(QColor(theme.TEXT))
        centred = Qt.AlignmentFlag.AlignVCenter
        painter.drawText(text, Qt.AlignmentFlag.AlignLeft | centred, title)
        painter.drawText(ends, Qt.AlignmentFlag.AlignLeft | centred, low)
        painter.drawText(ends, Qt.AlignmentFlag.AlignRight | centred, high)

    def _paint_help(self, painter: QPainter) -> None:
        painter.setOpacity(1.0 if self.hint else self.help_opacity)
        font = _scaled_font(self.font(), 0.9)
        painter.setFont(font)
        # The help is between axes and scale bar, and omitted in a narrow window; a hint is at the
        # top.
        left, right = MARGIN_PX + 100.0, self.width() - MARGIN_PX - 180.0
        if self.hint:
            left, right = 0.0, float(self.width())
        text = self.hint or gettext(MOUSE_HELP[self.seed_role])
        width = QFontMetricsF(font).horizontalAdvance(text) + 24.0
        if width < right - left or self.hint:
            middle = 0.5 * (left + right)
            top = MARGIN_PX if self.hint else self.height() - MARGIN_PX - 22.0
            box = QRectF(middle - 0.5 * width, top, width, 22.0)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(
                theme.colour("note", 0.92) if self.hint else theme.colour("paper", 0.85)
            )
            painter.drawRoundedRect(box, 11.0, 11.0)
            painter.setPen(QColor(theme.TEXT if self.hint else theme.MUTED))
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, text)


class OverlaidView(QWidget):
    """Widget with the picture and the overlay on top of it."""

    resized = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setMinimumSize(240, 180)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        self.overlay = Overlay(self)

    def set_canvas(self, canvas: QWidget) -> None:
        """Set the picture."""
        layout = self.layout()
        assert layout is not None
        layout.addWidget(canvas)
        self.overlay.raise_()

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the overlay as large as the picture."""
        super().resizeEvent(event)
        self.overlay.setGeometry(self.rect())
        self.resized.emit()


def has_right_neighbour(spots: Array, k: int) -> bool:
    """Whether spot ``k`` has a close neighbour on the right, and none on the left.

    In this case its label is placed on the left; otherwise the lines to both labels would cross.

    Parameters
    ----------
    spots : ndarray of shape (n, 2), pixels right and down
    """
    with np.errstate(invalid="ignore"):  # NaN behind the camera
        right, down = (spots - spots[k]).T
    near = (np.hypot(right, down) < NEIGHBOUR_RADIUS_PX) & (right != 0.0)
    return bool((near & (right > 0.0)).any() and not (near & (right < 0.0)).any())


def free_label_place(
    spot: QPointF,
    metrics: QFontMetricsF,
    label: str,
    occupied: Sequence[QRectF],
    picture: QRectF | None = None,
    *,
    leftwards: bool = False,
    labels: Sequence[QRectF] = (),
    leaders: Sequence[QLineF] = (),
) -> QRectF:
    """Rectangle of a label beside its point, preferably at the upper right.

    In a crowd of labels it is farther from the point; without a free place, it covers as little as
    possible, and as few lines as possible cross a label.

    Parameters
    ----------
    occupied : rectangles that the label does not cover
    picture : rectangle that the label does not leave
    leftwards : whether the upper left is preferred instead
    labels, leaders : other labels, which the line to the label does not cross, and their lines,
        which neither the label nor its line crosses
    """
    width, height = metrics.horizontalAdvance(label) + 14.0, metrics.height() + 4.0
    least, found = np.inf, QRectF()
    for ring in range(LABEL_RINGS):
        farther = ring * (height + 3.0)
        right, left = spot.x() + 12.0 + farther, spot.x() - 12.0 - width - farther
        above, below = spot.y() - 18.0 - height - farther, spot.y() + 18.0 + farther
        sides = (left, right) if leftwards else (right, left)
        middle = spot.x() - 0.5 * width, spot.y() - 0.5 * height
        places = [
            *((x, y) for y in (above, below) for x in sides),
            *((x, middle[1]) for x in sides), *((middle[0], y) for y in (above, below)),
        ]  # fmt: skip
        for x, y in places:
            box = QRectF(x, y, width, height)
            if picture is not None:
                box = _moved_into(box, picture)
            covered = sum(_area(box.intersected(other)) for other in occupied)
            line = leader_line(spot, box)
            crossings = sum(_is_crossed(other, line) for other in labels)
            crossings += sum(
                _is_crossed(box, other) or _cross_each_other(line, other) for other in leaders
            )
            covered += crossings * _area(box)
            if covered < least:
                least, found = covered, box
            if covered == 0.0:
                return box
    return found


def _moved_into(box: QRectF, picture: QRectF) -> QRectF:
    """Box moved by the least distance into a picture; its left and top if it is larger."""
    left = max(min(box.left(), picture.right() - box.width()), picture.left())
    top = max(min(box.top(), picture.bottom() - box.height()), picture.top())
    return QRectF(left, top, box.width(), box.height())


def leader_line(spot: QPointF, box: QRectF) -> QLineF:
    """Line from a point to the nearest place of its label, beside the rounded corners."""
    inner = box.adjusted(2.0, 0.0, -2.0, 0.0)
    end = QPointF(
        min(max(spot.x(), inner.left()), inner.right()),
        min(max(spot.y(), inner.top()), inner.bottom()),
    )
    return QLineF(spot, end)


def _is_crossed(rect: QRectF, line: QLineF) -> bool:
    """Whether a part of a line lies in a rectangle."""
    if rect.contains(line.p1()) or rect.contains(line.p2()):
        return True
    corners = (rect.topLeft(), rect.topRight(), rect.bottomRight(), rect.bottomLeft())
    return any(_cross_each_other(line, QLineF(corners[k - 1], corners[k])) for k in range(4))


def _cross_each_other(line: QLineF, other: QLineF) -> bool:
    return line.intersects(other)[0] == QLineF.IntersectionType.BoundedIntersection


def _area(rect: QRectF) -> float:
    return rect.width() * rect.height()


def _paint_leader(painter: QPainter, line: QLineF, marker: Marker) -> None:
    painter.setPen(QPen(theme.colour("paper", 0.86), 3.5))
    painter.drawLine(line)
    painter.setPen(QPen(QColor(*marker.colour).darker(130), 1.5))
    painter.drawLine(line)


def _paint_marker(painter: QPainter, spot: QPointF, box: QRectF, marker: Marker) -> None:
    colour = QColor(*marker.colour)
    # A dark and a light ring distinguish the dot from points of its colour.
    painter.setPen(QPen(QColor(LIGHT_SCHEME.text), 4.2))
    painter.drawEllipse(spot, 5.0, 5.0)
    painter.setPen(QPen(QColor(LIGHT_SCHEME.paper), 1.8))
    painter.setBrush(colour)
    painter.drawEllipse(spot, 5.0, 5.0)
    if not marker.label:
        return
    painter.setPen(QPen(colour.darker(115), 1.3))
    painter.setBrush(colour.darker(115) if marker.is_selected else theme.colour("paper", 0.88))
    painter.drawRoundedRect(box, 4.0, 4.0)
    painter.setPen(QColor(LIGHT_SCHEME.paper if marker.is_selected else theme.TEXT))
    painter.drawText(box, Qt.AlignmentFlag.AlignCenter, marker.label)


def _scaled_font(font: QFont, factor: float) -> QFont:
    scaled = QFont(font)
    if font.pointSizeF() > 0.0:
        scaled.setPointSizeF(font.pointSizeF() * factor)
    else:
        scaled.setPixelSize(round(font.pixelSize() * factor))
    return scaled
