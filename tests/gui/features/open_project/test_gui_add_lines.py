"""Tests of adding lines to the open project: by drop or by menu, and undone."""

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialogButtonBox, QMessageBox, QPushButton

from lispac.errors import InputError, ProjectError
from lispac.gui.features.open_project.import_survey.file_table import FORMAT, ROLE
from lispac.gui.features.open_project.import_survey.import_dialog import AddLinesDialog
from lispac.gui.window.dialogs import Dialogs
from lispac.project import LineSource, Project
from lispac.workflow.project.projects import open_project, save_project, with_lines_added
from tests.gui.import_support import drop, shifted
from tests.gui.support import WAIT_MS, Control, Demo, Driver, Key, Left, press
from tests.support.error_codes import has_code
from tests.support.message_codes import is_shown


@pytest.fixture
def shorter(demo: Demo, demo_copy: Path) -> Project:
    """The demo survey picked on four of its six lines, saved."""
    lines = demo.picked.lines[:4]
    names = {line.name for line in lines}
    targets = tuple(
        replace(t, sightings=tuple(s for s in t.sightings if s.line in names))
        for t in demo.picked.targets
    )
    made = replace(demo.picked, folder=demo_copy, lines=lines, targets=targets)
    save_project(made)
    return open_project(demo_copy)


@pytest.fixture
def short(driver: Driver, shorter: Project) -> Driver:
    """A window with the project of four lines."""
    driver.window.open_project(shorter.folder)
    driver.rest()
    assert driver.dialogs.errors == []
    return driver


MAX_POLLS = 600


class RealDialogs(Dialogs):
    """The real dialogues, driven by a timer: the question first, then the import dialogue."""

    def __init__(self, driver: Driver, button_text: str, drive: Callable[[AddLinesDialog], None]):
        super().__init__()
        self.parent = driver.window
        self.button_text, self.drive = button_text, drive
        self.questions: list[str] = []
        self.polls = 0
        self.timer = QTimer(driver.window)
        self.timer.timeout.connect(self._poll)
        self.timer.start(50)
        driver.dialogs.ask_to_add, driver.dialogs.add_lines = (
            self.ask_to_add,
            self.add_lines,
        )

    def _poll(self) -> None:
        shown = QApplication.activeModalWidget()
        if shown is None:
            return
        self.polls += 1
        if self.polls > MAX_POLLS:  # an unexpected dialogue: do not wait for ever
            shown.reject()
        elif isinstance(shown, QMessageBox):
            self.questions.append(shown.text())
            button = next(
                b for b in shown.findChildren(QPushButton) if b.text() == self.button_text
            )
            QTest.mouseClick(button, Left)
        elif isinstance(shown, AddLinesDialog) and not shown.work.busy:
            self.drive(shown)


def test_files_dropped_on_an_open_project_are_added_to_it(
    short: Driver, demo: Demo, shorter: Project
) -> None:
    new = [line.path for line in demo.project.lines[4:]]
    shown_values: list[object] = []

    def drive(dialog: AddLinesDialog) -> None:
        table = dialog.table
        shown_values[:] = [
            dialog.windowTitle(), dialog.ok.text(), dialog.place.isVisible(),
            [table.item(row, 0).text() for row in range(table.rowCount())],
            [table.cellWidget(0, column) for column in (ROLE, FORMAT)],
            dialog.input_files.files_problem(), dialog.remove.isEnabled(),
        ]  # fmt: skip
        QTest.mouseClick(dialog.ok, Left)

    dialogs = RealDialogs(short, "Add to harbour", drive)
    drop(short.window, new)
    short.bot.waitUntil(lambda: len(short.project.lines) == 6, timeout=WAIT_MS)
    short.rest()
    (question,) = dialogs.questions
    assert "harbour" in question
    names = [shorter.trajectory.name, shorter.accuracy.name]
    assert shown_values == [
        "Add lines to harbour", "Add to project", False, names + [p.name for p in new],
        [None, None], None, False,
    ]  # fmt: skip
    assert short.dialogs.errors == []
    assert [line.path for line in short.project.lines[4:]] == new
    assert [t.name for t in short.project.targets] == [t.name for t in shorter.targets]
    assert list(short.viewport.clouds) == [line.name for line in short.project.lines]
    assert len(open_project(shorter.folder).lines) == 4

    short.window.activateWindow()
    short.bot.waitUntil(short.window.isActiveWindow, timeout=WAIT_MS)
    press(short, Key.Key_Z, Control)
    short.rest()
    assert len(short.project.lines) == 4
    assert len(short.viewport.clouds) == 4
    press(short, Key.Key_Y, Control)
    short.rest()
    assert len(short.viewport.clouds) == 6
    press(short, Key.Key_S, Control)
    assert len(open_project(shorter.folder).lines) == 6


