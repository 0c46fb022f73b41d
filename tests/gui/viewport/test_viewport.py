"""Tests of the 3D viewport with real OpenGL: drawing, picking and closing."""

import gc
import os
import subprocess
import sys
import weakref
from pathlib import Path

import numpy as np
import pytest
import shiboken6
from PySide6.QtCore import QCoreApplication, QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QCursor, QGuiApplication, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget

from lispac.gui.viewport import navigation
from lispac.gui.viewport.base import (
    Highlight,
    Marker,
    PickedPoint,
    PointColouring,
    dimmed_colour,
)
from lispac.gui.viewport.decimation import Budget
from lispac.gui.viewport.highlights import outline_points
from lispac.gui.viewport.recording_viewport import RecordingViewport
from tests.gui.support import WAIT_MS, finish_layouts
from tests.support.long_runs import LONG, others_long
from tests.support.view_scenes import (
    BLUE,
    GREEN,
    RED,
    YELLOW,
    array_of,
    count,
    picture,
    pixel,
    scene,
    wall,
)

CTRL = Qt.KeyboardModifier.ControlModifier
NO_MODIFIER = Qt.KeyboardModifier.NoModifier
LEFT = Qt.MouseButton.LeftButton


@pytest.mark.parametrize("origin", [(0.0, 0.0, 0.0), (5_040_000.0, -612_000.0, 0.0)])
def test_ctrl_click_finds_the_line_and_the_point(viewport, qtbot, origin):
    clouds, colours = scene(origin)
    viewport.set_station(origin)
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    for line, index in (("red", 600), ("blue", 16000)):
        point = clouds[line][index]
        with qtbot.waitSignal(viewport.signals.seed_clicked) as clicked:
            QTest.mouseClick(viewport.canvas, LEFT, CTRL, pixel(viewport, point))
        picked = clicked.args[0]
        assert isinstance(picked, PickedPoint)
        assert picked.line == line
        np.testing.assert_allclose(picked.position, point, rtol=0, atol=0.11)
        # The exact coordinates of a point of the line
        assert np.any(np.all(clouds[line] == picked.position, axis=1))


def test_picture_agrees_with_the_projection(viewport):
    clouds = {"dot": np.array([[2.0, 20.0, 1.0]]), "far": np.array([[-6.0, 30.0, 9.0]])}
    viewport.show_clouds(clouds, {"dot": RED, "far": BLUE})
    viewport.fit(wall(25.0, (-9.0, 9.0), (-4.0, 14.0)))  # away from the axes and the scale bar
    viewport.set_point_size(5)
    image = picture(viewport)
    for line, colour in (("dot", RED), ("far", BLUE)):
        rows, columns = np.nonzero(np.abs(image.astype(int) - colour).max(axis=2) <= 2)
        x, y = viewport.to_pixels(clouds[line])[0]
        assert len(rows) >= 9
        assert columns.mean() + 0.5 == pytest.approx(x, abs=1.0)
        assert rows.mean() + 0.5 == pytest.approx(y, abs=1.0)


def test_ctrl_click_in_empty_space_is_a_miss_and_ctrl_drag_is_ignored(viewport, qtbot):
    viewport.show_clouds(*scene())
    emitted = []
    viewport.signals.seed_clicked.connect(emitted.append)
    viewport.signals.missed.connect(lambda: emitted.append("missed"))
    QTest.mouseClick(viewport.canvas, LEFT, CTRL, QPoint(3, 3))
    assert emitted == ["missed"]
    emitted.clear()
    start = pixel(viewport, (0.0, 15.0, 1.5))
    before = viewport.camera
    QTest.mousePress(viewport.canvas, LEFT, CTRL, start)
    QTest.mouseMove(viewport.canvas, start + QPoint(40, 10))
    QTest.mouseRelease(viewport.canvas, LEFT, CTRL, start + QPoint(40, 10))
    QTest.mouseClick(viewport.canvas, LEFT, NO_MODIFIER, start)
    assert emitted == []
    np.testing.assert_array_equal(viewport.camera.position, before.position)


