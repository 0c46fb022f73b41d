"""Tests of processing many points in chunks."""

import numpy as np
import pytest

from lispac.adjustment.model.threads import CHUNK_COUNT, MIN_PARALLEL_POINTS, run_in_chunks


@pytest.mark.parametrize(
    "counts",
    [
        [],
        [0],
        [5],
        [MIN_PARALLEL_POINTS + 1],
        [3, 0, 4],
        [10] * 5000,
        [1, 30 * MIN_PARALLEL_POINTS, 1],
        [0, 0, 2 * MIN_PARALLEL_POINTS],
    ],
    ids=lambda counts: f"{len(counts)} of {sum(counts)}",
)
def test_each_element_is_processed_once_in_one_chunk(counts: list[int]) -> None:
    ranges: list[tuple[int, int]] = []
    run_in_chunks(
        lambda first, last: ranges.append((first, last)), np.cumsum(counts, dtype=np.int64)
    )
    assert len(ranges) <= CHUNK_COUNT
    elements = [k for first, last in sorted(ranges) for k in range(first, last)]
    assert elements == list(range(len(counts)))
    assert (len(ranges) > 1) == (sum(counts) >= MIN_PARALLEL_POINTS and len(counts) > 1)
