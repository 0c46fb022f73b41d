"""Tests of step 3: its settings and refusals, and new estimates after a click in the table."""

import re
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtWidgets import QLabel, QStyleOptionToolButton, QWidget
from pytestqt.qtbot import QtBot

from lispac.adjustment.model.parameters import Parameter
from lispac.adjustment.result import VarianceComponent
from lispac.errors import InputError
from lispac.gui.app.language import set_language
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.project.status import ADJUST, TARGETS
from lispac.gui.widgets.foldable_group import FoldableGroup
from lispac.language import gettext
from lispac.messages import error
from lispac.present.calibration.sigmas import sigmas_used
from lispac.project import Project
from lispac.survey.georeferencing import Mounting
from lispac.workflow.project.projects import open_project
from tests.gui.support import (
    Control,
    Demo,
    Driver,
    Key,
    click,
    click_check,
    estimate,
    finish_layouts,
    open_step,
    press,
    seed,
    sentence,
    show_panel,
    type_into,
    wait_until_idle,
)
from tests.support.long_runs import LONG
from tests.support.message_codes import codes, is_shown


@pytest.fixture
def estimated(estimated: Project) -> Project:
    """The estimated demo survey without cross-checks, so that none run after a click in the table.

    `test_gui_diagnostics` tests the cross-checks.
    """
    return replace(estimated, cross_checks=None)


def unfold(driver: Driver, fold: FoldableGroup) -> None:
    """Unfold a group of the panel, which scrolls."""
    open_step(driver, 2)
    click(driver, fold.head)
    assert fold.body.isVisible()


def angles(driver: Driver) -> np.ndarray:
    assert driver.project.result is not None
    return driver.project.result.boresight


def tick(driver: Driver, row: int, column: int) -> None:
    table = driver.window.table
    click_check(driver, table, table.sightings.index(row, column))


# -- settings ------------------------------------------------------------------------------------


def test_an_invalid_setting_is_reported_while_typing(picked: Driver):
    panel = picked.window.adjust
    unfold(picked, panel.also)
    switch, sigma = panel.parameters.switches["lever_x"], panel.parameters.sigmas["lever_x"]
    assert not sigma.isEnabled()
    click(picked, switch)
    assert panel.also.head.text() == "Additional parameters: lever arm X"
    for text, words in (
        ("5x", "not a number"),
        ("-3", "zero or negative"),
        ("0", "zero or negative"),
    ):
        type_into(picked, sigma, text)
        assert words in panel.problem.text()
        assert panel.problem.isVisible()
        assert not panel.estimate.isEnabled()
    press(picked, Key.Key_F9)
    assert not picked.window.runner.busy
    assert [each.reason.code for each in picked.dialogs.errors] == ["settings.zero_parameter_sigma"]
    type_into(picked, sigma, "0.005")
    assert not panel.problem.isVisible()
    assert panel.estimate.isEnabled()
    assert panel.settings().parameters == (Parameter("lever_x", 0.005),)
    assert picked.project.settings.parameters == (Parameter("lever_x", None),)
    picked.bot.keyClick(sigma, Key.Key_Return)
    assert picked.project.settings.parameters == (Parameter("lever_x", 0.005),)
    type_into(picked, sigma, "")
    assert panel.settings().parameters == (Parameter("lever_x", None),)


def test_errors_of_the_settings_are_shown(picked: Driver):
    panel = picked.window.adjust
    unfold(picked, panel.advanced)
    type_into(picked, panel.model.position_time.lineEdit(), "0")
    assert is_shown("settings.zero_correlation_time", panel.problem.text())
    type_into(picked, panel.model.position_time.lineEdit(), "120")
    panel.model.noise.setFocus()
    picked.bot.keyClick(panel.model.noise, Key.Key_Down)
    picked.bot.keyClick(panel.model.noise, Key.Key_Down)
    assert is_shown("window.lidar_beam_incomplete", panel.problem.text())
    type_into(picked, panel.model.angle, "0.02")
    assert panel.settings().lidar_beam_sigma == (picked.project.settings.lidar_sigma, 0.02)
    assert panel.settings().position_time == 120
    click(picked, panel.findChild(QWidget, "model_independent"))
    assert not panel.model.position_time.isEnabled()
    assert "times too small" in panel.model_sentence.text()


