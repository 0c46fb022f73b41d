"""Garbage collection on the thread of the window only.

Python collects reference cycles in the thread that happens to exceed the number of new objects. If
a worker thread deleted a widget or graphics of a closed window in this way, Qt or OpenGL would
crash. Objects that are in no cycle are deleted immediately, as usual.
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
"""Interval of full collections, which take 0.06 s with all libraries loaded. Closed dialogues form
cycles with the lines they used: with collections by counts alone, 1.2 GB accumulated."""

MIN_NEW_MODULES = 30
"""Number of new modules after which their objects are examined once and then frozen. A library
adds modules continuously during its import; examining all objects takes a quarter of a second."""

M_TRIM_THRESHOLD, M_MMAP_THRESHOLD, MMAP_BYTES = -1, -3, 2_000_000
"""Options of malloc.h, and the size, bytes, above which an array gets separate memory pages and
free memory at the end of the heap is returned to the system."""

TRIM_INTERVAL_S = 5.0
"""Interval of memory trimming, which takes 0.01 to 0.04 s."""


class GuiThreadGarbageCollector(QObject):
    """Runs Python's garbage collector in the thread of the window only, until it is ended.

    Objects of imported modules are not examined again, since they are never freed and examining
    them takes 0.16 s. Other objects frozen with them are examined after a window is closed.
    """

    frozen_modules = 0
    """Number of modules whose objects are not examined."""
    with_window = False
    """Whether a window existed when the objects were frozen, and was frozen with them."""

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
        # Not while a dialogue is open: it must be freed with its lines after it is closed
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
        """Stop the collections and enable the automatic garbage collection of Python."""
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

    The C library of Linux keeps freed memory for later use: after four minutes of changing projects
    and languages, the program held 2.7 GB and used 1.7 GB. After an array of 32 MB was freed, it
    also places smaller arrays in the heap, which becomes fragmented; `MMAP_BYTES` prevents this and
    reduced the memory from 1.1 to 0.9 GB. The libraries of other systems return freed memory.
    """

    def __init__(self) -> None:
        library = ctypes.CDLL(None) if sys.platform.startswith("linux") else None
        # musl lacks both functions and does not need them
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
