"""Tests of processing columns in blocks: no point is lost, and no block is too large."""

import numpy as np
import pytest

from lispac.survey import crs
from lispac.survey.crs import run_in_blocks


@pytest.mark.parametrize("count", [0, 1, 6, 7, 8, 14, 23])
def test_blocks_are_reassembled_in_order(count: int, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(crs, "BLOCK_POINTS", 7)
    sizes: list[int] = []

    def run(x: np.ndarray, y: np.ndarray, z: np.ndarray) -> tuple[np.ndarray, ...]:
        assert all(axis.flags.c_contiguous for axis in (x, y, z))
        sizes.append(len(x))
        return x + y, 2 * y, z - 1

    # Columns of a table are not contiguous
    x, y, z = np.random.default_rng(count).normal(size=(count, 6)).T[::2]
    for found, expected in zip(run_in_blocks(run, x, y, z), (x + y, 2 * y, z - 1), strict=True):
        np.testing.assert_array_equal(found, expected)
    assert sorted(sizes, reverse=True) == [7] * (count // 7) + [count % 7] * bool(
        count % 7 or not count
    )
