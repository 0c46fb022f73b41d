"""A line: one pass of the vessel, as the scanner saw it."""

from dataclasses import dataclass
from functools import cached_property
from zlib import crc32

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

    @cached_property
    def fingerprint(self) -> str:
        """Number and checksum of the points: tells whether indices still mean the same points."""
        checksum = crc32(np.ascontiguousarray(self.points_lidar).data)
        checksum = crc32(np.ascontiguousarray(self.time).data, checksum)
        return f"{len(self)}-{checksum:08x}"

    def __len__(self) -> int:
        return len(self.time)
