"""Tests of the panel that converts the boresight to another program's convention."""

import json
from dataclasses import replace
from html import unescape
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtWidgets import QApplication, QComboBox, QDoubleSpinBox, QFileDialog
from pytestqt.qtbot import QtBot
from scipy.spatial.transform import Rotation

from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.conventions.convention_panel import TITLE, ConventionPanel
from lispac.gui.features.conventions.dialogs import ConventionDialogs
from lispac.gui.widgets.scanner_axes_view import ScannerAxesView, exaggeration_factor
from lispac.messages import note
from lispac.project import Project
from lispac.survey.conventions.conversion import ConventionSetup, convert_to_system
from lispac.survey.conventions.systems import SYSTEMS, Convention, convention_of_key
from lispac.workflow.output.installation import installation_formats
from lispac.workflow.project.survey import Survey
from tests.gui import by_hand
from tests.gui.support import Driver, Key, Left, click, show_panel
from tests.support.error_codes import has_code
from tests.support.long_runs import LONG

Calibrated = tuple[Project, Survey]


@pytest.fixture
def panel(qtbot: QtBot, qapp: QApplication) -> ConventionPanel:
    """The panel alone, with no project."""
    theme.apply_theme(qapp)
    made = ConventionPanel()
    made.resize(400, 1400)
    qtbot.addWidget(made)
    made.show()
    return made


def choose_entry(bot: QtBot, box: QComboBox, index: int) -> None:
    """Choose an entry of a list with the keys."""
    box.setFocus()
    bot.keyClick(box, Key.Key_Home)
    for _ in range(index):
        bot.keyClick(box, Key.Key_Down)
    assert box.currentIndex() == index


def choose(bot: QtBot, panel: ConventionPanel, key: str) -> None:
    choose_entry(bot, panel.system, [each.key for each in SYSTEMS].index(key))
    assert panel.convention.key == key


def type_in(bot: QtBot, field: QDoubleSpinBox, text: str) -> None:
    field.setFocus()
    field.selectAll()
    bot.keyClicks(field, text)
    bot.keyClick(field, Key.Key_Tab)


def type_boresight(bot: QtBot, panel: ConventionPanel, *angles: str) -> None:
    for field, text in zip(panel.inputs.boresight.fields, angles, strict=True):
        type_in(bot, field, text)


def rows(panel: ConventionPanel) -> dict[str, list[float]]:
    table = panel.table
    return {
        table.verticalHeaderItem(row).text(): [
            float(table.item(row, column).text().replace("−", "-")) for column in range(3)
        ]
        for row in range(table.rowCount())
    }


def heads(panel: ConventionPanel) -> list[str]:
    return [panel.table.horizontalHeaderItem(column).text() for column in range(3)]


def test_every_digit_can_be_read_and_copied(qtbot: QtBot, panel: ConventionPanel) -> None:
    phoenix = [each.key for each in SYSTEMS if each.name.startswith("Phoenix SpatialExplorer 1")]
    choose(qtbot, panel, phoenix[0])
    type_boresight(qtbot, panel, "0.13", "-0.12", "0.28")
    table = panel.table
    assert len(table.item(0, 1).text().split(".")[1]) == 8
    needed = sum(max(table.sizeHintForColumn(k), 0) for k in range(3))
    for column in range(3):
        assert table.columnWidth(column) >= table.sizeHintForColumn(column)
    assert needed > table.viewport().width()
    qtbot.waitUntil(table.horizontalScrollBar().isVisible)
    assert table.viewport().width() + table.horizontalScrollBar().maximum() >= needed
    last = table.rowCount() - 1
    assert table.viewport().height() >= table.rowViewportPosition(last) + table.rowHeight(last)
    qtbot.mouseClick(panel.copy_angles, Left)
    copied = [line.split("\t") for line in QApplication.clipboard().text().splitlines()]
    assert [name for name, _ in copied] == list(panel.convention.names)
    assert [float(value) for _, value in copied] == rows(panel)["Assumed angles"]


