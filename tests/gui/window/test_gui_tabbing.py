"""Tests of Tab and Shift+Tab through the window: each tab stop is visible."""

from itertools import pairwise
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QListWidget, QScrollArea, QWidget

from lispac.gui.appearance import theme
from tests.gui.support import WAIT_MS, Driver, Key, open_step, show_panel

MAX_STOPS = 200
"""More than the tab stops of the window."""
SMALL_WINDOW = 1366, 740


def round_trip(driver: Driver, key: Qt.Key) -> list[QWidget]:
    """Press a key until the focus returns to its start; return the widgets it passes."""
    stops: list[QWidget] = []
    for _ in range(MAX_STOPS):
        driver.bot.keyClick(QApplication.focusWidget(), key)
        focused = QApplication.focusWidget()
        if focused in stops:
            assert focused is stops[0]
            return stops
        assert is_visible(focused), focused
        stops.append(focused)
    raise AssertionError(names(stops))


def is_visible(widget: QWidget) -> bool:
    """Whether a part of a widget is visible; the content of a scroll area covers the area."""
    inner = widget.viewport() if hasattr(widget, "viewport") else widget
    return not inner.visibleRegion().isEmpty()


def names(stops: list[QWidget]) -> list[str]:
    return [each.objectName() for each in stops]


def raise_dock(driver: Driver, title: str) -> None:
    """Raise a dock above those it is tabbed with."""
    dock = driver.window.docks[title]
    show_panel(driver.window, title)
    driver.bot.waitUntil(lambda: not dock.visibleRegion().isEmpty(), timeout=WAIT_MS)


def test_tab_visits_the_visible_widgets_without_a_project(driver: Driver) -> None:
    driver.bot.waitUntil(lambda: QApplication.focusWidget() is not None, timeout=WAIT_MS)
    assert QApplication.focusWidget().objectName() == "start_tour"
    stops = round_trip(driver, Key.Key_Tab)
    assert {"start_design", "step_data", "step_report"} <= set(names(stops))
    assert not any(isinstance(each, QScrollArea) for each in stops)
    after = dict(pairwise(names(stops)))
    assert after["step_data"] == "step_targets"
    assert round_trip(driver, Key.Key_Backtab) == stops[::-1]


def test_recent_projects_follow_the_links_of_the_start_page(
    driver: Driver, demo_copy: Path
) -> None:
    window = driver.window
    for folder in (demo_copy, demo_copy.parent / "gone"):
        window.settings.add_recent(folder)
    page = window.central_widget.start
    page.show_recent(window.settings.recent())
    driver.bot.waitUntil(
        lambda: all(each.isVisible() for each in page.findChildren(QWidget, "start_recent")),
        timeout=WAIT_MS,
    )
    driver.bot.waitUntil(lambda: QApplication.focusWidget() is not None, timeout=WAIT_MS)
    found = names(round_trip(driver, Key.Key_Tab))
    assert found[found.index("start_design") + 1] == "start_recent"
    assert found.count("start_recent") == 1  # removed links are no tab stops


def test_a_frame_shows_that_the_view_has_the_focus(adjusted: Driver) -> None:
    window, view = adjusted.window, adjusted.viewport.widget
    view.setFocusPolicy(Qt.FocusPolicy.StrongFocus)  # a recording viewport has no focus policy
    window.workflow.headers[0].setFocus()
    without = window.central_widget.grab().toImage()
    view.setFocus()
    with_focus = window.central_widget.grab().toImage()
    accent = theme.colour("accent").rgb()
    assert without.pixel(0, without.height() - 1) != accent
    assert with_focus.pixel(0, without.height() - 1) == accent
    window.workflow.headers[0].setFocus()
    assert window.central_widget.grab().toImage() == without


def test_tab_visits_a_dock_only_in_front(driver: Driver) -> None:
    for front in ("Clip box", "Section", "Clip box"):
        raise_dock(driver, front)
        found = "section_laid" in names(round_trip(driver, Key.Key_Tab))
        assert found == (front == "Section")


def test_every_tab_stop_of_a_calibrated_project_is_visible(adjusted: Driver) -> None:
    window = adjusted.window
    window.resize(*SMALL_WINDOW)
    for step, header in enumerate(window.workflow.headers):
        open_step(adjusted, step)
        adjusted.rest()  # the fields of a long step are laid out by the event loop
        header.setFocus()
        stops = round_trip(adjusted, Key.Key_Tab)
        assert set(names(window.workflow.headers)) <= set(names(stops))
        round_trip(adjusted, Key.Key_Backtab)
    for title in window.docks:
        raise_dock(adjusted, title)
        window.workflow.headers[0].setFocus()
        round_trip(adjusted, Key.Key_Tab)
        round_trip(adjusted, Key.Key_Backtab)


def test_a_focused_widget_is_scrolled_into_view(adjusted: Driver) -> None:
    window = adjusted.window
    window.resize(*SMALL_WINDOW)
    open_step(adjusted, 0)
    adjusted.rest()  # the fields are laid out by the event loop
    window.workflow.headers[1].setFocus()
    adjusted.bot.keyClick(window.workflow.headers[1], Key.Key_Backtab)
    focused = QApplication.focusWidget()
    assert window.data.isAncestorOf(focused)
    assert focused.visibleRegion().boundingRect() == focused.rect()


def test_tab_changes_no_selection_in_lists(adjusted: Driver) -> None:
    """By default, a list that gets the focus selects its first row."""
    window = adjusted.window
    behind = [
        each
        for dock in window.docks.values()
        if dock.visibleRegion().isEmpty()
        for each in dock.findChildren(QListWidget)
    ]
    rows = [each.currentRow() for each in behind]
    assert behind
    round_trip(adjusted, Key.Key_Tab)
    assert [each.currentRow() for each in behind] == rows
