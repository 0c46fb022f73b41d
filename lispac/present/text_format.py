"""Texts of numbers, units and names in the language in use, for reports and tables."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from datetime import datetime

from lispac.adjustment.model.parameters import OUTPUT_UNITS, PARAMETER_DISPLAYS
from lispac.adjustment.model.parameters import mounting_value_name as quantity_name
from lispac.language import N_, gettext, number, without_negative_zero
from lispac.message_texts import message_text
from lispac.messages import Message

UNKNOWN_TEXT = "\u2013"
"""Dash for an unknown value."""
MINUS_SIGN, DEGREE_SIGN = "\u2212", "\u00b0"
MINUS_PATTERN = re.compile(r"(?<![^\s(])-(?=\d)")
"""Pattern of a hyphen that stands for the minus sign of a number."""

VALUE_TITLES: Mapping[str, str] = {
    "roll": N_("Roll"),
    "pitch": N_("Pitch"),
    "yaw": N_("Yaw"),
    "lever_x": N_("Lever arm X"),
    "lever_y": N_("Lever arm Y"),
    "lever_z": N_("Lever arm Z"),
    "range_offset": N_("Range offset"),
    "scan_angle_offset": N_("Scan-angle offset"),
    "latency": N_("Latency"),
}
"""Titles of the estimated values, for the first cell of a table row."""


def format_known(
    value: float | None, formatted: Callable[[float], str], unknown: str = UNKNOWN_TEXT
) -> str:
    """Formatted value, or the text ``unknown`` for None."""
    return unknown if value is None else formatted(value)


def grouped_number(value: float, decimals: int = 0) -> str:
    """A number with separators between groups of three digits."""
    return localised_number(f"{without_negative_zero(value, decimals):,.{decimals}f}")


def fixed_number(value: float, decimals: int, *, sign: bool = False) -> str:
    """A number without separators between groups of three digits; zero has no sign."""
    shown = without_negative_zero(value, decimals)
    return localised_number(f"{shown:{'+' if sign and shown else ''}.{decimals}f}")


def signed_number(value: float, decimals: int) -> str:
    """A number with its sign; a number rounded to zero has none."""
    return fixed_number(value, decimals, sign=True)


def shortest_number(value: float) -> str:
    """A number without trailing zeros, with at most six significant digits."""
    return localised_number(f"{value or 0.0:g}")


def localised_number(text: str) -> str:
    """A number, as Python writes it, with the signs of the language in use."""
    # `language.number` is not used, since its rounding of a tie may differ from that of Python.
    whole, point, decimals = text.partition(".")
    signs = decimal_sign() if point else ""
    return f"{whole.replace(',', group_sign())}{signs}{decimals}".replace("-", MINUS_SIGN)


def decimal_sign() -> str:
    """Decimal sign of the language in use."""
    return number(0.5, 1).strip("05")


def group_sign() -> str:
    """Sign between groups of three digits in the language in use."""
    return number(1000, 0).strip("01")


def millimetres(metres: float) -> str:
    """Length in metres formatted as millimetres with one decimal."""
    return grouped_number(1000 * metres, 1)


def centimetres(metres: float) -> str:
    """Length in metres formatted as centimetres with two decimals."""
    return fixed_number(100 * metres, 2)


def angle_text(value: float) -> str:
    """Text of an angle in degrees, with its sign and four decimals."""
    return signed_number(value, 4)


def interval_text(half: str) -> str:
    """Half-width of a confidence interval, with a plus-minus sign."""
    return f"\u00b1 {half}"


def triple_text(values: Sequence[float], decimals: int) -> str:
    """Text of three numbers, separated by commas."""
    x, y, z = (fixed_number(value, decimals) for value in values)
    return gettext("{x}, {y}, {z}", x=x, y=y, z=z)


def title_with_unit(title: str, unit: str) -> str:
    """Title of a column with its unit below."""
    return f"{title}\n({unit})"


def sentence_text(message: Message) -> str:
    """Text of a message with minus signs instead of hyphens, as in the tables."""
    return with_minus_signs(message_text(message))


def with_minus_signs(text: str, names: Iterable[str] = ()) -> str:
    """Text with minus signs instead of hyphens before numbers, except in the given names."""
    whole = "|".join(map(re.escape, sorted(names, key=len, reverse=True)))
    pattern = re.compile(f"{whole}|{MINUS_PATTERN.pattern}" if whole else MINUS_PATTERN.pattern)
    return pattern.sub(lambda found: MINUS_SIGN if found.group() == "-" else found.group(), text)


def title(name: str) -> str:
    """Title of an estimated value, for the first cell of a table row."""
    return gettext(VALUE_TITLES[name])


def parameter_name(name: str) -> str:
    """Name of an estimated value, for use within a sentence."""
    return message_text(quantity_name(name))


def origin_text(origin: Sequence[float] | None, *, is_given: bool) -> str:
    """Text of the origin of the local frame: latitude and longitude in degrees, height in metres.

    Parameters
    ----------
    origin : sequence of float or None
        Latitude, longitude, ellipsoidal height; None if it is not known.
    is_given : bool
        Whether the user gave it; otherwise it is the mean position of the trajectory.
    """
    if origin is None:
        return gettext("mean position of the trajectory")
    latitude, longitude, height = origin
    template = (
        N_("latitude {latitude}°, longitude {longitude}°, ellipsoidal height {height} m (given)")
        if is_given
        else N_(
            "latitude {latitude}°, longitude {longitude}°, ellipsoidal height {height} m (mean "
            "position of the trajectory)"
        )
    )
    return gettext(
        template,
        latitude=fixed_number(latitude, 8),
        longitude=fixed_number(longitude, 8),
        height=fixed_number(height, 3),
    )


def quantity_text(name: str, value: float, *, sign: bool = False) -> str:
    """Text of a value of the mounting with its displayed unit.

    Parameters
    ----------
    value : float, in the unit of `OUTPUT_UNITS` for this name
    """
    shown, (shown_factor, _) = PARAMETER_DISPLAYS[name], OUTPUT_UNITS[name]
    number = fixed_number(shown.factor / shown_factor * value, shown.decimals, sign=sign)
    return with_unit(number, shown.unit)


def with_unit(number: str, unit: str) -> str:
    """A number with its unit."""
    return f"{number}{DEGREE_SIGN}" if unit == "deg" else f"{number}\u00a0{unit}"


def time_text(stamp: str) -> str:
    """Text of an ISO 8601 time, to the minute, with its time zone."""
    at = datetime.fromisoformat(stamp)
    return f"{at:%Y-%m-%d %H:%M} {at.tzname()}"