def test_no_status_is_shown_before_a_value_exists(qtbot: QtBot, panel: ConventionPanel) -> None:
    shown = (panel.status, panel.table, panel.mounting_text, panel.gizmo, panel.matrix, panel.lever)
    assert not any(each.isVisible() for each in shown)
    assert not panel.copy.isEnabled()
    assert not panel.copy_angles.isEnabled()
    choose(qtbot, panel, SYSTEMS[2].key)
    assert not panel.status.isVisible()
    type_in(qtbot, panel.inputs.boresight.fields[0], "0")  # zero is a value, too
    assert panel.status.isVisible()
    assert rows(panel)
    assert panel.gizmo.isVisible()
    assert panel.copy.isEnabled()


def test_angles_are_converted_without_a_project(qtbot: QtBot, panel: ConventionPanel) -> None:
    type_boresight(qtbot, panel, "0.13", "-0.12", "0.28")
    type_in(qtbot, panel.inputs.lever_arm.fields[0], "-0.186")
    assert panel.convention.key == "applanix"
    assert heads(panel) == ["Roll", "Pitch", "Heading"]
    assert rows(panel) == {"New angles": [0.13, 0.12, 0.28]}
    assert "is pitched 0.120° bow up" in panel.mounting_text.text()
    assert "is rolled 0.130° port side up" in panel.mounting_text.text()
    assert "0.186\u00a0m aft of" in panel.mounting_text.text()
    assert "Convention verified" in panel.status.text()
    assert theme.DONE in panel.status.text()
    assert not panel.assumption.isVisible()
    assert not panel.inputs.use_project.isEnabled()
    assert panel.inputs.source.text() == "User-defined values."


def test_every_system_shows_its_status_and_its_assumption(qtbot, panel) -> None:
    type_boresight(qtbot, panel, "0.4", "-1.9", "0.4")
    for system in SYSTEMS:
        choose(qtbot, panel, system.key)
        assert_system_is_shown(panel, convention_of_key(system.key))


def assert_system_is_shown(panel, convention) -> None:
    word = {
        "verified": "Convention verified",
        "partly": "partly",
        "unverified": "Convention not verified",
    }
    assert word[convention.status] in panel.status.text()
    assert panel.assumption.isVisible() == bool(convention.assumption)
    assert convention.assumption in panel.assumption.text()
    assert panel.table.isVisible() == convention.has_angles
    if convention.has_angles:
        converted = convert_to_system(panel.inputs.mounting, ConventionSetup(convention))
        (label, shown), *_ = rows(panel).items()
        assert label == ("New angles" if convention.status == "verified" else "Assumed angles")
        np.testing.assert_allclose(shown, np.degrees(converted.angles), atol=5.1e-5)
        assert heads(panel) == [name.capitalize() for name in convention.names]
    assert panel.imu.isVisible() == convention.open_axes


