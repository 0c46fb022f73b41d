"""Mounting of the scanner on a vessel, as a sketch from above and from starboard, and as text.

The lever arm is to scale, the vessel is not. A wrong sign of the lever arm is obvious in the
sketch: the scanner is on the wrong side.
"""

from collections.abc import Sequence
from typing import Literal

import numpy as np
from PySide6.QtCore import QPointF, QRectF, QSize, Qt
from PySide6.QtGui import (
    QColor,
    QFont,
    QFontMetricsF,
    QPainter,
    QPaintEvent,
    QPen,
    QPolygonF,
)
from PySide6.QtWidgets import QGridLayout, QSizePolicy, QVBoxLayout, QWidget

from lispac.gui.appearance import quantities, theme, units
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.widgets.mounting_texts import boresight_sentence, lever_arm_sentence
from lispac.gui.widgets.reserved_label import ReservedLabel
from lispac.gui.widgets.scanner_axes_view import (
    SCANNER_AXES,
    exaggerated_rotation,
    exaggeration_text,
)
from lispac.language import N_, gettext
from lispac.survey.lever_arm_warnings import lever_arm_warnings

View = Literal["above", "starboard"]
VIEWS: tuple[View, ...] = ("above", "starboard")
VIEW_TITLES: dict[View, str] = {"above": N_("From above"), "starboard": N_("From starboard")}

_VIEW_AXES: dict[View, np.ndarray] = {
    "above": np.array([[0.0, -1.0, 0.0], [1.0, 0.0, 0.0]]),
    "starboard": np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]),
}
"""Right and up directions of each view in the body frame (forward, left, up)."""
_SIDE_LABELS: dict[View, tuple[str, str, str, str]] = {
    "above": (N_("bow +X"), N_("stern"), N_("port +Y"), N_("starboard")),
    "starboard": (N_("up +Z"), N_("down"), N_("stern"), N_("bow +X")),
}
"""Labels at the top, bottom, left and right of each view, with the positive axes."""
_HULL_OUTLINES: dict[View, tuple[tuple[float, float], ...]] = {
    "above": ((0.0, 0.86), (0.3, 0.45), (0.34, 0.1), (0.32, -0.84), (-0.32, -0.84), (-0.34, 0.1),
              (-0.3, 0.45)),
    "starboard": ((0.9, 0.14), (0.62, -0.4), (-0.8, -0.4), (-0.86, 0.06), (0.3, 0.06)),
}  # fmt: skip
"""Outline of a vessel, not to scale: right and up, in units of half the view."""

VIEW_EXTENTS_M = (
    0.5,
    0.75,
    1.0,
    1.5,
    2.0,
    3.0,
    5.0,
    7.5,
    10.0,
    15.0,
    20.0,
    30.0,
    50.0,
    75.0,
    100.0,
    150.0,
)
"""Possible distances from the POS centre to the edge; few, so that the scale rarely changes."""
_SCALE_BAR_LENGTHS = (0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0)
"""Possible lengths of the scale bar, in the unit shown."""
SKETCH_HEIGHT_PX = 220
_MAX_ARM_SHARE = 0.66
"""Largest component of a lever arm, as a share of the distance to the edge."""
_SCANNER_AXIS_PX, _BODY_AXIS_PX, _SCANNER_DOT_PX, _MIN_LABELLED_PX = 22.0, 20.0, 5.0, 24.0
"""Lengths of the scanner axes and of the body axes, radius of the dot of the scanner, and shortest
component of a lever arm that has a label. The body axes are shorter, so that they do not cross the
letters of the scanner axes."""
_SIDE_LABEL_Y = 0.86
"""Distance of the side labels below the centre of a view, as a share of half the view.

The labels are below the hull.
"""
_MIN_AXIS_SHARE = 0.25
"""Smallest visible share of the length of a drawn axis; a shorter one points at the viewer."""


