"""Tests of parts of the window alone: tasks, error dialogues, step status, settings."""

import gc
import json
import threading
import time
import weakref
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QDialog, QLabel, QPushButton
from pytestqt.qtbot import QtBot

from lispac.adjustment.result import PossibleCause
from lispac.errors import Cancelled, InputError
from lispac.gui.app.language import set_language
from lispac.gui.app.settings import AppSettings
from lispac.gui.app.status_bar import TaskStatusBar
from lispac.gui.app.tasks import Task, TaskRunner
from lispac.gui.project import status
from lispac.gui.widgets.error_box import error_box, error_text_and_details
from lispac.language import gettext_lazy
from lispac.messages import warning
from lispac.progress import PointProgress, Progress
from lispac.project import Project
from lispac.workflow.calibration import edits
from tests.gui.support import Demo, finish_layouts
from tests.support.message_codes import is_shown


@pytest.fixture
def runner(qtbot: QtBot):
    made = TaskRunner()
    yield made
    made.close()


def run_without_end(progress: Progress) -> None:
    while True:
        progress(0.5, "going on")
        time.sleep(0.005)


# -- tasks ---------------------------------------------------------------------------------------


def test_work_runs_in_a_worker_and_its_value_arrives_in_the_main_thread(qtbot, runner):
    got = []

    def work(progress):
        progress(0.5, "half")
        return threading.current_thread().name

    runner.run("Work", work, lambda value: got.append((value, threading.current_thread().name)))
    assert runner.busy
    qtbot.waitUntil(lambda: bool(got))
    assert got == [("lispac-worker", "MainThread")]
    assert not runner.active


def test_a_cancelled_task_delivers_no_value(qtbot, runner):
    got = []
    runner.run("Endless", run_without_end, got.append)
    qtbot.waitUntil(lambda: runner.current.step == "going on")
    with qtbot.waitSignal(runner.stopped) as stopped:
        runner.cancel()
    assert stopped.args == ["Endless"]
    assert got == []


def test_no_task_is_running_while_a_dialogue_shows_its_result(qtbot, runner):
    was_busy = []

    def show(_value: int) -> None:
        tasks.append(runner.current)
        dialog = QDialog()
        QTimer.singleShot(50, lambda: (was_busy.append(runner.busy), dialog.accept()))
        dialog.exec()

    tasks: list[Task | None] = []
    runner.changed.connect(lambda: tasks.append(runner.current))
    runner.run("Setting the pages", lambda progress: 1, show, modal=True)
    qtbot.waitUntil(lambda: bool(was_busy))
    assert was_busy == [False]
    first = next(k for k, task in enumerate(tasks) if task is None)
    assert tasks[first:] == [None] * len(tasks[first:])  # reported before the dialogue is shown


def test_a_task_that_ends_behind_a_dialogue_waits_for_it(qtbot, runner):
    got: list[int] = []
    dialog = QDialog()
    results_then = []
    runner.run("Work", lambda progress: 1, got.append, modal=True)
    QTimer.singleShot(400, lambda: (results_then.append(list(got)), dialog.accept()))
    dialog.exec()
    assert results_then == [[]]
    qtbot.waitUntil(lambda: got == [1])


@pytest.mark.parametrize("fails", [False, True])
def test_an_ended_task_keeps_no_data_alive(qtbot, runner, fails):
    """A reference to an ended task keeps no survey alive."""

    class Lines:
        pass

    lines, found, ended = Lines(), Lines(), []
    alive = [weakref.ref(lines), weakref.ref(found)]

    def work(_progress, lines=lines, found=found):
        if fails:
            raise InputError("It cannot be done.")
        return found, lines

    runner.failed.connect(lambda error: ended.append(str(error)))
    kept = runner.run("Work", work, lambda value: ended.append("done"))
    del lines, found, work
    qtbot.waitUntil(lambda: bool(ended))
    qtbot.waitUntil(lambda: not runner.active)
    gc.collect()
    assert [each() for each in alive] == [None, None]
    assert isinstance(kept.error, InputError) == fails


