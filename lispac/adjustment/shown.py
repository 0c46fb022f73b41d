"""How an adjustment is told to people, alike in the window, the report and the command line."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from lispac.adjustment.result import CrossCheck, CrossChecks


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

SPREAD_LINES = "Spread, one line left out"
SPREAD_TARGETS = "Spread, one target left out"
HALVES = "First half less second half"


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
