"""Tests of the panels: restore the default arrangement, show and close panels by the menu."""

from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtWidgets import QAbstractButton, QApplication, QToolBar
from pytestqt.qtbot import QtBot

from lispac.gui.project.features import WindowPlace
from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.gui.window.features import panel_records
from lispac.gui.window.main_window import MainWindow
from lispac.project import Project
from tests.gui.by_hand import choose, open_menu
from tests.gui.support import Demo, Driver, click, show_panel

SOON_MS = 10_000
Area = Qt.DockWidgetArea
Arrangement = dict[str, tuple[QRect | None, bool, set[str]]]


def arrangement(window: MainWindow) -> Arrangement:
    """Geometry, floating state and tab partners of each panel.

    The geometry is None for a panel behind another, because its size is not updated there.
    """
    return {
        title: (
            dock.geometry() if is_in_front(window, title) else None,
            dock.isFloating(),
            {each.objectName() for each in window.tabifiedDockWidgets(dock)},
        )
        for title, dock in window.docks.items()
    }


def is_in_front(window: MainWindow, title: str) -> bool:
    return not window.docks[title].visibleRegion().isEmpty()


def disturb(driver: Driver) -> None:
    """Close a panel, float a second, move a third, raise a fourth, and hide the toolbar."""
    window = driver.window
    show_panel(window, "Log")
    for title, button in (("Log", "close"), ("Workflow", "float")):
        dock = window.docks[title]
        click(driver, dock.findChild(QAbstractButton, f"qt_dockwidget_{button}button"))
    drag_to_right(driver, "Results")
    window.docks["Histograms"].raise_()
    window.findChild(QToolBar).hide()


