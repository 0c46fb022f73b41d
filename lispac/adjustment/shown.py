"""How an adjustment is told to people, alike in the window, the report and the command line."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Literal

from lispac.adjustment.parameters import Estimate
from lispac.adjustment.result import Component, CrossCheck, CrossChecks, SightingReliability


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

SPREAD_LINES = "Spread, one line left out"
SPREAD_TARGETS = "Spread, one target left out"
HALVES = "First minus second half"


def counted(number: int, what: str) -> str:
    """A number with its noun: ``1 target``, ``2,202 points``."""
    return f"{number:,} {what}" if number == 1 else f"{number:,} {what}s"


def named_parts(checks: CrossChecks) -> Iterator[tuple[str, CrossCheck]]:
    """Parts with their names; two halves that are compared with each other once."""
    yield from ((f"Without {p.kind} {p.without}", p) for p in checks.parts if p.kind != "half")
    halves = [part for part in checks.parts if part.kind == "half"]
    if halves and all(half.boresight is not None for half in halves):
        yield HALVES, halves[0]
        return
    yield from ((f"{half.without.capitalize()} half alone", half) for half in halves)


VAGUE = 10.0
"""Upper over lower end of a variance component's interval beyond which the data tell nothing."""


@dataclass(frozen=True)
class ComponentShown:
    """A variance component as it is shown.

    Attributes
    ----------
    name : whose sigmas
    factor : on the stated sigmas
    interval : of the factor, 95 %
    finding : whether the sigmas were changed by it, and why
    """

    name: str
    factor: str
    interval: str
    finding: str

    @property
    def sentence(self) -> str:
        """The same in one line."""
        return f"{self.name} sigmas times {self.factor} (95 %: {self.interval}), {self.finding}"


def component_shown(found: Component) -> ComponentShown:
    """A variance component in words; whether it was applied is what the adjustment says."""
    if found.applied:
        finding = f"applied: {'larger' if found.factor > 1 else 'smaller'} than stated"
    elif found.upper > VAGUE * found.lower:
        finding = "not applied: the data do not tell"
    elif found.lower <= 1 <= found.upper:
        finding = "not applied: as stated, within the interval"
    else:
        finding = "not applied: too little, or seen too weakly, to change what is stated"
    return ComponentShown(
        found.name, f"{found.factor:.2f}", f"{found.lower:.2f} to {found.upper:.2f}", finding
    )


def significance_words(estimate: Estimate) -> str:
    """Whether a value earns its place; empty where there is none."""
    if estimate.value is None:
        return ""
    untested = "not tested: with uncorrelated POS errors the sigmas are too small"
    return {True: "significant", False: "not significant", None: untested}[estimate.significant]


def parameter(name: str) -> str:
    """A value of the mounting in words; an angle's name is its own."""
    if name not in QUANTITIES:
        return name
    words = QUANTITIES[name].title
    return words[0].lower() + words[1:]


def amount(name: str, value: float) -> str:
    """A value of the mounting, in metres, radians or seconds, with the unit it is shown in."""
    shown = QUANTITIES[name]
    return minus(f"{shown.factor * value:.{shown.decimals}f}\u00a0{shown.unit}")


def capitalised(text: str) -> str:
    """The text with a capital first letter, all others as they are."""
    return text[:1].upper() + text[1:]


def one_of(kind: str, names: Sequence[str]) -> str:
    """``line L1``, or ``any of the lines L1 and L2``."""
    return f"{kind} {names[0]}" if len(names) == 1 else f"any of the {kind}s {listed(names)}"


def listed(names: Sequence[str]) -> str:
    """Names as in a sentence: a, b and c."""
    *head, last = names
    return f"{', '.join(head)} and {last}" if head else last


def minus(text: str) -> str:
    """The text with true minus signs."""
    # A hyphen is easily overlooked in print, and a line may break after it.
    return text.replace("-", "\u2212")


PLAIN = {"\u2212": "-", "\u00a0": " ", "\u00b1": "+/-", "\u00b2": "2", "\u00b0": " deg"}


def plain(text: str) -> str:
    """The text without signs and fixed spaces that not every terminal can show."""
    for sign, words in PLAIN.items():
        text = text.replace(sign, words)
    return text


def signed(value: float, decimals: int) -> str:
    """A number that always shows its sign."""
    return minus(f"{value:+.{decimals}f}")


def mm(metres: float) -> str:
    """Metres as millimetres, one decimal."""
    return f"{1000 * metres:,.1f}"


def surface_sigmas(surface: float, offset: float | None) -> str:
    """Sigma of the surfaces, metres, and that of their offsets where it is another one."""
    if offset is None:
        return f"{_tenths(surface)}\u00a0mm"
    return f"offsets {_tenths(offset)}\u00a0mm, tilts {_tenths(surface)}\u00a0mm"


def _tenths(metres: float) -> str:
    return "below 0.1" if mm(metres) == "0.0" else mm(metres)


def times(factor: float) -> str:
    """How many times something is as large as something else."""
    return f"{factor:.1f}\u00a0times"


Standing = Literal["left out", "not checked", "disagrees", "agrees"]


def standing(item: SightingReliability, critical: float) -> Standing:
    """How a sighting stands with the others; ``critical`` is the largest test value by chance."""
    if item.released:
        return "left out"
    if not item.detectable < UNCHECKED:
        return "not checked"
    return "disagrees" if abs(item.w) > critical else "agrees"
