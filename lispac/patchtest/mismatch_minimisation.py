"""Minimise the mismatch over the angles, one by one or all three together.

One after another they are turned in the classical order: roll, pitch, yaw. Reciprocal lines are
turned against each other by a roll and by a pitch. A roll moves what is beside the vessel up and
down, and what is high up to and fro, which level and upright surfaces show whatever the two others
are. A pitch moves what is high up along the course, a pole or an edge, by which time the roll has
to be right. A yaw turns all that is seen about the vertical, on reciprocal lines the same way and
by as much, so that they hardly show it; lines that cross, pass at another distance or on the other
side do, and what they differ by is the yaw's own only once the two others are right. What is left
of later angles in the earlier ones goes with further rounds.

Each stage squares distances up to a smaller scale than the one before: at first lines may be half
a metre apart; in the end an outlier must not affect them.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.errors import AdjustmentError
from lispac.language import N_, gettext_lazy
from lispac.messages import error
from lispac.patchtest.block_equations import linearise_blocks
from lispac.patchtest.line_mismatch import SCALE, Mismatch, PairBlock
from lispac.patchtest.object_sample import ObjectSample
from lispac.progress import Progress, no_progress

Array = NDArray[np.float64]

ANGLES = ("roll", "pitch", "yaw")
OPTIMISING = (N_("Optimising roll"), N_("Optimising pitch"), N_("Optimising yaw"))
UNDETERMINED = ("patch_test.no_roll", "patch_test.no_pitch", "patch_test.no_yaw")
"""Code of the message that an angle is not determined."""
SCALES = (0.5, 0.2, SCALE)
"""Metres, from stage to stage."""
STEPS, ROUNDS = 6, 12
"""Most steps of a stage, and most rounds of one angle after another."""
STEP_TOLERANCE = np.radians(2e-4)
"""Radians that the last step moves at most."""
MAX_STEP = np.radians(1.0)
"""Longest step, radians."""
MIN_LEVERAGE = 2.0
"""Metres that surfaces move along their normals for a radian, in the root mean square, below which
an angle counts as open, as `lispac.targets.rough_alignment` has it."""


@dataclass(frozen=True, eq=False)
class MismatchMinimum:
    """Boresight at which the mismatch of the lines is smallest.

    Attributes
    ----------
    boresight : ndarray of shape (3,), radians
    rounds : int
        Of one angle after another; 1 of what was found together.
    converged : bool
        Whether nothing moved in the last step.
    """

    boresight: Array
    rounds: int
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
        Where nothing overlaps, or the objects leave an angle open.
    """
    boresight = np.array(start, dtype=float)
    turned = list(angles)
    converged = False
    whole = Mismatch(sample, blocks)
    for stage, scale in enumerate(SCALES):
        mismatch = whole.with_scale(scale)
        for number in range(STEPS):
            progress((stage + number / STEPS) / len(SCALES), gettext_lazy("Optimising the angles"))
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
    """Minimise over roll, pitch and yaw in turn until none changes; see the module.

    Parameters
    ----------
    start : ndarray of shape (3,), radians

    Raises
    ------
    AdjustmentError
        As `minimise_mismatch`.
    """
    boresight, whole = np.array(start, dtype=float), Mismatch(sample, blocks)
    for rounds in range(1, ROUNDS + 1):
        mismatch = whole.with_scale(SCALES[min(rounds - 1, len(SCALES) - 1)])
        before = boresight.copy()
        for angle in range(3):
            progress((rounds - 1 + angle / 3) / ROUNDS, gettext_lazy(OPTIMISING[angle]))
            boresight[angle] += _angle_step(mismatch, boresight, [angle])[0]
        change = float(np.abs(boresight - before).max())
        if rounds >= len(SCALES) and change <= STEP_TOLERANCE:
            return MismatchMinimum(boresight, rounds, True)
    return MismatchMinimum(boresight, ROUNDS, False)


def _angle_step(mismatch: Mismatch, boresight: Array, turned: Sequence[int]) -> Array:
    """Step of the angles ``turned`` together, shape (k,), radians."""
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
    """Refuse to estimate an angle that no object determines.

    Parameters
    ----------
    normal_equations : ndarray of shape (k, k), square metres per square radian
        Of all blocks, weighted.
    weight : float
        Of all blocks that meet.
    turned : sequence of int
        Which angles they are of.

    Raises
    ------
    AdjustmentError
    """
    if weight <= 0:
        raise AdjustmentError(error("patch_test.no_pairs"))
    values, axes = np.linalg.eigh(normal_equations / weight)
    if values[0] < MIN_LEVERAGE**2:
        angle = turned[int(np.abs(axes[:, 0]).argmax())]
        raise AdjustmentError(error(UNDETERMINED[angle]))
