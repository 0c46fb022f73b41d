"""Tests of the camera: former views, linked views, and that the view moves only on request."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QToolButton

from lispac.gui.app.unavailable import Unavailable
from lispac.gui.viewport.base import Highlight, LinkedView
from lispac.gui.viewport.clipping import Box
from lispac.gui.viewport.view_history import REST_MS
from lispac.project import Project
from tests.gui.by_hand import choose, open_menu
from tests.gui.support import (
    Control,
    Demo,
    Driver,
    Key,
    Left,
    click,
    double_click,
    estimate,
    press,
    seed,
    wait_until_idle,
)
from tests.support.long_runs import LONG
from tests.support.view_scenes import BLUE, RED, YELLOW, array_of, count, pixel, scene

ALT = Qt.KeyboardModifier.AltModifier
PLAIN = Qt.KeyboardModifier.NoModifier
WEST = (0.0, 0.0, 0.5, 1.0)
EAST = (0.5, 0.0, 0.5, 1.0)
QUARTERS = [(x, y, 0.5, 0.5) for y in (0.0, 0.5) for x in (0.0, 0.5)]


def wheel(viewport, place, notches=1):
    """Turn the wheel at a pixel of the canvas."""
    at = QPointF(place)
    event = QWheelEvent(
        at, viewport.canvas.mapToGlobal(at), QPoint(), QPoint(0, 120 * notches),
        Qt.MouseButton.NoButton, PLAIN, Qt.ScrollPhase.NoScrollPhase, False,
    )  # fmt: skip
    QApplication.sendEvent(viewport.canvas, event)


def drag(viewport, start, way, button=Left):
    QTest.mousePress(viewport.canvas, button, PLAIN, start)
    QTest.mouseMove(viewport.canvas, start + way)
    QTest.mouseRelease(viewport.canvas, button, PLAIN, start + way)


def state(viewport):
    """Numbers of the camera that determine the picture."""
    camera = viewport.camera
    return np.array([*camera.position, camera.azimuth, camera.elevation])


# -- former views ----------------------------------------------------------------------------------


def test_views_are_stored_when_commanded_and_when_the_user_has_stopped(viewport, qtbot):
    viewport.show_clouds(*scene())
    reported = []
    viewport.signals.history_changed.connect(lambda *has: reported.append(has))
    first = state(viewport)
    viewport.view("front")
    front = state(viewport)
    assert reported == [(True, False)]
    viewport.view("front")
    assert reported == [(True, False)], "the same view is stored once"
    for _ in range(3):
        wheel(viewport, QPoint(300, 200))
    drag(viewport, QPoint(400, 300), QPoint(60, 30))
    moved = state(viewport)
    assert reported == [(True, False)], "the user is still moving"
    qtbot.waitUntil(lambda: len(reported) == 2)
    QTest.mouseClick(viewport.canvas, Left, PLAIN, QPoint(400, 300))
    qtbot.wait(REST_MS + 100)
    assert len(reported) == 2, "a click does not move the view"
    viewport.step_view(-1)
    np.testing.assert_allclose(state(viewport), front)
    assert reported[-1] == (True, True)
    QTest.mouseClick(viewport.canvas, Qt.MouseButton.BackButton, PLAIN, QPoint(400, 300))
    np.testing.assert_allclose(state(viewport), first)
    assert reported[-1] == (False, True)
    viewport.step_view(-1)
    np.testing.assert_allclose(state(viewport), first)
    for _ in range(2):
        QTest.mouseClick(viewport.canvas, Qt.MouseButton.ForwardButton, PLAIN, QPoint(400, 300))
    np.testing.assert_allclose(state(viewport), moved)
    viewport.step_view(-1)
    viewport.view("top")
    assert reported[-1] == (True, False), "later views are discarded"
    viewport.step_view(-1)
    np.testing.assert_allclose(state(viewport), front)


def test_a_movement_is_stored_before_a_command_and_the_projection_is_kept(viewport):
    viewport.show_clouds(*scene())
    drag(viewport, QPoint(400, 300), QPoint(60, 30))
    moved = state(viewport)
    viewport.view("top")
    viewport.set_parallel(True)
    viewport.step_view(-1)
    assert viewport.camera.parallel
    viewport.set_parallel(False)
    np.testing.assert_allclose(state(viewport), moved)
    viewport.clear()
    viewport.show_clouds(*scene())
    before = state(viewport)
    viewport.step_view(-1)
    np.testing.assert_array_equal(state(viewport), before), "views of the former lines"


@LONG
def test_former_views_by_keys_and_menu(real: Driver, demo: Demo) -> None:
    window, viewport = real.window, real.viewport
    window.document.open(demo.picked, demo.survey)
    wait_until_idle(real)
    actions = window.actions_
    assert actions.reason("previous_view") is Unavailable.FIRST_VIEW
    first = state(viewport)
    press(real, Key.Key_2)
    top = state(viewport)
    press(real, Key.Key_Left, ALT)
    np.testing.assert_allclose(state(viewport), first)
    assert actions.reason("previous_view") is Unavailable.FIRST_VIEW
    choose(real.bot, open_menu(real.bot, window, "View"), "Next view")
    np.testing.assert_allclose(state(viewport), top)
    assert actions.reason("next_view") is Unavailable.LAST_VIEW


def test_the_view_moves_only_on_request(real: Driver, demo: Demo, estimated: Project) -> None:
    """Selecting, renaming and picking do not move it; a double click does.

    When the panel of the results opens, the direction remains and the scene stays in place.
    """
    window, viewport = real.window, real.viewport
    window.document.open(demo.picked, demo.survey)
    wait_until_idle(real)
    drag(viewport, QPoint(200, 200), QPoint(60, 30))
    camera = viewport.camera
    table = window.table
    place = table.visualRect(table.sightings.index(1, 1)).center() + QPoint(20, 0)
    real.bot.mouseClick(table.viewport(), Left, pos=place)
    assert window.scene.selected == ("T2", demo.picked.lines[0].name)
    real.bot.keyClick(table, Key.Key_Up)
    assert window.scene.selected == ("T1", demo.picked.lines[0].name)
    window.workflow.go_to(2)
    listed = window.targets.table
    real.bot.mouseClick(
        listed.viewport(), Left, pos=listed.visualItemRect(listed.item(1, 1)).center()
    )
    assert window.scene.selected == ("T2", "")
    window._rename("T2", "Board")
    seed(real, "V1")
    assert viewport.camera is camera
    window.document.edit("estimate", estimated)
    wait_until_idle(real)
    former, camera = camera, viewport.camera
    assert (camera.azimuth, camera.elevation) == (former.azimuth, former.elevation)
    double_click(real, listed, 0, 1)
    assert viewport.camera is not camera
    np.testing.assert_allclose(
        viewport.camera.focal, np.concatenate(list(window.scene.selected_points.values())).mean(0),
        atol=0.5,
    )  # fmt: skip


# -- linked views in a viewport that draws ---------------------------------------------------------


def shifted(clouds, up=0.5):
    return {line: points + [0.0, 0.0, up] for line, points in clouds.items()}


def halves(viewport):
    """Pictures of the left and the right half."""
    image = array_of(viewport.picture())
    middle = image.shape[1] // 2
    return image[:, :middle], image[:, middle:]


@pytest.mark.parametrize("origin", [(0.0, 0.0, 0.0), (5_040_000.0, -612_000.0, 0.0)])
def test_two_views_have_the_same_camera_and_different_placements(viewport, origin):
    clouds, colours = scene(origin)
    viewport.set_station(origin)
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    plate = clouds["red"][np.abs(clouds["red"][:, 0] - origin[0]) < 0.55]
    own = Highlight(("T1", "red"), plate + [0.0, 0.0, 4.0], YELLOW, YELLOW)
    viewport.show_linked([
        LinkedView("After", EAST), LinkedView("Before", WEST, clouds=clouds, highlights=[own])
    ])  # fmt: skip
    left, right = halves(viewport)
    for colour in (RED, BLUE):
        assert count(left, colour) == pytest.approx(count(right, colour), rel=0.15)
        assert count(left, colour) > 300
    viewport.show_highlights([Highlight(("T1", "red"), plate, YELLOW, YELLOW)])
    left, right = halves(viewport)
    rows = [np.nonzero(np.abs(half.astype(int) - YELLOW).max(axis=2) <= 2)[0].mean()
            for half in (left, right)]  # fmt: skip
    assert rows[0] < rows[1] - 50, "sightings in their own placement"
    viewport.show_linked([
        LinkedView("After", EAST),
        LinkedView("Before", WEST, clouds=shifted(clouds, 100.0), highlights=[]),
    ])  # fmt: skip
    left, right = halves(viewport)
    assert count(left, RED) == 0
    assert count(right, RED) > 300
    viewport.show_linked(())
    whole = np.abs(array_of(viewport.picture()).astype(int) - RED).max(axis=2) <= 2
    assert np.nonzero(whole)[1].mean() == pytest.approx(400, abs=5), "the whole view"


def test_a_click_in_a_view_picks_the_point_that_is_shown_there(viewport, qtbot):
    clouds, colours = scene()
    former = shifted(clouds)
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    viewport.show_linked(
        [LinkedView("After", EAST), LinkedView("Before", WEST, clouds=former, highlights=[])]
    )
    index = 600
    inside = pixel(viewport, former["red"][index]) - QPoint(400, 0)  # in the left picture
    assert 0 < inside.x() < 400
    with qtbot.waitSignal(viewport.signals.seed_clicked) as clicked:
        QTest.mouseClick(viewport.canvas, Left, Control, inside)
    picked = clicked.args[0]
    place = np.array(picked.position)
    (row,) = np.flatnonzero((clouds["red"] == place).all(axis=1))  # in the lines of the view
    np.testing.assert_allclose(former["red"][row], former["red"][index], atol=0.11)
    viewport.set_mouse("point", "")
    with qtbot.waitSignal(viewport.signals.pointed) as pointed:
        QTest.mouseClick(viewport.canvas, Left, PLAIN, inside)
    np.testing.assert_array_equal(pointed.args[0].position, former["red"][row])
    viewport.set_mouse("navigate")
    hovered = []
    viewport.signals.hovered.connect(hovered.append)
    QTest.mouseMove(viewport.canvas, inside + QPoint(1, 0))
    QTest.mouseMove(viewport.canvas, inside)
    qtbot.waitUntil(lambda: bool(hovered))
    assert (clouds["red"] == np.array(hovered[0].position)).all(axis=1).any()
    right = pixel(viewport, clouds["red"][index])
    assert right.x() > 400
    with qtbot.waitSignal(viewport.signals.seed_clicked) as clicked:
        QTest.mouseClick(viewport.canvas, Left, Control, right)
    np.testing.assert_allclose(clicked.args[0].position, clouds["red"][index], atol=0.11)


def test_four_views_follow_the_same_centre_and_scale(viewport):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    low = clouds["red"][clouds["red"][:, 2] < 1.5]
    box = Box.around(low, np.array([0.0, 1.0, 0.0]), 0.05)
    section = Box(box.centre, box.axes[[1, 2, 0]], box.half[[1, 2, 0]])
    viewport.show_linked([
        LinkedView("After", QUARTERS[1]),
        LinkedView("Before", QUARTERS[0], clouds=clouds, highlights=[]),
        LinkedView("Top", QUARTERS[2], "top"),
        LinkedView("Section", QUARTERS[3], "section", box=section),
    ])  # fmt: skip
    viewport.view("front")
    image = array_of(viewport.picture())
    lower_right = image[300:, 400:]
    assert count(lower_right, RED) > 100
    assert count(lower_right, BLUE) == 0, "only the points in the box"
    assert count(image[300:, :400], BLUE) > 20
    start = viewport.camera
    drag(viewport, QPoint(200, 450), QPoint(0, 40))  # in the view from above
    moved = viewport.camera
    assert (moved.azimuth, moved.elevation) == (start.azimuth, start.elevation), "it is not turned"
    metres = 40 * start.distance / (150.0 / np.tan(np.radians(15.0)))
    np.testing.assert_allclose(moved.focal - start.focal, [metres, 0.0, 0.0], atol=1e-9)
    wheel(viewport, QPoint(200, 450))
    assert viewport.camera.distance == pytest.approx(0.85 * moved.distance)
    last = viewport.camera
    wheel(viewport, QPoint(600, 450))
    assert viewport.camera is last, "the section has a camera of its own"
    enlarged = count(array_of(viewport.picture())[300:, 400:], RED)
    drag(viewport, QPoint(200, 150), QPoint(30, 0))  # before: turns both
    assert viewport.camera.azimuth != last.azimuth
    assert count(array_of(viewport.picture())[300:, 400:], RED) == pytest.approx(enlarged, rel=0.1)


# -- linked views in the window --------------------------------------------------------------------


def parts(driver: Driver) -> list[tuple[str, bool]]:
    """Direction of each linked view, and whether it shows another placement."""
    return [(each.direction, each.clouds is not None) for each in driver.viewport.linked]


TWO = [("same", False), ("same", True)]
FOUR = [*TWO, ("top", False), ("side", False)]


def test_linked_views_by_keys_menu_and_toolbar(adjusted: Driver) -> None:
    window, viewport = adjusted.window, adjusted.viewport
    wait_until_idle(adjusted)
    press(adjusted, Key.Key_2, ALT)
    wait_until_idle(adjusted)
    assert parts(adjusted) == TWO
    before, survey = viewport.linked[1], window.document.survey
    assert all(before.clouds[line] is cloud.sample for line, cloud in survey.clouds.items())
    assert all(viewport.clouds[line] is not points for line, points in before.clouds.items())
    target = window.document.project.target("T1")
    line = target.sightings[0].line
    (own,) = [each for each in before.highlights if each.key == ("T1", line)]
    np.testing.assert_array_equal(own.points, survey.clouds[line][target.sightings[0].indices])
    press(adjusted, Key.Key_Escape)
    assert viewport.linked == ()
    assert window.actions_["one_view"].isChecked()
    choose(adjusted.bot, open_menu(adjusted.bot, window, "View"), "Linked views", "Four views")
    wait_until_idle(adjusted)
    assert parts(adjusted) == FOUR
    (button,) = [
        each for each in window.findChildren(QToolButton)
        if each.defaultAction() is window.actions_["two_views"]
    ]  # fmt: skip
    click(adjusted, button)
    wait_until_idle(adjusted)
    assert parts(adjusted) == TWO
    assert lit_lines(adjusted) == {"two_views"}
    click(adjusted, button)
    assert viewport.linked == (), "chosen again"
    assert lit_lines(adjusted) == {"after"}
    press(adjusted, Key.Key_4, ALT)
    press(adjusted, Key.Key_1, ALT)
    wait_until_idle(adjusted)
    assert viewport.linked == ()


def lit_lines(driver: Driver) -> set[str]:
    """Choices of the lines shown that are switched on."""
    names = ("before", "after", "wipe", "two_views")
    return {name for name in names if driver.window.actions_[name].isChecked()}


def test_other_lines_or_the_split_view_end_the_linked_views(adjusted: Driver) -> None:
    viewport = adjusted.viewport
    wait_until_idle(adjusted)
    for key in (Key.Key_B, Key.Key_W):
        press(adjusted, Key.Key_2, ALT)
        wait_until_idle(adjusted)
        assert parts(adjusted) == TWO
        assert viewport.wipe_clouds is None
        press(adjusted, key)
        wait_until_idle(adjusted)
        assert viewport.linked == ()
        assert adjusted.window.actions_["one_view"].isChecked()
        assert lit_lines(adjusted) == {"before" if key == Key.Key_B else "wipe"}
    assert viewport.wipe_clouds is not None
    press(adjusted, Key.Key_2, ALT)
    wait_until_idle(adjusted)
    assert parts(adjusted) == TWO
    assert viewport.wipe_clouds is None


@LONG
def test_without_a_result_two_views_say_why_not_and_four_show_the_prior_lines(
    picked: Driver,
) -> None:
    actions = picked.window.actions_
    assert actions.reason("two_views") is Unavailable.NO_RESULT
    press(picked, Key.Key_4, ALT)
    wait_until_idle(picked)
    assert parts(picked) == [("same", False), ("top", False), ("side", False)]
    press(picked, Key.Key_S)
    picked.window._select("T1", "")
    wait_until_idle(picked)
    assert parts(picked)[2][0] == "section"
    box = picked.viewport.linked[2].box
    assert 2.0 * box.half == pytest.approx([2.0, 2.0, 0.2])
    estimate(picked)
    wait_until_idle(picked)
    assert parts(picked) == [*FOUR[:3], ("section", False)]
    press(picked, Key.Key_Z, Control)
    wait_until_idle(picked)
    assert len(picked.viewport.linked) == 3


@LONG
def test_escape_ends_the_tool_then_rejects_the_target_then_ends_the_views(adjusted: Driver) -> None:
    window, viewport = adjusted.window, adjusted.viewport
    wait_until_idle(adjusted)
    press(adjusted, Key.Key_2, ALT)
    wait_until_idle(adjusted)
    seed(adjusted, "V2")
    assert window.controller.candidate is not None
    press(adjusted, Key.Key_M)
    assert window.tools.mouse_tool.tool == "measure_distance"
    press(adjusted, Key.Key_Escape)
    assert window.tools.mouse_tool.tool == ""
    assert window.controller.candidate is not None
    press(adjusted, Key.Key_Escape)
    assert window.controller.candidate is None
    wait_until_idle(adjusted)
    assert parts(adjusted) == TWO
    press(adjusted, Key.Key_Escape)
    assert viewport.linked == ()
    assert window.actions_.reason("end_tool") is Unavailable.NO_TOOL


def test_the_lasso_needs_one_view_and_says_so(adjusted: Driver) -> None:
    window = adjusted.window
    wait_until_idle(adjusted)
    window._select("T1", "")
    press(adjusted, Key.Key_L)
    assert window.tools.mouse_tool.tool == "lasso_add"
    press(adjusted, Key.Key_2, ALT)
    wait_until_idle(adjusted)
    assert window.tools.mouse_tool.tool == ""
    assert window.actions_.reason("lasso_add") is Unavailable.LINKED_VIEWS
    press(adjusted, Key.Key_L)
    assert window.tools.mouse_tool.tool == ""
    press(adjusted, Key.Key_Escape)
    press(adjusted, Key.Key_L)
    assert window.tools.mouse_tool.tool == "lasso_add"


def test_a_project_opens_in_one_view(adjusted: Driver, demo: Demo) -> None:
    wait_until_idle(adjusted)
    press(adjusted, Key.Key_2, ALT)
    wait_until_idle(adjusted)
    adjusted.window.document.open(demo.picked, demo.survey)
    wait_until_idle(adjusted)
    assert adjusted.viewport.linked == ()
    assert adjusted.window.actions_["one_view"].isChecked()