@LONG
def test_every_changed_setting_is_an_undo_step_and_is_used(picked: Driver):
    panel, before = picked.window.adjust, picked.project
    stack = picked.window.document.undo_stack
    first = stack.count()
    clouds = dict(picked.window.document.survey.clouds)
    unfold(picked, panel.also)
    click(picked, panel.parameters.switches["range_offset"])
    type_into(picked, panel.parameters.priors["range_offset"].lineEdit(), "0.02")
    unfold(picked, panel.advanced)
    type_into(picked, panel.model.surface, "0.5")
    panel.model.loss.setFocus()
    for _ in range(2):
        picked.bot.keyClick(panel.model.loss, Key.Key_Down)
    for axis, text in zip(panel.model.axes, ("2", "3", "4"), strict=True):
        panel.model.noise.setCurrentIndex(1)
        type_into(picked, axis, text)
    click(picked, panel.cross_check)
    panel.estimate.setFocus()
    picked.bot.keyClick(panel.estimate, Key.Key_Space)
    picked.rest()
    made = picked.project.settings
    assert made == replace(
        before.settings,
        parameters=(Parameter("range_offset"),),
        range_offset=0.02,
        surface=0.0005,
        loss="huber",
        lidar_sigma_xyz=(0.002, 0.003, 0.004),
    )
    (found,) = picked.project.result.parameters
    assert found.prior == pytest.approx(0.02)
    assert abs(found.value) < 4 * found.sigma  # the simulated survey has no range offset
    assert picked.project.cross_checks is None
    line = before.lines[0].name
    now = picked.window.document.survey.clouds[line].sample
    moved = np.linalg.norm(now - clouds[line].sample, axis=1)
    assert np.median(moved) == pytest.approx(0.02, abs=1e-6)
    # Parameter, its prior, form error, outliers (two choices), kind of noise, its three values
    assert stack.count() - first == 9 + 1
    press(picked, Key.Key_Z, Control)
    assert picked.project.result is None
    assert picked.project.settings == made
    while stack.count() and picked.project is not before:
        press(picked, Key.Key_Z, Control)
    picked.rest()
    assert picked.project is before
    again = picked.window.document.survey.clouds[line].sample
    assert np.abs(again - clouds[line].sample).max() < 1e-9
    assert not panel.parameters.switches["range_offset"].isChecked()


def test_the_text_on_correlation_times_is_not_cut_off(picked: Driver):
    picked.window.resize(1366, 768)
    panel = picked.window.adjust
    unfold(picked, panel.advanced)
    times = panel.model.times
    for kind in (0, 1, 2):
        panel.model.noise.setCurrentIndex(kind)
        finish_layouts()
        assert times.height() >= times.heightForWidth(times.width())


def test_the_point_count_is_that_of_the_result_if_there_is_one(
    driver: Driver, demo: Demo, estimated: Project
):
    driver.window.document.open(estimated, demo.survey)
    open_step(driver, 2)
    driver.rest()
    panel, points = driver.window.adjust, estimated.result.points
    assert f"<b>{points:,} points</b> in 12 sightings" in panel.count.text()
    panel.parameters.switches["lever_x"].click()
    driver.rest()
    assert driver.project.result is None
    assert panel.count.text().startswith("About <b>")
    panel.show_count(1, 1, 1)
    assert "<b>1 point</b> in 1 sighting" in panel.count.text()


