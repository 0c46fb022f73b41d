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

_DIRECTIONS: dict[str, tuple[int, int, int]] = {
    N_("forward"): (1, 0, 0),
    N_("aft"): (-1, 0, 0),
    N_("port"): (0, 1, 0),
    N_("starboard"): (0, -1, 0),
    N_("up"): (0, 0, 1),
    N_("down"): (0, 0, -1),
}
DIRECTIONS = tuple(_DIRECTIONS)

FORWARD_PORT_UP: Axes = ("forward", "port", "up")
"""The axes of this program, of the body as of the scanner."""


def axes_matrix(axes: Axes) -> Array:
    """Matrix that turns coordinates forward, port, up into those along ``axes``.

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
        If a word is not a direction, or two axes lie on one line.
    """
    for word in axes:
        if word not in _DIRECTIONS:
            raise InputError(error("survey.unknown_direction", word=word, directions=DIRECTIONS))
    matrix = np.array([_DIRECTIONS[word] for word in axes], dtype=float)
    if abs(np.linalg.det(matrix)) < 0.5:
        raise InputError(error("survey.axes_not_spanning", axes=axes))
    return matrix


def nearest_axes(rotation: Array) -> Axes:
    """The directions of the vessel that a frame's axes are nearest to.

    Parameters
    ----------
    rotation : ndarray of shape (3, 3)
        From the frame to the body (forward, port, up).

    Returns
    -------
    three words of `DIRECTIONS`
        Right-handed for a right-handed frame.
    """
    # The best of the 24 right-handed choices as a whole: axis by axis two of them could fall on
    # the same direction of a frame mounted askew.
    best: Axes = FORWARD_PORT_UP
    best_score = -np.inf
    for x in DIRECTIONS:
        for y in DIRECTIONS:
            if abs(np.dot(_DIRECTIONS[x], _DIRECTIONS[y])) > 0:
                continue
            axes = complete_axes(x, y)
            score = float(np.trace(axes_matrix(axes) @ rotation))
            if score > best_score + 1e-12:
                best, best_score = axes, score
    return best


def complete_axes(x: str, y: str) -> Axes:
    """The right-handed axes whose first two are given.

    Raises
    ------
    InputError
        If the two lie on one line.
    """
    across = np.cross(_DIRECTIONS[x], _DIRECTIONS[y])
    for z in DIRECTIONS:
        if np.array_equal(_DIRECTIONS[z], across):
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


def direction_message(word: str) -> Message:
    """A direction on the vessel as part of a message."""
    return note(DIRECTION_CODES[word])


def axes_text(axes: Sequence[str]) -> LazyText:
    """``X forward, Y starboard, Z down``."""
    x, y, z = map(gettext_lazy, axes)
    return gettext_lazy("X {x}, Y {y}, Z {z}", x=x, y=y, z=z)
