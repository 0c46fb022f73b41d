"""Pictures of the patch test: the lines at an object at true scale, and their mismatch.

They are painted with Qt, since Matplotlib takes a tenth of a second for each picture.
"""

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QPointF, QRect, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from lispac.gui.appearance import theme
from lispac.gui.viewport.base import Colour
from lispac.gui.viewport.overlay import length_text, scale_bar_length
from lispac.gui.widgets.result_tables import local_amount
from lispac.language import gettext
from lispac.patchtest.line_mismatch import curve_minimum
from lispac.present.calibration.patch_test import CURVE_ANGLE, CURVE_MISMATCH

Array = NDArray[np.float64]

MARGIN_PX, LEFT_PX, BOTTOM_PX = 10, 62, 36
"""Margins in pixels: of a picture, and to the left of and below the curve."""
ZOOM_STEP = 1.25
"""Factor between two scales of the picture of the lines."""
POINT_SIZE_PX = 2.0
"""Size of a point in pixels."""


class PaperPicture(QWidget):
    """Base class of the pictures: background, border and name for screen readers."""

    def __init__(self, name: str, accessible_name: str) -> None:
        super().__init__()
        self.setObjectName(name)
        self.setAccessibleName(accessible_name)
        self.setMinimumSize(160, 110)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)

    def sizeHint(self) -> QSize:
        """Preferred size, in pixels."""
        return QSize(360, 150)

    def painter(self) -> QPainter:
        """Create a painter and draw the background and the border."""
        painter = QPainter(self)
        painter.fillRect(self.rect(), theme.colour("paper"))
        painter.setPen(theme.colour("border"))
        painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
        return painter


