"""Ways to look at the lines with real OpenGL: projections, views, what is drawn over them."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from lispac.gui.viewport.base import Handle, Highlight, Sketch
from tests.view_scenes import BLUE, RED, YELLOW, count, picture, pixel, scene, wall

CTRL = Qt.KeyboardModifier.ControlModifier
PLAIN = Qt.KeyboardModifier.NoModifier
LEFT = Qt.MouseButton.LeftButton
INKED = (250, 10, 200)


def test_the_orthographic_picture_and_the_mathematics_agree(viewport, qtbot, tmp_path):
    clouds, colours = scene()
    dots = {"near": np.array([[2.0, 15.0, 1.0]]), "far": np.array([[-6.0, 30.0, 9.0]])}
    viewport.show_clouds(dots, {"near": RED, "far": BLUE})
    viewport.fit(wall(25.0, (-9.0, 9.0), (-4.0, 14.0)))
    viewport.set_parallel(True)
    viewport.set_point_size(5)
    image = picture(viewport, tmp_path)
    for line, colour in (("near", RED), ("far", BLUE)):
        rows, columns = np.nonzero(np.abs(image.astype(int) - colour).max(axis=2) <= 2)
        x, y = viewport.to_pixels(dots[line])[0]
        assert len(rows) >= 9
        assert columns.mean() + 0.5 == pytest.approx(x, abs=1.0)
        assert rows.mean() + 0.5 == pytest.approx(y, abs=1.0)
    viewport.clear()
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    widths = [np.ptp(viewport.to_pixels(p)[:, 0]) / np.ptp(p[:, 0]) for p in clouds.values()]
    assert widths[0] == pytest.approx(widths[1], rel=1e-6)
    plate = clouds["red"][np.abs(clouds["red"][:, 0]) < 0.55]
    viewport.show_highlights([Highlight(("T1", "red"), plate, YELLOW)])
    assert count(picture(viewport, tmp_path), YELLOW) > 300, "it lies over its line"
    with qtbot.waitSignal(viewport.signals.seed_clicked) as clicked:
        QTest.mouseClick(viewport.canvas, LEFT, CTRL, pixel(viewport, clouds["red"][600]))
    assert clicked.args[0].line == "red"
    viewport.set_parallel(False)
    widths = [np.ptp(viewport.to_pixels(p)[:, 0]) / np.ptp(p[:, 0]) for p in clouds.values()]
    assert widths[0] > 1.2 * widths[1]


def test_views_from_all_sides_and_along_a_normal(viewport):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    ahead = {"front": (0, 1), "back": (0, -1), "left": (1, 0), "right": (-1, 0)}
    for name, (north, west) in ahead.items():
        viewport.view(name)
        np.testing.assert_allclose(viewport.camera.axes[2], [north, west, 0], atol=0.05)
    viewport.look_along(np.array([0.0, -1.0, 0.0]), clouds["red"])
    np.testing.assert_allclose(viewport.camera.axes[2], [0, 1, 0], atol=1e-12)
    assert np.ptp(viewport.to_pixels(clouds["red"])[:, 1]) > 400, "and it fills the picture"


def drag(viewport, start, *ways):
    """Press at a pixel, go along, let go."""
    QTest.mousePress(viewport.canvas, LEFT, PLAIN, start)
    for way in ways:
        start = start + way
        QTest.mouseMove(viewport.canvas, start)
    QTest.mouseRelease(viewport.canvas, LEFT, PLAIN, start)


def test_while_pointing_a_click_points_and_a_drag_still_rotates(viewport, qtbot):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    told = []
    viewport.signals.pointed.connect(told.append)
    spot = pixel(viewport, clouds["red"][600])
    QTest.mouseClick(viewport.canvas, LEFT, PLAIN, spot)
    assert told == []
    viewport.set_mouse("point", "Click")
    assert viewport.canvas.cursor().shape() == Qt.CursorShape.CrossCursor
    QTest.mouseClick(viewport.canvas, LEFT, PLAIN, spot)
    (point,) = told
    assert point.line == "red"
    np.testing.assert_allclose(point.position, clouds["red"][600], atol=0.11)
    before = viewport.camera
    drag(viewport, spot, QPoint(40, 0), QPoint(20, 0))
    assert len(told) == 1
    assert viewport.camera is not before
    QTest.mouseClick(viewport.canvas, LEFT, PLAIN, QPoint(2, 2))
    assert told[1] is None
    viewport.set_mouse("navigate")
    QTest.mouseClick(viewport.canvas, LEFT, PLAIN, spot)
    assert len(told) == 2


def test_sketches_lie_where_their_points_are_and_go_away(viewport, tmp_path):
    viewport.show_clouds(*scene())
    viewport.view("front")
    without = picture(viewport, tmp_path)
    ends = ((-4.0, 15.0, 1.0), (4.0, 15.0, 1.0))
    viewport.show_sketch("a", Sketch(ends, ((0, 1),), INKED, dots=True, label="8 m", at=ends[0]))
    drawn = picture(viewport, tmp_path)
    rows, columns = np.nonzero(np.abs(drawn.astype(int) - INKED).max(axis=2) <= 2)
    spots = viewport.to_pixels(np.array(ends))
    assert len(rows) > 100
    assert rows.min() + 5 >= spots[:, 1].min() - 5
    assert columns.min() == pytest.approx(spots[:, 0].min(), abs=6)
    assert columns.max() == pytest.approx(spots[:, 0].max(), abs=6)
    viewport.show_sketch("a", None)
    np.testing.assert_array_equal(picture(viewport, tmp_path), without)
    behind = Sketch(((0.0, -50.0, 0.0), (0.0, 15.0, 1.0)), ((0, 1),), INKED)
    viewport.show_sketch("b", behind)  # half of it is behind the eye: nothing to draw
    np.testing.assert_array_equal(picture(viewport, tmp_path), without)


@pytest.mark.parametrize("parallel", [False, True])
def test_a_handle_follows_the_mouse_along_its_axis(viewport, parallel):
    viewport.show_clouds(*scene())
    viewport.set_parallel(parallel)
    viewport.view("isometric")
    place, axis = np.array([1.0, 15.0, 2.0]), np.array([1.0, 0.0, 0.0])
    moved, ended = [], []
    viewport.signals.handle_moved.connect(lambda *told: moved.append(told))
    viewport.signals.handle_let_go.connect(ended.append)
    viewport.show_sketch("box", Sketch((), (), INKED, handles=(Handle(tuple(place), tuple(axis)),)))
    camera = viewport.camera
    start = pixel(viewport, place)
    way = pixel(viewport, place + 0.8 * axis) - start
    drag(viewport, start, way / 2, way - way / 2)
    assert viewport.camera is camera, "the view stays"
    assert {told[:2] for told in moved} == {("box", 0)}
    # Pixels are whole.
    assert sum(told[2] for told in moved) == pytest.approx(0.8, abs=0.03)
    assert ended == ["box"]
    drag(viewport, start + QPoint(25, 25), QPoint(30, 0))
    assert viewport.camera is not camera


def test_an_outline_is_drawn_with_the_left_button(viewport, tmp_path):
    viewport.show_clouds(*scene())
    told = []
    viewport.signals.outlined.connect(told.append)
    viewport.set_mouse("outline", "Draw")
    camera = viewport.camera
    drag(viewport, QPoint(300, 300), QPoint(60, 0), QPoint(0, 60), QPoint(-60, 0))
    np.testing.assert_array_equal(told[0], [[300, 300], [360, 300], [360, 360], [300, 360]])
    assert viewport.camera is camera
    QTest.mouseClick(viewport.canvas, LEFT, PLAIN, QPoint(300, 300))
    assert len(told) == 1


def test_what_is_under_the_resting_mouse_is_told_while_hovering(viewport, qtbot):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    spot = pixel(viewport, clouds["red"][600])
    told = []
    viewport.signals.hovered.connect(told.append)
    QTest.mouseMove(viewport.canvas, spot)
    qtbot.wait(100)
    assert told == []
    viewport.set_hovering(True)
    QTest.mouseMove(viewport.canvas, spot + QPoint(1, 0))
    qtbot.waitUntil(lambda: len(told) == 1, timeout=2000)
    assert told[0].line == "red"
    np.testing.assert_allclose(told[0].position, clouds["red"][600], atol=0.11)
    viewport.set_hovering(False)
    assert told[1:] == [None]
