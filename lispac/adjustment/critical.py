"""The test value beyond which a sighting disagrees; window and report judge by the same one."""

import scipy.stats

from lispac.adjustment.blunders import FAMILY
from lispac.adjustment.result import AdjustmentResult


def critical_w(result: AdjustmentResult) -> float | None:
    """Test value beyond which a sighting disagrees with the others; None where none is tested.

    The more sightings are tested, the larger it is: the chance that any of them exceeds it without
    a fault stays 1 %.
    """
    if not result.reliability:
        return None
    return float(scipy.stats.norm.isf(FAMILY / 2 / len(result.reliability)))
