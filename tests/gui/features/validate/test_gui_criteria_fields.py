"""Tests that the fields of the acceptance criteria stay in place and keep the focus."""

from collections.abc import Callable
from dataclasses import replace

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractItemView, QApplication, QLineEdit, QWidget

from lispac.acceptance import LIMIT_NAMES
from lispac.gui.project.status import STEP_KEYS, VALIDATE
from lispac.project import Project
from tests.gui.support import Control, Demo, Driver, Key, Left, finish_layouts, open_step, press
from tests.support.long_runs import LONG, others_long

SIZES = ((1366, 768), (1600, 1000))
SOURCE = "Client specification 2026, P7"
TIGHT = ("0.00001", "0.00001", "0.00001", "0.1", "0.1", "0.01")
LAX = ("5", "5", "5", "900", "900", "900")
LETTERS = "sSpPmMxXoOlLfFhHbBwWcC1234567+-"
"""Keys of single-key commands, and others."""


@pytest.fixture
def started(driver: Driver) -> list[str]:
    """Names of the actions that are started."""
    names: list[str] = []

    def record(action: QAction) -> None:
        action.triggered.connect(lambda: names.append(action.objectName()))

    for each in driver.window.actions_.all:
        record(each)
    return names


@pytest.fixture(params=[SIZES[0], pytest.param(SIZES[1], marks=LONG)], ids=str)
def judged(request, driver: Driver, demo: Demo, validated: Project) -> Driver:
    """A window at step 4, whose fields are all visible, with a contract in the details."""
    identity = validated.identity.changed(contract="C-118")
    driver.window.resize(*request.param)
    driver.window.document.open(validated.with_identity(identity), demo.survey)
    driver.rest()
    open_step(driver, VALIDATE)
    driver.rest()
    scroll_to_fields(driver)
    return driver


def scroll_to_fields(driver: Driver) -> None:
    panel = driver.window.validate
    for each in (panel.before, panel.advice):
        driver.window.workflow.scroll_to(each)
        driver.rest()
    for each in fields(driver):
        assert each.visibleRegion().boundingRect() == each.rect(), each.objectName()


def fields(driver: Driver) -> list[QLineEdit]:
    form = driver.window.validate.acceptance
    return [*(form.fields[name] for name in LIMIT_NAMES), form.source]


def places(driver: Driver) -> list[QPoint]:
    """Middles of the fields in the window."""
    finish_layouts()
    return [each.mapTo(driver.window, each.rect().center()) for each in fields(driver)]


def hit(driver: Driver, place: QPoint) -> QWidget:
    """Click at a place of the window; return the widget that was there."""
    widget = driver.window.childAt(place)
    driver.bot.mouseClick(widget, Left, pos=widget.mapFrom(driver.window, place))
    driver.rest()
    return widget


def type_letters(driver: Driver, text: str) -> None:
    """Send keys to the widget with the focus, or to the window without one."""
    for letter in text:
        driver.bot.keyClicks(QApplication.focusWidget() or driver.window, letter)


def type_by_clicks(driver: Driver, values: tuple[str, ...], end: Callable[[], None]) -> None:
    """Type the limits and the source with clicks at the places before the first entry."""
    before = places(driver)
    for number, (place, value) in enumerate(zip(before, (*values, SOURCE), strict=True)):
        assert hit(driver, place) is fields(driver)[number]
        assert QApplication.focusWidget() is fields(driver)[number]
        press_in_focus(driver, Key.Key_A, Control)
        type_letters(driver, value)
        end()
        driver.rest()
        assert places(driver) == before, f"after field {number}"


def press_in_focus(driver: Driver, key: Qt.Key, modifier=Qt.KeyboardModifier.NoModifier) -> None:
    focused = QApplication.focusWidget()
    assert focused is not None
    driver.bot.keyClick(focused, key, modifier)


def assert_stored(driver: Driver, values: tuple[str, ...]) -> None:
    criteria = driver.project.acceptance
    scales = (1, 1, 1, 1000, 1000, 1000)
    for name, value, scale in zip(LIMIT_NAMES, values, scales, strict=True):
        assert getattr(criteria, name) == pytest.approx(float(value) / scale), name
    assert criteria.source == SOURCE


@LONG
def test_criteria_are_typed_with_clicks_at_first_read_places(
    judged: Driver, started: list[str]
) -> None:
    type_by_clicks(judged, TIGHT, lambda: press_in_focus(judged, Key.Key_Return))
    assert_stored(judged, TIGHT)
    assert judged.project.judgement.verdict == "fail"
    judged.window.workflow.scroll_to(judged.window.validate.outcome.buttons[-1])
    judged.rest()
    scroll_to_fields(judged)
    type_by_clicks(judged, LAX, lambda: None)
    assert_stored(judged, LAX)
    assert judged.project.judgement.verdict == "pass"
    assert started == []


