"""Tests of what a new user of the window sees: status while checking, options of the report."""

from dataclasses import replace
from html import unescape
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure
from PySide6.QtWidgets import QAbstractButton
from pytestqt.qtbot import QtBot

from lispac.gui.features.estimate.results_panel import MIN_WIDTH_PX
from lispac.gui.features.inspect.section_figure import draw_section, move_title_inside
from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from lispac.gui.project.status import ADJUST, REPORT, TARGETS
from lispac.language import gettext
from lispac.messages import warning
from lispac.project import Project
from tests.gui.import_support import rest
from tests.gui.support import (
    WAIT_MS,
    Control,
    Demo,
    Driver,
    Key,
    click,
    open_step,
    press,
    sentence,
    show_panel,
)
from tests.support.long_runs import LONG


def test_no_verdict_is_shown_before_the_checks_end(picked: Driver) -> None:
    window, texts = picked.window, []
    window.estimation.checking.connect(
        lambda running: texts.append((running, window.results.checks.text()))
    )
    assert window.adjust.cross_check.isChecked()
    seen = []
    window.document.changed.connect(lambda: seen.append(status(picked)))
    press(picked, Key.Key_F9)
    picked.bot.waitUntil(lambda: picked.project.result is not None, timeout=WAIT_MS)
    assert picked.project.cross_checks is None
    assert window.document.awaits_checks
    checking = sentence(picked, ADJUST)
    picked.bot.waitUntil(lambda: picked.project.cross_checks is not None, timeout=WAIT_MS)
    picked.rest()
    assert sentence(picked, ADJUST) != checking
    with_result = [text for has_result, has_checks, text in seen if has_result and not has_checks]
    assert set(with_result) == {checking}
    running, ended = texts
    assert running == (True, gettext("being computed"))
    assert not ended[0]
    assert ended[1] != running[1]


def status(driver: Driver) -> tuple[bool, bool, str]:
    project = driver.project
    refresh = driver.window.panel_refresh
    text = refresh._project_state().steps[ADJUST].sentence
    return project.result is not None, project.cross_checks is not None, text


@LONG
def test_cancelled_checks_leave_the_result_with_its_status(picked: Driver) -> None:
    press(picked, Key.Key_F9)
    picked.bot.waitUntil(lambda: picked.window.document.awaits_checks, timeout=WAIT_MS)
    checking = sentence(picked, ADJUST)
    picked.bot.waitUntil(lambda: picked.window.runner.current is not None, timeout=WAIT_MS)
    picked.window.actions_["cancel"].trigger()
    picked.rest()
    assert not picked.window.document.awaits_checks
    assert sentence(picked, ADJUST) != checking


@LONG
def test_other_options_make_the_report_out_of_date(adjusted: Driver, tmp_path: Path) -> None:
    window = adjusted.window
    open_step(adjusted, REPORT)
    adjusted.dialogs.path = tmp_path / "r.html"
    click(adjusted, window.report.report)
    adjusted.rest()
    exported = sentence(adjusted, REPORT)
    assert "r.html" in exported
    extent = window.report.extent
    extent.setFocus()
    former = extent.currentIndex()
    adjusted.bot.keyClick(extent, Key.Key_Down if former == 0 else Key.Key_Up)
    assert extent.currentIndex() != former
    assert sentence(adjusted, REPORT) != exported
    assert "r.html" in window.report.advice.text()
    adjusted.bot.keyClick(extent, Key.Key_Up if former == 0 else Key.Key_Down)
    assert sentence(adjusted, REPORT) == exported
    window.settings.sync()
    stored = window.settings.exported_report(adjusted.project.folder)
    assert stored is not None
    assert stored[3] == window.document.report.options


def test_a_project_with_one_target_opens_at_the_targets(driver: Driver, demo: Demo) -> None:
    for count, step in ((1, TARGETS), (2, ADJUST)):
        names = [target.name for target in demo.picked.targets_of_role("target")]
        project = demo.picked
        for name in names[count:]:
            project = project.without_target(name)
        driver.window.document.open(project, demo.survey)
        driver.rest()
        assert driver.window.workflow.opened == step


def test_a_closed_panel_is_named_with_its_menu(picked: Driver) -> None:
    dock = picked.window.docks["Targets by line"]
    click(picked, dock.findChild(QAbstractButton, "qt_dockwidget_closebutton"))
    assert "Targets by line" in picked.window.task_bar.currentMessage()


def test_an_empty_column_of_the_cross_checks_is_hidden(
    driver: Driver, demo: Demo, estimated: Project
) -> None:
    driver.window.document.open(estimated, demo.survey)
    driver.rest()
    press(driver, Key.Key_D, Control)
    driver.window.diagnostics.open("Cross-checks")
    driver.rest()
    table = driver.window.diagnostics.current.table
    texts = [
        {table.item(row, column).text() for row in range(table.rowCount())}
        for column in range(table.columnCount())
    ]
    assert [table.isColumnHidden(k) for k in range(len(texts))] == [each == {""} for each in texts]
    assert any(each == {""} for each in texts), "the reason of differences that agree"


@pytest.mark.usefixtures("qapp")
def test_all_files_of_an_import_are_visible(filled: ImportDialog, qtbot: QtBot) -> None:
    rest(qtbot, filled)
    table = filled.table
    last = table.visualRect(table.model().index(table.rowCount() - 1, 0))
    assert table.viewport().rect().contains(last)


