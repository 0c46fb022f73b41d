"""Test of a project saved in one language of the window and opened in another."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from lispac.gui.app.language import set_language
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.messages import Message
from lispac.workflow.project.projects import save_project
from tests.gui.french_support import english, pieces, texts
from tests.gui.support import (
    WAIT_MS,
    Demo,
    Driver,
    Key,
    click,
    open_step,
    press,
    show_panel,
    wait_until_idle,
)  # fmt: skip
from tests.support.french_catalogue import FRENCH

LEVER_ARM_ERROR = 0.1
"""Error of the lever arm, m, which leads to many warnings about the estimate."""
VALIDATE_STEP = 3
"""Index of the step of the workflow."""


@contextmanager
def window(code: str, qtbot: QtBot, folder: Path) -> Iterator[Driver]:
    """A window in a language, set as at the start of the program."""
    theme.apply_theme(QApplication.instance())
    set_language(code)
    try:
        made = Driver(qtbot, RecordingViewport(), folder)
        yield made
        made.leave()
    finally:
        set_language("en")


def open_project(driver: Driver, folder: Path) -> None:
    driver.dialogs.path = folder
    press(driver, Key.Key_O, Qt.KeyboardModifier.ControlModifier)
    wait_until_idle(driver)
    assert driver.dialogs.errors == []


def listed(driver: Driver) -> dict[str, Message]:
    """Messages of the warnings panel by their shown texts."""
    driver.bot.waitUntil(lambda: driver.window.warning_list.is_current, timeout=WAIT_MS)
    panel = driver.window.warnings
    driver.bot.waitUntil(lambda: panel.is_filled, timeout=WAIT_MS)
    shown = [panel.list.item(row).text() for row in range(panel.list.count())]
    assert shown == [message_text(each) for each in panel.messages]
    return dict(zip(shown, panel.messages, strict=True))


def french(driver: Driver) -> set[str]:
    """Texts of a window that are in the French catalogue."""
    only = {each for each in set(FRENCH.values()) - set(FRENCH) if any(map(str.isalpha, each))}
    return {text for text in texts(driver.window) if any(each in only for each in pieces(text))}


@pytest.mark.parametrize(
    ("first", "second"), [("en", "fr"), pytest.param("fr", "en", marks=pytest.mark.long)]
)
def test_all_warnings_are_in_the_language_of_the_window(
    first: str, second: str, qtbot: QtBot, tmp_path: Path, demo: Demo, demo_copy: Path
) -> None:
    north, *others = demo.picked.settings.lever_arm
    settings = replace(demo.picked.settings, lever_arm=(north + LEVER_ARM_ERROR, *others))
    save_project(replace(demo.picked, folder=demo_copy, settings=settings))
    with window(first, qtbot, tmp_path / "first") as driver:
        open_project(driver, demo_copy)
        press(driver, Key.Key_F9)
        wait_until_idle(driver)
        open_step(driver, VALIDATE_STEP)
        click(driver, driver.window.validate.run)
        wait_until_idle(driver)
        press(driver, Key.Key_S, Qt.KeyboardModifier.ControlModifier)
        wait_until_idle(driver)
        assert not driver.window.isWindowModified()
        before = listed(driver)
    with window(second, qtbot, tmp_path / "second") as driver:
        open_project(driver, demo_copy)
        after = listed(driver)
        assert [each.code for each in after.values()] == [each.code for each in before.values()]
        assert len(after) >= 5
        assert not set(before) & set(after)
        for step in range(5):
            open_step(driver, step)
        for title in (*driver.window.docks, *driver.window.panel_windows):
            show_panel(driver.window, title)
            driver.rest()
        assert (english(driver.window) if second == "fr" else french(driver)) == set()
