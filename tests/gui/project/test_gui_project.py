"""Tests of a project in the window: open, save, close, and its data files."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QStandardPaths
from PySide6.QtWidgets import QWidget

from lispac.errors import ProjectError
from lispac.gui.project.status import TARGETS
from lispac.workflow.project.projects import open_project
from tests.gui.by_hand import choose, open_menu
from tests.gui.support import (
    WAIT_MS,
    Control,
    Demo,
    Driver,
    Key,
    click,
    click_check,
    open_step,
    press,
    sentence,
    type_into,
)
from tests.support.long_runs import LONG, others_long

# -- opening, saving, closing ------------------------------------------------------------------


def test_a_project_opens_with_a_key_and_its_lines_are_drawn(
    driver: Driver, demo: Demo, demo_copy: Path
):
    assert sentence(driver, 0) == "no project open"
    driver.dialogs.path = demo_copy / "project.json"
    press(driver, Key.Key_O, Control)
    driver.rest()
    assert driver.project.folder == demo_copy
    assert list(driver.viewport.clouds) == [line.name for line in driver.project.lines]
    assert len(set(driver.viewport.colours.values())) == 6
    points = sum(len(scan) for scan in demo.survey.scans.values())
    assert sentence(driver, 0) == f"6 lines, {points:,} points"
    assert driver.window.settings.recent() == [demo_copy]
    assert not driver.window.isWindowModified()


def test_the_folders_of_moved_files_are_asked_for(driver: Driver, demo_copy: Path, tmp_path: Path):
    """The user chooses a wrong folder, then that of the lines, then a folder above the rest."""
    known = open_project(demo_copy)
    for name, paths in (("lines", [n.path for n in known.lines]), ("nav", [known.trajectory])):
        (tmp_path / "usb" / name).mkdir(parents=True)
        for path in paths:
            path.rename(tmp_path / "usb" / name / path.name)
    (tmp_path / "empty").mkdir()
    folders = [tmp_path / "empty", tmp_path / "usb" / "lines", tmp_path / "usb"]
    driver.dialogs.folders = list(folders)
    driver.window.open_project(demo_copy)
    driver.rest()
    assert driver.dialogs.requests == ["harbour: 7", "harbour: 7", "harbour: 1"]
    (error,) = driver.dialogs.errors
    assert error.code == "project_files.none_of_many_found"
    assert driver.project.trajectory == tmp_path / "usb" / "nav" / known.trajectory.name
    assert driver.window.document.is_survey_current
    assert driver.window.isWindowModified()  # the new paths belong to the project
    driver.dialogs.errors.clear()
    press(driver, Key.Key_S, Control)
    assert not driver.window.isWindowModified()
    assert open_project(demo_copy).trajectory == driver.project.trajectory


def test_a_project_with_missing_files_is_not_opened(driver: Driver, demo_copy: Path):
    known = open_project(demo_copy)
    known.trajectory.unlink()
    driver.window.open_project(demo_copy)
    driver.rest()
    assert driver.dialogs.requests == ["harbour: 1"]
    assert driver.window.document.project is None
    assert driver.window.task_bar.currentMessage() == ("harbour was not opened: files are missing")


def test_a_folder_without_a_project_is_refused_with_a_message(driver: Driver, tmp_path: Path):
    driver.window.open_project(tmp_path)
    driver.rest()
    assert isinstance(driver.dialogs.errors[0], ProjectError)
    assert driver.window.document.project is None


@pytest.mark.parametrize(("choice", "closes", "saved"), others_long([
    ("cancel", False, 0), ("discard", True, 0), ("save", True, 1),
]))  # fmt: skip
def test_closing_with_changes_asks(
    driver: Driver, demo: Demo, demo_copy: Path, choice, closes, saved
):
    before = replace(demo.project, folder=demo_copy)
    driver.window.document.open(before, demo.survey)
    target = demo.picked.target("T1")
    driver.window.document.edit("detection of T1", before.with_target(target))
    assert driver.window.isWindowModified()
    driver.dialogs.save_choice = choice
    assert driver.window.close() is closes
    assert driver.dialogs.requests == ["harbour"]
    assert len(open_project(demo_copy).targets) == saved


def test_a_project_is_closed_from_the_menu(driver: Driver, demo: Demo, demo_copy: Path) -> None:
    window, before = driver.window, replace(demo.project, folder=demo_copy)
    window.document.open(before, demo.survey)
    window.document.edit("detection of T1", before.with_target(demo.picked.target("T1")))
    driver.rest()
    for choice, is_open in (("cancel", True), ("discard", False)):
        driver.dialogs.save_choice = choice
        choose(driver.bot, open_menu(driver.bot, window, "File"), "Close project")
        driver.rest()
        assert (window.document.project is not None) == is_open
        assert window.centralWidget().start.isVisible() != is_open
    assert not window.actions_["close_project"].isEnabled()


def test_saving_clears_the_modified_state_and_undo_sets_it_again(
    driver: Driver, demo: Demo, demo_copy: Path
):
    before = replace(demo.project, folder=demo_copy)
    driver.window.document.open(before, demo.survey)
    driver.window.document.edit("pick", before.with_target(demo.picked.target("T1")))
    press(driver, Key.Key_S, Control)
    assert not driver.window.isWindowModified()
    assert [t.name for t in open_project(demo_copy).targets] == ["T1"]
    press(driver, Key.Key_Z, Control)
    assert driver.window.isWindowModified()


@pytest.mark.usefixtures("reads_files")
def test_closing_while_work_runs_stops_it(driver: Driver, demo_copy: Path):
    driver.window.open_project(demo_copy)
    assert driver.window.runner.busy
    assert driver.window.close()
    assert driver.window.runner.current is None
    assert driver.viewport.closed
    assert driver.window.document.project is None


@pytest.mark.usefixtures("reads_files")
def test_a_cancelled_opening_keeps_the_project_that_is_open(opened: Driver, demo_copy: Path):
    before = opened.project
    opened.window.open_project(demo_copy)
    click(opened, opened.window.task_bar.cancel)
    opened.rest()
    assert opened.project is before
    assert opened.viewport.clouds


def test_the_options_of_the_next_seed_are_reset_with_the_project(picked: Driver, demo_copy: Path):
    window, panel = picked.window, picked.window.targets
    open_step(picked, TARGETS)
    fresh = panel.seed_options
    type_into(picked, panel.findChild(QWidget, "search_radius"), "2.5")
    press(picked, Key.Key_F7)
    panel.line_choice.setFocus()
    picked.bot.keyClick(panel.line_choice, Key.Key_Down)
    assert panel.seed_options != fresh
    assert window.viewport.hint == ""
    picked.window.actions_["measure_distance"].trigger()
    assert window.viewport.mouse_mode != "navigate"
    picked.dialogs.path = demo_copy / "project.json"
    press(picked, Key.Key_O, Control)
    picked.rest()
    assert panel.seed_options == fresh
    assert window.viewport.mouse_mode == "navigate"
    assert not window.actions_["measure_distance"].isChecked()


def test_the_demo_is_written_to_the_documents_of_the_user(
    driver: Driver, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, demo_copy: Path
):
    """The cache may be emptied, and the demo may contain work of the user."""
    documents = tmp_path / "Documents"
    monkeypatch.setattr(QStandardPaths, "writableLocation", lambda _kind: str(documents))
    documents.mkdir()
    demo_copy.rename(documents / "LISPAC demo")
    click(driver, driver.window.central_widget.start.links["demo"])
    driver.rest()
    assert driver.project.folder == documents / "LISPAC demo"


def test_an_existing_demo_is_opened(driver: Driver, demo_copy: Path):
    driver.window.controller.open_demo(demo_copy)
    driver.rest()
    assert driver.project.truth_deg is not None


# -- data ----------------------------------------------------------------------------------------


def test_a_line_is_hidden_by_its_check_box(picked: Driver):
    open_step(picked, 0)
    table = picked.window.data.lines
    click_check(picked, table, table.model().index(1, 0))
    assert picked.viewport.hidden == {picked.project.lines[1].name}


@LONG
def test_a_new_lever_arm_moves_the_lines_and_undo_moves_them_back(picked: Driver):
    open_step(picked, 0)
    panel = picked.window.data
    line = picked.project.lines[0].name
    before = picked.viewport.clouds[line][:100].copy()
    field = panel.lever_arm.fields[2]
    field.setFocus()
    field.selectAll()
    picked.bot.keyClicks(field, "3.173")
    picked.bot.keyClick(field, Key.Key_Tab)
    picked.rest()
    assert picked.project.settings.lever_arm[2] == pytest.approx(3.173)
    moved = np.linalg.norm(picked.viewport.clouds[line][:100] - before, axis=1)
    assert moved == pytest.approx(np.ones(100), abs=1e-6)
    press(picked, Key.Key_Z, Control)
    picked.rest()
    assert picked.viewport.clouds[line][:100] == pytest.approx(before, abs=1e-9)
    assert field.value() == pytest.approx(2.173)


@LONG
@pytest.mark.usefixtures("reads_files")
def test_a_closed_window_is_hidden_before_its_tasks_have_ended(
    driver: Driver, picked_folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Cancelled work may take seconds to stop, and the window used to stay visible meanwhile."""
    window = driver.window
    window.open_project(picked_folder)
    driver.bot.waitUntil(lambda: window.document.project is not None, timeout=WAIT_MS)
    driver.rest()
    press(driver, Key.Key_F9)
    assert window.runner.busy
    states, hide = [], window.hide

    def hide_and_note() -> None:
        hide()
        states.append((window.isVisible(), window.runner.busy))

    monkeypatch.setattr(window, "hide", hide_and_note)
    window.close()
    assert states == [(False, True)]
    assert not window.runner.active
