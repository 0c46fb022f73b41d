"""Units of the numbers in the window; units of files, reports and scripts are independent.

Values are in a base unit: metres, millimetres, degrees, thousandths of a degree. Only texts, unit
signs and input fields convert them to the chosen unit. Azimuths and inclinations are always in
degrees.
"""

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from decimal import Decimal
from math import floor, log10, radians
from types import MappingProxyType
from typing import Literal

from lispac.language import ShownUnit, number, use_units, without_negative_zero

Base = Literal["m", "mm", "°", "m°"]


@dataclass(frozen=True)
class Unit:
    """Unit that is shown instead of a base unit.

    Attributes
    ----------
    sign : symbol written after a number
    factor : number of these units in one base unit
    finer : number of decimals in addition to those in the base unit
    """

    sign: str
    factor: float = 1.0
    finer: int = 0


def _feet_units(sign: str, metres: float) -> Mapping[Base, Unit]:
    return {"m": Unit(sign, 1.0 / metres), "mm": Unit(sign, 1e-3 / metres, 3)}


METRE_UNITS: Mapping[Base, Unit] = {"m": Unit("m"), "mm": Unit("mm")}
DEGREE_UNITS: Mapping[Base, Unit] = {"°": Unit("°"), "m°": Unit("0.001°")}
LENGTH_UNITS: Mapping[str, Mapping[Base, Unit]] = MappingProxyType(
    {
        "metres": METRE_UNITS,
        "feet": _feet_units("ft", 0.3048),
        "survey feet": _feet_units("ftUS", 1200 / 3937),
    }
)
"""Units of lengths by their stored key; with feet, small lengths are in decimals of a foot."""
ANGLE_UNITS: Mapping[str, Mapping[Base, Unit]] = MappingProxyType(
    {
        "degrees": DEGREE_UNITS,
        "milliradians": {
            "°": Unit("mrad", 1e3 * radians(1), -1),
            "m°": Unit("µrad", 1e3 * radians(1), -1),
        },
        "minutes": {"°": Unit("′", 60.0, -1), "m°": Unit("″", 3.6)},
    }
)
ROUNDING_TOLERANCE = 1e-3
"""Relative tolerance for a typed limit that was shown rounded to four digits."""
_shown_units: dict[Base, Unit] = {**METRE_UNITS, **DEGREE_UNITS}

_SIGN_PATTERNS: Mapping[Base, str] = {
    "m": r"(?:(?<=[\s(])m(?![\w²³/'’])|\bmetres\b|\bmètres\b)",
    "mm": r"(?:\bmm\b|\bmillimetres\b|\bmillimètres\b)",
    "°": r"(?:\bdeg\b|°|\bdegrees\b|\bdegrés\b)",
    "m°": r"0[.,]001\s?°",
}
"""Regular expressions of the signs and names of the base units in English and French texts."""
_FORMAT_PATTERN = re.compile(r"(?P<before>[+,]*)\.(?P<decimals>\d+)f")


def set_units(angles: str, lengths: str) -> None:
    """Set the units, given by their keys, for the next window that is created."""
    _shown_units.update({**ANGLE_UNITS[angles], **LENGTH_UNITS[lengths]})
    _use_units_in_texts()


@contextmanager
def standard_units() -> Iterator[None]:
    """Context with metres and degrees, for pictures in files and reports."""
    former = dict(_shown_units)
    set_units("degrees", "metres")
    try:
        yield
    finally:
        _shown_units.update(former)
        _use_units_in_texts()


def _use_units_in_texts() -> None:
    specifications: Mapping[str, Base] = {"m": "m", "mm": "mm", "deg": "°"}
    use_units(
        {
            name: ShownUnit(shown.sign, shown.factor, shown.finer)
            for name, base in specifications.items()
            if (shown := _shown_units[base]).factor != 1.0
        }
    )


def shown_unit(base: Base) -> Unit:
    """Unit shown instead of a base unit."""
    return _shown_units[base]


