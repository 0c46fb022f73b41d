"""Results of alternative methods, which are compared with the calibration by targets."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Message

Array = NDArray[np.float64]

Method = Literal["natural planes", "targetless", "patch test", "correspondences"]
COMPUTED_METHODS: tuple[Method, ...] = ("natural planes", "targetless", "patch test")
"""Alternative methods that need only the lines."""
ALTERNATIVE_METHODS: tuple[Method, ...] = (*COMPUTED_METHODS, "correspondences")
"""Alternative methods in the order in which they are shown."""


@dataclass(frozen=True, eq=False)
class AlternativeResult:
    """Result of an alternative method, which does not use the project's targets.

    Attributes
    ----------
    method : Method
    boresight : ndarray of shape (3,), radians; roll, pitch, yaw
    covariance : ndarray of shape (3, 3), radians^2
        All variances are positive.
    lines : tuple of str
        Lines used for the result.
    surfaces : int
        Number of planes, natural surfaces, objects or pairs of points used for the result.
    messages : tuple of Message
        Data used for the result, and its limitations.
    """

    method: Method
    boresight: Array
    covariance: Array
    lines: tuple[str, ...]
    surfaces: int
    messages: tuple[Message, ...] = ()

    @property
    def sigma(self) -> Array:
        """Standard deviations of roll, pitch, yaw, shape (3,), radians."""
        return np.asarray(np.sqrt(np.diag(self.covariance)))

    def is_sound(self) -> bool:
        """True if the angles are finite and their covariance is positive definite."""
        shapes = self.boresight.shape, self.covariance.shape
        if shapes != ((3,), (3, 3)) or not np.isfinite(self.boresight).all():
            return False
        finite = np.isfinite(self.covariance).all()
        return bool(finite and np.linalg.eigvalsh(self.covariance)[0] > 0.0)
