"""Tests of the studies in the window: history, subsampling, checks, error budget, visibility."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import shiboken6
from matplotlib.backend_bases import LocationEvent, MouseEvent
from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication, QDialog, QPushButton

from lispac.gui.features.studies.check_dialog import CheckDialog, CheckResultDialog
from lispac.gui.features.studies.study_dialog import (
    BudgetDialog,
    HistoryDialog,
    LineQualityDialog,
    SubsamplingDialog,
)
from lispac.gui.features.studies.visibility_dialog import VisibilityDialog
from lispac.identity import Identity
from lispac.io.project.project_file import write_project
from lispac.project import Project
from tests.gui.by_hand import choose, open_menu
from tests.gui.support import (
    WAIT_MS,
    Control,
    Driver,
    in_front,
    open_step,
    press,
    type_into,
    wait_until_idle,
)
from tests.support.long_runs import LONG
from tests.support.report_sample import sample_project
from tests.support.static_scans import tripod_scan

Key, Left = Qt.Key, Qt.MouseButton.LeftButton
SYSTEM = Identity(vessel="Nordlys", scanner="VZ-400i")


def use_next_dialog(driver: Driver, inspect_dialog, key: Qt.Key = Key.Key_Return) -> None:
    """Call ``inspect_dialog`` with the next dialogue and close it with a key; errors fail the test.

    Enter presses the button that was clicked last, if any.
    """
    errors: list[BaseException | None] = []

    def wait(tries: int) -> None:
        dialog = QApplication.activeModalWidget()
        if not isinstance(dialog, QDialog) or not in_front(dialog):
            if tries:
                QTimer.singleShot(50, lambda: wait(tries - 1))
            return
        try:
            inspect_dialog(dialog)
            errors.append(None)
        except BaseException as error:
            errors.append(error)
        finally:
            driver.bot.keyClick(dialog, key)

    QTimer.singleShot(50, lambda: wait(1200))
    driver.bot.waitUntil(lambda: bool(errors), timeout=WAIT_MS)
    if errors[0] is not None:
        raise errors[0]


def choose_study(driver: Driver, name: str) -> None:
    """Choose a study in the menu."""
    choose(driver.bot, open_menu(driver.bot, driver.window, "Calibrate"), name)


@pytest.fixture
def surveys(tmp_path: Path) -> Path:
    """A folder with last year's calibration of the vessel."""
    folder = tmp_path / "surveys" / "2025"
    project = sample_project(folder)
    write_project(replace(project, identity=replace(SYSTEM, dates="2025-04-02")))
    return folder.parent


@LONG
def test_the_open_result_is_compared_with_earlier_calibrations(
    adjusted: Driver, surveys: Path, estimated: Project
) -> None:
    document = adjusted.window.document
    document.edit("details", document.project.with_identity(replace(SYSTEM, dates="2026-04-05")))
    adjusted.rest()
    adjusted.dialogs.path = surveys
    assert estimated.result is not None
    pitch = np.degrees(estimated.result.boresight[1])

    def inspect_dialog(dialog: HistoryDialog) -> None:
        assert isinstance(dialog, HistoryDialog)
        assert dialog.table.rowCount() == 2
        days = [dialog.table.item(row, 0).text() for row in range(2)]
        assert days == ["2025-04-02", "2026-04-05"]
        assert dialog.table.item(1, 4).text().replace("−", "-") == f"{pitch:+.4f}"
        assert dialog.table.item(1, 12).text() == "mounting has moved"  # angles of another system
        assert "Nordlys, VZ-400i" in dialog.system.currentText()
        assert len(dialog.canvas.figure.axes) == 3
        adjusted.bot.mouseClick(dialog.copy_numbers, Left)
        assert "2026-04-05\t" in QGuiApplication.clipboard().text()
        adjusted.bot.mouseClick(dialog.copy_picture, Left)
        assert QGuiApplication.clipboard().pixmap().width() >= 560

    adjusted.bot.keyClick(adjusted.window, Key.Key_F11, Control)
    use_next_dialog(adjusted, inspect_dialog, Key.Key_Escape)


