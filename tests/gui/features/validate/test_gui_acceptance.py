"""Tests of the acceptance criteria of step 4, typed and judged in the window."""

import json
import threading
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QLabel
from pytestqt.qtbot import QtBot

from lispac.acceptance import NO_CRITERIA, AcceptanceCriteria, largest_offset
from lispac.adjustment.diagnostics.cause_warnings import EXPLAINED_CODES
from lispac.adjustment.result import CrossCheck, CrossChecks, PossibleCause
from lispac.gui.appearance import theme
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.validate.acceptance_form import CriterionResultLabel
from lispac.gui.features.validate.histograms_panel import (
    PAIR_COLOURS_HINT,
    PAIRS_HINT,
    PAIRS_VIEW,
    HistogramsPanel,
)
from lispac.gui.features.validate.pairs_table import OFFSET_AFTER
from lispac.gui.features.validate.planes_table import P95, RMS
from lispac.gui.project.status import REPORT, VALIDATE, step_statuses
from lispac.io.project.project_file import read_project
from lispac.language import gettext
from lispac.messages import note
from lispac.present.checking.acceptance import AcceptanceValues, CriterionResult
from lispac.present.checking.validation import ValidationPlane
from lispac.project import Project
from lispac.report.validation_warnings import probable_causes
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
    type_into,
)
from tests.support.long_runs import LONG, others_long
from tests.support.message_codes import is_shown
from tests.support.view_scenes import array_of

PEAKS = {"target": "V1", "smaller": 0.01, "larger": 0.05}


@pytest.fixture
def judged(driver: Driver, demo: Demo, validated: Project) -> Driver:
    """A window with a validated project at step 4."""
    driver.window.document.open(replace(validated), demo.survey)
    driver.rest()
    open_step(driver, VALIDATE)
    return driver


def test_step_4_shows_the_messages_on_the_comparison(judged: Driver) -> None:
    step, peaks = judged.window.validate, note("validation.peaks_on_plane", **PEAKS)
    several = note("validation.several_peaks_unknown", items=(peaks,))
    judged.window.warning_list.shown.emit((note("report.simulated"), several))
    assert step.messages.isVisible()
    assert is_shown("validation.several_peaks_unknown", step.messages.text())
    assert not is_shown("report.simulated", step.messages.text())
    judged.window.warning_list.update()
    judged.bot.waitUntil(lambda: judged.window.warning_list.is_current)
    assert not is_shown("validation.several_peaks_unknown", step.messages.text())


def state_of(driver: Driver) -> str:
    document = driver.window.document
    return step_statuses(document.project, document.survey)[VALIDATE].state


def marks(driver: Driver) -> list[tuple[bool, str]]:
    """Whether each plane of the table has an icon, and what a screen reader says about it."""
    table = driver.window.histograms.table
    items = [table.item(row, 0) for row in range(table.rowCount())]
    return [
        (not item.icon().isNull(), item.data(Qt.ItemDataRole.AccessibleTextRole)) for item in items
    ]


def test_without_criteria_nothing_is_judged(judged: Driver) -> None:
    (plane,) = judged.project.validation
    assert plane.after.rms < plane.before.rms
    assert judged.project.judgement.verdict == "not judged"
    assert state_of(judged) == "todo"
    assert marks(judged) == [(False, "V1. Acceptance: not judged")]


def test_halves_that_differ_are_named_beside_the_verdict(judged: Driver) -> None:
    window, project = judged.window, judged.project
    assert project.result is not None
    unit = np.radians(0.001)
    half = CrossCheck("half", "first", project.result.boresight, project.result.sigma)
    second = replace(
        half, part="second", difference=np.full(3, 9 * unit), significance=np.full(3, 2.5)
    )
    criteria = AcceptanceCriteria(yaw_sigma_deg=1.0)
    window.document.open(project.with_acceptance(criteria), judged.window.document.survey)
    judged.rest()
    open_step(judged, VALIDATE)
    assert "halves" not in window.validate.outcome.notes.text()
    window.document.edit("checks", judged.project.with_cross_checks(CrossChecks((half, second))))
    assert "halves" not in window.validate.outcome.notes.text()
    field = window.validate.acceptance.fields["roll_sigma_deg"]
    type_into(judged, field, "0.0085")
    judged.bot.keyClick(field, Key.Key_Return)
    judged.rest()
    notes = window.validate.outcome.notes
    assert "halves of the survey differ" in notes.text()
    assert "roll +0.0090° ± 0.0086° (criterion 0.0085°)" in notes.text()
    assert notes.isVisible()
    assert any(
        "halves" in window.warnings.list.item(k).text() for k in range(window.warnings.list.count())
    )


