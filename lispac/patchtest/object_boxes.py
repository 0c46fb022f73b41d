"""Boxes around objects of the patch test: a pole, a pillar, a crane leg, the edge of a wall."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import error

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

UP = np.array([0.0, 0.0, 1.0])
MIN_SIDE, MAX_SIDE = 0.1, 200.0
"""Smallest and largest side of a box, metres."""


@dataclass(frozen=True, eq=False)
class ObjectBox:
    """Box with vertical sides and any horizontal orientation.

    Attributes
    ----------
    centre : ndarray of shape (3,), metres, local frame
    size : ndarray of shape (3,), metres, along the axes of the box
        Lengths ahead, left and up.
    turn : float, radians
        Azimuth of the axis ahead, clockwise from north.
    """

    centre: Array
    size: Array
    turn: float = 0.0

    @property
    def axes(self) -> Array:
        """Unit vectors ahead, left and up as rows, shape (3, 3), local frame."""
        ahead = np.array([np.cos(self.turn), -np.sin(self.turn), 0.0])
        return np.array([ahead, np.cross(UP, ahead), UP])

    @property
    def reach(self) -> float:
        """Distance of a corner from the centre, metres."""
        return 0.5 * float(np.linalg.norm(self.size))

    def inside(self, points: Array, margin: float = 0.0) -> Flags:
        """Whether each point lies in the box, shape (n,).

        Parameters
        ----------
        points : ndarray of shape (n, 3), metres, local frame
        margin : float, metres
            Distance by which the box is enlarged on every side.
        """
        placed = np.abs((points - self.centre) @ self.axes.T)
        return np.asarray((placed <= 0.5 * self.size + margin).all(axis=1))


@dataclass(frozen=True, eq=False)
class PatchObject:
    """Object at which lines are compared with each other, and the box around it."""

    name: str
    box: ObjectBox


def object_of_box(name: str, box: ObjectBox) -> PatchObject:
    """Create an object from a user-defined box after validating it.

    Raises
    ------
    InputError
        A side is too short or too long, or the centre or the azimuth is not finite.
    """
    if not (np.isfinite(box.centre).all() and np.isfinite(box.turn)):
        raise InputError(error("patch_test.box_not_finite", name=name))
    if not ((box.size >= MIN_SIDE) & (box.size <= MAX_SIDE)).all():
        raise InputError(error("patch_test.box_size", name=name, least=MIN_SIDE, most=MAX_SIDE))
    return PatchObject(name, box)
