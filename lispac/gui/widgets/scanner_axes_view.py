"""Picture of the scanner axes in the body frame, rotated with the mouse."""

import numpy as np
from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent, QPen, QPolygonF
from PySide6.QtWidgets import QSizePolicy, QWidget

from lispac.geometry.rotations import rotation_matrix
from lispac.gui.appearance import theme
from lispac.language import gettext
from lispac.survey.conventions.axes import FORWARD_PORT_UP, Axes, axes_matrix

EXAGGERATION_FACTORS = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
"""Possible factors by which the rotation is enlarged, ascending."""
MAX_SHOWN_DEG = 25.0
"""Largest enlarged rotation; with a larger one, the axes would be hard to recognise."""
SCANNER_AXES = (("X", "axis_x"), ("Y", "axis_y"), ("Z", "axis_z"))
"""Letters of the scanner axes, with the names of their colours in the scheme."""
_HULL_OUTLINE = np.array(
    [[1.0, 0, 0], [0.55, 0.3, 0], [-0.75, 0.3, 0], [-0.75, -0.3, 0], [0.55, -0.3, 0]]
)
"""Corners of the vessel in the body frame; the drawn body axes have a length of 1.2."""
ORIGIN_SHARE, ORIGIN_SHARE_DOWN = 0.58, 0.34
"""Height of the origin below the upper edge, as a share, with an axis up and with one down."""
_INITIAL_VIEW_DEG = (-142.0, 26.0)
"""Azimuth of the eye, counter-clockwise from ahead, and elevation."""
_DEGREES_PER_PIXEL = 0.5
_KEY_STEP_DEG = 5.0


def exaggeration_factor(boresight: np.ndarray) -> int:
    """Factor by which a rotation is enlarged in the picture.

    Parameters
    ----------
    boresight : ndarray of shape (3,), radians
    """
    angle_deg = np.degrees(np.linalg.norm(_rotation_vector(boresight)))
    fitting = [factor for factor in EXAGGERATION_FACTORS if factor * angle_deg <= MAX_SHOWN_DEG]
    return fitting[-1] if fitting and angle_deg > 1e-6 else 1


def exaggerated_rotation(boresight: np.ndarray) -> tuple[int, np.ndarray]:
    """Factor, and the rotation enlarged by it, from scanner to body.

    Parameters
    ----------
    boresight : ndarray of shape (3,), radians

    Returns
    -------
    factor : int
    rotation : ndarray of shape (3, 3)
    """
    if not boresight.any():
        return 1, np.eye(3)  # without the import of SciPy, which would delay the first window
    from scipy.spatial.transform import Rotation

    factor = exaggeration_factor(boresight)
    return factor, Rotation.from_rotvec(factor * _rotation_vector(boresight)).as_matrix()


def exaggeration_text(factor: int) -> str:
    """Text on the factor by which the rotation is enlarged."""
    if factor == 1:
        return gettext("Scanner axes as mounted")
    return gettext("Scanner axes, rotation enlarged {factor:n} times", factor=factor)


def _rotation_vector(boresight: np.ndarray) -> np.ndarray:
    from scipy.spatial.transform import Rotation

    return Rotation.from_matrix(rotation_matrix(*boresight)).as_rotvec()


