"""Tests of the bins of distance histograms: round edges, shared by both states, merged."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from lispac.validation.distance_bins import (
    MAX_BINS,
    MIN_BINS,
    histogram_counts,
    merge_bins,
    shared_bin_edges,
)

SCALES = st.floats(1e-5, 10.0)


@given(SCALES, SCALES, st.integers(0, 2**32 - 1))
def test_bins_have_round_edges_and_cover_both_states(
    before: float, after: float, seed: int
) -> None:
    rng = np.random.default_rng(seed)
    distances = [scale * np.abs(rng.normal(size=500)) for scale in (before, after)]
    edges = shared_bin_edges(*distances)
    tops = [np.percentile(each, 99.5) for each in distances]
    assert edges[0] == 0.0
    assert max(tops) <= edges[-1] * (1 + 1e-6)
    assert len(edges) - 1 <= MAX_BINS
    width = edges[1]
    mantissa = width / 10.0 ** np.floor(np.log10(width) + 1e-9)
    assert min(abs(mantissa - digit) for digit in (1, 2, 5, 10)) < 1e-6
    finest = width <= min(tops) / MIN_BINS * (1 + 1e-6)
    # as fine as the largest number of bins allows
    assert finest or len(edges) - 1 > MAX_BINS / 2.5 - 1
    for each in distances:
        assert histogram_counts(each, edges).sum() == len(each)


@given(
    st.lists(st.integers(0, 1000), min_size=1, max_size=300),
    st.floats(0.001, 3.0),
    st.integers(1, 80),
)
def test_merged_bins_contain_the_same_points(counts: list[int], share: float, most: int) -> None:
    fine = 0.002 * np.arange(len(counts) + 1)
    shown = share * fine[-1]
    edges, grouped = merge_bins(fine, counts, shown, most)
    assert grouped.sum() == sum(counts)
    assert shown / edges[1] <= most * (1 + 1e-6) or edges[1] == pytest.approx(0.002)
    assert edges[-1] >= fine[-1] * (1 - 1e-9)
    for low, high, number in zip(edges[:-1], edges[1:], grouped, strict=True):
        inside = (fine[:-1] >= low - 1e-6) & (fine[:-1] < high - 1e-6)
        assert number == np.asarray(counts)[inside].sum()


def test_zero_distances_have_a_histogram() -> None:
    edges = shared_bin_edges(np.zeros(10), np.zeros(10))
    assert histogram_counts(np.zeros(10), edges)[0] == 10
