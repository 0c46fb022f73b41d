"""How long work reports on itself without knowing who listens.

A core function takes a keyword-only ``progress`` and calls it now and then. The command line
prints the calls, the window draws them, and either may raise `Cancelled` from inside the call:
that is how a running task is stopped.
"""

from typing import Protocol


class Progress(Protocol):
    """Called with the fraction done, in [0, 1], and what is being done."""

    def __call__(self, fraction: float, message: str = "") -> None:
        """Report; raises `lispac.errors.Cancelled` when the user asked to stop."""


def no_progress(fraction: float, message: str = "") -> None:
    """Listen to nothing."""


def part(progress: Progress, start: float, stop: float) -> Progress:
    """Give a sub-task the stretch from ``start`` to ``stop`` of the whole."""

    def report(fraction: float, message: str = "") -> None:
        progress(start + (stop - start) * fraction, message)

    return report
