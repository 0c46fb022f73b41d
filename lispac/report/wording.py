"""How the report writes numbers."""

from collections.abc import Callable, Sequence
from datetime import datetime

from lispac.adjustment.shown import (
    HALVES,
    QUANTITIES,
    STATED,
    listed,
    minus,
    mm,
    parameter,
    signed,
    surface_sigmas,
    times,
)
from lispac.adjustment.shown import capitalised as title
from lispac.report.values import CheckedPart, CrossChecked

__all__ = [
    "UNKNOWN", "angle", "count", "heading", "known", "listed", "minus", "mm", "moment",
    "named_parts", "origin", "parameter", "quantity", "signed", "surface_sigmas", "times", "title",
    "triple",
]  # fmt: skip

UNKNOWN = "\u2013"


def known(value: float | None, formatted: Callable[[float], str], unknown: str = UNKNOWN) -> str:
    """The value in words, or a dash where it is not known."""
    return unknown if value is None else formatted(value)


def angle(value: float) -> str:
    """An angle in degrees, four decimals."""
    return signed(value, 4)


def heading(value: float) -> str:
    """A heading in degrees, 0 to 360."""
    return f"{value % 360:.1f}"


def triple(values: Sequence[float], decimals: int) -> str:
    """Three numbers in a row."""
    return ", ".join(minus(f"{value:.{decimals}f}") for value in values)


def origin(origin: Sequence[float] | None) -> str:
    """Latitude, longitude (degrees) and height (metres) in words."""
    if origin is None:
        return "mean of the trajectory"
    latitude, longitude, height = origin
    return minus(f"latitude {latitude:.8f} deg, longitude {longitude:.8f} deg, {height:.3f} m")


def named_parts(checks: CrossChecked) -> list[tuple[str, CheckedPart]]:
    """Cross-checked parts with their names; two halves that are compared with each other once."""
    named = [(f"Without {p.kind} {p.part}", p) for p in checks.parts if p.kind != "half"]
    halves = [part for part in checks.parts if part.kind == "half"]
    if halves and all(half.boresight_deg is not None for half in halves):
        return [*named, (HALVES, halves[0])]
    return [*named, *((f"{title(half.part)} half alone", half) for half in halves)]


def quantity(name: str, value: float, *, sign: bool = False) -> str:
    """A value of the mounting, in metres, degrees or seconds, with the unit it is shown in."""
    shown, (stated, _) = QUANTITIES[name], STATED[name]
    number = shown.factor / stated * value
    return minus(f"{number:{'+' if sign else ''}.{shown.decimals}f}\u00a0{shown.unit}")


def count(number: int, what: str) -> str:
    """A number with its noun."""
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def moment(stamp: str) -> str:
    """An ISO 8601 time to the minute."""
    at = datetime.fromisoformat(stamp)
    return f"{at:%Y-%m-%d %H:%M} {at.tzname()}"
