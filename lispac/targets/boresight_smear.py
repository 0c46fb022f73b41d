"""Effect of a wrong boresight on a plane measured from a moving platform."""

from math import radians

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

PRIOR_OFF, ROUGHLY_OFF = radians(2.0), radians(0.2)
"""Sigma of each angle of a boresight that nothing has been estimated for, and of one that makes the
lines nearly meet, radians."""


def remove_smear(placed: Array, off: Array, moves: Array, noise: float, off_by: float) -> Array:
    """Distances without the part that a boresight error can explain.

    A turn of the LiDAR moves the points of a board along its normal. Where the platform turns or
    travels meanwhile they do not move alike, and a flat board is placed bent. The turn that
    explains most is searched for by least squares together with a plane; it is held to what the
    boresight may be off by, so that a board crossed in no time keeps its own bend.

    Parameters
    ----------
    placed : ndarray of shape (m, 2), metres, in the plane
    off : ndarray of shape (m,), metres, from the plane
    moves : ndarray of shape (m, 3), metres per radian
        Along the normal, as each angle turns.
    noise : float, metres
        Of a point.
    off_by : float, radians
        Sigma of each angle of the boresight: `PRIOR_OFF` or `ROUGHLY_OFF`.

    Returns
    -------
    ndarray of shape (m,), metres
        From the plane that is left.
    """
    scale = max(float(np.abs(placed).max()), 1e-6)
    design = np.column_stack([np.ones(len(off)), placed / scale, moves * off_by])
    normal = np.einsum("ni,nj->ij", design, design) / noise**2
    normal[[3, 4, 5], [3, 4, 5]] += 1.0  # the angles in units of their sigma
    right = np.einsum("ni,n->i", design, off) / noise**2
    found = np.linalg.lstsq(normal, right, rcond=1e-14)[0]
    return np.asarray(off - design @ found)


def beam_intersections(
    points: Array, turns: Array, off: Array, beams: Array, normal: Array
) -> tuple[Array, Array]:
    """Intersections of beams and plane, and their derivatives by the boresight.

    A point off the plane lies farther along its beam, and moves farther. Both are the surface's own
    shape once more, which the turns would explain with itself where the beams meet it aslant.

    Parameters
    ----------
    points : ndarray of shape (m, 3), metres, local frame
    turns : ndarray of shape (3, m, 3), metres per radian, local frame
    off : ndarray of shape (m,), metres, from the plane
    beams : ndarray of shape (m, 3), metres, local frame
        From the scanner to each point.
    normal : ndarray of shape (3,), local frame
        Of the plane.
    """
    ahead = beams @ normal
    # A grazing beam intersects the plane anywhere: there points are left as they are.
    clear = np.abs(off) < 0.1 * np.abs(ahead)
    along = np.where(clear, off, 0.0) / np.where(clear, ahead, 1.0)
    return points - along[:, None] * beams, turns * (1.0 - along)[None, :, None]
