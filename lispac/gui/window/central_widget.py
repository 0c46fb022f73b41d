"""Central widget of the window: the 3D view, or the start page without a project."""

from PySide6.QtCore import QRect
from PySide6.QtGui import QPainter, QPaintEvent, QRegion
from PySide6.QtWidgets import QApplication, QStackedWidget, QVBoxLayout, QWidget

from lispac.gui.appearance import theme
from lispac.gui.features.help.tour import TourCard
from lispac.gui.features.open_project.start_page import StartPage
from lispac.gui.viewport.base import Viewport

FRAME_WIDTH_PX = 2
"""Width of the frame that shows the keyboard focus of the view, pixels."""


class CentralWidget(QWidget):
    """3D view or start page, with the card of the tour above them."""

    def __init__(self, viewport: Viewport) -> None:
        super().__init__()
        self.setMinimumSize(240, 180)
        self.card, self.start = TourCard(), StartPage()
        self._pages = QStackedWidget()
        self._view = viewport.widget
        self._pages.addWidget(self.start)
        self._pages.addWidget(self._view)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.card)
        layout.addWidget(_FocusFrame(self._pages, self._view), 1)

    def show_view(self, visible: bool) -> None:
        """Show the 3D view, or the start page."""
        self._pages.setCurrentWidget(self._view if visible else self.start)


class _FocusFrame(QWidget):
    """Frame around the pages that is drawn while the 3D view has the focus."""

    def __init__(self, pages: QWidget, view: QWidget) -> None:
        super().__init__()
        self._view, self._drawn = view, False
        layout = QVBoxLayout(self)
        layout.setContentsMargins(FRAME_WIDTH_PX, FRAME_WIDTH_PX, FRAME_WIDTH_PX, FRAME_WIDTH_PX)
        layout.addWidget(pages)
        QApplication.instance().focusChanged.connect(self._update_frame)

    def _update_frame(self, _old: QWidget | None, new: QWidget | None) -> None:
        drawn = new is not None and (new is self._view or self._view.isAncestorOf(new))
        if drawn != self._drawn:
            self._drawn = drawn
            self.update(QRegion(self.rect()).subtracted(self._inner_rect()))

    def _inner_rect(self) -> QRect:
        return self.rect().adjusted(
            FRAME_WIDTH_PX, FRAME_WIDTH_PX, -FRAME_WIDTH_PX, -FRAME_WIDTH_PX
        )

    def paintEvent(self, event: QPaintEvent) -> None:
        if self._drawn:
            painter = QPainter(self)
            painter.setClipRegion(QRegion(self.rect()).subtracted(self._inner_rect()))
            painter.fillRect(self.rect(), theme.colour("accent"))
