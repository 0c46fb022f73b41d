"""Threads: loops over many points in parallel chunks, and BLAS limited to one thread.

The results are identical bit by bit for any number of cores.
"""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import AbstractContextManager
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

MIN_PARALLEL_POINTS = 20_000  # with fewer points, starting threads takes longer than the work
CHUNK_COUNT = 16  # number of tasks: enough to balance the load of the threads


def run_in_chunks(run: Callable[[int, int], object], ends: NDArray[np.int64]) -> None:
    """Call ``run(first, last)`` in parallel for ranges of elements with similar numbers of points.

    Parameters
    ----------
    run : callable
        Compiled kernel that releases the GIL; the ranges must not depend on each other.
    ends : ndarray of shape (m,), int, ascending
        Number of points up to the end of each element. Each element is processed by a single
        thread, so that its sums are always computed in the same order.
    """
    if not len(ends):
        return
    points = int(ends[-1])
    if points < MIN_PARALLEL_POINTS:
        run(0, len(ends))
        return
    bounds = np.linspace(0, points, CHUNK_COUNT + 1)[1:-1]
    cuts = np.unique([0, *np.searchsorted(ends, bounds), len(ends)])
    _run_parts(run, cuts)


def run_over_points(run: Callable[[int, int], object], count: int) -> None:
    """Call ``run(first, last)`` in parallel for ranges of ``count`` points; see `run_in_chunks`."""
    if count < MIN_PARALLEL_POINTS:
        run(0, count)
        return
    cuts = np.linspace(0, count, CHUNK_COUNT + 1).astype(np.int64)
    _run_parts(run, cuts)


def _run_parts(run: Callable[[int, int], object], cuts: NDArray[np.int64]) -> None:
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(run, cuts[:-1].tolist(), cuts[1:].tolist()))


@cache
def _thread_pool_controller() -> Any:
    from threadpoolctl import ThreadpoolController  # type: ignore[import-untyped]

    return ThreadpoolController()


def single_blas_thread() -> AbstractContextManager[Any]:
    """Context manager that limits BLAS to the calling thread.

    It is needed in scripts that import NumPy before this package, which sets the limit otherwise.
    BLAS uses all cores even for a product of a few hundred numbers. If another program uses these
    cores, waiting for them takes a hundred times longer than the product.
    """
    return _thread_pool_controller().limit(limits=1, user_api="blas")