def test_the_fields_keep_their_height_in_a_panel_that_is_too_low(judged: Driver) -> None:
    heights = [each.height() for each in fields(judged)]
    panel = judged.window.validate
    panel.resize(panel.width(), panel.height() // 2)
    layout = panel.layout()
    layout.activate()
    layout.setGeometry(panel.rect())
    assert [each.height() for each in fields(judged)] == heights


def test_criteria_are_typed_with_tab_only(judged: Driver, started: list[str]) -> None:
    for values in (TIGHT, LAX):
        scroll_to_fields(judged)
        before = places(judged)
        hit(judged, before[0])
        for number, value in enumerate((*values, SOURCE)):
            focused = QApplication.focusWidget()
            assert focused is fields(judged)[number]
            press_in_focus(judged, Key.Key_A, Control)
            type_letters(judged, value)
            if number < len(LIMIT_NAMES):
                press_in_focus(judged, Key.Key_Tab)
                judged.rest()
            assert places(judged) == before, f"after field {number}"
        press_in_focus(judged, Key.Key_Return)
        judged.rest()
        assert QApplication.focusWidget() is fields(judged)[-1]
        assert_stored(judged, values)
    assert started == []


@pytest.mark.parametrize("backwards", others_long([False, True]))
def test_tab_from_a_criterion_that_rebuilds_the_causes_keeps_the_focus_in_the_panel(
    judged: Driver, started: list[str], backwards: bool
) -> None:
    type_by_clicks(judged, TIGHT, lambda: None)
    field = fields(judged)[-1]
    press_in_focus(judged, Key.Key_Return)
    for limit, value in zip(fields(judged), LAX, strict=False):
        hit(judged, limit.mapTo(judged.window, limit.rect().center()))
        press_in_focus(judged, Key.Key_A, Control)
        type_letters(judged, value)
    hit(judged, field.mapTo(judged.window, field.rect().center()))
    press_in_focus(judged, Key.Key_Backtab if backwards else Key.Key_Tab)
    judged.rest()
    focused = QApplication.focusWidget()
    assert focused is not None
    assert focused.isVisible()
    assert judged.window.workflow.isAncestorOf(focused)
    if backwards:
        assert focused is fields(judged)[-2]
    press_in_focus(judged, Key.Key_S if backwards else Key.Key_Backtab)
    assert started == []


@LONG
def test_letters_in_a_step_start_no_command_of_the_view(
    driver: Driver, demo: Demo, validated: Project, started: list[str]
) -> None:
    driver.window.document.open(replace(validated), demo.survey)
    driver.rest()
    window = driver.window
    panels = (window.data, window.targets, window.adjust, window.validate, window.report)
    for step, panel in enumerate(panels):
        open_step(driver, step)
        focusable = [
            each for each in panel.findChildren(QWidget)
            if each.isVisible() and each.isEnabled()
            and each.focusPolicy() & Qt.FocusPolicy.TabFocus
            and each.focusProxy() is None and not isinstance(each, QAbstractItemView)
        ]  # fmt: skip
        assert focusable, STEP_KEYS[step]
        for each in focusable:
            each.setFocus()
            type_letters(driver, LETTERS)
            assert started == [], each.objectName()


def test_the_view_and_the_lists_keep_their_single_key_commands(
    judged: Driver, started: list[str]
) -> None:
    open_step(judged, 1)
    table = judged.window.targets.table
    table.setFocus()
    QTest.keyClick(table, Key.Key_L)
    judged.viewport.widget.setFocus()
    press(judged, Key.Key_L)
    assert len(started) == 2


@LONG
def test_a_typed_source_is_kept_when_all_limits_are_cleared(judged: Driver) -> None:
    form, limit = judged.window.validate.acceptance, fields(judged)[3]

    def enter(field: QLineEdit, text: str) -> None:
        hit(judged, field.mapTo(judged.window, field.rect().center()))
        press_in_focus(judged, Key.Key_A, Control)
        press_in_focus(judged, Key.Key_Delete)
        type_letters(judged, text)
        press_in_focus(judged, Key.Key_Return)
        judged.rest()

    enter(form.source, "Client specification 2026")
    for text in ("30", "", "25"):
        enter(limit, text)
        assert form.source.text() == "Client specification 2026"
        assert judged.project.acceptance.source == "Client specification 2026"
    enter(limit, "")
    enter(form.source, "")
    enter(limit, "30")
    assert judged.project.acceptance.source == "", "cleared by the user"
    for _ in range(3):
        press(judged, Key.Key_Z, Control)
    assert form.source.text() == "Client specification 2026"


@LONG
def test_the_contract_is_proposed_in_a_field_that_was_never_edited(judged: Driver) -> None:
    form, limit = judged.window.validate.acceptance, fields(judged)[3]
    hit(judged, limit.mapTo(judged.window, limit.rect().center()))
    type_letters(judged, "30")
    press_in_focus(judged, Key.Key_Return)
    assert form.source.text() == judged.project.acceptance.source == "C-118"
    press(judged, Key.Key_Z, Control)
    assert form.source.text() == ""
