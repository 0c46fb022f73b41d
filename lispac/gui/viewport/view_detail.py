"""Selection of the points to draw when the view rests, in several turns of the event loop."""

import time
from collections.abc import Callable, Iterator

from PySide6.QtCore import QObject

from lispac.gui.widgets.idle_tasks import IdleTask

DETAIL_DELAY_MS = 180
"""Time for which the view must rest before the detail is drawn."""

MAX_STEP_S = 0.04
"""Longest time of the selection until events of keyboard and mouse are processed."""


class ViewDetail:
    """Selects the points to draw when the view rests, step by step, and then shows them.

    Parameters
    ----------
    steps : function that returns an iterator, which selects a part of the points at each step
    show : function that shows the selected detail
    """

    def __init__(
        self, parent: QObject, steps: Callable[[], Iterator[None]], show: Callable[[], None]
    ) -> None:
        self._create_steps, self._show = steps, show
        self._steps: Iterator[None] = iter(())
        self._start_task = IdleTask(self._start_steps, parent, DETAIL_DELAY_MS)
        self._step_task = IdleTask(self._continue_steps, parent)

    @property
    def is_due(self) -> bool:
        """Whether the detail is being computed or is scheduled."""
        return self._start_task.isActive() or self._step_task.isActive()

    def schedule(self) -> None:
        """Schedule the detail for when the view has rested for a moment."""
        self._step_task.stop()
        self._start_task.start()

    def compute_now(self, steps: Iterator[None]) -> None:
        """Compute the detail at once with other steps and show it."""
        self.stop()
        for _ in steps:
            pass
        self._show()

    def abandon(self) -> None:
        """Abandon the steps in progress, since the view has moved; a scheduled start remains."""
        self._step_task.stop()

    def stop(self) -> None:
        """Cancel the schedule and the steps in progress."""
        self._start_task.stop()
        self._step_task.stop()

    def _start_steps(self) -> None:
        self._steps = self._create_steps()
        self._continue_steps()

    def _continue_steps(self) -> None:
        end = time.perf_counter() + MAX_STEP_S
        for _ in self._steps:
            if time.perf_counter() > end:
                self._step_task.start()
                return
        self._show()
