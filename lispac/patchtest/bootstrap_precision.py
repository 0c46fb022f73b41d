"""Bootstrap precision of the angles of a patch test, and objects that disagree with them.

The bootstrap (Efron 1979) resamples whole objects, each with all its lines. In each sample every
sighting also receives a simulated POS error with the given sigmas, correlated in time with the
correlation times of the POS (Gelb 1974).

Points or pairs of lines must not be resampled as if they were independent: all points of a line at
an object share one POS error, and objects that a line passes within a short time share most of it.
In forty simulated surveys, sigmas from resampled points or pairs were three to nine times too
small. Resampling the lines gave sigmas two to three times too small, because there were only six.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.parameters import mounting_value_name
from lispac.messages import Message, note
from lispac.patchtest.block_equations import BlockEquations, linearise_blocks
from lispac.patchtest.line_mismatch import Mismatch
from lispac.patchtest.mismatch_minimisation import (
    ANGLE_NAMES,
    MIN_ANGLE_SENSITIVITY,
    require_determined_angles,
)
from lispac.patchtest.object_sample import ObjectPoints
from lispac.survey.trajectory import TrajectoryAccuracy

Array = NDArray[np.float64]

MIN_OBJECTS = 5
"""Smallest number of objects for which sigmas are computed; fewer are too few to resample."""
BOOTSTRAP_SAMPLES = 1_000
"""Number of bootstrap samples."""
RANDOM_SEED = 1
"""Seed of the random numbers, fixed so that the same objects always give the same sigmas."""
MAX_DEVIATION_SIGMAS, OBJECT_TEST_LOSS_SCALE = 3.5, 0.5
"""Critical value and loss scale of the test of single objects.

The first is the largest deviation of an object's minimum from the common one, in sigmas; it is
large because three angles of about thirty objects are tested. The second is the scale of the robust
loss in this test, metres; it is large so that a line far from the others is not treated as an
outlier.
"""
OTHER_ERRORS_SIGMA = 0.01
"""Standard deviation of distances from errors other than angles and POS, metres.