def test_each_criterion_is_one_undo_step(judged: Driver) -> None:
    form = judged.window.validate.acceptance
    type_into(judged, form.fields["rms"], "30")
    judged.bot.keyClick(form.fields["rms"], Key.Key_Return)
    type_into(judged, form.fields["yaw_sigma_deg"], "0.05")
    judged.bot.keyClick(form.fields["yaw_sigma_deg"], Key.Key_Tab)
    type_into(judged, form.source, "Contract 4.2")
    judged.bot.keyClick(form.source, Key.Key_Tab)
    criteria = judged.project.acceptance
    assert (criteria.rms, criteria.yaw_sigma_deg, criteria.source) == (0.03, 0.05, "Contract 4.2")
    assert judged.window.document.undo_stack.count() == 3
    assert judged.project.result is not None
    assert judged.project.validation
    press(judged, Key.Key_Z, Control)
    press(judged, Key.Key_Z, Control)
    assert judged.project.acceptance == replace(criteria, yaw_sigma_deg=None, source="")
    assert form.fields["yaw_sigma_deg"].text() == ""
    assert form.source.text() == ""


def test_a_smaller_limit_than_the_rms_fails_and_an_empty_field_removes_it(judged: Driver) -> None:
    (plane,) = judged.project.validation
    form = judged.window.validate.acceptance
    field = form.fields["rms"]
    type_into(judged, field, f"{900 * plane.after.rms:.3f}")
    judged.bot.keyClick(field, Key.Key_Return)
    assert judged.project.judgement.verdict == "fail"
    assert state_of(judged) == "failed"
    assert marks(judged) == [(True, "V1. Acceptance: fail")]
    result = form.results["rms"]
    assert result.icon.isVisible()
    assert result.text.text() == f"{1000 * plane.after.rms:.1f} (V1)"
    assert result.text.property("role") == "error"
    outcome = judged.window.validate.outcome
    assert outcome.verdict.property("role") == "error"
    failed = outcome.icon.pixmap().toImage()
    window = judged.window
    judged.bot.waitUntil(lambda: window.warning_list.is_current, timeout=WAIT_MS)
    assert "acceptance.not_met" in {each.code for each in window.warnings.messages}
    type_into(judged, field, f"{1100 * plane.after.rms:.3f}")
    judged.bot.keyClick(field, Key.Key_Return)
    assert judged.project.judgement.verdict == "pass"
    assert state_of(judged) == "done"
    assert marks(judged) == [(True, "V1. Acceptance: pass")]
    assert "pass (1 of 6 criteria given)" in outcome.verdict.text()
    assert outcome.verdict.property("role") == "success"
    assert outcome.icon.pixmap().toImage() != failed, "not the colour alone"
    assert result.text.property("role") == "success"
    field.selectAll()
    judged.bot.keyClick(field, Key.Key_Delete)
    judged.bot.keyClick(field, Key.Key_Tab)
    assert judged.project.acceptance.is_empty
    assert marks(judged) == [(False, "V1. Acceptance: not judged")]
    assert not result.icon.isVisible()
    assert result.text.text() == ""


def test_a_limit_for_95_percent_is_typed_and_judged(judged: Driver) -> None:
    (plane,) = judged.project.validation
    field = judged.window.validate.acceptance.fields["p95"]
    for factor, verdict in ((0.9, "fail"), (1.1, "pass")):
        type_into(judged, field, f"{1000 * factor * plane.after.p95:.4f} mm")
        judged.bot.keyClick(field, Key.Key_Return)
        assert judged.project.acceptance.p95 == pytest.approx(factor * plane.after.p95, rel=1e-3)
        assert judged.project.judgement.verdict == verdict
        table = judged.window.histograms.table
        assert table.item(0, P95).font().bold() == (verdict == "fail")


