"""Tests of the start page and of the tour, by mouse and keys."""

import os
from datetime import datetime
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtWidgets import QCommandLinkButton

from lispac.gui.app.language import set_language
from lispac.gui.app.unavailable import Unavailable
from lispac.gui.features.help.tour import EXPORTED_TEXT, SAME_ORIENTATION_TEXT, TOUR_STEPS
from lispac.gui.features.open_project.start_page import StartPage
from lispac.gui.window.main_window import MAX_TITLE_BAR_HEIGHT_PX, MainWindow
from lispac.io.project.project_file import PROJECT_FILE_NAME, read_project
from tests.gui.support import WAIT_MS, Driver, click, press, seed
from tests.support.long_runs import LONG, others_long

SAVED_AT = datetime(2026, 3, 7, 9, 5).timestamp()


def links(window: MainWindow, name: str) -> list[QCommandLinkButton]:
    return window.central_widget.start.findChildren(QCommandLinkButton, name)


def test_recent_projects_are_opened_with_a_click(
    driver: Driver, demo_copy: Path, tmp_path: Path
) -> None:
    window = driver.window
    window.settings.add_recent(tmp_path / "gone")
    window.settings.add_recent(demo_copy)
    window.panel_refresh.refresh()
    driver.bot.waitUntil(lambda: len(links(window, "start_recent")) == 2, timeout=WAIT_MS)
    known, missing = links(window, "start_recent")
    assert (known.text(), known.isEnabled()) == (demo_copy.name, True)
    assert (missing.text(), missing.isEnabled()) == ("gone", False)
    assert "Not found" in missing.description()
    driver.bot.mouseClick(known, Qt.MouseButton.LeftButton)
    driver.bot.waitUntil(lambda: window.document.project is not None, timeout=WAIT_MS)
    driver.rest()
    assert driver.project.folder == demo_copy
    assert not window.central_widget.start.isVisible()
    assert window.viewport.widget.isVisible()


def test_the_date_of_a_recent_project_is_in_the_language_of_the_window(
    driver: Driver, demo_copy: Path
) -> None:
    window = driver.window
    window.settings.add_recent(demo_copy)
    os.utime(demo_copy / PROJECT_FILE_NAME, (SAVED_AT, SAVED_AT))
    for code, text in (("en", "Saved 2026-03-07 09:05 in"), ("fr", "07/03/2026 09:05 dans")):
        set_language(code)
        try:
            window.central_widget.start.show_recent(window.settings.recent())
        finally:
            set_language("en")
        (known, *_) = [
            link for link in links(window, "start_recent") if link.toolTip() == str(demo_copy)
        ][-1:]
        assert text in known.description()


def test_every_link_of_the_start_page_is_an_action(driver: Driver) -> None:
    for name, way in driver.window.central_widget.start.links.items():
        assert driver.window.actions_[name].isEnabled(), name
        assert way.isVisible()
        assert way.description()


@pytest.mark.parametrize(
    ("code", "height"), others_long([("en", 500), ("fr", 500), ("fr", 768), ("en", 1000)])
)
def test_every_link_of_the_start_page_is_visible_on_a_low_screen(
    driver: Driver, code: str, height: int
) -> None:
    driver.window.resize(1366, height - MAX_TITLE_BAR_HEIGHT_PX)
    set_language(code)
    try:
        page = StartPage()
    finally:
        set_language("en")
    driver.bot.addWidget(page)
    page.resize(driver.window.central_widget.start.size())
    page.show()
    for name, way in page.links.items():
        assert (
            page.viewport().rect().contains(QRect(way.mapTo(page.viewport(), QPoint()), way.size()))
        ), name
        assert way.description() or way.toolTip()
    assert bool(page.links["tour"].description()) == (height >= 768)
    page.close()


@pytest.fixture
def at_the_demo(monkeypatch: pytest.MonkeyPatch, demo_copy: Path) -> Path:
    monkeypatch.setattr("lispac.gui.project.controller.demo_folder", lambda: demo_copy)
    return demo_copy


