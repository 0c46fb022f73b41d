"""Garbage collection on the thread of the window only.

Python collects reference cycles in the thread that creates the last of a certain number of new
objects. If this were a worker thread and it deleted a widget or graphics of a closed window, Qt or
OpenGL would crash. Objects that are in no cycle are deleted immediately, as usual.
"""

import ctypes
import gc
import sys
import time

from PySide6.QtCore import QObject, QTimer
from PySide6.QtWidgets import QApplication

from lispac.gui.widgets.idle_tasks import IdleTask

CHECK_INTERVAL_MS = 100
"""Interval of the checks; a worker that reads files creates 100 000 objects a second."""
MIN_NEW_OBJECTS, MIN_YOUNG_COLLECTIONS = 700, 10
"""Number of new objects above which the first generation is collected, and number of such
collections above which the second one is collected as well: the defaults of Python 3.11."""
FULL_COLLECTION_INTERVAL_S = 15.0
"""Interval of full collections, which take 0.06 s with all libraries loaded. Closed dialogues form
cycles with the points of the lines they used: with collections by numbers of objects alone, 1.2 GB
accumulated."""

MIN_NEW_MODULES = 30
"""Number of newly imported modules above which their objects are examined once and then frozen, so
that later collections skip them. The number avoids repeated examinations, a quarter of a second
each, while a library is imported."""

M_TRIM_THRESHOLD, M_MMAP_THRESHOLD, MMAP_THRESHOLD_BYTES = -1, -3, 2_000_000
"""Two options of the C function ``mallopt`` (malloc.h) and the value of both, bytes: a larger array
gets memory pages of its own, and a larger free area at the end of the heap is returned to the
system."""

TRIM_INTERVAL_S = 5.0
"""Shortest interval between two returns of memory, which take 0.01 to 0.04 s each."""


class GuiThreadGarbageCollector(QObject):
    """Runs Python's garbage collector in the thread of the window only, until `end` is called.

    Objects of imported modules are frozen, since they are never freed and examining them takes
    0.16 s. All other existing objects are frozen with them; `collect_all` examines them again.
    """

    frozen_modules = 0
    """Number of imported modules at the start, or when `collect_due` last froze objects."""
    may_have_frozen_window = False
    """Whether objects of a window may be among the frozen objects."""

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        gc.disable()
        GuiThreadGarbageCollector.frozen_modules = len(sys.modules)
        gc.freeze()
        self._last_full = time.monotonic()
        self._timer = QTimer(self, interval=CHECK_INTERVAL_MS)
        self._timer.timeout.connect(self.collect_due)
        self._timer.start()

    def collect_due(self) -> None:
        """Collect the generations that are due, unless there are few new objects."""
        new_objects, young_collections, _ = gc.get_count()
        if new_objects <= MIN_NEW_OBJECTS or IdleTask.turn_used:
            return
        new_modules = len(sys.modules) - GuiThreadGarbageCollector.frozen_modules
        # Not while a dialogue is open: if frozen, it would not be freed with its lines when closed
        freezes = new_modules > MIN_NEW_MODULES and QApplication.activeModalWidget() is None
        is_full = freezes or time.monotonic() > self._last_full + FULL_COLLECTION_INTERVAL_S
        gc.collect(2 if is_full else 1 if young_collections > MIN_YOUNG_COLLECTIONS else 0)
        if is_full:
            self._last_full = time.monotonic()
        if freezes:
            GuiThreadGarbageCollector.frozen_modules = len(sys.modules)
            GuiThreadGarbageCollector.may_have_frozen_window = True
            gc.freeze()

    def end(self) -> None:
        """Stop these collections and enable the automatic garbage collection of Python again."""
        self._timer.stop()
        gc.enable()


def collect_all() -> None:
    """Collect all garbage, including frozen objects of a window that was replaced."""
    if GuiThreadGarbageCollector.may_have_frozen_window:
        gc.unfreeze()
    gc.collect()
    if GuiThreadGarbageCollector.may_have_frozen_window:
        gc.freeze()


class MemoryTrimming:
    """Returns freed memory of the C library to the system.

    The C library of Linux keeps freed memory for later use: after four minutes of changing projects
    and languages, the program held 2.7 GB and used 1.7 GB. Each time it frees an array of at most
    32 MB that has its own pages, it places later arrays of this size in the heap, which becomes
    fragmented. `MMAP_THRESHOLD_BYTES` prevents this and reduced the memory from 1.1 to 0.9 GB. The
    libraries of other systems return freed memory.
    """

    def __init__(self) -> None:
        library = ctypes.CDLL(None) if sys.platform.startswith("linux") else None
        # The C library musl lacks both functions and does not need them
        self._trim = getattr(library, "malloc_trim", None)
        set_option = getattr(library, "mallopt", None)
        if set_option is not None and self._trim is not None:
            set_option(M_MMAP_THRESHOLD, MMAP_THRESHOLD_BYTES)
            set_option(M_TRIM_THRESHOLD, MMAP_THRESHOLD_BYTES)
        self._last = time.monotonic()

    def trim_if_due(self) -> None:
        """Return freed memory if the interval is over; the worker calls this after each task."""
        if self._trim is not None and time.monotonic() > self._last + TRIM_INTERVAL_S:
            self._trim(0)
            self._last = time.monotonic()
