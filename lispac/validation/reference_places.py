"""Distances of a line from a reference at the same places before and after.

For a surface (a static scan, a surveyed plane) the distances are measured as between two lines: in
cylinders along the normal of the reference (M3C2: Lague et al. 2013), to the nearest surface of the
line. A surveyed point has no surface. Its distance is measured to a plane through the points of the
line around the nearest one, if the projection of the surveyed point lies inside this area.
"""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from lispac.compiled_code import njit
from lispac.errors import NotComparable
from lispac.geometry.planes import plane_axes
from lispac.geometry.radius_search import Cells, PointGrid, gather_within_radius
from lispac.messages import error
from lispac.validation.cylinder_diameters import MAX_DIAMETER_M, region_numbers
from lispac.validation.normal_distance import (
    SIGMA_PER_MAD,
    NormalDistances,
    distances_along_normal,
    reference_normals,
)
from lispac.validation.surface_layers import (
    NearestLayers,
    find_nearest_layers,
    is_in_any_cylinder,
    nearest_layer_bounds,
)

Array = NDArray[np.float64]
Bools = NDArray[np.bool_]

DIAMETER_GROWTH_FACTOR = 1.3
"""Ratio of a tested diameter around a surveyed point to the previous one."""
NORMAL_SPHERE_FACTOR = 2.0
"""Diameter of the sphere of points used for a normal, as a multiple of the cylinder diameter."""
MAX_FLAT_RMS_RATIO = 0.05
"""Largest ratio of the RMS of the points about a plane to the diameter of the place, for a flat
place."""
MIN_VARIANCE_RATIO = 0.1
"""Ratio of the smaller to the larger variance in the plane at or below which points lie along an
edge or a single profile."""
MAX_CENTROID_RATIO = 0.15
"""Largest distance of the centroid of the points around a place from the place, as a multiple of
the search radius. It is 0.17 where the cylinder, with half this radius, touches a straight edge."""
MIN_PLANE_POINTS = 6
"""Smallest number of points around a place for a plane."""
SEARCH_DEPTH_SIGMAS, MEDIAN_REGION_SIDE_M = 5.0, 4.0
"""Depth searched on either side of the median, in robust sigmas, and side of the cubes for which
separate medians are computed."""


@dataclass(frozen=True, eq=False)
class CorePointDistances:
    """Distances of one line from the reference at its core points, before and after calibration.

    They are positive where the line lies nearer to the vessel.

    Attributes
    ----------
    before, after : NormalDistances
        Distances at the same n places.
    to_other_surface : ndarray of shape (n,), metres
        Distance, after the calibration, from the measured surface of the line to a second surface
        within reach; NaN where there is none, and at surveyed points.
    """

    before: NormalDistances
    after: NormalDistances
    to_other_surface: Array


def is_reference_flat(reference: Array, cores: Array, diameters: Array, roughest: float) -> Bools:
    """Whether the reference is flat within the diameter around each core point, shape (k,).

    Places at an edge do not count as flat: beams that hit an edge partly give false points.

    Parameters
    ----------
    reference : ndarray of shape (m, 3), metres, local frame
    cores : ndarray of shape (k, 3), metres, local frame
    diameters : ndarray of shape (k,), metres
    roughest : float, metres
        RMS about a plane that is accepted as noise at places of any size.
    """
    flat = np.zeros(len(cores), dtype=bool)
    cells = PointGrid(reference, float(np.median(diameters)) / 2).cells
    counts, sums, products = _neighbourhood_moments(
        np.ascontiguousarray(cores), cells, diameters / 2
    )
    dense = np.flatnonzero(counts >= MIN_PLANE_POINTS)
    means = sums[dense] / counts[dense, None]
    scatter = products[dense] / counts[dense, None, None]
    spread = np.linalg.eigvalsh(scatter - means[:, :, None] * means[:, None, :])
    rms = np.sqrt(np.maximum(spread[:, 0], 0.0))
    is_surface = spread[:, 1] > MIN_VARIANCE_RATIO * spread[:, 2]
    is_inside = np.linalg.norm(means, axis=1) <= MAX_CENTROID_RATIO * diameters[dense] / 2
    flat[dense] = (
        is_surface
        & is_inside
        & (rms <= np.maximum(MAX_FLAT_RMS_RATIO * diameters[dense], roughest))
    )
    return flat