def test_a_hidden_line_is_not_drawn_or_picked_and_stays_hidden(viewport, qtbot):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    assert count(picture(viewport), RED) > 500
    viewport.set_line_visible("red", False)
    assert count(picture(viewport), RED) == 0
    with qtbot.waitSignal(viewport.signals.seed_clicked) as clicked:
        QTest.mouseClick(viewport.canvas, LEFT, CTRL, pixel(viewport, (0.0, 15.0, 1.5)))
    assert clicked.args[0].line == "blue"
    viewport.show_clouds(clouds, colours)  # as when switching before and after
    assert count(picture(viewport), RED) == 0
    viewport.set_line_visible("red", True)
    assert count(picture(viewport), RED) > 500


def test_the_legend_contains_the_visible_lines(viewport):
    clouds, colours = scene()
    clouds["green"] = wall(40.0, (20.0, 30.0), (0.0, 3.0))
    viewport.show_clouds(clouds, {**colours, "green": GREEN})
    viewport.view("front")
    viewport.fit(wall(15.0, (-2.0, 2.0), (0.0, 3.0)))
    bare = picture(viewport)
    viewport.show_line_legend(True)

    def marks() -> list[bool]:
        """Whether the legend has red, blue and green, which replaced the bare picture."""
        image = picture(viewport)
        changed = (image != bare).any(axis=2)
        rows, columns = np.nonzero(changed)
        assert rows.max() < 120, "the legend is in the upper left corner"
        assert columns.max() < 200
        return [
            bool(((np.abs(image.astype(int) - colour).max(axis=2) <= 2) & changed).sum() > 30)
            for colour in (RED, BLUE, GREEN)
        ]

    assert marks() == [True, True, True]
    viewport.set_line_visible("red", False)
    bare = hidden(viewport)
    assert marks() == [False, True, True]
    viewport.set_line_visible("blue", False)
    np.testing.assert_array_equal(picture(viewport), hidden(viewport))


def hidden(viewport) -> np.ndarray:
    """Picture without the legend, which is shown again afterwards."""
    viewport.show_line_legend(False)
    image = picture(viewport)
    viewport.show_line_legend(True)
    return image


def test_unchanged_scene_is_not_rendered_again(viewport, qtbot):
    viewport.show_clouds(*scene())
    viewport.view("front")
    viewport.set_point_size(5)
    before = viewport.picture()
    rendered = viewport.canvas.frames
    cover = QWidget(viewport.widget)  # as a menu does
    cover.resize(viewport.widget.size())
    cover.setAutoFillBackground(True)
    cover.show()
    qtbot.wait(50)
    cover.hide()
    viewport.canvas.repaint()
    viewport.show_markers([Marker("T1", (0.0, 15.0, 1.5), YELLOW)])
    qtbot.wait(50)
    assert viewport.canvas.frames == rendered
    viewport.show_markers([])
    viewport.canvas.repaint()
    shown = viewport.canvas.grabFramebuffer()
    assert viewport.canvas.frames == rendered
    hidden, visible = (count(each, RED) for each in (array_of(before), array_of(shown)))
    assert hidden == visible > 500
    viewport.set_line_visible("red", False)
    shown = viewport.canvas.grabFramebuffer()
    assert count(array_of(shown), RED) == 0
    assert viewport.canvas.frames > rendered


def test_camera_is_kept_between_before_and_after(viewport):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    QTest.mousePress(viewport.canvas, LEFT, NO_MODIFIER, QPoint(400, 300))
    QTest.mouseMove(viewport.canvas, QPoint(460, 320))
    QTest.mouseRelease(viewport.canvas, LEFT, NO_MODIFIER, QPoint(460, 320))
    camera = viewport.camera
    viewport.show_clouds({line: points + 0.3 for line, points in clouds.items()}, colours)
    assert viewport.camera is camera