def test_a_wrong_lever_arm_is_estimated(picked: Driver):
    truth = picked.project.settings.lever_arm
    open_step(picked, 0)
    type_into(picked, picked.window.data.lever_arm.fields[0].lineEdit(), f"{truth[0] + 0.06:.4f}")
    picked.bot.keyClick(picked.window.data.lever_arm.fields[0], Key.Key_Return)
    picked.rest()
    unfold(picked, picked.window.adjust.also)
    click(picked, picked.window.adjust.parameters.switches["lever_x"])
    estimate(picked)
    assert picked.project.result.estimated == ("roll", "pitch", "yaw", "lever_x")
    (found,) = picked.project.result.parameters
    assert abs(found.value - truth[0]) < 4 * found.sigma
    assert abs(found.value - found.prior) > 5 * found.sigma
    shown = picked.window.results.parameters.text()
    assert f"{found.value:+.4f}\u00a0m".replace("-", "−") in shown
    assert "significant" in shown


@LONG
def test_the_classical_model_keeps_its_warning(picked: Driver):
    open_step(picked, 2)
    click(picked, picked.window.adjust.findChild(QWidget, "model_independent"))
    estimate(picked)
    assert not picked.project.result.model.correlated
    assert "uncorrelated POS errors" in picked.window.results.warnings.text()
    assert picked.window.results.warnings.isVisible()


# -- a pending candidate, and errors -------------------------------------------------------------


@LONG
def test_estimate_asks_about_a_pending_candidate(opened: Driver, demo: Demo):
    opened.window.document.edit("picks", demo.project.with_target(demo.picked.target("T1")))
    seed(opened, "T2")
    press(opened, Key.Key_F9)
    assert opened.dialogs.requests == ["T2"]
    assert not opened.window.runner.busy
    assert opened.window.controller.candidate is not None
    opened.dialogs.candidate_choice = "accept"
    estimate(opened)
    assert {s.sighting.target for s in opened.project.result.sightings} == {"T1", "T2"}


@LONG
def test_the_workflow_follows_to_the_step_of_a_requested_result(picked: Driver):
    open_step(picked, TARGETS)
    estimate(picked)
    assert picked.window.workflow.opened == ADJUST
    open_step(picked, TARGETS)
    tick(picked, 0, 2)
    wait_until_idle(picked)
    assert picked.project.result is not None
    assert picked.window.workflow.opened == TARGETS  # it was not requested


def test_no_task_is_shown_as_running_behind_an_error(picked: Driver):
    shown = []
    bar = picked.window.task_bar.text
    picked.window.runner.failed.connect(lambda error: shown.append((str(error), bar.isVisible())))

    def fails(_progress):
        raise InputError("the file is short")

    picked.window.runner.run("Reading", fails, print)
    assert bar.isVisible()
    picked.rest()
    assert shown == [("the file is short", False)]


# -- estimates after a click in the table --------------------------------------------------------


def test_a_check_box_estimates_again_and_undo_reverts_both(picked: Driver):
    estimate(picked)
    first, whole = picked.project, angles(picked)
    assert picked.window.scene.which == "estimated"
    after = picked.viewport.clouds
    tick(picked, 0, 2)
    waiting = picked.window.results
    assert picked.project.result is None
    assert waiting.findChild(QWidget, "results_waiting").isVisible()
    assert not waiting.angles.isEnabled()
    wait_until_idle(picked)
    less = angles(picked)
    assert np.abs(less - whole).max() > 1e-7
    assert len(picked.project.result.sightings) == len(first.result.sightings) - 1
    assert waiting.angles.isEnabled()
    shown = f"{np.degrees(less[1]):+.4f}".replace("-", "−")
    assert waiting.angles.item(1, 1).text() == shown
    assert picked.window.scene.which == "estimated"
    assert picked.window.scene.has_estimated
    assert picked.viewport.clouds is not after
    press(picked, Key.Key_Z, Control)
    assert picked.project is first
    picked.rest()
    assert picked.window.scene.has_estimated
    press(picked, Key.Key_Y, Control)
    assert (angles(picked) == less).all()
    assert not picked.window.document.awaits_result
    assert picked.dialogs.errors == []

    # several clicks lead to one adjustment, and each is an undo step of its own
    picked.rest()
    log = picked.window.log
    before = log.toPlainText().count("estimated again")
    tick(picked, 1, 3)
    tick(picked, 1, 4)
    wait_until_idle(picked)
    assert log.toPlainText().count("estimated again") == before + 1
    assert len(picked.project.result.sightings) == len(first.result.sightings) - 3
    press(picked, Key.Key_Z, Control)
    wait_until_idle(picked)
    assert len(picked.project.result.sightings) == len(first.result.sightings) - 2
    press(picked, Key.Key_Z, Control)
    assert (angles(picked) == less).all()


