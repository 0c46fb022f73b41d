"""Texts about an adjustment for the window, the report and the command line."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from lispac.adjustment.result import Component, SightingReliability
from lispac.messages import Message, note


@dataclass(frozen=True)
class Quantity:
    """How a value estimated besides the boresight is shown.

    Attributes
    ----------
    title : begins a sentence
    factor : shown units to one metre, radian or second
    decimals : of the value in its unit
    """

    title: str
    factor: float
    unit: str
    decimals: int


_DEG = math.degrees(1.0)
QUANTITIES: Mapping[str, Quantity] = {
    "lever_x": Quantity("Lever arm X", 1.0, "m", 4),
    "lever_y": Quantity("Lever arm Y", 1.0, "m", 4),
    "lever_z": Quantity("Lever arm Z", 1.0, "m", 4),
    "range_offset": Quantity("Range offset", 1.0, "m", 4),
    "scan_angle_offset": Quantity("Scan-angle offset", _DEG, "deg", 4),
    "latency": Quantity("Latency", 1e3, "ms", 2),
}

STATED: Mapping[str, tuple[float, str]] = {
    name: (1.0, "s") if name == "latency" else (each.factor, each.unit)
    for name, each in QUANTITIES.items()
}
"""Factor from what is stored to what is typed in a terminal and written as JSON, and its unit."""

UNCHECKED = 1.0
"""Metres: a shift that has to be larger to be found is not checked by anything."""


def counted(number: int, what: str) -> str:
    """A number with its noun: ``1 target``, ``2,202 points``."""
    return f"{number:,} {what}" if number == 1 else f"{number:,} {what}s"


VAGUE = 10.0
"""Ratio of the ends of a variance component's interval beyond which it is not determined."""


def component_finding(found: Component) -> Message:
    """Whether the standard deviations were changed by a variance component, and why."""
    if found.applied:
        return note("component.larger" if found.factor > 1 else "component.smaller")
    if found.upper > VAGUE * found.lower:
        return note("component.not_determined")
    if found.lower <= 1 <= found.upper:
        return note("component.as_given")
    return note("component.too_small")


def parameter(name: str) -> str:
    """Text for a mounting parameter; an angle has its own name."""
    if name not in QUANTITIES:
        return name
    words = QUANTITIES[name].title
    return words[0].lower() + words[1:]


def capitalised(text: str) -> str:
    """The text with a capital first letter, all others as they are."""
    return text[:1].upper() + text[1:]


def listed(names: Sequence[str]) -> str:
    """Names as in a sentence: a, b and c."""
    *head, last = names
    return f"{', '.join(head)} and {last}" if head else last


PLAIN = {"\u2212": "-", "\u00a0": " ", "\u00b1": "+/-", "\u00b2": "2", "\u00b0": " deg"}


def plain(text: str) -> str:
    """The text without signs and fixed spaces that not every terminal can show."""
    for sign, words in PLAIN.items():
        text = text.replace(sign, words)
    return text


Standing = Literal["left out", "not checked", "disagrees", "agrees"]


def standing(item: SightingReliability, critical: float) -> Standing:
    """How a sighting stands with the others; ``critical`` is the largest test value by chance."""
    if item.released:
        return "left out"
    if not item.detectable < UNCHECKED:
        return "not checked"
    return "disagrees" if abs(item.w) > critical else "agrees"
