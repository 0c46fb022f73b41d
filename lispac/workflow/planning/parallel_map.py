"""Mapping of many simulations: in this process, in a pool of processes, or on a cluster.

Searches and Monte Carlo simulations use only a mapper, so that the same code runs in all three
ways. The results are the same, because no computation depends on others in its process.
"""

import os
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool
from contextlib import AbstractContextManager, contextmanager
from multiprocessing import get_context
from typing import Any

from lispac.design.plan_search import Mapper
from lispac.errors import LispacError
from lispac.messages import error
from lispac.workflow.planning.cluster_access import ClusterAccess

MAX_CHUNK_SIZE = 16
"""Largest number of values that are sent to a process at once."""

CHUNKS_PER_PROCESS = 8
"""Smallest number of chunks for each process, if there are enough values, so that the processes
wait only a short time for the last one to finish."""


def choose_mapper(
    workers: int | None, cluster: ClusterAccess | None
) -> AbstractContextManager[Mapper]:
    """Mapper for the number of processes or the cluster that the user chose.

    Parameters
    ----------
    workers : int or None
        Processes on this machine; all cores by default.
    cluster : ClusterAccess or None
        Access to a dask scheduler whose workers are used instead.

    Raises
    ------
    LispacError
        If the cluster cannot be used; raised on entering the context.
    """
    if cluster is None:
        return process_pool_mapper(workers or os.cpu_count() or 1)
    from lispac.workflow.planning.cluster import cluster_mapper

    return cluster_mapper(cluster)


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
