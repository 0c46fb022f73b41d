"""Which points of large lines are drawn: a share of a budget for each, evenly thinned.

A line is drawn in two nested parts: a coarse one that stays while the camera moves, and the detail
that joins it when the camera rests.
"""

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Budget:
    """How many points are drawn in all.

    Software OpenGL draws about 2.5 million points a second; the rest is a hundred times faster.
    """

    resting: int = 2_000_000
    moving: int = 250_000


def shares(counts: Mapping[str, int], budget: int) -> dict[str, int]:
    """Part of the budget each line gets: in proportion to its points, at least one.

    A line with points always shows; where all fit, all are drawn.
    """
    total = sum(counts.values())
    if total <= budget:
        return dict(counts)
    return {name: min(n, max(1, n * budget // total)) for name, n in counts.items()}


def sample_order(count: int, wanted: int) -> NDArray[np.int64]:
    """Indices of ``wanted`` out of ``count`` points in an order whose every prefix is a fair sample.

    The same for the same numbers, so that before and after show the same points. At random rather
    than every n-th: a stride beats against the profiles of the scanner and draws stripes.
    """
    order = np.random.default_rng(count).permutation(count)
    return order[:wanted].astype(np.int64, copy=False)


def robust_sample(points: NDArray[np.float64], percent: float = 0.05) -> NDArray[np.float64]:
    """Points without the outermost ``percent`` on each side of each axis; stray echoes are there.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres

    Returns
    -------
    ndarray of shape (m, 3)
        All of them where fewer than 100 would make a percentile meaningless.
    """
    if len(points) < 100:
        return points
    low, high = np.percentile(points, [percent, 100.0 - percent], axis=0)
    inside = np.all((points >= low) & (points <= high), axis=1)
    return points[inside] if inside.any() else points