@LONG
def test_a_whole_line_is_excluded_in_a_project_opened_with_its_result(
    driver: Driver, demo: Demo, estimated: Project
):
    driver.window.document.open(estimated, demo.survey)
    driver.rest()
    table, line = driver.window.table, estimated.lines[3].name
    row = table.sightings.rowCount() - 1
    assert table.sightings.data(table.sightings.index(row, 0)) == "Whole line"
    assert table.sightings.data(table.sightings.index(row, 4)) == "2 of 2 used"
    tick(driver, row, 4)
    wait_until_idle(driver)
    assert line not in {s.sighting.line for s in driver.project.result.sightings}
    assert len(driver.project.result.sightings) == len(estimated.result.sightings) - 2
    tick(driver, row, 4)
    wait_until_idle(driver)
    assert angles(driver) == pytest.approx(estimated.result.boresight, abs=1e-10)
    assert driver.window.actions_["undo"].text() == f"&Undo inclusion of line {line}"


@LONG
def test_too_few_sightings_are_refused_in_the_panel_without_a_message_box(
    driver: Driver, demo: Demo, estimated: Project
):
    driver.window.document.open(estimated, demo.survey)
    driver.rest()
    for column in range(2, 7):
        tick(driver, 0, column)
    wait_until_idle(driver)
    first = estimated.lines[0].name
    refusal = driver.window.results.refusal
    assert refusal.isVisible()
    only = message_text(error("adjustment.only_plane", target="T2"))
    assert only in refusal.text()
    assert is_shown("targets.single_line_targets", refusal.text())
    assert f"T1 on line {first}" in refusal.text()
    assert only in driver.window.task_bar.currentMessage()
    assert sentence(driver, 2) == "not estimated"
    assert driver.dialogs.errors == []
    assert driver.project.result is None
    tick(driver, 0, 2)
    wait_until_idle(driver)
    assert not refusal.isVisible()
    assert driver.project.result is not None
    driver.window.runner.cancel()


@LONG
def test_a_single_board_is_refused_until_one_orientation_is_accepted(
    driver: Driver, demo: Demo, estimated: Project
):
    driver.window.document.open(estimated, demo.survey)
    driver.rest()
    tick(driver, 1, 0)
    wait_until_idle(driver)
    refusal = driver.window.results.refusal
    assert refusal.isVisible()
    assert "The plane T1 is the only target" in refusal.text()
    model = driver.window.adjust.model
    assert model.accept_single_orientation.text() in refusal.text()
    assert driver.window.adjust.advanced.head.text() in refusal.text()
    unfold(driver, driver.window.adjust.advanced)
    click(driver, model.accept_single_orientation)
    assert (
        driver.window.adjust.advanced.head.text() == "Advanced: targets of one orientation accepted"
    )
    estimate(driver)
    assert driver.project.settings.accept_single_orientation
    observability = driver.project.result.observability
    assert "adjustment.one_target" in codes(observability.messages)
    assert not refusal.isVisible()
    for _ in range(2):
        press(driver, Key.Key_Z, Control)
    driver.rest()
    assert not model.accept_single_orientation.isChecked()


