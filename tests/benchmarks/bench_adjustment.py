"""Seconds of an adjustment against the number of points, in both stochastic models."""

import resource
from statistics import median
from time import perf_counter

import numpy as np
import pytest

from lispac.adjustment.solver import adjust
from lispac.adjustment.stochastic import POS_ERRORS, StochasticModel
from lispac.survey.georeferencing import Mounting
from tests.surveys import disturbed, planar_survey

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.208, -1.245, 0.149]))
START = Mounting(TRUTH.lever_arm, np.zeros(3))


@pytest.mark.parametrize("points", [2_600, 10_000, 100_000, 1_000_000])
def test_adjustment(points):
    """Two boards on six lines; the thesis's program took 532 s for 1,297 points a board."""
    exact = planar_survey(TRUTH, points=points // 12)
    observations = disturbed(exact, correlated=True, seed=1)
    for pos_errors in POS_ERRORS:
        model, seconds = StochasticModel(pos_errors), []
        adjust(observations, START, model)
        for _ in range(5):
            start = perf_counter()
            result = adjust(observations, START, model)
            seconds.append(perf_counter() - start)
        print(
            f"\n{len(observations):9,} points, {pos_errors:11s}: {median(seconds) * 1e3:8.1f} ms, "
            f"{result.iterations} iterations",
            end="",
        )
    peak = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e6
    print(f"; peak memory of the process so far {peak:.2f} GB")
