"""Tests of campaigns on a slow or unreliable cluster, with simulated results."""

from collections.abc import Callable, Iterator
from threading import Timer
from typing import Any

import pytest

from lispac.errors import LispacError
from lispac.workflow.planning import cluster as cluster_module
from lispac.workflow.planning.cluster import MAX_SENDS_PER_CHUNK, _Cluster

distributed = pytest.importorskip("distributed")


class Future:
    """Future that is done at once; its first ``slow`` queries run into the timeout."""

    def __init__(self, outcome: list[int] | Exception, slow: int) -> None:
        self._outcome, self._slow = outcome, slow

    def add_done_callback(self, call: Callable[["Future"], None]) -> None:
        call(self)

    def exception(self, timeout: float) -> Exception | None:
        if self._slow:
            self._slow -= 1
            raise TimeoutError
        return self._outcome if isinstance(self._outcome, Exception) else None

    def result(self, timeout: float) -> list[int]:
        assert not isinstance(self._outcome, Exception)
        return self._outcome

    def release(self) -> None: ...


class Late(Future):
    """Future that calls back after a delay in a separate thread, like those of a client."""

    def __init__(self, outcome: list[int]) -> None:
        super().__init__(outcome, slow=0)

    def add_done_callback(self, call: Callable[[Future], None]) -> None:
        Timer(0.08, call, [self]).start()


class Client:
    """Client with two threads that returns one given future for each submitted chunk."""

    def __init__(self, futures: Iterator[Future]) -> None:
        self.submitted, self._futures = 0, futures

    def nthreads(self) -> dict[str, int]:
        return {"one": 1, "other": 1}

    def submit(self, task: Any, chunk: list[int], *, pure: bool) -> Future:
        self.submitted += 1
        return next(self._futures)


def lost_worker_error() -> Exception:
    return distributed.scheduler.KilledWorker("task", "worker", 0)


def test_a_slow_result_is_awaited_while_there_are_workers() -> None:
    client = Client(iter([Future([1], slow=3)]))
    assert list(_Cluster(client, "tcp://here:1").map(abs, [-1])) == [1]
    assert client.submitted == 1


@pytest.mark.parametrize("losses", range(MAX_SENDS_PER_CHUNK + 1))
def test_chunks_of_lost_workers_are_sent_again_a_limited_number_of_times(losses: int) -> None:
    futures = [*(Future(lost_worker_error(), slow=0) for _ in range(losses)), Future([7], slow=0)]
    client = Client(iter(futures))
    cluster = _Cluster(client, "tcp://here:1")
    if losses < MAX_SENDS_PER_CHUNK:
        assert list(cluster.map(abs, [-7])) == [7]
        assert client.submitted == losses + 1
        return
    with pytest.raises(LispacError) as caught:
        list(cluster.map(abs, [-7]))
    assert client.submitted == MAX_SENDS_PER_CHUNK
    assert caught.value.code == "cluster.worker_lost_repeatedly"
    assert "tcp://here:1" in str(caught.value)
    assert not cluster.in_progress


def test_a_long_computation_does_not_end_the_campaign(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Several polls find no result, but the workers are alive."""
    monkeypatch.setattr(cluster_module, "POLL_INTERVAL", 0.01)
    monkeypatch.setattr(cluster_module, "WORKER_TIMEOUT", 0.0)
    client = Client(iter([Late([5])]))
    assert list(_Cluster(client, "tcp://here:1").map(abs, [-5])) == [5]