@pytest.mark.parametrize("persistent", [False, True])
def test_a_written_file_counts_as_done_when_cancelled_too_late(qtbot, runner, tmp_path, persistent):
    """Cancel is pressed after the work has ended but before the window is notified."""
    written, ended, got, notices = tmp_path / "line.laz", threading.Event(), [], []
    runner.stopped.connect(lambda title: notices.append(f"{title}: cancelled"))
    runner.cancelled_too_late.connect(notices.append)

    def work(_progress):
        written.write_text("points")
        ended.set()
        return written

    runner.run("Export", work, got.append, persistent=persistent)
    assert ended.wait(10)
    runner.cancel()
    qtbot.waitUntil(lambda: bool(notices))
    late = "Export: completed before it could be cancelled"
    assert notices == [late if persistent else "Export: cancelled"]
    assert got == ([written] if persistent else [])
    assert written.exists()


def test_persistent_work_that_stops_in_time_is_cancelled(qtbot, runner):
    got = []
    runner.run("Export", run_without_end, got.append, persistent=True)
    qtbot.waitUntil(lambda: runner.current.step == "going on")
    with qtbot.waitSignal(runner.stopped):
        runner.cancel()
    assert got == []


def test_a_failed_task_reports_why_and_the_next_one_runs(qtbot, runner):
    def fails(_progress):
        raise InputError("the file is short")

    got = []
    with qtbot.waitSignal(runner.failed) as failed:
        runner.run("Fails", fails, got.append)
        runner.run("Works", lambda _progress: 7, got.append)
    assert str(failed.args[0]) == "the file is short"
    qtbot.waitUntil(lambda: got == [7])


def test_quiet_work_gives_way_and_is_replaced_by_later_work(qtbot, runner):
    got = []
    runner.run("First", run_without_end, got.append, quiet=True, key="count")
    qtbot.waitUntil(lambda: runner.current.step == "going on")
    assert not runner.busy
    runner.run("Second", lambda _progress: 2, got.append, quiet=True, key="count")
    qtbot.waitUntil(lambda: got == [2])
    runner.run("Third", run_without_end, got.append, quiet=True)
    runner.run("Loud", lambda _progress: 3, got.append)
    qtbot.waitUntil(lambda: got == [2, 3])


def test_progress_reaches_the_window_at_most_twenty_times_a_second(qtbot, runner):
    shown = []
    runner.progress_changed.connect(lambda: shown.append(time.monotonic()))

    def chatty(progress):
        end = time.monotonic() + 0.5
        while time.monotonic() < end:
            progress(0.5)

    done = []
    runner.run("Chatty", chatty, done.append)
    qtbot.waitUntil(lambda: bool(done))
    assert len(shown) <= 0.5 * 20 + 4


def test_closing_waits_for_the_worker(qtbot):
    runner = TaskRunner()
    ended = []

    def work(progress):
        try:
            run_without_end(progress)
        except Cancelled:
            ended.append(True)
            raise

    runner.run("Endless", work, lambda _value: None)
    qtbot.waitUntil(lambda: runner.current.step == "going on")
    runner.close()
    assert ended == [True]
    assert "lispac-worker" not in [thread.name for thread in threading.enumerate()]


# -- errors and texts ----------------------------------------------------------------------------


def test_errors_of_libraries_are_in_the_details(qapp):
    try:
        try:
            json.loads("{")
        except ValueError as error:
            raise InputError("a.json: it cannot be read; restore it.") from error
    except InputError as caught:
        box = error_box(None, caught)
    assert box.text() == "a.json: it cannot be read; restore it."
    box.findChild(QPushButton, "copy_details").click()
    assert "JSONDecodeError" in QApplication.clipboard().text()
    box.deleteLater()
    own = error_box(None, InputError("a.las: there is no such file."))
    assert own.findChild(QPushButton, "copy_details") is None
    own.deleteLater()


