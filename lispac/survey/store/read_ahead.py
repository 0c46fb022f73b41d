"""Compute the next item of an iterator in a thread while the current one is processed."""

import queue
import threading
from collections.abc import Generator, Iterator
from typing import TypeVar

T = TypeVar("T")

POLL_INTERVAL_S = 0.1  # seconds between two checks whether the next piece is still needed


def read_ahead(source: Iterator[T], depth: int = 1) -> Generator[T, None, None]:
    """Yield from ``source``, which runs in a separate thread; up to ``depth`` pieces are queued.

    An exception in the source is raised here. When the generator is closed, it waits until the
    thread has finished its current piece, because the thread may have a file open.
    """
    pieces: queue.Queue[tuple[T] | None] = queue.Queue(depth)
    unwanted = threading.Event()
    errors: list[BaseException] = []

    def hand_over(piece: tuple[T] | None) -> None:
        while not unwanted.is_set():
            try:
                pieces.put(piece, timeout=POLL_INTERVAL_S)
                return
            except queue.Full:
                continue

    def run() -> None:
        try:
            for piece in source:
                hand_over((piece,))
                if unwanted.is_set():
                    break
        except BaseException as error:
            errors.append(error)
        finally:
            if isinstance(source, Generator):
                source.close()
            hand_over(None)

    thread = threading.Thread(target=run, name="reading ahead", daemon=True)
    thread.start()
    try:
        while (piece := pieces.get()) is not None:
            yield piece[0]
    finally:
        unwanted.set()
        thread.join()
    if errors:
        raise errors[0]
