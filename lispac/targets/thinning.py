"""Spatial subsampling: keep about one point per set distance (thesis section 4.5.3)."""

import numpy as np
from numpy.typing import NDArray

from lispac.errors import InputError
from lispac.messages import error

Array = NDArray[np.float64]
Indices = NDArray[np.int64]


def thin_points(points: Array, distance: float) -> Indices:
    """Choose one point in each cube of side ``distance``: the one nearest to the cube's centre.

    Every finite point has a chosen point within ``sqrt(3) * distance``, in the same cube. The
    corners of the cubes are multiples of the distance, independent of the points, so that all
    sightings of a target are thinned alike and the order of the points does not matter. Points with
    a coordinate that is not finite are dropped.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
    distance : float, metres
        Zero or less keeps every finite point.

    Returns
    -------
    ndarray of shape (m,), int64
        Ascending indices of the kept points.

    Raises
    ------
    InputError
        The distance is not a number.
    """
    if not np.isfinite(distance):
        raise InputError(error("target.point_spacing"))
    usable: Indices = np.flatnonzero(np.isfinite(points).all(axis=1)).astype(np.int64)
    if distance <= 0.0 or len(usable) == 0:
        return usable
    scaled = points[usable] / distance
    cells = np.floor(scaled)
    off_centre = ((scaled - cells - 0.5) ** 2).sum(axis=1)
    # Sorted by cell, distance and coordinates, so that ties do not depend on the point order.
    x, y, z = points[usable].T
    order = np.lexsort((z, y, x, off_centre, cells[:, 2], cells[:, 1], cells[:, 0]))
    sorted_cells = cells[order]
    first = np.ones(len(order), dtype=bool)
    first[1:] = (sorted_cells[1:] != sorted_cells[:-1]).any(axis=1)
    kept: Indices = usable[np.sort(order[first])]
    return kept
