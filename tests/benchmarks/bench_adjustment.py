"""Time and memory of an adjustment by number of points, with both stochastic models.

The processor time hardly depends on other programs. The points of a sighting are in order of time,
as in a file. Peak memory is that of the process during the adjustments, with the observations.
"""

from pathlib import Path
from statistics import median
from time import perf_counter, process_time

import numpy as np
import pytest
import scipy.linalg

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model.stochastic_model import StochasticModel
from lispac.adjustment.solve.banded_cholesky import (
    back_substitution,
    cholesky_factor,
    forward_substitution,
)
from lispac.survey.georeferencing import Mounting
from tests.support.surveys import disturbed, planar_survey

TRUTH = Mounting(np.array([-0.2, 0.04, 2.4]), np.radians([0.208, -1.245, 0.149]))
START = Mounting(TRUTH.lever_arm, np.zeros(3))
MODELS = (
    StochasticModel("independent"),
    StochasticModel("correlated"),
    StochasticModel("correlated", loss="tukey"),
)
THESIS_SECONDS = (145.0, 532.0)
"""Times of the thesis program for 820 and 1,671 points (table 4.3), s."""


@pytest.mark.parametrize("points", [2_600, 10_000, 100_000, 1_000_000, 10_000_000])
def test_adjustment(points):
    """Two boards on six lines: twelve sightings."""
    exact = planar_survey(TRUTH, points=points // 12)
    observations = disturbed(exact, correlated=True, seed=1)
    del exact
    observations = observations.reordered(np.lexsort((observations.time, observations.sighting)))
    before = peak_memory_gb(reset=True)
    adjust(observations.reordered(np.arange(0, len(observations), 11)), START, MODELS[-1])
    for model in MODELS:
        seconds, processor = [], []
        for _ in range(1 if points > 1_000_000 else 5):
            start, start_processor = perf_counter(), process_time()
            result = adjust(observations, START, model, diagnostics=False)
            seconds.append(perf_counter() - start)
            processor.append(process_time() - start_processor)
        time = median(seconds)
        print(
            f"\n{len(observations):10,} points, {model.pos_errors:11s} {model.loss:5s}: "
            f"{time * 1e3:9.1f} ms, of processor time {median(processor) * 1e3:9.1f} ms, "
            f"{result.iterations:2d} iterations",
            end="",
        )
        if points == 2_600:
            low, high = THESIS_SECONDS
            print(
                f", {low / time:,.0f} to {high / time:,.0f} x the thesis",
                end="",
            )
    print(f"; peak memory {peak_memory_gb():.2f} GB, {before:.2f} GB while the points were made")


def peak_memory_gb(*, reset: bool = False) -> float:
    """Largest resident memory of this process so far, or since the last reset, GB (Linux)."""
    status = Path("/proc/self/status").read_text()
    if reset:
        Path("/proc/self/clear_refs").write_text("5")
    return int(status.split("VmHWM:")[1].split()[0]) / 1e6


@pytest.mark.parametrize(("knots", "unknowns"), [(60, 20), (500, 30), (500, 200)])
def test_banded(knots, unknowns):
    """Compare the elimination of the POS errors with LAPACK's solution of the same matrix."""
    random = np.random.default_rng(1)
    band = random.normal(size=(12, 6 * knots))
    band[0] = 30.0
    right = random.normal(size=(unknowns, 6 * knots))
    factor = cholesky_factor(band)

    def seconds(solve):
        durations = []
        for _ in range(7):
            start = perf_counter()
            found = solve()
            durations.append(perf_counter() - start)
        return median(durations), found

    solve = scipy.linalg.cho_solve_banded
    theirs, expected = seconds(lambda: solve((factor, True), right.T))
    half, halved = seconds(lambda: forward_substitution(factor, right.T))
    whole, found = seconds(lambda: back_substitution(factor, halved))
    assert found == pytest.approx(expected)
    print(
        f"\n{knots:4d} knots, {unknowns:3d} unknowns: LAPACK {theirs * 1e3:6.2f} ms, forward "
        f"{half * 1e3:6.2f} ms (1/{theirs / half:.0f}), both {(half + whole) * 1e3:6.2f} ms "
        f"(1/{theirs / (half + whole):.0f})",
        end="",
    )
