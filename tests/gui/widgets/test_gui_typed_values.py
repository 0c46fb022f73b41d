"""Tests that a typed value is used by the next action, or that the action is refused."""

import re
from dataclasses import replace
from html import unescape
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication, QLineEdit, QWidget
from pytestqt.qtbot import QtBot

from lispac.errors import InputError
from lispac.gui.app.docks import raise_panel
from lispac.gui.app.unavailable import Unavailable
from lispac.gui.features.design.window import DesignWindow
from lispac.gui.features.preferences.dialogs import SettingsDialog
from lispac.gui.features.preferences.preferences import Preferences
from lispac.gui.widgets.number_field import NumberField
from lispac.project import Project
from lispac.workflow.project.projects import open_project
from tests.gui.design_support import type_cell
from tests.gui.support import (
    Control,
    Demo,
    Driver,
    Key,
    Left,
    click,
    in_front,
    open_step,
    press,
    seed,
    sentence,
    type_into,
)
from tests.support.long_runs import LONG, others_long
from tests.support.message_codes import is_shown


def lever_x(driver: Driver) -> NumberField:
    return driver.window.data.lever_arm.fields[0]


def type_lever_x(driver: Driver, text: str) -> NumberField:
    """Type the lever arm X without Enter; the focus stays in the field."""
    open_step(driver, 0)
    field = lever_x(driver)
    type_into(driver, field, text)
    assert field.hasFocus()
    return field


def open_estimated(driver: Driver, demo: Demo, estimated: Project) -> None:
    driver.window.document.open(estimated, demo.survey)
    driver.rest()


def refusals(driver: Driver) -> list[str]:
    """Codes of the errors shown so far, which are then forgotten."""
    shown = [each.reason.code for each in driver.dialogs.errors if isinstance(each, InputError)]
    driver.dialogs.errors.clear()
    return shown


def test_f9_estimates_with_the_value_being_typed(picked: Driver) -> None:
    picked.window.adjust.cross_check.setChecked(False)
    field = type_lever_x(picked, "-0.15")
    picked.bot.keyClick(field, Key.Key_F9)
    assert picked.project.settings.lever_arm[0] == -0.15
    picked.rest()
    assert picked.project.result is not None
    assert picked.project.result.mounting.lever_arm[0] == -0.15
    assert field.text() == "−0.1500 m"
    assert picked.window.document.undo_stack.count() == 2  # the change and the estimate


@LONG
def test_f9_estimates_with_the_prior_angle_being_typed(picked: Driver) -> None:
    picked.window.adjust.cross_check.setChecked(False)
    open_step(picked, 0)
    field = picked.window.data.boresight.fields[1]
    type_into(picked, field, "-0,8°")
    assert field.hasFocus()
    picked.bot.keyClick(field, Key.Key_F9)
    assert picked.project.settings.boresight_deg[1] == -0.8
    picked.rest()
    assert picked.project.result is not None
    assert np.degrees(picked.project.result.boresight[1]) == pytest.approx(-1.14, abs=0.1)
    assert picked.window.document.undo_stack.count() == 2  # the change and the estimate


@LONG
def test_f9_estimates_with_the_latency_being_typed(picked: Driver) -> None:
    panel = picked.window.adjust
    panel.cross_check.setChecked(False)
    open_step(picked, 2)
    click(picked, panel.also.head)
    field = panel.parameters.priors["latency"]
    type_into(picked, field, "2")
    assert field.hasFocus()
    picked.bot.keyClick(field, Key.Key_F9)
    assert picked.project.settings.latency == pytest.approx(0.002)  # the field is in milliseconds
    picked.rest()
    assert picked.project.result is not None
    assert picked.project.result.mounting.latency == pytest.approx(0.002)


@LONG
def test_the_estimate_button_uses_the_value_being_typed(picked: Driver) -> None:
    picked.window.adjust.cross_check.setChecked(False)
    type_lever_x(picked, "-0.15")
    picked.window.workflow.open(2)  # does not move the focus
    click(picked, picked.window.adjust.estimate)
    picked.rest()
    assert picked.project.result is not None
    assert picked.project.result.mounting.lever_arm[0] == -0.15