def test_a_folder_without_projects_is_reported(driver: Driver, tmp_path: Path) -> None:
    driver.dialogs.path = tmp_path
    driver.bot.keyClick(driver.window, Key.Key_F11, Control)
    driver.rest()
    (error,) = driver.dialogs.errors
    assert error.code == "history.no_project"


@LONG
def test_results_are_listed_by_subsampling_distance(adjusted: Driver) -> None:
    project = adjusted.project

    def inspect_dialog(dialog: SubsamplingDialog) -> None:
        assert isinstance(dialog, SubsamplingDialog)
        points = [
            int(dialog.table.item(row, 1).text().replace(",", ""))
            for row in range(dialog.table.rowCount())
        ]
        assert points == sorted(points, reverse=True)
        assert dialog.table.item(0, 0).text() == "all points"
        used = [dialog.table.item(row, 0).text() for row in range(len(points))]
        own = used.index(f"{project.settings.subsample:.2f}")
        assert project.result is not None
        assert points[own] == project.result.points
        shown = dialog.table.item(own, 2).text().replace("−", "-")
        assert shown == f"{np.degrees(project.result.boresight[0]):+.4f}"

    action = adjusted.window.actions_["subsampling"]
    assert action.isEnabled()
    action.trigger()
    use_next_dialog(adjusted, inspect_dialog)
    assert adjusted.project is project


@LONG
def test_a_static_scan_is_one_undo_step_and_in_the_report(adjusted: Driver, tmp_path: Path) -> None:
    scan = tmp_path / "tripod.txt"
    np.savetxt(scan, tripod_scan(("V1",), shift=(0.02, 0.0, 0.0)), fmt="%.4f", header="x y z")
    dialogs: list[QDialog] = []

    def use_dialog(dialog: CheckDialog) -> None:
        assert isinstance(dialog, CheckDialog)
        dialogs.append(dialog)
        assert not dialog.accept_button.isEnabled()
        dialog.file.setFocus()
        adjusted.bot.keyClicks(dialog.file, str(scan))
        assert dialog.accept_button.isEnabled()
        assert dialog.system.currentData() == ""
        assert not dialog.height.isVisible()
        dialog.system.setCurrentIndex(dialog.system.findData("local"))
        dialog.sigma.setValue(2.0)

    def inspect_dialog(dialog: CheckResultDialog) -> None:
        assert isinstance(dialog, CheckResultDialog)
        dialogs.append(dialog)
        found = adjusted.project.absolute
        assert found is not None
        assert found.sigma == pytest.approx(0.002)
        rows = dialog.table.rowCount()
        assert rows == len(found.lines) + 1
        mean = 1000 * found.all_lines.after.signed.mean
        assert dialog.table.item(rows - 1, 5).text().replace("−", "-") == f"{mean:+.1f}"
        assert "mean" in dialog.message_label.text().lower()
        assert len(dialog.canvas.figure.axes) == 1

    QTimer.singleShot(0, adjusted.window.actions_["check"].trigger)
    use_next_dialog(adjusted, use_dialog)
    use_next_dialog(adjusted, inspect_dialog)
    assert len(dialogs) == 2
    stack = adjusted.window.document.undo_stack
    assert stack.undoText() == "check against tripod.txt"
    stack.undo()
    adjusted.rest()
    assert adjusted.project.absolute is None


def test_a_reference_that_is_missing_is_reported(adjusted: Driver, tmp_path: Path) -> None:
    def use_dialog(dialog: CheckDialog) -> None:
        dialog.file.setText(str(tmp_path / "gone.laz"))

    QTimer.singleShot(0, adjusted.window.actions_["check"].trigger)
    use_next_dialog(adjusted, use_dialog)
    adjusted.rest()
    (error,) = adjusted.dialogs.errors
    assert "gone.laz" in str(error)
    assert adjusted.project.absolute is None


