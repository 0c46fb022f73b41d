"""Tests of the export dialogue and of the exported files."""

import dataclasses
from functools import partial
from pathlib import Path

import laspy
import numpy as np
import pytest
from PySide6.QtWidgets import QDialogButtonBox, QFileDialog, QMessageBox
from pytestqt.qtbot import QtBot

from lispac.gui.app import questions
from lispac.gui.app.actions import dialog_title
from lispac.gui.features.export.actions import ACTIONS
from lispac.gui.features.export.export_dialog import (
    BORESIGHT_TITLES,
    CHECK_DELAY_MS,
    CONTENT_TITLES,
    TRAJECTORY_TITLES,
    ExportDialog,
)
from lispac.gui.features.report.dialogs import ReportDialogs
from lispac.io.project.project_file import read_project
from lispac.project import LineSource, Project, Settings
from lispac.workflow.output.export_request import FILE_TYPES, ExportRequest, export, output_paths
from lispac.workflow.project.output_crs import utm_zone
from tests.gui.support import Control, Demo, Driver, Key, Left, click_in_box, press, use_next_dialog
from tests.support.cloud_files import track
from tests.support.long_runs import LONG
from tests.support.message_codes import is_shown
from tests.workflow.output.test_target_systems import ITRF, NAD83, on_map

Shift = Control.__class__.ShiftModifier


@pytest.fixture
def dialog(qtbot: QtBot, demo: Demo, estimated: Project, tmp_path: Path) -> ExportDialog:
    """Export dialogue of the demo survey after an adjustment."""
    project = dataclasses.replace(estimated, folder=tmp_path / "here")
    made = ExportDialog("lines", "estimated", project, demo.survey.trajectory)
    qtbot.addWidget(made)
    made.show()
    return made


def ok(dialog: ExportDialog):
    """OK button of the dialogue."""
    return dialog.buttons.button(QDialogButtonBox.StandardButton.Ok)


def test_the_dialogue_proposes_the_zone_and_explains_it(dialog: ExportDialog, demo: Demo) -> None:
    request = dialog.request()
    assert dialog.windowTitle() == dialog_title(ACTIONS["lines"])
    assert request.system == utm_zone(demo.survey.trajectory)
    assert (request.what, request.which, request.form) == ("lines", "estimated", "laz")
    assert request.output == dialog._project.folder / "export"
    assert "UTM zone" in dialog.message_label.text()
    dialog.system.setCurrentIndex(dialog.system.count() - 1)
    assert dialog.request().system == "local"
    assert "north, west and up" in dialog.message_label.text()
    dialog.system.setCurrentIndex(0)
    assert is_shown("assumed.datum", dialog.message_label.text())
    assert is_shown("export.epoch", dialog.message_label.text())
    dialog.what.setCurrentIndex(list(CONTENT_TITLES).index("trajectory"))
    assert dialog.message_label.isVisible()
    assert is_shown("export.trajectory_datum", dialog.message_label.text())


def test_an_invalid_coordinate_system_is_reported_while_typing(
    dialog: ExportDialog, qtbot: QtBot
) -> None:
    field = dialog.system.lineEdit()
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "EPSG:2")
    assert not ok(dialog).isEnabled()
    qtbot.wait(CHECK_DELAY_MS + 200)
    assert not ok(dialog).isEnabled()
    assert "EPSG:2" in dialog.message_label.text()
    qtbot.keyClicks(field, "959")
    qtbot.waitUntil(ok(dialog).isEnabled)
    assert "NAD83(CSRS)" in dialog.message_label.text()
    assert dialog.request().system == "EPSG:2959"
    dialog.folder.selectAll()
    qtbot.keyClick(dialog.folder, Key.Key_Delete)
    assert not ok(dialog).isEnabled()


