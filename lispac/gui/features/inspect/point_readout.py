"""Values of the point under the mouse: in the status bar, in a tooltip, and to be copied."""

from collections.abc import Callable, Iterable
from html import escape

from PySide6.QtCore import QObject, QPoint, QRect, QSize, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QCursor, QFontMetrics, QGuiApplication
from PySide6.QtWidgets import QMenu, QToolTip

from lispac.errors import LispacError
from lispac.gui.app.status_bar import FIELD_SEPARATOR
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.viewport.base import PickedPoint, Viewport
from lispac.gui.widgets.result_tables import fact_text
from lispac.language import N_, gettext
from lispac.present.survey.measured_point import MeasuredPoint, brief_point_facts, point_facts
from lispac.present.tables import Fact
from lispac.project import Project
from lispac.workflow.project.measured_points import PLANE_RADIUS_M, PointReader

READ_DELAY_MS = 60
"""Time after which the values of the point under the resting mouse are read."""
TOOLTIP_DELAY_MS = 800
"""Time for which the mouse must rest before the tooltip appears."""
TOOLTIP_DISTANCES = QSize(44, 20)
"""Horizontal and vertical distance of the tooltip from the mouse, pixels."""
TOOLTIP_MARGINS = QSize(32, 40)
"""Largest difference of the sizes of the tooltip and its text, with a margin for the offset that Qt
adds, pixels."""
QT_TOOLTIP_OFFSET = QPoint(2, 16)
"""Offset that Qt adds to the position of a tooltip, for the usual mouse pointer, pixels."""
NO_POINT_TEXT = N_("No point under the cursor")


