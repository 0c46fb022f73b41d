"""Tests of projections, views and overlays of the viewport with real OpenGL."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from lispac.gui.viewport.base import DragHandle, Highlight, PointColouring, Sketch
from lispac.gui.viewport.clipping import Box
from tests.support.long_runs import others_long
from tests.support.view_scenes import BLUE, RED, YELLOW, count, picture, pixel, scene, wall

GREEN = (0, 158, 115)

CTRL = Qt.KeyboardModifier.ControlModifier
NO_MODIFIER = Qt.KeyboardModifier.NoModifier
LEFT = Qt.MouseButton.LeftButton
OVERLAY_COLOUR = (250, 10, 200)


def test_orthographic_picture_agrees_with_the_projection(viewport, qtbot):
    clouds, colours = scene()
    dots = {"near": np.array([[2.0, 15.0, 1.0]]), "far": np.array([[-6.0, 30.0, 9.0]])}
    viewport.show_clouds(dots, {"near": RED, "far": BLUE})
    viewport.fit(wall(25.0, (-9.0, 9.0), (-4.0, 14.0)))
    viewport.set_parallel(True)
    viewport.set_point_size(5)
    image = picture(viewport)
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
    viewport.show_highlights([Highlight(("T1", "red"), plate, YELLOW, YELLOW)])
    assert count(picture(viewport), YELLOW) > 300, "it lies over its line"
    with qtbot.waitSignal(viewport.signals.seed_clicked) as clicked:
        QTest.mouseClick(viewport.canvas, LEFT, CTRL, pixel(viewport, clouds["red"][600]))
    assert clicked.args[0].line == "red"
    viewport.set_parallel(False)
    widths = [np.ptp(viewport.to_pixels(p)[:, 0]) / np.ptp(p[:, 0]) for p in clouds.values()]
    assert widths[0] > 1.2 * widths[1]


def test_standard_views_and_views_along_a_normal(viewport):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    ahead = {"front": (0, 1), "back": (0, -1), "left": (1, 0), "right": (-1, 0)}
    for name, (north, west) in ahead.items():
        viewport.view(name)
        np.testing.assert_allclose(viewport.camera.axes[2], [north, west, 0], atol=0.05)
    viewport.view_along(np.array([0.0, -1.0, 0.0]), clouds["red"])
    np.testing.assert_allclose(viewport.camera.axes[2], [0, 1, 0], atol=1e-12)
    assert np.ptp(viewport.to_pixels(clouds["red"])[:, 1]) > 400, "and it fills the picture"


def drag(viewport, start, *ways):
    """Press at a pixel, move by each vector and release."""
    QTest.mousePress(viewport.canvas, LEFT, NO_MODIFIER, start)
    for way in ways:
        start = start + way
        QTest.mouseMove(viewport.canvas, start)
    QTest.mouseRelease(viewport.canvas, LEFT, NO_MODIFIER, start)


def test_in_point_mode_a_click_picks_and_a_drag_rotates(viewport, qtbot):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    emitted = []
    viewport.signals.pointed.connect(emitted.append)
    spot = pixel(viewport, clouds["red"][600])
    QTest.mouseClick(viewport.canvas, LEFT, NO_MODIFIER, spot)
    assert emitted == []
    viewport.set_mouse("point", "Click")
    assert viewport.canvas.cursor().shape() == Qt.CursorShape.CrossCursor
    QTest.mouseClick(viewport.canvas, LEFT, NO_MODIFIER, spot)
    (point,) = emitted
    assert point.line == "red"
    np.testing.assert_allclose(point.position, clouds["red"][600], atol=0.11)
    before = viewport.camera
    drag(viewport, spot, QPoint(40, 0), QPoint(20, 0))
    assert len(emitted) == 1
    assert viewport.camera is not before
    QTest.mouseClick(viewport.canvas, LEFT, NO_MODIFIER, QPoint(2, 2))
    assert emitted[1] is None
    viewport.set_mouse("navigate")
    QTest.mouseClick(viewport.canvas, LEFT, NO_MODIFIER, spot)
    assert len(emitted) == 2


def test_sketches_are_drawn_at_their_points_and_removed(viewport):
    viewport.show_clouds(*scene())
    viewport.view("front")
    without = picture(viewport)
    ends = ((-4.0, 15.0, 1.0), (4.0, 15.0, 1.0))
    viewport.show_sketch(
        "a", Sketch(ends, ((0, 1),), OVERLAY_COLOUR, dots=True, label="8 m", label_point=ends[0])
    )
    drawn = picture(viewport)
    rows, columns = np.nonzero(np.abs(drawn.astype(int) - OVERLAY_COLOUR).max(axis=2) <= 2)
    spots = viewport.to_pixels(np.array(ends))
    assert len(rows) > 100
    assert rows.min() + 5 >= spots[:, 1].min() - 5
    assert columns.min() == pytest.approx(spots[:, 0].min(), abs=6)
    assert columns.max() == pytest.approx(spots[:, 0].max(), abs=6)
    viewport.show_sketch("a", None)
    np.testing.assert_array_equal(picture(viewport), without)
    behind = Sketch(((0.0, -50.0, 0.0), (0.0, 15.0, 1.0)), ((0, 1),), OVERLAY_COLOUR)
    viewport.show_sketch("b", behind)  # half of it is behind the eye: nothing to draw
    np.testing.assert_array_equal(picture(viewport), without)


@pytest.mark.parametrize("parallel", [False, True])
def test_a_handle_is_dragged_along_its_axis(viewport, parallel):
    viewport.show_clouds(*scene())
    viewport.set_parallel(parallel)
    viewport.view("isometric")
    place, axis = np.array([1.0, 15.0, 2.0]), np.array([1.0, 0.0, 0.0])
    moved, ended = [], []
    viewport.signals.handle_moved.connect(lambda *move: moved.append(move))
    viewport.signals.handle_released.connect(ended.append)
    viewport.show_sketch(
        "box", Sketch((), (), OVERLAY_COLOUR, handles=(DragHandle(tuple(place), tuple(axis)),))
    )
    camera = viewport.camera
    start = pixel(viewport, place)
    way = pixel(viewport, place + 0.8 * axis) - start
    drag(viewport, start, way / 2, way - way / 2)
    assert viewport.camera is camera, "the view stays"
    assert {move[:2] for move in moved} == {("box", 0)}
    # Pixel coordinates are integers.
    assert sum(move[2] for move in moved) == pytest.approx(0.8, abs=0.03)
    assert ended == ["box"]
    drag(viewport, start + QPoint(25, 25), QPoint(30, 0))
    assert viewport.camera is not camera


def test_an_outline_is_drawn_with_the_left_button(viewport):
    viewport.show_clouds(*scene())
    emitted = []
    viewport.signals.outlined.connect(emitted.append)
    viewport.set_mouse("outline", "Draw")
    camera = viewport.camera
    drag(viewport, QPoint(300, 300), QPoint(60, 0), QPoint(0, 60), QPoint(-60, 0))
    np.testing.assert_array_equal(emitted[0], [[300, 300], [360, 300], [360, 360], [300, 360]])
    assert viewport.camera is camera
    QTest.mouseClick(viewport.canvas, LEFT, NO_MODIFIER, QPoint(300, 300))
    assert len(emitted) == 1


def test_point_under_the_resting_mouse_is_shown(viewport, qtbot):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    spot = pixel(viewport, clouds["red"][600])
    emitted = []
    viewport.signals.hovered.connect(emitted.append)
    QTest.mouseMove(viewport.canvas, spot)
    QTest.mouseMove(viewport.canvas, spot + QPoint(1, 0))
    qtbot.waitUntil(lambda: len(emitted) == 1)
    assert emitted[0].line == "red"
    np.testing.assert_allclose(emitted[0].position, clouds["red"][600], atol=0.11)
    viewport.view("front")
    viewport.canvas.setFocus()
    QTest.keyClick(viewport.canvas, Qt.Key.Key_Right, Qt.KeyboardModifier.ShiftModifier)
    assert emitted[1:] == [None], "the view has moved"
    qtbot.waitUntil(lambda: len(emitted) == 3)
    assert emitted[2].line == "red"
    QTest.mouseMove(viewport.canvas, QPoint(3, 3))
    qtbot.waitUntil(lambda: len(emitted) == 4)
    assert emitted[3] is None


def test_only_points_in_the_box_are_drawn_and_picked(viewport, qtbot):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    plate = clouds["red"][np.abs(clouds["red"][:, 0]) < 0.55]
    viewport.show_highlights([Highlight(("T1", "red"), plate, YELLOW, YELLOW)])
    whole = {c: count(picture(viewport), c) for c in (RED, BLUE, YELLOW)}
    low = clouds["red"][clouds["red"][:, 2] < 1.5]
    viewport.clip(Box.around(low, np.array([0.0, 1.0, 0.0]), 0.01))
    image = picture(viewport)
    assert count(image, BLUE) == 0
    assert 0.4 * whole[RED] < count(image, RED) < 0.6 * whole[RED]
    assert 0.4 * whole[YELLOW] < count(image, YELLOW) < 0.6 * whole[YELLOW]
    shades = {
        line: np.full((len(points), 3), OVERLAY_COLOUR, np.uint8) for line, points in clouds.items()
    }
    half = clouds["red"][:, 2] < 0.7
    shades["red"][half] = (0, 90, 20)
    scale = np.zeros((2, 3), np.uint8)
    viewport.show_highlights([])
    viewport.show_clouds(clouds, colours, PointColouring(shades, "", "", "", scale))
    image = picture(viewport)  # each point keeps its colour
    assert count(image, (0, 90, 20)) == pytest.approx(count(image, OVERLAY_COLOUR), rel=0.25)
    with qtbot.waitSignal(viewport.signals.missed):
        QTest.mouseClick(viewport.canvas, LEFT, CTRL, pixel(viewport, (5.0, 25.0, 5.0)))
    viewport.clip(None)
    viewport.show_clouds(clouds, colours)
    assert count(picture(viewport), BLUE) == pytest.approx(whole[BLUE], rel=0.02)


@pytest.mark.parametrize(
    ("parallel", "origin"),
    others_long(
        [(False, (5_040_000.0, -612_000.0, 0.0)), (True, (0.0, 0.0, 0.0)),
         (True, (5_040_000.0, -612_000.0, 0.0)), (False, (0.0, 0.0, 0.0))],
        short=2,
    ),
)  # fmt: skip
def test_the_divider_between_before_and_after_is_dragged(viewport, parallel, origin):
    here = wall(25.0, (-9.0, 9.0), (0.0, 9.0), origin=origin)
    viewport.set_station(origin)
    viewport.show_clouds({"blue": here}, {"blue": BLUE})
    viewport.set_parallel(parallel)
    viewport.view("front")
    viewport.show_wipe({"blue": here + [0.0, 0.0, 20.0]})

    viewport.fit(np.concatenate([here, here + [0.0, 0.0, 20.0]]))
    image = picture(viewport)
    blue = np.abs(image.astype(int) - BLUE).max(axis=2) <= 2
    upper, lower = blue[:280], blue[320:]
    assert upper[:, :398].sum() > 300
    assert upper[:, 402:].sum() == 0
    assert lower[:, 402:].sum() > 300
    assert lower[:, :398].sum() == 0
    camera = viewport.camera
    drag(viewport, QPoint(400, 300), QPoint(-60, 0))
    assert viewport.camera is camera
    blue = np.abs(picture(viewport).astype(int) - BLUE).max(axis=2) <= 2
    assert blue[320:, 345:398].sum() > 50
    assert blue[:280, 345:].sum() == 0
    # Each placement has its own sightings, which are drawn again when targets change.
    middle = here[np.abs(here - here.mean(axis=0)).max(axis=1) < 4.0]
    above = middle + [0.0, 0.0, 20.0]
    viewport.show_highlights([Highlight(("T1", "blue"), middle, GREEN, YELLOW)])
    viewport.show_wipe(
        {"blue": here + [0.0, 0.0, 20.0]}, [Highlight(("T1", "blue"), above, GREEN, YELLOW)]
    )
    green = (picture(viewport) == GREEN).all(axis=2)
    assert green[:280, :338].sum() > 50
    assert green[320:, 342:].sum() > 50
    assert green[:280, 342:].sum() == green[320:, :338].sum() == 0
    viewport.show_wipe(None)
    image = picture(viewport)
    assert not (image[:280] == GREEN).all(axis=2).any()
    blue = np.abs(image.astype(int) - BLUE).max(axis=2) <= 2
    assert blue[:280].sum() == 0


def test_sides_of_a_box_move_separately_and_never_pass_each_other():
    rng = np.random.default_rng(3)
    points = rng.normal(size=(40_000, 3)) * [3.0, 0.5, 1.0] + 50.0
    box = Box.around(points, np.array([0.6, -0.8, 0.1]), 1e-6)
    assert len(box.inside(points)) == len(points)
    np.testing.assert_allclose(box.axes @ box.axes.T, np.eye(3), atol=1e-14)
    for side in range(6):
        (middle, out), other = box.sides[side], side ^ 1
        moved = box.with_side_moved(side, -0.3)
        np.testing.assert_allclose(moved.sides[side][0], middle - 0.3 * out, atol=1e-12)
        np.testing.assert_allclose(moved.sides[other][0], box.sides[other][0], atol=1e-12)
        beyond = (points - moved.sides[side][0]) @ out > 0
        assert len(moved.inside(points)) == np.count_nonzero(~beyond)
        flat = box.with_side_moved(side, -1e6)
        assert (flat.half > 0.02).all()
        np.testing.assert_allclose(flat.sides[other][0], box.sides[other][0], atol=1e-9)
