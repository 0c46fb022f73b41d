"""Tests of the import dialogue: closing, figures, keys, and files dropped on the window."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QDialog, QMessageBox
from pytestqt.qtbot import QtBot

from lispac.gui.app.settings import AppSettings
from lispac.gui.features.open_project.import_survey.file_table import SPAN, STATE
from lispac.gui.features.open_project.import_survey.import_dialog import (
    MOUNTING,
    QUALITY,
    TIMELINE,
    ImportDialog,
)
from lispac.gui.features.open_project.import_survey.quality_figures import envelope
from lispac.gui.features.open_project.import_survey.timeline import round_ticks
from lispac.gui.window.dialogs import Dialogs
from lispac.workflow.project.projects import open_project
from tests.gui.import_support import drop, raw
from tests.gui.support import WAIT_MS, Demo, Driver, Left, click_in_box, use_next_dialog
from tests.support.long_runs import LONG, others_long

Tab = Qt.Key.Key_Tab

# -- closing ---------------------------------------------------------------------------------------


@LONG
def test_escape_asks_before_it_discards_files(filled: ImportDialog, qtbot: QtBot) -> None:
    rows = filled.table.rowCount()
    assert rows > 1
    for name in (None, "Continue importing", "Close without importing"):
        questions: list[str] = []

        def answer(
            box: QMessageBox, name: str | None = name, questions: list[str] = questions
        ) -> None:
            questions.append(box.text())
            if name is None:
                QTest.keyClick(box, Qt.Key.Key_Escape)
            else:
                click_in_box(box, name)

        use_next_dialog(answer)
        QTest.keyClick(filled, Qt.Key.Key_Escape)
        assert len(questions) == 1
        assert filled.isVisible() == (name != "Close without importing")
        assert filled.table.rowCount() == rows
    assert filled.result() == QDialog.DialogCode.Rejected


def test_escape_closes_an_empty_dialogue_at_once(dialog: ImportDialog) -> None:
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    assert not dialog.isVisible()


# -- table of the files ----------------------------------------------------------------------------


@LONG
def test_times_have_no_separators_and_the_state_is_not_cut(filled: ImportDialog) -> None:
    table = filled.table
    for row in range(table.rowCount()):
        first, dash, last = table.item(row, SPAN).text().split()
        assert dash == "–"
        assert float(first) < float(last)  # "486,000.5" is no number
    table.setColumnWidth(STATE, 40)
    table.show_files(filled.input_files)
    assert table.columnWidth(STATE) >= table.sizeHintForColumn(STATE)


# -- quality ---------------------------------------------------------------------------------------


@LONG
def test_quality_figures_are_drawn_when_shown(filled: ImportDialog, qtbot: QtBot) -> None:
    assert filled.quality.canvas is None
    filled.tabs.setCurrentIndex(QUALITY)
    qtbot.waitUntil(lambda: filled.quality.canvas is not None, timeout=WAIT_MS)
    figure = filled.quality.canvas.figure
    assert [axes.get_ylabel() for axes in figure.axes] == ["Position\nσ (m)", "Attitude\nσ (°)"]
    assert figure.axes[-1].get_xlabel() == "GPS seconds of the week"
    motion = ["Speed\n(m/s)", "Roll, pitch\n(°)", "Heading\n(°)"]
    for k, labels in ((1, ["North (m)"]), (2, motion)):
        qtbot.mouseClick(filled.quality.choice.button(k), Left)
        assert [axes.get_ylabel() for axes in figure.axes] == labels
    points = sum(len(line.get_xdata()) for axes in figure.axes for line in axes.get_lines())
    assert points < 5 * 2 * 1500 + 100


def test_the_timeline_shows_all_lines_and_its_axis_in_a_low_dialogue(
    filled: ImportDialog, qtbot: QtBot
) -> None:
    filled.resize(1326, 708)
    filled.tabs.setCurrentIndex(TIMELINE)
    view = filled.timeline.view
    qtbot.waitUntil(lambda: not view.visibleRegion().isEmpty(), timeout=WAIT_MS)
    assert len(view.bars) == 7
    assert view.visibleRegion().boundingRect().height() == view.height()
    assert view.row_height >= view.fontMetrics().height()
    filled.resize(1326, 940)
    qtbot.waitUntil(lambda: view.height() == view.sizeHint().height(), timeout=WAIT_MS)


def test_a_refused_dialogue_scrolls_to_the_wrong_field(filled: ImportDialog) -> None:
    filled.resize(1326, 708)
    filled.tabs.setCurrentIndex(MOUNTING)
    field = filled.mounting.lever_arm.fields[2]
    field.setFocus()
    QTest.keyClicks(field.lineEdit(), "abc")
    bar = filled.mounting.verticalScrollBar()
    bar.setValue(bar.maximum())
    assert field.visibleRegion().isEmpty()
    filled.tabs.setCurrentIndex(0)
    QTest.mouseClick(filled.ok, Left)
    assert filled.isVisible()
    assert filled.tabs.currentWidget() is filled.mounting
    assert field.visibleRegion().boundingRect().height() == field.height()


def test_an_envelope_keeps_peaks_and_breaks_at_gaps() -> None:
    time = np.arange(720_000) / 200.0
    time[400_000:] += 50
    values = np.sin(time / 100)
    values[123_456] = 9.0
    values[654_321] = -7.0
    shown_time, shown = envelope(time, values, bins=1000, longest_gap=1.5)
    assert len(shown) <= 2 * 1001 + 3
    assert np.nanmax(shown) == 9.0
    assert np.nanmin(shown) == -7.0
    assert np.isnan(shown).sum() == 1
    assert (np.diff(shown_time) >= 0).all()
    assert (shown_time[0], shown_time[-1]) == (time[0], time[-1])
    short_time, short = envelope(np.array([0.0, 1, 5, 6]), np.arange(4.0), longest_gap=1.5)
    np.testing.assert_array_equal(short_time, [0, 1, 5, 5, 6])
    np.testing.assert_array_equal(short, [0, 1, np.nan, 2, 3])


def test_ticks_are_round_and_few() -> None:
    assert round_ticks(485_987.0, 486_461.0, 6) == [486_000, 486_100, 486_200, 486_300, 486_400]
    assert len(round_ticks(0.0, 0.9, 4)) <= 5
    assert [f"{tick:,.0f}" for tick in round_ticks(-3.0, 43.0, 5)] == ["0", "10", "20", "30", "40"]


# -- keyboard --------------------------------------------------------------------------------------


@LONG
def test_all_widgets_are_reached_with_the_tab_key(filled: ImportDialog, qtbot: QtBot) -> None:
    expected = {
        "import_add_files", "import_add_folder", "import_remove", "import_files",
        "new_folder", "new_folder_browse", "new_ok", "option_pitch", "import_preview",
    }  # fmt: skip
    filled.table.selectRow(0)
    filled.add_files.setFocus()
    reached = set()
    for _ in range(80):
        focused = QApplication.focusWidget()
        reached.add(focused.objectName())
        assert focused.accessibleName() or hasattr(focused, "text") or focused.objectName()
        qtbot.keyClick(focused, Tab)
    assert expected <= reached, expected - reached
    assert any(name.startswith("role_") for name in reached)


# -- from the window -------------------------------------------------------------------------------


@LONG
def test_the_origin_begins_with_the_mean_position(filled: ImportDialog, qtbot: QtBot) -> None:
    """A zero origin would be thousands of kilometres away."""
    page, content = filled.mounting, filled.input_files.trajectory_content
    filled.tabs.setCurrentWidget(page)
    assert page.settings().origin_deg_m is None
    qtbot.keyClick(page.origin_given, Qt.Key.Key_Space)
    assert content is not None
    frame = content.mean_frame()
    expected = (np.degrees(frame.latitude), np.degrees(frame.longitude), frame.height)
    assert page.settings().origin_deg_m == pytest.approx(expected, abs=1e-3)
    assert page.settings().origin_deg_m[:2] == pytest.approx(expected[:2], abs=1e-8)


def test_files_dropped_on_the_window_open_the_dialogue(driver: Driver, demo: Demo) -> None:
    drop(driver.window, raw(demo))
    driver.bot.waitUntil(lambda: bool(driver.dialogs.dropped), timeout=WAIT_MS)
    assert driver.dialogs.dropped == raw(demo)


@pytest.mark.parametrize("name", others_long(["project.json", ""]))
def test_a_project_dropped_on_the_window_opens(driver: Driver, demo_copy: Path, name: str) -> None:
    drop(driver.window, [demo_copy / name if name else demo_copy])
    driver.bot.waitUntil(lambda: driver.window.document.project is not None, timeout=WAIT_MS)
    driver.rest()
    assert driver.project.folder == demo_copy
    assert driver.dialogs.dropped == []


class RealImport(Dialogs):
    """Opens the real import dialogue, which a timer fills in."""

    def __init__(self, folder: Path) -> None:
        super().__init__()
        self.folder = folder

    def new_project(self, settings, paths=()):
        timer = QTimer(self.parent)
        timer.timeout.connect(self._drive)
        timer.start(50)
        try:
            return super().new_project(settings, paths)
        finally:
            timer.stop()
            timer.deleteLater()

    def _drive(self) -> None:
        dialog = QApplication.activeModalWidget()
        if isinstance(dialog, ImportDialog) and not dialog.work.busy:
            dialog.folder.setText(str(self.folder))
            dialog.folder.textEdited.emit(str(self.folder))
            if dialog.ok.isEnabled():
                QTest.mouseClick(dialog.ok, Left)


def test_dropped_files_become_a_project_in_the_window(
    driver: Driver, demo: Demo, tmp_path: Path
) -> None:
    dialogs = RealImport(tmp_path / "made")
    dialogs.parent = driver.window
    driver.window.lifecycle._dialogs = dialogs
    drop(driver.window, raw(demo))
    driver.bot.waitUntil(lambda: driver.window.document.project is not None, timeout=WAIT_MS)
    driver.rest()
    assert driver.project.folder == tmp_path / "made"
    assert driver.dialogs.errors == []
    assert len(open_project(tmp_path / "made").lines) == 6


def test_remembered_choices_of_the_dialogue_are_read_back(tmp_path: Path) -> None:
    settings = AppSettings(tmp_path / "s.ini")
    assert settings.column_mappings() == {}
    settings.save_column_mappings({"text/4/": "time x y z"})
    settings.save_column_mappings({"text/5/": "x y z time -"})
    settings.sync()
    read = AppSettings(tmp_path / "s.ini").column_mappings()
    assert read == {"text/4/": "time x y z", "text/5/": "x y z time -"}
