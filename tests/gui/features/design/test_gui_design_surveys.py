"""Tests of simulated surveys of a plan, and of the comparison of a real survey with its plan."""

from collections.abc import Sequence
from multiprocessing import active_children
from types import SimpleNamespace

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QObject, QPoint, QPointF
from PySide6.QtWidgets import QApplication

from lispac.design.monte_carlo import MonteCarloResult, run_monte_carlo
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.design import edits
from lispac.gui.features.design.window import DesignWindow
from lispac.io.config.plan_file import read_plan
from lispac.language import gettext_lazy
from lispac.messages import note
from lispac.present.angles import Angles
from lispac.present.planning.design_results import (
    ANGLES_BY_ROW_TABLE,
    FormattedAnglesRow,
    SimulationValues,
)
from lispac.present.tables import cell_text, ratio
from lispac.workflow.planning.plan_comparison import compare_with_plan
from tests.design.test_campaign import PORT
from tests.gui.design_support import (
    NoModifier,
    mouse_move,
    opened_by_keys,
    plan,
    wait_until_designed,
)
from tests.gui.support import WAIT_MS, Control, Driver, Key, Left, click
from tests.support.message_codes import is_shown

SLOW_PULSE_RATE = 4000.0
"""Low pulse rate, Hz, with which a simulated survey is adjusted quickly."""


@pytest.fixture
def coarse(driver: Driver, design: DesignWindow) -> DesignWindow:
    """The default plan with a slow scanner, and the page of the simulated surveys in front."""
    system = plan(design).system
    scanner = type(system.scanner)(SLOW_PULSE_RATE)
    work = design.workspace
    work.start(edits.with_system(work.titled, type(system)(scanner=scanner)))
    driver.bot.keyClick(design, Key.Key_F10)
    assert design.tabs.currentWidget() is design.surveys
    assert design.surveys.surveys.hasFocus()
    return design


def table_cells(rows: Sequence[FormattedAnglesRow]) -> list[list[str]]:
    return [[cell_text(column, row) for column in ANGLES_BY_ROW_TABLE.columns] for row in rows]


def surveyed_once() -> MonteCarloResult:
    """Result of 40 simulated surveys whose scatter agrees with the predicted sigmas."""
    errors = np.random.default_rng(4).normal(0.0, 1e-4, (40, 3))
    return MonteCarloResult(errors, np.full((40, 3), 1e-4), np.full(3, 1e-4), np.eye(3), 0)


def type_into_field(driver: Driver, field, text: str) -> None:
    field.setFocus()
    field.selectAll()
    driver.bot.keyClicks(field, text)