@njit(nogil=True, cache=True)
def _neighbourhood_moments(
    cores: Array, reference: Cells, radii: Array
) -> tuple[NDArray[np.int64], Array, Array]:  # pragma: no cover - compiled
    """Number, sum (n, 3) and sum of products (n, 3, 3) of the offsets of points near each core."""
    counts = np.zeros(len(cores), np.int64)
    sums, products = np.zeros((len(cores), 3)), np.zeros((len(cores), 3, 3))
    for k in range(len(cores)):
        found = gather_within_radius(reference, cores[k], radii[k])
        counts[k] = found.size
        for i in found:
            for a in range(3):
                off = reference[0][i, a] - cores[k, a]
                sums[k, a] += off
                for b in range(3):
                    products[k, a, b] += off * (reference[0][i, b] - cores[k, b])
    return counts, sums, products


def measure_to_surface(
    before: Array,
    after: Array,
    reference: Array,
    cores: Array,
    *,
    facing: Array,
    diameters: Array,
    reach: float,
    roughest: float,
) -> CorePointDistances:
    """Distances of a line from a surface at places measured before and after the calibration.

    Parameters
    ----------
    before, after : ndarrays of shape (n, 3), metres, local frame
        The line's points with the prior and with the estimated boresight.
    reference : ndarray of shape (m, 3), metres, local frame
    cores : ndarray of shape (k, 3), metres, local frame
        Flat places of the reference.
    facing : ndarray of shape (k, 3)
        Direction towards the vessel.
    diameters : ndarray of shape (k,), metres
        Diameters of the cylinders.
    reach : float, metres
        Largest possible distance of the line from the reference.
    roughest : float, metres
        RMS about a plane that is accepted as noise.

    Raises
    ------
    NotComparable
        If no place has enough points of the line and the reference.
    """
    normals = reference_normals(reference, cores, facing, NORMAL_SPHERE_FACTOR * diameters)
    noise = np.maximum(MAX_FLAT_RMS_RATIO * diameters, roughest)

    def layers_of(points: Array) -> NearestLayers:
        return find_nearest_layers(points, cores, normals, diameters, reach, 2 * noise)

    def measured(points: Array, middle: Array, half: Array) -> NormalDistances:
        valid = np.flatnonzero(np.isfinite(middle))
        if not len(valid):
            raise NotComparable(error("validation.line_out_of_reach"))
        found = distances_along_normal(
            points, reference, cores[valid], facing=facing[valid],
            normal_scale=NORMAL_SPHERE_FACTOR * diameters[valid], diameter=diameters[valid],
            depth=half[valid], middle=middle[valid], reference_depth=diameters[valid],
        )  # fmt: skip
        return replace(found, at=valid[found.at])

    layers = layers_of(after)
    middle, half = _search_windows(cores, layers, noise, reach)
    of_after = measured(after, middle, half)
    # With the prior boresight another surface may be nearer to the reference; the points of this
    # surface are therefore selected after the calibration.
    valid = np.isfinite(middle)
    same = is_in_any_cylinder(
        after, cores[valid], normals[valid], diameters[valid], middle[valid], half[valid]
    )
    of_before = measured(before, *_search_windows(cores, layers_of(before[same]), noise, reach))
    return _restrict_to_common_places(of_before, of_after, layers.to_next_layer)


def _search_windows(
    cores: Array, layers: NearestLayers, noise: Array, reach: float
) -> tuple[Array, Array]:
    """Position of the surface along the normal at each core, and half of the depth to search.

    The position is the median of a neighbourhood, since a wrong boresight displaces points by
    millimetres at short range and by decimetres at long range. The depth follows from the scatter
    of the line. The position is NaN where the line has no points in the whole neighbourhood.
    """
    middle, half = np.full(len(cores), np.nan), np.full(len(cores), np.nan)
    number, valid = region_numbers(cores, MEDIAN_REGION_SIDE_M), np.isfinite(layers.middle)
    deviations: list[Array] = []
    half_thicknesses: list[Array] = []
    for region in np.unique(number[valid]):
        own = number == region
        values = layers.middle[own & valid]
        low, high = nearest_layer_bounds(values, 2 * float(np.median(noise[own])))
        chosen = (values >= low) & (values <= high)
        middle[own] = np.median(values[chosen])
        deviations.append(np.abs(values[chosen] - np.median(values[chosen])))
        half_thicknesses.append(layers.half[own & valid][chosen])
    if deviations:
        scatter = SEARCH_DEPTH_SIGMAS * SIGMA_PER_MAD * float(np.median(np.concatenate(deviations)))
        depth = scatter + float(np.median(np.concatenate(half_thicknesses)))
        half[:] = np.minimum(reach, depth + noise)
    return middle, half


