"""Tests of recovery copies and locks: unsaved work survives a crash, no edit is overwritten."""

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from lispac.gui.project.recovery_copies import LOCK_FILE_NAME, LOCKED_PROJECT_ERROR
from lispac.gui.viewport.recording_viewport import RecordingViewport
from lispac.io.project.project_file import (
    PROJECT_FILE_NAME,
    UNSAVED_NAME,
    read_project,
    read_unsaved,
    write_unsaved,
)
from lispac.project import Project
from lispac.workflow.project.projects import save_project
from tests.gui.killed import killed_after_editing
from tests.gui.support import WAIT_MS, Control, Driver, Key, press
from tests.support.concurrent_commands import pool, run


@pytest.fixture
def folder(picked_folder: Path) -> Path:
    """A project folder with picked targets."""
    return picked_folder


def names(project) -> set[str]:
    return {target.name for target in project.targets}


def open_project_window(driver: Driver, folder: Path) -> None:
    driver.window.open_project(folder)
    driver.bot.waitUntil(lambda: driver.window.document.project is not None, timeout=WAIT_MS)
    driver.rest()


def wait_for_unsaved(driver: Driver, folder: Path, exists: bool) -> None:
    driver.bot.waitUntil(lambda: (folder / UNSAVED_NAME).exists() == exists, timeout=WAIT_MS)


@pytest.mark.long
def test_edits_of_a_killed_program_are_recovered(driver: Driver, folder: Path) -> None:
    killed_after_editing(folder)
    assert "North wall" not in names(read_project(folder))
    assert (folder / LOCK_FILE_NAME).exists(), "left by the killed program, and stale"
    driver.dialogs.recovers = True
    open_project_window(driver, folder)
    assert driver.dialogs.safety == [f"recover {folder.name}"]
    assert {"North wall", "South wall"} <= names(driver.project)
    assert driver.window.isWindowModified()
    driver.window.document.undo_stack.undo()
    assert {"T1", "T2"} <= names(driver.project)
    driver.window.document.undo_stack.redo()
    driver.window.actions_["save"].trigger()
    assert {"North wall", "South wall"} <= names(read_project(folder))
    wait_for_unsaved(driver, folder, exists=False)


def test_unsaved_work_of_an_ended_program_is_recovered(driver: Driver, folder: Path) -> None:
    project = read_project(folder)
    first = project.targets[0]
    renamed = project.without_target(first.name).with_target(replace(first, name="North wall"))
    write_unsaved(renamed)
    driver.dialogs.recovers = True
    open_project_window(driver, folder)
    assert driver.dialogs.safety == [f"recover {folder.name}"]
    assert names(driver.project) == names(renamed)
    assert driver.window.isWindowModified()
    driver.window.document.undo_stack.undo()
    assert names(driver.project) == names(project)
    driver.window.document.undo_stack.redo()
    driver.window.actions_["save"].trigger()
    assert names(read_project(folder)) == names(renamed)
    wait_for_unsaved(driver, folder, exists=False)


def test_the_lines_after_the_adjustment_are_shown_after_a_recovery(
    driver: Driver, estimated: Project, demo_copy: Path
) -> None:
    project = replace(estimated, folder=demo_copy)
    save_project(project)
    write_unsaved(project.without_target(project.targets_of_role("validation")[0].name))
    driver.dialogs.recovers = True
    open_project_window(driver, demo_copy)
    assert driver.dialogs.safety == [f"recover {demo_copy.name}"]
    assert driver.project.result is not None
    assert driver.window.scene.which == "estimated"
    assert driver.window.actions_["after"].isChecked()
    assert driver.window.scene.has_estimated


def test_discarded_unsaved_work_is_deleted(driver: Driver, folder: Path) -> None:
    write_unsaved(read_project(folder).without_target("T1"))
    open_project_window(driver, folder)
    assert driver.dialogs.safety == [f"recover {folder.name}"]
    assert {"T1", "T2"} <= names(driver.project)
    assert not driver.window.isWindowModified()
    assert not (folder / UNSAVED_NAME).exists()


def test_a_recovery_copy_exists_while_work_is_unsaved(driver: Driver, folder: Path) -> None:
    open_project_window(driver, folder)
    driver.window.controller.rename("T1", "North wall")
    wait_for_unsaved(driver, folder, exists=True)
    driver.window.document.undo_stack.undo()
    wait_for_unsaved(driver, folder, exists=False)
    driver.window.document.undo_stack.redo()
    wait_for_unsaved(driver, folder, exists=True)
    driver.window.close()  # discards the changes
    assert not (folder / UNSAVED_NAME).exists()
    assert not (folder / LOCK_FILE_NAME).exists()
    assert {"T1", "T2"} <= names(read_project(folder))


