"""Local cluster whose workers may be killed by tests."""

import time
from contextlib import ExitStack

import dask
import distributed

RESTART_TIMEOUT_S = 30.0
"""Time in which a nanny process restarts a worker on busy processors."""


class Clusters:
    """Cluster of two workers, each a separate process that is restarted when it ends.

    Attributes
    ----------
    running : the current cluster
    """

    def __init__(self) -> None:
        self._open = ExitStack()
        self.running = self._started()

    def _started(self) -> distributed.LocalCluster:
        # The scheduler gives up a chunk as soon as one worker is lost.
        self._open.enter_context(dask.config.set({"distributed.scheduler.allowed-failures": 0}))
        return self._open.enter_context(
            distributed.LocalCluster(
                n_workers=2, threads_per_worker=1, processes=True, dashboard_address=":0",
                silence_logs=50,
            )
        )  # fmt: skip

    def with_workers(self) -> distributed.LocalCluster:
        """The current cluster, or a new one if an earlier test has ended its workers for good."""
        until = time.monotonic() + RESTART_TIMEOUT_S
        while len(self.running.scheduler.workers) < 2:
            if time.monotonic() > until:
                self.close()
                self.running = self._started()
                break
            time.sleep(0.05)
        return self.running

    def close(self) -> None:
        """End all processes."""
        self._open.close()