def test_the_first_rows_have_equal_decimals_and_units(filled: ImportDialog, qtbot: QtBot) -> None:
    filled.table.select(filled.input_files.trajectory.path)
    rest(qtbot, filled)
    preview = filled.file_page.preview
    heads = [preview.horizontalHeaderItem(k).text() for k in range(preview.columnCount())]
    assert heads[:4] == ["time (s)", "latitude (rad)", "longitude (rad)", "height (m)"]
    for column in range(preview.columnCount()):
        texts = [preview.item(row, column).text() for row in range(preview.rowCount())]
        if not any("e" in text for text in texts):
            assert len({len(text.partition(".")[2]) for text in texts}) == 1, heads[column]
            assert not any(text.startswith("-") and float(text) == 0 for text in texts)


def test_the_default_of_the_noise_is_named_until_a_value_is_given(
    filled: ImportDialog, qtbot: QtBot
) -> None:
    filled.tabs.setCurrentWidget(filled.mounting)
    hint = filled.mounting.findChild(
        type(filled.mounting.sensors.scanner_origin), "new_lidar_default"
    )
    assert hint.isVisible()
    field = filled.mounting.lidar_sigma
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "3.5")
    qtbot.keyClick(field, Key.Key_Tab)
    assert not hint.isVisible()


def test_cuts_of_a_flat_plane_have_one_range(adjusted: Driver) -> None:
    adjusted.window._select("T1", "")
    press(adjusted, Key.Key_S)
    adjusted.rest()
    cut = adjusted.window.tools.sections._cuts[1]
    across = np.array([0.0, 1.0])
    rough = {line: points * [1.0, 0.05] for line, points in cut.points.items()}
    wide = replace(cut, normal=across, spread=0.05, points=rough)
    flat = {line: points * [1.0, 0.01] for line, points in cut.points.items()}
    narrow = replace(wide, points=flat)
    assert wide.automatic_exaggeration() == narrow.automatic_exaggeration() > 1
    colours = {line.name: (0, 0, 0) for line in adjusted.project.lines}
    figure = Figure(figsize=(9.0, 1.8))
    for cuts in ([wide, narrow], [narrow, wide]):
        draw_section(cuts, colours, ("Distance", "Height"), {}, figure, labelled=False)
        before, after = figure.axes
        assert before.get_xlim() == after.get_xlim()
        assert before.get_ylim() == after.get_ylim()
        assert before.get_xlabel(), "also in a low panel"
        figure.canvas.draw()
        for axes in (before, after):
            title = axes.xaxis.label.get_window_extent()
            assert axes.get_window_extent().contains(*title.get_points().mean(axis=0))


def test_the_axis_title_in_a_low_section_covers_no_line() -> None:
    figure = Figure(figsize=(4.0, 1.5))
    axes = figure.add_subplot()
    axes.set(xlim=(0.0, 1.0), ylim=(0.0, 1.0))
    axes.set_xlabel("Across (m)")
    upright = np.linspace(0.0, 1.0, 50)
    for x, side in ((0.9, "left"), (0.1, "right")):
        for line in axes.lines:
            line.remove()
        axes.plot(np.full(50, x), upright)
        move_title_inside(axes)
        assert axes.xaxis.label.get_horizontalalignment() == side


def test_the_signs_of_the_angles_are_visible_without_scrolling(
    driver: Driver, demo: Demo, estimated: Project
) -> None:
    driver.window.document.open(estimated, demo.survey)
    driver.rest()
    show_panel(driver.window, "Results")
    table = driver.window.results.angles
    header, side = table.horizontalHeader(), table.verticalHeader()
    assert header.visibleRegion().boundingRect().height() == header.height()
    widest = 0
    for column, part in enumerate(("port", "bow", "clockwise")):
        assert part in table.horizontalHeaderItem(column).text()
        needed = header.sectionSizeFromContents(column)
        assert needed.height() <= header.height()
        widest = max(widest, needed.width())
    assert side.width() + 3 * widest < MIN_WIDTH_PX - 12, "not cut off in the narrowest panel"


def test_one_click_shows_all_results(driver: Driver, demo: Demo, estimated: Project) -> None:
    driver.window.resize(1600, 1000)
    driver.window.document.open(estimated, demo.survey)
    driver.rest()
    show_panel(driver.window, "Results")
    results = driver.window.results
    low = results.height()
    click(driver, results.enlarge)
    driver.rest()
    table = results.correlation
    assert table.visibleRegion().boundingRect().height() == table.height()
    click(driver, results.enlarge)
    driver.rest()
    assert results.height() == low


def test_unchecked_signs_are_reported_only_after_the_checks(
    adjusted: Driver, estimated: Project
) -> None:
    """The checks confirm the signs of roll and pitch of most surveys."""
    message = warning("sbet.signs_not_checked", file="sbet.out", angles=("roll", "pitch"))
    results = adjusted.window.results
    state = replace(
        adjusted.window.panel_refresh._project_state(),
        project=estimated.with_data_messages((message,)),
    )
    for is_checking in (True, False):
        results.show_state(replace(state, is_checking=is_checking))
        text = unescape(results.warnings.text())
        assert ("sbet.out" in text) != is_checking