def test_drag_rotates_about_the_point_under_the_cursor_and_up_stays_up(viewport):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    point = clouds["red"][600]
    start = pixel(viewport, point)
    QTest.mousePress(viewport.canvas, LEFT, NO_MODIFIER, start)
    QTest.mouseMove(viewport.canvas, start + QPoint(80, 0))
    QTest.mouseRelease(viewport.canvas, LEFT, NO_MODIFIER, start + QPoint(80, 0))
    x, y = viewport.to_pixels(point[None])[0]
    assert np.hypot(x - start.x(), y - start.y()) < 4.0
    assert viewport.camera.axes[0, 2] == 0.0
    assert viewport.camera.azimuth != pytest.approx(1.5 * np.pi)


def test_the_view_does_not_rotate_if_a_dialogue_received_the_release(viewport):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    start = pixel(viewport, clouds["red"][600])
    QTest.mousePress(viewport.canvas, LEFT, NO_MODIFIER, start)
    before = viewport.camera
    for step in (40, 80):
        place = QPointF(start + QPoint(step, step))
        moved = QMouseEvent(
            QEvent.Type.MouseMove, place, viewport.canvas.mapToGlobal(place),
            Qt.MouseButton.NoButton, Qt.MouseButton.NoButton, NO_MODIFIER,
        )  # fmt: skip
        QCoreApplication.sendEvent(viewport.canvas, moved)
    assert viewport.camera == before
    QTest.mousePress(viewport.canvas, LEFT, NO_MODIFIER, start)
    QTest.mouseMove(viewport.canvas, start + QPoint(80, 0))
    QTest.mouseRelease(viewport.canvas, LEFT, NO_MODIFIER, start + QPoint(80, 0))
    assert viewport.camera != before


def test_the_scale_bar_is_valid_at_the_centre_and_no_click_changes_it(viewport, qtbot):
    clouds = {
        "red": wall(15.0, (-1.0, 1.0), (0.0, 2.0)),
        "blue": wall(40.0, (-9.0, 9.0), (0.0, 9.0)),
    }
    viewport.show_clouds(clouds, {"red": RED, "blue": BLUE})
    viewport.view("front")
    viewport.fit(clouds["blue"])
    far = pixel(viewport, (-7.0, 40.0, 8.0))

    def scale_depth() -> float:
        viewport.prepare()
        return viewport.widget.overlay.pictures[0].scale_depth

    first = scale_depth()
    x, y = (0.5 * each for each in (viewport.canvas.width(), viewport.canvas.height()))
    centre = viewport._navigator.point_at(x, y)
    depth = (np.array(centre.position) - viewport.camera.position) @ viewport.camera.axes[2]
    assert first == pytest.approx(depth, rel=0.02)
    focal_depths = []
    for place in (far, pixel(viewport, (0.0, 15.0, 1.0))):
        QTest.mouseClick(viewport.canvas, LEFT, NO_MODIFIER, place)
        focal_depths.append(viewport.camera.focal_depth)
        assert scale_depth() == pytest.approx(first, rel=1e-6)
    assert focal_depths[0] > 1.5 * focal_depths[1], "the clicks were on surfaces far apart"
    viewport.fit(clouds["red"])
    assert scale_depth() == pytest.approx(viewport.camera.distance, rel=0.1)
    viewport.set_parallel(True)
    assert scale_depth() == viewport.camera.distance


def test_highlights_keep_the_colour_of_their_line_and_have_a_halo(viewport):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    bare = picture(viewport)
    plate = clouds["red"][np.abs(clouds["red"][:, 0]) < 0.55]
    far = clouds["blue"][clouds["blue"][:, 0] > 7.0]
    viewport.show_highlights(
        [
            Highlight(("T1", "red"), plate, RED, YELLOW),
            Highlight(("T2", "blue"), far, BLUE, GREEN),
        ]
    )
    plain = picture(viewport)
    for line, halo in ((RED, YELLOW), (BLUE, GREEN)):
        assert count(plain, line) > count(bare, line)
        assert count(plain, halo) > count(bare, halo) + 300
    viewport.select(("T1", "red"))
    one = picture(viewport)
    assert count(one, RED) > count(plain, RED)
    wide, narrow = (np.ptp(np.nonzero((image == YELLOW).all(axis=2))[1]) for image in (one, plain))
    assert wide > narrow + 2
    assert count(one, GREEN) == count(plain, GREEN)
    viewport.select(("T1", "blue"))
    other = picture(viewport)
    assert count(other, YELLOW) == 0
    assert count(other, dimmed_colour(RED)) > 300
    viewport.select(("T2", ""))
    whole = picture(viewport)
    assert count(whole, GREEN) > count(bare, GREEN) + 300
    assert count(whole, BLUE) > count(plain, BLUE)
    viewport.select(None)
    viewport.show_highlights([])
    assert count(picture(viewport), YELLOW) == 0