def test_an_automatic_estimate_can_be_cancelled(driver: Driver, demo: Demo, estimated: Project):
    driver.window.document.open(estimated, demo.survey)
    driver.rest()
    tick(driver, 0, 2)
    driver.bot.waitUntil(lambda: driver.window.runner.busy)
    press(driver, Key.Key_Period, Control)
    wait_until_idle(driver)
    assert driver.project.result is None
    assert "cancelled. Press Estimate" in driver.window.results.refusal.text()
    assert driver.window.actions_["estimate"].isEnabled()
    assert driver.dialogs.errors == []


def test_an_unexpected_failure_is_reported_once(
    driver: Driver, demo: Demo, estimated: Project, monkeypatch: pytest.MonkeyPatch
):
    def fails(*_arguments, **_named):
        raise ZeroDivisionError

    monkeypatch.setattr("lispac.workflow.calibration.estimation.reselect_points", fails)
    driver.window.document.open(estimated, demo.survey)
    driver.rest()
    tick(driver, 0, 2)
    wait_until_idle(driver)
    driver.bot.wait(600)
    assert [type(error) for error in driver.dialogs.errors] == [ZeroDivisionError]
    assert "failed. Press Estimate" in driver.window.results.refusal.text()


def test_a_pick_after_an_estimate_starts_no_new_estimate(picked: Driver, estimated: Project):
    picked.window.document.edit("estimate", estimated)
    picked.window.controller.remove("T2")
    assert not picked.window.document.awaits_result
    picked.rest()
    assert picked.project.result is None
    text = picked.window.results.findChild(QWidget, "results_empty").text()
    assert is_shown("project.out_of_date", text)


def test_a_steep_pitch_is_shown_as_a_matrix_and_by_the_axes(
    driver: Driver, demo: Demo, estimated: Project
):
    driver.window.document.open(estimated, demo.survey)
    driver.rest()
    shown = driver.window.results.rotation
    assert not shown.isVisible()
    mounting = Mounting.with_nearest_axes(
        np.array(estimated.settings.lever_arm), np.radians([20.0, 89.3, 58.2])
    )
    steep = replace(estimated, result=replace(estimated.result, mounting=mounting))
    driver.window.document.open(steep, demo.survey)
    driver.rest()
    assert shown.isVisible()
    text = shown.text().replace("−", "-")
    for value in mounting.rotation_body_lidar.ravel():
        assert f"{value:+.8f}" in text
    assert "X down" in text


@LONG
def test_a_conservative_lidar_noise_is_replaced_by_that_of_the_residuals(
    driver: Driver, denser_demo: Demo
):
    """The noise of the demo is that of range and angles, about 1.7 mm on each axis."""
    picked, window = driver, driver.window
    window.document.open(denser_demo.picked, denser_demo.survey)
    driver.rest()
    window.adjust.cross_check.setChecked(False)
    open_step(picked, 0)
    type_into(picked, window.data.lidar_sigma, "6")
    press(picked, Key.Key_F9)
    picked.rest()
    results = window.results
    assert picked.project.result is not None
    assert picked.project.result.chi_square.outcome == "conservative"
    assert "conservative" in results.findChild(QLabel, "result_chi").text()
    show_panel(window, "Results")
    assert re.search(r"1\.[5-9]\d.mm instead of 6\.00.mm", results.use_noise.text())
    click(picked, results.use_noise)
    picked.rest()
    assert picked.project.settings.lidar_sigma == pytest.approx(0.0017, abs=0.0003)
    assert window.data.lidar_sigma.value() == pytest.approx(1.7, abs=0.3)
    assert picked.project.result is not None
    assert picked.project.result.chi_square.passed
    assert not results.use_noise.isVisible()
    assert picked.project.settings.is_lidar_noise_from_residuals
    assert picked.project.result.lidar_noise_from_residuals
    assert "not judged" in results.findChild(QLabel, "result_chi").text()
    assert "estimated from the residuals" in results.findChild(QLabel, "result_sigmas").text()
    assert sigmas_used(picked.project)[0].source == "estimated"
    open_step(picked, 0)
    assert "estimated from the residuals" in window.data.findChild(QLabel, "sigma_source").text()
    assert window.controller.save()
    assert open_project(picked.project.folder).settings.is_lidar_noise_from_residuals

    type_into(picked, window.data.lidar_sigma, "2.4")
    picked.bot.keyClick(window.data.lidar_sigma, Key.Key_Return)
    picked.rest()
    assert not picked.project.settings.is_lidar_noise_from_residuals
    window.document.undo_stack.undo()
    picked.rest()
    assert picked.project.settings.is_lidar_noise_from_residuals
    while picked.project.settings.lidar_sigma != 0.006:
        window.document.undo_stack.undo()
    assert not picked.project.settings.is_lidar_noise_from_residuals


