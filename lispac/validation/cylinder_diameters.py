"""Diameters of the M3C2 search cylinders at the core points of a reference, from point density.

Points are farther apart on a wall at 60 m than on one at 15 m. A single diameter for the whole site
would suit the densest parts, and cylinders in sparse parts would contain too few points for a
distance. The diameter therefore follows the local point spacing.
"""

import numpy as np
from numpy.typing import NDArray

from lispac.geometry.point_tree import PointTree
from lispac.targets.thinning import thin_points

Array = NDArray[np.float64]
Indices = NDArray[np.intp]

DIAMETER_FACTOR, MIN_DIAMETER_M, MAX_DIAMETER_M = 2.0, 0.10, 0.60
"""Diameter of a cylinder as a multiple of the distance to the twelfth neighbour, and its smallest
and largest value."""
SPACING_NEIGHBOUR = 12
"""Number, in order of distance, of the neighbour that determines the point spacing."""
DIAMETER_STEP_RATIO = 1.15
"""Ratio of a diameter to the next smaller one."""
REGION_SIDE_M = 2 * MAX_DIAMETER_M
"""Side of the cubes within which all places have the same diameter, the median."""
MAX_PLACES, MAX_CANDIDATES, MAX_SURFACE_POINTS = 3_000, 60_000, 400_000
"""Largest numbers of selected places, of candidate places, and of points of a scan to find them."""
SPACING_GROWTH_FACTOR = 1.2
"""Factor by which the spacing is increased until there are few enough places."""


def candidate_places(surface: Array) -> Array:
    """Places spread evenly over a scan, shape (k, 3), metres, local frame.

    Their spacing is the smallest diameter of a cylinder, or more if there are too many places.

    Parameters
    ----------
    surface : ndarray of shape (n, 3), metres, local frame
        Points of the scan.
    """
    points, side = surface[:: -(-len(surface) // MAX_SURFACE_POINTS)], MIN_DIAMETER_M
    while len(kept := thin_points(points, side)) > MAX_CANDIDATES:
        side *= SPACING_GROWTH_FACTOR
    return points[kept]


def twelfth_neighbour_distance(tree: PointTree, places: Array) -> Array:
    """Distance from each place to its twelfth neighbour, metres; infinite where there are fewer.

    Parameters
    ----------
    tree : PointTree
        Points to which the places belong.
    places : ndarray of shape (k, 3), metres, local frame

    Returns
    -------
    ndarray of shape (k,), metres
    """
    return tree.neighbours(places, SPACING_NEIGHBOUR + 1)[0][:, -1]


def cylinder_diameters(line: PointTree, places: Array, reach: float) -> Array:
    """Diameter of a cylinder that contains about twelve points of a line, at each place, metres.

    Parameters
    ----------
    line : PointTree
        Points of the line.
    places : ndarray of shape (k, 3), metres, local frame
    reach : float, metres
        Largest distance from a place at which a point of the line is searched for.

    Returns
    -------
    ndarray of shape (k,)
        NaN where the line has no point within reach.
    """
    found = np.full(len(places), np.nan)
    if not len(line) or not len(places):
        return found
    distance, nearest = line.nearest(places, reach)
    is_near = np.isfinite(distance)
    nearest_points, inverse = np.unique(nearest[is_near], return_inverse=True)
    found[is_near] = np.clip(
        DIAMETER_FACTOR * twelfth_neighbour_distance(line, line.points[nearest_points]),
        MIN_DIAMETER_M,
        MAX_DIAMETER_M,
    )[inverse]
    return found


def select_separate_places(places: Array, diameters: Array) -> tuple[Indices, Array]:
    """Select places that are at least one diameter apart, and the diameter at each.

    Parameters
    ----------
    places : ndarray of shape (k, 3), metres, local frame
    diameters : ndarray of shape (k,), metres
        Suitable diameter at each place. Within a region the median is used, since the distance to a
        neighbour scatters by one seventh even at uniform density.

    Returns
    -------
    chosen : ndarray of shape (m,), int
        Indices, ascending; at most `MAX_PLACES`, for which places farther apart are selected.
    diameters : ndarray of shape (m,), metres
    """
    steps = np.round(
        np.log(median_by_region(places, diameters, REGION_SIDE_M) / MIN_DIAMETER_M)
        / np.log(DIAMETER_STEP_RATIO)
    )
    usual = np.minimum(MIN_DIAMETER_M * DIAMETER_STEP_RATIO**steps, MAX_DIAMETER_M)
    spacing = 1.0
    while True:
        parts: list[Indices] = [np.zeros(0, dtype=np.intp)]
        for diameter in np.unique(usual):
            own = np.flatnonzero(usual == diameter)
            parts.append(own[thin_points(places[own], spacing * float(diameter))])
        chosen = np.sort(np.concatenate(parts))
        if len(chosen) <= MAX_PLACES:
            return chosen, usual[chosen]
        spacing *= SPACING_GROWTH_FACTOR


def median_by_region(places: Array, values: Array, side: float) -> Array:
    """Median of the values in the cube that contains each place, shape (k,).

    Parameters
    ----------
    places : ndarray of shape (k, 3), metres, local frame
    values : ndarray of shape (k,)
    side : float, metres
        Side of the cubes.
    """
    region = region_numbers(places, side)
    count = np.bincount(region)
    order = np.lexsort((values, region))
    first = np.cumsum(count) - count
    median: Array = values[order[first + count // 2]][region]
    return median


def region_numbers(places: Array, side: float) -> Indices:
    """Number of the cube that contains each place, shape (k,).

    Parameters
    ----------
    places : ndarray of shape (k, 3), metres, local frame
    side : float, metres
        Side of the cubes.
    """
    cubes = np.floor(places / side).astype(np.int64)
    _, region = np.unique(cubes, axis=0, return_inverse=True)
    return region.reshape(-1)
