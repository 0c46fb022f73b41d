"""Tests of the design window in feet and milliradians; the plan stays metric."""

from collections.abc import Iterator

import pytest
from PySide6.QtWidgets import QApplication

from lispac.errors import InputError
from lispac.gui.appearance import units
from lispac.gui.features.design import edits
from lispac.gui.features.design.plan_tables import LINE_FIELDS, TARGET_FIELDS, LinesList
from lispac.gui.features.design.search import LimitsForm, parse_numbers
from lispac.gui.features.design.system import SystemPanel
from lispac.gui.features.design.workspace import Workspace
from tests.support.error_codes import has_code
from tests.support.message_codes import is_shown

FOOT = 0.3048
"""Metres, by definition."""
LINE = {field.name: field for field in LINE_FIELDS}
TARGET = {field.name: field for field in TARGET_FIELDS}


@pytest.fixture(autouse=True)
def imperial() -> Iterator[None]:
    units.set_units("milliradians", "feet")
    yield
    units.set_units("degrees", "metres")


def test_a_table_accepts_feet_and_keeps_headings_in_degrees(qapp: QApplication) -> None:
    workspace = Workspace()
    lines = LinesList(workspace)
    table = lines.table
    assert table.horizontalHeaderItem(2).text() == "Distance\n(ft)"
    assert table.horizontalHeaderItem(4).text() == "Speed\n(ft/s)"
    distance = workspace.titled.plan.lines[0].distance
    assert table.item(0, 2).text() == f"{distance / FOOT:.1f}"
    assert LINE["distance"].read("50") == pytest.approx(50 * FOOT)
    assert LINE["speed"].read("3") == pytest.approx(3 * FOOT)
    assert LINE["heading"].read("50") == 50.0
    assert TARGET["flatness"].read("0.002") == pytest.approx(0.6096)  # the value is in millimetres
    assert TARGET["flatness"].shown(0.6096) == "0.0020"


def test_the_limit_of_a_range_is_accepted_as_it_is_shown(qapp: QApplication) -> None:
    assert LINE["distance"].limit(edits.MAX_LINE_DISTANCE_M) == "656.2"
    assert LINE["distance"].read("656.2") == edits.MAX_LINE_DISTANCE_M
    values = {"text": "700", "low": "3.281", "high": "656.2", "unit": "ft"}
    with pytest.raises(InputError, check=has_code("window.out_of_range", **values)):
        LINE["distance"].read("700")


def test_limits_that_are_not_edited_keep_all_digits(qapp: QApplication) -> None:
    form, titled = LimitsForm(), edits.default_plan()
    _, site = form.site(titled)
    with units.standard_units():
        metric = LimitsForm().site(titled)[1]
    assert vars(site) == vars(metric)
    form.lists["heights"].setText("10, 20")
    assert form.site(titled)[1].heights == pytest.approx((10 * FOOT, 20 * FOOT))
    assert is_shown("window.out_of_range", refusal("700"))
    assert "−164 to 656.2 ft" in refusal("700")


def refusal(text: str) -> str:
    with pytest.raises(InputError) as caught:
        parse_numbers(text, "Boards up", "m", -50.0, 200.0)
    return str(caught.value)


@pytest.mark.parametrize(
    ("text", "decimal", "numbers"),
    [
        ("0, 90, 180", ".", (0, 90, 180)), ("0,90,180", ".", (0, 90, 180)),
        ("1,5; 2", ".", (1.5, 2)), ("1,5 2,5", ".", (1.5, 2.5)), ("1.5,2.5", ".", (1.5, 2.5)),
        ("1,5;", ".", (1.5,)), ("1,5", ",", (1.5,)), ("1, 5", ",", (1, 5)),
        ("5 m, 600 cm", ".", (5, 6)), ("5m,6m", ".", (5, 6)), ("−1,5 m; 2 m", ".", (-1.5, 2)),
        ("1.5,2", ",", (1.5, 2)), ("10 20 30", ".", (10, 20, 30)), ("1,5; 2,5", ",", (1.5, 2.5)),
    ],
)  # fmt: skip
def test_a_list_of_numbers_is_read_with_commas_and_units(
    text: str, decimal: str, numbers: tuple[float, ...]
) -> None:
    with units.standard_units():
        assert parse_numbers(text, "Heights", "m", -50.0, 200.0, decimal) == pytest.approx(numbers)


@pytest.mark.parametrize(
    ("text", "code"),
    [("1,5", "ambiguous_comma"), ("0, 90, 180,5", "ambiguous_comma"), ("5 kg", "not_a_number_in"),
     ("5°", "not_a_number_in"), ("1,5 m", "ambiguous_comma"), (" ", "no_numbers")],
)  # fmt: skip
def test_a_list_that_can_be_read_in_two_ways_is_refused(text: str, code: str) -> None:
    with units.standard_units(), pytest.raises(InputError) as caught:
        parse_numbers(text, "Heights", "m", -50.0, 200.0)
    assert caught.value.message.code == f"window.{code}"


def test_two_decimal_commas_are_not_a_number() -> None:
    with units.standard_units(), pytest.raises(InputError) as caught:
        parse_numbers("4,5,6", "Heights", "m", -50.0, 200.0, ",")
    assert caught.value.message.code == "window.not_a_number_in"


def test_angles_of_a_list_may_have_their_unit() -> None:
    found = parse_numbers("90°; 1,5 deg", "Headings", "deg", -360.0, 360.0)
    assert found == pytest.approx((90.0, 1.5))


def test_a_field_of_the_system_is_in_feet_and_edits_only_itself(qapp: QApplication) -> None:
    workspace = Workspace()
    panel, before = SystemPanel(workspace), workspace.titled.plan.system
    assert panel.max_range.text() == f"{before.scanner.max_range / FOOT:.0f} ft"
    assert panel.attitude[0].suffix() == " mrad"
    panel.max_range.lineEdit().setText("500")
    panel.max_range.interpretText()
    after = workspace.titled.plan.system
    assert after.scanner.max_range == pytest.approx(500 * FOOT)
    assert after.pos == before.pos
    assert panel.max_range.text() == "500 ft"


@pytest.mark.parametrize(("length", "shown"), [(0.1, 0.2), (0.01, 0.02), (0.5, 2.0), (1.0, 2.0)])
def test_drags_use_round_steps_in_the_chosen_unit(length: float, shown: float) -> None:
    steps = edits.round_to_step(12.3456, length) / FOOT / shown
    assert steps == pytest.approx(round(steps), abs=1e-6)
    with units.standard_units():
        assert edits.round_to_step(12.3456, length) == pytest.approx(
            round(12.3456 / length) * length, abs=1e-12
        )