def test_the_result_is_out_of_date_as_soon_as_the_focus_leaves(
    driver: Driver, demo: Demo, estimated: Project
) -> None:
    open_estimated(driver, demo, estimated)
    field = type_lever_x(driver, "5")
    assert driver.project is estimated
    sketch = driver.window.data.mounting.sketch
    assert sketch.lever_arm[0] == 5.0  # a preview
    driver.bot.keyClick(field, Key.Key_Tab)
    assert driver.project.settings.lever_arm[0] == 5.0
    assert driver.project.result is None
    assert driver.window.document.is_result_outdated
    empty = driver.window.results.findChild(QWidget, "results_empty")
    assert is_shown("project.out_of_date", empty.text())
    empty = driver.window.histograms.findChild(QWidget, "histograms_empty")
    assert is_shown("project.out_of_date", empty.text())
    assert not driver.window.actions_["report"].isEnabled()
    driver.rest()
    focused = QApplication.focusWidget()
    assert focused is driver.window.data.lever_arm.fields[1]
    driver.bot.keyClick(focused, Key.Key_Z, Control)
    driver.rest()
    assert driver.project is estimated
    assert field.value() == sketch.lever_arm[0] == estimated.settings.lever_arm[0]
    assert not driver.window.document.undo_stack.canUndo()


def step_states(driver: Driver) -> list[str]:
    """States of the steps 3 to 5, which their headers show in brackets."""
    tips = [header.toolTip() for header in driver.window.workflow.headers[2:]]
    return [re.findall(r"\((not started|to do|done|check this step)\)", tip)[-1] for tip in tips]


def test_each_input_of_the_estimate_makes_later_steps_out_of_date(
    driver: Driver, demo: Demo, validated: Project
) -> None:
    before = replace(validated, accuracy=None)  # else the file gives the sigmas
    window = driver.window
    window.document.open(before, demo.survey)
    driver.rest()
    shown = step_states(driver)
    assert "not started" not in shown
    data, histograms = window.data, window.histograms
    empty = histograms.findChild(QWidget, "histograms_empty")
    latency = window.adjust.parameters.priors["latency"]
    fields = [
        (0, data.lever_arm.fields[1], "0,25 m"),
        (0, data.pos_sigmas.attitude.fields[2], "0.03"),
        (0, data.boresight.fields[0], "-1.5"),
        (2, latency, "2 ms"),
    ]
    report = window.actions_["report"]
    for step, field, text in fields:
        assert histograms.table.rowCount() == len(validated.validation)
        assert not empty.isVisibleTo(histograms)
        assert report.isEnabled()
        open_step(driver, step)
        if field is latency and not latency.isVisible():
            click(driver, window.adjust.also.head)
        type_into(driver, field, text)
        assert driver.project.result is not None
        if field is latency:
            driver.bot.mouseClick(driver.viewport.widget, Left)
        else:
            driver.bot.keyClick(field, Key.Key_Tab)
        assert not window.document.is_survey_current
        assert sentence(driver, 2) == sentence(driver, 1), "waiting for data"
        assert step_states(driver) == ["not started"] * 3
        assert driver.project.validation == ()
        assert empty.isVisibleTo(histograms)
        assert not report.isEnabled()
        assert window.actions_.reason("report") is Unavailable.NO_RESULT
        assert Unavailable.NO_RESULT.text in report.toolTip()
        if field is latency:
            driver.rest()
            assert step_states(driver) == ["to do", "not started", "not started"]
        press(driver, Key.Key_Z, Control)
        assert driver.project is before
        driver.bot.waitUntil(lambda: step_states(driver) == shown and report.isEnabled())


@pytest.mark.parametrize("key", others_long([Key.Key_Return, Key.Key_Enter]))
def test_undo_works_in_the_field_after_enter(picked: Driver, key: Key) -> None:
    before = picked.project
    field = type_lever_x(picked, "5")
    picked.bot.keyClick(field, key)
    assert picked.project.settings.lever_arm[0] == 5.0
    assert field.hasFocus()
    picked.bot.keyClick(field, Key.Key_Z, Control)
    picked.rest()
    assert picked.project is before
    assert field.value() == before.settings.lever_arm[0]


def test_undo_while_typing_reverts_the_typing(picked: Driver) -> None:
    before = picked.project
    field = type_lever_x(picked, "5")
    while field.lineEdit().isUndoAvailable():
        picked.bot.keyClick(field, Key.Key_Z, Control)
    picked.bot.keyClick(field, Key.Key_Tab)
    assert picked.project is before


