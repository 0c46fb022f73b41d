"""Result of a patch test."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.model.parameters import mounting_value_name
from lispac.messages import Message, note
from lispac.patchtest.bootstrap_precision import MIN_OBJECTS, ObjectAgreement
from lispac.patchtest.line_mismatch import LOSS_SCALE
from lispac.patchtest.mismatch_minimisation import ANGLE_NAMES

Array = NDArray[np.float64]

MAX_ESTIMATE_DIFFERENCE = np.radians(0.01)
"""Largest difference between joint and one-by-one estimates without a message, radians."""


@dataclass(frozen=True, eq=False)
class PatchTestResult:
    """Result of a patch test.

    Attributes
    ----------
    boresight : ndarray of shape (3,), radians
        Roll, pitch and yaw, estimated together.
    separate_boresight : ndarray of shape (3,), radians
        Roll, pitch and yaw, estimated one after another.
    covariance : ndarray of shape (3, 3), square radians, or None
        Covariance of roll, pitch and yaw; None if there are too few objects.
    curvature : ndarray of shape (3,), metres per radian
        RMS distance that opens between the lines per radian of each angle.
    mismatch_before, mismatch : float, metres
        Robust RMS distance between the lines, with the prior boresight and with the result. The
        first is NaN if the lines do not overlap at the objects with the prior boresight.
    lines : tuple of str
    objects : tuple of ObjectAgreement
    iterations : int
        Number of iterations over the angles one by one.
    converged : bool
        Whether both estimates converged.
    objects_without_pairs : tuple of str
        Requested objects at which no pair of lines overlaps.
    """

    boresight: Array
    separate_boresight: Array
    covariance: Array | None
    curvature: Array
    mismatch_before: float
    mismatch: float
    lines: tuple[str, ...]
    objects: tuple[ObjectAgreement, ...]
    iterations: int
    converged: bool
    objects_without_pairs: tuple[str, ...] = ()

    @property
    def sigma(self) -> Array | None:
        """Sigmas of roll, pitch and yaw, shape (3,), radians; None without a covariance."""
        return None if self.covariance is None else np.sqrt(np.diag(self.covariance))

    @property
    def disagreeing_objects(self) -> tuple[ObjectAgreement, ...]:
        """Objects whose minimum deviates from that of all objects by more than allowed."""
        return tuple(each for each in self.objects if each.disagrees)

    @property
    def messages(self) -> tuple[Message, ...]:
        """Messages on the data used and on the limitations of the result."""
        count = len(self.objects)
        found = [
            note("patch_test.basis", count=count, lines=len(self.lines)),
            self._mismatch_message,
        ]
        if self.covariance is None:
            found.append(note("patch_test.no_sigma", count=count, needed=MIN_OBJECTS))
        if not self.converged:
            found.append(note("patch_test.not_converged"))
        differences = np.abs(self.separate_boresight - self.boresight)
        if differences.max() > MAX_ESTIMATE_DIFFERENCE:
            k = int(differences.argmax())
            angle = mounting_value_name(ANGLE_NAMES[k])
            found.append(note("patch_test.order_matters", angle=angle, difference=differences[k]))
        found.extend(each.disagreement for each in self.disagreeing_objects)
        if self.objects_without_pairs:
            found.append(note("patch_test.not_met", objects=self.objects_without_pairs))
        return tuple(found)

    @property
    def _mismatch_message(self) -> Message:
        if not np.isfinite(self.mismatch_before):
            return note("patch_test.mismatch", limit=LOSS_SCALE, after=self.mismatch)
        return note(
            "patch_test.mismatch_reduced",
            limit=LOSS_SCALE, before=self.mismatch_before, after=self.mismatch,
        )  # fmt: skip
