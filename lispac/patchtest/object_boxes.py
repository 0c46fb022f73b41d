"""Boxes about objects: a pole, a pillar, the leg of a crane, the edge of a wall."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import error

Array = NDArray[np.float64]
Flags = NDArray[np.bool_]

UP = np.array([0.0, 0.0, 1.0])
SMALLEST, LARGEST = 0.1, 200.0
"""Sides of a box, metres."""


@dataclass(frozen=True, eq=False)
class ObjectBox:
    """An upright box, turned about the vertical.

    Attributes
    ----------
    centre : ndarray of shape (3,), metres, local frame
    size : ndarray of shape (3,), metres, local frame
        Along its own axes: ahead, to the left, upwards.
    turn : float, radians
        Where ahead is, clockwise from north.
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
            By which the box is larger on every side.
        """
        placed = np.abs((points - self.centre) @ self.axes.T)
        return np.asarray((placed <= 0.5 * self.size + margin).all(axis=1))


@dataclass(frozen=True, eq=False)
class PatchObject:
    """An object at which lines are aligned with each other."""

    name: str
    box: ObjectBox


def object_of_box(name: str, box: ObjectBox) -> PatchObject:
    """Create an object from a user-defined box, which is validated.

    Raises
    ------
    InputError
        A side that is no length, or a centre that is no place.
    """
    if not (np.isfinite(box.centre).all() and np.isfinite(box.turn)):
        raise InputError(error("patch_test.box_not_finite", name=name))
    if not ((box.size >= SMALLEST) & (box.size <= LARGEST)).all():
        raise InputError(error("patch_test.box_size", name=name, least=SMALLEST, most=LARGEST))
    return PatchObject(name, box)
