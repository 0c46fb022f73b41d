"""What a test of the window left behind: threads, timers, windows and graphics."""

import gc
import sys
import threading

import shiboken6
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QWidget


def left_behind() -> list[str]:
    """Name what lives on of what was made since `gc.freeze`, once garbage has been collected."""
    made = gc.get_objects()
    windows = [each for each in made if isinstance(each, QWidget) and _is_window(each)]
    timers = [each for each in made if isinstance(each, QTimer) and shiboken6.isValid(each)]
    shown = [each for each in QApplication.topLevelWidgets() if each.isVisible()]
    return [
        *(f"thread {each.name}" for each in threading.enumerate() if _is_ours(each)),
        *(f"timer {each.objectName()}" for each in timers if each.isActive()),
        *(f"window {type(each).__name__}" for each in windows),
        *(f"shown {type(each).__name__}" for each in shown),
        *(f"graphics {type(each).__name__}" for each in made if isinstance(each, _graphics())),
    ]


def _is_window(each: QWidget) -> bool:
    try:
        return each.isWindow()
    except RuntimeError:  # Qt has deleted it; what Python holds of it matters all the same
        return True


def _is_ours(thread: threading.Thread) -> bool:
    return thread.name.startswith("lispac")


def _graphics() -> tuple[type, ...]:
    rendering = sys.modules.get("vtkmodules.vtkRenderingCore")
    return () if rendering is None else (rendering.vtkRenderWindow, rendering.vtkRenderer)
