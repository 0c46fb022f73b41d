"""Tests of the coverage of the sigmas: a short study always, the long one with ``-m long``."""

import numpy as np
import pytest
import scipy.stats

from lispac.adjustment.diagnostics.crosscheck import cross_checks
from lispac.adjustment.diagnostics.warnings import result_warnings
from lispac.adjustment.least_squares import adjust
from tests.studies.coverage_of_errors import (
    KINDS,
    MODEL,
    PRIOR,
    TRUTH,
    displaced_target,
    hits,
    row,
    survey,
)
from tests.studies.coverage_of_errors import study as study_of_errors
from tests.studies.coverage_study import (
    CORRELATION_TIMES,
    DISTANCES,
    SUBSAMPLED_SURVEYS,
    sigma_ratios,
    study,
    table_text,
)
from tests.support.long_runs import LONG, others_long


@pytest.mark.parametrize("count", others_long([12, 24]))
def test_most_intervals_contain_the_truth(count: int) -> None:
    """Bounds of the binomial and chi-square distributions at one in a thousand."""
    times = (300.0, 600.0)
    results = study(times, (0.10,), count, workers=1)
    correlated, independent = results["correlated", 0.10], results["independent", 0.10]
    table = table_text(times, results)
    fewest = scipy.stats.binom.ppf(0.0005, count, 0.95) / count
    lower, upper = np.sqrt(scipy.stats.chi2.ppf([0.0005, 0.9995], count) / count)
    assert (correlated.hits >= fewest).all(), table
    assert ((correlated.spread > lower) & (correlated.spread < upper)).all(), table
    assert (independent.hits < 0.5).all(), table
    assert (correlated.rmse < 1.1 * independent.rmse).all(), table
    assert correlated.rmse[1] < independent.rmse[1] / 2, table


@pytest.mark.long
@pytest.mark.timeout(7200)
@pytest.mark.parametrize("times", CORRELATION_TIMES)
def test_coverage_of_a_thousand_surveys(times: tuple[float, float]) -> None:
    results = study(times, (0.10,), 1000)
    table = table_text(times, results)
    print(table)
    correlated, independent = results["correlated", 0.10], results["independent", 0.10]
    assert ((correlated.hits > 0.93) & (correlated.hits < 0.97)).all(), table
    assert ((correlated.spread > 0.9) & (correlated.spread < 1.1)).all(), table
    assert (correlated.rmse < 1.02 * independent.rmse).all(), table


@pytest.mark.long
@pytest.mark.timeout(7200)
@pytest.mark.parametrize("times", CORRELATION_TIMES)
def test_sigmas_do_not_depend_on_subsampling(times: tuple[float, float]) -> None:
    """Twenty surveys, each compared with itself, with a margin of three standard errors."""
    results = study(times, DISTANCES, SUBSAMPLED_SURVEYS)
    ratio, error = sigma_ratios(results)
    table = f"{table_text(times, results)}\nby the first\n{ratio}\n+- {error.max():.4f}"
    print(table)
    most = (ratio + 3 * error).max(axis=0) / (ratio - 3 * error).min(axis=0)
    assert (most < 1.10).all(), table


@LONG
@pytest.mark.parametrize("kind", ["none", pytest.param("POS time / 10", marks=pytest.mark.long)])
def test_the_sigmas_are_realistic_with_other_correlation_times(kind: str) -> None:
    """Three surveys; an angle misses two of the intervals with a probability of 1/46."""
    results = study_of_errors(kind, 3, workers=1)
    table_row = row(kind, results)
    assert (3 * hits(results) > 1.5).all(), table_row
    assert not any(each.serious for each in results), table_row
    shortened = [each.shortened for each in results]
    assert all(shortened) if kind == "POS time / 10" else not any(shortened)


@LONG
@pytest.mark.parametrize(
    ("kind", "is_raised"), others_long([("turned line", True), ("none", False)])
)
def test_sigmas_are_raised_by_the_scatter_without_single_lines(kind: str, is_raised: bool) -> None:
    """The jackknife is computed again from adjustments without each line."""
    data = survey(kind, 0)
    result = adjust(data, PRIOR, MODEL)
    formal = result.with_formal_sigmas.sigma
    parts = [p for p in cross_checks(data, PRIOR, result).parts if p.kind == "line"]
    differences = np.array([part.difference for part in parts])
    predicted = np.maximum([part.sigma**2 - formal**2 for part in parts], 0.0)
    share = (len(parts) - 1) / len(parts)
    excess = share * np.maximum((differences**2 - predicted).sum(axis=0), 0.0)
    factors = result.sigma / formal
    expected = np.sqrt(1 + excess / formal**2)
    assert np.abs(factors - np.where(factors > 1, expected, 1.0)).max() < 0.06
    assert (factors.max() > 1.1) == is_raised
    codes = [message.code for message in result_warnings(result, None)]
    assert ("adjustment.sigmas_raised" in codes) == is_raised
    assert (np.abs(result.boresight - TRUTH.boresight) < 2 * result.sigma).all()
    plain = adjust(data, PRIOR, MODEL, test_model=False)
    np.testing.assert_allclose(plain.sigma, formal, rtol=1e-9)


@pytest.mark.parametrize(
    ("target", "size", "seed", "raised"),
    [
        # The sum of the squared differences without single targets is too large.
        ("T2", 0.02, 1, [True, False, False]),
        pytest.param("T5", 0.01, 2, [False, False, True], marks=LONG),
        # A single difference, without one line, is too large.
        ("T1", 0.02, 2, [False, False, True]),
        ("T1", 0.0, 1, [False, False, False]),
    ],
)  # fmt: skip
def test_sigmas_are_raised_by_the_scatter_without_single_targets_or_one_line(
    target: str, size: float, seed: int, raised: list[bool]
) -> None:
    data = displaced_target(survey("none", seed), target, size)
    result = adjust(data, PRIOR, MODEL)
    factors = result.angle_sigma_factors
    assert ((np.ones(3) if factors is None else factors) > 1.15).tolist() == raised
    assert (np.abs(result.boresight - TRUTH.boresight) < 2 * result.sigma).all()


@pytest.mark.long
@pytest.mark.timeout(7200)
@pytest.mark.parametrize("kind", KINDS)
def test_intervals_of_surveys_without_a_serious_warning_contain_the_truth(kind: str) -> None:
    results = study_of_errors(kind, 200)
    print(row(kind, results))
    without_warning = [each for each in results if not each.serious]
    assert (
        hits(without_warning) >= 0.93 - 2 * np.sqrt(0.95 * 0.05 / max(1, len(without_warning)))
    ).all()
