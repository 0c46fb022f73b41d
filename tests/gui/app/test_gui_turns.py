"""Tests of `IdleTask`: events are processed between tasks that are due together."""

import itertools

from PySide6.QtCore import QObject, QTimer
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from lispac.gui.widgets.idle_tasks import IdleTask
from tests.gui.support import WAIT_MS


def test_tasks_due_together_run_in_separate_event_loop_iterations(
    qapp: QApplication, qtbot: QtBot
) -> None:
    owner, done = QObject(), []
    turns = [IdleTask(lambda k=k: done.append(k), owner) for k in range(3)]
    beat = QTimer(owner, interval=0)
    beat.timeout.connect(lambda: done.append("beat"))
    beat.start()
    for each in turns:
        each.start()
    qtbot.waitUntil(lambda: set(done) >= {0, 1, 2}, timeout=WAIT_MS)
    beat.stop()
    acted = [k for k, each in enumerate(done) if each != "beat"]
    assert [done[k] for k in acted] == [0, 1, 2]
    assert all("beat" in done[one:other] for one, other in itertools.pairwise(acted))
    assert not any(each.isActive() for each in turns)


def test_a_postponed_task_has_its_full_delay_the_next_time(
    qapp: QApplication, qtbot: QtBot
) -> None:
    owner, done = QObject(), []
    first, second = (IdleTask(lambda name=name: done.append(name), owner, 40) for name in "ab")
    first.start()
    second.start()
    qtbot.waitUntil(lambda: done == ["a", "b"], timeout=WAIT_MS)
    second.start()
    assert second.remainingTime() > 0
    second.stop()
    qtbot.wait(80)
    assert done == ["a", "b"]
