"""The middle of the window: the view of the lines, or ways to begin where there are none."""

from PySide6.QtWidgets import QStackedWidget, QVBoxLayout, QWidget

from lispac.gui.start_page import StartPage
from lispac.gui.tour import TourCard
from lispac.gui.viewport.base import Viewport


class Stage(QWidget):
    """The viewport with the start page behind it, and the tour's card above both."""

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
        layout.addWidget(self._pages, 1)

    def show_view(self, wanted: bool) -> None:
        """Show the view, or where there is nothing to see the ways to begin."""
        self._pages.setCurrentWidget(self._view if wanted else self.start)