def figure(value: float, base: Base, form: str) -> str:
    """Text of a value, given in the base unit, in the unit shown, without its sign.

    Parameters
    ----------
    form : str
        Format in the base unit, as in ``f"{value:{form}}"``; its decimals are adapted to the unit.
    """
    shown = _shown_units[base]
    fixed = _FORMAT_PATTERN.fullmatch(form)
    value *= shown.factor
    if fixed is None:
        return f"{value:{form}}"
    decimals = shown_decimals(int(fixed["decimals"]), base)
    value = without_negative_zero(value, decimals)
    before = fixed["before"] if value else fixed["before"].replace("+", "")  # zero has no sign
    return f"{value:{before}.{decimals}f}"


def amount(value: float, base: Base, form: str) -> str:
    """Text of a value with the sign of the unit shown; the value is in the base unit."""
    sign = _shown_units[base].sign
    return figure(value, base, form) + (sign if sign in "°′″" else f" {sign}")


def localised(text: str) -> str:
    """Convert a number in English notation to the user's language, with a true minus sign."""
    if "e" not in text:
        decimals = len(text.partition(".")[2])
        text = number(float(text.replace(",", "")), decimals, sign=text.startswith("+"))
    return text.replace("-", "\N{MINUS SIGN}")


def local_figure(value: float, base: Base, form: str) -> str:
    """Text of `figure`, in the user's language."""
    return localised(figure(value, base, form))


def local_sign(base: Base) -> str:
    """Sign of the unit shown, in the user's language."""
    sign = _shown_units[base].sign
    return f"{localised(sign[:-1])}°" if sign[0].isdigit() else sign


def local_amount(value: float, base: Base, form: str) -> str:
    """Text of a value with the sign of its unit, in the user's language."""
    sign = local_sign(base)
    blank = "" if sign in "°′″" else "\N{NO-BREAK SPACE}"
    return f"{local_figure(value, base, form)}{blank}{sign}"


def plain_figure(value: float, digits: int) -> str:
    """Text of a number with at most this many significant digits and without an exponent."""
    return f"{Decimal(f'{value:.{digits}g}'):f}"


def limit_text(value: float, base: Base | None) -> str:
    """Text of a limit of a range, with four digits if it is converted."""
    if base is None or not is_converted(base):
        return plain_figure(value, 10)
    return plain_figure(value * _shown_units[base].factor, 4)


def snap_to_limits(value: float, base: Base | None, low: float, high: float) -> float:
    """Value in the base unit, set to the limit if it exceeds the limit by a rounding error only."""
    if not is_converted(base):
        return value
    if low - ROUNDING_TOLERANCE * abs(low) <= value < low:
        return low
    return high if high < value <= high + ROUNDING_TOLERANCE * abs(high) else value


def shown_decimals(usual: int, base: Base) -> int:
    """Number of decimals in the unit shown, for ``usual`` decimals in the base unit."""
    return max(usual + _shown_units[base].finer, 0)


def shown_step(usual: float, base: Base) -> float:
    """Step in the base unit that is 1, 2 or 5 times a power of ten in the unit shown."""
    shown = _shown_units[base]
    if shown.factor == 1.0:
        return usual
    usual_step = usual * shown.factor
    power = 10.0 ** floor(log10(usual_step))
    return (
        min((1.0, 2.0, 5.0, 10.0), key=lambda k: abs(k * power - usual_step)) * power / shown.factor
    )


def is_converted(base: Base | None) -> bool:
    """Whether the unit shown differs from the base unit."""
    return base is not None and _shown_units[base].factor != 1.0


def convert_unit_signs(text: str, *bases: Base, figures: bool = True) -> str:
    """Replace the signs of base units in a text by those of the units shown.

    Parameters
    ----------
    figures : bool
        Whether the numbers in the text were converted by `figure`; if not, unit signs after
        numbers are kept.
    """

    def replaced(match: re.Match[str]) -> str:
        before = match["before"] or ""
        if not before:
            return shown.sign
        if not figures:
            return match[0]
        return before[0] + ("" if shown.sign in "°′″" else "\N{NO-BREAK SPACE}") + shown.sign

    for base in bases:
        shown = _shown_units[base]
        if shown.factor != 1.0:
            text = re.sub(rf"(?P<before>\d\s?)?{_SIGN_PATTERNS[base]}", replaced, text)
    return text
