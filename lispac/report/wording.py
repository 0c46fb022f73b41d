"""Numbers, units and names as the report writes them, in the language in use."""

import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from datetime import datetime

from lispac.adjustment.message_parts import quantity as quantity_name
from lispac.adjustment.shown import QUANTITIES, STATED
from lispac.language import N_, gettext, number
from lispac.message_texts import message_text
from lispac.messages import Message
from lispac.report.values import CheckedPart, CrossChecked

UNKNOWN = "\u2013"
MINUS = "\u2212"
HYPHEN = re.compile(r"(?<![^\s(])-(?=\d)")
"""A hyphen before a number."""

TITLES: Mapping[str, str] = {
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
"""Names of the estimated values, as they begin a row of a table."""


def known(value: float | None, formatted: Callable[[float], str], unknown: str = UNKNOWN) -> str:
    """The formatted value, or a dash where it is not known."""
    return unknown if value is None else formatted(value)


def grouped(value: float, decimals: int = 0) -> str:
    """A number with separators between groups of three digits."""
    return localised(f"{value:,.{decimals}f}")


def fixed(value: float, decimals: int, *, sign: bool = False) -> str:
    """A number without separators between groups of three digits."""
    return localised(f"{value:{'+' if sign else ''}.{decimals}f}")


def signed(value: float, decimals: int) -> str:
    """A number that always shows its sign."""
    return fixed(value, decimals, sign=True)


def shortest(value: float) -> str:
    """A number with as many decimals as it needs, six significant digits at most."""
    return localised(f"{value:g}")


def localised(text: str) -> str:
    """A number, as Python writes it, with the signs of the language in use."""
    # Not by `number`: it rounds the shortest decimals of a number, and so the last digit of a
    # number halfway between two may differ.
    whole, point, decimals = text.partition(".")
    signs = decimal_sign() if point else ""
    return f"{whole.replace(',', group_sign())}{signs}{decimals}".replace("-", MINUS)


def decimal_sign() -> str:
    """The sign before the decimals."""
    return number(0.5, 1).strip("05")


def group_sign() -> str:
    """The sign between groups of three digits."""
    return number(1000, 0).strip("01")


def mm(metres: float) -> str:
    """Metres as millimetres, one decimal."""
    return grouped(1000 * metres, 1)


def cm(metres: float) -> str:
    """Metres as centimetres, two decimals."""
    return fixed(100 * metres, 2)


def percent(ratio: float) -> str:
    """A ratio in whole percent, with its sign."""
    return f"{fixed(100 * ratio, 0)}\u00a0%"


def angle(value: float) -> str:
    """An angle in degrees, four decimals."""
    return signed(value, 4)


def heading(value: float) -> str:
    """A heading in degrees, 0 to 360."""
    return fixed(value % 360, 1)


def interval(half: str) -> str:
    """Half the width of a confidence interval."""
    return f"\u00b1 {half}"


def with_interval(value: str, half: str) -> str:
    """A value with half the width of its confidence interval."""
    return f"{value} {interval(half)}"


def triple(values: Sequence[float], decimals: int) -> str:
    """Three numbers in a row."""
    x, y, z = (fixed(value, decimals) for value in values)
    return gettext("{x}, {y}, {z}", x=x, y=y, z=z)


def in_unit(title: str, unit: str) -> str:
    """Title of a column with its unit below."""
    return f"{title}\n({unit})"


def degrees_unit() -> str:
    """The unit of angles, as it stands below the title of a column or beside an axis."""
    return gettext("deg")


def sentence(message: Message) -> str:
    """Text of a message with true minus signs, as the tables have them."""
    return with_minus(message_text(message))


def with_minus(text: str, names: Iterable[str] = ()) -> str:
    """The text of a message with true minus signs; names stay."""
    whole = "|".join(map(re.escape, sorted(names, key=len, reverse=True)))
    pattern = re.compile(f"{whole}|{HYPHEN.pattern}" if whole else HYPHEN.pattern)
    return pattern.sub(lambda found: MINUS if found.group() == "-" else found.group(), text)


def title(name: str) -> str:
    """Name of an estimated value, as it begins a row of a table."""
    return gettext(TITLES[name])


def parameter(name: str) -> str:
    """Name of an estimated value within a sentence."""
    return message_text(quantity_name(name))


def origin(origin: Sequence[float] | None) -> str:
    """Latitude and longitude in degrees, and height in metres."""
    if origin is None:
        return gettext("mean position of the trajectory")
    latitude, longitude, height = origin
    return gettext(
        "latitude {latitude} deg, longitude {longitude} deg, height {height} m",
        latitude=fixed(latitude, 8), longitude=fixed(longitude, 8), height=fixed(height, 3),
    )  # fmt: skip


def named_parts(checks: CrossChecked) -> list[tuple[str, CheckedPart]]:
    """Cross-checked parts with their names; two halves that are compared with each other once."""
    named = [(_without(part), part) for part in checks.parts if part.kind != "half"]
    halves = [part for part in checks.parts if part.kind == "half"]
    if halves and all(half.boresight_deg is not None for half in halves):
        return [*named, (gettext("First half minus second half"), halves[0])]
    names = {
        "first": gettext("First half of the lines only"),
        "second": gettext("Second half of the lines only"),
    }
    return [*named, *((names[half.part], half) for half in halves)]


def _without(part: CheckedPart) -> str:
    if part.kind == "line":
        return gettext("Without line {name}", name=part.part)
    return gettext("Without target {name}", name=part.part)


def quantity(name: str, value: float, *, sign: bool = False) -> str:
    """A value of the mounting, in metres, degrees or seconds, with the unit it is shown in."""
    shown, (stated, _) = QUANTITIES[name], STATED[name]
    number = fixed(shown.factor / stated * value, shown.decimals, sign=sign)
    # French writes the sign of degrees without a space before it.
    if shown.unit == "deg":
        return gettext("{number}\u00a0deg", number=number)
    return f"{number}\u00a0{shown.unit}"


def moment(stamp: str) -> str:
    """An ISO 8601 time to the minute."""
    at = datetime.fromisoformat(stamp)
    return f"{at:%Y-%m-%d %H:%M} {at.tzname()}"
