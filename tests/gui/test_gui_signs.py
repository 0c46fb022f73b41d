"""Tests of the check of the signs of roll and pitch, in the import and from a message."""

from collections.abc import Callable

import numpy as np
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QLabel, QPushButton
from pytestqt.qtbot import QtBot

from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from lispac.gui.features.open_project.import_survey.sign_check_dialog import SignCheckDialog
from lispac.messages import Action, warning
from tests.gui.import_support import rest
from tests.gui.support import WAIT_MS, Driver, Key, Left, click, press

ACTION = Action("check_sign", {"name": "pitch"})
UNCHECKED = warning("sbet.zero_rates", actions=[ACTION], file="t.sbet")


def while_open(read: Callable[[SignCheckDialog], None]) -> None:
    """Read the next dialogue of the signs once it is drawn, and close it with Escape."""

    def poll() -> None:
        dialog = QApplication.activeModalWidget()
        if not isinstance(dialog, SignCheckDialog) or dialog.canvas.is_drawing:
            QTimer.singleShot(50, poll)
            return
        try:
            read(dialog)
        finally:
            dialog.reject()

    poll()


def curves(dialog: SignCheckDialog) -> list[np.ndarray]:
    """Values of the curve of each axis; the first line of the signed angles marks zero."""
    return [axes.lines[-1].get_ydata() for axes in dialog.canvas.figure.axes]


def test_the_import_shows_the_attitude_and_then_the_option(
    filled: ImportDialog, qtbot: QtBot
) -> None:
    path = filled.input_files.trajectory.path
    filled.table.select(path)
    rest(qtbot, filled)
    filled.file_page.messages.show_messages([UNCHECKED], "")
    (button,) = filled.file_page.messages.buttons
    seen: list[list[np.ndarray]] = []
    while_open(lambda dialog: seen.append(curves(dialog)))
    qtbot.mouseClick(button, Left)
    ((roll, pitch, _heading),) = seen
    attitude = np.degrees(filled.input_files.trajectory_content.attitude)
    # The program's pitch is positive bow down, the curve bow up
    for curve, values in ((roll, attitude[:, 0]), (pitch, -attitude[:, 1])):
        np.testing.assert_allclose(
            [np.nanmin(curve), np.nanmax(curve)], [values.min(), values.max()], atol=1e-9
        )
    field = filled.file_page.options.fields["pitch"]
    assert field.hasFocus()
    assert not field.view().isVisible(), "the list covers nothing"


def test_a_message_shows_the_attitude_of_the_survey(opened: Driver) -> None:
    opened.bot.waitUntil(lambda: opened.window.warning_list.is_current, timeout=WAIT_MS)
    opened.window.warnings.show_warnings([UNCHECKED])
    press(opened, Key.Key_F12)
    seen: list[tuple[list[np.ndarray], str]] = []

    def read(dialog: SignCheckDialog) -> None:
        texts = " ".join(label.text() for label in dialog.findChildren(QLabel))
        seen.append((curves(dialog), texts))

    while_open(read)
    click(opened, opened.window.warnings.findChild(QPushButton, "message_check_sign"))
    (((roll, pitch, _heading), texts),) = seen
    attitude = np.degrees(opened.window.document.survey.trajectory.attitude)
    for curve, values in ((roll, attitude[:, 0]), (pitch, -attitude[:, 1])):
        np.testing.assert_allclose(
            [np.nanmin(curve), np.nanmax(curve)], [values.min(), values.max()], atol=1e-9
        )
    assert "starboard" in texts
    assert "residuals" in texts
