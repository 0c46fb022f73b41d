"""Window of one panel, beside the main window."""

from collections.abc import Iterable

from PySide6.QtCore import QPoint, QRect, QSize, Qt
from PySide6.QtGui import QAction, QCloseEvent, QKeyEvent, QKeySequence, QShortcut
from PySide6.QtWidgets import QMainWindow, QWidget

from lispac.gui.app.settings import AppSettings
from lispac.gui.app.status_bar import TaskStatusBar
from lispac.gui.widgets import tab_order
from lispac.language import gettext

MARGIN_RIGHT_PX, MARGIN_BOTTOM_PX, MARGIN_NARROW_PX = 24, 48, 12
"""Distance from the right and lower edges at first opening, which includes the frame, and from the
lower edge of a narrow window, pixels."""
TITLE_BAR_PX = 20
"""Approximate height of the title bar, which a narrow window has below the toolbar, pixels."""
FLAGS = (
    Qt.WindowType.Dialog
    | Qt.WindowType.CustomizeWindowHint
    | Qt.WindowType.WindowTitleHint
    | Qt.WindowType.WindowSystemMenuHint
    | Qt.WindowType.WindowMinMaxButtonsHint
    | Qt.WindowType.WindowCloseButtonHint
)
"""Type of a window that stays above its parent, with the buttons of a main window."""
OWN_KEYS = frozenset(map(QKeySequence, ("Esc", "Return", "Enter")))
"""Keys that have their own meaning in this window: close, and press the focused button."""


class PanelWindow(QMainWindow):
    """Window that shows one panel and stays open above the main window.

    It closes with Esc or Ctrl+W, which changes nothing, and with the main window. Its geometry is
    stored.

    Parameters
    ----------
    title : English title
    size : size in pixels when it is opened for the first time
    view : widget that the window covers as little as possible when it is opened for the first time
    narrow_width : width with which it is placed at the left edge of the parent if it would cover
        the view otherwise, pixels; 0 for none
    """

    def __init__(
        self,
        title: str,
        panel: QWidget,
        size: QSize,
        parent: QWidget,
        settings: AppSettings,
        view: QWidget | None = None,
        narrow_width: int = 0,
    ) -> None:
        super().__init__(parent, FLAGS)
        self._size, self._settings, self._view = size, settings, view
        self._narrow_width = narrow_width
        self.setObjectName(f"window_{title.lower().replace(' ', '_')}")
        self.setWindowTitle(f"{gettext(title)} – LISPAC")
        self.setCentralWidget(panel)
        self.task_bar = TaskStatusBar(is_narrow=True)
        self.setStatusBar(self.task_bar)
        self._is_placed = False
        QShortcut(QKeySequence.StandardKey.Close, self, self.close)

    def sizeHint(self) -> QSize:
        """Size when it is opened for the first time, in pixels."""
        return self._size

    def share_actions(self, actions: Iterable[QAction]) -> None:
        """Make the shortcuts of the main window work in this window too."""
        self.addActions([each for each in actions if OWN_KEYS.isdisjoint(each.shortcuts())])

    def bring_to_front(self) -> None:
        """Open the window, or bring it to the front."""
        if not self._is_placed:
            self._place()
        self.setWindowState(self.windowState() & ~Qt.WindowState.WindowMinimized)
        self.show()
        self.raise_()
        self.activateWindow()

    def _place(self) -> None:
        """Restore the stored geometry; else place the window for the first time."""
        self._is_placed = True
        stored = self._settings.window_geometry(self.objectName())
        if stored is not None and self.restoreGeometry(stored):
            return
        screen, parent = self.screen().availableGeometry(), self.parentWidget().geometry()
        margin = QSize(MARGIN_RIGHT_PX, MARGIN_BOTTOM_PX)
        size = self._size.boundedTo(screen.size() - margin)
        corner = parent.bottomRight()
        bottom = min(corner.y(), screen.bottom())
        right = max(screen.left(), min(corner.x(), screen.right()) - size.width() - MARGIN_RIGHT_PX)
        low = max(screen.top(), bottom - size.height() - MARGIN_BOTTOM_PX)
        places = [QRect(QPoint(right, low), size)]  # over the lower right of the parent
        if self._view is not None:
            edge = max(screen.left(), screen.right() - size.width() - MARGIN_RIGHT_PX)
            places += [QRect(QPoint(x, low), size) for x in (edge, screen.left())]
            if self._narrow_width:
                top = max(screen.top(), self._view.mapToGlobal(QPoint()).y())
                left = max(screen.left(), parent.left())
                top += TITLE_BAR_PX
                height = max(bottom - top - MARGIN_NARROW_PX, 1)
                places.append(QRect(left, top, self._narrow_width, height))
        place = min(places, key=self._covered_area)
        self.resize(place.size())
        self.move(place.topLeft())

    def _covered_area(self, rect: QRect) -> int:
        """Area of the view, square pixels, that the window would cover."""
        if self._view is None:
            return 0
        view = QRect(self._view.mapToGlobal(QPoint()), self._view.size())
        common = rect.intersected(view)
        return max(0, common.width()) * max(0, common.height())

    def save_geometry(self) -> None:
        """Store the geometry, if the window has been open."""
        if self._is_placed:
            self._settings.save_window_geometry(self.objectName(), self.saveGeometry())

    def copy_state_from(self, former: "PanelWindow") -> None:
        """Open the window where a former one is open."""
        if former.isVisible():
            self._is_placed = True
            self.restoreGeometry(former.saveGeometry())
            self.show()

    def focusNextPrevChild(self, forward: bool) -> bool:
        """Move the focus with Tab and Shift+Tab."""
        return tab_order.focus_next(self, forward)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Press the focused button with Enter; close the window with Esc."""
        if event.key() == Qt.Key.Key_Escape:
            self.close()
        elif not tab_order.press_focused_button(self, event):
            super().keyPressEvent(event)

    def closeEvent(self, event: QCloseEvent) -> None:
        """Store the geometry."""
        self.save_geometry()
        super().closeEvent(event)
