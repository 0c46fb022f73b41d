"""Test the complete workflow by keys alone: no mouse, no direct calls, no focus set by the test."""

from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QDialog, QWidget
from pytestqt.qtbot import QtBot

from lispac.gui.features.pick_targets.seed_coordinates import SeedCoordinatesDialog
from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.workflow.planning.demo import demo_seeds
from lispac.workflow.project.projects import open_project
from tests.gui.by_hand import Hands, name_project
from tests.gui.support import Control, Key, press

MAX_STOPS = 60
"""More than the tab stops of the window."""
Condition = Callable[[], bool]


@pytest.fixture
def hands(qtbot: QtBot, qapp: QApplication, tmp_path: Path) -> Iterator[Hands]:
    """The program with its own dialogues and a recording viewport."""
    made = Hands(qtbot, RecordingViewport, tmp_path)
    yield made
    made.leave()


def press_keys(hands: Hands, *keys: Qt.Key) -> None:
    """Press keys in the widget that has the focus."""
    for key in keys:
        hands.bot.keyClick(QApplication.focusWidget(), key)


def tab_to(hands: Hands, name: str) -> QWidget:
    """Press Tab until a widget has the focus, and check that it is visible."""
    for _ in range(MAX_STOPS):
        focused = QApplication.focusWidget()
        if focused.objectName() == name:
            assert not focused.visibleRegion().isEmpty()
            return focused
        press_keys(hands, Key.Key_Tab)
    raise AssertionError(f"Tab does not lead to {name}")


def open_from_start_page(hands: Hands, folder: Path) -> None:
    name_project(hands, folder)
    tab_to(hands, "start_open")
    press_keys(hands, Key.Key_Return)
    hands.until(lambda: hands.window.document.project is not None)
    hands.until_dialogs_used()
    hands.rest()


def type_seed(hands: Hands, name: str, end: Callable[[QDialog], None]) -> None:
    """Press F3 and type the coordinates of a plane into one field after the other."""

    def act(dialog: SeedCoordinatesDialog) -> bool:
        north, west, up = demo_seeds()[name][1]
        for value in (-west, north, up):
            hands.bot.keyClicks(dialog.focusWidget(), f"{value:.3f}")
            press_keys(hands, Key.Key_Tab)
        end(dialog)
        return True

    hands.answers.expect(SeedCoordinatesDialog, act)
    press(hands, Key.Key_F3)
    hands.until_dialogs_used()
    hands.rest()


def find(hands: Hands, name: str) -> None:
    """Find the plane at a seed, and check that it becomes the candidate."""
    type_seed(hands, name, lambda dialog: hands.bot.keyClick(dialog, Key.Key_Return))
    assert hands.window.controller.candidate is not None


def rename_last(hands: Hands, to: str) -> None:
    """Rename the target of the last row with F2; it stays selected under its new name."""
    tab_to(hands, "targets_table")
    press_keys(hands, Key.Key_End, Key.Key_Home, *[Key.Key_Down] * (len(hands.project.targets) - 1))
    press_keys(hands, Key.Key_F2)
    hands.bot.keyClicks(QApplication.focusWidget(), to)
    press_keys(hands, Key.Key_Return)
    hands.until(lambda: hands.window.targets.current == to)
    hands.rest()
    assert QApplication.focusWidget() is hands.window.targets.table


def test_from_the_start_page_to_the_saved_calibration(hands: Hands, demo_copy: Path) -> None:
    window = hands.window
    hands.until(lambda: QApplication.focusWidget() is not None)
    open_from_start_page(hands, demo_copy)
    for name in ("T1", "T2", "V1"):
        press(hands, Key.Key_F6 if demo_seeds()[name][0] == "target" else Key.Key_F7)
        find(hands, name)
        press(hands, Key.Key_Return)
    assert [(each.name, each.role) for each in hands.project.targets] == [
        ("T1", "target"), ("T2", "target"), ("V1", "validation")
    ]  # fmt: skip
    press(hands, Key.Key_Z, Control)
    assert len(hands.project.targets) == 2
    press(hands, Key.Key_Y, Control)
    rename_last(hands, "Quay")

    tab_to(hands, "step_adjust")
    press_keys(hands, Key.Key_Return)
    assert tab_to(hands, "cross_check").isChecked()
    press_keys(hands, Key.Key_Space)
    tab_to(hands, "estimate")
    press_keys(hands, Key.Key_Return)
    hands.until(lambda: hands.project.result is not None)
    hands.rest()
    press(hands, Key.Key_F10)
    hands.until(lambda: bool(hands.project.validation))
    hands.rest()
    press(hands, Key.Key_S, Control)

    kept = open_project(demo_copy)
    assert [each.name for each in kept.targets] == ["T1", "T2", "Quay"]
    assert (np.abs(np.degrees(kept.result.boresight) - kept.truth_deg) < 0.1).all()
    assert {each.name for each in kept.validation} == {"Quay"}
    assert not window.isWindowModified()


def test_enter_presses_the_focused_button(hands: Hands, demo_copy: Path) -> None:
    """On "Cancel" and "Reject", Enter does not accept."""
    hands.until(lambda: QApplication.focusWidget() is not None)
    open_from_start_page(hands, demo_copy)

    def cancel(dialog: QDialog) -> None:
        for _ in range(4):
            if QApplication.focusWidget().objectName() == "seed_cancel":
                break
            press_keys(hands, Key.Key_Tab)
        assert QApplication.focusWidget().objectName() == "seed_cancel"
        press_keys(hands, Key.Key_Return)

    type_seed(hands, "T1", cancel)
    assert hands.window.controller.candidate is None
    find(hands, "T1")
    tab_to(hands, "reject_candidate")
    press_keys(hands, Key.Key_Return)
    assert hands.window.controller.candidate is None
    assert hands.project.targets == ()


def test_each_step_has_a_shortcut(hands: Hands) -> None:
    """Also if the panel of the step is behind another panel or closed."""
    window = hands.window
    hands.until(lambda: QApplication.focusWidget() is not None)
    window.docks["Workflow"].close()
    steps = Key.Key_5, Key.Key_1, Key.Key_3, Key.Key_2, Key.Key_4
    for key, name in zip(steps, ("report", "data", "adjust", "targets", "validate"), strict=True):
        press(hands, key, Control)
        focused = QApplication.focusWidget()
        assert focused.objectName() == f"step_{name}"
        assert not focused.visibleRegion().isEmpty()
        assert window.workflow.headers[window.workflow.opened] is focused
