"""Two walls one behind the other, in colours that a picture can be searched for."""

import numpy as np

from lispac.gui.viewport.camera import Size

BLUE, RED, GREEN = (0, 114, 178), (213, 94, 0), (0, 158, 115)
YELLOW = (240, 228, 66)
SIZE = Size(800, 600)


def wall(west, north=(-5.0, 5.0), up=(0.0, 6.0), step=0.1, origin=(0.0, 0.0, 0.0)):
    """Points of a vertical plane across the view from the origin to the west."""
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
