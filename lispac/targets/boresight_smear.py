"""Effect of a wrong boresight on a plane measured from a moving platform."""

from math import radians

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

PRIOR_BORESIGHT_SIGMA, ROUGH_BORESIGHT_SIGMA = radians(2.0), radians(0.2)
"""Sigma in radians of each boresight angle: for a boresight without an estimate, and for a rough
one with which the lines nearly coincide."""


def remove_smear(
    placed: Array, off: Array, moves: Array, noise: float, boresight_sigma: float
) -> Array:
    """Distances without the part that a boresight error can explain.

    A boresight error shifts the points of a board along its normal. If the platform turns or moves
    during the measurement, the shifts differ and a flat board appears bent. The boresight error is
    estimated by least squares together with a plane. The sigma of the boresight constrains it, so
    that the real curvature of a board that was scanned in a short time is not removed.

    Parameters
    ----------
    placed : ndarray of shape (m, 2), metres, in the plane
    off : ndarray of shape (m,), metres
        Distances from the plane.
    moves : ndarray of shape (m, 3), metres per radian
        Derivatives of these distances with respect to the boresight angles.
    noise : float, metres
        Standard deviation of the distance of a point.
    boresight_sigma : float, radians
        Sigma of each angle of the boresight: `PRIOR_BORESIGHT_SIGMA` or `ROUGH_BORESIGHT_SIGMA`.

    Returns
    -------
    ndarray of shape (m,), metres
        Distances from the adjusted plane without the effect of the boresight error.
    """
    scale = max(float(np.abs(placed).max()), 1e-6)
    design = np.column_stack([np.ones(len(off)), placed / scale, moves * boresight_sigma])
    normal = np.einsum("ni,nj->ij", design, design) / noise**2
    normal[[3, 4, 5], [3, 4, 5]] += 1.0  # the angles in units of their sigma
    right = np.einsum("ni,n->i", design, off) / noise**2
    found = np.linalg.lstsq(normal, right, rcond=1e-14)[0]
    return np.asarray(off - design @ found)


def beam_intersections(
    points: Array, turns: Array, off: Array, beams: Array, normal: Array
) -> tuple[Array, Array]:
    """Intersections of beams and plane, and their derivatives with respect to the boresight.

    The derivatives at the points themselves depend on the distances of the points from the plane,
    because a point farther along its beam moves farther. At oblique incidence, the estimated
    boresight error would then absorb the shape of the surface. The derivatives are therefore
    computed at the intersections.

    Parameters
    ----------
    points : ndarray of shape (m, 3), metres, local frame
    turns : ndarray of shape (3, m, 3), metres per radian, local frame
    off : ndarray of shape (m,), metres
        Distances from the plane.
    beams : ndarray of shape (m, 3), metres, local frame
        Vectors from the scanner to each point.
    normal : ndarray of shape (3,), local frame
        Normal of the plane.
    """
    ahead = beams @ normal
    # The intersection of a grazing beam is poorly determined: such points are not changed.
    clear = np.abs(off) < 0.1 * np.abs(ahead)
    along = np.where(clear, off, 0.0) / np.where(clear, ahead, 1.0)
    return points - along[:, None] * beams, turns * (1.0 - along)[None, :, None]
