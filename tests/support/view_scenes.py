"""Two walls one behind the other, in colours that can be found in a picture."""

import numpy as np
from PySide6.QtCore import QPoint
from PySide6.QtGui import QImage

from lispac.gui.viewport.camera import ViewportSize

BLUE, RED, GREEN = (0, 114, 178), (213, 94, 0), (0, 158, 115)
YELLOW = (240, 228, 66)
SIZE = ViewportSize(800, 600)


def wall(west, north=(-5.0, 5.0), up=(0.0, 6.0), step=0.1, origin=(0.0, 0.0, 0.0)):
    """Points of a vertical plane, perpendicular to the view from the origin to the west."""
    n, u = np.meshgrid(np.arange(*north, step), np.arange(*up, step), indexing="ij")
    points = np.column_stack([n.ravel(), np.full(n.size, west), u.ravel()])
    return points + np.asarray(origin)


def scene(origin=(0.0, 0.0, 0.0)):
    """A near red wall before a wider, farther blue one."""
    clouds = {
        "red": wall(15.0, (-2.0, 2.0), (0.0, 3.0), origin=origin),
        "blue": wall(25.0, (-9.0, 9.0), (0.0, 9.0), origin=origin),
    }
    return clouds, {"red": RED, "blue": BLUE}


def pixel(viewport, point):
    x, y = viewport.to_pixels(np.array([point]))[0]
    return QPoint(round(x), round(y))


def picture(viewport) -> np.ndarray:
    """Picture on the screen of shape (height, width, 3)."""
    return array_of(viewport.picture())


def array_of(image: QImage) -> np.ndarray:
    """Pixels of an image, shape (height, width, 3)."""
    image = image.convertToFormat(QImage.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).copy()


def count(image, colour):
    return int((np.abs(image.astype(int) - colour).max(axis=2) <= 2).sum())