def test_a_failed_calibration_names_its_cause_and_goes_there(judged: Driver) -> None:
    window, (plane,) = judged.window, judged.project.validation
    assert not window.validate.outcome.buttons
    field = window.validate.acceptance.fields["offset"]
    type_into(judged, field, f"{500 * largest_offset(plane)[0]:.3f}")
    judged.bot.keyClick(field, Key.Key_Return)
    judged.rest()
    (cause,) = probable_causes(
        AcceptanceValues.of(judged.project.judgement), [ValidationPlane.of(plane)]
    )
    assert cause.code == "acceptance.cause_pos"
    (button,) = window.validate.outcome.buttons
    source = window.validate.acceptance.source
    source.setFocus()
    judged.bot.keyClick(source, Key.Key_Tab)
    assert QApplication.focusWidget() is button
    window.workflow.scroll_to(button)
    click(judged, button)
    judged.rest()
    first = window.data.pos_sigmas.position.fields[0]
    assert window.workflow.isAncestorOf(first)
    judged.bot.waitUntil(first.isVisible, timeout=WAIT_MS)


def test_a_wrong_given_value_is_the_only_cause_of_a_failed_calibration(judged: Driver) -> None:
    window, project = judged.window, judged.project
    assert project.result is not None
    cause = PossibleCause(
        "lever_z", "", "", np.array([0.5]), np.array([0.01]), np.zeros(3),
        project.result.rms_after, 2500.0,
    )  # fmt: skip
    wrong = replace(project.result, causes=((cause,),))
    limit = replace(project.acceptance, roll_sigma_deg=1e-6, offset=1e-6)
    window.document.edit("wrong", replace(project, result=wrong, acceptance=limit))
    judged.rest()
    outcome = window.validate.outcome
    (button,) = outcome.buttons
    assert "lever arm Z" in button.toolTip()
    click(judged, button)
    judged.rest()
    estimates = window.adjust.parameters.switches["lever_z"]
    judged.bot.waitUntil(estimates.isVisible, timeout=WAIT_MS)
    judged.bot.waitUntil(lambda: window.warning_list.is_current, timeout=WAIT_MS)
    codes = {each.code for each in window.warnings.messages}
    assert "adjustment.explained_by_value" in codes
    assert not codes & EXPLAINED_CODES


def test_the_report_step_shows_a_failed_calibration(judged: Driver, tmp_path: Path) -> None:
    header = judged.window.workflow.headers[REPORT]

    def exported_verdict(name: str) -> str:
        open_step(judged, REPORT)
        judged.dialogs.path = tmp_path / name
        click(judged, judged.window.report.report)
        judged.rest()
        return json.loads((tmp_path / name).read_text(encoding="utf-8"))["acceptance"]["verdict"]

    assert "(to do)" in header.toolTip()
    assert exported_verdict("first.json") == "not judged"
    assert "(done)" in header.toolTip()
    open_step(judged, VALIDATE)
    field = judged.window.validate.acceptance.fields["rms"]
    type_into(judged, field, "0.1")
    judged.bot.keyClick(field, Key.Key_Return)
    # The end of a long text is not visible, so that the verdict begins it.
    assert sentence(judged, REPORT).startswith("not accepted")
    assert "(failed)" in header.toolTip()
    assert exported_verdict("second.json") == "fail"
    assert sentence(judged, REPORT).startswith("not accepted")
    assert "(failed)" in header.toolTip()


def test_a_typed_source_is_committed_by_a_click_elsewhere_and_saved(
    judged: Driver, picked_folder
) -> None:
    judged.window.document.open(
        replace(judged.project, folder=picked_folder), judged.window.document.survey
    )
    judged.rest()
    open_step(judged, VALIDATE)
    form = judged.window.validate.acceptance
    type_into(judged, form.source, "  IHO S-44  ")
    press(judged, Key.Key_S, Control)
    assert judged.project.acceptance.source == "IHO S-44"
    assert read_project(picked_folder).acceptance.source == "IHO S-44"
    type_into(judged, form.fields["offset"], "12,5")
    click(judged, judged.window.validate.before)
    assert judged.project.acceptance.offset == 0.0125


def test_a_wrong_text_and_an_impossible_limit_change_nothing(judged: Driver) -> None:
    field = judged.window.validate.acceptance.fields["rms"]
    type_into(judged, field, "about 3")
    judged.bot.keyClick(field, Key.Key_Return)
    assert judged.project.acceptance.is_empty
    assert field.property("wrong") is True
    judged.bot.keyClick(field, Qt.Key.Key_Escape)
    assert field.text() == ""
    type_into(judged, field, "99999")
    judged.bot.keyClick(field, Key.Key_Return)
    assert field.input_error is not None
    assert field.input_error.code == "window.out_of_range"
    assert judged.project.acceptance.is_empty
    assert field.property("wrong") is True
    assert field.text() == "99999"
    judged.bot.keyClick(field, Qt.Key.Key_Escape)
    assert field.text() == ""


