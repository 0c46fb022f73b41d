"""Tests of assumed standard deviations and of the values for the error budget in the window."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtWidgets import QLabel
from pytestqt.qtbot import QtBot

from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from lispac.gui.project.status import ADJUST
from lispac.messages import Level
from lispac.present.calibration.settings import settings_used
from lispac.present.calibration.sigmas import sigmas_used
from lispac.workflow.planning.sensors import noise_settings, read_library
from tests.gui.support import (
    WAIT_MS,
    Control,
    Demo,
    Driver,
    Key,
    click,
    open_step,
    press,
    type_into,
    wait_until_idle,
)
from tests.support.long_runs import LONG

ASSUMED = ("LiDAR", "POS position", "POS attitude")


def text_of(driver: Driver, name: str) -> str:
    label = driver.window.findChild(QLabel, name)
    assert label is not None
    return label.text()


def without_given_sigmas(driver: Driver) -> None:
    """Project without accuracy file, in which nobody gave a standard deviation."""
    project = driver.project
    settings = replace(project.settings, lidar_sigma=None, lidar_beam_sigma=None)
    driver.window.document.edit("change", replace(project, accuracy=None).with_settings(settings))
    driver.rest()


@LONG
def test_assumed_values_are_grey_until_they_are_typed(picked: Driver) -> None:
    data = picked.window.data
    open_step(picked, 0)
    without_given_sigmas(picked)
    assert picked.project.assumed_sigmas == ASSUMED
    assert data.lidar_sigma.is_assumed
    assert data.lidar_sigma.property("assumed")
    assert data.lidar_sigma.value() == 5.0
    assert data.pos_sigmas.position.value() == (0.02, 0.02, 0.03)
    assert "grey italics are assumed" in text_of(picked, "sigma_source")

    type_into(picked, data.lidar_sigma, "5")  # the same value, now given
    picked.bot.keyClick(data.lidar_sigma, Key.Key_Return)
    picked.rest()
    assert picked.project.settings.lidar_sigma == 0.005
    assert not data.lidar_sigma.is_assumed
    assert picked.project.assumed_sigmas == ASSUMED[1:]

    north = data.pos_sigmas.position.fields[0]
    type_into(picked, north, "0.012")
    picked.bot.keyClick(north, Key.Key_Return)
    picked.rest()
    assert picked.project.settings.position_sigma == pytest.approx((0.012, 0.02, 0.03))
    assert picked.project.assumed_sigmas == ("POS attitude",)
    assert not any(field.is_assumed for field in data.pos_sigmas.position.fields)


def test_an_assumed_noise_is_estimated_and_named_in_the_results(
    driver: Driver, denser_demo: Demo
) -> None:
    """The noise of the demo is about 1.7 mm on each axis."""
    picked, window = driver, driver.window
    window.document.open(denser_demo.picked, denser_demo.survey)
    settings = replace(picked.project.settings, lidar_sigma=None, lidar_beam_sigma=None)
    window.document.edit("change", picked.project.with_settings(settings))
    picked.rest()
    assert picked.project.assumed_sigmas == ("LiDAR",)
    picked.bot.keyClick(window, Key.Key_F9)
    picked.rest()
    result = picked.project.result
    assert result is not None
    assert result.sigma_factors[0] == pytest.approx(0.34, abs=0.06)
    assert result.chi_square.outcome != "failed"
    assert "assumed before: 5.0" in text_of(picked, "result_sigmas")
    assert not window.results.use_noise.isVisible()


@LONG
def test_assumed_sigmas_cause_no_alarm(driver: Driver, denser_demo: Demo) -> None:
    window = driver.window
    window.document.open(denser_demo.picked, denser_demo.survey)
    without_given_sigmas(driver)
    assert driver.project.assumed_sigmas == ASSUMED
    window.adjust.cross_check.setChecked(False)  # they take most of the time
    for key in (Key.Key_F9, Key.Key_F10):
        press(driver, key)
        driver.rest()
        wait_until_idle(driver)
    assert driver.project.result is not None
    assert driver.project.validation
    driver.bot.waitUntil(lambda: window.warning_list.is_current)
    on_sigmas = [each for each in window.warnings.messages if "sigma" in each.code]
    assert on_sigmas
    assert {each.level for each in on_sigmas} == {Level.NOTE}
    assert "(done)" in window.workflow.headers[ADJUST].toolTip()


def test_the_accuracies_of_the_file_are_shown(picked: Driver) -> None:
    data, survey = picked.window.data, picked.window.document.survey
    open_step(picked, 0)
    assert picked.project.accuracy is not None
    assert not data.pos_sigmas.position.isEnabled()
    medians = np.median(survey.accuracy.position, axis=0)
    np.testing.assert_allclose(data.pos_sigmas.position.value(), medians, atol=1e-9)
    assert picked.project.accuracy.name in text_of(picked, "sigma_source")


def test_only_values_of_the_adjustment_make_the_result_out_of_date(adjusted: Driver) -> None:
    data = adjusted.window.data
    open_step(adjusted, 0)
    before = adjusted.project.result
    type_into(adjusted, data.divergence, "0.5")
    adjusted.bot.keyClick(data.divergence, Key.Key_Return)
    adjusted.rest()
    assert adjusted.project.settings.beam_divergence_mrad == pytest.approx(0.5)
    assert adjusted.project.result is before
    field = data.lever_arm_sigma.fields[2]
    type_into(adjusted, field, "0.01")
    adjusted.bot.keyClick(field, Key.Key_Return)
    adjusted.rest()
    assert adjusted.project.settings.lever_arm_sigma == pytest.approx((0.0, 0.0, 0.01))
    assert adjusted.project.result is None


def test_a_sensor_fills_in_the_divergence_and_gives_the_sigmas(
    filled: ImportDialog, qtbot: QtBot
) -> None:
    page = filled.mounting
    assert page.lidar_sigma.is_assumed
    assert page.settings().assumed_sigmas == ASSUMED
    shown = page.pos_sigmas.position.value()
    accuracy = filled.input_files.accuracy
    assert accuracy is not None
    np.testing.assert_allclose(
        shown, np.median(accuracy.content.position, axis=0), atol=1e-9
    )  # those of the file, not the default
    page.sensors.choose("riegl-vux-1", "hydrins:rtk")
    settings = page.settings()
    assert settings.assumed_sigmas == ()
    assert settings.beam_divergence_mrad == pytest.approx(page.divergence.value()) != 0


@LONG
def test_a_typed_noise_replaces_the_range_noise_of_a_scanner(
    picked: Driver, tmp_path: Path
) -> None:
    window, data = picked.window, picked.window.data
    scanner = read_library(tmp_path).scanner("riegl-vux-1")
    assert scanner.angle_sigma_deg > 0
    settings = picked.project.settings.with_values(**noise_settings(scanner))
    window.document.edit("change", picked.project.with_settings(settings))
    window.adjust.cross_check.setChecked(False)
    open_step(picked, 0)
    picked.rest()
    assert data.lidar_sigma.value() == pytest.approx(1000 * scanner.range_sigma)
    assert "range" in text_of(picked, "lidar_sigma_title")
    assert data.angle_sigma.value() == pytest.approx(scanner.angle_sigma_deg)
    type_into(picked, data.lidar_sigma, "20")
    picked.bot.keyClick(data.lidar_sigma, Key.Key_Return)
    picked.rest()
    beam = (0.02, scanner.angle_sigma_deg)
    assert picked.project.settings.lidar_beam_sigma == pytest.approx(beam)
    assert data.lidar_sigma.value() == pytest.approx(20.0)
    press(picked, Key.Key_F9)
    picked.rest()
    result = picked.project.result
    assert result is not None
    assert result.lidar_noise_ratio is not None
    assert result.lidar_noise_ratio < 0.2, "the noise of the demo is less than 2 mm"
    assert sigmas_used(picked.project)[0].used == pytest.approx(beam)
    assert settings_used(picked.project).lidar_sigma_m == pytest.approx(0.02)
    press(picked, Key.Key_Z, Control)
    press(picked, Key.Key_Z, Control)
    picked.rest()
    assert picked.project.settings == settings, "one undo step for both settings"


def test_the_angular_noise_of_the_beam_is_entered_in_step_1(picked: Driver) -> None:
    window, data = picked.window, picked.window.data
    settings = picked.project.settings.with_values(lidar_sigma=0.004)
    window.document.edit("change", picked.project.with_settings(settings))
    open_step(picked, 0)
    picked.rest()
    assert data.angle_sigma.isVisible()
    assert data.angle_sigma.value() == 0.0
    type_into(picked, data.angle_sigma, "0.012")
    picked.bot.keyClick(data.angle_sigma, Key.Key_Return)
    picked.rest()
    assert picked.project.settings.lidar_beam_sigma == pytest.approx((0.004, 0.012))
    assert "range" in text_of(picked, "lidar_sigma_title")
    assert window.adjust.model.angle.value() == pytest.approx(0.012)
    type_into(picked, data.angle_sigma, "0")
    picked.bot.keyClick(data.angle_sigma, Key.Key_Return)
    picked.rest()
    assert picked.project.settings.lidar_beam_sigma is None
    assert picked.project.settings.lidar_sigma == pytest.approx(0.004)


def test_a_noise_per_axis_is_entered_with_a_way_to_its_model(picked: Driver) -> None:
    window, data = picked.window, picked.window.data
    settings = picked.project.settings.with_values(lidar_sigma_xyz=(0.003, 0.004, 0.012))
    window.document.edit("change", picked.project.with_settings(settings))
    open_step(picked, 0)
    picked.rest()
    assert not data.lidar_sigma.isVisible()
    assert data.lidar_axes.value() == pytest.approx((3.0, 4.0, 12.0))
    assert not data.angle_sigma.isVisible()
    type_into(picked, data.lidar_axes.fields[1], "5")
    picked.bot.keyClick(data.lidar_axes.fields[1], Key.Key_Return)
    picked.rest()
    assert picked.project.settings.lidar_sigma_xyz == pytest.approx((0.003, 0.005, 0.012))
    click(picked, data.show_noise_model)
    model = window.adjust.model
    picked.bot.waitUntil(model.noise.hasFocus, timeout=WAIT_MS)
    type_into(picked, model.axes[2], "15")
    picked.bot.keyClick(model.axes[2], Key.Key_Return)
    picked.rest()
    assert picked.project.settings.lidar_sigma_xyz == pytest.approx((0.003, 0.005, 0.015))
    assert data.lidar_axes.value() == pytest.approx((3.0, 5.0, 15.0))
    shown = picked.project.settings.used_lidar_sigma
    model.noise.setCurrentIndex(0)
    picked.rest()
    assert picked.project.settings.lidar_sigma_xyz is None
    assert picked.project.settings.used_lidar_sigma == shown
    assert data.lidar_sigma.value() == pytest.approx(1000 * shown)