def test_the_correction_to_the_present_angles_is_shown(
    qtbot: QtBot, panel: ConventionPanel
) -> None:
    type_boresight(qtbot, panel, "0.125", "-1.192", "0.276")
    assert not panel.current.fields.isVisible()
    qtbot.mouseClick(panel.current.known, Left, pos=QPoint(8, panel.current.known.height() // 2))
    for field, text in zip(panel.current.fields.fields, ("0.1", "1.0", "-3"), strict=True):
        type_in(qtbot, field, text)
    shown = rows(panel)
    assert list(shown) == ["Current angles", "Correction", "New angles"]
    assert shown["Current angles"] == [0.1, 1.0, -3.0]
    assert shown["New angles"] == [0.125, 1.192, 0.276]
    assert "Do not add the correction" in panel.notes.text()
    assert "18 mm at 100 m" in panel.notes.text().replace("\u00a0", " ")
    qtbot.mouseClick(
        panel.current.applied, Left, pos=QPoint(8, panel.current.applied.height() // 2)
    )
    assert rows(panel)["New angles"] != [0.125, 1.192, 0.276]
    # Angles typed for one program are not used for another.
    choose(qtbot, panel, "novatel")
    assert rows(panel)["Current angles"] == [0.0, 0.0, 0.0]


def test_the_present_settings_are_typed_as_a_matrix(qtbot: QtBot, panel: ConventionPanel) -> None:
    type_boresight(qtbot, panel, "0.125", "-1.192", "0.276")
    current = panel.current
    for box in (current.known, current.as_matrix):
        qtbot.mouseClick(box, Left, pos=QPoint(8, box.height() // 2))
    assert current.matrix.isVisible()
    assert not current.fields.isVisible()
    assert "the matrix has 0 numbers" in panel.assumption.text()
    turn = Rotation.from_euler("ZYX", [-3, 1.0, 0.1], degrees=True).as_matrix()
    qtbot.mouseClick(current.matrix.viewport(), Left)
    qtbot.keyClicks(current.matrix, "; ".join(" ".join(f"{v:.10f}" for v in row) for row in turn))
    shown = rows(panel)
    assert shown["Current angles"] == [0.1, 1.0, -3.0]
    assert shown["New angles"] == [0.125, 1.192, 0.276]
    # PDAL has no angles, so only a matrix can be typed; the former values are cleared.
    choose(qtbot, panel, "pdal")
    assert current.matrix.isVisible()
    assert not current.as_matrix.isVisible()
    assert current.matrix.toPlainText() == ""
    qtbot.keyClicks(current.matrix, "1 0 0 0 1 0 0 0 1")
    assert "new = correction · current" in panel.notes.text()
    choose(qtbot, panel, "applanix")
    assert current.fields.isVisible()


def test_the_lever_arm_of_a_present_4x4_is_shown_and_kept(qtbot, panel: ConventionPanel) -> None:
    current = panel.current
    for box in (current.known, current.as_matrix):
        qtbot.mouseClick(box, Left, pos=QPoint(8, box.height() // 2))
    qtbot.mouseClick(current.matrix.viewport(), Left)
    qtbot.keyClicks(current.matrix, "1 0 0 0.12; 0 1 0 -0.34; 0 0 1 2.5; 0 0 0 1")
    text = panel.lever.text().replace("\u00a0", " ")
    assert text.count("X forward +0.1200 m, Y starboard −0.3400 m") == 2
    assert message_text(note("convention.lever_arm_kept")) in text
    assert "Correction of the 4x4 matrix" in panel.notes.text()
    # A lever arm typed here replaces that of the present matrix.
    type_in(qtbot, panel.inputs.lever_arm.fields[2], "-2.4")
    text = panel.lever.text().replace("\u00a0", " ")
    assert "Z down +2.4000 m" in text
    assert message_text(note("convention.lever_arm_replaced")) in text
    qtbot.mouseClick(panel.copy, Left)
    copied = np.array(QApplication.clipboard().text().split(), dtype=float).reshape(4, 4)
    np.testing.assert_allclose(copied[:3, 3], [0.0, 0.0, 2.4], atol=1e-12)


def test_the_matrix_is_copied_with_all_digits(qtbot: QtBot, panel: ConventionPanel) -> None:
    type_boresight(qtbot, panel, "0.4395", "-1.8681", "0.3992")
    type_in(qtbot, panel.inputs.lever_arm.fields[2], "2.4191")
    choose(qtbot, panel, "pdal")
    qtbot.mouseClick(panel.copy, Left)
    copied = np.array(QApplication.clipboard().text().split(), dtype=float).reshape(4, 4)
    converted = convert_to_system(panel.inputs.mounting, ConventionSetup(convention_of_key("pdal")))
    np.testing.assert_allclose(copied, converted.transform, atol=1e-12)


def test_the_axes_of_an_imu_are_chosen(qtbot: QtBot, panel: ConventionPanel) -> None:
    type_boresight(qtbot, panel, "1", "0", "0")
    choose(qtbot, panel, "phoenix")
    assert "Z up" in panel.rules.text()

    def pick(box: QComboBox, word: str) -> None:
        choose_entry(qtbot, box, box.findText(word))

    pick(panel.imu.y, "starboard")
    assert "X forward, Y starboard, Z down" in panel.rules.text()
    pick(panel.imu.x, "starboard")
    assert "are parallel or opposite" in panel.assumption.text()
    assert not panel.table.isVisible()
    assert not panel.copy.isEnabled()
    pick(panel.imu.y, "forward")
    assert panel.table.isVisible()
    assert panel.copy.isEnabled()
    assert "X starboard, Y forward, Z up" in panel.rules.text()


def test_invalid_scanner_axes_are_refused_with_a_message(qtbot, panel) -> None:
    choose(qtbot, panel, "hypack")
    type_boresight(qtbot, panel, "20", "-8", "30")
    assert panel.gizmo.isVisible()
    panel.scanner.setFocus()
    qtbot.keyClick(panel.scanner, Key.Key_Down)
    assert panel.scanner.currentData() == "kept"
    assert "left-handed" in panel.assumption.text()
    for widget in (panel.table, panel.gizmo, panel.status, panel.mounting_text):
        assert not widget.isVisible()
    choose(qtbot, panel, "applanix")
    assert panel.gizmo.isVisible()


def test_the_gizmo_exaggerates_small_rotations_and_shows_the_factor(qtbot, panel) -> None:
    assert exaggeration_factor(np.zeros(3)) == 1
    assert exaggeration_factor(np.radians([0.0, 0.12, 0.0])) == 200
    assert exaggeration_factor(np.radians([0.0, -1.2, 0.0])) == 20
    assert exaggeration_factor(np.radians([90.0, 0.0, 0.0])) == 1
    type_boresight(qtbot, panel, "0", "-1.2", "0")
    gizmo = panel.gizmo
    assert gizmo.factor == 20
    tip = gizmo.scanner_axes[0]
    assert np.degrees(np.arcsin(tip[2])) == pytest.approx(24.0), "bow up, twenty times"


@pytest.mark.parametrize("system", SYSTEMS, ids=lambda system: system.key)
def test_the_gizmo_shows_the_axes_of_the_chosen_program(
    qtbot: QtBot, panel: ConventionPanel, system: Convention
) -> None:
    choose(qtbot, panel, system.key)
    type_boresight(qtbot, panel, "20", "-8", "30")
    gizmo, converted = panel.gizmo, panel.replacement.in_system
    assert gizmo.factor == 1
    directions = {
        "forward": [1, 0, 0], "aft": [-1, 0, 0], "port": [0, 1, 0], "starboard": [0, -1, 0],
        "up": [0, 0, 1], "down": [0, 0, -1],
    }  # fmt: skip
    named = [directions[word] for word in converted.setup.axes]
    np.testing.assert_array_equal(gizmo.body_axes, named)
    assert np.linalg.det(gizmo.project(np.eye(3))) == pytest.approx(1.0), "the picture is mirrored"
    for index in range(panel.scanner.count()):
        panel.scanner.setCurrentIndex(index)
        if panel.replacement is None:  # left-handed axes
            assert not gizmo.isVisible()
            continue
        # Parts of the scanner axes along the body axes: the matrix from scanner to body
        rotation = gizmo.body_axes @ gizmo.scanner_axes.T
        expected = panel.replacement.in_system.transform[:3, :3]
        np.testing.assert_allclose(rotation, expected, atol=1e-9)


def test_the_gizmo_is_rotated_by_mouse_and_keys(qtbot: QtBot, qapp: QApplication) -> None:
    gizmo = ScannerAxesView()
    qtbot.addWidget(gizmo)
    gizmo.resize(340, 210)
    gizmo.show_boresight(np.radians([0.5, -1.0, 0.3]))
    gizmo.show()
    before, picture = gizmo.view_deg, gizmo.grab().toImage()
    forward = np.array([1.0, 0, 0])
    qtbot.mousePress(gizmo, Left, pos=QPoint(100, 100))
    qtbot.mouseMove(gizmo, QPoint(130, 110))
    qtbot.mouseRelease(gizmo, Left, pos=QPoint(130, 110))
    assert gizmo.view_deg == (before[0] - 15, before[1] + 5)
    assert gizmo.grab().toImage() != picture
    qtbot.keyClick(gizmo, Key.Key_Left)
    assert gizmo.view_deg[0] == before[0] - 10
    qtbot.mouseDClick(gizmo, Left)
    assert gizmo.view_deg == before
    for _ in range(40):
        qtbot.keyClick(gizmo, Key.Key_Down)
    right, above, towards = gizmo.project(np.array([0.0, 0, 1.0]))[0]
    assert towards > 0.99, "seen from above, up points at the eye"
    assert np.linalg.norm(gizmo.project(forward)) == pytest.approx(1.0)
    assert right == pytest.approx(0.0)
    assert above > 0


@LONG
def test_the_panel_shows_the_boresight_of_the_window(
    driver: Driver, calibrated: Calibrated
) -> None:
    project, survey = calibrated
    window, panel = driver.window, driver.window.panels["convention"]
    show_panel(window, TITLE)
    assert project.result is not None
    window.document.open(project, survey)
    driver.rest()
    assert panel.inputs.source.text() == f"Estimated boresight of {project.name}."
    np.testing.assert_array_equal(panel.inputs.mounting.boresight, project.result.boresight)
    roll, pitch, yaw = np.degrees(project.result.boresight)
    np.testing.assert_allclose(rows(panel)["New angles"], [roll, -pitch, yaw], atol=0.01)
    np.testing.assert_allclose(
        rows(panel)["1 sigma"], np.degrees(project.result.sigma), rtol=0.05, atol=1e-4
    )
    type_in(driver.bot, panel.inputs.boresight.fields[0], "5")
    assert "1 sigma" not in rows(panel), "nobody knows the sigma of a typed angle"
    # An edit that leaves the boresight alone leaves what was typed alone.
    validation = project.targets_of_role("validation")[0]
    window.controller.use_target(validation.name, False)
    driver.rest()
    assert panel.inputs.source.text() == "User-defined values."
    click(driver, panel.inputs.use_project)
    assert "1 sigma" in rows(panel)
    changed = replace(driver.project.settings, position_time=200.0)
    window.document.edit("settings", driver.project.with_settings(changed))
    driver.rest()
    assert panel.inputs.source.text().startswith("Prior boresight")
    assert "1 sigma" not in rows(panel)


@LONG
def test_the_boresight_is_saved_for_a_program(
    driver: Driver, calibrated: Calibrated, tmp_path: Path
) -> None:
    project, survey = calibrated
    window, panel = driver.window, driver.window.panels["convention"]
    show_panel(window, TITLE)
    assert not panel.save.isEnabled()
    window.document.open(project, survey)
    driver.rest()
    for key, name in (("kluster", "boat.kfc"), ("pdal", "a.json"), ("qinsy", "a.txt")):
        choose(driver.bot, panel, key)
        assert not panel.saved.isVisible()
        driver.dialogs.path = tmp_path / name
        click(driver, panel.save)
        driver.rest()
        assert driver.dialogs.requests[-1] == f"{project.name}-boresight-{key}"
        assert (tmp_path / name).exists()
        assert panel.saved.isVisible()
        unverified = message_text(note("convention.file_not_tried", program=panel.convention.name))
        assert (unverified in unescape(panel.saved.text())) is (key != "qinsy")
    (stage,) = json.loads((tmp_path / "a.json").read_text(encoding="utf-8"))
    assert stage["type"] == "filters.georeference", "the trajectory of the project is an SBET"
    # Without a lever arm, the refusal is shown, and nothing is written.
    choose(driver.bot, panel, "kluster")
    for field in panel.inputs.lever_arm.fields:
        type_in(driver.bot, field, "0")
    driver.dialogs.path = tmp_path / "none.kfc"
    click(driver, panel.save)
    driver.rest()
    assert has_code("convention.file_needs_lever_arm")(driver.dialogs.errors.pop())
    assert not driver.dialogs.path.exists()


def test_the_filter_of_the_dialogue_selects_the_file(
    qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    formats = installation_formats(convention_of_key("pdal"), with_trajectory=True)
    answers = iter((("", 0), ("a", 1), ("b.json", 0), ("c.json", 2)))

    def answer(_parent: object, _title: str, start: str, filters: str) -> tuple[str, str]:
        assert start.endswith("p.json")
        name, k = next(answers)
        return str(tmp_path / name) if name else "", filters.split(";;")[k]

    monkeypatch.setattr(QFileDialog, "getSaveFileName", answer)
    dialogs = ConventionDialogs()
    assert dialogs.installation_file(tmp_path / "p", formats) is None
    for name, k in (("a.json", 1), ("b.json", 0), ("c.json.txt", 2)):
        assert dialogs.installation_file(tmp_path / "p", formats) == (tmp_path / name, formats[k])


def test_the_panel_has_a_window_of_its_own(driver: Driver) -> None:
    """The menu opens it; Esc closes it; it keeps its place and size."""
    window = driver.window
    menu = by_hand.open_menu(driver.bot, window, "Calibrate")
    by_hand.choose(driver.bot, menu, "Angles in another program")
    own = window.panel_windows[TITLE]
    driver.bot.waitUntil(own.isActiveWindow, timeout=10_000)
    assert own.parentWidget() is window
    own.setGeometry(120, 90, 520, 600)
    driver.bot.keyClick(own, Qt.Key.Key_Escape)
    assert not own.isVisible()
    show_panel(window, TITLE)
    assert own.geometry() == QRect(120, 90, 520, 600)
