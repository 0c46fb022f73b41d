"""Tests of the check of the signs of roll and pitch, in the import and from a message."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from matplotlib.figure import Figure
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtWidgets import QLabel, QPushButton
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
from tests.gui.support import (
    WAIT_MS,
    Control,
    Driver,
    Key,
    Left,
    click,
    press,
    use_next_dialog,
    wait_until_idle,
)

ACTION = Action("check_sign", {"name": "pitch"})
UNCHECKED = warning("sbet.zero_rates", actions=[ACTION], file="t.sbet")


def while_open(qtbot: QtBot, read: Callable[[SignCheckDialog], None]) -> None:
    """Read the next dialogue of the signs once its figure is drawn, and close it."""

    def read_drawn(dialog: SignCheckDialog) -> None:
        qtbot.waitUntil(lambda: not dialog.canvas.is_drawing)
        read(dialog)

    use_next_dialog(read_drawn)


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
    while_open(qtbot, lambda dialog: seen.append(curves(dialog)))
    qtbot.mouseClick(button, Left)
    ((roll, pitch, _heading),) = seen
    attitude = np.degrees(filled.input_files.trajectory_content.attitude)
    # The program's pitch is positive bow down, the curve bow up
    for curve, values in ((roll, attitude[:, 0]), (pitch, -attitude[:, 1])):
        np.testing.assert_allclose(
            [np.nanmin(curve), np.nanmax(curve)], [values.min(), values.max()], atol=1e-9
        )
    field = filled.file_page.options.fields["pitch"]
    # Of the dialogue: without a window manager no window may be active when one is closed
    qtbot.waitUntil(lambda: filled.focusWidget() is field, timeout=WAIT_MS)
    assert not field.view().isVisible(), "the list covers nothing"


def test_a_message_shows_the_attitude_of_the_survey(opened: Driver) -> None:
    opened.bot.waitUntil(lambda: opened.window.warning_list.is_current, timeout=WAIT_MS)
    opened.window.warnings.show_warnings([UNCHECKED])
    press(opened, Key.Key_F12)
    seen: list[tuple[list[np.ndarray], str]] = []

    def read(dialog: SignCheckDialog) -> None:
        texts = " ".join(label.text() for label in dialog.findChildren(QLabel))
        seen.append((curves(dialog), texts))

    while_open(opened.bot, read)
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


def open_from_message(driver: Driver) -> None:
    """Open the dialogue by the button of a message."""
    driver.bot.waitUntil(lambda: driver.window.warning_list.is_current, timeout=WAIT_MS)
    driver.window.warnings.show_warnings([UNCHECKED])
    press(driver, Key.Key_F12)
    click(driver, driver.window.warnings.findChild(QPushButton, "message_check_sign"))


def attitude(driver: Driver) -> np.ndarray:
    return driver.window.document.survey.trajectory.attitude


def test_a_reversed_curve_corrects_the_sign_in_the_project(adjusted: Driver) -> None:
    before, result = attitude(adjusted).copy(), adjusted.project.result
    reading = adjusted.project.trajectory_reading
    seen: list[list[np.ndarray]] = []

    def reverse_roll(dialog: SignCheckDialog) -> None:
        assert not dialog.change.isEnabled()
        seen.append(curves(dialog))
        box = dialog.reversals["roll"]
        adjusted.bot.mouseClick(box, Left, pos=QPoint(10, box.height() // 2))
        seen.append(curves(dialog))
        adjusted.bot.mouseClick(dialog.change, Left)

    while_open(adjusted.bot, reverse_roll)
    open_from_message(adjusted)
    wait_until_idle(adjusted)
    (roll, pitch, _heading), (turned, same, _) = seen
    # A curve is thinned to the extremes of each interval, which change places
    assert (np.nanmin(turned), np.nanmax(turned)) == (-np.nanmax(roll), -np.nanmin(roll))
    np.testing.assert_allclose(same, pitch)
    # The attitude is relative to the local frame, whose vertical differs by 1e-5 rad
    np.testing.assert_allclose(attitude(adjusted), before * [-1.0, 1.0, 1.0], rtol=0, atol=1e-4)
    assert dict(adjusted.project.trajectory_reading.options)["roll"] == "port-down"
    assert adjusted.project.result is None
    assert [t.name for t in adjusted.project.targets] == ["T1", "T2", "V1"]
    undo = adjusted.window.actions_["undo"].text().replace("&", "")
    assert undo == "Undo change of the sign of roll"
    press(adjusted, Key.Key_Z, Control)
    wait_until_idle(adjusted)
    assert adjusted.project.trajectory_reading == reading
    assert adjusted.project.result is result
    np.testing.assert_array_equal(attitude(adjusted), before)


def test_signs_of_a_project_with_georeferenced_lines_cannot_be_changed(opened: Driver) -> None:
    first, *others = opened.project.lines
    reading = replace(first.reading, options=(("frame", "georeferenced"),))
    project = replace(opened.project, lines=(replace(first, reading=reading), *others))
    opened.window.document.open(project, opened.window.document.survey)
    seen: list[tuple[bool, str]] = []

    def read(dialog: SignCheckDialog) -> None:
        texts = " ".join(label.text() for label in dialog.findChildren(QLabel))
        seen.append((dialog.findChild(QPushButton, "change_signs") is None, texts))

    while_open(opened.bot, read)
    open_from_message(opened)
    ((has_no_button, texts),) = seen
    assert has_no_button
    assert "georeferenced" in texts
    assert opened.project is project


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
