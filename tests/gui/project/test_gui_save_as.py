"""Tests of saving a project in another folder with the real file dialogue."""

import errno
import os
import stat
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QFileDialog, QLineEdit

from lispac.errors import InputError, ProjectError
from lispac.gui.window.dialogs import Dialogs
from lispac.io.project.project_file import write_project
from lispac.messages import error, note
from lispac.progress import Step, no_progress
from lispac.project import Project
from lispac.workflow.importing.line_import import import_lines, line_folder
from lispac.workflow.project.project_copy import save_project_as
from lispac.workflow.project.projects import open_project, save_project
from lispac.workflow.project.survey import load_survey
from tests.gui.support import WAIT_MS, Control, Demo, Driver, Key, Left, press
from tests.support.message_codes import codes

Shift = Control.__class__.ShiftModifier


@pytest.fixture
def harbour(driver: Driver, demo: Demo, demo_copy: Path) -> Driver:
    """A window with a copy of the demo project that has one unsaved edit."""
    before = replace(demo.project, folder=demo_copy)
    save_project(before)
    driver.window.open_project(demo_copy)
    driver.rest()
    driver.window.document.edit(
        "detection of T1", driver.project.with_target(demo.picked.target("T1"))
    )
    return driver


@pytest.fixture
def typed(harbour: Driver) -> Iterator[list[str]]:
    """Text to type into the file dialogue; the proposed names are appended."""
    texts: list[str] = []
    harbour.dialogs.folder_to_save_in = lambda start: Dialogs.folder_to_save_in(
        harbour.dialogs, start
    )
    timer = QTimer(harbour.window)

    def drive() -> None:
        shown = QApplication.activeModalWidget()
        if isinstance(shown, QFileDialog) and shown.isVisible():
            field = shown.findChild(QLineEdit, "fileNameEdit")
            if len(texts) > 1:  # the dialogue did not accept the text
                shown.reject()
                return
            texts.append(field.text())
            field.setText(texts[0])
            save = shown.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Save)
            QTest.mouseClick(save, Left)

    timer.timeout.connect(drive)
    timer.start(50)
    yield texts
    timer.stop()


def test_the_project_continues_in_its_new_folder(
    harbour: Driver, typed: list[str], demo_copy: Path, tmp_path: Path
) -> None:
    typed.append(str(tmp_path / "office" / "quay"))
    (tmp_path / "office").mkdir()
    assert harbour.window.isWindowModified()
    press(harbour, Key.Key_S, Control | Shift)
    harbour.bot.waitUntil(lambda: harbour.project.name == "quay", timeout=WAIT_MS)
    harbour.rest()
    assert harbour.dialogs.errors == []
    assert typed[1] == "harbour-2"
    new = tmp_path / "office" / "quay"
    assert harbour.project.folder == new
    assert harbour.window.windowTitle() == "quay[*] – LISPAC"
    assert not harbour.window.isWindowModified()
    assert harbour.window.settings.recent()[:2] == [new, demo_copy]
    assert [t.name for t in open_project(new).targets] == ["T1"]
    assert open_project(demo_copy).targets == ()
    assert open_project(new).lines[0].path.is_file()

    # An edit made before the move is undone and saved in the new folder.
    harbour.window.activateWindow()
    harbour.bot.waitUntil(harbour.window.isActiveWindow, timeout=WAIT_MS)
    press(harbour, Key.Key_Z, Control)
    assert harbour.project.folder == new
    assert harbour.window.isWindowModified()
    press(harbour, Key.Key_S, Control)
    assert open_project(new).targets == ()
    press(harbour, Key.Key_Y, Control)
    assert harbour.project.folder == new
    assert harbour.window.document.is_survey_current


def test_an_unwritable_project_is_saved_in_another_folder(
    harbour: Driver, demo_copy: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refused(_project: Project, **_: object) -> None:
        raise InputError(f"{demo_copy}: cannot be written (Read-only); choose another folder.")

    monkeypatch.setattr("lispac.workflow.project.projects.write_project", refused)
    press(harbour, Key.Key_S, Control)
    (error,) = harbour.dialogs.errors
    assert error.code == "window.not_saved"
    assert harbour.window.isWindowModified()
    monkeypatch.undo()
    harbour.dialogs.path = tmp_path / "mine"
    assert harbour.window.actions_["save_as"].isEnabled()
    harbour.window.actions_["save_as"].trigger()
    harbour.rest()
    assert harbour.project.folder == tmp_path / "mine"
    assert not harbour.window.isWindowModified()


def test_a_folder_with_a_project_is_refused_and_nothing_changes(
    harbour: Driver, demo_copy: Path
) -> None:
    harbour.dialogs.path = demo_copy
    harbour.window.actions_["save_as"].trigger()
    harbour.rest()
    assert harbour.dialogs.errors[0].code == "project_folder.exists"
    assert harbour.window.isWindowModified()
    assert open_project(demo_copy).targets == ()


def test_imported_lines_are_copied_to_the_new_folder(demo: Demo, tmp_path: Path) -> None:
    one = replace(demo.project, folder=tmp_path / "old", lines=demo.project.lines[:2])
    write_project(one)
    import_lines(one, [one.lines[0].name])
    survey = load_survey(one)
    moved, found = save_project_as(one, survey, tmp_path / "new")
    own = line_folder(moved, moved.lines[0])
    assert found.scans[moved.lines[0].name].folder == own
    assert found.clouds[moved.lines[0].name].stored.folder == own
    again = load_survey(open_project(tmp_path / "new"))
    assert again.scans[moved.lines[0].name].folder == own
    assert "import.repeated" not in codes(again.notes)
    assert len(again.clouds[moved.lines[0].name].sample) == len(
        survey.clouds[one.lines[0].name].sample
    )
    with pytest.raises(ProjectError) as raised:
        save_project_as(one, survey, tmp_path / "new")
    assert raised.value.code == "project_folder.exists"

    def stop(fraction: float, step: Step | None = None) -> None:
        if str(step).startswith("Copying"):
            raise OSError(errno.ENOSPC, "No space left on device")

    with pytest.raises(InputError) as refused:
        save_project_as(one, survey, tmp_path / "full", progress=stop)
    assert refused.value.message == error(
        "project_folder.not_writable",
        folder=str(tmp_path / "full"),
        reason=note("system.disk_full"),
    )
    assert not (tmp_path / "full").exists()


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_a_folder_that_may_not_be_written_is_refused(demo: Demo, tmp_path: Path) -> None:
    (tmp_path / "locked").mkdir()
    (tmp_path / "locked").chmod(stat.S_IRUSR | stat.S_IXUSR)
    with pytest.raises(InputError) as raised:
        save_project_as(demo.project, demo.survey, tmp_path / "locked" / "p", progress=no_progress)
    assert raised.value.code == "project_folder.not_writable"


def test_a_free_folder_beside_the_project_is_proposed(harbour: Driver) -> None:
    folder = harbour.project.folder
    folders: list[Path] = []
    harbour.dialogs.folder_to_save_in = folders.append
    press(harbour, Key.Key_S, Control | Shift)
    assert folders == [folder.with_name(f"{folder.name}-2")]
    assert harbour.project.folder == folder
