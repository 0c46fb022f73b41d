"""Correction to settings of another program: a product of rotations, not a sum."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.survey.conventions.axes import axes_matrix, nearest_axes
from lispac.survey.conventions.conversion import (
    ConventionSetup,
    angles_of_rotation,
    convert_from_system,
    require_angles,
    rotation_of_angles,
    rotation_vector_jacobian,
)
from lispac.survey.conventions.systems import LISPAC_CONVENTION, Convention
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

SUM_TOLERANCE_RAD = float(np.radians(0.0005))
"""Largest error of a sum of angles that may replace the product of rotations: 1 mm at 100 m."""


@dataclass(frozen=True, eq=False)
class BoresightCorrection:
    """Correction from the current to the new settings of another program.

    Attributes
    ----------
    current_rotation : ndarray of shape (3, 3)
        Product of the current angles.
    rotation : ndarray of shape (3, 3)
        ``rotation @ current_rotation`` is the product of the new angles.
    current, new : ndarray of shape (3,), radians, in the order of `Convention.turns`
        None for a program that takes a matrix only.
    correction : ndarray of shape (3,), radians
        Angles of ``rotation`` in the same convention; None for a program that takes a matrix only.
    sum_error : float, radians
        Angle between the rotations of ``current + correction`` and of ``new``; 0 for a program that
        takes a matrix only.
    """

    current_rotation: Array
    rotation: Array
    current: Array | None = None
    new: Array | None = None
    correction: Array | None = None
    sum_error: float = 0.0


def correct_boresight(
    convention: Convention, current: Array, target_boresight: Array
) -> BoresightCorrection:
    """Compute the correction from the current settings to a required boresight.

    Parameters
    ----------
    current : ndarray of shape (3,), radians, in the order of `Convention.turns`
        Or their product, of shape (3, 3).
    target_boresight : ndarray of shape (3, 3)
        Product of the new angles, see `MountingInSystem.rotation`.

    Raises
    ------
    InputError
        If ``current`` contains angles, but the system takes a matrix only.
    """
    current_rotation = _angle_product(convention, current)
    rotation = target_boresight @ current_rotation.T
    if not convention.has_angles:
        return BoresightCorrection(current_rotation, rotation)
    if current.ndim == 2:
        current, _ = angles_of_rotation(convention, current_rotation)
    new, _ = angles_of_rotation(convention, target_boresight)
    correction, _ = angles_of_rotation(convention, rotation)
    summed = rotation_of_angles(convention, current + correction)
    sum_error = angle_between_rotations(summed, target_boresight)
    return BoresightCorrection(current_rotation, rotation, current, new, correction, sum_error)


def _angle_product(convention: Convention, current: Array) -> Array:
    if current.ndim == 2:
        return current
    require_angles(convention)
    return rotation_of_angles(convention, current)


def add_to_applied_boresight(
    setup: ConventionSetup, current: Array, estimated: Mounting, covariance: Array | None = None
) -> tuple[Mounting, Array | None]:
    """Total boresight of lines that are already rotated by the current settings.

    The axes of such lines are parallel to the body axes except for the error of these settings. The
    boresight estimated from them is this error; its rotation is multiplied from the left.

    Parameters
    ----------
    current : ndarray of shape (3,), radians, in the order of `Convention.turns`
        Or their product, of shape (3, 3).
    estimated : Mounting
        Estimated from the rotated lines.
    covariance : ndarray of shape (3, 3), radians squared, of the estimated boresight

    Returns
    -------
    Mounting
        Of the raw scanner, with the lever arm of ``estimated``.
    ndarray of shape (3, 3), radians squared, or None
        Covariance of its boresight.
    """
    current_rotation = _angle_product(setup.convention, current)
    old = convert_from_system(setup, current_rotation, np.zeros(3)).rotation_body_lidar
    remainder = estimated.rotation_body_lidar
    # The axes of the rotated lines may be any directions of the body, such as forward, starboard,
    # down.
    rotation = remainder @ axes_matrix(nearest_axes(remainder)) @ old
    whole = estimated.with_boresight(angles_of_rotation(LISPAC_CONVENTION, rotation)[0])
    if covariance is None:
        return whole, None
    jacobian = np.linalg.solve(
        rotation_vector_jacobian(LISPAC_CONVENTION, whole.boresight),
        rotation_vector_jacobian(LISPAC_CONVENTION, estimated.boresight),
    )
    return whole, jacobian @ covariance @ jacobian.T


def angle_between_rotations(one: Array, other: Array) -> float:
    """Angle, radians, of the rotation from ``one`` to ``other``, both of shape (3, 3)."""
    difference = one @ other.T
    # From the skew-symmetric part, because the arc cosine loses half the digits of a small angle.
    skew = np.array(
        [
            difference[2, 1] - difference[1, 2],
            difference[0, 2] - difference[2, 0],
            difference[1, 0] - difference[0, 1],
        ]
    )
    return float(np.arctan2(np.linalg.norm(skew), np.trace(difference) - 1))
