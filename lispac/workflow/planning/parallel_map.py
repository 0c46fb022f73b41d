"""Mapping of many simulations: in this process, in a pool of processes, or on a cluster.

Searches and Monte Carlo ask for a mapper alone, so the same code runs in all three places, and
gives the same numbers: no calculation knows which others it shares a process with.
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

MAX_CHUNK = 16
"""Most values that a process is sent at once."""

CHUNKS_PER_PROCESS = 8
"""Chunks that each process gets at least, where there are enough values: the last one to finish
keeps the others waiting for a fraction of the whole only."""


def choose_mapper(
    workers: int | None, cluster: ClusterAccess | None
) -> AbstractContextManager[Mapper]:
    """Mapper for the number of processes or the cluster that the user chose.

    Parameters
    ----------
    workers : int or None
        Processes on this machine; all cores by default.
    cluster : ClusterAccess or None
        Of a dask scheduler whose workers are to be used instead.

    Raises
    ------
    LispacError
        On entering: the cluster cannot be used.
    """
    if cluster is None:
        return process_pool_mapper(workers or os.cpu_count() or 1)
    from lispac.workflow.planning.cluster import cluster_mapper

    return cluster_mapper(cluster)


@contextmanager
def process_pool_mapper(workers: int, *, at_once: int = MAX_CHUNK) -> Iterator[Mapper]:
    """Mapper over ``workers`` processes; one means this process.

    What is not done when the context is left is never begun. The processes are started afresh on
    every system: one that is forked from a program with threads may wait for a lock for ever.

    Parameters
    ----------
    at_once : int
        Most values that a process is sent: what is begun is finished, also when it is cancelled.

    Raises
    ------
    LispacError
        From the mapper: a process of the pool was lost.
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
    """Number of values that a process is sent at once."""
    return max(1, min(MAX_CHUNK, values // (CHUNKS_PER_PROCESS * max(workers, 1))))
