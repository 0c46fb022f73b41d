"""Process columns in blocks on all cores."""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Columns = tuple[Array, Array, Array]

BLOCK = 1 << 17
"""Points per call, for example of PROJ, which releases Python's lock."""


def run_in_blocks(run: Callable[[Array, Array, Array], Columns], *axes: Array) -> Columns:
    """Run over blocks of three columns; returns three columns."""
    count = len(axes[0])
    if count <= BLOCK:
        return run(*(np.ascontiguousarray(axis) for axis in axes))
    result = tuple(np.empty(count) for _ in range(3))

    def one(start: int) -> None:
        rows = slice(start, start + BLOCK)
        for whole, some in zip(
            result, run(*(np.ascontiguousarray(axis[rows]) for axis in axes)), strict=True
        ):
            whole[rows] = some

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for _ in pool.map(one, range(0, count, BLOCK)):
            pass
    return result[0], result[1], result[2]