def test_a_halo_hides_no_other_line_of_the_target(viewport):
    """Two lines 5 cm apart are both visible in their colours, whatever is selected."""
    front, back = wall(15.0, (-2.0, 0.4), (0.0, 3.0)), wall(15.05, (-0.4, 2.0), (0.0, 3.0))
    viewport.show_clouds({"red": front, "blue": back}, {"red": RED, "blue": BLUE})
    viewport.view("front")
    viewport.show_highlights(
        [
            Highlight(("T1", "red"), front, RED, YELLOW),
            Highlight(("T1", "blue"), back, BLUE, YELLOW),
        ]
    )
    alone = {RED: len(front), BLUE: int((back[:, 0] > 0.4).sum())}
    for selected in (None, ("T1", "")):
        viewport.select(selected)
        image = picture(viewport)
        for colour, points in alone.items():
            assert count(image, colour) > 0.9 * 16 * points  # 4 x 4 pixels or more


@pytest.mark.parametrize("gap", [0.05, 0.2])
def test_only_the_edge_of_a_target_has_a_halo_in_close_views(viewport, gap):
    """Between the points of the surface, which are apart there, no halo covers other colours."""
    across, up = np.arange(-2.0, 2.001, 0.05), np.arange(0.0, 3.001, gap)
    grid = np.stack(np.meshgrid(across, up), -1).reshape(-1, 2)
    points = np.column_stack([grid[:, 0], np.full(len(grid), 15.0), grid[:, 1]])
    outline = outline_points(points)
    distance = np.minimum(2.0 - np.abs(grid[:, 0]), np.minimum(grid[:, 1], 3.0 - grid[:, 1]))
    assert outline[distance < 1e-6].all()
    assert not outline[distance > 4.5 * gap].any()
    viewport.show_clouds({"red": points}, {"red": RED})
    viewport.view("front")
    viewport.show_highlights([Highlight(("T1", "red"), points, RED, YELLOW)])
    viewport.select(("T1", ""))
    whole = picture(viewport)
    assert count(whole, YELLOW) > 300
    viewport.fit(points[np.abs(points - [0.0, 15.0, 1.5]).max(axis=1) < 0.5])
    close = picture(viewport)
    assert count(close, YELLOW) == 0
    assert count(close, RED) > 300


@pytest.mark.parametrize("width", [0.1, 1.0, 30.0, 200.0])
def test_shaded_sightings_cover_their_line_at_every_distance(viewport, width):
    """The line, which has noise of centimetres, is not drawn over the coloured sighting."""
    grey, shade = (188, 194, 200), (12, 200, 90)
    line = wall(15.0, (-1.0, 1.0), (0.0, 2.0), 0.02)
    line[:, 1] += np.random.default_rng(1).uniform(-0.015, 0.015, len(line))
    colouring = PointColouring(
        {"red": np.full((len(line), 3), grey, np.uint8)}, "Residual (mm)", "", "",
        np.zeros((2, 3), np.uint8),
    )  # fmt: skip
    viewport.show_clouds({"red": line}, {"red": RED}, colouring)
    viewport.view("front")
    middle = np.array([0.0, 15.0, 1.0])
    viewport.set_point_size(6)
    viewport.fit(middle + 0.5 * width * np.array([[-1.0, 0.0, -0.2], [1.0, 0.0, 0.2]]))
    centre = np.s_[150:450, 300:500]  # without axes and scale bar
    before = count(picture(viewport)[centre], grey)
    assert before > 20
    viewport.show_highlights(
        [Highlight(("V1", "red"), line, RED, YELLOW, np.full((len(line), 3), shade, np.uint8))]
    )
    image = picture(viewport)[centre]
    assert count(image, shade) > before
    assert count(image, grey) < 0.02 * before


