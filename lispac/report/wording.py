"""How the report writes numbers."""

from collections.abc import Callable, Sequence
from datetime import datetime

UNKNOWN = "\u2013"


def known(value: float | None, formatted: Callable[[float], str]) -> str:
    """The value in words, or a dash where it is not known."""
    return UNKNOWN if value is None else formatted(value)


def minus(text: str) -> str:
    """The text with true minus signs."""
    # A hyphen is easily overlooked in print, and a line may break after it.
    return text.replace("-", "\u2212")


def signed(value: float, decimals: int) -> str:
    """A number that always shows its sign."""
    return minus(f"{value:+.{decimals}f}")


def angle(value: float) -> str:
    """An angle in degrees, four decimals."""
    return signed(value, 4)


def heading(value: float) -> str:
    """A heading in degrees, 0 to 360."""
    return f"{value % 360:.1f}"


def mm(metres: float) -> str:
    """Metres as millimetres, one decimal."""
    return f"{1000 * metres:,.1f}"


def triple(values: Sequence[float], decimals: int) -> str:
    """Three numbers in a row."""
    return ", ".join(minus(f"{value:.{decimals}f}") for value in values)


def origin(origin: Sequence[float] | None) -> str:
    """Latitude, longitude (degrees) and height (metres) in words."""
    if origin is None:
        return "mean of the trajectory"
    latitude, longitude, height = origin
    return minus(f"latitude {latitude:.8f} deg, longitude {longitude:.8f} deg, {height:.3f} m")


def count(number: int, what: str) -> str:
    """A number with its noun."""
    return f"{number} {what}" if number == 1 else f"{number} {what}s"


def moment(stamp: str) -> str:
    """An ISO 8601 time to the minute."""
    at = datetime.fromisoformat(stamp)
    return f"{at:%Y-%m-%d %H:%M} {at.tzname()}"
