"""Mapping of many simulations in this process or in a pool of processes."""

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import contextmanager
from multiprocessing import get_context
from typing import Any

from lispac.design.plan_search import Mapper
from lispac.errors import LispacError
from lispac.messages import error

MAX_CHUNK_SIZE = 16
"""Largest number of values that are sent to a process at once."""

CHUNKS_PER_PROCESS = 8
"""Smallest number of chunks for each process, if there are enough values, so that the processes
wait only a short time for the last one to finish."""


@contextmanager
def process_pool_mapper(workers: int, *, at_once: int = MAX_CHUNK_SIZE) -> Iterator[Mapper]:
    """Mapper over ``workers`` processes; one means this process.

    Waiting values are not computed after the context is left. Processes are spawned, not forked, on
    every system, because a process forked from a program with threads may deadlock.

    Parameters
    ----------
    at_once : int
        Largest number of values sent to a process, which finishes them even after a cancellation.

    Raises
    ------
    LispacError
        If a process of the pool was lost; raised by the mapper.
    """
    if workers <= 1:
        yield map
        return
    pool = ProcessPoolExecutor(workers, get_context("spawn"))

    def spread(function: Callable[[Any], Any], values: Iterable[Any]) -> Iterator[Any]:
        values = list(values)
        try:
            chunk = min(chunk_size(len(values), workers), at_once)
            yield from pool.map(function, values, chunksize=chunk)
        except BrokenProcessPool as failure:
            raise LispacError(error("plan_survey.process_ended")) from failure

    try:
        yield spread
    finally:
        pool.shutdown(cancel_futures=True)


def chunk_size(values: int, workers: int) -> int:
    """Number of values that are sent to a process at once."""
    return max(1, min(MAX_CHUNK_SIZE, values // (CHUNKS_PER_PROCESS * max(workers, 1))))
