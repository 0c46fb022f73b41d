"""Ways to look at the lines with real OpenGL: projections, views, what is drawn over them."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

from lispac.gui.viewport.base import Highlight
from tests.view_scenes import BLUE, RED, YELLOW, count, picture, pixel, scene, wall

CTRL = Qt.KeyboardModifier.ControlModifier
LEFT = Qt.MouseButton.LeftButton


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
