"""Conversion of boresight and lever arm between this program and others, as angles or matrices."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.language import N_, LazyText, gettext_lazy, join_sentences
from lispac.messages import Message, error, note
from lispac.survey.conventions.axes import (
    FORWARD_PORT_UP,
    Axes,
    axes_matrix,
    axes_text,
    direction_message,
    nearest_axes,
)
from lispac.survey.conventions.systems import (
    LISPAC_CONVENTION,
    SCANNER_WORDS,
    Convention,
    Scanner,
    Status,
)
from lispac.survey.georeferencing import Mounting

Array = NDArray[np.float64]

GIMBAL_LOCK_COSINE = 1e-8
"""Cosine of the middle angle below which the two outer angles are not separable."""
NEAR_GIMBAL_LOCK_COSINE = np.cos(np.radians(80.0))
"""Cosine of the middle angle below which the two outer angles are almost not separable."""
DEFINED_BY_FORMULA = N_("defined by the formula")
"""Meaning of an angle about body axes that the user has given."""
ORTHOGONALITY_TOLERANCE = 5e-6
"""Largest element of M Mᵀ - I for a typed matrix M, which may be rounded to six decimals."""


@dataclass(frozen=True)
class ConventionSetup:
    """A convention and its installation-dependent settings.

    Attributes
    ----------
    body_axes : directions of the system's body axes, if they differ from its convention
    scanner : rule for its scanner axes relative to the raw points, if it differs from the
        convention
    mounting : nominal directions of the raw scanner axes, for a system with a mounting; None for
        the axes nearest to the boresight, or forward, port, up if the boresight is unknown
    """

    convention: Convention
    body_axes: Axes | None = None
    scanner: Scanner | None = None
    mounting: Axes | None = None

    @property
    def axes(self) -> Axes:
        """Body axes used for the conversion."""
        return self.body_axes or self.convention.axes

    @property
    def scanner_frame(self) -> Scanner:
        """Rule for the scanner axes used for the conversion."""
        return self.scanner or self.convention.scanner

    @property
    def is_as_documented(self) -> bool:
        """Whether no setting deviates from the documented convention."""
        axes_kept = self.convention.open_axes or self.axes == self.convention.axes
        return axes_kept and self.scanner_frame == self.convention.scanner

    @property
    def status(self) -> Status:
        """Degree of verification of the convention, as it is used here."""
        return self.convention.status if self.is_as_documented else "unverified"

    @property
    def meanings(self) -> tuple[LazyText, ...]:
        """Sign of each angle; that of the convention holds for its own body axes only."""
        is_kept = self.axes == self.convention.axes
        return tuple(
            gettext_lazy(turn.meaning if is_kept else DEFINED_BY_FORMULA)
            for turn in self.convention.turns
        )

    @property
    def permutation(self) -> Array:
        """Matrix from this program's body axes to the system's, shape (3, 3)."""
        return axes_matrix(self.axes)

    def scanner_matrix(self, rotation_body_lidar: Array | None = None) -> Array:
        """Matrix from the raw scanner axes to those the angles refer to, shape (3, 3).

        Parameters
        ----------
        rotation_body_lidar : ndarray of shape (3, 3), optional

        Raises
        ------
        InputError
            If the scanner axes are kept or mounted, but the body axes are left-handed.
        """
        if self.scanner_frame == "turned":
            return self.permutation
        if np.linalg.det(self.permutation) < 0:
            x, y, z = map(direction_message, self.axes)
            raise InputError(
                error("survey.axes_left_handed", system=self.convention.name, x=x, y=y, z=z)
            )
        if self.scanner_frame == "kept":
            return np.eye(3)
        return self.permutation @ axes_matrix(self.nominal_axes(rotation_body_lidar)).T

    def nominal_axes(self, rotation_body_lidar: Array | None = None) -> Axes:
        """Nominal directions of the raw scanner axes.

        Parameters
        ----------
        rotation_body_lidar : ndarray of shape (3, 3), optional
            If known; the directions nearest to its axes are used.
        """
        if self.mounting is not None:
            return self.mounting
        return FORWARD_PORT_UP if rotation_body_lidar is None else nearest_axes(rotation_body_lidar)

    @property
    def assumption(self) -> LazyText | None:
        """Assumption about the system, shown with every number."""
        sentences = [gettext_lazy(self.convention.assumption)] if self.convention.assumption else []
        if not self.is_as_documented:
            sentences.append(
                gettext_lazy("The given axes differ from the documentation of the program.")
            )
        if self.convention.open_axes and self.body_axes is None:
            axes = axes_text(self.axes)
            sentences.append(gettext_lazy("No axes were given: {axes} is assumed.", axes=axes))
        return join_sentences(sentences) if sentences else None

    def scanner_axes(self, rotation_body_lidar: Array) -> LazyText:
        """Assumption about the scanner's axes.

        Parameters
        ----------
        rotation_body_lidar : ndarray of shape (3, 3)
        """
        sentences = [gettext_lazy(SCANNER_WORDS[self.scanner_frame])]
        if self.scanner_frame == "mounted":
            axes = axes_text(self.nominal_axes(rotation_body_lidar))
            sentences.append(gettext_lazy("Mounting used: scanner axes {axes}.", axes=axes))
        return join_sentences(sentences)


@dataclass(frozen=True, eq=False)
class MountingInSystem:
    """A boresight and a lever arm in the convention of another system.

    Attributes
    ----------
    angles : ndarray of shape (3,), radians, in the order of the input fields of the system; None if
        it takes a matrix only
    lever_arm : ndarray of shape (3,), metres, body axes of the system
    rotation : ndarray of shape (3, 3)
        Product of the angles; for a system without angles, scanner to body.
    transform : ndarray of shape (4, 4)
        From scanner to body coordinates of the system, including the lever arm. The scanner axes
        are those of the raw points if they are kept or mounted, otherwise those with the names of
        the body axes.
    sigmas : ndarray of shape (3,), radians, of the angles; None if unknown or at a gimbal lock
    note : message on the angles near a gimbal lock
    """

    setup: ConventionSetup
    angles: Array | None
    lever_arm: Array
    rotation: Array
    transform: Array
    sigmas: Array | None = None
    note: Message | None = None


def rotation_of_angles(convention: Convention, angles: Array) -> Array:
    """Matrix product of the angles of a system, shape (3, 3), no unit.

    Parameters
    ----------
    angles : ndarray of shape (3,), radians, in the order of `Convention.turns`
    """
    product = np.eye(3)
    for k in convention.order:
        turn = convention.turns[k]
        product = product @ _rotation_about_axis(turn.axis, turn.sign * float(angles[k]))
    return product


def angles_of_rotation(convention: Convention, rotation: Array) -> tuple[Array, Message | None]:
    """Angles with the product ``rotation``, and a message on them.

    Parameters
    ----------
    rotation : ndarray of shape (3, 3)

    Returns
    -------
    ndarray of shape (3,), radians, in the order of `Convention.turns`
        The middle factor in [-pi/2, pi/2], the outer ones in [-pi, pi].
    Message or None
        If the middle angle is within 10 deg of ±90 deg.
    """
    first, middle, last = (convention.turns[k] for k in convention.order)
    i, j, k = first.axis, middle.axis, last.axis
    parity = 1.0 if (j - i) % 3 == 1 else -1.0
    cosine = float(np.hypot(rotation[i, i], rotation[i, j]))
    names: dict[str, Any] = {
        "first": first.title, "middle": middle.title, "last": last.title,
    }  # fmt: skip
    message: Message | None = None
    if cosine < GIMBAL_LOCK_COSINE:
        # Both outer rotations are about the same axis: only their sum is determined.
        a = np.arctan2(parity * rotation[k, j], rotation[j, j])
        pole = 90 if parity * middle.sign * rotation[i, k] > 0 else -90
        message = note("convention.gimbal_lock", angle=np.radians(pole), **names)
    else:
        a = np.arctan2(-parity * rotation[j, k], rotation[k, k])
        if cosine < NEAR_GIMBAL_LOCK_COSINE:
            message = note("convention.near_gimbal_lock", **names)
    # The other angles are those of the rotation that remains after the first one. The product is
    # therefore exact even if the first angle itself is uncertain.
    rest = _rotation_about_axis(i, float(a)).T @ rotation
    b = np.arctan2(parity * rest[i, k], rest[k, k])
    c = np.arctan2(parity * rest[j, i], rest[j, j]) if cosine >= GIMBAL_LOCK_COSINE else 0.0
    angles = np.empty(3)
    for place, turn, value in zip(convention.order, (first, middle, last), (a, b, c), strict=True):
        # Negative zeros are written as 0.
        angles[place] = turn.sign * value + 0.0
    return angles, message


def convert_to_system(
    mounting: Mounting, setup: ConventionSetup, covariance: Array | None = None
) -> MountingInSystem:
    """Convert a mounting of this program to the convention of another system.

    Parameters
    ----------
    covariance : ndarray of shape (3, 3), radians squared
        Of roll, pitch and yaw in this program. It is propagated with the Jacobian of the
        conversion, but not used for a mounting with nominal axes.
    """
    convention, rotation = setup.convention, mounting.rotation_body_lidar
    if mounting.axes is not None:  # the covariance is that of a rotation about the body axes
        mounting, covariance = mounting.without_nominal_axes, None
    lever_arm = setup.permutation @ np.asarray(mounting.lever_arm, dtype=float)
    scanner = setup.scanner_matrix(rotation)
    coordinates = setup.permutation @ rotation @ scanner.T
    transform = np.eye(4)
    transform[:3, 3] = lever_arm
    mounted = setup.scanner_frame == "mounted"
    transform[:3, :3] = coordinates @ scanner if mounted else coordinates
    product = coordinates if convention.direction == "lidar_to_body" else coordinates.T
    converted = MountingInSystem(setup, None, lever_arm, product, transform)
    if not convention.has_angles:
        return converted
    angles, message = angles_of_rotation(convention, product)
    sigmas = None
    if covariance is not None:
        jacobian = angle_jacobian(setup, np.asarray(mounting.boresight, dtype=float))
        if jacobian is not None:
            sigmas = np.sqrt(np.diag(jacobian @ covariance @ jacobian.T))
    return replace(converted, angles=angles, sigmas=sigmas, note=message)


def convert_from_system(setup: ConventionSetup, rotation: Array, lever_arm: Array) -> Mounting:
    """Convert from another system to a mounting of this program, inverse of `convert_to_system`.

    Parameters
    ----------
    rotation : ndarray of shape (3, 3)
        Product of the angles of the system (`rotation_of_angles`); for a system without angles,
        scanner to body.
    lever_arm : ndarray of shape (3,), metres, body axes of the system
    """
    coordinates = rotation if setup.convention.direction == "lidar_to_body" else rotation.T
    body_lidar = setup.permutation.T @ coordinates @ setup.scanner_matrix()
    boresight, _ = angles_of_rotation(LISPAC_CONVENTION, body_lidar)
    return Mounting(setup.permutation.T @ np.asarray(lever_arm, dtype=float), boresight)


def mounting_of_angles(setup: ConventionSetup, angles: Array, lever_arm: Array) -> Mounting:
    """Mounting of this program from the angles and the lever arm of another system.

    Parameters
    ----------
    angles : ndarray of shape (3,), radians
        In the order of `Convention.turns`.
    lever_arm : ndarray of shape (3,), metres
        Along the body axes of the system.

    Raises
    ------
    InputError
        If the system takes a matrix only.
    """
    require_angles(setup.convention)
    return convert_from_system(setup, rotation_of_angles(setup.convention, angles), lever_arm)


def require_angles(convention: Convention) -> None:
    """Refuse angles of a system that takes a matrix only.

    Raises
    ------
    InputError
        If the convention has no angles.
    """
    if not convention.has_angles:
        raise InputError(error("survey.matrix_only", system=convention.name))


def require_rotation(matrix: Array) -> Array:
    """Rotation, shape (3, 3), nearest to a typed matrix, whose elements may be rounded.

    It is computed by the singular value decomposition (Schönemann 1966).

    Parameters
    ----------
    matrix : ndarray of shape (3, 3)

    Raises
    ------
    InputError
        If the matrix is a reflection, is not orthogonal to six decimals, or has another shape or
        values that are not finite.
    """
    if matrix.shape != (3, 3) or not np.isfinite(matrix).all():
        raise InputError(error("survey.matrix_shape"))
    deviation = float(np.abs(matrix @ matrix.T - np.eye(3)).max())
    if deviation > ORTHOGONALITY_TOLERANCE:
        raise InputError(error("survey.not_a_rotation", deviation=deviation))
    if np.linalg.det(matrix) < 0:
        raise InputError(error("survey.matrix_mirrors"))
    left, _, right = np.linalg.svd(matrix)
    return left @ right


def angle_jacobian(setup: ConventionSetup, boresight: Array) -> Array | None:
    """Derivatives of a system's angles with respect to roll, pitch and yaw of this program.

    Parameters
    ----------
    boresight : ndarray of shape (3,), radians, roll, pitch and yaw of this program

    Returns
    -------
    ndarray of shape (3, 3), no unit; None if the outer angles of the system are not separable
    """
    mounting = Mounting(np.zeros(3), boresight)
    rotation = mounting.rotation_body_lidar
    convention = setup.convention
    matrix = setup.permutation @ rotation @ setup.scanner_matrix(rotation).T
    # Small rotation vector in the body axes of the system; a left-handed permutation reverses it.
    turn = (
        np.linalg.det(setup.permutation)
        * setup.permutation
        @ rotation_vector_jacobian(LISPAC_CONVENTION, boresight)
    )
    if convention.direction == "body_to_lidar":
        matrix, turn = matrix.T, -matrix.T @ turn
    angles, _ = angles_of_rotation(convention, matrix)
    axes = rotation_vector_jacobian(convention, angles)
    if abs(np.linalg.det(axes)) < GIMBAL_LOCK_COSINE:
        return None
    return np.linalg.solve(axes, turn)


def rotation_vector_jacobian(convention: Convention, angles: Array) -> Array:
    """Derivatives of the small rotation vector with respect to the angles.

    Parameters
    ----------
    angles : ndarray of shape (3,), radians, in the order of `Convention.turns`

    Returns
    -------
    ndarray of shape (3, 3), no unit
        One column for each angle.
    """
    columns = np.empty((3, 3))
    before = np.eye(3)
    for k in convention.order:
        turn = convention.turns[k]
        columns[:, k] = turn.sign * before[:, turn.axis]
        before = before @ _rotation_about_axis(turn.axis, turn.sign * float(angles[k]))
    return columns


def _rotation_about_axis(axis: int, angle: float) -> Array:
    """Right-handed rotation about one axis."""
    c, s = np.cos(angle), np.sin(angle)
    y, z = (axis + 1) % 3, (axis + 2) % 3
    matrix = np.eye(3)
    matrix[y, y] = matrix[z, z] = c
    matrix[z, y], matrix[y, z] = s, -s
    return matrix