def test_a_system_of_another_part_of_the_world_gives_a_warning(
    dialog: ExportDialog, qtbot: QtBot
) -> None:
    dialog.system.lineEdit().setText("EPSG:32660")
    dialog._check_input()
    assert dialog.message_label.property("role") == "error"
    assert is_shown("crs.meant_elsewhere", dialog.message_label.text())
    assert "EPSG:32618" in dialog.message_label.text()
    dialog.system.lineEdit().setText("EPSG:32619")  # the next zone, as a survey near its edge has
    dialog._check_input()
    assert not is_shown("crs.meant_elsewhere", dialog.message_label.text())
    dialog.height.setText("5703")
    dialog.system.setCurrentIndex(dialog.system.count() - 1)
    qtbot.waitUntil(lambda: not dialog.height.isEnabled())
    assert dialog.request().height == ""


def test_each_kind_of_export_has_its_own_fields(dialog: ExportDialog, qtbot: QtBot) -> None:
    for what in CONTENT_TITLES:
        dialog.what.setCurrentIndex(list(CONTENT_TITLES).index(what))
        assert dialog.system.isVisible() == (what in ("lines", "targets"))
        assert dialog.boresight.isVisible() == ("trajectory" not in what)
        assert dialog.trajectory.isVisible() == (what == "lines")
        assert dialog.form.count() == len(FILE_TYPES[what])
    dialog.what.setCurrentIndex(list(CONTENT_TITLES).index("trajectory"))
    dialog.form.setCurrentIndex(1)
    assert dialog.request().output.name.endswith("_export.txt")
    with qtbot.waitSignal(dialog.accepted):
        qtbot.mouseClick(ok(dialog), Left)


def test_the_corrected_trajectory_is_offered_with_its_support(dialog: ExportDialog) -> None:
    assert dialog.request().trajectory_choice == "given"
    dialog.trajectory.setCurrentIndex(list(TRAJECTORY_TITLES).index("corrected"))
    assert dialog.request().trajectory_choice == "corrected"
    assert is_shown("corrections.support", dialog.message_label.text())
    assert ok(dialog).isEnabled()
    dialog.boresight.setCurrentIndex(list(BORESIGHT_TITLES).index("prior"))
    assert is_shown("corrections.prior_boresight", dialog.message_label.text())
    assert not ok(dialog).isEnabled()
    dialog.what.setCurrentIndex(list(CONTENT_TITLES).index("corrected_trajectory"))
    assert is_shown("corrections.support", dialog.message_label.text())
    assert ok(dialog).isEnabled()
    request = dialog.request()
    assert request.output.name.endswith("_corrected.out")
    assert request.trajectory_choice == "given"


@LONG
def test_the_corrected_trajectory_is_written(adjusted: Driver, tmp_path: Path) -> None:
    request = ExportRequest("corrected_trajectory", tmp_path / "c.out", form="sbet")
    adjusted.dialogs.export_request = request
    adjusted.window.actions_["corrected_trajectory"].trigger()
    adjusted.rest()
    names = sorted(path.name for path in tmp_path.glob("c*"))
    assert names == ["c.out", "c_corrections.csv", "c_smrmsg.out"]
    assert not adjusted.dialogs.errors


def test_the_corrected_trajectory_is_not_written_without_an_estimate(
    qtbot: QtBot, demo: Demo
) -> None:
    dialog = ExportDialog("corrected_trajectory", "estimated", demo.project, demo.survey.trajectory)
    qtbot.addWidget(dialog)
    assert dialog.windowTitle() == dialog_title(ACTIONS["corrected_trajectory"])
    assert is_shown("project.not_estimated", dialog.message_label.text())
    assert not ok(dialog).isEnabled()


def test_only_the_prior_is_offered_without_an_estimate(qtbot: QtBot, demo: Demo) -> None:
    dialog = ExportDialog("lines", "estimated", demo.project, demo.survey.trajectory)
    qtbot.addWidget(dialog)
    assert dialog.request().which == "prior"
    assert not dialog.boresight.isEnabled()