@LONG
def test_the_values_of_the_fit_are_not_cut_after_a_change(adjusted: Driver) -> None:
    result = adjusted.project.result
    assert result is not None
    lidar = VarianceComponent("LiDAR", 0.7, 0.65, 0.75, applied=True)
    labels = [
        each
        for each in adjusted.window.results.findChildren(QLabel)
        if each.objectName().startswith("result_")
    ]
    assert labels
    for components in ((lidar,), (), (lidar,)):
        changed = replace(adjusted.project, result=replace(result, components=components))
        adjusted.window.document.edit("components", changed)
        adjusted.rest()
        assert [x.objectName() for x in labels if x.height() < x.heightForWidth(x.width())] == []


def test_the_missing_field_of_the_lidar_noise_is_named_and_shown(picked: Driver) -> None:
    panel = picked.window.adjust
    unfold(picked, panel.advanced)
    panel.model.noise.setFocus()
    for _ in range(2):
        picked.bot.keyClick(panel.model.noise, Key.Key_Down)
    picked.rest()
    # The field is in view at once, and its name and unit are beside it.
    assert not panel.model.angle.visibleRegion().isEmpty()
    for field in (panel.model.range, panel.model.angle):
        name = field.accessibleName()
        labels = [each for each in panel.model.findChildren(QLabel) if each.buddy() is field]
        assert [each.text() for each in labels] == [name]
        assert labels[0].isVisible()
    assert panel.input_error is not None
    assert panel.input_error.code == "window.lidar_beam_incomplete"
    assert panel.input_error.params["fields"] == (panel.model.angle.accessibleName(),)
    assert panel.model.angle.accessibleName() in panel.problem.text()
    assert not panel.estimate.isEnabled()
    panel.advanced.open(False)
    click(picked, panel.show_field)
    picked.rest()
    assert panel.advanced.body.isVisible()
    assert panel.model.angle.hasFocus()
    assert not panel.model.angle.visibleRegion().isEmpty()
    type_into(picked, panel.model.angle, "0.00524")
    metrics = panel.model.angle.fontMetrics()
    assert panel.model.angle.width() > metrics.horizontalAdvance("0.00524") + 20
    picked.rest()
    assert panel.input_error is None
    assert not panel.show_field.isVisible()
    assert panel.estimate.isEnabled()


@pytest.mark.parametrize("language", ["en", "fr"])
def test_a_long_header_of_a_group_is_cut_at_its_end(qtbot: QtBot, language: str) -> None:
    set_language(language)
    group = FoldableGroup(gettext("Advanced"), "fold", QWidget())
    qtbot.addWidget(group)
    group.set_summary(f"{gettext('range and angle noise')}, {gettext('given form error')}")
    group.resize(200, 40)
    group.show()
    option = QStyleOptionToolButton()
    group.head.initStyleOption(option)
    assert len(option.text) < len(group.head.text())
    assert option.text.endswith("…")
    assert group.head.text().startswith(option.text[:-1])
    # The style does not cut the text again.
    free = group.head.width() - option.iconSize.width() - 4
    assert option.fontMetrics.horizontalAdvance(option.text) <= free
    group.resize(900, 40)
    group.head.initStyleOption(option)
    assert option.text == group.head.text()
    set_language("en")
