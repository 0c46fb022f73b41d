"""Helpers for tests of the design window: read its values, drag in its views, type into it."""

import time

import numpy as np
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QLineEdit

from lispac.design.prediction import predict
from lispac.gui.features.design.window import DesignWindow
from tests.gui.support import WAIT_MS, Control, Driver, Key, Left

Shift = Qt.KeyboardModifier.ShiftModifier
NoModifier = Qt.KeyboardModifier.NoModifier


def opened_by_keys(driver: Driver) -> DesignWindow:
    """Open the design window with its shortcut; it closes with the main window."""
    driver.bot.keyClick(driver.window, Key.Key_D, Control | Shift)
    window = driver.window.site_design.window
    assert window is not None
    driver.bot.waitUntil(window.isActiveWindow, timeout=WAIT_MS)
    return window


def plan(design: DesignWindow):
    return design.workspace.titled.plan


def wait_for_plan(design: DesignWindow) -> None:
    """Wait until the shown numbers belong to the current plan."""
    began = time.monotonic()
    while design.results.predictor.is_out_of_date:
        QApplication.processEvents()
        assert time.monotonic() - began < WAIT_MS / 1000


def shown(design: DesignWindow) -> list[float]:
    wait_for_plan(design)
    return [float(design.results.sigma[a].text()) for a in ("roll", "pitch", "yaw")]


def predicted(design: DesignWindow) -> list[float]:
    return [round(float(v), 4) for v in np.degrees(predict(plan(design)).sigma)]


def drag(driver: Driver, view, start: QPointF, stop: QPointF, modifier=NoModifier) -> list[str]:
    """Drag with the mouse; return the texts of the roll sigma during the drag."""
    design = driver.window.site_design.window
    first, last = start.toPoint(), stop.toPoint()
    shown_sigmas = []
    driver.bot.mousePress(view, Left, pos=first)
    for share in (0.3, 0.7, 1.0):
        # QTest.mouseMove sends no pressed button.
        at = QPointF(first + (last - first) * share)
        event = mouse_move(view, at, modifier)
        QApplication.sendEvent(view, event)
        wait_for_plan(design)
        shown_sigmas.append(design.results.sigma["roll"].text())
    driver.bot.mouseRelease(view, Left, pos=last)
    return shown_sigmas


def mouse_move(view, at: QPointF, modifier):
    return QMouseEvent(
        QEvent.Type.MouseMove, at, view.mapToGlobal(at), Qt.MouseButton.NoButton, Left, modifier
    )


def wait_until_designed(driver: Driver) -> None:
    runner = driver.window.site_design.runner
    driver.bot.waitUntil(lambda: not runner.active, timeout=WAIT_MS)


def middle_of(view, k: int) -> QPointF:
    first, last = view._line_pixels(k, view._line_ends()[k])
    return (first + last) / 2


def type_cell(driver: Driver, table, row: int, column: int, text: str) -> QLineEdit:
    """Type into a cell and return its editor, which stays open."""
    table.setFocus()
    table.setCurrentCell(row, column)
    driver.bot.keyClick(table, Key.Key_F2)
    editor = table.findChild(QLineEdit)
    editor.selectAll()
    driver.bot.keyClicks(editor, text)
    return editor
