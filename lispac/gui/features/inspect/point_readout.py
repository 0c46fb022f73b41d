"""Values of the point under the mouse: in the status bar, in a tooltip, and to be copied."""

from collections.abc import Callable
from html import escape

from PySide6.QtCore import QObject, QPoint, QRect, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QCursor, QGuiApplication
from PySide6.QtWidgets import QMenu, QToolTip

from lispac.errors import LispacError
from lispac.gui.app.status_bar import FIELD_SEPARATOR
from lispac.gui.project.document import Document
from lispac.gui.project.scene import Scene
from lispac.gui.viewport.base import PickedPoint, Viewport
from lispac.gui.widgets.result_tables import fact_text
from lispac.language import N_, gettext
from lispac.project import Project
from lispac.workflow.project.measured_points import PLANE_RADIUS_M, PointReader

READ_DELAY_MS = 60
"""Time after which the values of the point under the resting mouse are read."""
TOOLTIP_DELAY_MS = 800
"""Time for which the mouse must rest before the tooltip appears."""
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
    ) -> None:
        super().__init__(scene)
        self._document, self._scene, self._viewport = document, scene, viewport
        self._copy_picture, self._note = copy_picture, note
        self._point: PickedPoint | None = None
        self._reader: tuple[Project, PointReader] | None = None
        self.values: list[tuple[str, str]] = []
        self.may_show_tooltip: Callable[[], bool] = lambda: True
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
        self._set_values([] if self._point is None else self._values_of(self._point))
        if self.values and self.may_show_tooltip():
            self._tooltip.start()

    def _set_values(self, values: list[tuple[str, str]]) -> None:
        if values != self.values:
            self.values = values
            self.shown.emit(FIELD_SEPARATOR.join(f"{name} {text}" for name, text in values))

    def _values_of(self, point: PickedPoint) -> list[tuple[str, str]]:
        from lispac.present.measured_point import point_facts

        project, survey = self._document.current_data
        index = self._scene.sample_index(point)
        if project is None or survey is None or index is None:
            return []
        try:
            if self._reader is None or self._reader[0].lines is not project.lines:
                self._reader = project, PointReader(project, survey.trajectory)
            near = self._viewport.drawn_near(point.line, point.position, PLANE_RADIUS_M)
            cloud = self._scene.clouds[point.line]
            read = self._reader[1].values(point.line, cloud, index, near)
        except LispacError:  # such as a coordinate system whose grid is missing now
            return []
        return [(fact.name, fact_text(fact)) for fact in point_facts(read)]

    def _show_tooltip(self) -> None:
        widget = self._viewport.widget
        if self.values and QGuiApplication.mouseButtons() == Qt.MouseButton.NoButton:
            lines = [f"{name}: {text}" for name, text in self.values]
            text = "<br>".join(map(escape, (*lines, gettext("Ctrl+C: copy"))))
            place = QCursor.pos()
            here = QRect(widget.mapFromGlobal(place) - QPoint(2, 2), widget.mapFromGlobal(place))
            QToolTip.showText(place, text, widget, here.adjusted(0, 0, 2, 2))

    def _show_menu(self, point: PickedPoint | None, place: QPoint) -> None:
        """Show the menu of the view for the point under the right mouse button."""
        values = [] if point is None else self._values_of(point)
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


def _copy(values: list[tuple[str, str]]) -> None:
    """Copy names and values, one pair a line, as text that a spreadsheet separates too."""
    QGuiApplication.clipboard().setText("\n".join(f"{name}\t{text}" for name, text in values))
