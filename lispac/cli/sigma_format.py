"""Formatting of the sigma of a plan without one of its parts."""

import math


def sigma_text(radians: float) -> str:
    """Sigma in degrees, or "not determined", from ``radians``."""
    return f"{math.degrees(radians):.4f}" if math.isfinite(radians) else "not determined"


def sigma_degrees(radians: float) -> float | None:
    """Sigma in degrees from ``radians``; None if an angle is not determined."""
    return math.degrees(radians) if math.isfinite(radians) else None
