"""Clock of computations, which stops while functions are compiled (`lispac.compiled_code`)."""

import threading
import time


class CompilationTimer:
    """Time during which at least one thread compiles functions or reads them from the cache.

    Attributes
    ----------
    total : float, seconds, without a compilation that is under way
    """

    def __init__(self) -> None:
        self.total = 0.0
        self._lock, self._active, self._since = threading.Lock(), 0, 0.0

    def start(self) -> None:
        """Count the time until the next call of `end`; calls may be nested."""
        with self._lock:
            if self._active == 0:
                self._since = time.perf_counter()
            self._active += 1

    def end(self) -> None:
        """Stop counting if no other compilation is under way."""
        with self._lock:
            self._active -= 1
            if self._active == 0:
                self.total += time.perf_counter() - self._since


compilation_timer = CompilationTimer()
"""Timer of all compilations of this process."""


def computing_time() -> float:
    """Clock that stops while functions are compiled, seconds; only differences have a meaning."""
    return time.perf_counter() - compilation_timer.total