Examples are rough surfaces and edges.
"""


@dataclass(frozen=True, eq=False)
class ObjectAgreement:
    """Agreement of one object with the minimum of all objects.

    Attributes
    ----------
    name : str
    pairs : tuple of str
        Names of the pairs of lines that overlap at the object.
    mismatch : float, metres
        Robust RMS distance between its lines at the minimum of all objects.
    angle : int or None
        Angle with the most significant difference: 0 roll, 1 pitch, 2 yaw. None if the object
        determines no angle; it is not tested then.
    difference : float, radians
        Minimum of this object alone in that angle, minus the minimum of all objects (linearised).
    limit : float, radians
        Largest absolute value of ``difference`` that is accepted.
    """

    name: str
    pairs: tuple[str, ...]
    mismatch: float
    angle: int | None
    difference: float
    limit: float

    @property
    def disagrees(self) -> bool:
        """Whether the minimum of this object deviates from that of all by more than allowed."""
        return self.angle is not None and abs(self.difference) > self.limit

    @property
    def disagreement(self) -> Message:
        """Message that the object disagrees, with the difference and its limit."""
        assert self.angle is not None
        return note(
            "patch_test.object_disagrees",
            object=self.name, angle=mounting_value_name(ANGLE_NAMES[self.angle]),
            difference=self.difference, usual=self.limit,
        )  # fmt: skip


@dataclass(frozen=True, eq=False)
class BootstrapPrecision:
    """Precision of the boresight at which the mismatch is smallest.

    Attributes
    ----------
    covariance : ndarray of shape (3, 3), square radians, or None
        Covariance of roll, pitch and yaw; None if there are too few objects.
    curvature : ndarray of shape (3,), metres per radian
        RMS displacement of the lines along the surface normals per radian of each angle.
    objects : tuple of ObjectAgreement
    """

    covariance: Array | None
    curvature: Array
    objects: tuple[ObjectAgreement, ...]


def bootstrap_precision(
    mismatch: Mismatch,
    boresight: Array,
    accuracy: TrajectoryAccuracy,
    position_time: float,
    attitude_time: float,
) -> BootstrapPrecision:
    """Estimate the precision of the minimum at ``boresight``, shape (3,), radians.

    Parameters
    ----------
    accuracy : TrajectoryAccuracy
    position_time, attitude_time : float, seconds
        Correlation times of the position error and of the attitude error of the POS.

    Raises
    ------
    AdjustmentError
        The objects do not determine one of the angles.
    """
    found = linearise_blocks(mismatch, boresight, pos_errors=True)
    weight = mismatch.weights * found.overlaps
    parts = _equations_by_object(mismatch, found, weight)
    total = np.sum([part.normal for part in parts], axis=0)
    require_determined_angles(total, float(weight.sum()), (0, 1, 2))
    row_of, roots = _pos_covariance_roots(mismatch, accuracy, position_time, attitude_time)
    squares = mismatch.mean_squares(boresight)
    wide = linearise_blocks(mismatch.with_scale(OBJECT_TEST_LOSS_SCALE), boresight, pos_errors=True)
    objects = tuple(
        _object_agreement(part, mismatch, row_of, roots, squares, weight)
        for part in _equations_by_object(mismatch, wide, weight)
    )
    covariance = None
    if len(parts) >= MIN_OBJECTS:
        covariance = _bootstrap_covariance(parts, row_of, roots)
    return BootstrapPrecision(covariance, np.sqrt(np.diag(total) / weight.sum()), objects)


@dataclass(frozen=True, eq=False)
class _ObjectEquations:
    """Normal equations of one object, and the effect of POS and other errors on its gradient."""

    name: str
    blocks: list[int]
    normal: Array
    gradient: Array
    pos_derivatives: dict[int, Array]
    other_errors: Array


def _equations_by_object(
    mismatch: Mismatch, equations: BlockEquations, weight: Array
) -> list[_ObjectEquations]:
    parts: dict[str, _ObjectEquations] = {}
    for k, block in enumerate(mismatch.blocks):
        if not weight[k]:
            continue
        name = block.first.object.name
        part = parts.setdefault(
            name, _ObjectEquations(name, [], np.zeros((3, 3)), np.zeros(3), {}, np.zeros(3))
        )
        part.blocks.append(k)
        part.normal[:] += weight[k] * equations.normal[k]
        part.other_errors[:] += (weight[k] * OTHER_ERRORS_SIGMA) ** 2 * np.diag(equations.normal[k])
        part.gradient[:] += weight[k] * equations.gradient[k]
        for side, points in enumerate((block.first, block.second)):
            by_pos = part.pos_derivatives.setdefault(id(points), np.zeros((3, 6)))
            by_pos += weight[k] * equations.pos_derivatives[k, side]
    return list(parts.values())


def _pos_covariance_roots(
    mismatch: Mismatch, accuracy: TrajectoryAccuracy, position_time: float, attitude_time: float
) -> tuple[dict[int, int], Array]:
    """Row of each sighting, and square roots of the covariances of POS errors, (6, s, s).

    The covariance of each of the six POS errors between the ``s`` sightings is ``root @ root.T``.
    """
    observed: dict[int, ObjectPoints] = {
        id(each): each for block in mismatch.blocks for each in (block.first, block.second)
    }
    time = np.array([each.time for each in observed.values()])
    sigma = np.hstack(accuracy.at(time))
    separation = np.abs(time[:, None] - time)
    roots = np.empty((6, len(time), len(time)))
    for k in range(6):
        shared = np.exp(-separation / (position_time if k < 3 else attitude_time))
        values, axes = np.linalg.eigh(shared * np.outer(sigma[:, k], sigma[:, k]))
        roots[k] = axes * np.sqrt(np.maximum(values, 0.0))
    return {key: row for row, key in enumerate(observed)}, roots


def _pos_error_gradients(part: _ObjectEquations, row_of: dict[int, int], roots: Array) -> Array:
    """Derivatives of a gradient by independent POS errors of unit variance, shape (3, 6 s)."""
    rows = [row_of[key] for key in part.pos_derivatives]
    by = np.stack(list(part.pos_derivatives.values()))  # (m, 3, 6)
    return np.einsum("mak,kms->aks", by, roots[:, rows]).reshape(3, -1)


def _object_agreement(
    part: _ObjectEquations, mismatch: Mismatch, row_of: dict[int, int], roots: Array,
    squares: Array, weight: Array,
) -> ObjectAgreement:  # fmt: skip
    own = weight[part.blocks]
    normal_diagonal = np.diag(part.normal)
    by_pos = _pos_error_gradients(part, row_of, roots)
    spread = np.sqrt((by_pos**2).sum(axis=1) + part.other_errors)
    determined = normal_diagonal >= MIN_ANGLE_SENSITIVITY**2 * own.sum()
    pairs = tuple(mismatch.blocks[k].pair.name for k in part.blocks)
    rms = float(np.sqrt((own * squares[part.blocks]).sum() / own.sum()))
    if not determined.any():
        return ObjectAgreement(part.name, pairs, rms, None, 0.0, 0.0)
    deviation = np.where(determined, np.abs(part.gradient) / np.maximum(spread, 1e-12), -1.0)
    angle = int(deviation.argmax())
    return ObjectAgreement(
        part.name,
        pairs,
        rms,
        angle,
        float(-part.gradient[angle] / normal_diagonal[angle]),
        float(MAX_DEVIATION_SIGMAS * spread[angle] / normal_diagonal[angle]),
    )


def _bootstrap_covariance(
    parts: Sequence[_ObjectEquations], row_of: dict[int, int], roots: Array
) -> Array:
    """Covariance of the angles over all bootstrap samples, shape (3, 3), square radians."""
    generator = np.random.default_rng(RANDOM_SEED)
    normal = np.stack([part.normal for part in parts])
    gradient = np.stack([part.gradient for part in parts])
    by_pos = np.stack([_pos_error_gradients(part, row_of, roots) for part in parts])
    object_count = len(parts)
    repeats = generator.multinomial(
        object_count, np.full(object_count, 1.0 / object_count), BOOTSTRAP_SAMPLES
    ).astype(float)
    pos_errors = generator.standard_normal((by_pos.shape[2], BOOTSTRAP_SAMPLES))
    errors = gradient[:, :, None] + np.einsum("oas,sd->oad", by_pos, pos_errors)
    sample_normal = np.einsum("do,oij->dij", repeats, normal)
    # Samples with few different objects may be singular; a small part of the sum of all objects
    # regularises them.
    sample_normal += 1e-3 * normal.sum(axis=0)
    sample_gradient = np.einsum("do,oad->da", repeats, errors)
    angles = -np.linalg.solve(sample_normal, sample_gradient[..., None])[..., 0]
    return np.asarray(np.cov(angles.T))
