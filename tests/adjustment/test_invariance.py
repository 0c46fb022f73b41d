"""Tests that order and threads do not change the result, and of the chi-square test."""

from dataclasses import replace

import numpy as np
import pytest
import scipy.stats

from lispac.adjustment.least_squares import adjust
from lispac.adjustment.model import threads as kernel_threads
from lispac.adjustment.model.observations import Observations
from lispac.adjustment.model.point_averaging import average_points_in_cells
from lispac.adjustment.model.stochastic_model import StochasticModel
from tests.adjustment.test_robustness import PRIOR, shifted, survey, with_outliers
from tests.support.long_runs import LONG, others_long

MODEL = StochasticModel(loss="tukey")
MAX_DIFFERENCE_SIGMAS = np.radians(1e-9)


def mixed(observations: Observations, seed: int) -> Observations:
    """Return the same observations with points, sightings and targets in another order."""
    generator = np.random.default_rng(seed)
    points = observations.reordered(generator.permutation(len(observations)))
    order = generator.permutation(len(observations.sightings))
    return replace(
        points,
        sighting=np.argsort(order)[points.sighting],
        sightings=tuple(observations.sightings[k] for k in order),
    )


@pytest.mark.parametrize("spacing", others_long([0.0, 0.1]))
@pytest.mark.parametrize("order", others_long([1, 2]))
def test_order_does_not_change_the_result(spacing, order) -> None:
    """The observations contain outliers and a blunder; with a spacing they are averaged."""
    observations = shifted(with_outliers(survey(3, 0.06 if spacing else 0.1), 1)[0], 4, 0.05)
    results = []
    for seed in (None, order):
        points = observations if seed is None else mixed(observations, seed)
        if spacing:
            points = average_points_in_cells(points, PRIOR, spacing, no_outliers=True)
        results.append(adjust(points, PRIOR, MODEL, diagnostics=True))
    first, other = results
    assert set(other.rejected_sightings) == set(first.rejected_sightings) != set()
    assert np.abs(other.boresight - first.boresight).max() < MAX_DIFFERENCE_SIGMAS
    assert np.abs(other.sigma - first.sigma).max() < MAX_DIFFERENCE_SIGMAS


@LONG
def test_the_number_of_threads_does_not_change_the_result(monkeypatch) -> None:
    points = survey(5, 0.025)
    assert len(points) > kernel_threads.MIN_PARALLEL_POINTS
    results = []
    for threads in (1, 2, 7):
        monkeypatch.setattr(kernel_threads.os, "cpu_count", lambda threads=threads: threads)
        results.append(adjust(points, PRIOR, MODEL, diagnostics=False).boresight)
    monkeypatch.setattr(kernel_threads, "MIN_PARALLEL_POINTS", 10**9)  # no parallel computation
    results.append(adjust(points, PRIOR, MODEL, diagnostics=False).boresight)
    for other in results[1:]:
        assert np.abs(other - results[0]).max() < MAX_DIFFERENCE_SIGMAS


@LONG
@pytest.mark.parametrize("sighting", others_long([1, 5, 9]))
def test_outliers_and_a_shifted_sighting_are_rejected(sighting) -> None:
    """The result agrees with that of a clean survey without the shifted sighting."""
    clean = survey(0, 0.1)
    dirty = with_outliers(shifted(clean, sighting, 0.05), 0)[0]
    result = adjust(dirty, PRIOR, MODEL)
    without = clean.of_sightings(np.arange(len(clean.sightings)) != sighting)
    best = adjust(without, PRIOR, MODEL, diagnostics=False)
    assert result.rejected_sightings == (clean.sightings[sighting],)
    assert (np.abs(result.boresight - best.boresight) < best.sigma).all()


@pytest.mark.parametrize(
    ("factor", "passes_mostly"), others_long([(1.0, True), (0.8, False), (1.25, False)], 2)
)
def test_the_chi_square_test_accepts_correct_sigmas(factor, passes_mostly) -> None:
    """The 95 % test of the correlated model passes at correct LiDAR sigmas only."""
    count = 30 if passes_mostly else 10
    passed = sum(
        adjust(
            survey(300 + seed).with_scaled_sigmas(factor, 1.0, 1.0), PRIOR, StochasticModel(),
            diagnostics=False,
        ).chi_square.passed
        for seed in range(count)
    )  # fmt: skip
    if passes_mostly:
        assert passed >= scipy.stats.binom.ppf(0.0005, count, 0.95)
    else:
        assert passed == 0
