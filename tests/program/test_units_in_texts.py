"""Tests that texts show lengths and angles in the units of the user."""

import re
from collections.abc import Iterator
from math import radians
from string import Formatter

import pytest

from lispac.gui.appearance import units
from lispac.language import gettext, in_language
from lispac.message_texts import english_text, message_text
from lispac.messages import note
from tests.support.french_catalogue import FRENCH

NBSP = "\N{NO-BREAK SPACE}"


@pytest.fixture(autouse=True)
def feet_and_milliradians() -> Iterator[None]:
    units.set_units("milliradians", "feet")
    yield
    units.set_units("degrees", "metres")


@pytest.mark.parametrize(
    ("template", "expected"),
    [
        ("{m:m.1} m long", f"9.8{NBSP}ft long"),
        ("{m:m.1} to {m:m.2} m", f"9.8 to 9.84{NBSP}ft"),
        ("{m:mm.0} mm, given {m:m.0} m", f"9.843{NBSP}ft, given 10{NBSP}ft"),
        ("{deg:deg.3} ± {deg:deg.3+} deg", f"8.73 ± +8.73{NBSP}mrad"),
        ("{{m}} {m:m} metres", f"{{m}} 9.84{NBSP}ft"),
        ("{m:m.1} m/s", "3.0 m/s"),
        ("{m:x.1} m²", "3.0 m²"),
        ("heading {deg:deg.0} deg", "heading 0 deg"),
        ("{m:m.0} by {m:s.0} s", "3 by 3 s"),
    ],
)
def test_numbers_and_signs_are_in_the_unit_of_the_user(template: str, expected: str) -> None:
    assert gettext(template, m=3.0, deg=radians(0.5)) == expected


def test_reports_and_json_have_metres_and_degrees() -> None:
    message = note("mounting.lever_arm_long", length=30.0)
    assert "98.4" in message_text(message)
    assert "30.0 m" in english_text(message)
    with in_language("fr"):
        assert "30,0" in message_text(message)


def test_no_length_keeps_the_sign_of_a_metric_unit() -> None:
    """Of all texts of the catalogue, in both languages; constants in a text are metric."""
    metric = re.compile(r"(?<!\d)7[.,\d]*[ \u00a0\u202f]?(?:m|mm|metres|mètres)(?![\w²³/])")
    for language, texts in (("en", FRENCH), ("fr", FRENCH.values())):
        for template in texts:
            shown = gettext(template, **values_of(template))
            assert not metric.search(shown), (language, shown)


def values_of(template: str) -> dict[str, object]:
    """Values for the placeholders of a text: 7 for all numbers."""
    values: dict[str, object] = {"count": 7}
    for _, name, spec, _ in Formatter().parse(template):
        if name:
            is_list = spec in ("names", "choices", "sentences")
            values[name] = ["a"] if is_list else "a" if spec in ("", "title") else 7.0
    return values