class LinesPicture(PaperPicture):
    """Drawing of the lines at an object, each in its colour, at true scale."""

    def __init__(self) -> None:
        super().__init__("patch_section", gettext("Section of the lines at the object"))
        self._points: Mapping[str, Array] = {}
        self._colours: Mapping[str, Colour] = {}
        self._half = np.ones(2)

    def show_points(
        self, points: Mapping[str, Array], colours: Mapping[str, Colour], size: Array
    ) -> None:
        """Show the points of each line.

        Parameters
        ----------
        points : ndarray of shape (n, 2) by line, metres, to the right and upwards from the centre
        size : ndarray of shape (2,), metres
            Extent of the picture, which is enlarged if misaligned lines are outside.
        """
        self._points, self._colours, self._half = points, colours, 0.5 * size
        found = [np.quantile(np.abs(each), 0.99, axis=0) for each in points.values() if len(each)]
        outside = max((float((each / self._half).max()) for each in found), default=0.0)
        if outside > 1:  # in steps, so that the scale rarely changes while an angle is changed
            self._half *= ZOOM_STEP ** np.ceil(np.log(outside) / np.log(ZOOM_STEP))
        self.update()

    @property
    def drawn(self) -> Mapping[str, Array]:
        """Points shown."""
        return self._points

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the points and a scale bar."""
        painter = self.painter()
        wide, high = self.width() - 2 * MARGIN_PX, self.height() - 2 * MARGIN_PX
        scale = min(wide / (2 * self._half[0]), high / (2 * self._half[1]))
        middle = np.array([0.5 * self.width(), 0.5 * self.height()])
        for line, points in self._points.items():
            pen = QPen(QColor(*self._colours[line]), POINT_SIZE_PX)
            pen.setCapStyle(Qt.PenCapStyle.SquareCap)
            painter.setPen(pen)
            places = middle + scale * points * [1.0, -1.0]
            painter.drawPoints(QPolygonF([QPointF(x, y) for x, y in places.tolist()]))
        if self._points:
            self._draw_scale_bar(painter, scale)
        painter.end()

    def _draw_scale_bar(self, painter: QPainter, scale: float) -> None:
        metres = scale_bar_length(1.0 / scale, 0.3 * self.width())
        low = self.height() - MARGIN_PX - 4
        painter.setPen(QPen(theme.colour("text"), 2.5))
        painter.drawLine(QPointF(MARGIN_PX, low), QPointF(MARGIN_PX + metres * scale, low))
        painter.drawText(QPointF(MARGIN_PX, low - 6), length_text(metres))


class CurvePicture(PaperPicture):
    """Mismatch over one angle with its current value and minimum; a click chooses a value."""

    value_clicked = Signal(float)
    """Angle, radians, at the clicked place of the curve."""

    def __init__(self) -> None:
        super().__init__("patch_curve", gettext("Mismatch as a function of the angle"))
        self.setToolTip(gettext("Click to set the angle"))
        self.setCursor(Qt.CursorShape.CrossCursor)
        self._title = ""
        self._values, self._mismatch = np.empty(0), np.empty(0)
        self._current: tuple[float, float] | None = None

    def show_curve(self, title: str, values: Array, mismatch: Array) -> None:
        """Show a curve, or an empty curve while it is being computed.

        Parameters
        ----------
        values : ndarray of shape (n,), radians
        mismatch : ndarray of shape (n,), metres
        """
        known = np.isfinite(mismatch)
        self._title, self._values, self._mismatch = title, values[known], mismatch[known]
        self.update()

    def mark_current(self, value: float, mismatch: float) -> None:
        """Mark the current value, radians, and its mismatch, metres; NaN if it is unknown."""
        self._current = value, mismatch
        self.update()

    @property
    def minimum(self) -> float | None:
        """Angle of the smallest mismatch, radians; None if the curve has no clear minimum."""
        return curve_minimum(self._values, self._mismatch)

    def place(self, value: float, mismatch: float) -> QPointF:
        """Pixels of a value, radians, and a mismatch, metres."""
        first, last = self._values[0], self._values[-1]
        across = (value - first) / (last - first)
        up = mismatch / self._largest_mismatch
        frame = self._frame
        return QPointF(frame.left() + across * frame.width(), frame.bottom() - up * frame.height())

    @property
    def _largest_mismatch(self) -> float:
        return max(1.15 * float(self._mismatch.max()), 1e-4)

    @property
    def _frame(self) -> QRectF:
        top = 26 + self._title_height - self.fontMetrics().lineSpacing()
        return QRectF(LEFT_PX, top, self.width() - LEFT_PX - 14, self.height() - top - BOTTOM_PX)

    @property
    def _title_height(self) -> int:
        """Height of the title, which is wrapped in a narrow picture, pixels."""
        place = QRect(0, 0, self.width() - 2 * MARGIN_PX, self.height())
        wrapped = self.fontMetrics().boundingRect(place, Qt.TextFlag.TextWordWrap, self._title)
        return max(wrapped.height(), self.fontMetrics().lineSpacing())

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Choose the value under the mouse."""
        frame = self._frame
        if event.button() != Qt.MouseButton.LeftButton or not len(self._values):
            return
        across = (event.position().x() - frame.left()) / frame.width()
        if 0.0 <= across <= 1.0:
            first, last = float(self._values[0]), float(self._values[-1])
            self.value_clicked.emit(first + across * (last - first))

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the curve, its axes and marks."""
        painter = self.painter()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(theme.colour("text"))
        place = QRectF(MARGIN_PX, 4, self.width() - 2 * MARGIN_PX, self._title_height)
        painter.drawText(place, Qt.TextFlag.TextWordWrap, self._title)
        if len(self._values) > 1:
            self._draw_axes(painter)
            line = QPolygonF(
                [self.place(v, m) for v, m in zip(self._values, self._mismatch, strict=True)]
            )
            painter.setPen(QPen(theme.colour("accent"), 2))
            painter.drawPolyline(line)
            self._draw_marks(painter)
        painter.end()

    def _draw_axes(self, painter: QPainter) -> None:
        frame = self._frame
        painter.setPen(theme.colour("grid"))
        painter.drawRect(frame)
        painter.setPen(theme.colour("muted"))
        ends = (self._values[0], 0.5 * (self._values[0] + self._values[-1]), self._values[-1])
        for number, value in enumerate(ends):
            text = local_amount(float(np.degrees(value)), CURVE_ANGLE)
            flag = (Qt.AlignmentFlag.AlignLeft, Qt.AlignmentFlag.AlignHCenter,
                    Qt.AlignmentFlag.AlignRight)[number]  # fmt: skip
            box = QRectF(frame.left() - 24, frame.bottom() + 4, frame.width() + 34, 16)
            if number != 1 or frame.width() > 240:
                painter.drawText(box, flag, text)
        for share in (0.0, 0.5, 1.0):
            text = local_amount(share * self._largest_mismatch, CURVE_MISMATCH)
            box = QRectF(0, frame.bottom() - share * frame.height() - 8, LEFT_PX - 6, 16)
            painter.drawText(box, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, text)

    def _label_top(self, lowest: float) -> float:
        """Upper edge of the label of the minimum, where the curve is not, pixels."""
        is_high = self.place(lowest, float(self._mismatch.min())).y() < self._frame.center().y()
        return self._frame.bottom() - 18 if is_high else self._frame.top() + 2

    def _draw_marks(self, painter: QPainter) -> None:
        lowest, frame = self.minimum, self._frame
        if lowest is not None:
            painter.setPen(QPen(theme.colour("done"), 1.5, Qt.PenStyle.DashLine))
            x = self.place(lowest, 0.0).x()
            painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()))
            value = local_amount(float(np.degrees(lowest)), CURVE_ANGLE)
            text = gettext("minimum {angle}", angle=value)
            right = x > frame.center().x()
            width = (x - frame.left() if right else frame.right() - x) - 8
            if painter.fontMetrics().horizontalAdvance(text) > width:
                text = value
            box = QRectF(x - 204 if right else x + 4, self._label_top(lowest), 200, 16)
            side = Qt.AlignmentFlag.AlignRight if right else Qt.AlignmentFlag.AlignLeft
            painter.setPen(theme.colour("done"))
            painter.drawText(box, side, text)
        if self._current is None:
            return
        angle, mismatch = self._current
        if not self._values[0] <= angle <= self._values[-1]:
            return
        painter.setPen(QPen(theme.colour("text"), 1))
        x = self.place(angle, 0.0).x()
        painter.drawLine(QPointF(x, frame.top()), QPointF(x, frame.bottom()))
        if np.isfinite(mismatch):
            painter.setBrush(theme.colour("text"))
            painter.drawEllipse(self.place(angle, min(mismatch, self._largest_mismatch)), 4, 4)
