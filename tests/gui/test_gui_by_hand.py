"""The program used by mouse and keyboard alone, with its own dialogues and graphics.

Each way ends with what is on the disk, and a picture of the window that is not blank.
"""

from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QPoint, QTimer
from PySide6.QtGui import QImage
from PySide6.QtWidgets import (
    QApplication,
    QDialog,
    QFileDialog,
    QLineEdit,
    QMessageBox,
    QPushButton,
)
from pytestqt.qtbot import QtBot

from lispac.gui import theme
from lispac.gui.dialogs.import_files.dialog import ImportDialog
from lispac.gui.dialogs.service import Dialogs
from lispac.io.project_file import UNSAVED_NAME
from lispac.workflow.demo import demo_seeds
from lispac.workflow.projects import open_project, save_project
from tests.gui.import_support import drop, raw
from tests.gui.support import WAIT_MS, Control, Demo, Driver, Key, Left, click, press
from tests.gui.test_gui_safekeeping import killed_after_editing


@pytest.fixture
def hands(qtbot: QtBot, qapp: QApplication, tmp_path: Path) -> Iterator[Driver]:
    """An empty window that draws and asks."""
    if qapp.platformName() == "offscreen":
        pytest.skip("OpenGL needs a screen, if only a virtual one")
    from lispac.gui.viewport.vtk import VtkViewport

    theme.apply_theme(qapp)
    made = Driver(qtbot, VtkViewport(), tmp_path, Dialogs())
    yield made
    made.window.document.undo_stack.setClean()
    made.leave()


@pytest.fixture
def picked_folder(demo: Demo, demo_copy: Path) -> Path:
    """A project folder with picked targets."""
    save_project(replace(demo.picked, folder=demo_copy))
    return demo_copy


def answer(kind: type[QDialog], act: Callable[[QDialog], bool]) -> QTimer:
    """Do something to the next dialogue of a kind; until it says that this was all."""
    timer = QTimer(interval=50)

    def look() -> None:
        dialog = QApplication.activeModalWidget()
        if isinstance(dialog, kind) and dialog.isVisible() and act(dialog):
            timer.stop()

    timer.timeout.connect(look)
    timer.start()
    return timer


def push(bot: QtBot, text: str) -> QTimer:
    """Click a button of the next question."""

    def act(box: QMessageBox) -> bool:
        found = next(b for b in box.buttons() if text in b.text().replace("&", ""))
        bot.mouseClick(found, Left)
        return True

    return answer(QMessageBox, act)


def open_by_keys(hands: Driver, folder: Path) -> None:
    """Ctrl+O, and the file's name."""

    def act(dialog: QFileDialog) -> bool:
        name = dialog.findChild(QLineEdit, "fileNameEdit")
        name.selectAll()
        hands.bot.keyClicks(name, str(folder / "project.json"))
        hands.bot.keyClick(name, Key.Key_Return)
        return True

    asked = answer(QFileDialog, act)
    press(hands, Key.Key_O, Control)
    hands.bot.waitUntil(lambda: hands.window.document.project is not None, timeout=WAIT_MS)
    hands.rest()
    assert not asked.isActive()
    hands.window.activateWindow()  # no window manager does it
    hands.bot.waitUntil(hands.window.isActiveWindow, timeout=WAIT_MS)


def ctrl_click(hands: Driver, name: str) -> None:
    """On a drawn point of a plane of the demo."""
    window, viewport, bot = hands.window, hands.viewport, hands.bot
    role, position = demo_seeds()[name]
    press(hands, Key.Key_F6 if role == "target" else Key.Key_F7)
    press(hands, Key.Key_3)
    clouds = np.concatenate([cloud.sample for cloud in window.scene.clouds.values()])
    away = np.linalg.norm(clouds - position, axis=1)
    viewport.fit(clouds[away < 3])
    bot.wait(300)
    aim = clouds[np.argmin(away)]  # a drawn point of the plane, not a gap between two
    x, y = (int(v) for v in viewport.to_pixels(aim[None])[0][:2])
    bot.mouseClick(viewport.canvas, Left, Control, QPoint(x, y))
    hands.rest()
    assert window.controller.candidate is not None


def rename(hands: Driver, row: int, to: str) -> None:
    """F2 in the list of targets."""
    table = hands.window.targets.table
    hands.bot.mouseClick(
        table.viewport(), Left, pos=table.visualItemRect(table.item(row, 0)).center()
    )
    hands.bot.keyClick(table, Key.Key_F2)
    editor = table.findChild(QLineEdit)
    editor.selectAll()
    hands.bot.keyClicks(editor, to)
    hands.bot.keyClick(editor, Key.Key_Return)
    hands.bot.waitUntil(
        lambda: to in [target.name for target in hands.project.targets], timeout=WAIT_MS
    )
    hands.rest()


