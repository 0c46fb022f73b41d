"""Tests of the import dialogue by mouse and keyboard: drop, choose and correct files."""

from pathlib import Path

import laspy
import numpy as np
import pytest
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QComboBox, QWidget
from pytestqt.qtbot import QtBot

from lispac.gui.app.settings import AppSettings
from lispac.gui.features.open_project.import_survey.file_table import ROLE, STATE
from lispac.gui.features.open_project.import_survey.import_dialog import (
    MOUNTING,
    TIMELINE,
    ImportDialog,
)
from lispac.gui.features.open_project.import_survey.timeline import timeline_bars
from lispac.messages import Action
from lispac.workflow.project.projects import create_project
from tests.gui.import_support import drop, raw, rest, shifted, texts
from tests.gui.support import WAIT_MS, Demo, Key, Left, finish_layouts
from tests.support.long_runs import LONG
from tests.support.message_codes import is_shown


@LONG
def test_the_maximum_range_may_have_a_comma_and_a_unit(
    filled: ImportDialog, qtbot: QtBot, demo: Demo
) -> None:
    filled.table.select(raw(demo)[-1])
    rest(qtbot, filled)
    texts_shown = {"0,25 km": "250", "150,5": "150.5", "200 m": "200", "far": "far"}
    for typed, shown in texts_shown.items():
        field = filled.file_page.options.fields["max_range"]
        field.setFocus()
        field.selectAll()
        qtbot.keyClicks(field, typed)
        qtbot.keyClick(field, Key.Key_Return)
        rest(qtbot, filled)
        assert filled.file_page.options.fields["max_range"].text() == shown
        assert any(
            dict(line.reading.options).get("max_range") == shown
            for line in filled.input_files.lines
        )


# -- files in --------------------------------------------------------------------------------------


def test_an_empty_dialogue_lists_the_required_files(dialog: ImportDialog) -> None:
    assert dialog.empty.isVisible()
    assert not dialog.ok.isEnabled()
    assert dialog.reason.text().startswith("Add the files of the survey")


def test_dropped_files_become_a_project(
    filled: ImportDialog, qtbot: QtBot, demo: Demo, tmp_path: Path
) -> None:
    assert texts(filled, ROLE) == ["Trajectory", "Accuracy", *["Line"] * 6]
    assert set(texts(filled, STATE)) <= {"OK", "1 warning", "2 warnings"}
    assert filled.ok.isEnabled(), filled.reason.text()
    assert "lever arm is zero" in filled.reason.text()
    assert not filled.mounting.pos_sigmas.position.isEnabled()
    data, proposed = raw(demo)[0].parent, Path(filled.folder.text())
    assert proposed.parent == data.parent, "beside the raw data"
    assert not proposed.exists()

    filled.folder.selectAll()
    qtbot.keyClicks(filled.folder, str(demo.project.folder))
    assert not filled.ok.isEnabled()
    assert "already contains a project" in filled.reason.text()
    filled.folder.selectAll()
    qtbot.keyClicks(filled.folder, str(tmp_path / "made"))

    filled.tabs.setCurrentIndex(MOUNTING)
    field = filled.mounting.lever_arm.fields[2]
    field.selectAll()
    qtbot.keyClicks(field, "2.173")
    assert filled.reason.text() == ""
    qtbot.mouseClick(filled.ok, Left)
    assert filled.result() == ImportDialog.DialogCode.Accepted
    request = filled.request()
    made = create_project(
        request.folder, trajectory=request.trajectory, lines=request.lines,
        settings=request.settings, accuracy=request.accuracy,
    )  # fmt: skip
    assert [line.name for line in made.lines] == [line.name for line in demo.project.lines]
    assert made.settings.lever_arm == (0.0, 0.0, 2.173)


def test_a_folder_is_searched_and_unknown_files_are_listed_with_the_reason(
    dialog: ImportDialog, qtbot: QtBot, demo: Demo, tmp_path: Path
) -> None:
    (tmp_path / "field").mkdir()
    (tmp_path / "field" / "letter.txt").write_text("Dear surveyor, these are the files.\n")
    (tmp_path / "field" / "notes.doc").write_bytes(b"\xd0\xcf\x11\xe0" + bytes(500))
    shifted(demo.project.lines[0].path, tmp_path / "field" / "L1.laz", 0.0)
    drop(dialog, [tmp_path / "field"])
    rest(qtbot, dialog)
    assert texts(dialog, ROLE) == ["Line", "Not imported", "Not imported"]
    assert texts(dialog, STATE)[1:] == ["Unknown", "Unknown"]
    dialog.table.selectRow(1)
    shown = [label.text() for label in dialog.file_page.messages.findChildren(QWidget)
             if hasattr(label, "text")]  # fmt: skip
    assert any(is_shown("import.unknown_format", text) for text in shown)
    assert "The trajectory is missing" in dialog.reason.text()


