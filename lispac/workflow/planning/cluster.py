"""Computation of many simulations on a cluster: the workers of a dask scheduler.

The scheduler distributes chunks to workers and gives the chunks of a lost worker to others.
Received results are kept here, so that only unfinished chunks are computed again. The scheduler
gives up a chunk that has lost its worker several times. Such a chunk is sent again a few times,
because office computers may be switched off while they compute.
"""

import asyncio
import concurrent.futures
import logging
import threading
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager, suppress
from functools import partial
from queue import Empty, SimpleQueue
from time import monotonic
from typing import Any

from lispac.design.plan_search import Mapper
from lispac.errors import LispacError
from lispac.messages import error
from lispac.version import __version__
from lispac.workflow.planning.cluster_access import ClusterAccess
from lispac.workflow.planning.process_pool import chunk_size

CONNECT_TIMEOUT = 4.0
"""Longest time for a reply of the scheduler, seconds."""

START_TIMEOUT = 15.0
"""Longest time for a worker to appear, seconds; dask's nanny process restarts a lost worker."""

POLL_INTERVAL = 2.0
"""Seconds without a result after which the number of workers is checked."""

WORKER_TIMEOUT = 60.0
"""Longest time without any worker, seconds, after which the computation ends with an error."""

MAX_SENDS_PER_CHUNK = 3
"""Largest number of times that a chunk is sent to the scheduler. Each time, the scheduler tolerates
several lost workers before it gives the chunk up."""


@contextmanager
def cluster_mapper(access: ClusterAccess | str) -> Iterator[Mapper]:
    """Mapper over the workers of a dask scheduler.

    Unfinished chunks are cancelled when the context is left.

    Parameters
    ----------
    access : ClusterAccess or str
        A str is the address, without certificates given by the user.

    Raises
    ------
    LispacError
        If dask.distributed is not installed, there is no scheduler at the address, it has no
        workers, or they have another version of LISPAC. Raised by the mapper: if no worker is left,
        or a chunk has lost its worker too often.
    """
    access = ClusterAccess(access) if isinstance(access, str) else access
    address = access.url
    try:
        import distributed
    except ImportError as failure:
        raise LispacError(error("cluster.not_installed")) from failure
    security = access.security()
    with _suppressed_logs():
        _require_scheduler(address, security)
        client = distributed.Client(
            address, timeout=CONNECT_TIMEOUT, set_as_default=False, security=security
        )
        cluster = _Cluster(client, address)
        try:
            cluster.check()
            yield cluster.map
        finally:
            cluster.close()


@contextmanager
def _suppressed_logs() -> Iterator[None]:
    """Suppress the log of the client, since the program reports its errors itself."""
    logs = [logging.getLogger(name) for name in ("distributed", "distributed.client")]
    levels = [log.level for log in logs]
    for log in logs:
        log.setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        for log, level in zip(logs, levels, strict=True):
            log.setLevel(level)


def _require_scheduler(address: str, security: Any) -> None:
    """Refuse an address without a scheduler, for which the client would wait without end.

    Raises
    ------
    LispacError
        If no scheduler replies at the address within `CONNECT_TIMEOUT`.
    """
    from distributed.comm import connect

    async def try_connection() -> None:
        options = security.get_connection_args("client") | {"timeout": CONNECT_TIMEOUT}
        comm = await asyncio.wait_for(connect(address, **options), CONNECT_TIMEOUT)
        comm.abort()

    try:
        asyncio.run(try_connection())
    except Exception as failure:  # another program's reply may cause any error
        raise LispacError(
            error("cluster.no_scheduler", address=address, limit=CONNECT_TIMEOUT)
        ) from failure