@pytest.mark.parametrize("text", others_long(["0.0000001", "0", "99"]))
def test_the_limits_in_the_message_have_no_exponents(judged: Driver, text: str) -> None:
    field = judged.window.validate.acceptance.fields["roll_sigma_deg"]
    type_into(judged, field, text)
    judged.bot.keyClick(field, Key.Key_Tab)
    assert field.input_error is not None
    assert field.input_error.code == "window.out_of_range"
    params = field.input_error.params
    assert (params["text"], params["low"], params["high"]) == (text, "0.000001", "10")
    assert field.toolTip() == message_text(field.input_error)
    type_into(judged, field, "0.00002")
    judged.bot.keyClick(field, Key.Key_Return)
    assert field.text() == "0.00002"
    assert judged.project.acceptance.roll_sigma_deg == pytest.approx(2e-5)


def test_criteria_for_the_angles_only_need_no_planes(judged: Driver) -> None:
    document = judged.window.document
    limits = NO_CRITERIA.changed(roll_sigma_deg=1.0, pitch_sigma_deg=1.0, yaw_sigma_deg=1.0)
    document.edit("limits", judged.project.with_acceptance(limits))
    judged.rest()
    status = step_statuses(document.project, document.survey)[VALIDATE]
    assert status.state == "done"
    assert status.sentence == "acceptance: pass (3 of 6 criteria given)"
    every = limits.changed(rms=1.0, p95=1.0, offset=1.0)
    document.edit("limits", judged.project.with_acceptance(every))
    judged.rest()
    assert "criteria given" not in judged.window.validate.outcome.verdict.text()


@pytest.mark.parametrize("text", others_long(["-30", "abc"]))
def test_a_typed_criterion_that_is_not_used_shows_no_verdict(judged: Driver, text: str) -> None:
    form, outcome = judged.window.validate.acceptance, judged.window.validate.outcome
    type_into(judged, form.fields["rms"], "1000")
    judged.bot.keyClick(form.fields["rms"], Key.Key_Return)
    judged.rest()
    assert outcome.icon.isVisible()
    passed = sentence(judged, VALIDATE)
    type_into(judged, form.fields["offset"], text)
    judged.bot.keyClick(form.fields["offset"], Key.Key_Tab)
    judged.rest()
    assert not outcome.icon.isVisible()
    assert outcome.verdict.property("role") == "error"
    assert "pass" not in outcome.verdict.text()
    problem = form.fields["offset"].input_error
    assert problem is not None
    reason = message_text(problem)
    shown = [
        each.text() for each in judged.window.validate.findChildren(QLabel) if each.isVisible()
    ]
    assert judged.window.validate.advice.text() == reason
    assert sum(reason in text for text in shown) == 1
    assert form.results["rms"].text.text() == "", "no result without a verdict"
    assert "pass" not in sentence(judged, VALIDATE)
    assert judged.project.judgement.verdict == "pass", "the criteria in use do not change"
    judged.bot.keyClick(form.fields["offset"], Key.Key_Escape)
    judged.rest()
    assert outcome.icon.isVisible()
    assert sentence(judged, VALIDATE) == passed


def test_no_verdict_is_shown_while_the_lines_are_compared(
    judged: Driver, monkeypatch: pytest.MonkeyPatch
) -> None:
    goes_on = threading.Event()

    def wait(project: Project, *_arguments: object, **_named: object) -> Project:
        goes_on.wait(WAIT_MS / 1000)
        return project.with_validation(judged_planes, {})

    window, outcome = judged.window, judged.window.validate.outcome
    judged_planes = judged.project.validation
    criteria = NO_CRITERIA.changed(rms=1.0)
    project = judged.project.with_acceptance(criteria).with_validation((), {})
    window.document.edit("limits", project)
    judged.rest()
    assert outcome.notes.isVisible(), "nothing has been compared"
    monkeypatch.setattr("lispac.workflow.checking.validation.validate", wait)
    try:
        judged.bot.mouseClick(window.validate.run, Qt.MouseButton.LeftButton)
        judged.bot.waitUntil(lambda: not outcome.notes.isVisible(), timeout=WAIT_MS)
        assert "validating" in outcome.verdict.text()
        assert "validating" in sentence(judged, VALIDATE)
    finally:
        goes_on.set()
    judged.rest()
    assert outcome.verdict.text().startswith("Acceptance: pass")