class PointReadout(QObject):
    """Reads the values of the point under the resting mouse.

    Attributes
    ----------
    values : names and texts of the values of the point; empty if there is none
    may_show_tooltip : function that returns whether the tooltip may cover the view
    """

    shown = Signal(str)
    """Values of the point in one line; empty if there is none."""

    def __init__(
        self,
        document: Document,
        scene: Scene,
        viewport: Viewport,
        copy_picture: QAction,
        note: Callable[[str], None],
        is_picking: Callable[[], bool],
    ) -> None:
        super().__init__(scene)
        self._document, self._scene, self._viewport = document, scene, viewport
        self._copy_picture, self._note, self._is_picking = copy_picture, note, is_picking
        self._point: PickedPoint | None = None
        self._reader: tuple[Project, PointReader] | None = None
        self.values: list[tuple[str, str]] = []
        self.may_show_tooltip: Callable[[], bool] = lambda: True
        self._tooltip_lines: list[str] = []
        self._reading = QTimer(self, singleShot=True, interval=READ_DELAY_MS)
        self._reading.timeout.connect(self._show_values)
        self._tooltip = QTimer(self, singleShot=True, interval=TOOLTIP_DELAY_MS)
        self._tooltip.timeout.connect(self._show_tooltip)
        viewport.signals.hovered.connect(self._on_hovered)
        viewport.signals.copy_requested.connect(self.copy)
        viewport.signals.menu_requested.connect(self._show_menu)
        scene.drawn.connect(lambda: self._on_hovered(None))
        document.about_to_open.connect(self._clear_project)

    def copy(self) -> None:
        """Copy the values of the point under the mouse to the clipboard."""
        if self._reading.isActive():
            self._show_values()
        if not self.values:
            self._note(gettext(NO_POINT_TEXT))
            return
        _copy(self.values)
        self._note(gettext("The values of the point were copied."))

    def _on_hovered(self, point: PickedPoint | None) -> None:
        self._point = point
        self._tooltip.stop()
        if point is None:
            self._reading.stop()
            self._set_values([])
        else:
            self._reading.start()

    def _show_values(self) -> None:
        self._reading.stop()
        measured = None if self._point is None else self._measured(self._point)
        self._set_values([] if measured is None else _facts_texts(point_facts(measured)))
        if measured is not None:
            self._tooltip_lines = [
                FIELD_SEPARATOR.join(
                    gettext("{name}: {text}", name=name, text=text)
                    for name, text in _facts_texts(line)
                )
                for line in brief_point_facts(measured)
            ]
            self._tooltip.start()

    def _set_values(self, values: list[tuple[str, str]]) -> None:
        if values != self.values:
            self.values = values
            self.shown.emit(
                FIELD_SEPARATOR.join(
                    gettext("{name}: {text}", name=name, text=text) for name, text in values
                )
            )

    def _measured(self, point: PickedPoint) -> MeasuredPoint | None:
        """Values of a point; None if they are not available."""
        project, survey = self._document.current_data
        index = self._scene.sample_index(point)
        if project is None or survey is None or index is None:
            return None
        try:
            if self._reader is None or self._reader[0].lines is not project.lines:
                self._reader = project, PointReader(project, survey.trajectory)
            near = self._viewport.drawn_near(point.line, point.position, PLANE_RADIUS_M)
            cloud = self._scene.clouds[point.line]
            return self._reader[1].values(point.line, cloud, index, near)
        except LispacError:  # such as a coordinate system whose grid is missing now
            return None

    def _show_tooltip(self) -> None:
        """Show the values beside the mouse until it moves, except while points are picked."""
        is_pressed = QGuiApplication.mouseButtons() != Qt.MouseButton.NoButton
        has_control = Qt.KeyboardModifier.ControlModifier & QGuiApplication.queryKeyboardModifiers()
        if not self.values or is_pressed or has_control or self._is_picking():
            return
        if not self.may_show_tooltip():
            return
        view, place = self._viewport.widget, QCursor.pos()
        # Qt hides the tooltip if this widget, which must be the one under the mouse, reports a move
        widget = view.childAt(view.mapFromGlobal(place)) or view
        here = QRect(widget.mapFromGlobal(place) - QPoint(2, 2), widget.mapFromGlobal(place))
        text = "<br>".join(map(escape, self._tooltip_lines))
        bounds = QRect(view.mapToGlobal(QPoint(0, 0)), view.size())
        corner = tooltip_corner(place, self._tooltip_size, bounds)
        QToolTip.showText(
            corner - QT_TOOLTIP_OFFSET, f"<p style='white-space:pre'>{text}</p>", widget,
            here.adjusted(0, 0, 2, 2),
        )  # fmt: skip

    @property
    def _tooltip_size(self) -> QSize:
        """Upper limit of the size of the tooltip, pixels."""
        metrics = QFontMetrics(QToolTip.font())
        width = max(map(metrics.horizontalAdvance, self._tooltip_lines))
        height = metrics.lineSpacing() * len(self._tooltip_lines)
        return QSize(width, height) + TOOLTIP_MARGINS

    def _show_menu(self, point: PickedPoint | None, place: QPoint) -> None:
        """Show the menu of the view for the point under the right mouse button."""
        measured = None if point is None else self._measured(point)
        values = [] if measured is None else _facts_texts(point_facts(measured))
        menu = QMenu(self._viewport.widget)
        menu.setObjectName("point_menu")
        menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        copying = menu.addAction(gettext("Copy the point"), lambda: _copy(values))
        copying.setEnabled(bool(values))
        menu.addAction(self._copy_picture)
        menu.popup(place)

    def _clear_project(self) -> None:
        self._reader = None
        self._on_hovered(None)


def tooltip_corner(mouse: QPoint, size: QSize, bounds: QRect) -> QPoint:
    """Upper left corner of a tooltip: at the lower right of the mouse, if there is room.

    Otherwise it is on the other side. The points around the mouse stay visible. All values are in
    pixels on the screen.
    """
    x = _beside(mouse.x(), TOOLTIP_DISTANCES.width(), size.width(), bounds.left(), bounds.right())
    y = _beside(mouse.y(), TOOLTIP_DISTANCES.height(), size.height(), bounds.top(), bounds.bottom())
    return QPoint(x, y)


def _beside(mouse: int, distance: int, length: int, low: int, high: int) -> int:
    """Start of a tooltip along one axis: after the mouse, or before it if there is more room."""
    after, before = mouse + distance, mouse - distance - length
    return before if after + length > high and mouse - low > high - mouse else after


def _facts_texts(facts: Iterable[Fact]) -> list[tuple[str, str]]:
    return [(fact.name, fact_text(fact)) for fact in facts]


def _copy(values: list[tuple[str, str]]) -> None:
    """Copy names and values, one pair a line, as text that a spreadsheet separates too."""
    QGuiApplication.clipboard().setText("\n".join(f"{name}\t{text}" for name, text in values))
