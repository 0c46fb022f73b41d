"""Tests that an edit of one validation plane keeps the comparisons of the others."""

import operator
from collections.abc import Callable
from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtWidgets import QApplication, QLineEdit, QMenu, QTableWidget

from lispac.acceptance import AcceptanceCriteria
from lispac.gui.project.status import TARGETS, VALIDATE
from lispac.project import Project
from tests.gui.support import (
    Control,
    Demo,
    Driver,
    Key,
    click_check,
    open_step,
    press,
    seed,
    sentence,
    show_panel,
    wait_until_idle,
)


@pytest.fixture
def two_planes(driver: Driver, demo: Demo, validated: Project) -> Driver:
    """A window with the validation planes V1 and V9, both compared and accepted."""
    (plane,) = validated.validation
    project = validated.with_target(replace(validated.target("V1"), name="V9"))
    project = project.with_validation((plane, replace(plane, name="V9")), {})
    criteria = AcceptanceCriteria(rms=10 * plane.after.rms)
    driver.window.document.open(project.with_acceptance(criteria), demo.survey)
    show_panel(driver.window, "Histograms")
    driver.rest()
    return driver


def compared(driver: Driver) -> list[str]:
    """Names in the table of the histograms, which must be those of the project."""
    table = driver.window.histograms.table
    names = [table.item(row, 0).text() for row in range(table.rowCount())]
    assert names == [plane.name for plane in driver.project.validation]
    return names


def tick(driver: Driver, name: str) -> None:
    """Click the check box of a plane in the table of sightings."""
    table = driver.window.table
    table.show()
    show_panel(driver.window, "Targets by line")
    click_check(driver, table, table.sightings.index(table.sightings.row_of(name), 0))
    wait_until_idle(driver)


def undo(driver: Driver) -> None:
    press(driver, Key.Key_Z, Control)
    wait_until_idle(driver)


def test_excluding_a_plane_keeps_the_comparisons_of_the_others(two_planes: Driver) -> None:
    before = two_planes.project
    two_planes.window.histograms.select("V9")
    verdict = two_planes.window.validate.outcome.verdict
    assert "excluded" not in verdict.text()
    tick(two_planes, "V1")
    assert not two_planes.project.target("V1").used
    assert two_planes.project.result is before.result
    assert compared(two_planes) == ["V9"]
    assert two_planes.project.validation[0] is before.validation[1]
    assert two_planes.window.histograms.current == "V9"
    assert two_planes.project.judgement.verdict == "pass"
    assert "1 validation plane excluded" in verdict.text()

    tick(two_planes, "V1")
    assert compared(two_planes) == ["V1", "V9"]
    assert all(map(operator.is_, two_planes.project.validation, before.validation))
    assert two_planes.project.not_compared == {}
    assert two_planes.project.judgement.verdict == "pass"
    assert sentence(two_planes, VALIDATE) == "2 of 2 planes pass"

    undo(two_planes)
    assert compared(two_planes) == ["V9"]
    undo(two_planes)
    assert compared(two_planes) == ["V1", "V9"]
    assert two_planes.project.validation is before.validation


def test_an_excluded_plane_is_compared_again_after_an_edit(two_planes: Driver) -> None:
    tick(two_planes, "V1")
    line = two_planes.project.target("V1").sightings[0].line
    two_planes.window.controller.use_sighting("V1", line, False)
    assert two_planes.project.excluded_comparisons == {}
    tick(two_planes, "V1")
    assert compared(two_planes) == ["V9"]
    assert two_planes.project.not_compared["V1"].code == "validation.plane_edited"
    assert two_planes.project.judgement.verdict == "not judged"
    assert sentence(two_planes, VALIDATE) == "1 of 2 planes compared"
    header = two_planes.window.workflow.headers[VALIDATE]
    shown = header.sentence
    assert shown.fontMetrics().horizontalAdvance(shown.text()) <= shown.width()
    assert "V1" in header.toolTip()


def test_excluded_planes_keep_their_comparisons_under_a_new_name(two_planes: Driver) -> None:
    before = two_planes.project.validation
    for name in ("V1", "V9"):
        tick(two_planes, name)
    assert two_planes.project.validation == ()
    two_planes.window.controller.rename("V1", "Tower")
    tick(two_planes, "Tower")
    (tower,) = two_planes.project.validation
    assert (tower.name, tower.after) == ("Tower", before[0].after)
    assert two_planes.project.not_compared == {}


def choose(driver: Driver, text: str, open_menu: Callable[[], object]) -> None:
    """Choose an entry of the context menu of the table of planes with the mouse."""
    table = driver.window.histograms.table
    open_menu()
    driver.bot.waitUntil(lambda: table.findChild(QMenu, "planes_menu") is not None)
    menu = table.findChild(QMenu, "planes_menu")
    driver.bot.waitUntil(menu.isVisible)
    (entry,) = (each for each in menu.actions() if each.text() == text)
    place = menu.actionGeometry(entry).center()
    driver.bot.mouseClick(menu, Qt.MouseButton.LeftButton, pos=place)
    driver.bot.waitUntil(lambda: table.findChild(QMenu, "planes_menu") is None)
    wait_until_idle(driver)