def test_the_reasons_are_below_the_text_that_refers_to_them(judged: Driver) -> None:
    (plane,) = judged.project.validation
    panel = judged.window.validate
    field = panel.acceptance.fields["offset"]
    type_into(judged, field, f"{500 * largest_offset(plane)[0]:.3f}")
    judged.bot.keyClick(field, Key.Key_Return)
    judged.rest()
    assert panel.advice.text()
    assert panel.advice.geometry().bottom() < panel.outcome.geometry().top()


@pytest.mark.parametrize(
    "is_dark", [pytest.param(False, id="light", marks=LONG), pytest.param(True, id="dark")]
)
def test_failing_values_of_selected_rows_keep_their_colour(
    request, qapp: QApplication, driver: Driver, demo: Demo, validated: Project, is_dark: bool
) -> None:
    theme.apply_theme(qapp, "dark" if is_dark else "light")
    request.addfinalizer(lambda: theme.apply_theme(qapp, "light"))
    limits = NO_CRITERIA.changed(rms=0.0001, offset=0.0001)
    driver.window.document.open(validated.with_acceptance(limits), demo.survey)
    driver.rest()
    panel = show_panel(driver.window, "Histograms").widget()
    assert isinstance(panel, HistogramsPanel)
    panel.plot.setCurrentIndex(PAIRS_VIEW)
    panel.plot.activated.emit(PAIRS_VIEW)
    driver.rest()
    rows = range(panel.pairs.rowCount())
    row = next(k for k in rows if panel.pairs.item(k, OFFSET_AFTER).font().bold())
    for table, item in (
        (panel.table, panel.table.item(0, RMS)), (panel.pairs, panel.pairs.item(row, OFFSET_AFTER))
    ):  # fmt: skip
        place = table.visualItemRect(item)
        driver.bot.mouseClick(table.viewport(), Qt.MouseButton.LeftButton, pos=place.center())
        assert item.isSelected()
        driver.rest()
        picture = array_of(table.viewport().grab(place).toImage()).astype(int)
        redder = picture[..., 0] - picture[..., 2]
        assert np.count_nonzero(redder > 50) >= 10, "letters of the colour of an error"
        assert np.count_nonzero(redder < -20) >= 100, "background of a selected row"


@pytest.mark.parametrize(
    ("count", "short"), [(0, "3.1"), (2, "3.1 (V1, V2)"), (3, "3.1 (3 planes)")]
)
def test_many_planes_beside_a_value_are_counted(qtbot: QtBot, count: int, short: str) -> None:
    label = CriterionResultLabel("result", "Offset")
    qtbot.addWidget(label)
    names = tuple(f"V{k + 1}" for k in range(count))
    label.show_result(CriterionResult("offset", "m", 0.0031, 0.002, "fail", names))
    assert label.text.text() == short
    assert all(name in label.toolTip() for name in names)


def test_the_signs_of_the_pairs_are_explained_beside_them(judged: Driver) -> None:
    panel = show_panel(judged.window, "Histograms").widget()
    assert isinstance(panel, HistogramsPanel)
    panel.plot.setCurrentIndex(PAIRS_VIEW)
    panel.plot.activated.emit(PAIRS_VIEW)
    judged.rest()
    text = gettext(PAIRS_HINT)
    for limit in (None, 0.0001):
        criteria = NO_CRITERIA.changed(rms=limit, offset=limit)
        judged.window.document.edit("limits", judged.project.with_acceptance(criteria))
        judged.rest()
        assert text in panel.reading.text()
        assert (gettext(PAIR_COLOURS_HINT) in panel.reading.text()) == (limit is not None)
        assert text.split()[0] in panel.reading.toolTip()
    heads = [panel.pairs.horizontalHeaderItem(k) for k in range(panel.pairs.columnCount())]
    assert "reciprocal" in heads[0].text()
    for head in heads:
        if "Offset" in head.text() or "offset" in head.text():
            assert "positive if the first" in head.toolTip().replace("\n", " ")
