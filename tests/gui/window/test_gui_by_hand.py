"""Tests of the program by mouse and keyboard alone, with its own dialogues and graphics.

Each test ends with a check of the files on the disk and of a picture of the window.
"""

import shutil
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import (
    QApplication,
    QFileDialog,
    QLineEdit,
    QMessageBox,
    QPushButton,
)
from pytestqt.qtbot import QtBot

from lispac.gui.app.settings import AppSettings
from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from lispac.gui.features.report.identity_dialog import IdentityDialog
from lispac.io.project.project_file import UNSAVED_NAME, write_unsaved
from lispac.project import Project
from lispac.workflow.planning.demo import demo_seeds
from lispac.workflow.project.projects import open_project, save_project
from tests.gui.by_hand import (
    SETTINGS,
    DialogAnswers,
    Hands,
    ctrl_click,
    open_by_keys,
    push,
    rename,
    shows_something,
)
from tests.gui.import_support import drop, raw
from tests.gui.killed import killed_after_editing
from tests.gui.support import Control, Demo, Key, Left, click, press
from tests.support.long_runs import LONG, others_long

WHEEL_NOTCHES = 12
"""Notches of the wheel after which a plane of the demo fills the view."""


def spot(hands: Hands, name: str) -> QPoint:
    """Zoom to a plane of the demo with the wheel over it, and return where it is drawn."""
    role, position = demo_seeds()[name]
    press(hands, Key.Key_F6 if role == "target" else Key.Key_F7)
    press(hands, Key.Key_3)
    clouds = np.concatenate([cloud.sample for cloud in hands.window.scene.clouds.values()])
    aim = clouds[np.argmin(np.linalg.norm(clouds - position, axis=1))]  # a point, not a gap

    def drawn() -> QPoint:
        return QPoint(*(int(v) for v in hands.viewport.to_pixels(aim[None])[0][:2]))

    for _ in range(WHEEL_NOTCHES):
        at = QPointF(drawn())
        turned = QWheelEvent(
            at, QPointF(hands.viewport.canvas.mapToGlobal(at.toPoint())), QPoint(), QPoint(0, 120),
            Qt.MouseButton.NoButton, Qt.KeyboardModifier.NoModifier, Qt.ScrollPhase.NoScrollPhase,
            False,
        )  # fmt: skip
        QApplication.sendEvent(hands.viewport.canvas, turned)
    hands.bot.wait(300)
    return drawn()


def names(folder: Path) -> list[str]:
    """Names of the targets on the disk."""
    return [target.name for target in open_project(folder).targets]


def test_an_unexpected_dialogue_is_rejected_and_reported(qtbot: QtBot, qapp: QApplication) -> None:
    """The unexpected dialogue opens in the event loop of an expected one."""
    actions, below, above = DialogAnswers(), QMessageBox(), QMessageBox()
    below.setText("What now?")
    above.setText("The disk is full.")

    def act(_box: QMessageBox) -> bool:
        above.exec()
        return True

    actions.expect(QMessageBox, act)
    below.exec()
    assert [text for text in actions.trouble if "The disk is full." in text] == actions.trouble
    assert len(actions.trouble) == 1
    actions.expect(QFileDialog, act)
    actions.stop()
    assert actions.trouble[1:] == ["no QFileDialog came"]
    for each in (actions, below, above):
        each.deleteLater()


