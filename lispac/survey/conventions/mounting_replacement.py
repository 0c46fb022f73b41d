"""Mounting that is set in another program, and the mounting that replaces it there."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Message, note
from lispac.survey.conventions.axes import axes_matrix, nearest_axes
from lispac.survey.conventions.conversion import (
    ConventionSetup,
    MountingInSystem,
    convert_to_system,
)
from lispac.survey.conventions.correction import (
    BoresightCorrection,
    add_to_applied_boresight,
    correct_boresight,
)
from lispac.survey.conventions.matrix_input import angle_product_of_matrix
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

LeverArm = Literal["none", "given", "replaced", "taken over", "on top", "turned"]
"""Origin of the new lever arm."""
_LEVER_ARM_CODES: dict[LeverArm, str] = {
    "replaced": "convention.lever_arm_replaced",
    "taken over": "convention.lever_arm_kept",
    "on top": "convention.lever_arm_added",
    "turned": "convention.lever_arm_turned",
}


@dataclass(frozen=True, eq=False)
class CurrentMountingInSystem:
    """Boresight, and lever arm if known, that are currently set in another program.

    Attributes
    ----------
    values : ndarray of shape (3,), radians, in the order of `Convention.turns`
        Or their product, of shape (3, 3).
    transform : ndarray of shape (4, 4), or None
        Scanner to body as in `MountingInSystem.transform`; None if no lever arm was given.
    """

    values: Array
    transform: Array | None = None

    @property
    def lever_arm(self) -> Array | None:
        """Lever arm of the 4x4 matrix, shape (3,), metres, body axes of the system."""
        return None if self.transform is None else np.asarray(self.transform[:3, 3])


@dataclass(frozen=True, eq=False)
class MountingReplacement:
    """New mounting for another program, and the correction from the current one.

    Attributes
    ----------
    mounting : new mounting of the raw scanner, in the convention of this program
    covariance : ndarray of shape (3, 3), radians squared, of its boresight; None if unknown
    in_system : new mounting in the convention of the other program
    current, correction : None if no current mounting was given
    transform : ndarray of shape (4, 4), or None
        The matrix that, multiplied by the current transform from the right, is the new one; None if
        the current lever arm is unknown.
    lever_arm : origin of the new lever arm
    """

    mounting: Mounting
    covariance: Array | None
    in_system: MountingInSystem
    current: CurrentMountingInSystem | None
    correction: BoresightCorrection | None
    transform: Array | None
    lever_arm: LeverArm

    @property
    def has_lever_arm(self) -> bool:
        """Whether the new lever arm is known."""
        return self.lever_arm != "none"

    @property
    def lever_arm_note(self) -> Message | None:
        """Message on the origin of the new lever arm; None if it was given or is unknown."""
        code = _LEVER_ARM_CODES.get(self.lever_arm)
        return None if code is None else note(code)


def current_mounting_of_matrix(
    setup: ConventionSetup, rotation: Array, lever_arm: Array | None
) -> CurrentMountingInSystem:
    """Current mounting from the matrix from scanner to body.

    Parameters
    ----------
    rotation : ndarray of shape (3, 3)
    lever_arm : ndarray of shape (3,), metres, body axes of the system; None for a 3x3 matrix
    """
    values = angle_product_of_matrix(setup, rotation)
    if lever_arm is None:
        return CurrentMountingInSystem(values)
    transform = np.eye(4)
    transform[:3, :3], transform[:3, 3] = rotation, lever_arm
    return CurrentMountingInSystem(values, transform)


def replace_mounting(
    setup: ConventionSetup,
    estimated: Mounting,
    covariance: Array | None,
    current: CurrentMountingInSystem | None,
    *,
    applied: bool,
    has_lever_arm: bool,
) -> MountingReplacement:
    """Compute the mounting that replaces the current one in another program.

    Parameters
    ----------
    estimated : Mounting
        Estimated from the lines that were imported into this program.
    covariance : ndarray of shape (3, 3), radians squared, of its boresight
    applied : bool
        Whether the imported lines were already rotated by the current mounting, and shifted if it
        has a lever arm.
    has_lever_arm : bool
        Whether the lever arm of ``estimated`` is known; otherwise its zeros have no meaning.
    """
    mounting, source = estimated, _lever_arm_source(current, applied, has_lever_arm)
    if current is not None and applied:
        mounting, covariance = add_to_applied_boresight(
            setup, current.values, estimated, covariance
        )
    if current is not None and current.transform is not None:
        old = setup.permutation.T @ current.transform[:3, 3]
        if applied:
            # The axes of such lines are the body axes, or other directions of the body.
            remainder = estimated.rotation_body_lidar
            old = remainder @ axes_matrix(nearest_axes(remainder)) @ old
            mounting = replace(mounting, lever_arm=estimated.lever_arm + old)
        elif not has_lever_arm:
            mounting = replace(mounting, lever_arm=old)
    new = convert_to_system(mounting, setup, covariance)
    correction = transform = None
    if current is not None:
        correction = correct_boresight(setup.convention, current.values, new.rotation)
        if current.transform is not None:
            transform = new.transform @ np.linalg.inv(current.transform)
    return MountingReplacement(mounting, covariance, new, current, correction, transform, source)


def _lever_arm_source(
    current: CurrentMountingInSystem | None, applied: bool, has_lever_arm: bool
) -> LeverArm:
    if current is None or current.transform is None:
        return "given" if has_lever_arm else "none"
    if applied:
        return "on top" if has_lever_arm else "turned"
    return "replaced" if has_lever_arm else "taken over"
