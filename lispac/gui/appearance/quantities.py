"""Lengths and angles as text, in the units and the language of the user."""

from lispac.gui.appearance import units
from lispac.gui.appearance.units import Base
from lispac.language import number

_MINUS_SIGN = "\N{MINUS SIGN}"
_ANGLE_SIGNS = "°′″"
"""Signs that follow a number without a space."""


def figure(value: float, base: Base, decimals: int, *, sign: bool = False) -> str:
    """Text of a value without its unit.

    Parameters
    ----------
    value : float
        Value in the base unit.
    decimals : int
        Decimals in the base unit; their number is adapted to the unit shown.
    """
    return units.local_figure(value, base, f"{'+' if sign else ''}.{decimals}f")


def amount(value: float, base: Base, decimals: int, *, sign: bool = False) -> str:
    """Text of a value with its unit."""
    return f"{figure(value, base, decimals, sign=sign)}{unit_suffix(base)}"


def unit_suffix(base: Base) -> str:
    """Sign of the unit shown, preceded by a space if one is usual."""
    shown = units.local_sign(base)
    return shown if shown in _ANGLE_SIGNS else f"\N{NO-BREAK SPACE}{shown}"


def signed_number(value: float, decimals: int, *, sign: bool = True) -> str:
    """Text of a number in the language of the user, with a true minus sign."""
    return number(float(value), decimals, sign=sign).replace("-", _MINUS_SIGN)
