"""Tests of the check of the signs of roll and pitch, in the import and from a message."""

from collections.abc import Callable

import numpy as np
import pytest
from matplotlib.figure import Figure
from PySide6.QtCore import QRect, Qt, QTimer
from PySide6.QtWidgets import QApplication, QLabel, QPushButton
from pytestqt.qtbot import QtBot

from lispac.gui.features.open_project.import_survey.import_dialog import ImportDialog
from lispac.gui.features.open_project.import_survey.quality_figures import (
    AttitudeRecord,
    draw_signs,
)
from lispac.gui.features.open_project.import_survey.sign_check_dialog import SignCheckDialog
from lispac.gui.features.warnings.warnings_panel import ACTION_LINE, BUTTON_GAP_PX
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
    button = opened.window.warnings.findChild(QPushButton, "message_check_sign")
    messages = opened.window.warnings.list
    text = messages.item(0).text().removesuffix(f"\n{ACTION_LINE}")
    width = messages.viewport().width() - messages.iconSize().width()
    lines = messages.fontMetrics().boundingRect(
        QRect(0, 0, width, 1000), Qt.TextFlag.TextWordWrap, text
    )
    room = messages.visualItemRect(messages.item(0)).height() - lines.height()
    assert room >= button.height() + BUTTON_GAP_PX // 2, "the button is below the text"
    click(opened, button)
    (((roll, pitch, _heading), texts),) = seen
    attitude = np.degrees(opened.window.document.survey.trajectory.attitude)
    for curve, values in ((roll, attitude[:, 0]), (pitch, -attitude[:, 1])):
        np.testing.assert_allclose(
            [np.nanmin(curve), np.nanmax(curve)], [values.min(), values.max()], atol=1e-9
        )
    assert "starboard" in texts
    assert "residuals" in texts


@pytest.mark.parametrize("ends_deg", [(10.0, -800.0), (700.0, 20.0)], ids=["three", "two"])
def test_a_heading_of_several_turns_has_readable_ticks(ends_deg: tuple[float, float]) -> None:
    time = np.linspace(0.0, 100.0, 2001)
    attitude = np.zeros((len(time), 3))
    turned = np.radians(np.linspace(*ends_deg, len(time)))
    attitude[:, 2] = np.arctan2(np.sin(turned), np.cos(turned))
    record = AttitudeRecord(time=time, attitude=attitude, longest_gap=1.0, axis="s", lines=())
    figure = Figure()
    draw_signs(record, figure)
    axes = figure.axes[2]
    low, high = axes.get_ylim()
    ticks = [tick for tick in axes.get_yticks() if low <= tick <= high]
    assert ticks == [0, 90, 180, 270, 360]
    degrees = np.degrees(attitude[:, 2]) % 360
    (curve,) = axes.lines
    drawn_time, drawn = curve.get_data()
    for moment in (7.3, 41.0, 88.8):
        near = abs(drawn_time - moment) < 0.06
        expected = degrees[np.argmin(abs(time - moment))]
        assert drawn[near] == pytest.approx(expected, abs=1.0)
    joined = np.isfinite(np.diff(drawn))
    assert abs(np.diff(drawn)[joined]).max() < 2.0, "no line across the axis at north"
    assert (np.diff(drawn_time)[joined] > 0).all(), "and none back to an earlier time"