def request_menu(table: QTableWidget, row: int, reason: QContextMenuEvent.Reason) -> None:
    place = table.visualRect(table.model().index(row, 0)).center()
    whole = table.viewport().mapToGlobal(place)
    QApplication.sendEvent(table.viewport(), QContextMenuEvent(reason, place, whole))


def test_a_plane_is_excluded_in_the_context_menu_of_the_table(two_planes: Driver) -> None:
    before = two_planes.project
    window, reasons = two_planes.window, QContextMenuEvent.Reason
    table = window.histograms.table
    window.histograms.select("V9")
    choose(two_planes, "Exclude V9", lambda: request_menu(table, 1, reasons.Keyboard))
    assert [plane.used for plane in two_planes.project.targets_of_role("validation")] == [
        True, False
    ]  # fmt: skip
    assert compared(two_planes) == ["V1"]
    window.actions_["undo"].trigger()  # one step
    wait_until_idle(two_planes)
    assert two_planes.project.validation is before.validation

    choose(two_planes, "Exclude V1", lambda: click_and_request(two_planes, table, 0))
    assert compared(two_planes) == ["V9"]
    choose(two_planes, "Include V1", lambda: request_menu(table, 0, reasons.Keyboard))
    assert compared(two_planes) == ["V1", "V9"]


def click_and_request(driver: Driver, table: QTableWidget, row: int) -> None:
    """Press the right mouse button on a row, which selects it, and request its menu."""
    place = table.visualRect(table.model().index(row, 0)).center()
    driver.bot.mouseClick(table.viewport(), Qt.MouseButton.RightButton, pos=place)
    if table.findChild(QMenu, "planes_menu") is None:  # not all systems send the request
        request_menu(table, row, QContextMenuEvent.Reason.Mouse)


def test_step_2_counts_the_planes_that_are_used(two_planes: Driver) -> None:
    tick(two_planes, "V9")
    header = two_planes.window.workflow.headers[TARGETS]
    assert header.sentence.text().endswith("targets, 1 of 2 validation planes")
    assert "1 validation plane used, 1 excluded." in header.toolTip()
    table = two_planes.window.targets.table
    rows = {table.item(row, 0).text(): table.item(row, 3).text() for row in range(table.rowCount())}
    assert rows["V9"] == "excluded"
    assert " of " in rows["V1"]
    tick(two_planes, "V9")
    assert header.sentence.text().endswith("targets, 2 validation planes")


def test_a_menu_opens_the_acceptance_criteria(two_planes: Driver) -> None:
    window = two_planes.window
    open_step(two_planes, 0)
    window.actions_["acceptance_criteria"].trigger()
    two_planes.rest()
    assert window.workflow.opened == VALIDATE
    first = window.validate.acceptance.fields["roll_sigma_deg"]
    assert first.hasFocus()
    assert not first.visibleRegion().isEmpty()


def test_a_renamed_plane_keeps_its_comparison(two_planes: Driver) -> None:
    open_step(two_planes, 1)
    table = two_planes.window.targets.table
    names = [table.item(row, 0).text() for row in range(table.rowCount())]
    table.setCurrentCell(names.index("V1"), 0)
    table.setFocus()
    two_planes.bot.keyClick(table, Key.Key_F2)
    editor = table.findChild(QLineEdit)
    editor.selectAll()
    two_planes.bot.keyClicks(editor, "Tower")
    two_planes.bot.keyClick(editor, Key.Key_Return)
    wait_until_idle(two_planes)
    assert compared(two_planes) == ["Tower", "V9"]
    assert two_planes.project.not_compared == {}
    assert two_planes.project.judgement.verdict_on("Tower") == "pass"
    undo(two_planes)
    assert compared(two_planes) == ["V1", "V9"]


def test_a_new_plane_is_compared_by_the_next_validation(two_planes: Driver) -> None:
    two_planes.window.controller.remove("V9")
    assert compared(two_planes) == ["V1"]
    assert two_planes.project.not_compared == {}
    open_step(two_planes, 1)
    seed(two_planes, "V1")
    press(two_planes, Key.Key_Return)
    wait_until_idle(two_planes)
    added = two_planes.project.targets[-1].name
    assert compared(two_planes) == ["V1"]
    assert set(two_planes.project.not_compared) == {added}
    two_planes.window.actions_["validate"].trigger()
    wait_until_idle(two_planes)
    assert compared(two_planes) == ["V1", added]
    assert two_planes.project.not_compared == {}


def test_all_comparisons_depend_on_the_boresight(two_planes: Driver) -> None:
    settings = replace(two_planes.project.settings, boresight_deg=(0.1, 0.0, 0.0))
    two_planes.window.controller.change_settings(settings)
    two_planes.rest()
    assert two_planes.project.validation == ()
    undo(two_planes)
    assert compared(two_planes) == ["V1", "V9"]
    tick(two_planes, "V9")
    assert set(two_planes.project.excluded_comparisons) == {"V9"}
    two_planes.window.controller.use_target("T1", False)
    assert two_planes.project.validation == ()
    assert two_planes.project.excluded_comparisons == {}
    assert two_planes.project.not_compared == {}
