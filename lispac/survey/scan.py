"""A line in the LiDAR frame."""

from dataclasses import dataclass
from functools import cached_property
from zlib import crc32

import numpy as np
from numpy.typing import NDArray

from lispac.messages import Message


@dataclass(frozen=True, eq=False)
class Scan:
    """Raw points of one line.

    Attributes
    ----------
    points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
    time : ndarray of shape (n,), seconds, in the trajectory's time base
    intensity : ndarray of shape (n,) or None
    assumptions : tuple of Message
        Assumptions of the reader.
    """

    points_lidar: NDArray[np.float64]
    time: NDArray[np.float64]
    intensity: NDArray[np.float64] | None = None
    assumptions: tuple[Message, ...] = ()

    @cached_property
    def fingerprint(self) -> str:
        """Number and checksum of the points, to verify that indices refer to the same points."""
        checksum = crc32(np.ascontiguousarray(self.points_lidar).data)
        checksum = crc32(np.ascontiguousarray(self.time).data, checksum)
        return f"{len(self)}-{checksum:08x}"

    def __len__(self) -> int:
        return len(self.time)

    @cached_property
    def first_time(self) -> float:
        """Earliest time, seconds."""
        return float(self.time.min())

    @cached_property
    def last_time(self) -> float:
        """Latest time, seconds."""
        return float(self.time.max())

    @cached_property
    def reach(self) -> float:
        """Distance of the farthest point from the scanner, metres."""
        return float(np.sqrt(np.einsum("ij,ij->i", self.points_lidar, self.points_lidar).max()))

    def take(self, numbers: NDArray[np.int64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Some points, shape (n, 3), metres, LiDAR frame, and their times, shape (n,), seconds.

        Parameters
        ----------
        numbers : ndarray of shape (n,), int
            Places in the line.
        """
        return self.points_lidar[numbers], self.time[numbers]

    def intensities(self, numbers: NDArray[np.int64]) -> NDArray[np.float64] | None:
        """Intensities of some points, shape (n,), if the line has any.

        Parameters
        ----------
        numbers : ndarray of shape (n,), int
            Places in the line.
        """
        return None if self.intensity is None else self.intensity[numbers]
