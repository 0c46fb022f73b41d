"""Visibility of a systematic error on a board: the criteria of the thesis (section 3.4.4).

The type I criterion, from planarity and centroidal distance, is a first selection. It is 1 if the
points form a board at the position of the board, and 0 if they do not. The type II criteria,
angular deviation and signed orthogonal distance, are the rotation and shift of the plane of the
points, by which the error is visible.

Choices where the thesis is incomplete or contains misprints:

- Planarity is that of West et al. (2004), as cited by the thesis: (l2 - l3) / l1, with the
  eigenvalues in descending order.
- Figure 3.8 shows the combination of the two values only graphically. Here it is the planarity
  times one minus the normalised distance. This is 1 only if both have their best values, and 0 if
  one has its worst value.
- Figure 3.10 divides the orthogonal distance by the length of the simulated plane's normal, which
  is 1, and omits the d of the reference plane. This is correct only if that plane passes through
  the origin.
- Figure 3.10 requires an angle from 0 to 90 deg, but its arc tangent gives up to 180 deg, since two
  normals of one plane may point to opposite sides.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.planes import Plane, fit_plane

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PointsShape:
    """Shape of the points on a board by algorithm 1 (figure 3.7).

    Attributes
    ----------
    centroid : ndarray of shape (3,), metres, local
    eigenvalues : ndarray of shape (3,), square metres
        Of the covariance of the points, the largest first.
    plane : Plane, local
    """

    centroid: Array
    eigenvalues: Array
    plane: Plane

    @property
    def planarity(self) -> float:
        """1 for a square board, 0 for points on a straight line or in a ball."""
        largest, middle, smallest = self.eigenvalues
        return float((middle - smallest) / largest)


def points_shape(points: Array) -> PointsShape:
    """Centroid, eigenvalues and plane of points of shape (n, 3), metres, local.

    Raises
    ------
    PlaneNotFound
        Fewer than three points, or all on one straight line.
    """
    plane = fit_plane(points)
    spread = np.linalg.eigvalsh(np.cov(points.T))[::-1]
    return PointsShape(points.mean(axis=0), np.maximum(spread, 0.0), plane)


def centroidal_distance(shape: PointsShape, centre: Array) -> float:
    """Distance from the centre of the board, shape (3,), local, to the points' centroid, metres."""
    return float(np.linalg.norm(shape.centroid - centre))


def normalise_distances(distances: Array) -> Array:
    """Normalise distances: the smallest becomes 0, the largest 1 (equation 3.4).

    Parameters
    ----------
    distances : ndarray of any shape, metres
        Distances to be compared; NaN where there are no points.

    Returns
    -------
    ndarray of the same shape, no unit
    """
    least, largest = np.nanmin(distances), np.nanmax(distances)
    if largest == least:
        return np.asarray(distances - least)  # all distances are equal
    return np.asarray((distances - least) / (largest - least))


def type_one_criterion(planarity: Array, normalised_distance: Array) -> Array:
    """Type I criterion: near 1 for flat points near the board, 0 if there are no points (NaN).

    Parameters
    ----------
    planarity, normalised_distance : ndarray of any shape, no unit

    Returns
    -------
    ndarray of the same shape
    """
    return np.nan_to_num(planarity * (1.0 - normalised_distance), nan=0.0)


def angular_deviation(shape: PointsShape, reference: Plane) -> float:
    """Angle between the plane of the points and that of the board, radians in [0, pi/2]."""
    return shape.plane.tilt_to(reference)


def orthogonal_distance(shape: PointsShape, reference: Plane) -> float:
    """Distance of the centroid from the board's plane, metres; positive along its normal."""
    return float(reference.distances(shape.centroid))
