"""Tests of restoring the default arrangement of moved, closed and floating panels."""

from pathlib import Path

from PySide6.QtCore import QRect, Qt
from PySide6.QtWidgets import QAbstractButton, QApplication, QToolBar
from pytestqt.qtbot import QtBot

from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.gui.window.main_window import MainWindow
from tests.gui.by_hand import choose, open_menu
from tests.gui.support import Driver, click

SOON_MS = 10_000
Arrangement = dict[str, tuple[QRect | None, bool, set[str]]]


def arrangement(window: MainWindow) -> Arrangement:
    """Return geometry, floating state and tab group of each panel.

    The geometry of a panel behind another is undefined, so it is None.
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
    """Close one panel, float, move and raise others, and hide the toolbar."""
    window = driver.window
    for title, button in (("Results", "close"), ("Workflow", "float")):
        dock = window.docks[title]
        click(driver, dock.findChild(QAbstractButton, f"qt_dockwidget_{button}button"))
    window.addDockWidget(Qt.DockWidgetArea.TopDockWidgetArea, window.docks["Log"])
    window.docks["Histograms"].raise_()
    window.findChild(QToolBar).hide()


def arrange(driver: Driver) -> None:
    choose(driver.bot, open_menu(driver.bot, driver.window, "View"), "Panels", "Restore default")


def test_all_panels_return_to_their_default_places(driver: Driver) -> None:
    window = driver.window
    before = arrangement(window)
    assert is_in_front(window, "Results")
    disturb(driver)
    driver.bot.waitUntil(lambda: is_in_front(window, "Histograms"), timeout=SOON_MS)
    assert window.docks["Workflow"].isFloating()
    arrange(driver)
    driver.bot.waitUntil(lambda: arrangement(window) == before, timeout=SOON_MS)
    assert window.findChild(QToolBar).isVisible()


def test_panels_of_a_restored_layout_return_to_their_default_places(
    driver: Driver, qtbot: QtBot, qapp: QApplication, tmp_path: Path
) -> None:
    before = arrangement(driver.window)
    disturb(driver)
    driver.window.close()
    later = Driver(qtbot, RecordingViewport(), tmp_path)
    try:
        assert later.window.docks["Workflow"].isFloating()
        assert not later.window.docks["Results"].isVisible()
        later.window.resize(driver.window.size())
        arrange(later)
        qtbot.waitUntil(lambda: arrangement(later.window) == before, timeout=SOON_MS)
    finally:
        later.leave()


def test_the_menu_shows_a_hidden_panel_and_closes_a_visible_one(driver: Driver) -> None:
    """By keys; a panel behind another is raised and gets the focus."""
    window, bot = driver.window, driver.bot

    def pick(title: str) -> None:
        menu = open_menu(bot, window, "View")
        panels = next(a.menu() for a in menu.actions() if "Panels" in a.text().replace("&", ""))
        menu.setActiveAction(panels.menuAction())
        bot.keyClick(menu, Qt.Key.Key_Right)
        bot.waitUntil(panels.isVisible, timeout=SOON_MS)
        titles = [action.text() for action in panels.actions()]
        ticked = [action.text() for action in panels.actions() if action.isChecked()]
        assert ticked == [each for each in window.docks if is_in_front(window, each)]
        for _ in range(titles.index(title) - titles.index(panels.activeAction().text())):
            bot.keyClick(panels, Qt.Key.Key_Down)
        bot.keyClick(panels, Qt.Key.Key_Return)

    assert not is_in_front(window, "Warnings")
    pick("Warnings")
    bot.waitUntil(lambda: is_in_front(window, "Warnings"), timeout=SOON_MS)
    pick("Patch test")
    dock = window.docks["Patch test"]
    bot.waitUntil(lambda: dock.isAncestorOf(QApplication.focusWidget()), timeout=SOON_MS)
    assert is_in_front(window, "Patch test")
    assert window.docks["Warnings"].isVisible()
    pick("Patch test")
    bot.waitUntil(lambda: not dock.isVisible(), timeout=SOON_MS)
    pick("Patch test")
    bot.waitUntil(lambda: is_in_front(window, "Patch test"), timeout=SOON_MS)
