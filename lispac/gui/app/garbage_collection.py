"""Garbage collection on the thread of the window only.

Python collects cycles in whatever thread happens to make the object too many. A worker that finds a
widget or graphics of a window that has gone would delete them there, which Qt and OpenGL do not
survive. What lies in no cycle goes at once, as ever.
"""

import ctypes
import gc
import sys
import time

from PySide6.QtCore import QObject, QTimer
from PySide6.QtWidgets import QApplication

from lispac.gui.widgets.idle_tasks import IdleTask

COLLECT_INTERVAL_MS = 100
"""Interval of the checks: a worker that reads creates 100 000 objects a second."""
MIN_YOUNG, MIN_MIDDLE = 700, 10
"""Numbers of objects that start a collection of the first and second generation, as in Python."""
FULL_INTERVAL_S = 15.0
"""Interval of full collections, which take 0.06 s with all libraries loaded. A closed dialogue
lies in cycles with the lines it was opened for: by counts alone that came to 1.2 GB."""

MIN_NEW_MODULES = 30
"""New modules after which they are examined once and then frozen. While a library is imported,
every tenth of a second brings some: all of them at once take a quarter of a second."""

M_TRIM_THRESHOLD, M_MMAP_THRESHOLD, MMAP_BYTES = -1, -3, 2_000_000
"""Options of malloc.h, and the size, bytes, from which an array has pages of its own and free
memory at the end of the heap is returned."""

TRIM_INTERVAL_S = 5.0
"""Interval of memory trimming, which takes 0.01 to 0.04 s."""


class GuiThreadGarbageCollector(QObject):
    """Runs Python's garbage collector in the thread of the window only, until it is ended.

    Imported modules are not examined again: they are never freed, and examining them takes 0.16 s.
    Other objects of that time are examined after a window is closed.
    """

    frozen_modules = 0
    """Modules that are not examined."""
    with_window = False
    """Whether a window was there when they were counted, and is not examined either."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        gc.disable()
        GuiThreadGarbageCollector.frozen_modules = len(sys.modules)
        gc.freeze()
        self._last_full = time.monotonic()
        self._timer = QTimer(self, interval=COLLECT_INTERVAL_MS)
        self._timer.timeout.connect(self.collect_due)
        self._timer.start()

    def collect_due(self) -> None:
        """Collect the generations that are due."""
        young, middle, _old = gc.get_count()
        if young <= MIN_YOUNG or IdleTask.turn_used:
            return
        new = len(sys.modules) - GuiThreadGarbageCollector.frozen_modules
        # A dialogue that is open will go, with the lines it was opened for
        imported = new > MIN_NEW_MODULES and QApplication.activeModalWidget() is None
        due = imported or time.monotonic() > self._last_full + FULL_INTERVAL_S
        gc.collect(2 if due else 1 if middle > MIN_MIDDLE else 0)
        if due:
            self._last_full = time.monotonic()
        if imported:
            GuiThreadGarbageCollector.frozen_modules = len(sys.modules)
            GuiThreadGarbageCollector.with_window = True
            gc.freeze()

    def end(self) -> None:
        """Return garbage collection to Python."""
        self._timer.stop()
        gc.enable()


def collect_all() -> None:
    """Collect all garbage, including objects of a closed window that were frozen."""
    if GuiThreadGarbageCollector.with_window:
        gc.unfreeze()
    gc.collect()
    if GuiThreadGarbageCollector.with_window:
        gc.freeze()


class MemoryTrimming:
    """Returns freed memory of the C library to the system.

    The C library of Linux keeps them for later: after four minutes of changing projects and
    languages the program held 2.7 GB of which it used 1.7. And once an array of 32 MB has gone it
    lays all that are smaller between other things, where holes stay: with `MMAP_BYTES` the program
    held 0.9 GB after work with which it had 1.1. Libraries of other systems give them back.
    """

    def __init__(self) -> None:
        library = ctypes.CDLL(None) if sys.platform.startswith("linux") else None
        # musl has neither and needs neither
        self._trim = getattr(library, "malloc_trim", None)
        if (choose := getattr(library, "mallopt", None)) is not None and self._trim is not None:
            choose(M_MMAP_THRESHOLD, MMAP_BYTES)
            choose(M_TRIM_THRESHOLD, MMAP_BYTES)
        self._last = time.monotonic()

    def trim_if_due(self) -> None:
        """Return freed memory if it is due; called by a worker after each task."""
        if self._trim is not None and time.monotonic() > self._last + TRIM_INTERVAL_S:
            self._trim(0)
            self._last = time.monotonic()