@LONG
def test_the_requested_exports_are_written(picked: Driver, tmp_path: Path) -> None:
    zone = utm_zone(picked.window.document.survey.trajectory)
    picked.dialogs.export_request = ExportRequest("lines", tmp_path / "l", "prior", "laz", zone)
    press(picked, Key.Key_E, Control | Shift)
    picked.rest()
    names = sorted(path.name for path in (tmp_path / "l").iterdir())
    assert names == sorted(f"{line.name}_prior.laz" for line in picked.project.lines)
    cloud = laspy.read(tmp_path / "l" / names[0])
    assert cloud.header.parse_crs().to_epsg() == int(zone.split(":")[1])
    assert len(cloud) == len(picked.window.document.survey.scans[names[0][:-10]])
    log_text = picked.window.log.text() if hasattr(picked.window.log, "text") else ""
    for what, form in (("targets", "csv"), ("planes", "txt"), ("trajectory", "sbet")):
        output = tmp_path / what if what != "trajectory" else tmp_path / "t.out"
        picked.dialogs.export_request = ExportRequest(what, output, "prior", form)
        picked.window.actions_["trajectory" if what == "trajectory" else "targets"].trigger()
        picked.rest()
        assert output.exists(), log_text
    assert np.loadtxt(next((tmp_path / "planes").iterdir())).shape[1] == 25
    assert picked.dialogs.requests == ["lines", "targets", "targets", "trajectory"]
    assert not picked.dialogs.errors


def test_an_export_contains_unsaved_edits_and_keeps_them(picked: Driver, tmp_path: Path) -> None:
    """A project is saved when it is created, so only its edits can be unsaved."""
    window, folder = picked.window, picked.project.folder
    saved = {each.name for each in read_project(folder).targets}
    window.controller.rename("T1", "Quay")
    assert window.document.is_modified
    picked.dialogs.export_request = ExportRequest("targets", tmp_path / "t", "prior", "csv")
    window.actions_["targets"].trigger()
    picked.rest()
    assert any("Quay" in path.name for path in (tmp_path / "t").iterdir())
    assert window.document.is_modified
    assert picked.project.target("Quay")
    assert {each.name for each in read_project(folder).targets} == saved
    picked.dialogs.requests.clear()
    picked.dialogs.save_choice = "cancel"
    window.close()
    assert picked.dialogs.requests == [picked.project.name]
    assert window.isVisible()
    assert window.document.is_modified


def test_datum_and_epoch_of_the_lines_go_with_a_code(qtbot: QtBot, tmp_path: Path) -> None:
    reading = on_map(trajectory_datum=ITRF, epoch="2023.5")
    line = LineSource("one", tmp_path / "one.las", (), reading)
    project = Project(
        folder=tmp_path,
        trajectory=tmp_path / "sbet.out",
        lines=(line,),
        settings=Settings((0.0, 0.0, 0.0)),
    )
    dialog = ExportDialog("targets", "prior", project, track())
    qtbot.addWidget(dialog)
    dialog.show()
    request = dialog.request()
    assert (request.system, request.trajectory_datum, request.epoch) == ("", None, None)
    assert not dialog.datum.isEnabled()
    own = dialog.message_label.text()
    assert is_shown("assumed.datum_shift", own)
    assert "ITRF2014" in own
    dialog.system.lineEdit().setText(NAD83)
    dialog._check_input()
    request = dialog.request()
    assert (request.system, request.trajectory_datum, request.epoch) == (NAD83, ITRF, 2023.5)
    assert dialog.message_label.text() == own
    for field, text, words in (
        (dialog.epoch, "soon", "decimal year"),
        (dialog.epoch, "99999", "decimal year"),
        (dialog.epoch, "", "depends on time"),
        (dialog.datum, "EPSG:2", "EPSG:2"),
    ):
        good = field.text()
        field.setText(text)
        assert not ok(dialog).isEnabled()
        dialog._check_input()
        assert words in dialog.message_label.text()
        assert not ok(dialog).isEnabled()
        field.setText(good)
        dialog._check_input()
        assert ok(dialog).isEnabled()
    dialog.datum.clear()
    dialog._check_input()
    assert is_shown("export.epoch_without_datum", dialog.message_label.text())
    dialog.epoch.clear()
    dialog._check_input()
    assert dialog.request().trajectory_datum == ""
    assert is_shown("assumed.datum", dialog.message_label.text())


