"""Progress reports of long computations.

A core function takes a keyword-only ``progress`` and calls it now and then. The command line
prints the calls, the window draws them, and either may raise `Cancelled` from inside the call:
that is how a running task is stopped.
"""

import time
from dataclasses import dataclass
from typing import Protocol

from lispac.language import LazyText, duration_text, gettext, number

SHORTEST_RATED = 1.0
"""Seconds after which a rate is given."""


@dataclass(frozen=True)
class PointProgress:
    """Progress of a task by its number of points.

    Attributes
    ----------
    step : LazyText
        What is done with them: ``Reading L1``.
    done : int
        Points that are done.
    total : int or None
        Points there are, where that is known.
    rate : float or None
        Points a second, where that is known.
    """

    step: LazyText
    done: int
    total: int | None
    rate: float | None = None

    def __str__(self) -> str:
        """The step with its rate, and the time left for it."""
        if self.rate is None or self.total is None:
            return self.without_time_left()
        left = gettext("{time} left", time=duration_text((self.total - self.done) / self.rate))
        return f"{self.without_time_left()}, {left}"

    def without_time_left(self) -> str:
        """Text of the step with its rate."""
        if self.total is None:
            text = gettext("{step}: {done} points", step=self.step, done=count_text(self.done))
        else:
            text = gettext(
                "{step}: {done} of {total} points",
                step=self.step, done=count_text(self.done), total=count_text(self.total),
            )  # fmt: skip
        if self.rate is None:
            return text
        rate = gettext("{rate:x.2} M points/s", rate=self.rate / 1e6)
        return f"{text}, {rate}"


Step = LazyText | PointProgress
"""What is being done; ``str`` gives its text."""


class Progress(Protocol):
    """Called with the fraction done, in [0, 1], and what is being done."""

    def __call__(self, fraction: float, step: Step | None = None) -> None:
        """Report; raises `lispac.errors.Cancelled` when the user asked to stop."""


def no_progress(fraction: float, step: Step | None = None) -> None:
    """Ignore the progress."""


def sub_progress(progress: Progress, start: float, stop: float) -> Progress:
    """Progress of a sub-task, from ``start`` to ``stop`` of the whole."""

    def report(fraction: float, step: Step | None = None) -> None:
        progress(start + (stop - start) * fraction, step)

    return report


class PointRate:
    """Rate of points of a task.

    Parameters
    ----------
    step : LazyText
        What is done with them: ``Reading L1``.
    total : int or None
        Points to come, where that is known.
    done : int
        Points that were done before the clock started.
    """

    def __init__(self, step: LazyText, total: int | None, done: int = 0) -> None:
        self._step, self._total, self._before = step, total, done
        self._started = time.monotonic()

    def step(self, done: int) -> PointProgress:
        """Progress after ``done`` points, with the rate once it is known."""
        elapsed = time.monotonic() - self._started
        if elapsed < SHORTEST_RATED or done <= self._before:
            return PointProgress(self._step, done, self._total)
        return PointProgress(self._step, done, self._total, (done - self._before) / elapsed)


def count_text(count: int) -> str:
    """A count of points, in millions where it is large: ``812``, ``4.9 M``."""
    return f"{number(count / 1e6, 1)} M" if count >= 1_000_000 else number(count, 0)