def test_closing_asks_to_save_the_value_being_typed(picked: Driver) -> None:
    field = type_lever_x(picked, "5")
    picked.dialogs.save_choice = "cancel"
    picked.bot.keyClick(field, Key.Key_Q, Control)
    assert picked.dialogs.requests == [picked.project.name]
    assert picked.window.isVisible()
    assert picked.project.settings.lever_arm[0] == 5.0


@LONG
def test_save_stores_the_value_being_typed(driver: Driver, picked_folder: Path) -> None:
    driver.window.open_project(picked_folder)
    driver.bot.waitUntil(lambda: driver.window.document.project is not None)
    driver.rest()
    assert not driver.window.actions_["save"].isEnabled()
    field = type_lever_x(driver, "5")
    driver.bot.keyClick(field, Key.Key_S, Control)
    assert open_project(picked_folder).settings.lever_arm[0] == 5.0
    assert not driver.window.document.is_modified


def test_no_action_runs_with_a_former_value(picked: Driver) -> None:
    before = picked.project
    field = type_lever_x(picked, "abc")
    picked.bot.keyClick(field, Key.Key_F9)
    assert refusals(picked) == ["window.not_a_number_in"]
    assert not picked.window.runner.busy
    picked.bot.keyClick(field, Key.Key_Tab)  # the text stays
    assert field.cleanText() == "abc"
    assert field.property("wrong")
    for name in ("estimate", "save_as", "lines"):
        picked.window.actions_[name].trigger()
        assert refusals(picked) == ["window.not_a_number_in"]
    click_estimate(picked)
    assert refusals(picked) == ["window.not_a_number_in"]
    assert picked.project is before
    assert not picked.window.runner.busy
    picked.dialogs.save_choice = "save"
    assert not picked.window.close()
    assert picked.dialogs.requests == [before.name]
    assert refusals(picked) == ["window.not_a_number_in"]
    open_step(picked, 0)
    field.setFocus()
    picked.bot.keyClick(field, Key.Key_Escape)
    assert field.value() == before.settings.lever_arm[0]
    assert not field.property("wrong")
    press(picked, Key.Key_F9)
    assert picked.window.runner.busy


def click_estimate(driver: Driver) -> None:
    open_step(driver, 2)
    click(driver, driver.window.adjust.estimate)


@LONG
def test_another_edit_keeps_a_wrong_text(picked: Driver) -> None:
    field = type_lever_x(picked, "abc")
    other = picked.window.data.lever_arm.fields[1]
    type_into(picked, other, "0.05")
    picked.bot.keyClick(other, Key.Key_Return)
    assert picked.project.settings.lever_arm[1] == 0.05
    picked.rest()
    assert field.cleanText() == "abc"
    assert field.property("wrong")
    picked.window.document.open(picked.project, picked.window.document.survey)
    assert field.value() == picked.project.settings.lever_arm[0]
    assert field.input_error is None


def test_settings_of_the_adjustment_belong_to_the_project(
    driver: Driver, demo: Demo, estimated: Project, demo_copy: Path
) -> None:
    estimated = replace(estimated, folder=demo_copy)  # the project is saved
    open_estimated(driver, demo, estimated)
    open_step(driver, 2)
    panel = driver.window.adjust
    click(driver, panel.advanced.head)
    time = panel.model.position_time
    type_into(driver, time, "2 min")
    driver.bot.keyClick(time, Key.Key_Tab)
    assert driver.project.settings.position_time == 120.0
    assert driver.project.result is None
    assert driver.window.document.is_modified
    type_into(driver, panel.distance, "0.2 m")  # the field is in centimetres
    assert panel.distance.value() == 20.0
    driver.bot.keyClick(panel.distance, Key.Key_Tab)
    assert driver.project.settings.subsample == 0.2
    type_into(driver, panel.model.surface, "0,5")
    driver.bot.keyClick(panel.model.surface, Key.Key_S, Control)
    assert driver.project.settings.surface == 0.0005
    for _ in range(3):
        press(driver, Key.Key_Z, Control)
    assert driver.project is estimated
    assert time.value() == estimated.settings.position_time


def test_a_target_is_not_searched_with_a_former_radius(opened: Driver) -> None:
    open_step(opened, 1)
    radius = opened.window.targets.findChild(NumberField, "search_radius")
    type_into(opened, radius, "1..5")
    seed(opened, "T1")
    assert refusals(opened) == ["window.not_a_number_in"]
    assert opened.window.controller.candidate is None
    type_into(opened, radius, "150 cm")
    seed(opened, "T1")
    assert opened.window.targets.radius == 1.5
    assert opened.window.controller.candidate is not None


