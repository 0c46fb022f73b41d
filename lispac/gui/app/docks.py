"""Dock panels of the window: which of them are open, default layout, actions and focus."""

from collections.abc import Collection, Mapping

import numpy as np
from PySide6.QtCore import QByteArray, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QAction, QCloseEvent
from PySide6.QtWidgets import QDockWidget, QMainWindow, QStyle, QTabWidget, QToolBar, QWidget

from lispac.gui.app.panel_window import PanelWindow
from lispac.gui.widgets.tab_order import focus_dock_content
from lispac.language import N_, gettext

Area = Qt.DockWidgetArea

WORKFLOW, RESULTS, SIGHTINGS = N_("Workflow"), N_("Results"), N_("Targets by line")
HISTOGRAMS, LOG = N_("Histograms"), N_("Log")
"""English titles of docks: keys of `Docks`; the object names in a saved layout come from them."""
SIDE_WIDTH_PX = 336
"""Initial width of the panel at the left, pixels."""
MIN_STRIP_HEIGHT_PX, MAX_STRIP_SHARE = 150, 0.3
"""Limits of the initial height of the panels at the bottom: pixels, and share of the window."""
ENLARGED_SHARE = 0.55
"""Share of the height of the window that an enlarged panel at the bottom has."""
VIEW_SHARES = {768: 0.455, 960: 0.555}
"""Share of the window that the panels at the bottom initially leave to the 3D view, by the height
of the window in pixels; interpolated between, constant beyond."""


