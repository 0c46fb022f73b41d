"""Tests of the log file and of the notifications at the end of long tasks."""

import logging
import threading
import time
import warnings
from pathlib import Path

import pytest
from PySide6.QtCore import qWarning
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from lispac.gui.app.log_file import LogFile
from lispac.gui.app.tasks import Task
from lispac.gui.window import desktop_notifications
from lispac.gui.window.desktop_notifications import DesktopNotifications
from tests.gui.support import WAIT_MS, Driver


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_hidden_errors_and_warnings_are_in_the_log_file(tmp_path: Path) -> None:
    errors: list[BaseException] = []
    before = (threading.excepthook, logging.getLogger("lispac").handlers[:])
    book = LogFile(tmp_path / "made", errors.append)
    book.begin()
    try:
        thread = threading.Thread(target=lambda: 1 / 0)
        thread.start()
        thread.join()
        qWarning("a widget is not happy")
        with warnings.catch_warnings():
            warnings.simplefilter("always")
            logging.captureWarnings(False)
            logging.captureWarnings(True)
            warnings.warn("a library is not happy", stacklevel=1)
        logging.getLogger("lispac").info("Opened harbour")
    finally:
        book.end()
    assert [type(error) for error in errors] == [ZeroDivisionError]
    written = book.file.read_text(encoding="utf-8")
    for words in ("WARNING Qt: a widget", "a library is not happy", "INFO Opened harbour"):
        assert words in written
    assert threading.excepthook is threading.__excepthook__
    assert logging.getLogger("lispac").handlers == before[1]


def test_an_error_is_logged_with_its_origin(tmp_path: Path, driver: Driver) -> None:
    book = LogFile(tmp_path, driver.dialogs.show_error)
    book.begin()
    try:
        driver.window.controller.logged.emit("Opened a project")

        def work(_progress: object) -> None:
            raise KeyError("no such thing")

        driver.window.runner.failed.connect(
            lambda error: logging.getLogger("lispac").error("seen", exc_info=error)
        )
        driver.window.runner.run("Working", work, lambda _value: None)
        driver.rest()
    finally:
        book.end()
    written = book.file.read_text(encoding="utf-8")
    assert "INFO Opened a project" in written
    assert "KeyError: 'no such thing'" in written
    assert "test_gui_logbook.py" in written


def test_an_unwritable_log_folder_is_ignored(tmp_path: Path) -> None:
    (tmp_path / "file").touch()
    book = LogFile(tmp_path / "file", lambda _error: None)
    book.begin()
    logging.getLogger("lispac").info("nowhere")
    book.end()


@pytest.mark.parametrize("ending", ["done", "failed", "cancelled", "short"])
def test_a_notification_reports_the_end_of_a_long_task(
    driver: Driver, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, ending: str
) -> None:
    monkeypatch.setattr(desktop_notifications, "MIN_TASK_S", 30.0 if ending == "short" else 0.05)
    notifications: list[str] = []
    DesktopNotifications(driver.window, driver.window.runner, notifications.append)
    other = QWidget()
    qtbot.addWidget(other)
    other.show()
    other.activateWindow()
    qtbot.waitUntil(other.isActiveWindow, timeout=WAIT_MS)

    def work(progress) -> None:
        time.sleep(0.1)
        if ending == "failed":
            raise ValueError("no")
        progress(0.5, "")

    task: Task = driver.window.runner.run("Working", work, lambda _value: None)
    if ending == "cancelled":
        task.cancel.set()
    driver.rest()
    expected = {"done": ["Working: completed after"], "failed": ["Working: failed after"]}
    assert [words.rpartition(" after")[0] + " after" for words in notifications] == expected.get(
        ending, []
    )


def test_no_notification_is_sent_while_the_window_is_active(
    driver: Driver, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(desktop_notifications, "MIN_TASK_S", 0.0)
    notifications: list[str] = []
    DesktopNotifications(driver.window, driver.window.runner, notifications.append)
    driver.window.runner.run("Working", lambda _progress: None, lambda _value: None)
    driver.rest()
    assert notifications == []