def test_a_project_opened_twice_is_detected(
    driver: Driver, folder: Path, qtbot: QtBot, qapp: QApplication, tmp_path: Path
) -> None:
    open_project_window(driver, folder)
    driver.window.controller.rename("T1", "North wall")
    wait_for_unsaved(driver, folder, exists=True)
    other = Driver(qtbot, RecordingViewport(), tmp_path / "other")
    other.dialogs.opens_twice = False
    other.window.open_project(folder)
    qtbot.waitUntil(lambda: other.dialogs.safety != [], timeout=WAIT_MS)
    other.rest()
    assert f"process {os.getpid()}" in other.dialogs.safety[0]
    assert other.window.document.project is None
    assert other.window.task_bar.currentMessage() == "", "nothing says that it was opened"

    other.dialogs.opens_twice = True
    open_project_window(other, folder)
    other.window.controller.rename("T2", "South wall")
    other.window.actions_["save"].trigger()
    assert "South wall" in names(read_project(folder))
    assert other.window.recovery_copies.problem == LOCKED_PROJECT_ERROR, (
        "for as long as it has no protection"
    )
    assert driver.window.recovery_copies.problem is None
    kept = read_unsaved(folder)
    assert kept is not None
    assert "North wall" in names(kept), "the first window's work, with its points"
    other.window.hide()
    other.window.close()
    other.window.deleteLater()

    driver.dialogs.overwrites = False
    driver.window.actions_["save"].trigger()
    assert driver.dialogs.safety == [f"overwrite {folder.name}"]
    assert "South wall" in names(read_project(folder)), "it is not overwritten unasked"
    assert driver.window.isWindowModified()
    driver.dialogs.overwrites = True
    driver.window.actions_["save"].trigger()
    assert "North wall" in names(read_project(folder))
    driver.window.controller.rename("T1", "Northern wall")
    driver.window.actions_["save"].trigger()
    assert driver.dialogs.safety == [f"overwrite {folder.name}"] * 2, "its own save is no news"


def window_and_command_at_once(driver: Driver, folder: Path, times: int) -> None:
    """Check that each change is saved, or that the window reports that it is not."""
    chance = np.random.default_rng(35)
    open_project_window(driver, folder)
    driver.dialogs.overwrites = False
    with pool() as processes:
        processes.submit(run, ("identity",), folder).result()  # loads the modules
        for k in range(times):
            vessel, name = f"Vessel {k}", f"Wall {k}"
            command = processes.submit(run, ("identity", "--vessel", vessel), folder)
            driver.bot.wait(int(chance.integers(0, 40)))
            driver.window.controller.rename(driver.project.targets[0].name, name)
            notice_count, errors = len(driver.dialogs.safety), len(driver.dialogs.errors)
            saved = driver.window.controller.save()
            assert command.result()[0] == 0
            found = read_project(folder)
            assert found.identity.vessel == vessel
            reported = (
                len(driver.dialogs.safety) > notice_count or len(driver.dialogs.errors) > errors
            )
            assert saved != reported
            assert (name in names(found)) == saved
            driver.window.document.open(None, None)
            open_project_window(driver, folder)


def test_concurrent_edits_of_window_and_command(driver: Driver, folder: Path) -> None:
    window_and_command_at_once(driver, folder, 3)


@pytest.mark.long
def test_concurrent_edits_of_window_and_many_commands(driver: Driver, folder: Path) -> None:
    window_and_command_at_once(driver, folder, 60)


def test_a_failed_recovery_copy_is_reported(driver: Driver, folder: Path) -> None:
    open_project_window(driver, folder)
    (folder / UNSAVED_NAME).mkdir()
    (folder / UNSAVED_NAME / "held").touch()
    driver.window.controller.rename("T1", "North wall")
    driver.bot.waitUntil(
        lambda: "recovery copy" in driver.window.log.toPlainText(), timeout=WAIT_MS
    )
    trouble = driver.window.recovery_copies.problem
    assert trouble is not None
    assert trouble.code == "window.unsaved_work_not_kept"
    assert driver.dialogs.errors == []


def test_a_failed_recovery_copy_is_repeated(driver: Driver, folder: Path) -> None:
    open_project_window(driver, folder)
    (folder / UNSAVED_NAME).mkdir()
    (folder / UNSAVED_NAME / "held").touch()
    driver.window.controller.rename("T1", "North wall")
    driver.bot.waitUntil(lambda: driver.window.recovery_copies.problem is not None, timeout=WAIT_MS)
    (folder / UNSAVED_NAME / "held").unlink()
    (folder / UNSAVED_NAME).rmdir()
    driver.window.controller.rename("T2", "South wall")
    driver.bot.waitUntil(lambda: (folder / UNSAVED_NAME).is_file())
    driver.bot.waitUntil(lambda: driver.window.recovery_copies.problem is None)


def test_a_renamed_folder_is_not_recreated_without_its_lines(driver: Driver, folder: Path) -> None:
    open_project_window(driver, folder)
    away = folder.with_name("renamed")
    folder.rename(away)
    driver.window.controller.rename("T1", "North wall")
    driver.bot.waitUntil(lambda: driver.window.recovery_copies.problem is not None)
    driver.window.activateWindow()
    press(driver, Key.Key_S, Control)
    driver.bot.waitUntil(lambda: driver.dialogs.errors != [])
    assert driver.dialogs.errors[0].code == "project_folder.gone"
    assert not folder.exists()
    assert driver.window.isWindowModified()

    away.rename(folder)
    press(driver, Key.Key_S, Control)
    driver.bot.waitUntil(lambda: not driver.window.isWindowModified())
    assert "North wall" in names(read_project(folder))
    assert driver.dialogs.safety == [], "nobody else wrote it"
    assert driver.window.recovery_copies.problem is None


def test_a_project_with_a_damaged_recovery_copy_is_opened(driver: Driver, folder: Path) -> None:
    (folder / UNSAVED_NAME).write_text((folder / PROJECT_FILE_NAME).read_text()[:1000])
    open_project_window(driver, folder)
    assert driver.dialogs.safety == []
    assert UNSAVED_NAME in driver.window.log.toPlainText()
    assert {"T1", "T2"} <= names(driver.project)