def test_simulated_surveys_agree_with_the_command_line(
    driver: Driver, coarse: DesignWindow
) -> None:
    surveys, before = coarse.surveys, coarse.workspace.titled
    assert (surveys.surveys.value(), surveys.surveys.minimum()) == (200, 20)
    driver.bot.keyClicks(surveys.surveys, "32")  # replaces the selected text
    type_into_field(driver, surveys.seed, "7")
    box = surveys.flatness
    driver.bot.mouseClick(box, Left, pos=QPoint(8, box.height() // 2))
    assert box.isChecked()
    click(driver, surveys.start)
    assert surveys.cancel.isEnabled()
    assert not surveys.start.isEnabled()
    wait_until_designed(driver)
    assert driver.dialogs.errors == []
    found = run_monte_carlo(before.plan, 32, seed=7, flatness_known=True)
    shown = surveys.result_table
    assert shown.head.text() == "Site: 32 surveys simulated and adjusted"
    values = SimulationValues.of(found)
    assert shown.cells[1:] == table_cells(values.rows)
    assert shown.messages.text().split("\n") == list(map(message_text, found.messages))
    assert not shown.outdated.isVisible()
    driver.bot.keyClick(coarse, Key.Key_L, Control)
    assert shown.outdated.isVisible(), "it is no answer about another plan"
    driver.bot.keyClick(coarse, Key.Key_Z, Control)
    assert not shown.outdated.isVisible()
    assert coarse.workspace.titled is before
    assert coarse.views.currentWidget() is coarse.pictures
    figure = coarse.pictures.pages.currentWidget().figure
    assert len(figure.axes) == 3
    for axes in figure.axes:
        drawn = sum(bar.get_height() for bar in axes.patches)
        width = axes.patches[0].get_width()
        (curve,) = axes.lines
        assert drawn == 32
        assert np.trapezoid(curve.get_ydata(), curve.get_xdata()) == pytest.approx(
            32 * width, rel=1e-3
        ), "the curve holds as many surveys as the bars"


@pytest.mark.long
def test_a_cancelled_campaign_shows_its_finished_surveys_if_they_suffice(
    driver: Driver, coarse: DesignWindow
) -> None:
    surveys, runner = coarse.surveys, driver.window.site_design.runner
    driver.bot.keyClicks(surveys.surveys, "5000")
    driver.bot.keyClick(surveys.start, Key.Key_Space)
    driver.bot.waitUntil(lambda: runner.current.fraction * 5000 >= 40, timeout=WAIT_MS)
    driver.bot.waitUntil(lambda: "surveys/s" in str(runner.current.step), timeout=WAIT_MS)
    driver.bot.waitUntil(lambda: " left" in coarse.task_bar.text.text(), timeout=WAIT_MS)
    click(driver, surveys.cancel)
    wait_until_designed(driver)
    head = surveys.result_table.head.text()
    assert head.startswith("Site: cancelled after ")
    assert head.endswith(" of 5,000 simulated surveys")
    finished = int(head.split()[3].replace(",", ""))
    assert 40 <= finished < 5000
    agrees = note("campaign.coverage_agrees", count=finished)
    assert message_text(agrees) in surveys.result_table.messages.text()


def test_too_few_finished_surveys_show_nothing(driver: Driver, coarse: DesignWindow) -> None:
    surveys = coarse.surveys
    driver.bot.keyClick(surveys.start, Key.Key_Space)
    driver.bot.keyClick(coarse, Key.Key_Period, Control)
    wait_until_designed(driver)
    assert surveys.result_table.cells == []
    assert coarse.task_bar.currentMessage() == "Simulating surveys: cancelled"
    assert coarse.pictures.which.count() == 0
    assert surveys.start.isEnabled()
    assert driver.dialogs.errors == []


@pytest.mark.long
def test_a_campaign_that_ends_during_a_drag_does_not_end_the_drag(
    driver: Driver, coarse: DesignWindow
) -> None:
    view, surveys = coarse.wall_view, coarse.surveys
    spot = view._target_rect(edits.placed_targets(coarse.workspace.titled)[0]).center()
    driver.bot.keyClicks(surveys.surveys, "20")
    driver.bot.keyClick(surveys.start, Key.Key_Space)
    driver.bot.mousePress(view, Left, pos=spot.toPoint())
    QApplication.sendEvent(view, mouse_move(view, spot + QPointF(0, -30), NoModifier))
    wait_until_designed(driver)
    assert "20 surveys" in surveys.result_table.head.text()
    assert coarse.views.currentWidget() is view
    QApplication.sendEvent(view, mouse_move(view, spot + QPointF(0, -60), NoModifier))
    driver.bot.mouseRelease(view, Left, pos=(spot + QPointF(0, -60)).toPoint())
    assert str(coarse.workspace.history.undo_name) == "Move T1"
    assert plan(coarse).targets[0].centre[2] > 5.0


def test_a_plan_that_cannot_be_adjusted_is_refused(driver: Driver, coarse: DesignWindow) -> None:
    for _ in range(5):
        coarse.workspace.remove_line()
    driver.bot.keyClick(coarse.surveys.start, Key.Key_Space)
    wait_until_designed(driver)
    (error,) = driver.dialogs.errors
    assert error.code == "design.undetermined"
    driver.dialogs.errors.clear()
    coarse.workspace.remove_line()
    driver.bot.keyClick(coarse.surveys.start, Key.Key_Space)
    assert is_shown("window.plan_incomplete", coarse.task_bar.currentMessage())


def test_closing_the_program_stops_the_surveys(driver: Driver, coarse: DesignWindow) -> None:
    driver.bot.keyClick(coarse.surveys.start, Key.Key_Space)
    runner = driver.window.site_design.runner
    driver.bot.waitUntil(lambda: runner.current.fraction > 0, timeout=WAIT_MS)
    driver.dialogs.save_choice = "discard"
    driver.bot.keyClick(coarse, Key.Key_W, Control)
    assert runner.active, "the window of the site may close meanwhile"
    assert driver.window.close()
    assert runner.current is None
    assert active_children() == [], "no process of the pool is left"


def test_a_new_result_replaces_all_widgets_of_the_former_one(
    driver: Driver, coarse: DesignWindow
) -> None:
    shown, plan_ = coarse.surveys.result_table, plan(coarse)
    counts, head = [], gettext_lazy("Simulate surveys")
    for k in range(30):
        rows = [FormattedAnglesRow("RMS error (deg)", Angles(k, 0.2, -0.3), ratio(1))] * 7
        shown.show_result(head, SimpleNamespace(rows=rows, summary_texts=("remark",)), plan_)
        coarse.pictures.show_errors(surveyed_once())
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        counts.append(len(coarse.findChildren(QObject)))
    assert shown.cells[1] == ["RMS error (deg)", "29.0", "0.2", "−0.3"]
    assert len(set(counts[1:])) == 1


def test_the_open_project_is_compared_with_the_plan(adjusted: Driver) -> None:
    design, document = opened_by_keys(adjusted), adjusted.window.document
    adjusted.dialogs.path = PORT
    adjusted.bot.keyClick(design, Key.Key_O, Control)
    design.workspace.add_line(duplicate=True)
    adjusted.bot.keyClick(design, Key.Key_F11)
    wait_until_designed(adjusted)
    assert adjusted.dialogs.errors == []
    found = compare_with_plan(document.project, document.survey, design.workspace.titled)
    shown = design.compared
    assert shown.cells[1:] == table_cells(found.rows)
    assert shown.messages.text().split("\n") == list(found.summary_texts)
    assert message_text(found.messages[-1]) in shown.messages.text()
    assert document.project.name in shown.head.text()
    assert read_plan(PORT).title in shown.head.text()
    assert shown.isVisible()


def test_a_comparison_without_a_calibrated_project_is_refused(
    driver: Driver, design: DesignWindow, demo
) -> None:
    driver.bot.keyClick(design, Key.Key_F11)
    (error,) = driver.dialogs.errors
    assert error.code == "window.no_project_to_compare"
    driver.dialogs.errors.clear()
    driver.window.document.open(demo.picked, demo.survey)
    driver.rest()
    design.activateWindow()
    driver.bot.keyClick(design, Key.Key_F11)
    wait_until_designed(driver)
    (error,) = driver.dialogs.errors
    assert error.code == "estimate.needed"
    driver.dialogs.errors.clear()
    assert design.compared.cells == []
