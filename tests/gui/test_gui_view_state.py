"""Test that the state of the view is restored in a window with another theme."""

from collections.abc import Mapping

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from lispac.gui.window.session import Session
from lispac.project import Project
from tests.gui.by_hand import choose, open_menu
from tests.gui.support import Demo, Key

SOON_MS = 20_000


def choose_theme(session: Session, bot: QtBot, theme: str) -> None:
    """Choose a theme in the menu, and wait for the new window."""
    former = session.window
    choose(bot, open_menu(bot, former, "View"), "heme", theme)
    bot.waitUntil(lambda: session.window is not former, timeout=SOON_MS)
    bot.waitUntil(session.window.isActiveWindow, timeout=SOON_MS)


def test_the_same_lines_are_shown_in_another_theme(
    session: Session,
    qtbot: QtBot,
    demo: Demo,
    estimated: Project,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Lines after, or before and after in one picture; no line is georeferenced again."""
    session.window.document.open(estimated, demo.survey)
    wait_until_idle(session, qtbot)
    assert session.window.actions_["after"].isChecked()  # a project with a result
    qtbot.keyClick(session.window, Key.Key_B)
    wait_until_idle(session, qtbot)
    before = dict(session.window.viewport.clouds)
    for key in (Key.Key_B, Key.Key_C):
        qtbot.keyClick(session.window, key)
    wait_until_idle(session, qtbot)
    after, shading = session.window.viewport.clouds, session.window.viewport.shading
    assert not same(after, before)
    assert shading is not None
    monkeypatch.setattr(type(demo.survey), "displayed_clouds", None)
    for theme in ("Dark", "Light"):
        choose_theme(session, qtbot, theme)
        window = session.window
        wait_until_idle(session, qtbot)
        assert same(window.viewport.clouds, after)
        assert window.viewport.shading.title == shading.title
        wiped = theme == "Light"
        assert window.actions_["colour_height"].isChecked()
        assert window.actions_["after"].isChecked() == (not wiped)
        assert window.validate.after.isChecked() == (not wiped)
        assert (
            (window.viewport.wipe_clouds is not None)
            == window.actions_["wipe"].isChecked()
            == wiped
        )
        if not wiped:
            qtbot.keyClick(window, Key.Key_W)
    assert same(window.viewport.wipe_clouds, before)
    qtbot.keyClick(window, Key.Key_B)
    wait_until_idle(session, qtbot)
    assert same(window.viewport.clouds, before)
    assert not window.actions_["wipe"].isChecked()
    choose_theme(session, qtbot, "Dark")
    wait_until_idle(session, qtbot)
    assert same(session.window.viewport.clouds, before)
    assert session.window.actions_["before"].isChecked()


def wait_until_idle(session: Session, bot: QtBot) -> None:
    """Wait until no task is active and the lines are drawn."""
    bot.waitUntil(
        lambda: not session.window.runner.active and session.window.scene.is_drawn, timeout=SOON_MS
    )
    bot.wait(100)


def same(one: Mapping[str, np.ndarray], other: Mapping[str, np.ndarray]) -> bool:
    return one.keys() == other.keys() and all(np.array_equal(one[k], other[k]) for k in one)
