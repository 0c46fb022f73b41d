"""Findings of the statistical tests, shared by window, report and command line.

Distributions are imported from scipy.special where they are used: the import takes 0.2 s, that of
scipy.stats 1 s.
"""

from typing import Literal

import numpy as np

from lispac.adjustment.result import AdjustmentResult, SightingReliability, VarianceComponent
from lispac.adjustment.solve.blunders import FAMILY_WISE_LEVEL
from lispac.messages import Message, note

MAX_DETECTABLE_BIAS = 1.0
"""Minimal detectable bias at and above which a sighting counts as not checked, metres."""

MAX_INTERVAL_RATIO = 10.0
"""Largest ratio of the bounds of the confidence interval of a determined variance component."""

SightingStatus = Literal["rejected", "not checked", "disagrees", "agrees"]


def critical_test_value(result: AdjustmentResult) -> float | None:
    """Critical value for the tests of sightings; None if no sighting is tested.

    It increases with the number of sightings, so that the probability of at least one false alarm
    is at most 1 % (Bonferroni's inequality).
    """
    from scipy.special import ndtri

    if not result.reliability:
        return None
    return float(-ndtri(FAMILY_WISE_LEVEL / 2 / len(result.reliability)))


def exceedance_limit(points: int, chance: float) -> int:
    """Number of exceedances that is itself exceeded with a probability of at most ``chance``.

    Each of ``points`` test values exceeds its critical value with the same probability ``chance``.
    """
    from scipy.special import bdtrc

    mean = points * chance
    counts = np.arange(int(mean + 10.0 * np.sqrt(mean)) + 20)
    return int(np.argmax(bdtrc(np.minimum(counts, points), points, chance) <= chance))


def sighting_status(item: SightingReliability, critical: float) -> SightingStatus:
    """Status of a sighting; ``critical`` is the critical test value."""
    if item.rejected:
        return "rejected"
    if not item.detectable < MAX_DETECTABLE_BIAS:
        return "not checked"
    return "disagrees" if abs(item.w) > critical else "agrees"


def variance_component_finding(component: VarianceComponent, *, is_assumed: bool) -> Message:
    """Message whether a variance component changed the standard deviations, and why.

    Parameters
    ----------
    is_assumed : bool
        Whether the standard deviations were assumed, because nobody gave them.
    """
    if is_assumed:
        if component.applied:
            return note("component.replaces_assumed")
        determined = component.is_determined
        return note("component.confirms_assumed" if determined else "component.not_determined")
    if component.applied:
        return note("component.larger" if component.factor > 1 else "component.smaller")
    if component.upper > MAX_INTERVAL_RATIO * component.lower:
        return note("component.not_determined")
    if component.lower <= 1 <= component.upper:
        return note("component.as_given")
    return note("component.too_small")