def test_points_coloured_by_value_have_a_legend(viewport):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    plain = picture(viewport)
    assert count(plain, RED) > 300
    low, high = (12, 200, 90), (250, 60, 240)
    shades = {
        line: np.where(points[:, :1] < 0, [low], [high]).astype(np.uint8)
        for line, points in clouds.items()
    }
    scale = np.array([low, high], np.uint8)
    viewport.show_clouds(clouds, colours, PointColouring(shades, "Height (m)", "0", "12", scale))
    shaded = picture(viewport)
    assert count(shaded, RED) == count(shaded, BLUE) == 0
    assert min(count(shaded, low), count(shaded, high)) > 300
    assert (shaded[:60, :200] != plain[:60, :200]).any(axis=2).mean() > 0.5, "the legend"
    viewport.show_clouds(clouds, colours)
    np.testing.assert_array_equal(picture(viewport), plain)


def test_markers_show_even_behind_a_wall(viewport):
    viewport.show_clouds(*scene())
    without = picture(viewport)
    viewport.show_markers([Marker("T1", (0.0, 40.0, 1.0), YELLOW)])
    shown = picture(viewport)
    assert count(shown, YELLOW) > count(without, YELLOW) + 20


def test_large_clouds_are_reduced_to_the_point_budget(shown):
    view = shown(Budget(resting=4000, moving=500))
    cloud = wall(25.0, (-9.0, 9.0), (0.0, 9.0))
    view.show_clouds({"blue": cloud}, {"blue": BLUE})
    part = cloud[(np.abs(cloud[:, 0]) < 1.0) & (cloud[:, 2] < 2.0)]
    far = count(picture(view), BLUE)
    view.fit(part)
    near = picture(view)
    assert 2000 < far <= 4 * 4000
    # All points of a small part are drawn, although the budget is a quarter of the cloud.
    assert count(near, BLUE) > 0.95 * 4 * len(part)


def test_slow_frames_reduce_the_points_drawn_while_moving(shown):
    view = shown(Budget(resting=4000, moving=2000))
    view.show_clouds({"blue": wall(25.0, (-9.0, 9.0), (0.0, 9.0))}, {"blue": BLUE})

    def drawn():
        view.canvas.grabFramebuffer()
        actors = view.canvas.renderer.GetActors()
        return sum(
            actor.GetMapper().GetInput().GetNumberOfPoints()
            for actor in actors
            if actor.GetVisibility()
        )

    def move():
        view._navigator.mouse.rotated.emit(1.0, 0.0)
        return drawn()

    assert move() == 2000
    view._view_detail.compute_now(view._refinement_steps(view._times.rest_points))
    assert drawn() == 2 * 4000  # each point has a rim
    view._times.slice = 1
    view._detail_render_s = 1.0
    assert move() == 250
    view._view_detail.compute_now(view._refinement_steps(view._times.rest_points))
    assert drawn() == 2 * 4000


def test_empty_view_shows_instructions_again_after_clear(viewport):
    empty = picture(viewport)
    ink = int((empty.max(axis=2) < 120).sum())
    assert ink > 50
    viewport.show_clouds(*scene())
    viewport.show_markers([Marker("T1", (0.0, 15.0, 1.0), YELLOW)])
    viewport.clear()
    cleared = picture(viewport)
    np.testing.assert_array_equal(cleared, empty)


