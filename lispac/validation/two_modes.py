"""Test whether the distances between two lines have two modes.

The density of a distribution with one mode is, between any two places, at least the smaller of the
densities at these places. The two places are the centres of the two parts with the least sum of
squares within them (Fisher 1958). The numbers of distances in three intervals of the same width,
about both centres and about their middle, are compared: if there is one mode, the number in the
middle is at most by chance smaller than both others.
"""

import numpy as np
from numpy.typing import NDArray

from lispac.validation.absolute_check import NORMAL_QUANTILE_975
from lispac.validation.comparison_results import TwoModes
from lispac.validation.normal_distance import NormalDistances

Array = NDArray[np.float64]

MAX_PROBABILITY = 0.01
"""Probability, if there is one mode, above which the two modes are not reported at all."""


def find_two_modes(distances: NormalDistances, variation: float) -> TwoModes | None:
    """Find two modes of the distances at places measured from one of two lines.

    Parameters
    ----------
    variation : float, metres
        Standard deviation of the change of the displacement between the lines over the plane.

    Returns
    -------
    TwoModes, or None if the distances have one mode
    """
    from scipy.special import bdtr

    values = np.sort(distances.distance)
    if len(values) < 2 or values[0] == values[-1]:
        return None
    split = _best_split(values)
    low, high = float(values[:split].mean()), float(values[split:].mean())
    half = (high - low) / 6.0
    at_low, between, at_high = (
        int(np.count_nonzero(np.abs(values - centre) <= half))
        for centre in (low, (low + high) / 2.0, high)
    )
    smaller = min(at_low, at_high)
    if between >= smaller:
        return None
    probability = float(bdtr(between, between + smaller, 0.5))
    if probability > MAX_PROBABILITY:
        return None
    noise = float(np.median(distances.half_width)) / NORMAL_QUANTILE_975
    of_centres = noise**2 * (1.0 / split + 1.0 / (len(values) - split))
    return TwoModes(
        high - low,
        float(np.sqrt(variation**2 + of_centres)),
        min(split, len(values) - split) / len(values),
        probability,
    )


def _best_split(values: Array) -> int:
    """Size of the first part of sorted values that gives the least sum of squares within parts."""
    sums = np.cumsum(values - values.mean())[:-1]
    sizes = np.arange(1, len(values))
    # The sum of squares between two parts, of which one has the opposite sum of the other
    return 1 + int(np.argmax(sums**2 * (1.0 / sizes + 1.0 / (len(values) - sizes))))
