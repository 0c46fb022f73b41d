"""Units of the numbers shown and typed in the window; files, reports and scripts have their own.

Values are in a base unit: metres, millimetres, degrees, thousandths of a degree. Only numbers as
text, signs of units and fields convert them to the unit chosen. Azimuths and inclinations are in
degrees whatever the choice.
"""

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from math import floor, log10, radians
from types import MappingProxyType
from typing import Literal

from lispac.language import number

Base = Literal["m", "mm", "°", "m°"]


@dataclass(frozen=True)
class Unit:
    """What stands in place of a base.

    Attributes
    ----------
    sign : as it follows a figure
    factor : of these to one of the base
    finer : decimals more than in the base
    """

    sign: str
    factor: float = 1.0
    finer: int = 0


def _feet(sign: str, metres: float) -> Mapping[Base, Unit]:
    return {"m": Unit(sign, 1.0 / metres), "mm": Unit(sign, 1e-3 / metres, 3)}


METRES: Mapping[Base, Unit] = {"m": Unit("m"), "mm": Unit("mm")}
DEGREES: Mapping[Base, Unit] = {"°": Unit("°"), "m°": Unit("0.001°")}
LENGTHS: Mapping[str, Mapping[Base, Unit]] = MappingProxyType(
    {"metres": METRES, "feet": _feet("ft", 0.3048), "survey feet": _feet("ftUS", 1200 / 3937)}
)
"""By the key that is kept; small lengths are in feet, too, as surveyors who use them do."""
ANGLES: Mapping[str, Mapping[Base, Unit]] = MappingProxyType(
    {
        "degrees": DEGREES,
        "milliradians": {
            "°": Unit("mrad", 1e3 * radians(1), -1),
            "m°": Unit("µrad", 1e3 * radians(1), -1),
        },
        "minutes": {"°": Unit("′", 60.0, -1), "m°": Unit("″", 3.6)},
    }
)
ROUNDED = 1e-3
"""Share by which four digits may be off."""
_used: dict[Base, Unit] = {**METRES, **DEGREES}

_SIGNS: Mapping[Base, str] = {
    "m": r"(?:(?<=[\s(])m(?![\w²³/'’])|\bmetres\b|\bmètres\b)",
    "mm": r"(?:\bmm\b|\bmillimetres\b|\bmillimètres\b)",
    "°": r"(?:\bdeg\b|°|\bdegrees\b|\bdegrés\b)",
    "m°": r"0[.,]001\s?°",
}
_FORM = re.compile(r"(?P<before>[+,]*)\.(?P<decimals>\d+)f")


def show_in(angles: str, lengths: str) -> None:
    """Use units from now on, by their keys; the window is made anew then."""
    _used.update({**ANGLES[angles], **LENGTHS[lengths]})


@contextmanager
def standard() -> Iterator[None]:
    """Metres and degrees for a while: for pictures that go into a file or a report."""
    kept = dict(_used)
    show_in("degrees", "metres")
    try:
        yield
    finally:
        _used.update(kept)


def unit(base: Base) -> Unit:
    """What is shown in place of a base."""
    return _used[base]


def figure(value: float, base: Base, form: str) -> str:
    """A value in the base as a figure in the unit shown.

    Parameters
    ----------
    form : str
        Of the figure in the base, as in ``f"{value:{form}}"``; its decimals follow the unit.
    """
    shown = _used[base]
    fixed = _FORM.fullmatch(form)
    if fixed is not None and shown.finer:
        form = f"{fixed['before']}.{decimals(int(fixed['decimals']), base)}f"
    return f"{value * shown.factor:{form}}"


def amount(value: float, base: Base, form: str) -> str:
    """The same with its sign, as it stands in a sentence."""
    sign = _used[base].sign
    return figure(value, base, form) + (sign if sign in "°′″" else f" {sign}")


def localised(text: str) -> str:
    """A figure in English notation as in the user's language, with a true minus sign."""
    if "e" not in text:
        decimals = len(text.partition(".")[2])
        text = number(float(text.replace(",", "")), decimals, sign=text.startswith("+"))
    return text.replace("-", "\N{MINUS SIGN}")


def local_figure(value: float, base: Base, form: str) -> str:
    """A figure as `figure` makes it, written as in the user's language."""
    return localised(figure(value, base, form))


def local_sign(base: Base) -> str:
    """The sign of the unit shown, written as in the user's language."""
    sign = _used[base].sign
    return f"{localised(sign[:-1])}°" if sign[0].isdigit() else sign


def local_amount(value: float, base: Base, form: str) -> str:
    """A value with the sign of its unit, written as in the user's language."""
    sign = local_sign(base)
    blank = "" if sign in "°′″" else "\N{NO-BREAK SPACE}"
    return f"{local_figure(value, base, form)}{blank}{sign}"


def limit(value: float, base: Base) -> str:
    """The end of a range, to four digits where it is converted."""
    shown = float(f"{value * _used[base].factor:.4g}") if differs(base) else value
    return f"{shown:,.10g}"


def ended(value: float, base: Base | None, low: float, high: float) -> float:
    """A value in the base; what lies beyond an end by its rounding in `limit` is that end."""
    if not differs(base):
        return value
    if low - ROUNDED * abs(low) <= value < low:
        return low
    return high if high < value <= high + ROUNDED * abs(high) else value


def decimals(usual: int, base: Base) -> int:
    """How many are shown where the base has so many."""
    return max(usual + _used[base].finer, 0)


def step(usual: float, base: Base) -> float:
    """In the base: what an arrow of a field adds, the nearest 1, 2 or 5 of the unit shown."""
    shown = _used[base]
    if shown.factor == 1.0:
        return usual
    wanted = usual * shown.factor
    power = 10.0 ** floor(log10(wanted))
    return min((1.0, 2.0, 5.0, 10.0), key=lambda k: abs(k * power - wanted)) * power / shown.factor


def differs(base: Base | None) -> bool:
    """Whether another unit is shown."""
    return base is not None and _used[base].factor != 1.0


def signs(said: str, *bases: Base, figures: bool = True) -> str:
    """A text in the user's language with the signs of the units shown instead of the bases'.

    Parameters
    ----------
    figures : bool
        Whether those in the text are of `figure`; others stay, with the unit they are in.
    """

    def replaced(found: re.Match[str]) -> str:
        before = found["before"] or ""
        if not before:
            return shown.sign
        if not figures:
            return found[0]
        return before[0] + ("" if shown.sign in "°′″" else "\N{NO-BREAK SPACE}") + shown.sign

    for base in bases:
        shown = _used[base]
        if shown.factor != 1.0:
            said = re.sub(rf"(?P<before>\d\s?)?{_SIGNS[base]}", replaced, said)
    return said
