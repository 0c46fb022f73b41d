"""Identify the surface of a reference among several surfaces, one behind the other.

A line with points on a board also has points on the wall behind it. A cylinder deep enough for the
possible displacement of the line contains points of both, and their mean lies on neither. The
points along the normal are therefore divided into layers in which they are dense, and the layer
nearest to the reference is assumed to be its surface.

At a single place, the nearest layer may consist of outliers, or of points of the wall if the line
has no points on the board. The places of a neighbourhood are therefore divided into layers once
more, by the positions of their nearest layers.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
from lispac.geometry.radius_search import Cells, PointGrid, gather_within_radius

Array = NDArray[np.float64]
Bools = NDArray[np.bool_]

MIN_DENSITY_RATIO = 0.2
"""Smallest ratio of the number of points to that at the densest position; fewer are outliers."""
MIN_LAYER_POINTS, MIN_LAYER_PLACES = 4, 2
"""Smallest number of points of a line in a layer, and of places of a neighbourhood in a layer; one
place is enough if there are no others."""


@dataclass(frozen=True, eq=False)
class NearestLayers:
    """Layer of a line nearest to the reference at each of n places.

    Attributes
    ----------
    middle, half : ndarrays of shape (n,), metres
        Position of the layer along the normal, and half its thickness; NaN where there is none.
    to_next_layer : ndarray of shape (n,), metres
        Distance from this layer to the next one within reach; NaN where there is none.
    """

    middle: Array
    half: Array
    to_next_layer: Array


def find_nearest_layers(
    points: Array, cores: Array, normals: Array, diameters: Array, reach: float, thickness: Array
) -> NearestLayers:
    """Find the layer of a line nearest to the reference, in a cylinder at each place.

    Parameters
    ----------
    points : ndarray of shape (m, 3), metres, local frame
    cores : ndarray of shape (n, 3), metres, local frame
    normals : ndarray of shape (n, 3), unit vectors, local frame
    diameters : ndarray of shape (n,), metres
    reach : float, metres
        Half the length of the cylinder.
    thickness : ndarray of shape (n,), metres
        Thickness of a surface with its noise: points that are no farther apart form one layer.
    """
    cells = PointGrid(points, max(float(diameters.max()), reach) / 2).cells
    found = _nearest_layers_kernel(
        cells, np.ascontiguousarray(cores), np.ascontiguousarray(normals), diameters / 2, reach,
        thickness,
    )  # fmt: skip
    return NearestLayers(*found.T)


def nearest_layer_bounds(values: Array, thickness: float) -> tuple[float, float]:
    """Lowest and highest value, metres, of the layer of values nearest to zero.

    Parameters
    ----------
    values : ndarray of shape (n,), metres
    thickness : float, metres
        As in `find_nearest_layers`.
    """
    values = np.sort(values)
    low, high, _ = _nearest_layer_indices(values, thickness, min(MIN_LAYER_PLACES, len(values)))
    return float(values[low]), float(values[high])


def is_in_any_cylinder(
    points: Array, cores: Array, normals: Array, diameters: Array, middle: Array, half: Array
) -> Bools:
    """Whether each of ``points``, shape (m, 3), local frame, lies in the cylinder of any place.

    Parameters
    ----------
    cores : ndarray of shape (n, 3), metres, local frame
    normals : ndarray of shape (n, 3), unit vectors, local frame
    diameters : ndarray of shape (n,), metres
    middle, half : ndarrays of shape (n,), metres
        Position of the centre of each cylinder along the normal, and half its length.
    """
    cells = PointGrid(points, max(float(diameters.max()), float(half.max())) / 2).cells
    return _in_cylinders_kernel(
        cells, np.ascontiguousarray(cores), np.ascontiguousarray(normals), diameters / 2, middle,
        half,
    )  # fmt: skip


@njit(nogil=True, cache=True)
def _nearest_layer_indices(
    values: Array, thickness: float, fewest: int
) -> tuple[int, int, float]:  # pragma: no cover - compiled
    """First and last index of the layer nearest to zero, and the distance to the next layer.

    The values are in ascending order. The indices are -1 if there is no layer.
    """
    n = len(values)
    counts, end = np.zeros(n, np.int64), 0
    for k in range(n):
        end = max(end, k)
        while end < n and values[end] - values[k] <= thickness:
            end += 1
        counts[k] = end - k
    min_count = max(fewest, MIN_DENSITY_RATIO * counts.max()) if n else fewest
    first, last, best, previous, to_next = -1, -1, np.inf, np.nan, np.nan
    k = 0
    while k < n:
        if counts[k] < min_count:
            k += 1
            continue
        low, high = k, k + counts[k] - 1
        # Overlapping layers are joined.
        while k <= high:
            if counts[k] >= min_count:
                high = max(high, k + counts[k] - 1)
            k += 1
        distance = abs(values[low : high + 1].mean())
        if distance < best:
            best, first, last = distance, low, high
            to_next = values[low] - previous
        elif np.isnan(to_next) or values[low] - values[last] < to_next:
            to_next = values[low] - values[last]
        previous = values[high]
    return first, last, to_next


@njit(nogil=True, cache=True)
def _distances_in_cylinder(
    cloud: Cells, core: Array, normal: Array, radius: float, middle: float, half: float
) -> tuple[Array, NDArray[np.int64]]:  # pragma: no cover - compiled
    """Distances along the normal of the points in a cylinder, and their numbers."""
    near = gather_within_radius(
        cloud, core + middle * normal, np.sqrt(half * half + radius * radius)
    )
    values, kept = np.empty(near.size), 0
    for i in near:
        along, squared = 0.0, 0.0
        for axis in range(3):
            off = cloud[0][i, axis] - core[axis]
            along += off * normal[axis]
            squared += off * off
        if squared - along * along <= radius * radius and abs(along - middle) <= half:
            values[kept], near[kept] = along, i
            kept += 1
    return values[:kept], near[:kept]


@njit(nogil=True, cache=True)
def _nearest_layers_kernel(
    cloud: Cells, cores: Array, normals: Array, radii: Array, reach: float, thickness: Array
) -> Array:  # pragma: no cover - compiled
    found = np.full((len(cores), 3), np.nan)
    for k in range(len(cores)):
        if np.isnan(normals[k, 0]):
            continue
        values, _ = _distances_in_cylinder(cloud, cores[k], normals[k], radii[k], 0.0, reach)
        values.sort()
        first, last, to_next = _nearest_layer_indices(values, thickness[k], MIN_LAYER_POINTS)
        if first >= 0:
            found[k, 0] = values[first : last + 1].mean()
            found[k, 1] = (values[last] - values[first]) / 2
            found[k, 2] = to_next
    return found


@njit(nogil=True, cache=True)
def _in_cylinders_kernel(
    cloud: Cells, cores: Array, normals: Array, radii: Array, middle: Array, half: Array
) -> Bools:  # pragma: no cover - compiled
    found = np.zeros(len(cloud[0]), np.bool_)
    for k in range(len(cores)):
        if not np.isnan(normals[k, 0]):
            _, numbers = _distances_in_cylinder(
                cloud, cores[k], normals[k], radii[k], middle[k], half[k]
            )
            found[numbers] = True
    return found