@pytest.mark.long
def test_files_dropped_on_the_start_page_become_a_project(
    hands: Hands, demo: Demo, tmp_path: Path
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

    assert hands.window.central_widget.start.isVisible()
    hands.answers.expect(ImportDialog, act)
    drop(hands.window, raw(demo))
    hands.until(lambda: hands.window.document.project is not None)
    hands.rest()
    hands.until_dialogs_used()
    assert not hands.window.central_widget.start.isVisible()
    kept = open_project(made)
    assert [line.name for line in kept.lines] == [line.name for line in demo.project.lines]
    assert kept.trajectory.name == "trajectory.sbet"
    shows_something(hands, tmp_path / "imported.png")


@pytest.mark.long
def test_pick_undo_redo_rename_estimate_cancel_estimate(
    hands: Hands, demo_copy: Path, tmp_path: Path
) -> None:
    window = hands.window
    open_by_keys(hands, demo_copy)
    for name in ("T1", "T2"):
        ctrl_click(hands, spot(hands, name))
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
    hands.until(cancel.isVisible)
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


@pytest.mark.parametrize(
    "button",
    [
        "Save the changes",
        *(pytest.param(b, marks=pytest.mark.long) for b in ("Cancel", "Discard the changes")),
    ],
)
def test_closing_with_unsaved_changes(
    hands: Hands, picked_folder: Path, button: str, tmp_path: Path
) -> None:
    open_by_keys(hands, picked_folder)
    before = names(picked_folder)
    click(hands, hands.window.workflow.headers[1])
    rename(hands, 0, "North wall")
    shows_something(hands, tmp_path / "renamed.png")
    push(hands, button)
    press(hands, Key.Key_Q, Control)
    hands.until_dialogs_used()
    assert hands.window.isVisible() == (button == "Cancel")
    after = ["North wall", *before[1:]] if button == "Save the changes" else before
    assert names(picked_folder) == after
    assert (picked_folder / UNSAVED_NAME).exists() == (button == "Cancel")


@pytest.mark.parametrize("button", others_long(["Continue the task", "Stop and close"]))
def test_closing_while_a_task_runs(hands: Hands, picked_folder: Path, button: str) -> None:
    """The question comes first; a task that the user continues gives its result."""
    open_by_keys(hands, picked_folder)
    before = (picked_folder / "project.json").read_bytes()
    press(hands, Key.Key_F9)
    assert hands.window.runner.busy
    push(hands, button)
    if button == "Stop and close":
        press(hands, Key.Key_Q, Control)
        hands.until_dialogs_used()
        assert not hands.window.isVisible()
        assert (picked_folder / "project.json").read_bytes() == before
        return
    press(hands, Key.Key_Q, Control)
    hands.until_dialogs_used()
    assert hands.window.isVisible()
    hands.rest()
    assert hands.project.result is not None


@LONG
def test_a_refused_name_is_typed_again_in_its_field(hands: Hands, picked_folder: Path) -> None:
    open_by_keys(hands, picked_folder)
    click(hands, hands.window.workflow.headers[1])
    table, names_before = hands.window.targets.table, names(picked_folder)
    row = names_before.index("T2")
    place = table.visualItemRect(table.item(row, 0)).center()
    hands.bot.mouseClick(table.viewport(), Left, pos=place)
    hands.bot.keyClick(table, Key.Key_F2)
    hands.bot.keyClicks(table.findChild(QLineEdit), "T1")
    push(hands, "Close")
    hands.bot.keyClick(table.findChild(QLineEdit), Key.Key_Return)
    hands.until_dialogs_used()
    hands.until(lambda: [each.text() for each in table.findChildren(QLineEdit)] == ["T1"])
    field = table.findChild(QLineEdit)
    assert (field.text(), hands.window.targets.current) == ("T1", "T2")
    assert [each.name for each in hands.project.targets] == names_before
    hands.bot.keyClicks(field, "Crane")
    hands.bot.keyClick(field, Key.Key_Return)
    hands.rest()
    assert hands.project.targets[row].name == hands.window.targets.current == "Crane"


@LONG
def test_typed_details_are_not_discarded_by_escape(hands: Hands, picked_folder: Path) -> None:
    open_by_keys(hands, picked_folder)
    seen: list[str] = []

    def type_and_escape(dialog: IdentityDialog) -> bool:
        field = dialog.findChild(QLineEdit, "identity_client")
        if not seen:
            hands.bot.keyClicks(field, "Port of Rimouski")
        seen.append(field.text())
        hands.bot.keyClick(field, Key.Key_Escape)
        return True

    def go_on(dialog: IdentityDialog) -> bool:
        field = dialog.findChild(QLineEdit, "identity_client")
        seen.append(field.text())
        hands.bot.keyClick(field, Key.Key_Escape)
        return True

    hands.answers.expect(IdentityDialog, type_and_escape)
    push(hands, "Continue typing")
    hands.answers.expect(IdentityDialog, go_on)
    push(hands, "Close without keeping")
    click(hands, hands.window.workflow.headers[4])
    details = hands.window.findChild(QPushButton, "report_details")
    click(hands, details)
    hands.until_dialogs_used()
    assert seen == ["Port of Rimouski"] * 2
    assert hands.project.identity.client == ""
    hands.answers.expect(IdentityDialog, lambda dialog: bool(dialog.reject()) or True)
    click(hands, details)  # unchanged, so that nothing is asked
    hands.until_dialogs_used()


@pytest.mark.long
@pytest.mark.parametrize("button", ["Restore", "Discard"])
def test_unsaved_work_is_offered_after_a_crash(
    hands: Hands, picked_folder: Path, button: str, tmp_path: Path
) -> None:
    before = names(picked_folder)
    killed_after_editing(picked_folder)
    assert names(picked_folder) == before
    # As at the next start of the same user, who has these settings
    hands.settings.last_project = AppSettings(
        picked_folder.parent / "killed" / SETTINGS
    ).last_project
    assert hands.session.crashed_project() == picked_folder
    open_by_keys(hands, picked_folder, then=button)
    back = button == "Restore"
    after = ["North wall", "South wall", *before[2:]] if back else before
    assert [target.name for target in hands.project.targets] == after
    assert hands.window.isWindowModified() == back
    shows_something(hands, tmp_path / "recovered.png")
    press(hands, Key.Key_Z, Control)
    assert [target.name for target in hands.project.targets] == before
    press(hands, Key.Key_Y, Control)
    press(hands, Key.Key_S, Control)
    assert names(picked_folder) == after
    assert not hands.window.isWindowModified()
    hands.until(lambda: not (picked_folder / UNSAVED_NAME).exists())
    assert hands.session.crashed_project() is None


@pytest.mark.long  # `test_gui_safekeeping` and `test_gui_view_state` cover it without dialogues
def test_the_lines_after_the_calibration_are_shown_when_a_project_is_opened(
    hands: Hands, demo_copy: Path, estimated: Project, tmp_path: Path
) -> None:
    """Opened again, and opened with the unsaved work of a program that ended."""
    save_project(replace(estimated, folder=demo_copy))
    crashed = replace(
        estimated, folder=Path(shutil.copytree(demo_copy, tmp_path / "crashed" / "harbour"))
    )
    save_project(crashed)
    write_unsaved(crashed.without_target(crashed.targets_of_role("validation")[0].name))
    for folder, button in ((demo_copy, ""), (crashed.folder, "Restore")):
        open_by_keys(hands, folder, button)
        hands.until(lambda folder=folder: hands.project.folder == folder)
        hands.rest()
        scene = hands.window.scene
        hands.until(lambda scene=scene: scene.which == "estimated" and scene.is_drawn)
        assert hands.window.actions_["after"].isChecked()
        after = {line: cloud.sample.copy() for line, cloud in scene.clouds.items()}
        press(hands, Key.Key_B)
        hands.rest()
        hands.until(lambda scene=scene: scene.which == "prior" and scene.is_drawn)
        moved = [np.linalg.norm(scene.clouds[k].sample - after[k], axis=1) for k in after]
        # The prior boresight is about a degree off, at distances of some tens of metres
        assert 0.1 < np.median(np.concatenate(moved)) < 2.0
