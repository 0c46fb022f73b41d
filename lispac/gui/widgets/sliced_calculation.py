"""Long calculation of a library, run in slices between events of the window.

For what neither has steps of its own nor can go to the worker, since the window uses the same
objects: the thread it has runs only while its caller waits, so never two at a time.
"""

import threading
import time
from collections.abc import Callable

SLICE_S = 0.03
"""Seconds after which the calculation pauses where it allows it."""


class _CalculationAbandoned(BaseException):
    """Ends a calculation that was abandoned."""


class SlicedCalculation:
    """Calculation that pauses after each slice until the caller continues it."""

    def __init__(self) -> None:
        self._turn, self._back = threading.Semaphore(0), threading.Semaphore(0)
        self._thread: threading.Thread | None = None
        self._done = self._abandoned = False
        self._error: BaseException | None = None
        self._until = 0.0

    @property
    def is_running(self) -> bool:
        """Whether a calculation was begun and is not finished."""
        return self._thread is not None

    def begin(self, work: Callable[[], object]) -> None:
        """Set a calculation, which calls `pause` where it may pause; `resume` starts it."""
        self.abandon()
        self._done = self._abandoned = False
        self._error = None

        def run() -> None:
            self._turn.acquire()
            self._until = time.perf_counter() + SLICE_S
            try:
                if not self._abandoned:
                    work()
            except _CalculationAbandoned:
                pass
            except BaseException as error:
                self._error = error
            self._done = True
            self._back.release()

        self._thread = threading.Thread(target=run, daemon=True, name="slices")
        self._thread.start()

    def resume(self) -> bool:
        """Calculate for one slice; return True if finished. Raises errors of the calculation."""
        if self._thread is None:
            return True
        self._turn.release()
        self._back.acquire()
        if self._done:
            self._thread.join()
            self._thread = None
        if self._error is not None:
            raise self._error
        return self._done

    def pause(self) -> None:
        """Pause the calculation if its slice is over; called by the calculation."""
        if threading.current_thread() is not self._thread or time.perf_counter() < self._until:
            return
        self._back.release()
        self._turn.acquire()
        if self._abandoned:
            raise _CalculationAbandoned
        self._until = time.perf_counter() + SLICE_S

    def abandon(self) -> None:
        """Abandon the calculation."""
        self._abandoned = True
        self.resume()
