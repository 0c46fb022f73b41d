"""Measure the pauses of the window's thread, and record their causes.

A timer fires regularly on the window's thread. While it is late, a watcher thread samples the stack
of the window's thread, which shows the cause of the pause.
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

BEAT_MS = 10
SAMPLE_S = 0.025
STACK_DEPTH = 7
"""Number of innermost stack frames kept of each sample."""


@dataclass
class Pause:
    """A time in which the window's thread did not return to its event loop.

    Attributes
    ----------
    took : wall-clock time, ms
    drawing : part of it in which VTK drew, ms; long with software rendering
    waiting : time outside drawing in which the thread waited for a processor, ms
    computing : processor time of the thread outside drawing, ms
    places : sampled places of the thread, with the number of samples of each
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
    """Timer that measures the pauses of the thread it was made on, from `start` to `stop`.

    Parameters
    ----------
    limit : float, ms
        Pauses longer than this are recorded.
    draws : Draws
        Drawing time of VTK so far.
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
        self._samples: list[tuple[float, str]] = []
        self._ended = threading.Event()
        self._watcher = threading.Thread(target=self._watch, name="pulse", daemon=True)
        self._timer = QTimer(self, interval=BEAT_MS, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._beat)

    def start(self) -> None:
        """Start the timer and the watcher thread."""
        self.discard()
        self._timer.start()
        self._watcher.start()

    def stop(self) -> None:
        """Stop the timer and the watcher thread."""
        self._timer.stop()
        self._ended.set()
        self._watcher.join()

    def discard(self) -> None:
        """Clear all measurements."""
        self.pauses, self.longest, self.beats = [], 0.0, 0
        self._last = self._now()

    def skip(self) -> None:
        """Ignore the time since the last beat."""
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
            samples = Counter(place for at, place in self._samples if at > since)
            self.pauses.append(Pause(took, drawing, waiting, computing, samples))
        self._samples = []

    def _watch(self) -> None:
        while not self._ended.wait(SAMPLE_S):
            at = time.perf_counter()
            if 1000 * (at - self._last[0]) > self.limit / 2:
                self._samples.append((at, _place(sys._current_frames().get(self._thread))))


class Draws:
    """Total drawing time of VTK; how much of it was computing or waiting for a processor, s."""

    def __init__(self) -> None:
        self.seconds, self.computing, self.waiting = 0.0, 0.0, 0.0
        self._clock = processor_clock()
        self._began = (0.0, 0.0, 0.0)

    def begin(self) -> None:
        """Note the start of a frame."""
        self._began = (time.perf_counter(), *self._clock())

    def end(self) -> None:
        """Add the time of the frame that has been drawn."""
        computing, waiting = self._clock()
        self.seconds += time.perf_counter() - self._began[0]
        self.computing += computing - self._began[1]
        self.waiting += waiting - self._began[2]


def timed_viewport(draws: Draws) -> type:
    """Viewport class that adds its drawing time to ``draws``."""
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
    frames = [f"{Path(each.filename).name}:{each.lineno} {each.name}" for each in shown]
    return " < ".join(reversed(frames))


def processor_clock() -> Callable[[], tuple[float, float]]:
    """Clock of this thread: seconds of computing and of waiting for a processor.

    The waiting time is 0 on systems other than Linux.
    """
    try:
        file = os.open(f"/proc/self/task/{threading.get_native_id()}/schedstat", os.O_RDONLY)
    except OSError:
        return lambda: (time.thread_time(), 0.0)

    def read() -> tuple[float, float]:
        computing, waiting, _ = os.pread(file, 100, 0).split()
        return int(computing) / 1e9, int(waiting) / 1e9

    return read


def resident_mb() -> float:
    """Resident memory of this process, MB; 0 where the system does not report it."""
    try:
        pages = int(Path("/proc/self/statm").read_text().split()[1])
    except OSError:
        return 0.0
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6