def test_the_error_budget_is_shown(adjusted: Driver) -> None:
    def inspect_dialog(dialog: BudgetDialog) -> None:
        assert isinstance(dialog, BudgetDialog)
        rows = {dialog.table.item(row, 0).text(): row for row in range(dialog.table.rowCount())}
        before, after = (
            float(dialog.table.item(rows[name], 9).text())
            for name in ("Boresight before calibration", "Boresight after calibration")
        )
        assert before > 10 * after > 0
        level = dialog.table.item(rows["POS position"], 3).text()
        dialog.beam.setCurrentIndex(1)
        assert dialog.table.item(rows["POS position"], 3).text() != level
        assert dialog.table.item(rows["Lever arm"], 1).text() == "not given"

    choose_study(adjusted, "Error budget")
    use_next_dialog(adjusted, inspect_dialog)


def test_typed_lever_arm_sigma_and_divergence_are_in_the_error_budget(adjusted: Driver) -> None:
    open_step(adjusted, 0)
    data = adjusted.window.data
    for typed, text in ((data.lever_arm_sigma.fields[2], "0,04"), (data.divergence, "3 mrad")):
        type_into(adjusted, typed, text)
        adjusted.bot.keyClick(typed, Key.Key_Return)
        adjusted.rest()
    press(adjusted, Key.Key_F9)
    wait_until_idle(adjusted)
    shown: list[str] = []
    footprint: dict[str, str] = {}

    def read_table(dialog: BudgetDialog) -> None:
        rows = {dialog.table.item(row, 0).text(): row for row in range(dialog.table.rowCount())}
        shown.extend(dialog.table.item(rows["Lever arm"], column).text() for column in range(10))
        for column in range(dialog.table.columnCount()):
            head = " ".join(dialog.table.horizontalHeaderItem(column).text().split())
            footprint[head] = dialog.table.item(rows["Beam footprint"], column).text()

    choose_study(adjusted, "Error budget")
    use_next_dialog(adjusted, read_table)
    assert adjusted.project.settings.lever_arm_sigma == pytest.approx((0.0, 0.0, 0.04))
    horizontal, vertical = (float(text) for text in shown[1:3])  # centimetres
    assert vertical == pytest.approx(4.0, abs=0.1)
    assert horizontal < 0.5
    # The reflecting place is anywhere in a disc, whose diameter is 3 mrad of the range
    x, y = np.meshgrid(np.linspace(-1, 1, 1001), np.linspace(-1, 1, 1001))
    squared = (x**2 + y**2)[x**2 + y**2 <= 1]
    of_disc = np.sqrt(squared.mean())
    for metres in (10, 50, 100):
        (across,) = (
            float(text)
            for head, text in footprint.items()
            if head.startswith("Across beam") and f" {metres} m" in head.replace("\xa0", " ")
        )
        assert across == pytest.approx(100 * 1.5e-3 * metres * of_disc, abs=0.051)


@LONG
def test_the_visibility_study_is_shown_and_copied(
    driver: Driver, capsys: pytest.CaptureFixture[str]
) -> None:
    """The study needs no project, because boards are planned before a survey."""

    def inspect_dialog(dialog: VisibilityDialog) -> None:
        assert isinstance(dialog, VisibilityDialog)
        assert dialog.table.rowCount() == 8
        best = {
            dialog.table.item(row, 0).text(): dialog.table.item(row, 3).text() for row in range(8)
        }
        assert best["Pitch 2°"] == "0"
        assert best["Lever arm Z 10 cm"] == "not visible"
        dialog.table.selectRow(0)
        assert dialog.error.currentText() == "Roll 2°"
        assert "Appendix C.2.1" in dialog.message_label.text()
        dialog.table.selectRow(2)
        assert dialog.error.currentText() == "Yaw 2°"
        assert "Appendix" not in dialog.message_label.text()
        dialog.criterion.setCurrentIndex(1)
        (axes,) = dialog.canvas.figure.axes
        assert "Yaw" in axes.get_title(loc="left")
        assert "orthogonal distance" in axes.get_ylabel()
        dialog.canvas.draw()
        x, y = axes.transData.transform((-38.0, 0.0))
        MouseEvent("motion_notify_event", dialog.canvas, x, y)._process()
        text = dialog.reading.text()
        assert "-40°" in text
        driver.bot.mouseClick(dialog.copy_numbers, Left)
        heads, *rows = QGuiApplication.clipboard().text().splitlines()
        assert heads.split("\t")[3] == "45°"
        (row,) = (row.split("\t") for row in rows if row.startswith("-40\t"))
        assert f"45°: {float(row[3]):.4f}".replace("-", "\u2212") in text
        driver.bot.mouseClick(dialog.copy_picture, Left)
        assert QGuiApplication.clipboard().pixmap().width() >= 560
        dialog.site.setCurrentText("Marine site")
        assert dialog.table.rowCount() == 3
        assert [dialog.error.itemText(k) for k in range(3)] == [
            "Roll 2°", "Pitch 2°", "Yaw 2°",
        ]  # fmt: skip
        assert dialog.error.currentText() == "Yaw 2°"
        shiboken6.delete(dialog.reading)  # at exit, widgets are deleted in any order
        LocationEvent("axes_leave_event", dialog.canvas, x, y)._process()
        assert capsys.readouterr().err == ""

    action = driver.window.actions_["visibility"]
    assert action.isEnabled()
    action.trigger()
    use_next_dialog(driver, inspect_dialog, Key.Key_Escape)


