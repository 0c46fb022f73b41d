"""Threads: loops over many points in parallel chunks, and BLAS limited to one thread.

Neither changes a result, bit by bit, with the number of cores.
"""

import os
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from contextlib import AbstractContextManager
from functools import cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

MIN_PARALLEL_POINTS = 20_000  # points that are dealt with before the threads have started
CHUNKS = 16  # tasks for the threads: enough that they end together


def run_in_chunks(run: Callable[[int, int], object], ends: NDArray[np.int64]) -> None:
    """Call ``run(first, last)`` for parts of 0 to ``len(ends)`` of about the same size.

    Parameters
    ----------
    run : callable
        A compiled kernel that releases the GIL; parts must not depend on each other.
    ends : ndarray of shape (m,), int, ascending
        Points up to the end of each element; an element is dealt with by one thread, whatever
        their number, so that its sums are always made in the same order.
    """
    if not len(ends):
        return
    points = int(ends[-1])
    if points < MIN_PARALLEL_POINTS:
        run(0, len(ends))
        return
    bounds = np.linspace(0, points, CHUNKS + 1)[1:-1]
    cuts = np.unique([0, *np.searchsorted(ends, bounds), len(ends)])
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(run, cuts[:-1].tolist(), cuts[1:].tolist()))


@cache
def _thread_pool_controller() -> Any:
    from threadpoolctl import ThreadpoolController  # type: ignore[import-untyped]

    return ThreadpoolController()


def single_blas_thread() -> AbstractContextManager[Any]:
    """Context manager that limits BLAS to the calling thread.

    BLAS starts all cores for a product of a few hundred numbers; where another program uses them,
    it waits for them a hundred times longer than the product takes.
    """
    return _thread_pool_controller().limit(limits=1, user_api="blas")
