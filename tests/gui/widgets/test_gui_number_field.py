"""Tests of number fields: every typed text is kept, and wrong ones are marked."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QToolTip, QVBoxLayout, QWidget
from pytestqt.qtbot import QtBot

from lispac.gui import widgets
from lispac.gui.app.language import set_language
from lispac.gui.appearance import units
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.widgets.number_field import NumberField
from lispac.gui.widgets.number_input import parse_number
from tests.gui.support import in_front
from tests.support.message_codes import is_shown

Key, SOON_MS = Qt.Key, 20_000


class Form(QWidget):
    """Form with a field of −100 to 100 m, set to 2 m, one of 0.1 to 1000 mm, and a count.

    Attributes
    ----------
    emitted, committed : values that the first field has emitted while typing, and at commits
    """

    def __init__(self) -> None:
        super().__init__()
        self.emitted: list[float] = []
        self.up = widgets.number("up", suffix=" m", decimals=4, low=-100, high=100, step=0.01)
        self.up.setValue(2.0)
        self.sigma = widgets.number("sigma", suffix=" mm", decimals=1, low=0.1, high=1000, step=0.5)
        self.count = widgets.number("count", suffix="", decimals=0, low=1, high=9999, step=1)
        layout = QVBoxLayout(self)
        layout.addWidget(self.up)
        layout.addWidget(self.sigma)
        layout.addWidget(self.count)
        self.committed: list[float] = []
        self.up.valueChanged.connect(self.emitted.append)
        self.up.committed.connect(self.committed.append)


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
    assert QToolTip.text() == "Range: −100.0000 to 100.0000 m"
    qtbot.keyClick(form.up, Key.Key_Return)
    assert form.up.cleanText() == "2173"  # Enter does not accept it
    qtbot.keyClick(form.up, Key.Key_Backspace)
    qtbot.keyClick(form.up, Key.Key_Backspace)
    assert form.up.property("wrong") is False
    qtbot.keyClick(form.up, Key.Key_Return)
    assert form.up.value() == 21.0


@pytest.mark.parametrize(
    ("text", "code"),
    [("2173", "window.out_of_range"), ("abc", "window.not_a_number_in"),
     ("1.2.3", "window.not_a_number_in"), ("", "window.empty_number"),
     ("5 kg", "window.not_a_number_in"), ("7,5,", "window.not_a_number_in"),
     ("1.234,5", "window.not_a_number_in"), ("1,2,3", "window.not_a_number_in")],
)  # fmt: skip
def test_a_wrong_text_stays_visible_and_marked(form, qtbot, text: str, code: str) -> None:
    type_into_field(qtbot, form.up, text)
    if not text:
        qtbot.keyClick(form.up, Key.Key_Delete)
    qtbot.keyClick(form.up, Key.Key_Return)
    assert form.up.hasFocus()
    assert form.up.cleanText() == text
    qtbot.keyClick(form.up, Key.Key_Tab)
    assert form.sigma.hasFocus()
    assert form.up.cleanText() == text
    assert form.up.property("wrong") is True
    assert form.up.input_error.code == code
    assert form.up.toolTip() == message_text(form.up.input_error)
    assert form.up.value() == 2.0
    assert form.emitted[-1:] in ([], [2.0])  # intermediate values such as 21 are reverted
    assert form.committed == []
    qtbot.waitUntil(lambda: QToolTip.text() == form.up.toolTip(), timeout=SOON_MS)
    type_into_field(qtbot, form.up, "3")
    qtbot.keyClick(form.up, Key.Key_Tab)
    assert form.up.property("wrong") is False
    assert form.up.input_error is None
    assert form.committed == [3.0]


def test_the_reason_is_shown_after_a_click_elsewhere(form, qtbot) -> None:
    """The tip appears after the release of the mouse, which would close it."""
    type_into_field(qtbot, form.up, "2173")
    qtbot.mousePress(form.sigma.lineEdit(), Qt.MouseButton.LeftButton)
    form.sigma.setFocus()  # as the window system does at a click
    qtbot.wait(80)
    qtbot.mouseRelease(form.sigma.lineEdit(), Qt.MouseButton.LeftButton)
    qtbot.waitUntil(lambda: is_shown("window.out_of_range", QToolTip.text()), timeout=SOON_MS)
    assert QToolTip.isVisible()


@pytest.mark.parametrize(
    ("text", "metres"),
    [("1e1", 10.0), ("1,5", 1.5), ("1.5", 1.5), ("-2", -2.0), ("5 mm", 0.005),
     ("5mm", 0.005), ("5 m", 5.0), ("12 cm", 0.12), ("10 ft", 3.048), ("1e-3", 0.001),
     (".25", 0.25), ("1.23456", 1.23456), ("0.01 km", 10.0)],
)  # fmt: skip
def test_numbers_are_read_as_people_write_them(form, qtbot, text: str, metres: float) -> None:
    type_into_field(qtbot, form.up, text)
    qtbot.keyClick(form.up, Key.Key_Return)
    assert form.up.input_error is None
    assert form.up.value() == pytest.approx(metres, abs=1e-12)
    assert form.up.text() == f"{metres:.4f} m".replace("-", "−")
    assert form.committed == [pytest.approx(metres, abs=1e-12)]


@pytest.mark.parametrize(
    ("text", "unit", "number"),
    [("−2", "m", -2.0), ("1\u202f234,5", "m", 1234.5), ("1 2", "m", None), ("1,234.5", "m", None),
     ("30′", "°", 0.5), ("5 s", "m", None), ("2 min", "s", 120.0), ("1e999", "", None),
     ("nan", "", None), ("5 m", "", None)],
)  # fmt: skip
def test_pasted_numbers_are_read_or_refused(text: str, unit: str, number: float | None) -> None:
    assert parse_number(text, unit) == (None if number is None else pytest.approx(number))


def test_an_exponent_is_not_dropped(form, qtbot) -> None:
    type_into_field(qtbot, form.sigma, "1e2")
    assert form.sigma.value() == 100.0
    type_into_field(qtbot, form.sigma, "1e9")
    assert form.sigma.cleanText() == "1e9"
    assert form.sigma.input_error.code == "window.out_of_range"


def test_a_count_must_be_a_whole_number(form, qtbot) -> None:
    type_into_field(qtbot, form.count, "6.5")
    qtbot.keyClick(form.count, Key.Key_Tab)
    assert form.count.input_error.code == "window.not_a_whole_number"
    type_into_field(qtbot, form.count, "1 000")
    qtbot.keyClick(form.count, Key.Key_Tab)
    assert form.count.value() == 1000


def test_values_follow_typing_and_are_committed_once(form, qtbot) -> None:
    type_into_field(qtbot, form.up, "12")
    assert form.emitted == [1.0, 12.0]
    assert form.committed == []
    qtbot.keyClick(form.up, Key.Key_Return)
    qtbot.keyClick(form.up, Key.Key_Tab)
    assert form.committed == [12.0]


def test_steps_are_committed_when_the_focus_leaves(form, qtbot) -> None:
    form.up.setFocus()
    for _ in range(3):
        qtbot.keyClick(form.up, Key.Key_Up)
    assert form.committed == []
    qtbot.keyClick(form.up, Key.Key_Tab)
    assert form.committed == [pytest.approx(2.03)]


def test_the_program_does_not_overwrite_a_text_being_typed(form, qtbot) -> None:
    type_into_field(qtbot, form.up, "5x")
    form.up.setValue(2.0)  # the value in use is shown again
    assert form.up.cleanText() == "5x"
    form.up.setValue(7.0)
    assert form.up.text() == "7.0000 m"
    assert form.up.property("wrong") is False


@pytest.mark.parametrize("text", ["-", "-3", "0", "20000"])
def test_typed_signs_and_digits_are_kept(form, qtbot, text: str) -> None:
    form.sigma.setValue(5.0)
    type_into_field(qtbot, form.sigma, text)
    assert form.sigma.cleanText() == text
    form.up.setFocus()
    assert form.sigma.cleanText() == text
    assert form.sigma.property("wrong") is True
    assert form.sigma.value() == 5.0


def test_a_step_starts_from_the_last_valid_value(form, qtbot) -> None:
    type_into_field(qtbot, form.up, "500")
    qtbot.keyClick(form.up, Key.Key_Up)
    assert form.up.value() == pytest.approx(2.01)


def test_escape_restores_the_last_valid_value(form, qtbot) -> None:
    type_into_field(qtbot, form.up, "-500")
    qtbot.keyClick(form.up, Key.Key_Escape)
    assert form.up.text() == "2.0000 m"


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
        assert shown == "Plage : −328,0840 à 328,0840 ft"
        own.sigma.setFocus()
        assert own.up.value() == 2.0
        assert own.up.cleanText() == "329,5"
        type_into_field(qtbot, own.up, "320,5")
        own.sigma.setFocus()
        assert own.up.value() == pytest.approx(320.5 * 0.3048)
    finally:
        set_language("en")
        units.set_units("degrees", "metres")


@pytest.mark.parametrize(
    ("limit", "text"), [(1e-6, "0.000001"), (1e7, "10000000"), (-2.5, "-2.5"), (0.0, "0")]
)
def test_the_limit_of_a_range_has_no_exponent(limit: float, text: str) -> None:
    assert units.limit_text(limit, None) == text