@LONG
def test_the_examination_can_be_stopped_and_resumed(
    dialog: ImportDialog, qtbot: QtBot, demo: Demo
) -> None:
    drop(dialog, raw(demo))
    qtbot.waitUntil(lambda: any(e.pending for e in dialog.input_files.files), timeout=WAIT_MS)
    assert dialog.stop.isVisible()
    qtbot.mouseClick(dialog.stop, Left)
    rest(qtbot, dialog)
    assert "Unknown" in texts(dialog, STATE)
    assert not dialog.ok.isEnabled()
    qtbot.mouseClick(dialog.again, Left)
    rest(qtbot, dialog)
    assert "Unknown" not in texts(dialog, STATE)
    assert dialog.ok.isEnabled(), dialog.reason.text()


@LONG
def test_roles_are_chosen_and_files_removed_by_keys(filled: ImportDialog, qtbot: QtBot) -> None:
    combo = filled.table.cellWidget(7, ROLE)
    assert isinstance(combo, QComboBox)
    combo.setFocus()
    qtbot.keyClicks(combo, "No")
    rest(qtbot, filled)
    assert texts(filled, ROLE)[7] == "Not imported"
    assert len(filled.input_files.lines) == 5
    filled.table.setFocus()
    filled.table.selectRow(7)
    qtbot.keyClick(filled.table, Key.Key_Delete)
    assert filled.table.rowCount() == 7


# -- corrections -----------------------------------------------------------------------------------


def test_lines_in_another_time_base_are_corrected_by_a_button(
    dialog: ImportDialog, qtbot: QtBot, demo: Demo, tmp_path: Path
) -> None:
    lines = [line.path for line in demo.project.lines]
    late = [shifted(lines[k], tmp_path / f"day{k}.laz", -86_400.0) for k in (2, 3)]
    drop(dialog, [demo.project.trajectory, lines[0], *late])
    rest(qtbot, dialog)
    dialog.tabs.setCurrentIndex(TIMELINE)
    assert dialog.tabs.tabText(TIMELINE) == "Timeline (2 lines to check)"
    bars = timeline_bars(dialog.input_files)
    assert [bar.is_usable for bar in bars] == [True, True, False, False]
    assert bars[2].text == "100.0 % outside trajectory"
    assert not dialog.ok.isEnabled()
    assert dialog.timeline.all.isVisible()
    first = dialog.timeline.messages.buttons[0]
    assert first.text() == "Add +86400 s"
    qtbot.mouseClick(first, Left)
    rest(qtbot, dialog)
    assert dialog.input_files.file(late[0]).shift == pytest.approx(86_400)
    dialog.work.edit(dialog.input_files.with_action(late[0], Action("clear_shift")))
    qtbot.mouseClick(dialog.timeline.all, Left)
    rest(qtbot, dialog)
    assert dialog.ok.isEnabled(), dialog.reason.text()
    request = dialog.request()
    assert [line.reading.time_shift for line in request.lines] == [0, 86_400, 86_400]


def test_a_line_is_excluded_by_its_button_and_the_timeline_obeys_keys(
    dialog: ImportDialog, qtbot: QtBot, demo: Demo, tmp_path: Path
) -> None:
    far = shifted(demo.project.lines[2].path, tmp_path / "far.laz", 9999.9)
    other = shifted(demo.project.lines[1].path, tmp_path / "other.laz", 7777.7)
    drop(dialog, [demo.project.trajectory, demo.project.lines[0].path, far, other])
    rest(qtbot, dialog)
    dialog.tabs.setCurrentIndex(TIMELINE)
    view = dialog.timeline.view
    view.setFocus()
    for _ in range(4):
        qtbot.keyClick(view, Key.Key_Down)
    assert dialog.table.current == other
    assert "after" in view.accessibleDescription() or "outside" in view.accessibleDescription()
    for excluded in (other, far):  # the last button belongs to the last line
        button = dialog.timeline.messages.buttons[-1]
        assert button.text() == "Exclude the file"
        qtbot.mouseClick(button, Left)
        rest(qtbot, dialog)
        assert dialog.input_files.file(excluded).role is None
    assert dialog.ok.isEnabled(), dialog.reason.text()


def test_the_longest_gap_is_set_beside_the_timeline(filled: ImportDialog, qtbot: QtBot) -> None:
    filled.tabs.setCurrentIndex(TIMELINE)
    gap = filled.timeline.gap
    assert gap.value() == 1.5
    gap.setFocus()
    gap.selectAll()
    qtbot.keyClicks(gap, "4")
    qtbot.keyClick(gap, Key.Key_Return)
    assert filled.isVisible()  # Enter accepts the value and does not close the dialogue
    assert filled.request().settings.longest_gap == 4.0