def measure_to_points(
    before: Array,
    after: Array,
    places: Array,
    *,
    facing: Array,
    diameters: Array,
    reach: float,
    roughest: float,
) -> CorePointDistances:
    """Distances of a line from surveyed points, for those with a distance in both states.

    Parameters
    ----------
    before, after : ndarrays of shape (n, 3), metres, local frame
        The line's points with the prior and with the estimated boresight.
    places, facing : ndarrays of shape (k, 3), metres, local frame
        The surveyed points, and the direction from each towards the vessel.
    diameters : ndarray of shape (k,), metres
        Diameter of the area around each point that is tried first.

    Raises
    ------
    NotComparable
        If the line has no flat place at any surveyed point in both states.
    """
    states = []
    for points in (before, after):
        grid = PointGrid(points)
        found = []
        for place, side, diameter in zip(places, facing, diameters, strict=True):
            about = points[grid.within(place, reach + max(diameter, MAX_DIAMETER_M))]
            found.append(
                _plane_distance_at_point(
                    about, place, side, diameter=diameter, reach=reach, roughest=roughest
                )
            )
        states.append(_plane_distances(places, found))
    return _restrict_to_common_places(states[0], states[1])


def _plane_distance_at_point(
    points: Array, place: Array, facing: Array, *, diameter: float, reach: float, roughest: float
) -> tuple[float, float, Array] | None:
    """Distance, half its 95 % interval (metres) and normal of the plane of a line at a point.

    If the profiles of the line are far apart, its points around the place may lie on a single
    profile; the area is then enlarged.
    """
    if not len(points):
        return None
    distance = np.linalg.norm(points - place, axis=1)
    nearest = int(np.argmin(distance))
    if distance[nearest] > reach:
        return None
    to_nearest = np.linalg.norm(points - points[nearest], axis=1)
    tested_diameter = diameter
    while (
        found := _fit_plane_near(
            points[to_nearest <= tested_diameter / 2], place, facing, tested_diameter, roughest
        )
    ) is None:
        tested_diameter *= DIAMETER_GROWTH_FACTOR
        if tested_diameter > max(MAX_DIAMETER_M, diameter):
            return None
    return found


def _fit_plane_near(
    near: Array, place: Array, facing: Array, diameter: float, roughest: float
) -> tuple[float, float, Array] | None:
    from scipy.special import stdtrit

    if len(near) < MIN_PLANE_POINTS:
        return None
    middle = near.mean(axis=0)
    spread, vectors = np.linalg.eigh((near - middle).T @ (near - middle) / len(near))
    rms = float(np.sqrt(max(spread[0], 0.0)))
    if spread[1] <= MIN_VARIANCE_RATIO * spread[2] or rms > max(
        MAX_FLAT_RMS_RATIO * diameter, roughest
    ):
        return None
    normal = vectors[:, 0] * (1.0 if vectors[:, 0] @ facing >= 0.0 else -1.0)
    axes = plane_axes(normal)
    foot = axes @ (place - middle)
    if np.hypot(*foot) > diameter / 2:
        return None
    design = np.column_stack([np.ones(len(near)), (near - middle) @ axes.T])
    terms = np.array([1.0, *foot])
    freedom = len(near) - 3
    variance = rms**2 * len(near) / freedom
    half = stdtrit(freedom, 0.975) * np.sqrt(
        variance * (terms @ np.linalg.solve(design.T @ design, terms))
    )
    return float(normal @ (middle - place)), float(half), normal


def _plane_distances(
    places: Array, distances: list[tuple[float, float, Array] | None]
) -> NormalDistances:
    at = np.array([k for k, each in enumerate(distances) if each is not None], dtype=np.intp)
    if not len(at):
        raise NotComparable(error("validation.no_flat_point"))
    values = [each for each in distances if each is not None]
    return NormalDistances(
        places[at],
        np.array([distance for distance, _, _ in values]),
        np.array([half for _, half, _ in values]),
        len(places) - len(at),
        np.array([normal for _, _, normal in values]),
        at,
    )


def _restrict_to_common_places(
    before: NormalDistances, after: NormalDistances, to_other_surface: Array | None = None
) -> CorePointDistances:
    """Restrict both states to the places that have a distance in both.

    Raises
    ------
    NotComparable
        If there is no such place.
    """
    at = np.intersect1d(before.at, after.at)
    if not len(at):
        raise NotComparable(error("validation.no_place_in_both"))
    second = np.full(len(at), np.nan) if to_other_surface is None else to_other_surface[at]
    return CorePointDistances(before.select_cores(at), after.select_cores(at), second)
