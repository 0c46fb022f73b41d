"""Dock panels of the window: default layout, actions and focus."""

from collections.abc import Mapping

from PySide6.QtCore import QByteArray, Qt, QTimer
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDockWidget, QMainWindow, QTabWidget, QWidget

from lispac.gui.widgets.tab_order import focus_dock_content
from lispac.language import N_, gettext

Area = Qt.DockWidgetArea
Docks = dict[str, QDockWidget]

WORKFLOW, RESULTS, SIGHTINGS = N_("Workflow"), N_("Results"), N_("Targets by line")
HISTOGRAMS, LOG = N_("Histograms"), N_("Log")
"""English titles of docks: keys of `Docks`; the object names in a saved layout come from them."""


def create_docks(window: QMainWindow, panels: Mapping[str, tuple[QWidget, Area]]) -> Docks:
    """Create the docks of the panels by title; docks on one side are tabs, the first in front."""
    # With an enabled layout, Qt leaves empty tab bars behind
    window.layout().setEnabled(False)
    docks: Docks = {}
    last: dict[Area, QDockWidget] = {}
    first: dict[Area, QDockWidget] = {}
    for title, (panel, area) in panels.items():
        docks[title] = dock = _create_dock(window, title, panel)
        window.addDockWidget(area, dock)
        if area in last:
            window.tabifyDockWidget(last[area], dock)
        last[area] = dock
        first.setdefault(area, dock)
    for area in first:
        window.setTabPosition(area, QTabWidget.TabPosition.North)
    window.layout().setEnabled(True)
    for dock in first.values():
        dock.raise_()
    window.setCorner(Qt.Corner.BottomLeftCorner, Area.LeftDockWidgetArea)
    window.setCorner(Qt.Corner.BottomRightCorner, Area.BottomDockWidgetArea)
    window.setDockOptions(
        QMainWindow.DockOption.AnimatedDocks | QMainWindow.DockOption.AllowTabbedDocks
    )
    return docks


def dock_actions(docks: Mapping[str, QDockWidget]) -> list[QAction]:
    """Actions that bring each panel to the front, or close the panel that is in front.

    The actions of Qt would close a dock that is hidden behind another, instead of showing it.
    """
    return [_dock_action(dock) for dock in docks.values()]


def _dock_action(dock: QDockWidget) -> QAction:
    action = QAction(dock.windowTitle(), dock)
    action.setCheckable(True)
    dock.visibilityChanged.connect(action.setChecked)  # also False for a dock behind another
    action.triggered.connect(lambda visible: focus_dock(dock) if visible else dock.close())
    return action


def focus_dock(dock: QDockWidget) -> None:
    """Bring a panel to the front and give it the focus."""
    raise_panel(dock.widget())
    # The dock is visible only after Qt has laid out the tabs
    QTimer.singleShot(0, dock, lambda: focus_dock_content(dock))


def raise_panel(panel: QWidget) -> None:
    """Bring the dock of a panel to the front without changing the focus."""
    dock = panel.parentWidget()
    assert isinstance(dock, QDockWidget)
    dock.show()
    dock.raise_()


def set_initial_sizes(window: QMainWindow, docks: Mapping[str, QDockWidget]) -> None:
    """Set the initial sizes of the panels."""
    sides = [docks[WORKFLOW], docks[RESULTS]]
    window.resizeDocks(sides, [350, 400], Qt.Orientation.Horizontal)
    bottom = [docks[SIGHTINGS]]
    window.resizeDocks(bottom, [3 * window.height() // 10], Qt.Orientation.Vertical)


def restore_default_layout(
    window: QMainWindow, docks: Mapping[str, QDockWidget], initial_state: QByteArray
) -> None:
    """Restore the initial layout, including closed and floating panels.

    Parameters
    ----------
    initial_state : state of the window when its panels were created
    """
    window.restoreState(initial_state)
    # The state contains the sizes of panels before the window got its own size
    set_initial_sizes(window, docks)


def show_window_and_docks(window: QMainWindow, docks: Mapping[str, QDockWidget]) -> None:
    """Show a window and then its floating panels, so that they are in front of it."""
    floating = [dock for dock in docks.values() if dock.isFloating() and dock.isVisible()]
    for dock in floating:
        dock.hide()
    window.show()
    for dock in floating:
        dock.show()


def hide_floating_docks(docks: Mapping[str, QDockWidget]) -> None:
    """Hide the floating panels, which do not close with their window."""
    for dock in docks.values():
        if dock.isFloating():
            dock.hide()


def _create_dock(window: QMainWindow, title: str, panel: QWidget) -> QDockWidget:
    dock = QDockWidget(gettext(title), window)
    dock.setObjectName(f"dock_{title.lower().replace(' ', '_')}")
    dock.setWidget(panel)
    return dock