def test_columns_are_chosen_over_the_preview_and_remembered(
    dialog: ImportDialog, qtbot: QtBot, demo: Demo, tmp_path: Path
) -> None:
    las = laspy.read(demo.project.lines[0].path)
    rows = np.column_stack([las.gps_time, las.x, las.y, las.z])[:300]
    text = tmp_path / "line.txt"
    np.savetxt(text, rows, fmt="%.5f")
    drop(dialog, [demo.project.trajectory, text])
    rest(qtbot, dialog)
    dialog.table.selectRow(1)
    assert is_shown("import.columns_not_chosen", dialog.reason.text())
    assert "time, X coordinate, Y coordinate and Z coordinate" in dialog.reason.text()
    for column, letter in enumerate("txyz"):
        combo = dialog.file_page.preview.combos[column]
        combo.setFocus()
        QTest.qWait(1)
        qtbot.keyClicks(combo, letter)
        rest(qtbot, dialog)
    assert texts(dialog, STATE)[1] == "OK", dialog.reason.text()
    assert dialog.ok.isEnabled(), dialog.reason.text()
    qtbot.mouseClick(dialog.ok, Left)
    kept = AppSettings(tmp_path / "settings.ini").column_mappings()
    assert list(kept.values()) == ["time x y z"]

    np.savetxt(tmp_path / "next.txt", rows[::2], fmt="%.5f")
    second = ImportDialog(AppSettings(tmp_path / "settings.ini"))
    second.add([demo.project.trajectory, tmp_path / "next.txt"])
    rest(qtbot, second)
    assert second.input_files.files_problem() is None
    second.done(0)
    second.deleteLater()


def test_a_coordinate_system_is_typed_and_its_name_shown(
    dialog: ImportDialog, qtbot: QtBot, demo: Demo, tmp_path: Path
) -> None:
    header = laspy.LasHeader(point_format=6, version="1.4")
    header.scales, header.offsets = np.full(3, 1e-3), np.array([613_000.0, 5_039_000.0, 0.0])
    las = laspy.LasData(header)
    first = laspy.read(demo.project.lines[0].path)
    count = 500
    las.x, las.y = 613_100 + np.arange(count) % 9, 5_039_600 + np.arange(count) % 7
    las.z, las.gps_time = np.zeros(count), np.asarray(first.gps_time)[:count]
    las.write(tmp_path / "map.laz")
    drop(dialog, [demo.project.trajectory, tmp_path / "map.laz"])
    rest(qtbot, dialog)
    dialog.table.selectRow(1)
    rest(qtbot, dialog)
    button = dialog.file_page.messages.buttons[0]
    assert button.text() == "Choose the coordinate system"
    qtbot.mouseClick(button, Left)
    field = dialog.file_page.options.fields["crs"]
    assert field.hasFocus()
    qtbot.keyClicks(field, "99999")
    qtbot.keyClick(field, Key.Key_Return)
    rest(qtbot, dialog)
    system = dialog.file_page.options.system
    assert is_shown("crs.unknown", system.text())
    field.selectAll()
    qtbot.keyClicks(field, "32618")
    qtbot.keyClick(field, Key.Key_Return)
    rest(qtbot, dialog)
    assert "WGS 84 / UTM zone 18N (EPSG:32618)" in system.text()
    assert dict(dialog.input_files.lines[0].reading.options)["crs"] == "32618"


def test_a_damaged_file_is_an_error_with_its_name_and_can_be_removed(
    filled: ImportDialog, qtbot: QtBot, tmp_path: Path
) -> None:
    damaged = tmp_path / "L9.laz"
    damaged.write_text("These are words, not points.\n")
    drop(filled, [damaged])
    rest(qtbot, filled)
    filled.table.select(damaged)
    row = filled.table.currentRow()
    assert texts(filled, STATE)[row] == "Error"
    tip = filled.table.item(row, STATE).toolTip()
    assert "L9.laz" in tip
    (shown,) = filled.input_files.messages(filled.input_files.file(damaged))
    assert shown.code == "import.not_of_its_format"
    assert filled.ok.isEnabled(), "the other files can be imported"


@LONG
def test_the_mounting_page_scrolls_to_the_end_of_its_content_only(
    filled: ImportDialog, qtbot: QtBot
) -> None:
    filled.tabs.setCurrentIndex(MOUNTING)
    page = filled.mounting
    for text in ("0.186", "0.038", "2.419"):
        field = page.lever_arm.fields[("0.186", "0.038", "2.419").index(text)]
        qtbot.mouseClick(field.lineEdit(), Left)
        field.selectAll()
        qtbot.keyClicks(field, text)
        qtbot.keyClick(field, Key.Key_Tab)
    for size in ((1180, 700), (1000, 640)):
        filled.resize(*size)
        finish_layouts()
        body = page.widget()
        bar = page.verticalScrollBar()
        bar.setValue(bar.maximum())
        needed = body.layout().heightForWidth(body.width())
        assert body.height() <= max(needed, page.viewport().height()) + 1
