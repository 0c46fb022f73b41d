"""Minimise the mismatch over the angles, one by one or all three together.

One by one, the angles are estimated in the classical order of a patch test:

- Roll. An error moves points beside the vessel vertically and points high above it sideways, in
  opposite directions on reciprocal lines. Horizontal and vertical surfaces reveal it, even if the
  other two angles have errors.
- Pitch. An error moves points high above the vessel along the course, in opposite directions on
  reciprocal lines. Poles and edges reveal it once the roll is corrected.
- Yaw. An error rotates all points about the vertical. At a given object it has the same effect on
  reciprocal lines at the same distance, so that they do not reveal it. Lines that cross, or that
  pass at another distance or on the other side, reveal it once roll and pitch are corrected.

Errors of the later angles affect the estimates of the earlier ones, so the sequence is repeated.

The scale of the robust loss decreases from stage to stage. It is large at first, because the lines
may be half a metre apart, and small in the end, to limit the influence of outliers.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.errors import AdjustmentError
from lispac.language import N_, gettext_lazy
from lispac.messages import error
from lispac.patchtest.block_equations import linearise_blocks
from lispac.patchtest.line_mismatch import LOSS_SCALE, Mismatch, PairBlock
from lispac.patchtest.object_sample import ObjectSample
from lispac.progress import Progress, no_progress

Array = NDArray[np.float64]

ANGLE_NAMES = ("roll", "pitch", "yaw")
PROGRESS_TEXTS = (N_("Optimising roll"), N_("Optimising pitch"), N_("Optimising yaw"))
"""Texts of the progress while each angle is optimised."""
UNDETERMINED_CODES = ("patch_test.no_roll", "patch_test.no_pitch", "patch_test.no_yaw")
"""Codes of the messages that roll, pitch or yaw is not determined."""
LOSS_SCALES = (0.5, 0.2, LOSS_SCALE)
"""Scale of the robust loss in each stage, metres."""
MAX_STEPS, MAX_ITERATIONS = 6, 12
"""Largest number of steps of a stage, and of iterations over the three angles one by one."""
STEP_TOLERANCE = np.radians(2e-4)
"""Largest change of an angle in the last step or iteration for convergence, radians."""
MAX_STEP = np.radians(1.0)
"""Largest change of an angle in one step, radians."""
MIN_ANGLE_SENSITIVITY = 2.0
"""Smallest RMS displacement of surfaces along their normals for a determined angle.

In metres per radian, the same value as in `lispac.targets.rough_alignment`.
"""


@dataclass(frozen=True, eq=False)
class MismatchMinimum:
    """Boresight at which the mismatch of the lines is smallest.

    Attributes
    ----------
    boresight : ndarray of shape (3,), radians
    iterations : int
        Number of iterations over the angles one by one; 1 if they were estimated together.
    converged : bool
        Whether no angle changed by more than `STEP_TOLERANCE` in the last step or iteration.
    """

    boresight: Array
    iterations: int
    converged: bool


def minimise_mismatch(
    sample: ObjectSample,
    blocks: Sequence[PairBlock],
    start: Array,
    angles: Sequence[int] = (0, 1, 2),
    *,
    progress: Progress = no_progress,
) -> MismatchMinimum:
    """Minimise the mismatch over some angles together; the others are fixed.

    Parameters
    ----------
    start : ndarray of shape (3,), radians
    angles : sequence of int
        0 roll, 1 pitch, 2 yaw.

    Raises
    ------
    AdjustmentError
        No lines overlap at an object, or the objects do not determine one of the angles.
    """
    boresight = np.array(start, dtype=float)
    turned = list(angles)
    converged = False
    whole = Mismatch(sample, blocks)
    for stage, scale in enumerate(LOSS_SCALES):
        mismatch = whole.with_scale(scale)
        for number in range(MAX_STEPS):
            progress(
                (stage + number / MAX_STEPS) / len(LOSS_SCALES),
                gettext_lazy("Optimising the angles"),
            )
            step = _angle_step(mismatch, boresight, turned)
            boresight[turned] += step
            converged = bool(np.abs(step).max() <= STEP_TOLERANCE)
            if converged:
                break
    return MismatchMinimum(boresight, 1, converged)


def minimise_angle_by_angle(
    sample: ObjectSample,
    blocks: Sequence[PairBlock],
    start: Array,
    *,
    progress: Progress = no_progress,
) -> MismatchMinimum:
    """Minimise the mismatch over roll, pitch and yaw one by one until none changes.

    Parameters
    ----------
    start : ndarray of shape (3,), radians

    Raises
    ------
    AdjustmentError
        As `minimise_mismatch`.
    """
    boresight, whole = np.array(start, dtype=float), Mismatch(sample, blocks)
    for iterations in range(1, MAX_ITERATIONS + 1):
        mismatch = whole.with_scale(LOSS_SCALES[min(iterations - 1, len(LOSS_SCALES) - 1)])
        before = boresight.copy()
        for angle in range(3):
            progress(
                (iterations - 1 + angle / 3) / MAX_ITERATIONS, gettext_lazy(PROGRESS_TEXTS[angle])
            )
            boresight[angle] += _angle_step(mismatch, boresight, [angle])[0]
        change = float(np.abs(boresight - before).max())
        if iterations >= len(LOSS_SCALES) and change <= STEP_TOLERANCE:
            return MismatchMinimum(boresight, iterations, True)
    return MismatchMinimum(boresight, MAX_ITERATIONS, False)


def _angle_step(mismatch: Mismatch, boresight: Array, turned: Sequence[int]) -> Array:
    """Gauss-Newton step of the angles ``turned``, shape (k,), radians."""
    found = linearise_blocks(mismatch, boresight)
    weight = mismatch.weights
    some = np.ix_(list(turned), list(turned))
    normal = np.einsum("b,bij->ij", weight, found.normal)[some]
    require_determined_angles(normal, float(weight[found.overlaps].sum()), turned)
    step = -np.linalg.solve(normal, (weight @ found.gradient)[list(turned)])
    return np.asarray(np.clip(step, -MAX_STEP, MAX_STEP))


def require_determined_angles(
    normal_equations: Array, weight: float, turned: Sequence[int]
) -> None:
    """Raise an error if the objects do not determine one of the angles.

    Parameters
    ----------
    normal_equations : ndarray of shape (k, k), square metres per square radian
        Weighted sum over all blocks.
    weight : float
        Total weight of the blocks with enough overlap.
    turned : sequence of int
        Angles of the rows: 0 roll, 1 pitch, 2 yaw.

    Raises
    ------
    AdjustmentError
        No block overlaps, or an angle is not determined.
    """
    if weight <= 0:
        raise AdjustmentError(error("patch_test.no_pairs"))
    values, axes = np.linalg.eigh(normal_equations / weight)
    if values[0] < MIN_ANGLE_SENSITIVITY**2:
        angle = turned[int(np.abs(axes[:, 0]).argmax())]
        raise AdjustmentError(error(UNDETERMINED_CODES[angle]))