def test_own_errors_show_their_text_and_other_errors_have_details(qtbot: QtBot, qapp: QApplication):
    assert error_text_and_details(InputError("line 3 is empty")) == ("line 3 is empty", "")
    sentence, details = error_text_and_details(ZeroDivisionError("by zero"))
    assert "Traceback" not in sentence
    assert "ZeroDivisionError: by zero" in details
    box = error_box(None, ZeroDivisionError("by zero"))
    qtbot.addWidget(box)
    box.show()
    box.findChild(QPushButton, "copy_details").click()
    assert "ZeroDivisionError" in qapp.clipboard().text()
    assert box.isVisible()
    box.close()


def test_steps_show_their_status_and_advice(demo: Demo):
    assert status.step_statuses(None, None)[0].sentence == "no project open"
    assert status.step_statuses(demo.project, None)[0].state == "todo"
    start = status.step_statuses(demo.project, demo.survey)
    assert [s.state for s in start] == ["done", "todo", "empty", "empty", "empty"]
    assert "Ctrl" in start[1].advice
    assumed = warning("sbet.zero_rates", file="trajectory.sbet")
    warned = replace(demo.survey, messages=(*demo.survey.messages, assumed))
    assert status.step_statuses(demo.project, warned)[0].state == "warning"
    ready = status.step_statuses(demo.picked, demo.survey)
    assert ready[1].sentence == "2 targets, 1 validation plane"
    assert ready[2].ready
    first = demo.picked.target("T1")
    on_one_line = demo.picked.with_target(replace(first, sightings=first.sightings[:1]))
    assert "fewer than two lines" in status.step_statuses(on_one_line, demo.survey)[1].advice


def test_the_data_are_not_done_while_the_lines_contradict_the_lever_arm(
    demo: Demo, estimated: Project
):
    assert status.step_statuses(estimated, demo.survey)[0].state == "done"
    one = np.ones(1)
    cause = PossibleCause("lever_x", "", "", one, 0.01 * one, np.ones(3), 0.5, 1e4)
    result = replace(estimated.result, causes=((cause,),))
    data = status.step_statuses(replace(estimated, result=result), demo.survey)[0]
    assert data.state == "warning"
    assert is_shown("adjustment.contradicted_lever_x", data.advice)


def test_many_points_are_counted_in_millions():
    assert status.point_count(1_344_882) == "1.3 M points"
    assert status.point_count(447_043) == "447,043 points"


def test_a_step_with_a_serious_warning_is_not_done(demo: Demo, estimated: Project):
    test = estimated.result.chi_square
    passed = replace(test, statistic=0.5 * (test.lower + test.upper))
    estimated = replace(estimated, result=replace(estimated.result, chi_square=passed))
    sound = status.step_statuses(estimated, demo.survey)[2]
    assert sound.state == "done"
    assert "warnings" not in sound.sentence
    size, sigma, moved = np.array([0.1]), np.array([0.004]), estimated.result.sigma * 9
    found = PossibleCause("lever_x", "", "", size, sigma, moved, 0.05, 600.0)
    result = replace(estimated.result, causes=((found,),))
    doubtful = status.step_statuses(replace(estimated, result=result), demo.survey)[2]
    assert doubtful.state == "warning"
    assert doubtful.sentence.startswith("done, with warnings")
    assert "F12" in doubtful.advice


def test_renaming_a_validation_plane_keeps_the_order(demo: Demo):
    renamed = edits.with_renamed_target(demo.picked, "T1", "A")
    assert [t.name for t in renamed.targets] == ["A", "T2", "V1"]
    assert edits.set_target_use(demo.picked, "T1", True) is demo.picked