def drag_to_right(driver: Driver, title: str) -> None:
    """Drag the title bar of a panel to the right edge of the window."""
    window, bot, dock = driver.window, driver.bot, driver.window.docks[title]
    start = QPoint(60, 12)
    bot.mousePress(dock, Qt.MouseButton.LeftButton, pos=start)
    bot.mouseMove(dock, start + QPoint(30, 30))
    edge = window.mapToGlobal(QPoint(window.width() - 6, window.height() // 2))
    for k in range(20, -1, -1):
        bot.mouseMove(dock, dock.mapFromGlobal(edge - QPoint(5 * k, 0)))
    bot.wait(300)
    bot.mouseRelease(dock, Qt.MouseButton.LeftButton, pos=dock.mapFromGlobal(edge))
    bot.waitUntil(lambda: not dock.isFloating(), timeout=SOON_MS)
    assert window.dockWidgetArea(dock) == Area.RightDockWidgetArea


def arrange(driver: Driver) -> None:
    choose(driver.bot, open_menu(driver.bot, driver.window, "View"), "Panels", "Restore default")


@pytest.fixture
def calibrated(driver: Driver, demo: Demo, validated: Project) -> Driver:
    """The validated demo survey."""
    driver.window.document.open(validated, demo.survey)
    driver.rest()
    return driver


def test_all_panels_return_to_the_default_arrangement(calibrated: Driver) -> None:
    driver, window = calibrated, calibrated.window
    before = arrangement(window)
    assert is_in_front(window, "Results")
    disturb(driver)
    driver.bot.waitUntil(lambda: is_in_front(window, "Histograms"), timeout=SOON_MS)
    assert window.docks["Workflow"].isFloating()
    arrange(driver)
    driver.bot.waitUntil(lambda: arrangement(window) == before, timeout=SOON_MS)
    assert window.findChild(QToolBar).isVisible()


def test_panels_moved_in_an_earlier_window_return_to_the_default_arrangement(
    calibrated: Driver, qtbot: QtBot, tmp_path: Path, demo: Demo, validated: Project
) -> None:
    window = calibrated.window
    before = arrangement(window)
    disturb(calibrated)
    window.docks["Targets by line"].close()
    window.close()
    later = Driver(qtbot, RecordingViewport(), tmp_path)
    try:
        later.window.document.open(validated, demo.survey)
        later.rest()
        docks = later.window.docks
        assert docks["Workflow"].isFloating()
        assert later.window.dockWidgetArea(docks["Results"]) == Area.RightDockWidgetArea
        assert is_in_front(later.window, "Results")
        assert not docks["Targets by line"].isVisible(), "closed by the user"
        later.window.resize(window.size())
        arrange(later)
        qtbot.waitUntil(lambda: arrangement(later.window) == before, timeout=SOON_MS)
    finally:
        later.leave()


def test_the_menu_shows_a_hidden_panel_and_closes_a_visible_one(calibrated: Driver) -> None:
    """A panel behind another is raised and gets the focus; a visible one is closed."""
    window, bot = calibrated.window, calibrated.bot

    def pick(title: str) -> None:
        menu = open_menu(bot, window, "View")
        panels = next(a.menu() for a in menu.actions() if "Panels" in a.text().replace("&", ""))
        menu.setActiveAction(panels.menuAction())
        bot.keyClick(menu, Qt.Key.Key_Right)
        bot.waitUntil(panels.isVisible, timeout=SOON_MS)
        titles = [action.text() for action in panels.actions()]
        ticked = [action.text() for action in panels.actions() if action.isChecked()]
        assert ticked == [each for each, dock in window.docks.items() if not dock.isHidden()]
        for _ in range(titles.index(title) - titles.index(panels.activeAction().text())):
            bot.keyClick(panels, Qt.Key.Key_Down)
        bot.keyClick(panels, Qt.Key.Key_Return)

    assert not is_in_front(window, "Messages")
    pick("Messages")
    bot.waitUntil(lambda: is_in_front(window, "Messages"), timeout=SOON_MS)
    pick("Section")
    dock = window.docks["Section"]
    bot.waitUntil(lambda: dock.isAncestorOf(QApplication.focusWidget()), timeout=SOON_MS)
    assert is_in_front(window, "Section")
    assert window.docks["Messages"].isVisible()
    pick("Section")
    bot.waitUntil(lambda: not dock.isVisible(), timeout=SOON_MS)
    pick("Section")
    bot.waitUntil(lambda: is_in_front(window, "Section"), timeout=SOON_MS)


def test_a_registered_panel_has_its_place_its_controller_and_an_action(opened: Driver) -> None:
    window = opened.window
    assert panel_records()
    for record in panel_records():
        title = record.place.title
        container = {**window.docks, **window.panel_windows}[title]
        assert container.isAncestorOf(window.panels[record.name])
        assert (record.name in window.panel_controllers) == (record.connect is not None)
        if isinstance(record.place, WindowPlace):
            assert not container.isVisible()
            window.actions_[record.place.action].trigger()
            assert container.isVisible()
            assert container.sizeHint() == record.place.size


def test_a_panel_behind_another_is_ticked_in_the_menu(adjusted: Driver) -> None:
    docks = adjusted.window.docks
    panel_actions = {
        action.text(): action
        for action in next(
            a.menu()
            for a in next(
                menu for menu in adjusted.window.menuBar().actions()
                if menu.text().replace("&", "") == "View"
            ).menu().actions()
            if "Panels" in a.text().replace("&", "")
        ).actions()
    }  # fmt: skip
    for title in ("Targets by line", "Results"):
        show_panel(adjusted.window, title)
        adjusted.rest()
    behind = docks["Targets by line"]
    assert behind.visibleRegion().isEmpty()
    for title in ("Targets by line", "Results", "Workflow"):
        assert panel_actions[title].isChecked(), title
    panel_actions["Targets by line"].trigger()  # to the front, and still open
    adjusted.rest()
    assert not behind.visibleRegion().isEmpty()
    assert panel_actions["Targets by line"].isChecked()
    panel_actions["Targets by line"].trigger()
    adjusted.rest()
    assert behind.isHidden()
    assert not panel_actions["Targets by line"].isChecked()
    docks["Results"].hide()
    assert not panel_actions["Results"].isChecked()
