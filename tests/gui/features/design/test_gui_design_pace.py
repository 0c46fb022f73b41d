"""Tests that the design window stays responsive with a large plan."""

import time

from PySide6.QtCore import QPointF, Qt, QTimer
from PySide6.QtWidgets import QApplication

from lispac.design.objective import PlanObjective
from lispac.design.plan_search import information_gains
from lispac.gui.appearance.message_texts import message_text
from lispac.gui.features.design import edits
from lispac.gui.features.design.window import DesignWindow
from lispac.workflow.planning.plan_checks import plan_warnings
from tests.gui.design_support import NoModifier, mouse_move, plan, predicted, shown, wait_for_plan
from tests.gui.support import WAIT_MS, Control, Driver, Key, Left

MAX_PAUSE_MS = 200
"""Limit for the window's thread; the prediction for 12 lines and 4 targets takes a second."""


class Heartbeat:
    """Longest computing time of the window's thread without a return to its event loop, ms.

    It is processor time of the thread, so other programs do not affect it.
    """

    def __init__(self, parent) -> None:
        self._timer = QTimer(parent, interval=5, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self._beat)
        self._last, self.longest = time.thread_time(), 0.0
        self._timer.start()

    def _beat(self) -> None:
        now = time.thread_time()
        self.longest = max(self.longest, 1000 * (now - self._last))
        self._last = now


def test_a_large_plan_is_predicted_without_blocking_the_window(
    driver: Driver, design: DesignWindow
) -> None:
    for _ in range(6):
        driver.bot.keyClick(design, Key.Key_D, Control)
    for _ in range(2):
        driver.bot.keyClick(design, Key.Key_B, Control)
    assert (len(plan(design).lines), len(plan(design).targets)) == (12, 4)
    predictor = design.results.predictor
    heart = Heartbeat(design)
    driver.bot.waitUntil(lambda: not predictor.active, timeout=WAIT_MS)
    assert heart.longest < MAX_PAUSE_MS
    assert shown(design) == predicted(design)
    rows = design.results.gain_table
    best = information_gains(plan(design), PlanObjective())[0]
    assert (rows.rowCount(), rows.item(0, 0).text()) == (16, best.name)


def test_an_edit_cancels_the_running_prediction(driver: Driver, design: DesignWindow) -> None:
    for _ in range(6):
        driver.bot.keyClick(design, Key.Key_D, Control)
    predictor = design.results.predictor
    driver.bot.waitUntil(lambda: predictor._slow is not None, timeout=WAIT_MS)
    slow = predictor._slow
    driver.bot.keyClick(design.plan_view, Key.Key_Up)
    assert slow.cancel.is_set()
    assert shown(design) == predicted(design)
    driver.bot.waitUntil(lambda: predictor.messages_current, timeout=WAIT_MS)
    predictor.out_of_date.emit()
    assert "Least precisely determined" in design.results.messages.text(), (
        "said, and not taken back"
    )
    driver.bot.waitUntil(lambda: not predictor.active, timeout=WAIT_MS)
    assert design.results.gain_table.rowCount() == 14


def test_sigmas_follow_a_drag_before_it_ends(driver: Driver, design: DesignWindow) -> None:
    view = design.wall_view
    spot = view._target_rect(edits.placed_targets(design.workspace.titled)[0]).center()
    before = shown(design)
    driver.bot.mousePress(view, Left, pos=spot.toPoint())
    QApplication.sendEvent(view, mouse_move(view, spot + QPointF(0, -80), NoModifier))
    wait_for_plan(design)
    assert design.workspace.is_dragging
    assert shown(design) == predicted(design) != before
    driver.bot.mouseRelease(view, Left, pos=spot.toPoint())


def test_a_plan_that_cannot_be_surveyed_is_reported(driver: Driver, design: DesignWindow) -> None:
    label = design.results.warnings
    assert not label.isVisible()
    view = design.plan_view
    view.setFocus()
    for _ in range(3):
        driver.bot.keyClick(view, Key.Key_PageDown)  # line 4, 225 deg
    for _ in range(10):
        driver.bot.keyClick(view, Key.Key_Down)
    assert plan(design).lines[3].distance == 5.0
    # Abeam of the middle, the line is 5 cos 45 = 3.54 m from the wall. It continues straight to 5 m
    # beyond its last target, which is 0.8 cos 45 m farther on: 5.57 cos 45 = 3.94 m nearer.
    (found,) = plan_warnings(design.workspace.titled)
    assert (found.code, found.params["line"]) == ("plan.line_through_wall", 4)
    assert label.text() == message_text(found)
    assert "0.4 m" in label.text()
    driver.bot.keyClick(design, Key.Key_Z, Control)
    assert not label.isVisible()
    wall = design.wall_view
    wall.setFocus()
    for _ in range(10):
        driver.bot.keyClick(wall, Key.Key_Right)
    (found,) = plan_warnings(design.workspace.titled)
    assert found.code == "plan.targets_overlap"
    assert label.text() == message_text(found)
