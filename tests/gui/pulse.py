"""Measure how long the thread of a window does not handle events, and what it does then.

A timer fires on the thread of the window. When it is late, a second thread records the stack of the
first, which shows the cause of the pause.
"""

import os
import sys
import threading
import time
import traceback
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from PySide6.QtCore import QObject, Qt, QTimer

INTERVAL_MS = 10
SAMPLING_INTERVAL_S = 0.025
STACK_DEPTH = 7
"""Number of frames kept of each stack sample, innermost first."""


@dataclass
class Pause:
    """A pause in which the window's thread did not return to its event loop.

    Attributes
    ----------
    took : total time, ms
    drawing : part in which VTK drew, ms; long with software rendering
    waiting : other part in which the thread was ready but had no processor, ms
    computing : processor time of the thread except for drawing, ms
    places : sampled positions of the thread with their counts
    """

    took: float
    drawing: float
    waiting: float
    computing: float
    places: Counter[str] = field(default_factory=Counter)

    def __str__(self) -> str:
        cause = "".join(f"\n      {n} x {place}" for place, n in self.places.most_common(4))
        return (
            f"{self.took:.0f} ms (computing {self.computing:.0f}, drawing {self.drawing:.0f}, "
            f"waiting for a processor {self.waiting:.0f}){cause}"
        )


class Pulse(QObject):
    """Measure pauses of the thread on which it was created, between `start` and `stop`.

    Parameters
    ----------
    limit : float, ms
        Longer pauses are recorded.
    draws : Draws
        Drawing times of VTK.
    """

    def __init__(self, limit: float, draws: "Draws", parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.limit, self._draws = limit, draws
        self.pauses: list[Pause] = []
        self.longest = 0.0
        self.beats = 0
        self._thread = threading.get_ident()
        self._clock = processor_clock()
        self._last = self._now()
        self._looks: list[tuple[float, str]] = []
        self._ended = threading.Event()
        self._watcher = threading.Thread(target=self._watch, name="pulse", daemon=True)
        self._timer = QTimer(self, interval=INTERVAL_MS, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._beat)

    def start(self) -> None:
        """Start measuring."""
        self.forget()
        self._timer.start()
        self._watcher.start()

    def stop(self) -> None:
        """Stop measuring and end the sampling thread."""
        self._timer.stop()
        self._ended.set()
        self._watcher.join()

    def forget(self) -> None:
        """Discard all measurements."""
        self.pauses, self.longest, self.beats = [], 0.0, 0
        self._last = self._now()

    def skip(self) -> None:
        """Ignore the time since the last event of the timer."""
        self._last = self._now()

    def _now(self) -> tuple[float, float, float, float]:
        computing, waiting = self._clock()
        draws = self._draws
        return (
            time.perf_counter(), draws.seconds, computing - draws.computing, waiting - draws.waiting
        )  # fmt: skip

    def _beat(self) -> None:
        now = self._now()
        took, drawing, computing, waiting = (
            1000 * (new - old) for new, old in zip(now, self._last, strict=True)
        )
        self._last, since = now, self._last[0]
        self.beats += 1
        self.longest = max(self.longest, took)
        if took > self.limit:
            seen = Counter(place for at, place in self._looks if at > since)
            self.pauses.append(Pause(took, drawing, waiting, computing, seen))
        self._looks = []

    def _watch(self) -> None:
        while not self._ended.wait(SAMPLING_INTERVAL_S):
            at = time.perf_counter()
            if 1000 * (at - self._last[0]) > self.limit / 2:
                self._looks.append((at, _place(sys._current_frames().get(self._thread))))


class Draws:
    """Total time of drawing by VTK, with its computing and waiting parts, seconds."""

    def __init__(self) -> None:
        self.seconds, self.computing, self.waiting = 0.0, 0.0, 0.0
        self._clock = processor_clock()
        self._began = (0.0, 0.0, 0.0)

    def begin(self) -> None:
        """Start the time of a frame."""
        self._began = (time.perf_counter(), *self._clock())

    def end(self) -> None:
        """Add the time of the drawn frame."""
        computing, waiting = self._clock()
        self.seconds += time.perf_counter() - self._began[0]
        self.computing += computing - self._began[1]
        self.waiting += waiting - self._began[2]


def timed_viewport(draws: Draws) -> type:
    """Return a viewport class that records its drawing times."""
    from lispac.gui.viewport.vtk_viewport import VtkViewport

    class Timed(VtkViewport):
        def _on_frame_start(self, *_: object) -> None:
            super()._on_frame_start()
            draws.begin()

        def _on_frame_end(self, *_: object) -> None:
            super()._on_frame_end()
            draws.end()

    return Timed


def _place(frame: object) -> str:
    if frame is None:
        return "gone"
    stack = traceback.extract_stack(frame)  # type: ignore[arg-type]
    ours = [
        k for k, each in enumerate(stack[:-STACK_DEPTH]) if "lispac" in Path(each.filename).parts
    ]
    shown = [*(stack[k] for k in ours[-1:]), *stack[-STACK_DEPTH:]]
    told = [f"{Path(each.filename).name}:{each.lineno} {each.name}" for each in shown]
    return " < ".join(reversed(told))


def processor_clock() -> Callable[[], tuple[float, float]]:
    """Return a function for computing and waiting time of this thread (waiting on Linux only)."""
    try:
        file = os.open(f"/proc/self/task/{threading.get_native_id()}/schedstat", os.O_RDONLY)
    except OSError:
        return lambda: (time.thread_time(), 0.0)

    def read() -> tuple[float, float]:
        computing, waiting, _ = os.pread(file, 100, 0).split()
        return int(computing) / 1e9, int(waiting) / 1e9

    return read


def resident_mb() -> float:
    """Return the resident memory of this process in megabytes, or 0 if unknown."""
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[1])
    except OSError:
        return 0.0
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6
