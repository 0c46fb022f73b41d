"""Points a second and time left, in words."""

import time

SETTLED = 1.0
"""Seconds after which a rate is worth telling."""


class Pace:
    """How fast points go by.

    Parameters
    ----------
    what : str
        What is done with them: ``Reading L1``.
    total : int or None
        Points to come, where that is known.
    done : int
        Points that were done before the clock started.
    """

    def __init__(self, what: str, total: int | None, done: int = 0) -> None:
        self._what, self._total, self._before = what, total, done
        self._started = time.monotonic()

    def words(self, done: int) -> str:
        """What is done, how far, how fast and for how long still."""
        words = f"{self._what}: {millions(done)}"
        if self._total is not None:
            words += f" of {millions(self._total)}"
        words += " points"
        elapsed = time.monotonic() - self._started
        if elapsed < SETTLED or done <= self._before:
            return words
        rate = (done - self._before) / elapsed
        words += f", {rate / 1e6:.2f} M points/s"
        if self._total is not None:
            words += f", {spoken((self._total - done) / rate)} left"
        return words


def millions(count: int) -> str:
    """A count as one reads it: ``812``, ``4.9 M``."""
    return f"{count / 1e6:.1f} M" if count >= 1_000_000 else f"{count:,}"


def spoken(seconds: float) -> str:
    """A duration as one says it: ``3 s``, ``2 min 10 s``, ``1 h 05 min``."""
    whole = max(1, round(seconds))
    if whole < 60:
        return f"{whole} s"
    if whole < 3600:
        return f"{whole // 60} min {whole % 60:02d} s"
    return f"{whole // 3600} h {whole % 3600 // 60:02d} min"