def test_resizing_keeps_all_points_in_view(viewport, qtbot):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    viewport.widget.resize(420, 700)
    qtbot.waitUntil(lambda: viewport.canvas.width() == 420)
    pixels = viewport.to_pixels(np.concatenate(list(clouds.values())))
    assert pixels.min() >= 0.0
    assert np.all(pixels.max(axis=0) <= [420, 700])
    with qtbot.waitSignal(viewport.signals.seed_clicked) as clicked:
        QTest.mouseClick(viewport.canvas, LEFT, CTRL, pixel(viewport, clouds["red"][600]))
    assert clicked.args[0].line == "red"


@pytest.fixture
def _slow_layout(monkeypatch: pytest.MonkeyPatch) -> None:
    """Keep the picture until the size has changed, however long this takes."""
    monkeypatch.setattr(navigation, "KEPT_TIME_S", WAIT_MS / 1000)


@pytest.mark.usefixtures("_slow_layout")
def test_a_panel_that_opens_leaves_the_scene_in_place(viewport, qtbot):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    finish_layouts()
    height = viewport.canvas.height()
    middle = viewport._navigator._surface_at(*viewport._navigator._middle_of_view())
    before = viewport.to_pixels(middle[None])[0]
    # Else the surface under the pointer would stay in place
    QCursor.setPos(viewport.widget.mapToGlobal(viewport.widget.rect().bottomRight()) * 1.1)
    viewport.keep_picture()
    viewport.widget.resize(viewport.widget.width(), height - 60)
    qtbot.waitUntil(lambda: viewport.canvas.height() == height - 60)
    np.testing.assert_allclose(viewport.to_pixels(middle[None])[0], before, atol=1.0)


@pytest.mark.usefixtures("_slow_layout")
def test_a_panel_that_opens_does_not_cover_the_selected_target(viewport, qtbot):
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    canvas = viewport.canvas
    height = canvas.height()
    pixels = viewport.to_pixels(clouds["red"])
    lowest = clouds["red"][np.argsort(pixels[:, 1])[-20:]]
    assert viewport.to_pixels(lowest)[:, 1].mean() > height - 120
    viewport.show_highlights([Highlight(("T1", "red"), lowest, (0, 0, 0), (0, 0, 0))])
    viewport.select(("T1", ""))
    viewport.keep_picture()
    viewport.widget.resize(viewport.widget.width(), height - 120)
    qtbot.waitUntil(lambda: canvas.height() == height - 120)
    x, y = viewport.to_pixels(lowest).T
    assert x.min() >= 0.0
    assert x.max() <= canvas.width()
    assert y.min() >= 0.0
    assert y.max() <= canvas.height() - 30.0
    before = viewport.to_pixels(lowest)
    viewport.keep_picture()
    viewport.widget.resize(viewport.widget.width(), height - 122)
    qtbot.waitUntil(lambda: canvas.height() == height - 122)
    np.testing.assert_allclose(viewport.to_pixels(lowest), before, atol=3.0)


@pytest.mark.parametrize("wrapper", ["_ctx", "_surface"])
def test_the_view_is_drawn_after_qt_objects_have_lost_their_python_wrappers(
    viewport, qtbot, wrapper
):
    """PySide sometimes invalidates wrappers of objects that still exist."""
    clouds, colours = scene()
    viewport.show_clouds(clouds, colours)
    viewport.view("front")
    qtbot.wait(100)
    shiboken6.invalidate(getattr(viewport.canvas, wrapper))
    viewport.widget.resize(viewport.widget.width() - 40, viewport.widget.height() - 60)
    viewport.view("top")
    viewport.view("front")
    qtbot.wait(300)
    screen = array_of(viewport.canvas.screen().grabWindow(viewport.widget.winId()).toImage())
    assert count(screen, RED) > 50
    assert count(picture(viewport), RED) > 50


def test_a_cross_shows_where_a_seed_would_be_set(viewport):
    viewport.show_clouds(*scene())
    viewport.canvas.setFocus()
    QTest.keyPress(viewport.canvas, Qt.Key.Key_Control)
    assert viewport.canvas.cursor().shape() == Qt.CursorShape.CrossCursor
    QTest.keyRelease(viewport.canvas, Qt.Key.Key_Control)
    assert viewport.canvas.cursor().shape() == Qt.CursorShape.ArrowCursor