def test_studies_of_a_result_are_disabled_without_targets(opened: Driver) -> None:
    assert not opened.window.actions_["check"].isEnabled()
    assert not opened.window.actions_["budget"].isEnabled()
    assert not opened.window.actions_["subsampling"].isEnabled()
    assert opened.window.actions_["history"].isEnabled()


@LONG
def test_differences_between_lines_are_shown(adjusted: Driver) -> None:
    """A selected row is shown in the map and marked in the view, which can be moved meanwhile."""
    window, viewport = adjusted.window, adjusted.viewport
    window.computations.show("estimated")
    adjusted.rest()
    project = adjusted.project
    action = window.actions_["line_quality"]
    assert action.isEnabled()
    action.trigger()
    adjusted.rest()
    dialog = window.findChild(LineQualityDialog)
    adjusted.bot.waitUntil(dialog.isVisible, timeout=WAIT_MS)
    assert QApplication.activeModalWidget() is None, "the view stays usable"
    table = dialog.table
    rows = [
        [table.item(row, column).text() for column in range(9)] for row in range(table.rowCount())
    ]
    assert len({tuple(row[:2]) for row in rows}) == 15 + 1, "six lines, and all together"

    def drawn() -> int:
        return dialog.figure().axes[0].collections[0].get_offsets().shape[0]

    def title() -> str:
        return dialog.figure().axes[0].get_title(loc="left")

    (together,) = (row for row in rows if (row[0], row[2]) == ("all lines", "all surfaces"))
    assert float(together[5]) < 40, "what the simulated trajectory leaves, mm"
    assert drawn() == int(together[3].replace(",", ""))
    assert title() == "All lines, all surfaces"
    assert "line_differences" not in viewport.sketches
    limits = dialog.figure().axes[0].collections[0].get_clim()
    first = table.visualItemRect(table.item(0, 0)).center()
    adjusted.bot.mouseClick(table.viewport(), Left, pos=first)
    for number in (0, 1):
        row = rows[number]
        assert title() == f"{row[0]} − {row[1]}, {row[2]}"
        assert drawn() == int(row[3].replace(",", ""))
        assert dialog.figure().axes[0].collections[0].get_clim() == limits, "comparable colours"
        sketch = viewport.sketches["line_differences"]
        assert sketch.label == title()
        assert 0 < len(sketch.points) <= int(row[3].replace(",", ""))
        adjusted.bot.keyClick(table, Key.Key_Down)
    adjusted.bot.mouseClick(dialog.findChild(QPushButton, "line_quality_close"), Left)
    adjusted.bot.waitUntil(lambda: "line_differences" not in viewport.sketches, timeout=WAIT_MS)
    assert adjusted.project is project


@LONG
def test_differences_of_another_boresight_are_closed(adjusted: Driver) -> None:
    window = adjusted.window
    window.actions_["line_quality"].trigger()
    adjusted.rest()
    dialog = window.findChild(LineQualityDialog)
    adjusted.bot.waitUntil(dialog.isVisible, timeout=WAIT_MS)
    window.controller.use_target("T1", False)
    adjusted.bot.waitUntil(lambda: window.findChild(LineQualityDialog) is None, timeout=WAIT_MS)
    adjusted.rest()