class _Cluster:
    """Connection to the scheduler, with the chunks in progress."""

    def __init__(self, client: Any, address: str) -> None:
        self.client, self.address = client, address
        self.in_progress: set[_ChunkInProgress] = set()

    def check(self) -> None:
        """Refuse a cluster without workers, or with a scheduler or workers of another version.

        Raises
        ------
        LispacError
            If there is no worker, or one of them or the scheduler has another version.
        """
        try:  # a lost worker may be restarting
            self.client.wait_for_workers(1, timeout=START_TIMEOUT)
        except TimeoutError:
            raise LispacError(error("cluster.no_workers", address=self.address)) from None
        try:  # the scheduler unpickles the chunks before it sends them to workers
            found = self.client.run_on_scheduler(_program_version)
        except Exception as failure:
            found = failure
        if isinstance(found, str):
            _require_version("cluster.scheduler_version", found, address=self.address)
        else:
            raise LispacError(
                error(
                    "cluster.scheduler_without_version", address=self.address, reason=str(found),
                    expected=__version__,
                )
            )  # fmt: skip
        for worker, found in self.client.run(_program_version, on_error="return").items():
            if isinstance(found, str):
                _require_version("cluster.worker_version", found, address=worker)
            else:
                raise LispacError(
                    error(
                        "cluster.worker_without_version", address=worker, reason=str(found),
                        expected=__version__,
                    )
                )  # fmt: skip

    def map(self, function: Callable[[Any], Any], values: Iterable[Any]) -> Iterator[Any]:
        """Yield the results in the order of the values, as soon as they are available."""
        values = list(values)
        size = chunk_size(len(values), self._count_threads())
        chunks = [values[k : k + size] for k in range(0, len(values), size)]
        task = partial(_map_on_worker, function, __version__)
        completed: SimpleQueue[_ChunkInProgress] = SimpleQueue()
        for k, chunk in enumerate(chunks):
            self._send_chunk(_ChunkInProgress(k, task, chunk, completed))
        results: dict[int, list[Any]] = {}
        for k in range(len(chunks)):
            while k not in results:
                sent = self._wait_for_result(completed)
                result = self._receive_result(sent)
                if result is None:
                    self._send_chunk(sent)
                else:
                    results[sent.number] = result
            yield from results.pop(k)

    def _send_chunk(self, sent: "_ChunkInProgress") -> None:
        sent.times += 1
        with self._report_lost_connection():
            sent.future = self.client.submit(sent.task, sent.chunk, pure=False)
        self.in_progress.add(sent)
        sent.future.add_done_callback(sent.on_done)

    def _wait_for_result(self, completed: "SimpleQueue[_ChunkInProgress]") -> "_ChunkInProgress":
        """Wait for the next completed chunk while the connection holds.

        Raises
        ------
        LispacError
            If no worker is left.
        """
        without_workers_since = None
        while True:
            try:
                return completed.get(timeout=POLL_INTERVAL)
            except Empty:
                pass
            if self._count_threads():
                without_workers_since = None
            else:
                without_workers_since = without_workers_since or monotonic()
                if monotonic() - without_workers_since > WORKER_TIMEOUT:
                    raise self._connection_error()

    def _receive_result(self, sent: "_ChunkInProgress") -> list[Any] | None:
        """Results of a completed chunk; None if the scheduler gave it up and it is sent again.

        Raises
        ------
        LispacError
            If it was sent too often already, or no worker is left.
        """
        import distributed

        result = None
        with self._report_lost_connection():
            lost = self._query_scheduler(sent.future.exception)
            if lost is None:
                # If the worker was lost since, the chunk is computed again, or given up.
                try:
                    result = list(self._query_scheduler(sent.future.result))
                except distributed.scheduler.KilledWorker as killed:
                    lost = killed
        if lost is not None and not isinstance(lost, distributed.scheduler.KilledWorker):
            raise lost
        self._discard_chunk(sent)
        if lost is not None and sent.times >= MAX_SENDS_PER_CHUNK:
            raise LispacError(
                error(
                    "cluster.worker_lost_repeatedly",
                    address=self.address,
                    count=len(sent.chunk),
                    times=MAX_SENDS_PER_CHUNK,
                )
            )
        return result

    def _query_scheduler(self, method: Callable[..., Any]) -> Any:
        """Value of a completed future; it is computed again if its worker was lost.

        Raises
        ------
        LispacError
            If no worker is left.
        """
        while True:
            try:
                return method(timeout=WORKER_TIMEOUT)
            except TimeoutError:
                if not self._count_threads():
                    raise self._connection_error() from None

    def _connection_error(self) -> LispacError:
        return LispacError(error("cluster.no_workers_left", address=self.address))

    def _count_threads(self) -> int:
        """Number of threads of all workers."""
        with self._report_lost_connection():
            return sum(self.client.nthreads().values())

    @contextmanager
    def _report_lost_connection(self) -> Iterator[None]:
        """Convert errors of the communication with the scheduler into a lost connection.

        Raises
        ------
        LispacError
            If the connection is lost.
        """
        try:
            yield
        except (
            OSError, TimeoutError, asyncio.CancelledError, concurrent.futures.CancelledError,
        ) as failure:  # fmt: skip
            raise LispacError(error("cluster.connection_lost", address=self.address)) from failure

    def _discard_chunk(self, sent: "_ChunkInProgress") -> None:
        sent.future.release()
        self.in_progress.discard(sent)

    def close(self) -> None:
        """Cancel unfinished chunks and close the connection."""
        with suppress(Exception):  # if the scheduler has ended, there is nothing to cancel
            self.client.cancel([sent.future for sent in self.in_progress])
        self.client.close()


class _ChunkInProgress:
    """A chunk that was sent and is not completed."""

    future: Any

    def __init__(
        self,
        number: int,
        task: Callable[[Sequence[Any]], list[Any]],
        chunk: Sequence[Any],
        completed: "SimpleQueue[_ChunkInProgress]",
    ) -> None:
        self.number, self.task, self.chunk, self.completed = number, task, chunk, completed
        self.times = 0

    def on_done(self, future: Any) -> None:
        """Called in a thread of the client when the chunk is completed."""
        self.completed.put(self)


_WORKER_LOCK = threading.Lock()
"""Lock by which a worker process computes one chunk at a time. It may have several threads, but the
number of BLAS threads is a setting of the whole process."""


def _program_version() -> str:
    return __version__


def _require_version(code: str, version: str, required: str = "", *, address: str = "") -> None:
    """Require the version ``required``, by default that of this program.

    Raises
    ------
    LispacError
        If ``version`` differs; ``code`` is the code of its message.
    """
    required = required or __version__
    if version != required:
        raise LispacError(error(code, version=version, expected=required, address=address))


def _map_on_worker(
    function: Callable[[Any], Any], version: str, values: Sequence[Any]
) -> list[Any]:
    """Compute the results of a chunk on the worker."""
    _require_version("cluster.late_worker_version", __version__, version)
    with _WORKER_LOCK:
        return [function(value) for value in values]
