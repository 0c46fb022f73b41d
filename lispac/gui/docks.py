"""The panels around the view: where each is at first, and which lie behind one another."""

from collections.abc import Mapping

from PySide6.QtCore import QByteArray, Qt, QTimer
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QDockWidget, QMainWindow, QTabWidget, QWidget

from lispac.gui.tab_order import go_into
from lispac.language import N_, gettext

Area = Qt.DockWidgetArea
Docks = dict[str, QDockWidget]

WORKFLOW, RESULTS, SIGHTINGS = N_("Workflow"), N_("Results"), N_("Targets by line")
HISTOGRAMS, LOG = N_("Histograms"), N_("Log")
"""Titles of docks in English: keys of `Docks`, from which the names in a saved layout are made."""


def laid_out(window: QMainWindow, panels: Mapping[str, tuple[QWidget, Area]]) -> Docks:
    """Docks of the panels by their titles; those of one side are tabs, the first in front."""
    # Otherwise Qt leaves the first tab bars behind.
    window.layout().setEnabled(False)
    docks: Docks = {}
    last: dict[Area, QDockWidget] = {}
    first: dict[Area, QDockWidget] = {}
    for title, (panel, area) in panels.items():
        docks[title] = dock = _dock(window, title, panel)
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


def switches(docks: Mapping[str, QDockWidget]) -> list[QAction]:
    """An action for each panel: it comes into sight, or is closed where it is in sight.

    Those of Qt would close one that lies behind another, which is not what was asked for.
    """
    return [_switch(dock) for dock in docks.values()]


def _switch(dock: QDockWidget) -> QAction:
    made = QAction(dock.windowTitle(), dock)
    made.setCheckable(True)
    dock.visibilityChanged.connect(made.setChecked)  # false for one behind another, too
    made.triggered.connect(lambda wanted: bring(dock) if wanted else dock.close())
    return made


def bring(dock: QDockWidget) -> None:
    """Have a panel in front, with the focus."""
    raise_panel(dock.widget())
    # It has its place when Qt has laid the tabs out
    QTimer.singleShot(0, dock, lambda: go_into(dock))


def raise_panel(panel: QWidget) -> None:
    """Show the dock of a panel in front of its neighbours, wherever the focus is."""
    dock = panel.parentWidget()
    assert isinstance(dock, QDockWidget)
    dock.show()
    dock.raise_()


def share_out(window: QMainWindow, docks: Mapping[str, QDockWidget]) -> None:
    """Restore the original sizes of the panels."""
    sides = [docks[WORKFLOW], docks[RESULTS]]
    window.resizeDocks(sides, [350, 400], Qt.Orientation.Horizontal)
    below = [docks[SIGHTINGS]]
    window.resizeDocks(below, [3 * window.height() // 10], Qt.Orientation.Vertical)


def arrange(window: QMainWindow, docks: Mapping[str, QDockWidget], at_first: QByteArray) -> None:
    """Put every panel back where a first start has it, also those that float or were closed.

    Parameters
    ----------
    at_first : state of the window when the panels were laid out
    """
    window.restoreState(at_first)
    share_out(window, docks)  # the state is older than the size of the window


def show_all(window: QMainWindow, docks: Mapping[str, QDockWidget]) -> None:
    """Show a window, then the panels that float: those that are there before lie behind it."""
    floating = [dock for dock in docks.values() if dock.isFloating() and dock.isVisible()]
    for dock in floating:
        dock.hide()
    window.show()
    for dock in floating:
        dock.show()


def hide_floating(docks: Mapping[str, QDockWidget]) -> None:
    """Hide the panels that float: they do not go with their window."""
    for dock in docks.values():
        if dock.isFloating():
            dock.hide()


def _dock(window: QMainWindow, title: str, panel: QWidget) -> QDockWidget:
    dock = QDockWidget(gettext(title), window)
    dock.setObjectName(f"dock_{title.lower().replace(' ', '_')}")
    dock.setWidget(panel)
    return dock