class Dock(QDockWidget):
    """Panel at a side of the window, which the user can close, move and detach."""

    closed = Signal()
    """The user has closed the panel."""
    about_to_open = Signal()
    """An action opens the panel, or brings it to the front."""

    def bring_to_front(self) -> None:
        """Open the panel, or bring it to the front."""
        self.about_to_open.emit()
        self.show()
        self.raise_()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Emit `closed`."""
        super().closeEvent(event)
        self.closed.emit()


Docks = dict[str, Dock]


def create_docks(window: QMainWindow, panels: Mapping[str, tuple[QWidget, Area]]) -> Docks:
    """Create the docks of the panels by title; docks on one side are tabs."""
    # With an enabled layout, Qt leaves empty tab bars behind
    window.layout().setEnabled(False)
    docks: Docks = {}
    last: dict[Area, QDockWidget] = {}
    for title, (panel, area) in panels.items():
        docks[title] = dock = _create_dock(window, title, panel)
        window.addDockWidget(area, dock)
        if area in last:
            window.tabifyDockWidget(last[area], dock)
        last[area] = dock
    for area in Area.LeftDockWidgetArea, Area.RightDockWidgetArea, Area.BottomDockWidgetArea:
        window.setTabPosition(area, QTabWidget.TabPosition.North)
    window.layout().setEnabled(True)
    window.setCorner(Qt.Corner.BottomLeftCorner, Area.LeftDockWidgetArea)
    window.setCorner(Qt.Corner.BottomRightCorner, Area.BottomDockWidgetArea)
    window.setDockOptions(
        QMainWindow.DockOption.AnimatedDocks | QMainWindow.DockOption.AllowTabbedDocks
    )
    return docks


def dock_actions(docks: Mapping[str, QDockWidget]) -> list[QAction]:
    """Actions that bring each panel to the front, or close the panel that is in front.

    They are checked while the panel is open. The actions of Qt would close a dock whose tab is
    behind another, instead of showing it.
    """
    return [_dock_action(dock) for dock in docks.values()]


def _dock_action(dock: QDockWidget) -> QAction:
    action = QAction(dock.windowTitle(), dock)
    action.setCheckable(True)
    action.setChecked(not dock.isHidden())
    # A dock whose tab is behind another is open
    dock.toggleViewAction().toggled.connect(action.setChecked)

    def choose() -> None:
        if dock.visibleRegion().isEmpty():
            focus_dock(dock)
        else:
            dock.close()
        action.setChecked(not dock.isHidden())

    action.triggered.connect(choose)
    return action


def focus_dock(dock: QDockWidget) -> None:
    """Bring a panel to the front and give it the focus."""
    raise_panel(dock.widget())
    # The dock is visible only after Qt has laid out the tabs
    QTimer.singleShot(0, dock, lambda: focus_dock_content(dock))


def raise_panel(panel: QWidget) -> None:
    """Bring a panel to the front, in its dock or its own window."""
    container = panel.parentWidget()
    assert isinstance(container, Dock | PanelWindow)
    container.bring_to_front()


def close_panel(panel: QWidget) -> None:
    """Close the dock or window of a panel."""
    container = panel.parentWidget()
    assert isinstance(container, Dock | PanelWindow)
    container.close()


class DockLayout(QObject):
    """Decides which docks are open, and hides all of them while the view is maximised.

    A dock is opened when there is something to show in it, unless the user has closed it. The docks
    that do not open by themselves are opened by the user.

    Parameters
    ----------
    automatic : titles of the docks that open by themselves
    accompanying : those of them that open only with another dock or with a project, because they
        show nothing that the user waits for, and would take a part of the view
    """

    maximised_changed = Signal(bool)
    closed_by_user = Signal(str)
    """The user has closed the dock with this title."""
    opens_by_itself = Signal()
    """A panel opens because it has something to show; the user did not ask for it."""

    def __init__(
        self,
        window: QMainWindow,
        docks: Docks,
        automatic: Collection[str],
        accompanying: Collection[str] = (),
    ) -> None:
        super().__init__(window)
        self._window, self._docks = window, docks
        self._automatic = frozenset(automatic)
        self._accompanying = frozenset(accompanying)
        self._waiting: frozenset[str] = frozenset()
        self._wanted = set(self._automatic)
        self._filled: frozenset[str] = frozenset()
        self.has_strip_height = False
        """Whether a panel at the bottom was shown, so that their height is the one to keep."""
        self._state_before: QByteArray | None = None
        self._open_before: Collection[str] = ()
        self._must_close_empty = False
        for title, dock in docks.items():
            dock.setVisible(title == WORKFLOW)
            dock.visibilityChanged.connect(
                lambda visible, title=title: visible and self._on_shown(title)
            )
            dock.about_to_open.connect(lambda: self.set_maximised(False))
            dock.closed.connect(lambda title=title: self._on_closed(title))
        self._initial_state = window.saveState()

    # -- content -----------------------------------------------------------------------------

    def show_filled(self, filled: Collection[str], *, is_new_project: bool) -> None:
        """Open the wanted docks that now have something to show.

        Parameters
        ----------
        filled : titles of the docks that have something to show
        is_new_project : whether docks without content are closed as well
        """
        former = frozenset() if is_new_project else self._filled - self._waiting
        self._filled = frozenset(filled)
        self._must_close_empty |= is_new_project
        added = self._filled - former
        others = self._closed_docks(added - self._accompanying)
        self._waiting = frozenset() if is_new_project or others else added & self._accompanying
        if self.is_maximised:
            return
        self._close_empty()
        if not is_new_project and others:
            self.opens_by_itself.emit()
        self._open(added - self._waiting)

    def _close_empty(self) -> None:
        """Close the docks without content once after another project was opened."""
        if self._must_close_empty:
            for title, dock in self._docks.items():
                if title not in self._filled:
                    dock.hide()
        self._must_close_empty = False

    def present(self, title: str) -> None:
        """Bring a dock to the front, unless the user has closed it."""
        if title in self._wanted and not self.is_maximised:
            self._docks[title].show()
            self._docks[title].raise_()

    def _closed_docks(self, titles: Collection[str]) -> list[Dock]:
        """Docks of these titles that the user wants and that are not open."""
        return [
            dock
            for title, dock in self._docks.items()
            if title in titles and title in self._wanted and dock.isHidden()
        ]

    def _open(self, titles: Collection[str]) -> None:
        opened = self._closed_docks(titles)
        for dock in opened:
            dock.show()
        if opened:
            opened[0].raise_()

    def _on_shown(self, title: str) -> None:
        self._wanted.add(title)
        if not self.has_strip_height and title != WORKFLOW and self._window.isVisible():
            self.has_strip_height = True
            self._set_strip_height(self._docks[title])

    def _on_closed(self, title: str) -> None:
        self._wanted.discard(title)
        self.closed_by_user.emit(title)

    def _set_strip_height(self, dock: QDockWidget) -> None:
        if self._window.dockWidgetArea(dock) == Area.BottomDockWidgetArea:
            height = _initial_strip_height(self._window)
            self._window.resizeDocks([dock], [height], Qt.Orientation.Vertical)

    def set_enlarged(self, panel: QWidget, is_enlarged: bool) -> None:
        """Give the panels at the bottom more height for a plot, or their initial height."""
        dock = panel.parentWidget()
        if not isinstance(dock, Dock) or dock.isFloating():
            return
        window = self._window
        height = round(ENLARGED_SHARE * window.height())
        if not is_enlarged:
            height = _initial_strip_height(window)
        window.resizeDocks([dock], [height], Qt.Orientation.Vertical)

    # -- maximised view ----------------------------------------------------------------------

    @property
    def is_maximised(self) -> bool:
        """Whether all docks are hidden, so that the view fills the window."""
        return self._state_before is not None

    def _open_titles(self) -> Collection[str]:
        """Titles of the docks that are open, or that were before the view was maximised."""
        if self.is_maximised:
            return self._open_before
        return [title for title, dock in self._docks.items() if not dock.isHidden()]

    def set_maximised(self, maximised: bool) -> None:
        """Hide all docks and toolbars, or restore them as they were."""
        if maximised == self.is_maximised:
            return
        if maximised:
            self._open_before = self._open_titles()
            self._state_before = self._window.saveState()
            for each in (*self._docks.values(), *self._window.findChildren(QToolBar)):
                each.hide()
        else:
            before, self._state_before = self._state_before, None
            assert before is not None
            self._window.restoreState(before)
            self._close_empty()
            self._open(self._filled - self._waiting)
        self.maximised_changed.emit(maximised)

    # -- layout ------------------------------------------------------------------------------

    def set_initial_sizes(self) -> None:
        """Set the initial sizes of the docks; those at the bottom get theirs when they open."""
        self._window.resizeDocks(
            [self._docks[WORKFLOW]], [SIDE_WIDTH_PX], Qt.Orientation.Horizontal
        )
        self.has_strip_height = False
        for title, dock in self._docks.items():
            if title != WORKFLOW and dock.isVisible():
                self._on_shown(title)

    def restore_default(self) -> None:
        """Restore the initial layout, including closed and floating docks."""
        self._state_before = None
        self._window.restoreState(self._initial_state)
        self._wanted = set(self._automatic)
        self._open(self._filled - self._waiting)
        # The state contains the sizes of docks before the window got its own size
        self.set_initial_sizes()
        self.maximised_changed.emit(False)

    def state(self) -> tuple[QByteArray, list[str]]:
        """State to store: layout of the window without maximised view, titles of wanted docks."""
        layout = self._state_before or self._window.saveState()
        return layout, [title for title in self._docks if title in self._wanted]

    def copy_state_from(self, former: "DockLayout") -> None:
        """Open the docks that are open in a former window, and bring the same ones to the front."""
        for title in former._open_titles():
            self._docks[title].show()
        for title, dock in self._docks.items():
            if not former._docks[title].visibleRegion().isEmpty():
                dock.raise_()

    def restore(
        self, layout: QByteArray, wanted: Collection[str] | None, *, has_strip_height: bool = True
    ) -> None:
        """Restore a stored layout.

        Parameters
        ----------
        wanted : titles of wanted docks; None if the layout was stored without them
        has_strip_height : whether a panel at the bottom had been shown before it was stored
        """
        self._window.restoreState(layout)
        self._wanted = set(self._automatic if wanted is None else wanted)
        self.has_strip_height = has_strip_height


def _initial_strip_height(window: QMainWindow) -> int:
    """Height of the panels at the bottom that leaves the share of `VIEW_SHARES` to the view."""
    view = window.centralWidget()
    share = float(np.interp(window.height(), list(VIEW_SHARES), list(VIEW_SHARES.values())))
    view_height = share * window.width() * window.height() / max(view.width(), 1)
    separator = window.style().pixelMetric(QStyle.PixelMetric.PM_DockWidgetSeparatorExtent)
    height = round(window.statusBar().y() - view.y() - view_height) - separator
    return min(max(height, MIN_STRIP_HEIGHT_PX), round(MAX_STRIP_SHARE * window.height()))


def show_with_owned_windows(window: QMainWindow) -> None:
    """Show a window and then its floating panels and other windows, so that they are above it.

    A window manager keeps a window above its parent only if the parent was shown first.
    """
    owned = {
        each: each.size()
        for each in window.findChildren(QWidget)
        if each.isWindow() and each.isVisible()
    }
    for each in owned:
        each.hide()
    window.show()
    for each, size in owned.items():
        # Each would become the active window, at a time that the window system chooses
        each.setAttribute(Qt.WidgetAttribute.WA_ShowWithoutActivating)
        each.show()
        each.setAttribute(Qt.WidgetAttribute.WA_ShowWithoutActivating, False)
        each.resize(size)


def hide_floating_docks(docks: Mapping[str, QDockWidget]) -> None:
    """Hide the floating panels, which do not close with their window."""
    for dock in docks.values():
        if dock.isFloating():
            dock.hide()


def _create_dock(window: QMainWindow, title: str, panel: QWidget) -> Dock:
    dock = Dock(gettext(title), window)
    dock.setObjectName(f"dock_{title.lower().replace(' ', '_')}")
    dock.setWidget(panel)
    return dock