def test_a_click_elsewhere_commits_the_value(picked: Driver) -> None:
    type_lever_x(picked, "5")
    label = picked.window.data.findChild(QWidget, "trajectory_name")
    picked.bot.mouseClick(label, Left)  # a label does not take the focus
    assert picked.project.settings.lever_arm[0] == 5.0


# -- other panels, tables and dialogues ----------------------------------------------------------


def test_no_angles_are_converted_from_a_wrong_text(opened: Driver) -> None:
    panel = opened.window.panels["convention"]
    raise_panel(panel)
    assert panel.table.isVisible()
    roll = panel.inputs.boresight.fields[0]
    type_into(opened, roll, "1.2.3")
    assert not panel.table.isVisible()
    assert is_shown("window.not_a_number_in", unescape(panel.assumption.text()))
    type_into(opened, roll, "1,25")
    assert panel.table.isVisible()
    assert np.degrees(panel.inputs.mounting.boresight[0]) == pytest.approx(1.25)


@LONG
def test_a_patch_test_does_not_search_from_a_former_angle(opened: Driver) -> None:
    controller = opened.window.panel_controllers["patch_test"]
    opened.window.actions_["patch_test"].trigger()
    click(opened, controller.panel.propose)
    opened.rest()
    angles = controller.panel.angles
    before = angles.boresight
    type_into(opened, angles.fields[0], "e1")
    click(opened, angles.find_buttons[0])
    assert refusals(opened) == ["window.not_a_number_in"]
    assert not opened.window.runner.busy
    assert (angles.boresight == before).all()


def test_a_dialogue_is_not_accepted_with_a_wrong_number(qtbot: QtBot, tmp_path: Path) -> None:
    dialog = SettingsDialog(Preferences(), tmp_path / "sensors")
    qtbot.addWidget(dialog)
    dialog.show()
    qtbot.waitUntil(lambda: in_front(dialog))
    field = dialog.point_size
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "99")
    qtbot.mouseClick(dialog.keep, Left)
    assert dialog.isVisible()
    assert field.hasFocus()
    assert field.cleanText() == "99"
    field.selectAll()
    qtbot.keyClicks(field, "4")
    qtbot.keyClick(field, Key.Key_Return)
    assert not dialog.isVisible()
    assert dialog.preferences.point_size == 4


def test_a_cell_keeps_a_wrong_text_and_the_plan_is_not_used(
    driver: Driver, design: DesignWindow
) -> None:
    table, before = design.lines.table, design.workspace.titled
    editor = type_cell(driver, table, 2, 2, "2..5")
    place = table.visualRect(table.model().index(0, 2)).center()
    driver.bot.mouseClick(table.viewport(), Left, pos=place)
    assert table.findChild(QLineEdit) is editor
    assert editor.text() == "2..5"
    assert design.workspace.titled is before
    driver.bot.keyClick(design, Key.Key_S, Control)
    design.actions_["save_as"].trigger()
    assert refusals(driver) == ["window.not_a_number_in"]
    driver.bot.keyClick(editor, Key.Key_Escape)
    assert editor.isHidden() or table.findChild(QLineEdit) is not editor


def test_a_shortcut_commits_the_cell_being_typed(driver: Driver, design: DesignWindow) -> None:
    editor = type_cell(driver, design.lines.table, 2, 2, "2050 cm")
    driver.bot.keyClick(editor, Key.Key_L, Control)
    assert design.workspace.titled.plan.lines[2].distance == 20.5


def test_a_field_of_the_survey_system_keeps_a_wrong_text(
    driver: Driver, design: DesignWindow
) -> None:
    design.tabs.setCurrentWidget(design.system)
    field = design.system.max_range
    type_into(driver, field, "0.15 km")
    driver.bot.keyClick(field, Key.Key_Return)
    assert design.workspace.titled.plan.system.scanner.max_range == 150.0
    type_into(driver, field, "far")
    design.actions_["save_as"].trigger()
    assert refusals(driver) == ["window.not_a_number_in"]
    assert field.cleanText() == "far"
    assert design.workspace.titled.plan.system.scanner.max_range == 150.0
