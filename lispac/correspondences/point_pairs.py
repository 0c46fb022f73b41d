"""Pairs of points of the same place, measured at two times."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PointPairs:
    """Pairs of measured points.

    Attributes
    ----------
    time : ndarray of shape (n, 2), seconds
    points_lidar : ndarray of shape (n, 2, 3), metres, LiDAR frame
    """

    time: Array
    points_lidar: Array

    def __len__(self) -> int:
        return len(self.time)

    def where(self, mask: NDArray[np.bool_]) -> "PointPairs":
        """Pairs for which ``mask``, shape (n,), is true."""
        return PointPairs(self.time[mask], self.points_lidar[mask])

    def first_of_each(self) -> NDArray[np.bool_]:
        """Whether a pair is the first of several that are equal, also with exchanged points, (n,).

        A pair given twice would count as two observations.
        """
        ends = np.concatenate([self.time[:, :, None], self.points_lidar], axis=2)
        turned = ends[:, 1, 0] < ends[:, 0, 0]
        ends[turned] = ends[turned, ::-1]
        _, first = np.unique(ends.reshape(len(ends), 8), axis=0, return_index=True)
        mask = np.zeros(len(ends), dtype=bool)
        mask[first] = True
        return mask
