"""Times of a frame, a pick and a change of data in the viewport with six million points."""

import time

import numpy as np
import pytest
from PySide6.QtGui import QGuiApplication

from lispac.gui.viewport.camera import Camera, ViewportSize
from lispac.gui.viewport.decimation import points_in_view
from lispac.gui.viewport.point_picker import pick_point

LINES = 6
POINTS = 1_000_000
COLOURS = [
    (0, 114, 178),
    (213, 94, 0),
    (0, 158, 115),
    (204, 121, 167),
    (230, 159, 0),
    (86, 180, 233),
]


def harbour():
    """Six noisy samples of a quay wall with a tower on it."""
    rng = np.random.default_rng(1)
    clouds = {}
    for k in range(LINES):
        points = rng.uniform([-30.0, 20.0, -2.0], [30.0, 22.0, 6.0], size=(POINTS, 3))
        tower = rng.random(POINTS) < 0.3
        points[tower] = rng.uniform([-4.0, 30.0, 0.0], [4.0, 31.0, 45.0], size=(tower.sum(), 3))
        clouds[f"L{k + 1}"] = points
    return clouds


def median_ms(function, rounds=5):
    times = []
    for _ in range(rounds):
        start = time.perf_counter()
        function()
        times.append(time.perf_counter() - start)
    return 1000.0 * float(np.median(times))


def test_pick_among_six_million():
    clouds = harbour()
    size = ViewportSize(1200, 800)
    camera = Camera(np.array([0.0, 25.0, 10.0]), -1.2, 0.4, 90.0)
    took = median_ms(lambda: pick_point(clouds, camera, 600.0, 420.0, size))
    view_ms = median_ms(
        lambda: [points_in_view(points, camera, size) for points in clouds.values()]
    )
    print(
        f"\npick among {LINES * POINTS:,} points: {took:.0f} ms; "
        f"which are in view: {view_ms:.0f} ms"
    )


def test_frames(qtbot):
    if QGuiApplication.platformName() in ("offscreen", "minimal"):
        pytest.skip("OpenGL needs a screen, a virtual one will do")
    from lispac.gui.viewport.vtk_viewport import VtkViewport

    clouds = harbour()
    view = VtkViewport()
    view.widget.resize(1200, 800)
    view.widget.show()
    qtbot.waitExposed(view.widget)
    colours = dict(zip(clouds, COLOURS, strict=True))
    load = median_ms(lambda: view.show_clouds(clouds, colours), rounds=3)
    mouse = view._navigator.mouse

    def moved():
        mouse.rotated.emit(3.0, 0.0)
        view.canvas.grabFramebuffer()

    def rested():
        mouse.rotated.emit(3.0, 0.0)
        view._view_detail.compute_now(view._refinement_steps(view._times.rest_points))
        view.canvas.grabFramebuffer()

    moved()
    moving = median_ms(moved, rounds=10)
    resting = median_ms(rested)
    view.close()
    view.widget.close()
    print(
        f"\n{LINES} lines of {POINTS:,} points at 1200 x 800: lines replaced {load:.0f} ms, "
        f"moving frame {moving:.0f} ms, picture at rest {resting:.0f} ms"
    )
