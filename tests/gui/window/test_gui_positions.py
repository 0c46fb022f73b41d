"""Tests that controls stay in place while texts beside them change."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QAbstractButton, QComboBox, QLineEdit, QWidget
from pytestqt.qtbot import QtBot

from lispac.gui.features.help.tour import TOUR_STEPS, VERDICT_TEXTS
from lispac.gui.features.open_project.import_survey.import_dialog import MOUNTING, ImportDialog
from lispac.gui.project.status import DATA, REPORT, VALIDATE
from lispac.gui.widgets.number_field import NumberField
from lispac.project import Project
from tests.gui.support import Demo, Driver, Key, click, finish_layouts, open_step, type_into

CONTROLS = (QAbstractButton, QComboBox, QLineEdit, NumberField)


def places(root: QWidget) -> dict[str, QPoint]:
    """Places in a widget of all its visible named controls."""
    finish_layouts()
    return {
        each.objectName(): each.mapTo(root, QPoint(0, 0))
        for each in root.findChildren(QWidget)
        if isinstance(each, CONTROLS) and each.isVisible() and each.objectName()
    }


def moved(before: dict[str, QPoint], after: dict[str, QPoint]) -> dict[str, tuple[QPoint, QPoint]]:
    """Controls that are visible in both states and have moved."""
    common = before.keys() & after.keys()
    assert len(common) > 3
    return {name: (before[name], after[name]) for name in common if before[name] != after[name]}


def test_a_lever_arm_moves_no_controls_of_the_import(filled: ImportDialog, qtbot: QtBot) -> None:
    filled.tabs.setCurrentIndex(MOUNTING)
    before = places(filled)
    warned = filled.mounting.view.warnings_label
    assert warned.isVisible()
    assert filled.reason.text() == "", "the warning is shown once"
    field = filled.mounting.lever_arm.fields[2]
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, "2.419")
    assert not warned.isVisible()
    assert moved(before, places(filled)) == {}
    filled.tabs.setCurrentIndex(0)
    elsewhere = places(filled)
    filled.tabs.setCurrentIndex(MOUNTING)
    names = ("new_ok", "new_folder", "new_folder_browse")
    assert [elsewhere[name] for name in names] == [before[name] for name in names]


def test_a_lever_arm_moves_no_controls_of_the_data_step(opened: Driver) -> None:
    data = opened.window.data
    open_step(opened, DATA)
    type_into(opened, data.lever_arm.fields[2], "2.1")
    opened.rest()
    before = places(data)
    for field in data.lever_arm.fields:
        type_into(opened, field, "0")
        opened.bot.keyClick(field, Key.Key_Return)
    assert data.mounting.warnings_label.isVisible()
    assert moved(before, places(data)) == {}


def test_no_gap_is_left_above_the_sketch_of_the_mounting(opened: Driver) -> None:
    data = opened.window.data
    open_step(opened, DATA)
    type_into(opened, data.lever_arm.fields[2], "2.1")
    opened.bot.keyClick(data.lever_arm.fields[2], Key.Key_Return)
    opened.rest()
    text, sketch = data.mounting.text_label, data.mounting.sketch
    assert text.isVisible()
    bottom = text.mapTo(data, text.rect().bottomLeft()).y()
    fields = data.boresight.mapTo(data, data.boresight.rect().bottomLeft()).y()
    assert text.mapTo(data, QPoint(0, 0)).y() - fields <= 12
    assert 0 < sketch.mapTo(data, QPoint(0, 0)).y() - bottom <= 12


def test_the_steps_of_the_tour_have_one_height(opened: Driver) -> None:
    card = opened.window.central_widget.card
    heights = set()
    for number, text in enumerate([*(step.text for step in TOUR_STEPS), *VERDICT_TEXTS.values()]):
        card.show_step(min(number, len(TOUR_STEPS) - 1), text)
        places(opened.window)
        assert card.text.height() >= card.text.heightForWidth(card.text.width())
        heights.add(card.height())
    card.hide()
    assert len(heights) == 1


def test_typed_criteria_move_no_controls(driver: Driver, demo: Demo, validated: Project) -> None:
    driver.window.resize(1600, 1000)
    driver.window.document.open(validated, demo.survey)
    driver.rest()
    open_step(driver, VALIDATE)
    panel = driver.window.validate
    before = places(panel)
    for name, value in (("rms", "0.1"), ("offset", "900"), ("roll_sigma_deg", "0.5")):
        field = panel.acceptance.fields[name]
        type_into(driver, field, value)
        driver.bot.keyClick(field, Key.Key_Return)
        driver.rest()
        assert moved(before, places(panel)) == {}, name
    assert panel.acceptance.results["rms"].text.property("role") == "error"


def test_details_and_export_move_no_controls_of_the_report(
    driver: Driver, demo: Demo, validated: Project, tmp_path
) -> None:
    driver.window.resize(1600, 1000)
    driver.window.document.open(validated, demo.survey)
    driver.rest()
    open_step(driver, REPORT)
    panel = driver.window.report
    before = places(panel)
    assert panel.missing.isVisible()
    project = driver.project
    named = project.identity.changed(
        **{name: "x" for name in project.identity.missing if name != "survey_dates"}
    )
    driver.window.document.edit("details", project.with_identity(named))
    assert moved(before, places(panel)) == {}
    panel.extent.setCurrentIndex(1)
    panel.extent.activated.emit(1)
    assert moved(before, places(panel)) == {}
    driver.dialogs.path = tmp_path / "r.html"
    click(driver, panel.report)
    driver.rest()
    assert driver.dialogs.errors == []
    assert moved(before, places(panel)) == {}


def test_a_typing_error_moves_no_controls_of_the_adjustment(picked: Driver) -> None:
    open_step(picked, 2)
    panel = picked.window.adjust
    before = places(panel)
    click(picked, panel.findChild(QAbstractButton, "model_independent"))
    assert moved(before, places(panel)) == {}


@pytest.mark.parametrize("size", [(1366, 768), (1600, 1000)])
def test_the_steps_have_one_width(driver: Driver, demo: Demo, validated: Project, size) -> None:
    driver.window.resize(*size)
    driver.window.document.open(replace(validated), demo.survey)
    driver.rest()
    widths = []
    for step in (0, 1, 2, 3, 4, 1, 0):
        open_step(driver, step)
        places(driver.window)
        widths.append(driver.window.viewport.widget.width())
    assert len(set(widths)) == 1, widths