def test_recent_projects_come_back_newest_first(tmp_path: Path):
    kept = AppSettings(tmp_path / "s.ini")
    for name in ("a", "b", "a"):
        kept.add_recent(tmp_path / name)
    kept.point_size = 4
    kept.sync()
    again = AppSettings(tmp_path / "s.ini")
    assert again.recent() == [tmp_path / "a", tmp_path / "b"]
    assert again.point_size == 4


READING = gettext_lazy("Reading {line}", line="L1")


@pytest.mark.parametrize(
    ("step", "shown"),
    [
        (gettext_lazy("Aligning the lines"), "Aligning the lines  ·  10 s left"),
        (PointProgress(READING, 4_900_000, 20_000_000, 2.1e6),
         "Reading L1: 4.9 M of 20.0 M points, 2.10 M points/s  ·  10 s left"),
        (PointProgress(READING, 4_900_000, 20_000_000),
         "Reading L1: 4.9 M of 20.0 M points  ·  10 s left"),
    ],
)  # fmt: skip
def test_time_left_is_shown_once_and_counts_for_the_whole_task(qtbot: QtBot, step, shown):
    bar = TaskStatusBar()
    qtbot.addWidget(bar)
    task = Task("Import", lambda progress: None, lambda value: None)
    task.started = time.monotonic() - 10
    task.report(0.5, step)
    bar.show_task(task)
    assert bar.text.text() == shown


def test_a_message_stays_alone_when_the_height_of_the_status_bar_changes(qtbot: QtBot) -> None:
    bar = TaskStatusBar()
    qtbot.addWidget(bar)
    bar.point.setText("Line L1")
    bar.show()
    bar.showMessage("T1: found in 6 of 6 lines")
    higher = QLabel("6 notes")
    higher.setFixedHeight(2 * bar.height())
    bar.addPermanentWidget(higher)
    finish_layouts()
    assert not bar.point.isVisible()
    bar.clearMessage()
    assert bar.point.isVisible()


def test_a_longer_text_has_its_width_before_the_progress_is_painted(qtbot: QtBot) -> None:
    bar = TaskStatusBar()
    qtbot.addWidget(bar)
    bar.resize(1366, 30)
    bar.show()
    task = Task("Import", lambda progress: None, lambda value: None)
    for step in ("Reading", "Computing the points of all lines with the estimated boresight"):
        task.report(task.fraction + 0.1, step)
        bar.show_task(task)  # no event is processed afterwards
        assert bar.text.width() >= bar.text.sizeHint().width()
        assert not bar.text.geometry().intersects(bar.bar.geometry())


def test_no_time_left_is_shown_before_it_is_dependable(qtbot: QtBot) -> None:
    bar = TaskStatusBar()
    qtbot.addWidget(bar)
    task = Task("Import", lambda progress: None, lambda value: None)
    for elapsed, fraction, is_visible in (
        (0.0, 0.0, False), (1.0, 0.1, False), (6.0, 0.01, False), (8.0, 0.4, False),
        (20.0, 0.6, False), (42.0, 0.9, True), (80.0, 0.91, False),
    ):  # fmt: skip
        task.started = time.monotonic() - elapsed
        task.report(fraction)
        bar.show_task(task)
        assert ("left" in bar.text.text()) == is_visible, elapsed
    task.report(0.2)
    assert task.fraction == 0.91
    task.started -= 40  # without a report
    bar.show_task(task)
    assert "left" not in bar.text.text()


def test_time_left_is_french_after_an_untranslated_name(qtbot: QtBot) -> None:
    bar = TaskStatusBar()
    qtbot.addWidget(bar)
    task = Task("Adjusting", lambda progress: None, lambda value: None)
    task.started = time.monotonic() - 10
    task.report(0.5, gettext_lazy("Reading {line}", line="Sud"))
    set_language("fr")
    try:
        bar.show_task(task)
    finally:
        set_language("en")
    shown = "Lecture de Sud  ·  encore 10 s"
    assert bar.text.text().replace("\u202f", " ").replace("\u00a0", " ") == shown