def test_lines_of_two_epochs_leave_the_choice_to_the_user(qtbot: QtBot, tmp_path: Path) -> None:
    lines = tuple(
        LineSource(name, tmp_path / f"{name}.las", (), on_map(trajectory_datum=ITRF, epoch=epoch))
        for name, epoch in (("one", "2023.5"), ("two", "2010.0"))
    )
    project = Project(
        folder=tmp_path,
        trajectory=tmp_path / "sbet.out",
        lines=lines,
        settings=Settings((0.0, 0.0, 0.0)),
    )
    dialog = ExportDialog("lines", "prior", project, track())
    qtbot.addWidget(dialog)
    assert dialog.system.itemData(0) == utm_zone(track())
    dialog.system.lineEdit().setText(NAD83)
    dialog._check_input()
    assert "datum differs between lines" in dialog.message_label.text()
    assert not ok(dialog).isEnabled()
    dialog.datum.setText(ITRF)
    dialog.epoch.setText("2010")
    dialog._check_input()
    assert ok(dialog).isEnabled()
    assert dialog.request().epoch == 2010.0


@pytest.mark.parametrize("what", CONTENT_TITLES)
def test_an_export_asks_before_it_replaces_files(
    dialog: ExportDialog, qtbot: QtBot, tmp_path: Path, what: str
) -> None:
    dialog.what.setCurrentIndex(list(CONTENT_TITLES).index(what))
    dialog.folder.setText(str(tmp_path))
    paths = output_paths(dialog._project, dialog.request())
    paths[-1].write_bytes(b"of an earlier export")
    asked: list[str] = []

    def answer(text: str, box: QMessageBox) -> None:
        asked.append(box.informativeText())
        click_in_box(box, text)

    use_next_dialog(partial(answer, "Cancel"))
    qtbot.mouseClick(ok(dialog), Left)
    assert dialog.isVisible()
    use_next_dialog(partial(answer, "Replace"))
    with qtbot.waitSignal(dialog.accepted):
        qtbot.mouseClick(ok(dialog), Left)
    assert asked == [str(paths[-1])] * 2


def test_the_files_of_an_export_are_those_written(demo: Demo, estimated: Project, tmp_path) -> None:
    for what, form in (
        ("targets", "csv"), ("planes", "txt"), ("trajectory", "sbet"),
        ("corrected_trajectory", "sbet"),
    ):  # fmt: skip
        folder = tmp_path / what
        folder.mkdir()
        output = folder if FILE_TYPES[what][0] in ("laz", "txt") else folder / "t.out"
        request = ExportRequest(what, output, form=form)
        written, _ = export(estimated, demo.survey, request)
        assert sorted(written) == sorted(output_paths(estimated, request))
        assert sorted(folder.iterdir()) == sorted(written)
    asked = ExportRequest("lines", tmp_path / "lines", form="laz")
    written, _ = export(estimated, demo.survey, asked)
    assert written == output_paths(estimated, asked)


@pytest.mark.parametrize(
    ("typed", "chosen", "saved"),
    [
        ("report", "PDF (*.pdf)", "report.pdf"),
        ("report 1.2", "PDF (*.pdf)", "report 1.2.pdf"),
        ("report.HTML", "PDF (*.pdf)", "report.HTML"),
        ("report", "unknown", "report.pdf"),
    ],
)
def test_a_completed_name_is_asked_about_if_the_file_exists(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, typed: str, chosen: str, saved: str
) -> None:
    """Qt asks about the typed name only."""
    names = iter([(str(tmp_path / typed), chosen), ("", "")])
    asked: list[Path] = []
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_args: next(names))
    monkeypatch.setattr(
        questions, "ask_to_replace", lambda paths, _parent: bool(asked.extend(paths))
    )
    dialogs = ReportDialogs()
    is_completed = typed != saved
    if is_completed:
        (tmp_path / saved).write_text("of an earlier export")
    found = dialogs.report_file(tmp_path / "start.pdf")
    assert found == (None if is_completed else tmp_path / saved)
    assert asked == ([tmp_path / saved] if is_completed else [])
