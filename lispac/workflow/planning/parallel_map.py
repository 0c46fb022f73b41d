"""Mapping of many simulations: in this process, in a pool of processes, or on a cluster.

Searches and Monte Carlo simulations use only a mapper, so that the same code runs in all three
ways. The results are the same, because no computation depends on others in its process.
"""

import os
from contextlib import AbstractContextManager

from lispac.design.plan_search import Mapper
from lispac.workflow.planning.cluster import cluster_mapper
from lispac.workflow.planning.cluster_access import ClusterAccess
from lispac.workflow.planning.process_pool import process_pool_mapper


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
    return cluster_mapper(cluster)
