"""Axes of a frame as directions on the vessel: forward, port, up and their opposites."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.language import N_, LazyText, gettext_lazy
from lispac.messages import Message, error, note

Array = NDArray[np.float64]
Axes = tuple[str, str, str]
"""Directions of X, Y and Z."""

_DIRECTION_VECTORS: dict[str, tuple[int, int, int]] = {
    N_("forward"): (1, 0, 0),
    N_("aft"): (-1, 0, 0),
    N_("port"): (0, 1, 0),
    N_("starboard"): (0, -1, 0),
    N_("up"): (0, 0, 1),
    N_("down"): (0, 0, -1),
}
DIRECTIONS = tuple(_DIRECTION_VECTORS)

FORWARD_PORT_UP: Axes = ("forward", "port", "up")
"""Axes of the body frame and of the LiDAR frame of this program."""


def axes_matrix(axes: Axes) -> Array:
    """Matrix that converts coordinates forward, port, up to coordinates along ``axes``.

    Parameters
    ----------
    axes : three words of `DIRECTIONS`

    Returns
    -------
    ndarray of shape (3, 3)
        A signed permutation; its determinant is -1 where the axes are left-handed.

    Raises
    ------
    InputError
        If a word is not a direction, or two axes are parallel or opposite.
    """
    for word in axes:
        if word not in _DIRECTION_VECTORS:
            raise InputError(error("survey.unknown_direction", word=word, directions=DIRECTIONS))
    matrix = np.array([_DIRECTION_VECTORS[word] for word in axes], dtype=float)
    if abs(np.linalg.det(matrix)) < 0.5:
        raise InputError(error("survey.axes_not_spanning", axes=axes))
    return matrix


def nearest_axes(rotation: Array) -> Axes:
    """Directions on the vessel that are nearest to the axes of a frame.

    Parameters
    ----------
    rotation : ndarray of shape (3, 3)
        From the frame to the body (forward, port, up).

    Returns
    -------
    three words of `DIRECTIONS`
        Always right-handed.
    """
    # The best of all 24 right-handed choices. If each axis were chosen separately, two axes of an
    # oblique frame could get the same direction.
    best: Axes = FORWARD_PORT_UP
    best_score = -np.inf
    for x in DIRECTIONS:
        for y in DIRECTIONS:
            if abs(np.dot(_DIRECTION_VECTORS[x], _DIRECTION_VECTORS[y])) > 0:
                continue
            axes = complete_axes(x, y)
            score = float(np.trace(axes_matrix(axes) @ rotation))
            if score > best_score + 1e-12:
                best, best_score = axes, score
    return best


def complete_axes(x: str, y: str) -> Axes:
    """Right-handed axes with the given directions of X and Y.

    Raises
    ------
    InputError
        If X and Y are parallel or opposite.
    """
    normal = np.cross(_DIRECTION_VECTORS[x], _DIRECTION_VECTORS[y])
    for z in DIRECTIONS:
        if np.array_equal(_DIRECTION_VECTORS[z], normal):
            return x, y, z
    raise InputError(
        error("survey.axes_on_one_line", x=direction_message(x), y=direction_message(y))
    )


DIRECTION_CODES = {
    "forward": "survey.direction_forward",
    "aft": "survey.direction_aft",
    "port": "survey.direction_port",
    "starboard": "survey.direction_starboard",
    "up": "survey.direction_up",
    "down": "survey.direction_down",
}
"""Code of the message that names each direction."""


def direction_message(word: str) -> Message:
    """A direction on the vessel as part of a message."""
    return note(DIRECTION_CODES[word])


def axes_text(axes: Sequence[str]) -> LazyText:
    """Text of axes, such as ``X forward, Y starboard, Z down``."""
    x, y, z = map(gettext_lazy, axes)
    return gettext_lazy("X {x}, Y {y}, Z {z}", x=x, y=y, z=z)
