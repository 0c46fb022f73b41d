"""Texts and units for results of an adjustment in window, report and command line."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from lispac.adjustment.result import SightingReliability, VarianceComponent
from lispac.messages import Message, note


@dataclass(frozen=True)
class ParameterDisplay:
    """Title, unit and decimals of a value estimated besides the boresight.

    Attributes
    ----------
    title : begins a sentence
    factor : shown units to one metre, radian or second
    decimals : of the value in its unit
    """

    title: str
    factor: float
    unit: Literal["m", "deg", "ms"]
    decimals: int


_DEG = math.degrees(1.0)
QUANTITIES: Mapping[str, ParameterDisplay] = {
    "lever_x": ParameterDisplay("Lever arm X", 1.0, "m", 4),
    "lever_y": ParameterDisplay("Lever arm Y", 1.0, "m", 4),
    "lever_z": ParameterDisplay("Lever arm Z", 1.0, "m", 4),
    "range_offset": ParameterDisplay("Range offset", 1.0, "m", 4),
    "scan_angle_offset": ParameterDisplay("Scan-angle offset", _DEG, "deg", 4),
    "latency": ParameterDisplay("Latency", 1e3, "ms", 2),
}

OUTPUT_UNITS: Mapping[str, tuple[float, str]] = {
    name: (1.0, "s") if name == "latency" else (each.factor, each.unit)
    for name, each in QUANTITIES.items()
}
"""Factor from what is stored to what is typed in a terminal and written as JSON, and its unit."""

UNCHECKED_SHIFT = 1.0
"""Metres: a shift that has to be larger to be found is not checked by anything."""


def number_with_noun(number: int, what: str) -> str:
    """A number with its noun: ``1 target``, ``2,202 points``."""
    return f"{number:,} {what}" if number == 1 else f"{number:,} {what}s"


MAX_INTERVAL_RATIO = 10.0
"""Ratio of the ends of a variance component's interval beyond which it is not determined."""


def variance_component_finding(component: VarianceComponent) -> Message:
    """Whether a variance component changed the standard deviations, and why."""
    if component.applied:
        return note("component.larger" if component.factor > 1 else "component.smaller")
    if component.upper > MAX_INTERVAL_RATIO * component.lower:
        return note("component.not_determined")
    if component.lower <= 1 <= component.upper:
        return note("component.as_given")
    return note("component.too_small")


def parameter_label(name: str) -> str:
    """Name of a value of the mounting; an angle's name is its own."""
    if name not in QUANTITIES:
        return name
    words = QUANTITIES[name].title
    return words[0].lower() + words[1:]


def capitalised(text: str) -> str:
    """The text with a capital first letter, all others as they are."""
    return text[:1].upper() + text[1:]


def join_names(names: Sequence[str]) -> str:
    """Join names as in a sentence: a, b and c."""
    *head, last = names
    return f"{', '.join(head)} and {last}" if head else last


ASCII_CHARACTERS = {
    "\u2212": "-",
    "\u2013": "-",
    "\u03c3": "sigma",
    "\u00a0": " ",
    "\u00b1": "+/-",
    "\u00b2": "2",
    "\u00b0": " deg",
}


def to_plain_text(text: str) -> str:
    """Text without signs and fixed spaces that some terminals cannot show."""
    for sign, words in ASCII_CHARACTERS.items():
        text = text.replace(sign, words)
    return text


SightingStatus = Literal["rejected", "not checked", "disagrees", "agrees"]


def sighting_status(item: SightingReliability, critical: float) -> SightingStatus:
    """Status of a sighting; ``critical`` is the critical test value."""
    if item.rejected:
        return "rejected"
    if not item.detectable < UNCHECKED_SHIFT:
        return "not checked"
    return "disagrees" if abs(item.w) > critical else "agrees"