def test_the_tour_leads_to_a_validated_boresight_and_a_report(
    driver: Driver, at_the_demo: Path, tmp_path: Path
) -> None:
    window = driver.window
    driver.bot.mouseClick(window.central_widget.start.links["tour"], Qt.MouseButton.LeftButton)
    driver.bot.waitUntil(lambda: window.tour.is_running, timeout=WAIT_MS)
    driver.rest()
    card = window.central_widget.card
    assert card.isVisible()

    def at(step: int) -> None:
        driver.bot.waitUntil(
            lambda: card.head.text() == f"Tour, step {step} of {len(TOUR_STEPS)}", timeout=WAIT_MS
        )

    at(1)
    assert window.scene.colouring == "intensity"
    assert window.actions_["colour_intensity"].isChecked()
    seed(driver, "T1")
    at(2)
    press(driver, Qt.Key.Key_Return)
    at(3)
    driver.rest()
    seed(driver, "T2")
    press(driver, Qt.Key.Key_Return)
    at(4)
    driver.rest()
    assert window.scene.colouring == "line"
    press(driver, Qt.Key.Key_F9)
    at(5)
    driver.rest()
    press(driver, Qt.Key.Key_F7)
    seed(driver, "V1")
    press(driver, Qt.Key.Key_Return)
    at(6)
    driver.rest()
    press(driver, Qt.Key.Key_F10)
    at(7)
    driver.rest()
    assert driver.project.validation
    off = np.degrees(driver.project.result.boresight) - np.array(driver.project.truth_deg)
    assert (
        np.abs(off / np.degrees(np.sqrt(np.diag(driver.project.result.covariance)[:3]))).max() < 3
    )
    driver.dialogs.path = tmp_path / "report.json"
    press(driver, Qt.Key.Key_E, Qt.KeyboardModifier.ControlModifier)
    driver.bot.waitUntil(lambda: card.text.text() == EXPORTED_TEXT, timeout=WAIT_MS)
    driver.rest()
    driver.bot.mouseClick(card.end, Qt.MouseButton.LeftButton, pos=QPoint(10, 10))
    assert not card.isVisible()


@LONG
def test_the_tour_explains_two_targets_of_one_orientation(
    driver: Driver, at_the_demo: Path
) -> None:
    window, card = driver.window, driver.window.central_widget.card
    click(driver, window.central_widget.start.links["tour"])
    driver.bot.waitUntil(lambda: window.tour.is_running, timeout=WAIT_MS)
    driver.rest()
    seed(driver, "T1")
    press(driver, Qt.Key.Key_Return)
    driver.bot.waitUntil(lambda: card.text.text() == TOUR_STEPS[2].text, timeout=WAIT_MS)
    driver.rest()
    seed(driver, "V1", role="target")
    press(driver, Qt.Key.Key_Return)
    driver.bot.waitUntil(lambda: card.text.text() == SAME_ORIENTATION_TEXT, timeout=WAIT_MS)
    driver.rest()
    press(driver, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    driver.bot.waitUntil(lambda: card.text.text() == TOUR_STEPS[2].text, timeout=WAIT_MS)
    driver.rest()


def test_another_project_ends_the_tour(driver: Driver, at_the_demo: Path) -> None:
    driver.window.tour.start()
    driver.bot.waitUntil(lambda: driver.window.tour.is_running, timeout=WAIT_MS)
    driver.rest()
    driver.window.open_project(at_the_demo)
    driver.bot.waitUntil(lambda: not driver.window.tour.is_running, timeout=WAIT_MS)
    assert not driver.window.central_widget.card.isVisible()
    driver.rest()


@pytest.mark.parametrize("removes", others_long([True, False]))
@pytest.mark.usefixtures("reads_files")
def test_the_tour_asks_before_it_removes_targets(
    driver: Driver, picked_folder: Path, monkeypatch: pytest.MonkeyPatch, removes: bool
) -> None:
    monkeypatch.setattr("lispac.gui.project.controller.demo_folder", lambda: picked_folder)
    driver.dialogs.removes_targets = removes
    names = [each.name for each in read_project(picked_folder).targets]
    click(driver, driver.window.central_widget.start.links["tour"])
    driver.bot.waitUntil(lambda: driver.window.document.project is not None, timeout=WAIT_MS)
    driver.rest()
    assert f"remove {len(names)} targets" in driver.dialogs.requests
    assert driver.window.tour.is_running == removes
    assert [each.name for each in driver.project.targets] == ([] if removes else names)
    if removes:
        press(driver, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
        assert [each.name for each in driver.project.targets] == names


@LONG
@pytest.mark.usefixtures("reads_files")
def test_a_cancelled_tour_does_not_affect_the_next_project(
    driver: Driver, at_the_demo: Path, picked_folder: Path
) -> None:
    window = driver.window
    click(driver, window.central_widget.start.links["tour"])
    click(driver, window.task_bar.cancel)
    driver.rest()
    assert window.document.project is None
    window.open_project(picked_folder)
    driver.bot.waitUntil(lambda: window.document.project is not None, timeout=WAIT_MS)
    driver.rest()
    assert driver.project.targets
    assert not window.isWindowModified()
    assert not window.tour.is_running


def test_the_status_bar_separates_the_tip_of_an_action_from_its_reason(driver: Driver) -> None:
    actions = driver.window.actions_
    assert actions["seed_target"].statusTip() == (
        "The next Ctrl+click in the view picks an adjustment target. No project is open."
    )
    for action in actions.all:
        tip, reason = action.statusTip(), Unavailable.NO_PROJECT.text
        if tip.endswith(reason) and tip != reason:
            assert tip.removesuffix(reason).endswith(". ")
            assert ".." not in tip
