"""Tests of number fields: values outside the range are marked and never truncated."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QToolTip, QVBoxLayout, QWidget
from pytestqt.qtbot import QtBot

from lispac.gui import widgets
from lispac.gui.app.language import set_language
from lispac.gui.appearance import units
from lispac.gui.widgets.number_field import NumberField
from tests.gui.support import in_front

Key, SOON_MS = Qt.Key, 20_000


class Form(QWidget):
    """Form with a field of −100 to 100 m, set to 2 m, and one of 0.1 to 1000 mm.

    Attributes
    ----------
    told : values that the first field has emitted
    """

    def __init__(self) -> None:
        super().__init__()
        self.emitted: list[float] = []
        self.up = widgets.number("up", suffix=" m", decimals=4, low=-100, high=100, step=0.01)
        self.up.setValue(2.0)
        self.sigma = widgets.number("sigma", suffix=" mm", decimals=1, low=0.1, high=1000, step=0.5)
        layout = QVBoxLayout(self)
        layout.addWidget(self.up)
        layout.addWidget(self.sigma)
        self.up.valueChanged.connect(self.emitted.append)


@pytest.fixture
def form(qtbot: QtBot) -> Iterator[Form]:
    made = Form()
    qtbot.addWidget(made)
    made.show()
    qtbot.waitUntil(lambda: in_front(made), timeout=SOON_MS)
    yield made
    QToolTip.hideText()


def type_into_field(qtbot: QtBot, field: NumberField, text: str) -> None:
    field.setFocus()
    field.selectAll()
    qtbot.keyClicks(field, text)


def test_a_value_outside_the_range_is_marked_and_the_range_is_shown(form, qtbot) -> None:
    type_into_field(qtbot, form.up, "2173")
    assert form.up.cleanText() == "2173"
    assert form.up.property("wrong") is True
    assert QToolTip.text() == "Range: -100.0000 to 100.0000 m"
    qtbot.keyClick(form.up, Key.Key_Return)
    assert form.up.cleanText() == "2173"  # Enter does not accept it
    qtbot.keyClick(form.up, Key.Key_Backspace)
    qtbot.keyClick(form.up, Key.Key_Backspace)
    assert form.up.property("wrong") is False
    qtbot.keyClick(form.up, Key.Key_Return)
    assert form.up.value() == 21.0


def test_a_field_left_with_an_invalid_value_restores_the_former_one(form, qtbot) -> None:
    type_into_field(qtbot, form.up, "2173")
    qtbot.keyClick(form.up, Key.Key_Tab)
    assert form.sigma.hasFocus()
    assert form.up.value() == 2.0
    assert form.up.text() == "2.0000 m"
    assert form.up.property("wrong") is False
    assert form.emitted[-1] == 2.0  # the intermediate values 2 and 21 are reverted
    tip = "2173 is outside the range -100.0000 to 100.0000 m. 2.0000 m is kept."
    qtbot.waitUntil(lambda: QToolTip.text() == tip, timeout=SOON_MS)
    assert QToolTip.isVisible()


def test_the_kept_value_is_shown_after_a_click_elsewhere(form, qtbot) -> None:
    """The tip appears after the release of the mouse, which would close it."""
    type_into_field(qtbot, form.up, "2173")
    qtbot.mousePress(form.sigma.lineEdit(), Qt.MouseButton.LeftButton)
    form.sigma.setFocus()  # as the window system does at a click
    qtbot.wait(80)
    qtbot.mouseRelease(form.sigma.lineEdit(), Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: "2.0000 m is kept" in QToolTip.text(), timeout=SOON_MS)
    assert QToolTip.isVisible()


@pytest.mark.parametrize("text", ["-", "-3", "0", "20000"])
def test_typed_signs_and_digits_are_kept(form, qtbot, text: str) -> None:
    form.sigma.setValue(5.0)
    type_into_field(qtbot, form.sigma, text)
    assert form.sigma.cleanText() == text
    form.up.setFocus()
    assert form.sigma.value() == 5.0


def test_a_step_starts_from_the_last_valid_value(form, qtbot) -> None:
    type_into_field(qtbot, form.up, "500")
    qtbot.keyClick(form.up, Key.Key_Up)
    assert form.up.value() == pytest.approx(2.01)


def test_escape_restores_the_last_valid_value(form, qtbot) -> None:
    type_into_field(qtbot, form.up, "-500")
    qtbot.keyClick(form.up, Key.Key_Escape)
    assert form.up.text() == "2.0000 m"


def test_letters_and_too_many_decimals_cannot_be_typed(form, qtbot) -> None:
    type_into_field(qtbot, form.up, "1x.23456")
    assert form.up.cleanText() == "1.2345"


def test_the_range_is_shown_in_feet_and_in_french(form, qtbot) -> None:
    set_language("fr")
    units.set_units("degrees", "feet")
    try:
        own = Form()
        qtbot.addWidget(own)
        own.show()
        qtbot.waitUntil(lambda: in_front(own), timeout=SOON_MS)
        type_into_field(qtbot, own.up, "329,5")
        shown = QToolTip.text().replace("\N{NO-BREAK SPACE}", " ")
        assert shown == "Plage : -328,0840 à 328,0840 ft"
        own.sigma.setFocus()
        assert own.up.value() == 2.0
        type_into_field(qtbot, own.up, "320,5")
        own.sigma.setFocus()
        assert own.up.value() == pytest.approx(320.5 * 0.3048)
    finally:
        set_language("en")
        units.set_units("degrees", "metres")
