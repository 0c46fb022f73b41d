"""Tests that a refused estimate keeps the former result and marks it as out of date."""

import json
from dataclasses import replace
from html import unescape
from pathlib import Path

import numpy as np

from lispac.adjustment.diagnostics.warnings import outdated_result_warning
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.report.report_export import ReportExport
from tests.gui.support import WAIT_MS, Control, Driver, Key, press, wait_until_idle


def test_window_and_report_mark_the_result_as_out_of_date(adjusted: Driver, tmp_path: Path) -> None:
    before = adjusted.project.result
    settings = replace(adjusted.project.settings, surface=-1.0)
    adjusted.window.estimation.estimate(settings, False)
    adjusted.rest()
    assert adjusted.project.result is before
    [refusal] = adjusted.dialogs.errors
    expected = outdated_result_warning(refusal.reason)
    words = message_text(expected)
    assert words in unescape(adjusted.window.results.warnings.text())
    reporting = adjusted.window.findChild(ReportExport)
    report = tmp_path / "r.json"
    adjusted.dialogs.path = report
    reporting.export()
    adjusted.rest()
    warnings = json.loads(report.read_text())["warnings"]
    assert [
        (each["level"], each["text"]) for each in warnings if each["code"] == expected.code
    ] == [("warning", words)]

    adjusted.window.controller.rename("T1", "North wall")  # the boresight is estimated again
    assert words in unescape(adjusted.window.results.warnings.text())
    adjusted.window.estimation.estimate(adjusted.project.settings, False)
    adjusted.rest()
    assert adjusted.project.result is not before
    assert adjusted.window.document.refused_since == ""
    assert words not in unescape(adjusted.window.results.warnings.text())


def test_undo_shows_the_lines_of_the_restored_result_after_the_calibration(
    adjusted: Driver,
) -> None:
    window = adjusted.window
    adjusted.bot.waitUntil(lambda: window.scene.which == "estimated", timeout=WAIT_MS)
    without = replace(adjusted.project, result=None, cross_checks=None)
    window.document.edit("removal of the result", without)
    adjusted.rest()
    assert window.scene.which == "prior"
    press(adjusted, Key.Key_Z, Control)
    adjusted.rest()
    assert adjusted.project.result is not None
    assert window.scene.which == "estimated"
    assert window.actions_["after"].isChecked()
    window.actions_["before"].trigger()
    window.document.edit("removal of the result", without)
    press(adjusted, Key.Key_Z, Control)
    adjusted.rest()
    assert window.scene.which == "prior", "the choice of the user is kept"


def test_several_undo_steps_to_a_result_show_the_lines_after_the_calibration(
    adjusted: Driver,
) -> None:
    window = adjusted.window
    adjusted.bot.waitUntil(lambda: window.scene.which == "estimated", timeout=WAIT_MS)
    result = adjusted.project.result
    without = replace(adjusted.project, result=None, cross_checks=None)
    window.document.edit("removal of the result", without)
    adjusted.rest()
    x, y, z = without.settings.lever_arm
    window.controller.change_settings(replace(without.settings, lever_arm=(x + 0.1, y, z)))
    adjusted.rest()
    assert window.scene.which == "prior"
    for _ in range(2):
        press(adjusted, Key.Key_Z, Control)
        adjusted.rest()
    assert adjusted.project.result is result
    assert window.scene.which == "estimated"


def test_reason_of_a_failed_first_estimate_stays_after_its_message(adjusted: Driver) -> None:
    window = adjusted.window
    without = replace(adjusted.project, result=None, cross_checks=None)
    window.document.edit("removal of the result", without)
    adjusted.rest()
    window.estimation.estimate(replace(without.settings, surface=-1.0), False)
    adjusted.rest()
    [refusal] = adjusted.dialogs.errors
    words = message_text(refusal.reason)
    assert window.adjust.advice.text() == words
    assert window.results.refusal.text() == words
    window.controller.rename("T1", "North wall")
    assert window.adjust.advice.text() != words, "an edit may remove the reason"
    press(adjusted, Key.Key_Z, Control)
    assert window.adjust.advice.text() == words
    window.estimation.estimate(without.settings, False)
    adjusted.rest()
    assert adjusted.project.result is not None
    assert window.document.refusal == ""


def test_the_boresight_is_estimated_again_after_a_target_is_renamed(adjusted: Driver) -> None:
    before = adjusted.project.result
    adjusted.window.controller.rename("T1", "North wall")
    wait_until_idle(adjusted)
    after = adjusted.project.result
    assert after is not None
    np.testing.assert_allclose(after.boresight, before.boresight, atol=1e-9)
    assert {each.sighting.target for each in after.reliability} == {"North wall", "T2"}
    press(adjusted, Key.Key_Z, Control)
    assert adjusted.project.result is before
