"""Detail of a resting view: selected in several steps of the event loop, or at once."""

import time
from collections.abc import Callable, Iterator

from PySide6.QtCore import QObject

from lispac.gui.idle_tasks import IdleTask

REST_MS = 180
"""Stillness after which the detail is drawn."""

STEP_S = 0.04
"""Longest time of the selection without events of keyboard and mouse."""


class ViewDetail:
    """Selects the detail in steps, and then shows it.

    Parameters
    ----------
    steps : returns an iterator that selects a part at each step
    show : shows the selected detail
    """

    def __init__(
        self, parent: QObject, steps: Callable[[], Iterator[None]], show: Callable[[], None]
    ) -> None:
        self._make, self._show = steps, show
        self._steps: Iterator[None] = iter(())
        self._rest = IdleTask(self._begin, parent, REST_MS)
        self._step = IdleTask(self._go_on, parent)

    @property
    def is_due(self) -> bool:
        """Whether it follows."""
        return self._rest.isActive() or self._step.isActive()

    def later(self) -> None:
        """Select it once the view has rested for a moment."""
        self._step.stop()
        self._rest.start()

    def now(self, steps: Iterator[None]) -> None:
        """Select it with other steps, and show it at once."""
        self.stop()
        for _ in steps:
            pass
        self._show()

    def abandon(self) -> None:
        """Stop the selection: the view has moved."""
        self._step.stop()

    def stop(self) -> None:
        """Neither begin nor go on."""
        self._rest.stop()
        self._step.stop()

    def _begin(self) -> None:
        self._steps = self._make()
        self._go_on()

    def _go_on(self) -> None:
        end = time.perf_counter() + STEP_S
        for _ in self._steps:
            if time.perf_counter() > end:
                self._step.start()
                return
        self._show()
