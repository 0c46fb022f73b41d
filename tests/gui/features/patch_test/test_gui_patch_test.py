"""Tests of the patch test panel by mouse and keys."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QSize, Qt
from PySide6.QtWidgets import QListWidget, QScrollArea, QSlider, QStyle, QStyleOptionSlider

from lispac.gui.app.unavailable import Unavailable
from lispac.gui.features.patch_test.angles import SLIDER_STEP_DEG
from lispac.gui.features.patch_test.panel import EMPTY_TEXT, PatchTestPanel
from lispac.gui.features.patch_test.pictures import CurvePicture
from lispac.project import Project
from tests.gui.support import (
    Control,
    Demo,
    Driver,
    Key,
    Left,
    click,
    finish_layouts,
    press,
    type_into,
    wait_until_idle,
)
from tests.support.message_codes import is_shown

ROLL, PITCH, YAW = range(3)


def panel(driver: Driver) -> PatchTestPanel:
    return driver.window.panels["patch_test"]


def opened_panel(driver: Driver) -> PatchTestPanel:
    """Open the panel with its shortcut and return it."""
    press(driver, Key.Key_T, Control)
    assert panel(driver).isVisible()
    return panel(driver)


def wait_for_curve(driver: Driver) -> None:
    """Wait until the curve belongs to the current angles."""
    patch_test_controller = driver.window.panel_controllers["patch_test"]
    driver.bot.waitUntil(lambda: not patch_test_controller.is_curve_pending, timeout=60_000)
    driver.rest()


def drag(driver: Driver, slider: QSlider, value: int) -> None:
    """Drag the handle of a slider to a value, as near as pixels allow."""
    option = QStyleOptionSlider()
    slider.initStyleOption(option)
    handle = slider.style().subControlRect(
        QStyle.ComplexControl.CC_Slider, option, QStyle.SubControl.SC_SliderHandle, slider
    )
    travel = slider.width() - handle.width()
    share = (value - slider.minimum()) / (slider.maximum() - slider.minimum())
    end = QPoint(round(share * travel + 0.5 * handle.width()), handle.center().y())
    driver.bot.mousePress(slider, Left, pos=handle.center())
    driver.bot.mouseMove(slider, end)
    driver.bot.mouseRelease(slider, Left, pos=end)


def tick(driver: Driver, made: QListWidget, row: int) -> None:
    """Click the check box of a row."""
    made.scrollToItem(made.item(row))
    place = made.visualItemRect(made.item(row))
    driver.bot.mouseClick(made.viewport(), Left, pos=QPoint(place.left() + 10, place.center().y()))


def test_the_panel_shows_instructions_while_it_is_empty(opened: Driver) -> None:
    shown = opened_panel(opened)
    assert shown.text_label.isVisible()
    assert shown.text_label.text() == EMPTY_TEXT
    assert not shown.all.isEnabled()
    assert not shown.angles.isEnabled()
    needs_object = (shown.all, shown.go, shown.remove, shown.prior, shown.save_button)
    assert all(Unavailable.NO_OBJECT.text in button.toolTip() for button in needs_object)
    assert Unavailable.NO_OBJECT.text not in shown.propose.toolTip()
    assert shown.propose.isEnabled()
    assert shown.pairs.count() == 15
    assert shown.pairs.item(0).text().startswith("⇄ ")
    assert shown.pairs.item(0).toolTip() == "reciprocal lines"


def test_the_minimum_of_the_curve_is_the_optimised_angle(opened: Driver) -> None:
    window, shown = opened.window, opened_panel(opened)
    click(opened, shown.propose)
    opened.rest()
    assert shown.picture.isVisible()
    assert shown.objects.count() > 10
    click(opened, shown.all)
    opened.rest()
    result = window.panel_controllers["patch_test"].last_result
    assert result is not None
    assert result.sigma is not None
    assert window.panel_windows["Patch test"].width() <= 830
    area = shown.findChild(QScrollArea)
    assert area.verticalScrollBar().maximum() == area.horizontalScrollBar().maximum() == 0
    assert shown.picture.mapTo(shown, QPoint()).y() > shown.go.mapTo(shown, QPoint()).y()
    own_window = window.panel_windows["Patch test"]
    size = own_window.size()
    for narrow in (QSize(456, 640), size):  # beside the view at 1366 x 768, and as it was
        own_window.resize(narrow)
        finish_layouts()
        assert area.verticalScrollBar().maximum() == area.horizontalScrollBar().maximum() == 0
        for part in (*shown.angles.result_labels, *shown.angles.find_buttons, shown.all):
            assert part.height() >= part.sizeHint().height()
    assert "result" in shown.angles.result_labels[PITCH].text()
    assert is_shown("patch_test.basis", shown.message_label.text())
    truth = np.radians(opened.project.truth_deg)
    assert (np.abs(result.boresight - truth) < 3 * result.sigma).all()

    assert opened.project.alternative_result("patch test") is None
    click(opened, shown.save_button)
    kept = opened.project.alternative_result("patch test")
    assert kept is not None
    np.testing.assert_array_equal(kept.boresight, result.boresight)
    press(opened, Key.Key_Z, Control)
    assert opened.project.alternative_result("patch test") is None

    # Plot the curve of all ticked objects: the minimum of a single object differs.
    shown.of.setCurrentIndex(1)
    start = result.boresight + [0.0, np.radians(0.15), 0.0]
    shown.angles.set_angles(start)
    slider = shown.angles.sliders[PITCH]  # its middle is the found angle
    drag(opened, slider, 80)
    wait_for_curve(opened)
    lowest = shown.curve.minimum
    assert lowest is not None
    assert shown.angles.boresight[PITCH] != start[PITCH], "the drag turned nothing"
    drag(opened, slider, round(np.degrees(lowest - result.boresight[PITCH]) / SLIDER_STEP_DEG))
    wait_for_curve(opened)
    assert shown.angles.boresight[PITCH] != start[PITCH]
    assert abs(shown.angles.boresight[PITCH] - result.boresight[PITCH]) < result.sigma[PITCH]
    # A click into the curve also sets the angle
    place = shown.curve.place(lowest, 0.001).toPoint()
    opened.bot.mouseClick(shown.curve, Left, pos=place)
    wait_for_curve(opened)
    turned = shown.angles.boresight
    assert abs(turned[PITCH] - result.boresight[PITCH]) < result.sigma[PITCH]
    assert (turned[[ROLL, YAW]] == start[[ROLL, YAW]]).all()
    assert shown.angles.fields[PITCH].value() == pytest.approx(np.degrees(turned[PITCH]))

    # The button for a single angle finds the same minimum.
    click(opened, shown.angles.find_buttons[PITCH])
    opened.rest()
    alone = shown.angles.boresight
    assert abs(alone[PITCH] - result.boresight[PITCH]) < 0.2 * result.sigma[PITCH]
    assert "mismatch is smallest" in shown.message_label.text()


def test_the_angles_are_compared_with_those_of_the_adjustment(
    demo: Demo, estimated: Project, driver: Driver
) -> None:
    driver.window.document.open(estimated, demo.survey)
    wait_until_idle(driver)
    shown = opened_panel(driver)
    click(driver, shown.propose)
    driver.rest()
    click(driver, shown.all)
    driver.rest()
    result = driver.window.panel_controllers["patch_test"].last_result
    assert estimated.result is not None
    difference = np.degrees(result.boresight - estimated.result.boresight)
    text = shown.message_label.text()
    texts = [f"{angle:+.4f}".replace("-", "\N{MINUS SIGN}") for angle in difference]
    assert all(each in text for each in texts)
    driver.window.document.edit("boresight", replace(estimated, result=None))
    assert texts[0] not in shown.message_label.text()


@pytest.mark.parametrize("depth", [0.01, 0.095])
def test_the_label_of_the_minimum_does_not_cover_the_curve(qapp, depth: float) -> None:
    """A shallow minimum lies high in the picture, and its label then below the curve."""
    curve = CurvePicture()
    curve.resize(400, 160)
    angles = np.radians(np.linspace(-3.0, 3.0, 121))
    curve.show_curve("Roll", angles, 0.1 - depth * np.exp(-((angles / np.radians(0.5)) ** 2)))
    lowest = curve.minimum
    top = curve._label_top(lowest)
    height = curve.place(lowest, 0.1 - depth).y()
    assert not top - 4 <= height <= top + 20


def test_keys_change_the_angles_and_another_choice_clears_the_result(opened: Driver) -> None:
    shown = opened_panel(opened)
    click(opened, shown.propose)
    opened.rest()
    before = {line: points.copy() for line, points in shown.picture.drawn.items()}
    assert len(before) >= 2
    slider = shown.angles.sliders[ROLL]
    slider.setFocus()
    opened.bot.keyClick(slider, Key.Key_Right)
    assert np.degrees(shown.angles.boresight[ROLL]) == pytest.approx(0.001)
    opened.bot.keyClick(slider, Key.Key_PageUp)
    assert np.degrees(shown.angles.boresight[ROLL]) == pytest.approx(0.011)
    moved = shown.picture.drawn
    assert any(np.abs(moved[line] - before[line]).max() > 1e-4 for line in before)
    type_into(opened, shown.angles.fields[YAW], "0.5")
    assert np.degrees(shown.angles.boresight[YAW]) == pytest.approx(0.5)
    assert slider.value() == 11
    assert shown.angles.sliders[YAW].value() == 500
    click(opened, shown.prior)
    assert (shown.angles.boresight == 0).all()
    np.testing.assert_allclose(
        shown.picture.drawn[next(iter(before))], before[next(iter(before))], atol=1e-9
    )

    # another choice of objects or pairs of lines clears the result
    click(opened, shown.angles.find_buttons[ROLL])
    opened.rest()
    assert "mismatch is smallest" in shown.message_label.text()
    tick(opened, shown.objects, 0)
    assert shown.objects.item(0).checkState() == Qt.CheckState.Unchecked
    assert shown.message_label.text() == ""
    many = len(shown.ticked_entries)
    assert many == shown.objects.count() - 1
    for row in range(shown.pairs.count()):
        tick(opened, shown.pairs, row)
    assert not shown.ticked_pairs
    click(opened, shown.all)
    opened.rest()
    assert opened.dialogs.errors[-1].code == "patch_test.no_pairs"


def test_user_defined_boxes_are_added_shown_and_removed(opened: Driver) -> None:
    window, shown = opened.window, opened_panel(opened)
    click(opened, shown.target)
    opened.rest()
    assert "Select a target" in window.log.toPlainText()
    click(opened, shown.box)
    assert "Switch on the clip box" in window.log.toPlainText()
    line = window.document.survey.lines[0]
    points = opened.viewport.clouds[line]
    high = int(np.abs(points - [32.0, -24.5, 36.0]).sum(axis=1).argmin())
    click(opened, shown.point)
    assert opened.viewport.mouse_mode == "point"
    opened.viewport.point_at(line, high)
    opened.rest()
    assert opened.viewport.mouse_mode == "navigate"
    assert [shown.objects.item(0).text(), shown.objects.count()] == ["H1", 1]
    assert opened.viewport.sketches["patch"].label == "H1"
    shown.window().close()
    assert "patch" not in opened.viewport.sketches, "the box is hidden with the panel"
    assert opened_panel(opened) is shown
    assert opened.viewport.sketches["patch"].label == "H1"
    click(opened, shown.go)
    press(opened, Key.Key_X)
    click(opened, shown.box)
    opened.rest()
    assert [shown.objects.item(k).text() for k in range(2)] == ["H1", "H2"]
    click(opened, shown.remove)
    opened.rest()
    while shown.objects.count():
        click(opened, shown.remove)
        opened.rest()
    assert shown.text_label.isVisible()
    assert "patch" not in opened.viewport.sketches


def test_an_object_added_with_the_key_opens_the_panel(opened: Driver) -> None:
    line = opened.window.document.survey.lines[0]
    points = opened.viewport.clouds[line]
    high = int(np.abs(points - [32.0, -24.5, 36.0]).sum(axis=1).argmin())
    press(opened, Key.Key_T, Control | Qt.KeyboardModifier.ShiftModifier)
    opened.viewport.point_at(line, high)
    opened.rest()
    assert panel(opened).isVisible()
    assert opened.viewport.sketches["patch"].label == "H1"
