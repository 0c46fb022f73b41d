"""Search for resources leaked by a test of the window: threads, timers, windows, graphics."""

import gc
import sys
import threading
import time

import shiboken6
from PySide6.QtCore import QCoreApplication, QEvent, QTimer
from PySide6.QtWidgets import QApplication, QDialog, QMainWindow

SETTLING_S = 1.0
"""Time for single-shot timers and ending threads to finish."""


def find_leaks() -> list[str]:
    """Names of objects that were created since `gc.freeze` and still exist after a short wait."""
    leaks = _leaked()
    until = time.monotonic() + SETTLING_S  # one search may take that long on a busy machine
    while leaks and time.monotonic() < until:
        time.sleep(0.01)
        QCoreApplication.processEvents()
        leaks = _leaked()
    return leaks


def _leaked() -> list[str]:
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    gc.collect()
    # Windows deleted by Qt count too: their Python objects still hold points and graphics
    kinds = (QTimer, QMainWindow, QDialog, *_graphics())
    found = [each for each in gc.get_objects() if isinstance(each, kinds)]
    shown = [each for each in QApplication.topLevelWidgets() if each.isVisible()]
    return [
        *(f"thread {each.name}" for each in threading.enumerate() if _is_ours(each)),
        *(f"timer {each.objectName()}" for each in found if _is_running_timer(each)),
        *(f"shown {type(each).__name__}" for each in shown),
        *(type(each).__name__ for each in found if not isinstance(each, QTimer)),
    ]


def _is_ours(thread: threading.Thread) -> bool:
    return thread.name.startswith("lispac")


def _is_running_timer(each: object) -> bool:
    return isinstance(each, QTimer) and shiboken6.isValid(each) and each.isActive()


def _graphics() -> tuple[type, ...]:
    rendering = sys.modules.get("vtkmodules.vtkRenderingCore")
    return () if rendering is None else (rendering.vtkRenderWindow, rendering.vtkRenderer)