class ScannerAxesView(QWidget):
    """Body axes in grey and scanner axes in colour, with the rotation enlarged."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("gizmo")
        self.setAccessibleName(gettext("Scanner axes relative to the body axes"))
        self.setToolTip(
            gettext(
                "Axes of the chosen program. Grey: axes of the vessel. Coloured: axes of the "
                "scanner, with the rotation enlarged. Drag or use the arrow keys to rotate, "
                "double-click to reset."
            )
        )
        self.setMinimumHeight(190)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setCursor(Qt.CursorShape.OpenHandCursor)
        self.view_deg = _INITIAL_VIEW_DEG
        self.factor = 1
        self._rotation_body_scanner = np.eye(3)
        self._axes = self._scanner_axes = FORWARD_PORT_UP
        self._last: QPointF | None = None

    def sizeHint(self) -> QSize:
        """Preferred size, in pixels."""
        return QSize(340, 210)

    def show_boresight(
        self,
        boresight: np.ndarray,
        axes: Axes = FORWARD_PORT_UP,
        scanner_axes: Axes = FORWARD_PORT_UP,
    ) -> None:
        """Draw a boresight.

        Parameters
        ----------
        boresight : ndarray of shape (3,), radians
            Roll, pitch and yaw of this program.
        axes, scanner_axes : directions of the body axes and of the scanner axes X, Y and Z
        """
        self.factor, self._rotation_body_scanner = exaggerated_rotation(boresight)
        self._axes, self._scanner_axes = axes, scanner_axes
        self.update()

    @property
    def body_axes(self) -> np.ndarray:
        """Body axes X, Y and Z as drawn, in rows, by their parts forward, left and up."""
        return axes_matrix(self._axes)

    @property
    def scanner_axes(self) -> np.ndarray:
        """Scanner axes X, Y and Z as drawn, in rows, by their parts forward, left and up."""
        return axes_matrix(self._scanner_axes) @ self._rotation_body_scanner.T

    def reset_view(self) -> None:
        """Reset the view to the initial one, from above the starboard quarter."""
        self.view_deg = _INITIAL_VIEW_DEG
        self.update()

    def turn_view(self, azimuth_deg: float, elevation_deg: float) -> None:
        """Turn the view; the elevation is limited to 89 degrees up and down."""
        azimuth, elevation = self.view_deg
        azimuth = (azimuth + azimuth_deg + 180) % 360 - 180
        self.view_deg = (azimuth, float(np.clip(elevation + elevation_deg, -89.0, 89.0)))
        self.update()

    def project(self, points_body: np.ndarray) -> np.ndarray:
        """Screen coordinates (right, up, towards the eye) of points, shape (n, 3).

        The eye is at the azimuth of the view, counted counter-clockwise from ahead.
        """
        azimuth, elevation = np.radians(self.view_deg)
        ca, sa, ce, se = np.cos(azimuth), np.sin(azimuth), np.cos(elevation), np.sin(elevation)
        right = (-sa, ca, 0.0)
        above = (-se * ca, -se * sa, ce)
        towards = (ce * ca, ce * sa, se)
        return np.atleast_2d(points_body) @ np.array([right, above, towards]).T

    def paintEvent(self, event: QPaintEvent) -> None:
        """Paint the axes of the scanner and of the body."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.fillRect(self.rect(), QColor(theme.PAPER))
        painter.setPen(QPen(QColor(theme.ACCENT if self.hasFocus() else theme.BORDER)))
        painter.drawRect(self.rect().adjusted(0, 0, -1, -1))
        painter.setPen(QPen(QColor(theme.EDGE)))
        painter.setBrush(QColor(theme.HULL))
        painter.drawPolygon(QPolygonF([self._pixel(corner) for corner in _HULL_OUTLINE]))
        # Axes farther from the eye are drawn first.
        drawn = [
            (1.2 * axis, "body_axis", f"{letter} {gettext(name)}", 1.5)
            for axis, name, letter in zip(self.body_axes, self._axes, "XYZ", strict=True)
        ]
        drawn += [
            (0.95 * axis, colour, letter, 3.0)
            for axis, (letter, colour) in zip(self.scanner_axes, SCANNER_AXES, strict=True)
        ]
        for axis, colour, name, width in sorted(drawn, key=lambda each: self._axis_depth(each[0])):
            self._draw_axis(painter, axis, colour, name, width)
        painter.setPen(QColor(theme.MUTED))
        painter.drawText(10, self.height() - 10, exaggeration_text(self.factor))
        painter.end()

    def _draw_axis(
        self, painter: QPainter, axis: np.ndarray, colour: str, name: str, width: float
    ) -> None:
        pen = QPen(theme.colour(colour))
        pen.setWidthF(width)
        pen.setCapStyle(Qt.PenCapStyle.RoundCap)
        painter.setPen(pen)
        painter.drawLine(self._pixel(np.zeros(3)), self._pixel(axis))
        metrics = painter.fontMetrics()
        tip = self._pixel(1.12 * axis)
        x = tip.x() - metrics.horizontalAdvance(name) / 2
        x = min(max(x, 4.0), self.width() - metrics.horizontalAdvance(name) - 4.0)
        painter.drawText(QPointF(x, tip.y() + metrics.ascent() / 2 - 1), name)

    def _pixel(self, point_body: np.ndarray) -> QPointF:
        x, y, _ = self.project(point_body)[0]
        scale = 0.42 * min(self.height(), self.width())
        origin = ORIGIN_SHARE if self.body_axes[:, 2].sum() > 0 else ORIGIN_SHARE_DOWN
        return QPointF(self.width() / 2 + scale * x, self.height() * origin - scale * y)

    def _axis_depth(self, axis: np.ndarray) -> float:
        return float(self.project(axis)[0, 2])

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Start turning the view."""
        self._last = event.position()
        self.setCursor(Qt.CursorShape.ClosedHandCursor)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Turn the view with the mouse."""
        if self._last is None:
            return
        drag = event.position() - self._last
        self._last = event.position()
        self.turn_view(-_DEGREES_PER_PIXEL * drag.x(), _DEGREES_PER_PIXEL * drag.y())

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Stop turning the view."""
        self._last = None
        self.setCursor(Qt.CursorShape.OpenHandCursor)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Reset the view."""
        self.reset_view()

    def keyPressEvent(self, event) -> None:
        """Turn the view with the arrows."""
        turns = {
            Qt.Key.Key_Left: (_KEY_STEP_DEG, 0.0),
            Qt.Key.Key_Right: (-_KEY_STEP_DEG, 0.0),
            Qt.Key.Key_Up: (0.0, -_KEY_STEP_DEG),
            Qt.Key.Key_Down: (0.0, _KEY_STEP_DEG),
        }
        if event.key() in turns:
            self.turn_view(*turns[event.key()])
        else:
            super().keyPressEvent(event)