def test_files_that_cannot_be_added_are_reported_in_the_dialogue(
    short: Driver, shorter: Project, tmp_path: Path
) -> None:
    late = shifted(shorter.lines[1].path, tmp_path / "late.laz", 90_000.0)
    reasons: list[str] = []

    def drive(dialog: AddLinesDialog) -> None:
        reasons.append(dialog.reason.text())
        assert not dialog.ok.isEnabled()
        short.bot.mouseClick(dialog.buttons.button(QDialogButtonBox.StandardButton.Cancel), Left)

    RealDialogs(short, "Add to harbour", drive)
    drop(short.window, [shorter.lines[0].path])
    short.bot.waitUntil(lambda: len(reasons) == 1, timeout=WAIT_MS)
    drop(short.window, [late])
    short.bot.waitUntil(lambda: len(reasons) == 2, timeout=WAIT_MS)
    short.window.actions_["add_lines"].trigger()
    short.bot.waitUntil(lambda: len(reasons) == 3, timeout=WAIT_MS)
    name = shorter.lines[0].name
    assert is_shown("import.already_in_project", reasons[0])
    assert name in reasons[0]
    assert "late.laz" in reasons[1]
    assert "trajectory" in reasons[1]
    assert is_shown("import.no_lines_added", reasons[2])
    assert short.project.lines == shorter.lines
    assert not short.window.isWindowModified()


@pytest.mark.parametrize(("choice", "is_new"), [("cancel", False), ("new", True)])
def test_dropped_files_may_also_be_a_new_project(short: Driver, demo: Demo, choice, is_new) -> None:
    short.dialogs.drop_choice = choice
    line = demo.project.lines[5].path
    drop(short.window, [line])
    short.bot.waitUntil(lambda: bool(short.dialogs.requests), timeout=WAIT_MS)
    assert short.dialogs.requests == ["harbour"]
    assert short.dialogs.dropped == ([line] if is_new else [])
    assert len(short.project.lines) == 4


def test_a_line_that_cannot_be_read_leaves_project_and_folder_as_they_are(
    shorter: Project, tmp_path: Path
) -> None:
    kept = shorter.folder / "lines" / "notes.txt"
    kept.parent.mkdir()
    kept.write_text("mine")
    late = shifted(shorter.lines[1].path, tmp_path / "late.laz", 90_000.0)
    before = sorted(shorter.folder.rglob("*"))
    with pytest.raises(InputError, check=has_code("import.after_trajectory")):
        with_lines_added(shorter, [LineSource("late", late)])
    with pytest.raises(InputError) as raised:
        with_lines_added(shorter, [LineSource(shorter.lines[0].name, late)])
    assert raised.value.code == "project_line.same_name"
    with pytest.raises(
        ProjectError, check=has_code("project_line.known", line=shorter.lines[0].name)
    ):
        with_lines_added(shorter, [LineSource("again", shorter.lines[0].path)])
    assert sorted(shorter.folder.rglob("*")) == before
    assert kept.read_text() == "mine"
