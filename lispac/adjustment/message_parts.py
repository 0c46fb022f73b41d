"""Parts of warnings about an adjustment: names of quantities, amounts, sightings."""

from collections.abc import Iterable

from lispac.adjustment.display_text import QUANTITIES
from lispac.adjustment.observations import Sighting
from lispac.messages import Message, note


def mounting_value_name(name: str) -> Message:
    """Name of an angle or of another value of the mounting."""
    return note(f"quantity.{name}")


def mounting_value_names(names: Iterable[str]) -> tuple[Message, ...]:
    """Names of several values of the mounting."""
    return tuple(map(mounting_value_name, names))


def amount_with_unit(name: str, value: float) -> Message:
    """A value of the mounting (metres, radians or seconds) with its unit."""
    return note(f"amount.{QUANTITIES[name].unit}", value=float(value))


def signed_change(name: str, value: float) -> Message:
    """A change of a value of the mounting with its sign and unit."""
    return note(f"change.{QUANTITIES[name].unit}", value=float(value))


def sighting_item(sighting: Sighting) -> Message:
    """A sighting as an item of a list."""
    return note("item.sighting", target=sighting.target, line=sighting.line)
