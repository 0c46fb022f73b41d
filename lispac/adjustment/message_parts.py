"""Parts of warnings about an adjustment: names of quantities, amounts, sightings."""

from collections.abc import Iterable

from lispac.adjustment.observations import Sighting
from lispac.adjustment.shown import QUANTITIES
from lispac.messages import Message, note


def quantity(name: str) -> Message:
    """Name of an angle or of another value of the mounting."""
    return note(f"quantity.{name}")


def quantities(names: Iterable[str]) -> tuple[Message, ...]:
    """Names of several of them."""
    return tuple(map(quantity, names))


def amount(name: str, value: float) -> Message:
    """A value of the mounting (metres, radians or seconds) with its unit."""
    return note(f"amount.{QUANTITIES[name].unit}", value=float(value))


def change(name: str, value: float) -> Message:
    """A change of a value of the mounting with its sign and unit."""
    return note(f"change.{QUANTITIES[name].unit}", value=float(value))


def at(sighting: Sighting) -> Message:
    """A sighting in a list."""
    return note("item.sighting", target=sighting.target, line=sighting.line)
