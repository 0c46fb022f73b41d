"""Tests of the background tasks of the design window: plan search and scenarios."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QDialog

from lispac.gui.features.design import controller
from lispac.gui.features.design.system import PlanSensorsDialog
from lispac.gui.features.design.window import DesignWindow
from lispac.workflow.planning.sensors import read_library
from tests.gui.design_support import plan, wait_until_designed
from tests.gui.support import WAIT_MS, Control, Driver, Key, click
from tests.support.message_codes import is_shown

SITE = """
title = "Pier"
facing_deg = 270
[board_choices]
boards = 1
along_m = [-1, 1]
up_m = [5]
inclination_deg = [45]
[line_choices]
lines = 3
headings_deg = [0, 45, 180]
distances_m = [10, 15]
[[natural]]
name = "tower"
along_m = 0
off_m = 0
up_m = 20
width_m = 5
height_m = 5
"""


def test_a_typed_list_with_one_comma_stops_the_search_until_it_is_clear(
    driver: Driver, design: DesignWindow
) -> None:
    design.tabs.setCurrentWidget(design.search)
    field = design.search.limits.lists["heights"]
    for text, heights in (("1,5", None), ("1,5; 2,5 m", (1.5, 2.5))):
        field.setFocus()
        field.selectAll()
        driver.bot.keyClicks(field, text)
        assert design.search.find.isEnabled() == (heights is not None)
        shown = design.search.error_label.text()
        assert is_shown("window.ambiguous_comma", shown) == (heights is None)
    assert design.search.limits.site(design.workspace.titled)[1].heights == (1.5, 2.5)


def test_the_best_plan_is_one_undo_step(driver: Driver, design: DesignWindow, tmp_path) -> None:
    design.tabs.setCurrentWidget(design.search)
    search, before = design.search, design.workspace.titled
    driver.dialogs.path = tmp_path / "pier.toml"
    driver.dialogs.path.write_text(SITE)
    click(driver, search.read)
    assert "tower" in search.about_file.text()
    field = search.limits.lists["distances"]
    field.setFocus()
    field.selectAll()
    driver.bot.keyClicks(field, "10, x")
    assert not search.find.isEnabled()
    assert is_shown("window.not_a_number_in", search.error_label.text())
    assert "“x”" in search.error_label.text()
    field.selectAll()
    driver.bot.keyClicks(field, "10, 15")
    click(driver, search.find)
    assert search.cancel.isEnabled()
    wait_until_designed(driver)
    assert driver.dialogs.errors == []
    assert "all 250 possible plans" in search.message_label.text()
    assert [t.name for t in plan(design).targets] == ["T1", "tower"]
    assert design.workspace.titled.title == "Pier"
    assert design.pictures.which.count() == 1
    driver.bot.keyClick(design, Key.Key_Z, Control)
    assert design.workspace.titled is before


def test_a_search_can_be_cancelled_and_changes_nothing(
    driver: Driver, design: DesignWindow
) -> None:
    design.tabs.setCurrentWidget(design.search)
    before, runner = design.workspace.titled, driver.window.site_design.runner
    design.search.plans.setValue(500)
    click(driver, design.search.find)
    driver.bot.waitUntil(
        lambda: runner.current is not None and "plans" in str(runner.current.step),
        timeout=WAIT_MS,
    )
    assert "plans/s" in str(runner.current.step) or runner.current.fraction > 0
    driver.bot.waitUntil(lambda: design.task_bar.cancel.isVisible(), timeout=WAIT_MS)
    driver.bot.keyClick(design, Key.Key_Period, Control)
    wait_until_designed(driver)
    assert design.workspace.titled is before
    assert design.search.find.isEnabled()
    assert driver.dialogs.errors == []


def test_scenarios_are_drawn_in_figures(driver: Driver, design: DesignWindow, monkeypatch) -> None:
    monkeypatch.setattr(controller, "SCENARIOS", ("size", "POS"))
    driver.bot.keyClick(design, Key.Key_F9)
    wait_until_designed(driver)
    pictures = design.pictures
    assert design.views.currentWidget() is pictures
    assert [pictures.which.itemText(k) for k in range(2)] == [
        "size (for the wall and boards of Shahraji's thesis)", "POS",
    ]  # fmt: skip
    assert len(pictures.pages.currentWidget().figure.axes) == 2
    driver.bot.keyClick(design, Key.Key_F9)
    wait_until_designed(driver)
    assert pictures.which.count() == 2


def test_sigmas_come_from_the_sensor_library(
    driver: Driver, design: DesignWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    opened_dialogs: list[PlanSensorsDialog] = []

    def choose(dialog: PlanSensorsDialog) -> int:
        opened_dialogs.append(dialog)
        dialog.choice.choose("zf-9012", "apogee:ppk")
        return QDialog.DialogCode.Accepted

    monkeypatch.setattr(PlanSensorsDialog, "exec", choose)
    before = design.workspace.titled.plan.system
    design.tabs.setCurrentWidget(design.system)
    driver.bot.mouseClick(design.system.library, Qt.MouseButton.LeftButton)
    known = read_library(driver.window.settings.sensors)
    figures, now = known.scanner("zf-9012"), design.workspace.titled.plan.system
    assert now.scanner.range_sigma == figures.range_sigma
    assert np.degrees(now.scanner.angle_sigma) == pytest.approx(figures.angle_sigma_deg)
    assert now.scanner.pulses_per_second == before.scanner.pulses_per_second
    state = next(s for p in known.pos if p.name == "apogee" for s in p.figures.states
                 if s.name == "ppk")  # fmt: skip
    assert now.pos.sigma_position == state.position_sigma
    assert np.degrees(now.pos.sigma_attitude) == pytest.approx(state.attitude_sigma_deg)
    assert design.system.range_sigma.value() == pytest.approx(1000 * figures.range_sigma)
    design.workspace.undo()
    assert design.workspace.titled.plan.system == before

    monkeypatch.setattr(PlanSensorsDialog, "exec", lambda _dialog: QDialog.DialogCode.Accepted)
    driver.bot.mouseClick(design.system.library, Qt.MouseButton.LeftButton)
    assert design.workspace.titled.plan.system == before
    assert len(opened_dialogs) == 1
