"""Tests of the garbage collection in the window's thread, and of the release of memory."""

import gc
import mmap
import sys
import threading
import time
import types
import weakref
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QEvent, QTimer
from PySide6.QtWidgets import QApplication, QDialog, QMainWindow
from pytestqt.qtbot import QtBot

from lispac.gui.app.garbage_collection import (
    FULL_COLLECTION_INTERVAL_S,
    MIN_NEW_MODULES,
    MIN_NEW_OBJECTS,
    TRIM_INTERVAL_S,
    GuiThreadGarbageCollector,
    MemoryTrimming,
    collect_all,
)  # fmt: skip
from tests.gui.support import WAIT_MS
from tests.support.leaked_resources import find_leaks


class Cycle:
    """Object with a reference to itself."""

    def __init__(self) -> None:
        self.itself = self


def busy(stop: threading.Event) -> None:
    """Create enough objects to trigger Python's automatic collection, as a reading worker does."""
    kept = []
    while not stop.is_set():
        kept = [[each] for each in range(50 * MIN_NEW_OBJECTS)]
        time.sleep(0.001)
    del kept


def test_cycles_are_collected_in_the_window_thread(qapp: QApplication, qtbot: QtBot) -> None:
    tidying = GuiThreadGarbageCollector()
    stop, threads = threading.Event(), []
    worker = threading.Thread(target=busy, args=(stop,))
    worker.start()
    try:
        cycles = [Cycle() for _ in range(20)]
        for each in cycles:
            weakref.finalize(each, lambda: threads.append(threading.current_thread()))
        time.sleep(0.2)  # the worker creates objects, the window's thread is idle
        del each, cycles
        time.sleep(0.2)
        assert threads == []
        qtbot.waitUntil(lambda: len(threads) == 20, timeout=WAIT_MS)
    finally:
        stop.set()
        worker.join()
        tidying.end()
    assert set(threads) == {threading.main_thread()}
    assert gc.isenabled()


def test_each_generation_is_collected_when_due(
    qapp: QApplication, monkeypatch: pytest.MonkeyPatch
) -> None:
    now, collected = [100.0], []
    monkeypatch.setattr(time, "monotonic", lambda: now[0])
    tidying = GuiThreadGarbageCollector()
    monkeypatch.setattr(gc, "collect", collected.append)
    try:
        for later, counts in (
            (FULL_COLLECTION_INTERVAL_S, (MIN_NEW_OBJECTS, 99, 999)),
            (0.0, (MIN_NEW_OBJECTS + 1, 3, 999)),
            (0.1, (800, 11, 0)), (0.1, (800, 0, 0)), (FULL_COLLECTION_INTERVAL_S, (800, 0, 0)),
        ):  # fmt: skip
            now[0] += later
            monkeypatch.setattr(gc, "get_count", lambda counts=counts: counts)
            tidying.collect_due()
    finally:
        tidying.end()
    assert collected == [0, 2, 0, 2]


def test_newly_imported_modules_are_frozen_after_a_full_collection(
    qapp: QApplication, monkeypatch: pytest.MonkeyPatch
) -> None:
    now, done = [100.0], []
    monkeypatch.setattr(GuiThreadGarbageCollector, "frozen_modules", 0)
    monkeypatch.setattr(GuiThreadGarbageCollector, "may_have_frozen_window", False)
    monkeypatch.setattr(time, "monotonic", lambda: now[0])
    monkeypatch.setattr(gc, "collect", lambda generation: done.append(f"collect {generation}"))
    monkeypatch.setattr(gc, "freeze", lambda: done.append("leave alone"))
    monkeypatch.setattr(gc, "get_count", lambda: (MIN_NEW_OBJECTS + 1, 0, 0))
    tidying = GuiThreadGarbageCollector()

    def later() -> list[str]:
        done.clear()
        now[0] += FULL_COLLECTION_INTERVAL_S + 1
        tidying.collect_due()
        return done

    try:
        assert later() == ["collect 2"]
        for k in range(MIN_NEW_MODULES + 1):
            monkeypatch.setitem(sys.modules, f"came_{k}", types.ModuleType("came"))
        dialogue = QDialog(modal=True)
        dialogue.show()
        assert later() == ["collect 2"]
        dialogue.close()
        assert later() == ["collect 2", "leave alone"]
        assert later() == ["collect 2"]
    finally:
        tidying.end()


def test_a_window_frozen_with_new_modules_is_still_collected(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    for name, now in (
        ("frozen_modules", len(sys.modules)), ("may_have_frozen_window", True),
    ):  # fmt: skip
        monkeypatch.setattr(GuiThreadGarbageCollector, name, now)
    collected: list[str] = []
    window = Cycle()
    weakref.finalize(window, collected.append, "window")
    gc.freeze()
    del window
    gc.collect()
    assert collected == []
    collect_all()
    assert collected == ["window"]
    assert gc.get_freeze_count() > 0
    gc.unfreeze()


def resident() -> int:
    """Resident memory of this process, bytes."""
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * mmap.PAGESIZE


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="of Linux' C library")
def test_memory_of_freed_arrays_is_returned_to_the_system() -> None:
    """Memory of freed arrays is returned to the system, also after a larger array was freed.

    glibc raises its threshold for separate mappings when a larger block is freed. The test runs in
    its own process, because existing holes would be filled first.
    """
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as alone:
        before, after = alone.submit(memory_around_freeing).result(timeout=60)
    assert after < before - 140e6


def memory_around_freeing() -> tuple[int, int]:
    """Resident bytes before and after half of the arrays are freed."""
    large = np.ones(3_900_000)
    del large
    MemoryTrimming()
    arrays = [np.ones(400_000) for _ in range(100)]
    before = resident()
    del arrays[::2]
    return before, resident()


@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="of Linux' C library")
def test_freed_memory_is_trimmed_after_work(monkeypatch: pytest.MonkeyPatch) -> None:
    blocks = [b"x" * 100_000 for _ in range(4000)]  # 400 MB of blocks too small for a mapping each
    before = resident()
    del blocks[::2]
    memory = MemoryTrimming()
    memory.trim_if_due()  # not due yet
    assert resident() > before - 20e6
    later = time.monotonic() + TRIM_INTERVAL_S + 1
    monkeypatch.setattr(time, "monotonic", lambda: later)
    memory.trim_if_due()
    assert resident() < before - 150e6
    assert len(blocks) == 2000


def test_leaked_windows_timers_and_threads_are_found(qapp: QApplication, qtbot: QtBot) -> None:
    """Test `find_leaks`, the check that follows each test of a window."""
    assert find_leaks() == []
    window, timer, stop = QMainWindow(), QTimer(objectName="beat"), threading.Event()
    window.show()
    timer.start(1000)
    worker = threading.Thread(target=stop.wait, name="lispac-worker")
    worker.start()
    found = find_leaks()
    stop.set()
    worker.join()
    timer.stop()
    window.close()
    window.deleteLater()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    assert found == [
        "thread lispac-worker", "timer beat", "shown QMainWindow", "QMainWindow"
    ]  # fmt: skip
    del window, timer
    assert find_leaks() == []
