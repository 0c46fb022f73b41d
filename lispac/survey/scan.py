"""A line: one pass of the vessel, as the scanner saw it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Scan:
    """Raw points of one line.

    Attributes
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    time : ndarray of shape (n,), seconds, in the trajectory's time base
    intensity : ndarray of shape (n,) or None
    assumptions : tuple of str
        What the reader took for granted, in words.
    """

    points_lidar: NDArray[np.float64]
    time: NDArray[np.float64]
    intensity: NDArray[np.float64] | None = None
    assumptions: tuple[str, ...] = ()

    def __len__(self) -> int:
        return len(self.time)