def names(folder: Path) -> list[str]:
    """Of the targets on the disk."""
    return [target.name for target in open_project(folder).targets]


def shows_something(hands: Driver, file: Path) -> None:
    """Keep a picture of the window, which is not blank."""
    hands.bot.wait(300)
    assert hands.window.grab().save(str(file))
    image = QImage(str(file)).convertToFormat(QImage.Format.Format_RGB32)
    assert len(np.unique(np.frombuffer(image.constBits(), np.uint32))) > 50


def test_files_dropped_on_the_start_page_become_a_project(
    hands: Driver, demo: Demo, tmp_path: Path
) -> None:
    made = tmp_path / "made"

    def act(dialog: ImportDialog) -> bool:
        if dialog.work.busy or not dialog.table.rowCount():
            return False
        if dialog.folder.text() != str(made):
            dialog.folder.selectAll()
            hands.bot.keyClicks(dialog.folder, str(made))
            return False
        hands.bot.mouseClick(dialog.ok, Left)
        return True

    assert hands.window.stage.start.isVisible()
    asked = answer(ImportDialog, act)
    drop(hands.window, raw(demo))
    hands.bot.waitUntil(lambda: hands.window.document.project is not None, timeout=WAIT_MS)
    hands.rest()
    assert not asked.isActive()
    assert not hands.window.stage.start.isVisible()
    kept = open_project(made)
    assert [line.name for line in kept.lines] == [line.name for line in demo.project.lines]
    assert kept.trajectory.name == "trajectory.sbet"
    shows_something(hands, tmp_path / "imported.png")


def test_pick_undo_redo_rename_estimate_cancel_estimate(
    hands: Driver, demo_copy: Path, tmp_path: Path
) -> None:
    window = hands.window
    open_by_keys(hands, demo_copy)
    for name in ("T1", "T2"):
        ctrl_click(hands, name)
        press(hands, Key.Key_Return)
        hands.rest()
    assert [target.name for target in hands.project.targets] == ["T1", "T2"]
    press(hands, Key.Key_Z, Control)
    assert [target.name for target in hands.project.targets] == ["T1"]
    press(hands, Key.Key_S, Control)
    assert names(demo_copy) == ["T1"]
    press(hands, Key.Key_Y, Control)
    rename(hands, 0, "North wall")
    press(hands, Key.Key_S, Control)
    assert names(demo_copy) == ["North wall", "T2"]

    click(hands, window.workflow.headers[2])
    click(hands, window.adjust.estimate)
    cancel = window.findChild(QPushButton, "cancel_estimate")
    hands.bot.waitUntil(cancel.isVisible, timeout=WAIT_MS)
    click(hands, cancel)
    hands.rest()
    assert window.document.project.result is None
    click(hands, window.adjust.estimate)
    hands.rest()
    press(hands, Key.Key_S, Control)
    kept = open_project(demo_copy)
    assert kept.result is not None
    assert (np.abs(np.degrees(kept.result.boresight) - kept.truth_deg) < 0.1).all()
    assert not window.isWindowModified()
    shows_something(hands, tmp_path / "estimated.png")


@pytest.mark.parametrize("button", ["Cancel", "Discard", "Save"])
def test_closing_with_unsaved_changes(
    hands: Driver, picked_folder: Path, button: str, tmp_path: Path
) -> None:
    open_by_keys(hands, picked_folder)
    before = names(picked_folder)
    click(hands, hands.window.workflow.headers[1])
    rename(hands, 0, "North wall")
    shows_something(hands, tmp_path / "renamed.png")
    asked = push(hands.bot, button)
    press(hands, Key.Key_Q, Control)
    assert not asked.isActive()
    assert hands.window.isVisible() == (button == "Cancel")
    after = ["North wall", *before[1:]] if button == "Save" else before
    assert names(picked_folder) == after
    assert (picked_folder / UNSAVED_NAME).exists() == (button == "Cancel")


@pytest.mark.parametrize("button", ["Bring it back", "Forget it"])
def test_after_a_crash_the_work_is_offered(
    hands: Driver, picked_folder: Path, button: str, tmp_path: Path
) -> None:
    before = names(picked_folder)
    killed_after_editing(picked_folder)
    assert names(picked_folder) == before
    asked = push(hands.bot, button)
    open_by_keys(hands, picked_folder)
    assert not asked.isActive()
    QCoreApplication.processEvents()
    back = button == "Bring it back"
    assert hands.window.isWindowModified() == back
    press(hands, Key.Key_S, Control)
    assert ("North wall" in names(picked_folder)) == back
    hands.bot.waitUntil(lambda: not (picked_folder / UNSAVED_NAME).exists(), timeout=WAIT_MS)
    shows_something(hands, tmp_path / "recovered.png")