class MountingSketch(QWidget):
    """Two views of the vessel with the POS centre and the scanner at its lever arm."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("mounting_sketch")
        self.setAccessibleName(gettext("Mounting of the scanner on the vessel"))
        self.setToolTip(
            gettext(
                "The lever arm of the scanner is to scale, the vessel is not. Grey: body axes. "
                "Coloured: scanner axes rotated by the prior boresight, small rotations "
                "enlarged."
            )
        )
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.lever_arm = np.zeros(3)
        self.factor, self._rotation_body_scanner = 1, np.eye(3)
        self.has_warning = False

    def sizeHint(self) -> QSize:
        """Preferred size, in pixels."""
        return QSize(330, SKETCH_HEIGHT_PX)

    def minimumSizeHint(self) -> QSize:
        """Smallest useful size, in pixels."""
        return QSize(300, SKETCH_HEIGHT_PX)

    def show_mounting(self, lever_arm: Sequence[float], boresight_deg: Sequence[float]) -> None:
        """Draw a lever arm (metres; forward, left, up) and a boresight (roll, pitch, yaw)."""
        self.lever_arm = np.array(lever_arm, dtype=float)
        self.factor, self._rotation_body_scanner = exaggerated_rotation(np.radians(boresight_deg))
        self.has_warning = bool(lever_arm_warnings(lever_arm))
        self.update()

    # -- geometry -------------------------------------------------------------------------------

    @property
    def extent(self) -> float:
        """Metres from the POS centre to the edge of a view."""
        longest = float(np.abs(self.lever_arm).max())
        return next(
            (each for each in VIEW_EXTENTS_M if longest <= _MAX_ARM_SHARE * each),
            VIEW_EXTENTS_M[-1],
        )

    @property
    def pixels_per_metre(self) -> float:
        """Scale of both views, along all axes."""
        return self._half_size / self.extent

    def pixel_of(self, view: View, point_body: Sequence[float] | np.ndarray) -> QPointF:
        """Pixel of a point of the body frame (metres from the POS centre) in a view."""
        right, up = self.pixels_per_metre * (_VIEW_AXES[view] @ np.asarray(point_body, dtype=float))
        return self._centre(view) + QPointF(float(right), -float(up))

    def axis_ends(self, view: View, axis: int) -> tuple[QPointF, QPointF]:
        """Start and end of an axis of the scanner in a view."""
        start = self.pixel_of(view, self.lever_arm)
        right, up = _SCANNER_AXIS_PX * (_VIEW_AXES[view] @ self._rotation_body_scanner[:, axis])
        return start, start + QPointF(float(right), -float(up))

    def hull(self, view: View) -> QPolygonF:
        """Outline of the vessel in a view."""
        centre, half = self._centre(view), self._half_size
        return QPolygonF([centre + QPointF(half * x, -half * y) for x, y in _HULL_OUTLINES[view]])

    def side_labels(self, view: View) -> dict[str, QRectF]:
        """Labels at the sides of a view, with their places."""
        left, width = self.width() / 2 * VIEWS.index(view), self.width() / 2
        half, y = self._half_size, self._centre(view).y()
        metrics = QFontMetricsF(self._font)
        line = metrics.height()
        top, bottom, port, starboard = (gettext(label) for label in _SIDE_LABELS[view])
        widths = {
            each: metrics.horizontalAdvance(each) + 2 for each in (top, bottom, port, starboard)
        }
        side, middle = y + half * _SIDE_LABEL_Y, left + width / 2
        return {
            top: QRectF(middle - widths[top] / 2, y - half - line - 3, widths[top], line),
            bottom: QRectF(middle - widths[bottom] / 2, side + line, widths[bottom], line),
            port: QRectF(left + 4, side, widths[port], line),
            starboard: QRectF(left + width - 4 - widths[starboard], side, widths[starboard], line),
        }

    @property
    def _font(self) -> QFont:
        font = QFont(self.font())
        font.setPixelSize(11)
        return font

    @property
    def _half_size(self) -> float:
        return min(self.width() / 4 - 6, (self.height() - 40) / 2 - 13)

    def _centre(self, view: View) -> QPointF:
        quarter = self.width() / 4
        return QPointF(quarter * (1 + 2 * VIEWS.index(view)), 18 + (self.height() - 40) / 2)

    # -- painting --------------------------------------------------------------------------------

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint vessel and scanner from above and from starboard."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), QColor(theme.PAPER))
        painter.setPen(QPen(QColor(theme.BORDER)))
        painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
        middle = round(self.width() / 2)
        painter.drawLine(middle, 6, middle, self.height() - 24)
        painter.setFont(self._font)
        for view in VIEWS:
            self._paint_vessel(painter, view)
            self._paint_body_axes(painter, view)
            self._paint_lever_arm(painter, view)
            self._paint_scanner(painter, view)
        self._paint_scale(painter)
        painter.end()

    def _paint_vessel(self, painter: QPainter, view: View) -> None:
        painter.setPen(QPen(QColor(theme.EDGE)))
        painter.setBrush(QColor(theme.HULL))
        painter.drawPolygon(self.hull(view))
        painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.setPen(QColor(theme.TEXT))
        left = self.width() / 2 * VIEWS.index(view)
        painter.drawText(QPointF(left + 7, 15), gettext(VIEW_TITLES[view]))
        painter.setPen(QColor(theme.MUTED))
        for label, area in self.side_labels(view).items():
            painter.drawText(area, Qt.AlignmentFlag.AlignCenter, label)

    def _paint_body_axes(self, painter: QPainter, view: View) -> None:
        centre = self._centre(view)
        painter.setPen(QPen(theme.colour("body_axis"), 1.5))
        for right, up in _VIEW_AXES[view].T:
            painter.drawLine(centre, centre + _BODY_AXIS_PX * QPointF(float(right), -float(up)))
        painter.setBrush(QColor(theme.MUTED))
        painter.drawRect(QRectF(centre.x() - 3, centre.y() - 3, 6, 6))
        painter.setPen(QColor(theme.TEXT))
        # On the side of the POS centre that is away from the scanner.
        from_scanner, metrics = centre - self.pixel_of(view, self.lever_arm), painter.fontMetrics()
        x = 7.0 if from_scanner.x() > 0 else -7.0 - metrics.horizontalAdvance(gettext("POS"))
        y = 4.0 + metrics.ascent() if from_scanner.y() >= 0 else -7.0
        painter.drawText(centre + QPointF(x, y), gettext("POS"))

    def _paint_lever_arm(self, painter: QPainter, view: View) -> None:
        """Paint the lever arm along the axes of the view, with its components."""
        view_axes = _VIEW_AXES[view]
        along_up = np.abs(view_axes[1]) * self.lever_arm  # first vertically, then horizontally
        across = np.abs(view_axes[0]) * self.lever_arm
        corner, end = self.pixel_of(view, along_up), self.pixel_of(view, self.lever_arm)
        pen = QPen(self._colour, 1.2, Qt.PenStyle.DashLine)
        painter.setPen(pen)
        painter.drawLine(self._centre(view), corner)
        painter.drawLine(corner, end)
        painter.setPen(QColor(theme.TEXT))
        leftwards = end.x() < self._centre(view).x()
        for amount, place in (
            (np.abs(along_up).max(), (self._centre(view) + corner) / 2),
            (np.abs(across).max(), (corner + end) / 2),
        ):
            if amount * self.pixels_per_metre < _MIN_LABELLED_PX:
                continue  # included in the text below the sketch
            label = length_with_unit(amount, ".2f")
            width, height = painter.fontMetrics().horizontalAdvance(label), 12.0
            if place.x() == corner.x() == self._centre(view).x():  # beside the vertical part
                x = place.x() + 5 if leftwards else place.x() - 5 - width
                box = QRectF(x, place.y() - height / 2, width, height)
            else:
                lower = end.y() >= self._centre(view).y()
                y = place.y() + 3 if lower else place.y() - 3 - height
                box = QRectF(place.x() - width / 2, y, width, height)
            painter.fillRect(box.adjusted(-1, 0, 1, 0), theme.colour("paper", 0.75))
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, label)

    def _paint_scanner(self, painter: QPainter, view: View) -> None:
        for axis, (letter, colour) in enumerate(SCANNER_AXES):
            start, tip = self.axis_ends(view, axis)
            direction = tip - start
            if np.hypot(direction.x(), direction.y()) < _MIN_AXIS_SHARE * _SCANNER_AXIS_PX:
                continue
            painter.setPen(QPen(theme.colour(colour), 2.2))
            painter.drawLine(start, tip)
            _paint_axis_letter(painter, start, tip, letter)
        painter.setPen(QPen(QColor(theme.PAPER)))
        painter.setBrush(self._colour)
        painter.drawEllipse(self.pixel_of(view, self.lever_arm), _SCANNER_DOT_PX, _SCANNER_DOT_PX)

    @property
    def _colour(self) -> QColor:
        return QColor(theme.WARNING if self.has_warning else theme.ACCENT)

    def _paint_scale(self, painter: QPainter) -> None:
        metres = 1 / units.shown_unit("m").factor  # metres in one unit shown
        length = metres * max(
            (bar for bar in _SCALE_BAR_LENGTHS if metres * bar <= self.extent / 2),
            default=_SCALE_BAR_LENGTHS[0],
        )
        y, x = self.height() - 9, self.width() - 8.0
        bar = length * self.pixels_per_metre
        label = length_with_unit(length, ".3g")
        painter.setPen(QPen(QColor(theme.MUTED), 1.5))
        painter.drawLine(QPointF(x - bar, y), QPointF(x, y))
        for end in (x - bar, x):
            painter.drawLine(QPointF(end, y - 3), QPointF(end, y + 3))
        label_width = painter.fontMetrics().horizontalAdvance(label)
        painter.drawText(QPointF(x - bar - label_width - 5, y + 4), label)
        painter.drawText(QPointF(7, y + 4), exaggeration_text(self.factor))


LONGEST_ARM = (-10.0, -10.0, -10.0)
"""Lever arm with the longest description."""
DOUBTFUL_ARMS = ((0.0, 0.0, 0.0), (0.0, 0.0, -20.0), (0.0, 200.0, 0.0))
"""A lever arm for each of the warnings."""


class MountingView(QWidget):
    """The sketch with a description above it, which warnings replace.

    Both have one place, so that nothing moves while a lever arm is typed; above the sketch, they
    are visible beside the fields on a small screen.
    """

    def __init__(self, prefix: str) -> None:
        super().__init__()
        self.sketch = MountingSketch()
        self.text_label = ReservedLabel(
            "muted", f"{prefix}_words", texts=[_description(LONGEST_ARM, (0.0, 0.0, 0.0))]
        )
        texts = [message_text(each) for arm in DOUBTFUL_ARMS for each in lever_arm_warnings(arm)]
        self.warnings_label = ReservedLabel("warning", f"{prefix}_warnings", texts=texts)
        texts = QGridLayout()  # a stacked layout would not be as high as wrapped labels need
        texts.addWidget(self.text_label, 0, 0)
        texts.addWidget(self.warnings_label, 0, 0)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(4)
        column.addLayout(texts)
        column.addWidget(self.sketch)
        self.show_mounting((0.0, 0.0, 0.0), (0.0, 0.0, 0.0))

    def show_mounting(self, lever_arm: Sequence[float], boresight_deg: Sequence[float]) -> None:
        """Show a lever arm (metres; forward, left, up) and a boresight (degrees)."""
        self.sketch.show_mounting(lever_arm, boresight_deg)
        text = _description(lever_arm, boresight_deg)
        self.text_label.setText(text)
        self.sketch.setAccessibleDescription(text)
        warnings = lever_arm_warnings(lever_arm)
        self.warnings_label.setText("\n".join(map(message_text, warnings)))
        self.text_label.setVisible(not warnings)
        self.warnings_label.setVisible(bool(warnings))


def _description(lever_arm: Sequence[float], boresight_deg: Sequence[float]) -> str:
    return f"{lever_arm_sentence(lever_arm)} {boresight_sentence(np.radians(boresight_deg))}"


def length_with_unit(length: float, form: str) -> str:
    """Text of a length (metres) with the unit shown."""
    return units.localised(units.figure(length, "m", form)) + quantities.unit_suffix("m")


def _paint_axis_letter(painter: QPainter, start: QPointF, tip: QPointF, letter: str) -> None:
    """Paint the letter of an axis beyond its tip."""
    direction = tip - start
    place = tip + direction * (7.0 / max(float(np.hypot(direction.x(), direction.y())), 1e-9))
    painter.drawText(
        QRectF(place.x() - 8, place.y() - 8, 16, 16), Qt.AlignmentFlag.AlignCenter, letter
    )
