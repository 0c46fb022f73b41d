"""What a patch test found, and the sentences that say so."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.adjustment.shown import listed
from lispac.patchtest.mismatch import SCALE
from lispac.patchtest.optimise import ANGLES
from lispac.patchtest.sigmas import FEWEST, ObjectFound

Array = NDArray[np.float64]

FAR = np.radians(0.01)
"""By how much the two ways of turning the angles may differ without a word, radians."""


@dataclass(frozen=True, eq=False)
class PatchTest:
    """The answer of a patch test.

    Attributes
    ----------
    boresight : ndarray of shape (3,), radians
        Roll, pitch, yaw, found together.
    one_by_one : ndarray of shape (3,), radians
        The same, turned one after another.
    covariance : ndarray of shape (3, 3), square radians, or None
        None where there are too few objects for one.
    curvature : ndarray of shape (3,), metres per radian
        By how much lines part when each angle is turned, in the root mean square.
    mismatch_before, mismatch : float, metres
        Robust RMS distance between the lines, with the prior boresight and with the answer; NaN
        before where the lines do not meet at the objects.
    lines : tuple of str
    objects : tuple of ObjectFound
    rounds : int
        Of turning one angle after another.
    settled : bool
        Whether angles stayed where they were in the end, both ways.
    unmet : tuple of str
        Objects that were asked for and at which no pair of lines meets.
    """

    boresight: Array
    one_by_one: Array
    covariance: Array | None
    curvature: Array
    mismatch_before: float
    mismatch: float
    lines: tuple[str, ...]
    objects: tuple[ObjectFound, ...]
    rounds: int
    settled: bool
    unmet: tuple[str, ...] = ()

    @property
    def sigma(self) -> Array | None:
        """Of roll, pitch and yaw, shape (3,), radians; None where none can be stated."""
        return None if self.covariance is None else np.sqrt(np.diag(self.covariance))

    @property
    def disagreeing(self) -> tuple[ObjectFound, ...]:
        """Objects whose own minimum is off by more than is allowed."""
        return tuple(each for each in self.objects if each.disagrees)

    @property
    def sentences(self) -> tuple[str, ...]:
        """What the answer rests on and what to think of it, in words."""
        found = [
            f"The answer rests on {len(self.objects)} objects and {len(self.lines)} lines.",
            self._fall,
        ]
        if self.covariance is None:
            found.append(
                f"A sigma cannot be stated: {len(self.objects)} objects are too few to tell how "
                f"far the answer would move with others; at least {FEWEST} are needed."
            )
        if not self.settled:
            found.append("The angles still moved when the search ended.")
        apart = np.abs(self.one_by_one - self.boresight)
        if apart.max() > FAR:
            angle = int(apart.argmax())
            found.append(
                f"Turned one after another, the angles end elsewhere: the {ANGLES[angle]} by "
                f"{np.degrees(apart[angle]):.3f} deg."
            )
        found.extend(each.sentence for each in self.disagreeing)
        if self.unmet:
            found.append(f"No two of the lines meet at: {listed(self.unmet)}.")
        return tuple(found)

    @property
    def _fall(self) -> str:
        now, most = 1000 * self.mismatch, 1000 * SCALE
        words = f"The mismatch (robust RMS distance between lines, at most {most:.0f} mm)"
        if not np.isfinite(self.mismatch_before):
            return f"{words} is {now:.1f} mm; with the prior boresight the lines do not meet there."
        before = 1000 * self.mismatch_before
        return f"{words} falls from {before:.1f} mm with the prior boresight to {now:.1f} mm."
