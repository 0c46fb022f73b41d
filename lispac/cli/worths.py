"""What a plan would be without one of its parts, printed."""

import math


def without(radians: float) -> str:
    """Degrees, or that an angle would be left open."""
    return f"{math.degrees(radians):.4f}" if math.isfinite(radians) else "not determined"


def known(radians: float) -> float | None:
    """Degrees; None where an angle would be left open."""
    return math.degrees(radians) if math.isfinite(radians) else None