def test_closing_twice_releases_all_objects(qtbot):
    if QGuiApplication.platformName() in ("offscreen", "minimal"):
        pytest.skip("OpenGL needs a screen, a virtual one will do")
    from lispac.gui.viewport.vtk_viewport import VtkViewport

    view = VtkViewport()
    view.widget.resize(300, 200)
    view.widget.show()
    qtbot.waitExposed(view.widget)
    view.show_clouds(*scene())
    renderer = weakref.ref(view.canvas.ren_win)
    alive = weakref.ref(view)
    view.close()
    view.close()
    view.widget.resize(320, 240)  # a late event of a closing window
    view.widget.close()
    view.widget.deleteLater()
    del view
    qtbot.wait(50)
    gc.collect()
    assert alive() is None
    assert renderer() is None


SEPARATE_PROGRAM = """
import sys
import numpy as np
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QCursor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMainWindow
from lispac.gui.viewport.vtk_viewport import VtkViewport

app = QApplication([])
window = QMainWindow()
view = VtkViewport(window)
window.setCentralWidget(view.widget)
window.resize(500, 400)
window.show()
QTest.qWaitForWindowExposed(window)
n, u = np.meshgrid(np.arange(-3, 3, 0.1), np.arange(0, 3, 0.1))
points = np.column_stack([n.ravel(), np.full(n.size, 20.0), u.ravel()])
view.show_clouds({"a": points}, {"a": (200, 0, 0)})
app.processEvents()
picked = []
view.signals.seed_clicked.connect(picked.append)
x, y = view.to_pixels(points[[700]])[0]
QTest.mouseClick(view.canvas, Qt.LeftButton, Qt.ControlModifier, QPoint(round(x), round(y)))
error = np.abs(np.array(picked[0].position) - points[700]).max()
print(view.canvas.devicePixelRatioF(), tuple(view.canvas.ren_win.GetSize()),
      (view.canvas.width(), view.canvas.height()), error < 0.11)
if "close" in sys.argv:
    view.close()
    window.close()
"""


@LONG
@pytest.mark.parametrize("ending", others_long(["close", "leave"]))
def test_high_resolution_screen_and_clean_exit(qapp, ending):
    if QGuiApplication.platformName() in ("offscreen", "minimal"):
        pytest.skip("OpenGL needs a screen, a virtual one will do")
    root = Path(__file__).resolve().parents[3]
    environment = {**os.environ, "QT_SCALE_FACTOR": "2", "PYTHONPATH": str(root)}
    done = subprocess.run(
        [sys.executable, "-c", SEPARATE_PROGRAM, ending],
        env=environment, capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert done.stdout.split(" ", 1)[0] == "2.0"
    assert "(1000, 800) (500, 400) True" in done.stdout
    assert "ERR" not in done.stderr


# The recording viewport


def test_recording_viewport_records_calls_and_clicks(qtbot):
    view = RecordingViewport()
    qtbot.addWidget(view.widget)
    clouds, colours = scene()
    view.show_clouds(clouds, colours)
    with qtbot.waitSignal(view.signals.seed_clicked) as clicked:
        view.click("red", 5)
    assert clicked.args[0] == PickedPoint("red", tuple(clouds["red"][5]))
    with qtbot.waitSignal(view.signals.missed):
        view.click_empty()
    view.set_line_visible("red", False)
    with pytest.raises(KeyError):
        view.click("red", 5)
    view.clear()
    view.close()
    assert [name for name, _ in view.calls] == ["show_clouds", "set_line_visible", "clear", "close"]


def test_both_viewports_implement_the_protocol():
    from lispac.gui.viewport.base import Viewport
    from lispac.gui.viewport.vtk_viewport import VtkViewport

    required = {name for name in vars(Viewport) if not name.startswith("_")}
    for kind in (VtkViewport, RecordingViewport):
        assert required <= set(dir(kind))
