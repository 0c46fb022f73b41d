"""Tests that the window stays usable, with its settings, if a new one cannot replace it."""

import threading
from pathlib import Path

import pytest
from PySide6.QtCore import QLockFile, QTimer
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from lispac.gui.appearance import theme
from lispac.gui.appearance.colour_schemes import DARK_SCHEME, LIGHT_SCHEME
from lispac.gui.features.design.controller import SiteDesign
from lispac.gui.features.pick_targets.proposals import ProposedTargets
from lispac.gui.project.recovery_copies import LOCK_FILE_NAME
from lispac.gui.window.main_window import MainWindow
from lispac.gui.window.panel_refresh import PanelRefresh
from lispac.gui.window.session import Session
from lispac.io.project.project_file import UNSAVED_NAME
from lispac.language import current_language
from tests.gui.by_hand import choose, open_menu
from tests.gui.support import Control, Key
from tests.support.long_runs import others_long

SOON_MS = 20_000

STEPS = {
    "first part": (MainWindow, "_build"),
    "last part": (MainWindow, "_connect_features"),
    "slot": (PanelRefresh, "refresh"),
    "restored": (ProposedTargets, "copy_state_from"),
    "shown": (SiteDesign, "copy_state_from"),
}
"""Steps of the construction of a window that replaces another, by their place in it."""


class BrokenStepError(Exception):
    """Error of a step that fails in a test."""


def fail(*_: object) -> None:
    raise BrokenStepError


def writers() -> int:
    """Number of threads that write recovery copies."""
    return sum(each.name.startswith("lispac-keeping") for each in threading.enumerate())


def windows() -> list[MainWindow]:
    return [each for each in QApplication.topLevelWidgets() if isinstance(each, MainWindow)]


@pytest.mark.parametrize("step", others_long(STEPS, lambda step: step == "shown"))
def test_a_window_that_cannot_be_replaced_stays_usable(
    session: Session,
    qtbot: QtBot,
    qapp: QApplication,
    picked_folder: Path,
    monkeypatch: pytest.MonkeyPatch,
    step: str,
) -> None:
    window, dialogs = session.window, session._dialogs
    lock = picked_folder / LOCK_FILE_NAME
    open_project(window, qtbot, picked_folder)

    for menu, entry in (("heme", "Dark"), ("Lang", "Français")):
        wait_until_idle(window, qtbot)
        with monkeypatch.context() as broken:
            broken.setattr(*STEPS[step], fail)
            choose(qtbot, open_menu(qtbot, window, "View"), menu, entry)
            qtbot.waitUntil(lambda: bool(dialogs.errors), timeout=SOON_MS)
        assert [type(each) for each in dialogs.errors] == [BrokenStepError]
        dialogs.errors.clear()
        assert session.window is window
        assert windows() == [window]
        assert window.isVisible()
        assert dialogs.parent is window
        assert writers() <= 1
        assert theme.current_scheme() is LIGHT_SCHEME
        assert qapp.styleSheet() == theme.style_sheet(LIGHT_SCHEME)
        assert current_language() == "en"
        assert (window.settings.theme, window.settings.language) == ("light", "en")
        for name in ("theme_light", "english"):
            assert window.actions_[name].isChecked()
    assert lock.is_file()

    unsaved = picked_folder / UNSAVED_NAME
    window.controller.rename("T1", "Quay")
    qtbot.waitUntil(unsaved.is_file, timeout=SOON_MS)
    wait_until_idle(window, qtbot)
    qtbot.keyClick(window, Key.Key_Z, Control)
    qtbot.waitUntil(lambda: "T1" in window.targets.names, timeout=SOON_MS)
    qtbot.waitUntil(lambda: not unsaved.is_file(), timeout=SOON_MS)

    wait_until_idle(window, qtbot)
    choose(qtbot, open_menu(qtbot, window, "View"), "heme", "Dark")
    qtbot.waitUntil(lambda: session.window is not window, timeout=SOON_MS)
    window = session.window
    wait_until_idle(window, qtbot)
    assert theme.current_scheme() is DARK_SCHEME
    assert windows() == [window]
    assert lock.is_file()
    window.actions_["close_project"].trigger()
    assert not lock.exists()
    open_project(window, qtbot, picked_folder)
    assert lock.is_file()
    assert dialogs.safety == []
    limit = QTimer(singleShot=True, interval=SOON_MS)
    limit.timeout.connect(lambda: qapp.exit(1))
    limit.start()
    QTimer.singleShot(0, window.actions_["quit"].trigger)
    assert qapp.exec() == 0
    limit.stop()
    assert not lock.exists()
    assert not [each for each in QApplication.topLevelWidgets() if each.isVisible()]
    assert writers() == 0
    assert dialogs.errors == []


def open_project(window: MainWindow, bot: QtBot, folder: Path) -> None:
    """Open a project and wait until its lines are drawn."""
    window.open_project(folder)
    bot.waitUntil(lambda: window.document.survey is not None, timeout=SOON_MS)
    wait_until_idle(window, bot)


def wait_until_idle(window: MainWindow, bot: QtBot) -> None:
    """Wait until the active window has drawn all and computes nothing."""
    bot.waitUntil(
        lambda: (
            window.isActiveWindow()
            and QApplication.activePopupWidget() is None
            and window.scene.is_drawn
            and not window.runner.active
        ),
        timeout=SOON_MS,
    )
    bot.wait(100)


def test_the_colours_of_the_system_are_restored_after_an_error(
    session: Session, qtbot: QtBot, qapp: QApplication, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The system has become dark, and the window that stays is light."""
    window = session.window
    window.settings.theme = "system"
    session.rebuild_window()
    assert theme.current_scheme() is LIGHT_SCHEME
    window = session.window
    with monkeypatch.context() as dark:
        dark.setattr(theme, "is_system_dark", lambda _application: True)
        dark.setattr(MainWindow, "_connect_features", fail)
        session._follow_system_theme()
        qtbot.waitUntil(lambda: bool(session._dialogs.errors), timeout=SOON_MS)
        assert session.window is window
        assert window.settings.theme == "system"
        assert theme.current_scheme() is LIGHT_SCHEME


def test_a_project_that_was_opened_twice_is_not_asked_about_again(
    session: Session, qtbot: QtBot, picked_folder: Path
) -> None:
    """The lock of another program is asked about once, not in each new window."""
    lock = QLockFile(str(picked_folder / LOCK_FILE_NAME))
    assert lock.tryLock(0)
    open_project(session.window, qtbot, picked_folder)
    dialogs = session._dialogs
    assert len(dialogs.safety) == 1
    problem = session.window.recovery_copies.problem
    assert problem is not None
    former = session.window
    choose(qtbot, open_menu(qtbot, former, "View"), "heme", "Dark")
    qtbot.waitUntil(lambda: session.window is not former, timeout=SOON_MS)
    assert len(dialogs.safety) == 1
    assert session.window.recovery_copies.problem == problem
    assert (picked_folder / LOCK_FILE_NAME).is_file()
    lock.unlock()
