"""Progress reports of long computations.

A long computation has a keyword-only parameter ``progress``, which it calls repeatedly. The command
line prints the progress and the window shows a progress bar. Either may raise `Cancelled` inside
the call to stop the computation.
"""

import time
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

from lispac.language import LazyText, duration_text, gettext, number

MIN_RATE_TIME_S = 1.0
"""Smallest duration of a measurement, seconds, for which a rate is given."""

MIN_RATE = 5000.0
"""Smallest rate that is given, points per second: 0.01 million when rounded."""


@dataclass(frozen=True)
class PointProgress:
    """Progress of a task by its number of points.

    Attributes
    ----------
    step : LazyText
        Name of the current step, such as ``Reading L1``.
    done : int
        Number of processed points.
    total : int or None
        Number of all points, if known.
    rate : float or None
        Points per second, if known.
    """

    step: LazyText
    done: int
    total: int | None
    rate: float | None = None

    def __str__(self) -> str:
        """Text of the step with its rate and the remaining time."""
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
"""Current step of a task; ``str`` gives its text."""


class Progress(Protocol):
    """Callable that takes the completed fraction, in [0, 1], and the current step."""

    def __call__(self, fraction: float, step: Step | None = None) -> None:
        """Report the progress; raises `lispac.errors.Cancelled` if the user cancelled the task."""


def no_progress(fraction: float, step: Step | None = None) -> None:
    """Ignore the progress."""


def sub_progress(progress: Progress, start: float, stop: float) -> Progress:
    """Progress of a part of a task, which covers the fractions from ``start`` to ``stop``."""

    def report(fraction: float, step: Step | None = None) -> None:
        progress(start + (stop - start) * fraction, step)

    return report


def without_steps(progress: Progress) -> Progress:
    """Progress of a part of a task that does not replace the name of the task's step."""

    def report(fraction: float, step: Step | None = None) -> None:
        progress(fraction)

    return report


ROUND_SHARE = 0.7
"""Share of the remaining progress that the next one of an unknown number of rounds covers."""


def progress_of_rounds(progress: Progress) -> Iterator[Progress]:
    """Progress of each of an unknown number of rounds, without end."""
    start = 0.0
    while True:
        stop = start + ROUND_SHARE * (1.0 - start)
        yield sub_progress(progress, start, stop)
        start = stop


class PointRate:
    """Measurement of the number of points processed per second.

    Parameters
    ----------
    step : LazyText
        Name of the step, such as ``Reading L1``.
    total : int or None
        Number of all points, if known.
    done : int
        Number of points processed before the measurement started.
    """

    def __init__(self, step: LazyText, total: int | None, done: int = 0) -> None:
        self._step, self._total, self._before = step, total, done
        self._started = time.monotonic()

    def step(self, done: int) -> PointProgress:
        """Progress after ``done`` points, with the rate once it is known."""
        elapsed = time.monotonic() - self._started
        rate = (done - self._before) / elapsed if elapsed >= MIN_RATE_TIME_S else 0.0
        if rate < MIN_RATE:
            return PointProgress(self._step, done, self._total)
        return PointProgress(self._step, done, self._total, rate)


def count_text(count: int) -> str:
    """Number of points as a text, in millions if large: ``812``, ``4.9 M``."""
    return f"{number(count / 1e6, 1)} M" if count >= 1_000_000 else number(count, 0)
