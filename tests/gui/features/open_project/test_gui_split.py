"""Tests of the import dialogue with a file of two scanners: warning, and split into lines."""

import json
from pathlib import Path

import laspy
import numpy as np
import pytest
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from lispac.cli.main import main
from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from lispac.project import Settings
from lispac.workflow.project.projects import new_project
from tests.gui.import_support import drop, rest
from tests.gui.support import Demo, Left


def two_scanners(line: Path, to: Path) -> Path:
    """Copy a line with points that belong alternately to two scanners."""
    las = laspy.read(line)
    las.user_data[:] = np.arange(len(las.points)) % 2
    las.write(to)
    return to


def shown_messages(dialog: ImportDialog) -> list[str]:
    return [label.text() for label in dialog.file_page.messages.findChildren(QLabel)
            if label.isVisible()]  # fmt: skip


@pytest.fixture
def survey(demo: Demo, dialog: ImportDialog, qtbot: QtBot, tmp_path: Path) -> Path:
    line = demo.project.lines[0].path
    path = two_scanners(line, tmp_path / "L9.laz")
    drop(dialog, [demo.project.trajectory, path])
    rest(qtbot, dialog)
    dialog.table.select(path)
    return path


def test_a_file_of_two_sources_is_split_by_a_click(
    survey: Path, dialog: ImportDialog, qtbot: QtBot, tmp_path: Path
) -> None:
    buttons = dialog.file_page.messages.buttons
    (split,) = [each for each in buttons if each.text().startswith("Split")]
    assert len(dialog.input_files.sources()) == 1
    qtbot.mouseClick(split, Left)
    rest(qtbot, dialog)
    lines = dialog.input_files.sources()
    assert [line.name for line in lines] == ["L9_0", "L9_1"]
    assert any("L9_0 and L9_1" in text for text in shown_messages(dialog))
    dialog.folder.setText(str(tmp_path / "project"))
    request = dialog.request()
    project, loaded = new_project(
        request.folder, trajectory=request.trajectory, lines=list(request.lines),
        settings=Settings(lever_arm=(0.0, 0.0, 0.0)),
        trajectory_reading=request.trajectory_reading,
    )  # fmt: skip
    whole = len(laspy.read(survey).points)
    assert [line.name for line in project.lines] == ["L9_0", "L9_1"]
    assert sum(len(scan) for scan in loaded.scans.values()) == whole
    codes = {each.code for each in loaded.messages}
    assert not codes & {"audit.several_sources", "audit.several_scanners"}


def test_a_split_can_be_undone(survey: Path, dialog: ImportDialog, qtbot: QtBot) -> None:
    (split,) = [
        each for each in dialog.file_page.messages.buttons if each.text().startswith("Split")
    ]
    qtbot.mouseClick(split, Left)
    rest(qtbot, dialog)
    (back,) = [
        each for each in dialog.file_page.messages.buttons if each.text() == "Keep as one line"
    ]
    qtbot.mouseClick(back, Left)
    rest(qtbot, dialog)
    assert [line.name for line in dialog.input_files.sources()] == ["L9"]


def test_findings_are_shown_before_the_project_is_made(
    demo: Demo, dialog: ImportDialog, qtbot: QtBot, tmp_path: Path
) -> None:
    """Findings about later points of a file: withheld points at its end, and a noise class."""
    line = demo.project.lines[0].path
    count = len(laspy.read(line).points)
    last = np.arange(count) >= count - 20
    path = tmp_path / "L8.laz"
    las = laspy.read(line)
    las.withheld[:] = last
    las.classification[:] = np.where(np.arange(count) % 100 == 99, 7, 1)
    las.write(path)
    drop(dialog, [demo.project.trajectory, path])
    rest(qtbot, dialog)
    dialog.table.select(path)
    texts = " ".join(shown_messages(dialog))
    view = dialog.file_page.messages
    assert view.height() >= min(len(view.buttons), 3) * view.buttons[0].height()
    assert "20 points" in texts
    assert "class 7" in texts
    (keep,) = [
        each for each in dialog.file_page.messages.buttons if each.text() == "Set withheld to keep"
    ]
    qtbot.mouseClick(keep, Left)
    rest(qtbot, dialog)
    assert dialog.input_files.file(path).options["withheld"] == "keep"
    assert "20 points" not in " ".join(shown_messages(dialog))


@pytest.mark.parametrize(("words", "found"), [([], True), (["--quick"], False)])
def test_inspect_audits_all_points_unless_quick(
    demo: Demo, tmp_path: Path, capsys: pytest.CaptureFixture[str], words: list[str], found: bool
) -> None:
    path = two_scanners(demo.project.lines[0].path, tmp_path / "L9.laz")
    assert main(["inspect", str(path), "--json", *words]) == 0
    shown = json.loads(capsys.readouterr().out)
    codes = [each["code"] for each in shown["formats"][0]["messages"]]
    assert ("audit.several_sources" in codes) == found
