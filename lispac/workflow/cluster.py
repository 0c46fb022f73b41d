"""A campaign on many machines: the workers of a dask scheduler.

The scheduler hands chunks to workers and hands those of a lost worker to others. What has come in
is kept here, so that nothing is calculated twice but what was under way. Where the same chunk has
lost its worker several times over, the scheduler gives it up; it is sent again a few times, since
office machines are switched off without regard to what they calculate.
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

from lispac import __version__
from lispac.design.search import Mapper
from lispac.errors import LispacError
from lispac.messages import error
from lispac.workflow.campaign import chunk_of
from lispac.workflow.cluster_access import ClusterAccess

CONNECT = 4.0
"""Seconds that a scheduler has to answer."""

WORKERS = 15.0
"""Seconds that a worker may take to be there: one that was lost is started again by its nanny."""

LOOK = 2.0
"""Seconds without a result after which the number of workers is checked."""

PATIENCE = 60.0
"""Seconds that may pass without any worker before the campaign ends."""

SENDINGS = 3
"""Times that a chunk is sent; each time the scheduler bears with several lost workers."""


@contextmanager
def cluster_of(access: ClusterAccess | str) -> Iterator[Mapper]:
    """A mapper over the workers of a dask scheduler.

    What is not done when the context is left is cancelled.

    Parameters
    ----------
    access : ClusterAccess or str
        An address alone stands for access without certificates of its own.

    Raises
    ------
    LispacError
        dask.distributed is not installed, no scheduler answers, it has no workers, or they have
        another LISPAC; from the mapper: all workers are gone, or a chunk ends every worker.
    """
    access = ClusterAccess(access) if isinstance(access, str) else access
    address = access.url
    try:
        import distributed
    except ImportError as failure:
        raise LispacError(error("cluster.not_installed")) from failure
    security = access.security()
    with _silence():
        _greet(address, security)
        client = distributed.Client(
            address, timeout=CONNECT, set_as_default=False, security=security
        )
        cluster = _Cluster(client, address)
        try:
            cluster.check()
            yield cluster.map
        finally:
            cluster.close()


@contextmanager
def _silence() -> Iterator[None]:
    """Report errors as one message, not by the log of the client."""
    logs = [logging.getLogger(name) for name in ("distributed", "distributed.client")]
    levels = [log.level for log in logs]
    for log in logs:
        log.setLevel(logging.CRITICAL + 1)
    try:
        yield
    finally:
        for log, level in zip(logs, levels, strict=True):
            log.setLevel(level)


def _greet(address: str, security: Any) -> None:
    """Refuse an address without a scheduler; a client would wait for ever.

    Raises
    ------
    LispacError
    """
    from distributed.comm import connect

    async def greeted() -> None:
        options = security.get_connection_args("client")
        comm = await asyncio.wait_for(connect(address, timeout=CONNECT, **options), CONNECT)
        comm.abort()

    try:
        asyncio.run(greeted())
    except Exception as failure:  # whatever another program's answer leads to
        raise LispacError(
            error("cluster.no_scheduler", address=address, limit=CONNECT)
        ) from failure


class _Cluster:
    """The connection, and what was sent and has not come back."""

    def __init__(self, client: Any, address: str) -> None:
        self.client, self.address = client, address
        self.under_way: set[_ChunkInProgress] = set()

    def check(self) -> None:
        """Refuse a cluster without workers, or whose workers are not like this program.

        Raises
        ------
        LispacError
        """
        try:  # one that was lost is perhaps being started again
            self.client.wait_for_workers(1, timeout=WORKERS)
        except TimeoutError:
            raise LispacError(error("cluster.no_workers", address=self.address)) from None
        try:  # it reads every chunk before it hands it on
            found = self.client.run_on_scheduler(_version)
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
        for worker, found in self.client.run(_version, on_error="return").items():
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
        """The answers in the order of the values, each as soon as those before it are there."""
        values = list(values)
        size = chunk_of(len(values), self._workers())
        chunks = [values[k : k + size] for k in range(0, len(values), size)]
        task = partial(_answers, function, __version__)
        back: SimpleQueue[_ChunkInProgress] = SimpleQueue()
        for k, chunk in enumerate(chunks):
            self._send(_ChunkInProgress(k, task, chunk, back))
        answers: dict[int, list[Any]] = {}
        for k in range(len(chunks)):
            while k not in answers:
                sent = self._next(back)
                answer = self._answer(sent)
                if answer is None:
                    self._send(sent)
                else:
                    answers[sent.number] = answer
            yield from answers.pop(k)

    def _send(self, sent: "_ChunkInProgress") -> None:
        sent.times += 1
        with self._talk():
            sent.future = self.client.submit(sent.task, sent.chunk, pure=False)
        self.under_way.add(sent)
        sent.future.add_done_callback(sent.came)

    def _next(self, back: "SimpleQueue[_ChunkInProgress]") -> "_ChunkInProgress":
        """What comes back next, as long as there is hope.

        Raises
        ------
        LispacError
            Where all workers are gone.
        """
        alone_since = None
        while True:
            try:
                return back.get(timeout=LOOK)
            except Empty:
                pass
            if self._workers():
                alone_since = None
            else:
                alone_since = alone_since or monotonic()
                if monotonic() - alone_since > PATIENCE:
                    raise self._gone()

    def _answer(self, sent: "_ChunkInProgress") -> list[Any] | None:
        """Result of a task; None if the scheduler gave it up and it should be repeated.

        Raises
        ------
        LispacError
            Where it was sent too often already, or all workers are gone.
        """
        import distributed

        answer = None
        with self._talk():
            lost = self._asked(sent.future.exception)
            if lost is None:
                # Its worker may have been lost since: others do it again, or are lost by it, too
                try:
                    answer = list(self._asked(sent.future.result))
                except distributed.scheduler.KilledWorker as killed:
                    lost = killed
        if lost is not None and not isinstance(lost, distributed.scheduler.KilledWorker):
            raise lost
        self._forget(sent)
        if lost is not None and sent.times >= SENDINGS:
            raise LispacError(
                error(
                    "cluster.worker_lost_repeatedly",
                    address=self.address,
                    count=len(sent.chunk),
                    times=SENDINGS,
                )
            )
        return answer

    def _asked(self, ask: Callable[..., Any]) -> Any:
        """Result of a completed future; repeated if its worker was lost.

        Raises
        ------
        LispacError
            Where nobody is left to do it.
        """
        while True:
            try:
                return ask(timeout=PATIENCE)
            except TimeoutError:
                if not self._workers():
                    raise self._gone() from None

    def _gone(self) -> LispacError:
        return LispacError(error("cluster.no_workers_left", address=self.address))

    def _workers(self) -> int:
        """Threads of all workers there are now."""
        with self._talk():
            return sum(self.client.nthreads().values())

    @contextmanager
    def _talk(self) -> Iterator[None]:
        """What breaks while one talks to the scheduler is its connection.

        Raises
        ------
        LispacError
        """
        try:
            yield
        except (
            OSError, TimeoutError, asyncio.CancelledError, concurrent.futures.CancelledError,
        ) as failure:  # fmt: skip
            raise LispacError(error("cluster.connection_lost", address=self.address)) from failure

    def _forget(self, sent: "_ChunkInProgress") -> None:
        sent.future.release()
        self.under_way.discard(sent)

    def close(self) -> None:
        """Cancel what has not come back, and leave."""
        with suppress(Exception):  # the scheduler may be gone, and then there is nothing to cancel
            self.client.cancel([sent.future for sent in self.under_way])
        self.client.close()


class _ChunkInProgress:
    """A chunk on its way."""

    future: Any

    def __init__(
        self,
        number: int,
        task: Callable[[Sequence[Any]], list[Any]],
        chunk: Sequence[Any],
        back: "SimpleQueue[_ChunkInProgress]",
    ) -> None:
        self.number, self.task, self.chunk, self.back = number, task, chunk, back
        self.times = 0

    def came(self, future: Any) -> None:
        """Called when it is done, in a thread of the client."""
        self.back.put(self)


_ONE_AT_A_TIME = threading.Lock()
"""A worker may have several threads; how many threads BLAS has is a setting of the process."""


def _version() -> str:
    return __version__


def _require_version(code: str, found: str, wanted: str = "", *, address: str = "") -> None:
    """Refuse another version than ``wanted``, by default this one, by the message ``code``.

    Raises
    ------
    LispacError
    """
    wanted = wanted or __version__
    if found != wanted:
        raise LispacError(error(code, version=found, expected=wanted, address=address))


def _answers(function: Callable[[Any], Any], version: str, values: Sequence[Any]) -> list[Any]:
    """On the worker: the answers to a chunk."""
    _require_version("cluster.late_worker_version", __version__, version)
    with _ONE_AT_A_TIME:
        return [function(value) for value in values]
