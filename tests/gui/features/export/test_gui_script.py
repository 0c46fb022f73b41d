"""Tests of the script of the actions done in the window, and of its run without the window."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QLabel, QPlainTextEdit, QPushButton, QWidget

from lispac.gui.features.export.dialogs import ScriptDialog
from tests.gui.support import Control, Driver, Key, Left, press, seed, use_next_dialog
from tests.support.script_runs import run, same_part

DialogAction = Callable[[QWidget], None]


def shown_script(driver: Driver, use_dialog: DialogAction = lambda dialog: None) -> str:
    """The script that the window shows."""
    found: list[str] = []

    def inspect_dialog(dialog: QWidget) -> None:
        assert isinstance(dialog, ScriptDialog)
        found.append(dialog.findChild(QPlainTextEdit, "script_text").toPlainText())
        use_dialog(dialog)

    use_next_dialog(inspect_dialog)
    action = driver.window.actions_["script"]
    assert action.isEnabled()
    action.trigger()
    driver.rest()
    assert driver.dialogs.errors == []
    (script,) = found
    return script


def values_in_window(driver: Driver, path: Path) -> dict:
    """Comparable values of the JSON report that the window writes."""
    driver.dialogs.path = path
    press(driver, Key.Key_E, Control)
    driver.rest()
    assert driver.dialogs.errors == []
    return same_part(path)


@pytest.mark.long
def test_window_and_script_give_the_same_report(opened: Driver, tmp_path: Path) -> None:
    """The reports agree after seeds, an undone edit, a kept edit, an estimate and a validation."""
    for name in ("T1", "T2", "V1", "V2"):
        seed(opened, name)
        opened.window.controller.accept()
    seed(opened, "V3")
    opened.window.controller.accept()
    opened.window.document.undo_stack.undo()
    opened.window.controller.use_sighting("T2", "L3_045", False)
    opened.window.controller.rename("V2", "Tower")
    press(opened, Key.Key_F9)
    opened.rest()
    press(opened, Key.Key_F10)
    opened.rest()
    expected = values_in_window(opened, tmp_path / "window.json")
    assert expected["calibrated"]
    assert [plane["name"] for plane in expected["validation"]] == ["V1", "Tower"]
    assert expected["cross_checks"] is not None

    def save(dialog: QWidget) -> None:
        opened.dialogs.path = tmp_path / "steps.py"
        opened.bot.mouseClick(dialog.findChild(QPushButton, "script_copy"), Left)
        opened.bot.mouseClick(dialog.findChild(QPushButton, "script_save"), Left)
        assert "steps.py" in dialog.findChild(QLabel, "script_message").text()
        assert dialog.findChild(QLabel, "script_messages") is None

    script = shown_script(opened, save)
    assert QGuiApplication.clipboard().text() == script
    assert (tmp_path / "steps.py").read_text(encoding="utf-8") == script
    assert "'V3'" not in script
    assert "project.put(" not in script
    assert run(script, tmp_path / "again") == expected


@pytest.mark.long
def test_a_difference_between_window_and_script_is_reported(
    opened: Driver,
) -> None:
    """The window keeps the selected points of the former estimate; the script selects new ones."""
    for name in ("T1", "T2"):
        seed(opened, name)
        opened.window.controller.accept()
    press(opened, Key.Key_F9)
    opened.rest()
    opened.window.controller.use_sighting("T1", "L3_045", False)
    opened.bot.waitUntil(lambda: not opened.window.document.awaits_result, timeout=60_000)
    opened.rest()
    followed = opened.project.result
    texts: list[str] = []

    def read(dialog: QWidget) -> None:
        label = dialog.findChild(QLabel, "script_messages")
        texts.append("" if label is None else label.text())

    shown_script(opened, read)
    opened.window.actions_["estimate"].trigger()
    opened.rest()
    shown_script(opened, read)
    moved = np.degrees(np.abs(opened.project.result.boresight - followed.boresight)).max()
    assert moved > 0
    assert f"by up to {moved:.4f}°" in texts[0]
    assert texts[1] == ""


def test_there_is_no_script_without_a_project(driver: Driver) -> None:
    assert not driver.window.actions_["script"].isEnabled()


def test_a_script_that_cannot_be_saved_is_reported(opened: Driver, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")

    def save(dialog: QWidget) -> None:
        opened.dialogs.path = tmp_path / "file" / "steps.py"
        opened.bot.mouseClick(dialog.findChild(QPushButton, "script_save"), Left)
        assert dialog.findChild(QLabel, "script_message").text() == ""

    with pytest.raises(AssertionError):
        shown_script(opened, save)
    (error,) = opened.dialogs.errors
    assert error.code == "file.not_writable"
