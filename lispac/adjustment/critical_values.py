"""Critical value of the test of sightings, shared by window and report.

Distributions come from scipy.special, where they are used: it takes a fifth of a second to import,
and scipy.stats a whole one.
"""

import numpy as np

from lispac.adjustment.blunders import FAMILY_WISE_LEVEL
from lispac.adjustment.result import AdjustmentResult


def critical_test_value(result: AdjustmentResult) -> float | None:
    """Critical test value of the sightings; None where no sighting is tested.

    The more sightings are tested, the larger it is: the chance that any of them exceeds it without
    a fault stays at most 1 % (Bonferroni's inequality).
    """
    from scipy.special import ndtri

    if not result.reliability:
        return None
    return float(-ndtri(FAMILY_WISE_LEVEL / 2 / len(result.reliability)))


def exceedance_limit(points: int, chance: float) -> int:
    """Number of exceedances that is itself exceeded only with probability ``chance``.

    More do so only with that chance again.
    """
    from scipy.special import bdtrc

    mean = points * chance
    counts = np.arange(int(mean + 10.0 * np.sqrt(mean)) + 20)
    return int(np.argmax(bdtrc(np.minimum(counts, points), points, chance) <= chance))
