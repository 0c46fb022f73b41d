"""Noise of LiDAR points, and its component along the normal of a surface.

The component follows from the propagation of variances to the condition equation of the adjustment
(thesis equations 4.1 and 4.4).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


@dataclass(frozen=True)
class LidarNoise:
    """Noise of the points of a LiDAR: on each axis, or along and across the beam.

    Attributes
    ----------
    axes : tuple of 3 floats, metres
        Standard deviations along x, y, z of the LiDAR; not used if ``beam`` is given.
    beam : tuple of 2 floats, metres and radians, or None
        Standard deviations of the range and of the beam direction.
    """

    axes: tuple[float, float, float]
    beam: tuple[float, float] | None = None

    def sigmas(self, points_lidar: Array) -> Array:
        """Sigmas along x, y, z, or along the beam and twice across it, shape (n, 3), metres.

        Parameters
        ----------
        points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
        """
        if self.beam is None:
            return np.tile(np.array(self.axes, dtype=float), (len(points_lidar), 1))
        along, angle = self.beam
        across = np.linalg.norm(points_lidar, axis=1) * angle
        return np.column_stack([np.full(len(points_lidar), along), across, across])

    def along_normals(self, points_lidar: Array, normals_lidar: Array) -> Array:
        """Sigma of each point along the normal of its surface, shape (n,), metres.

        The variance is that of the condition equation of the adjustment from the LiDAR noise
        (`lispac.adjustment.model.condition_equations.lidar_variance`).

        Parameters
        ----------
        points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
        normals_lidar : ndarray of shape (n, 3), vectors of length 1, no unit, LiDAR frame
        """
        sigmas = self.sigmas(points_lidar)
        if self.beam is None:
            return np.asarray(np.linalg.norm(normals_lidar * sigmas, axis=1))
        ranges = np.maximum(np.linalg.norm(points_lidar, axis=1), np.finfo(float).tiny)
        along = np.einsum("ni,ni->n", points_lidar, normals_lidar) / ranges
        across = np.maximum(1.0 - along**2, 0.0)
        return np.sqrt(along**2 * sigmas[:, 0] ** 2 + across * sigmas[:, 1] ** 2)

    def normal_sigma(self, points_lidar: Array, normals_lidar: Array) -> float:
        """Root mean square of `along_normals`, metres: the expected RMS of a flat surface.

        Parameters
        ----------
        points_lidar : ndarray of shape (n, 3), metres, LiDAR frame
        normals_lidar : ndarray of shape (n, 3), vectors of length 1, no unit, LiDAR frame
        """
        if self.beam is None and len(set(self.axes)) == 1:
            return self.axes[0]
        return float(np.sqrt(np.mean(self.along_normals(points_lidar, normals_lidar) ** 2)))
