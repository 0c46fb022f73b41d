"""Search for one plane in every line, starting from one seed.

In the other lines the target may be displaced by a metre or more and tilted by a few degrees. Its
surroundings predict its position. There, a plane with a normal similar to the reference is searched
for and compared with the reference by outline and tilt.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import degrees

import numpy as np
from numpy.typing import NDArray

from lispac.errors import PlaneNotFound
from lispac.geometry.planes import Plane, plane_axes
from lispac.geometry.radius_search import PointGrid
from lispac.messages import Message, error
from lispac.progress import Progress, no_progress
from lispac.targets import outline
from lispac.targets.cloud_shift import CloudShift, rate_shifts
from lispac.targets.flat_patches import find_flat_patches
from lispac.targets.line_search import (
    MAX_TESTED_SHIFTS,
    ShapeSearch,
    WeightedSurroundings,
    best_match,
    find_shifts_into_line,
    indices_near,
    search_target_in_lines,
    surroundings_of_patch,
)
from lispac.targets.plane_finder import (
    FinderSettings,
    PlanePatch,
    extract_patch,
    find_plane,
    neighbourhood_of,
    require_seed,
)

Array = NDArray[np.float64]

# Largest distance from the predicted plane of a point that votes for the plane, metres.
MAX_PREDICTION_OFFSET = 0.3
# A patch that extends beyond this share of the search radius is cut by it. If the seed was not
# clicked in a line, the distance of such a patch is increased by the second number, metres: with a
# wrong boresight, the wall behind a target may lie at the seed in one line and the target beside
# the seed in another one; the target is preferred.
UNCUT_RADIUS_SHARE, CUT_PLANE_PENALTY = 0.97, 1.0
# Flat patches larger than this, square metres, have a weight smaller than their area.
MAX_FULL_WEIGHT_AREA = 0.25
# A patch of a surface that crosses the plane continues beyond the threshold: twice as many points
# lie between one and three thresholds from the plane as on it. The second number is the largest
# excess of this ratio over that of the reference, which may be smeared by the boresight as well.
CROSSING_BAND, MAX_CROSSING_EXCESS = 3.0, 0.8
# Smallest share of the reference's outline that a patch has to cover, and largest ratio of areas.
MIN_COVERED_SHARE, MAX_AREA_RATIO = 0.3, 3.0


@dataclass(frozen=True, eq=False)
class _ReferenceSurface:
    """Surface found in the reference line, which is searched for in the other lines.

    ``cell`` is the cell size of its outline, metres, and ``ratio_beyond`` the result of
    `_ratio_beyond_threshold`.
    """

    seed: Array
    patch: PlanePatch
    patch_points: Array
    surroundings: WeightedSurroundings
    cell: float
    ratio_beyond: float


def find_in_lines(
    clouds: Mapping[str, Array],
    seed: Array,
    settings: FinderSettings,
    *,
    first_line: str | None = None,
    indices: Mapping[str, PointGrid] | None = None,
    points_at_seed: Mapping[str, Array] | None = None,
    progress: Progress = no_progress,
) -> tuple[dict[str, PlanePatch], dict[str, Message]]:
    """Find the plane at the seed in every line.

    Parameters
    ----------
    clouds : mapping of line name to ndarray of shape (n, 3), metres, one local frame
    seed : ndarray of shape (3,), metres, local frame
    settings : FinderSettings
    first_line : str, optional
        The clicked line, used as the reference. If omitted, the line with a point at the seed;
        otherwise the line whose plane passes nearest to the seed, where planes that end within the
        radius come first. If this plane is missing in some lines, the reference is the one of the
        nearest three whose plane is found in most lines.
    indices : mapping of line name to PointGrid, optional
        Prepared cells; lines without them are read completely.
    points_at_seed : mapping of line name to ndarray of shape (m, 3), metres, local frame, optional
        For lines that are sampled, all points close to the seed; see `find_plane`.
    progress : Progress

    Returns
    -------
    found : dict of line name to PlanePatch
        All normals are on the same side.
    missing : dict of line name to Message
        Reason why the target was not found in a line.

    Raises
    ------
    PlaneNotFound
        The clicked line has no plane at the seed, or no line has.
    """
    seed = require_seed(seed)
    grids, close = indices or {}, points_at_seed or {}

    def follow(first_line: str, first: PlanePatch) -> Callable[[str], PlanePatch]:
        grid = grids.get(first_line)
        reference = _reference_surface(clouds[first_line], grid, first, seed, settings)
        return lambda name: _find_in_line(clouds[name], grids.get(name), reference, settings)

    shape = ShapeSearch(
        no_line="finder.no_line_for_plane",
        in_no_line="finder.no_plane_in_lines",
        error=PlaneNotFound,
        find=lambda name: find_plane(
            clouds[name], seed, settings, index=grids.get(name), points_at_seed=close.get(name)
        ),
        distance=lambda name, patch: _distance_to_seed(clouds[name], patch, seed, settings.radius),
        follow=follow,
        is_cut=lambda name, patch: _is_cut(clouds[name], patch, seed, settings.radius),
    )
    return search_target_in_lines(clouds, grids, seed, shape, first_line, progress)


def _is_cut(cloud: Array, patch: PlanePatch, seed: Array, radius: float) -> bool:
    farthest = float(np.linalg.norm(cloud[patch.indices] - seed, axis=1).max())
    return farthest > UNCUT_RADIUS_SHARE * radius


def _distance_to_seed(cloud: Array, patch: PlanePatch, seed: Array, radius: float) -> float:
    beside = (seed - patch.centre) @ plane_axes(patch.plane.normal).T
    outside = np.maximum(np.abs(beside) - 0.5 * patch.extent, 0.0)
    return float(
        np.hypot(patch.plane.distances(seed), np.linalg.norm(outside))
    ) + CUT_PLANE_PENALTY * _is_cut(cloud, patch, seed, radius)


def _reference_surface(
    cloud: Array, grid: PointGrid | None, patch: PlanePatch, seed: Array, settings: FinderSettings
) -> _ReferenceSurface:
    patch_points = cloud[patch.indices]
    placed = patch_points @ plane_axes(patch.plane.normal).T
    cell = outline.outline_cell_size(placed, np.ones(len(placed)))
    about = cloud[indices_near(cloud, grid, seed, settings.radius)]
    return _ReferenceSurface(
        seed=seed,
        patch=patch,
        patch_points=patch_points,
        surroundings=surroundings_of_patch(
            cloud, grid, patch.indices, patch.centre, seed, settings
        ),
        cell=cell,
        ratio_beyond=_ratio_beyond_threshold(about, patch.plane, placed, cell, settings),
    )


def _find_in_line(
    cloud: Array, grid: PointGrid | None, reference: _ReferenceSurface, settings: FinderSettings
) -> PlanePatch:
    def is_same(best: PlanePatch, other: PlanePatch) -> bool:
        return bool(np.isin(other.indices, best.indices, assume_unique=True).mean() >= 0.2)

    def contradiction(best: PlanePatch, other: PlanePatch) -> Message | None:
        # Two parts of one large surface are no contradiction: both give the same plane.
        off = abs(float(best.plane.distances(other.centre)))
        if is_same(best, other) or off <= settings.threshold:
            return None
        distance = float(np.linalg.norm(other.centre - best.centre))
        return error("finder.two_planes", distance=distance)

    shifts = find_shifts_into_line(cloud, grid, reference.surroundings, reference.seed, settings)
    return best_match(
        shifts,
        lambda shift: _match_at_shift(cloud, grid, reference, shift, settings),
        contradiction,
        lambda: _shifts_onto_patches(cloud, grid, reference, settings),
        lambda rivals: _scores_without_wide_surfaces(cloud, grid, reference, rivals, settings),
        is_same,
    )


def _scores_without_wide_surfaces(
    cloud: Array,
    grid: PointGrid | None,
    reference: _ReferenceSurface,
    rivals: list[CloudShift],
    settings: FinderSettings,
) -> list[float]:
    """Scores of translations with reduced weight of large surfaces.

    A shift along a wall cannot be detected on the wall itself, only on details such as a window or
    a second board. The many points of the wall would dominate the score. The weight of a flat patch
    is therefore proportional to its side instead of its area.
    """
    around_reference = reference.surroundings
    flat = find_flat_patches(around_reference.points, settings.threshold)
    areas = np.array([patch.area for patch in flat.patches])
    weights = 1.0 / np.sqrt(np.maximum(np.append(areas, 0.0), MAX_FULL_WEIGHT_AREA))[flat.label]
    around = cloud[indices_near(cloud, grid, reference.seed, settings.radius + settings.max_shift)]
    vectors = np.array([shift.vector for shift in rivals])
    return [shift.score for shift in rate_shifts(flat.thinned, weights, around, vectors)]


def _shifts_onto_patches(
    cloud: Array, grid: PointGrid | None, reference: _ReferenceSurface, settings: FinderSettings
) -> list[CloudShift]:
    """Translations of the target onto flat patches of similar size and tilt.

    They are needed along a bare wall, where the surroundings do not determine the shift along it.
    """
    reach = settings.radius + settings.max_shift
    around = cloud[indices_near(cloud, grid, reference.seed, reach)]
    patch = reference.patch
    placed = reference.patch_points @ plane_axes(patch.plane.normal).T
    area = outline.filled_area(placed, reference.cell)
    vectors = [
        other.centre - patch.centre
        for other in find_flat_patches(around, settings.threshold).patches
        if MIN_COVERED_SHARE * area <= other.area <= MAX_AREA_RATIO * area
        and other.plane.tilt_to(patch.plane) <= settings.max_tilt
    ]
    vectors = [v for v in vectors if np.linalg.norm(v) <= settings.max_shift]
    around_reference = reference.surroundings
    shifts = rate_shifts(
        around_reference.points, around_reference.weights, around, np.reshape(vectors, (-1, 3))
    )
    return sorted(shifts, key=lambda shift: -shift.score)[:MAX_TESTED_SHIFTS]


def _match_at_shift(
    cloud: Array,
    grid: PointGrid | None,
    reference: _ReferenceSurface,
    shift: CloudShift,
    settings: FinderSettings,
) -> tuple[PlanePatch, float]:
    """Plane at the predicted position, and a score of its agreement with the reference.

    Raises
    ------
    PlaneNotFound
        If the patch covers too little of the reference, or is far larger.
    """
    moved = reference.patch_points + shift.vector
    seed = reference.seed + shift.vector
    there = neighbourhood_of(cloud, seed, settings, index=grid)
    points = cloud[there]
    normal = reference.patch.plane.normal
    axes = plane_axes(normal)
    offset = (points - reference.patch.centre - shift.vector) @ normal
    inside = outline.is_covered(points @ axes.T, moved @ axes.T, reference.cell)
    votes = np.where(
        inside & (np.abs(offset) <= MAX_PREDICTION_OFFSET), 1.0 / (1.0 + (offset / 0.1) ** 2), 1e-6
    )
    if np.count_nonzero(inside & (np.abs(offset) <= MAX_PREDICTION_OFFSET)) < settings.min_points:
        raise PlaneNotFound(error("finder.too_few_where_expected"))
    patch = extract_patch(points, there, votes, settings, seed, expected_normal=normal)
    placed = cloud[patch.indices] @ axes.T
    cell = max(reference.cell, outline.outline_cell_size(placed, np.ones(len(placed))))
    coverage = float(outline.is_covered(moved @ axes.T, placed, cell).mean())
    larger = outline.filled_area(placed, cell) / outline.filled_area(moved @ axes.T, cell)
    tilt = degrees(patch.plane.tilt_to(reference.patch.plane))
    if coverage < MIN_COVERED_SHARE:
        raise PlaneNotFound(error("finder.small_part", share=coverage))
    if larger > MAX_AREA_RATIO:
        raise PlaneNotFound(error("finder.too_large", ratio=larger))
    own = cloud[patch.indices] @ plane_axes(patch.plane.normal).T
    beyond = _ratio_beyond_threshold(points, patch.plane, own, cell, settings)
    if beyond - reference.ratio_beyond > MAX_CROSSING_EXCESS:
        raise PlaneNotFound(error("finder.crossing"))
    likeness = coverage * min(1.0, 1.5 / larger) * np.cos(np.radians(2.0 * tilt))
    return patch, shift.score * float(likeness)


def _ratio_beyond_threshold(
    points: Array, plane: Plane, placed: Array, cell: float, settings: FinderSettings
) -> float:
    """Ratio of the points beyond the threshold to those on the plane, within its outline.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
        Points of the neighbourhood.
    placed : ndarray of shape (m, 2), metres
        Points of the patch in its plane.
    cell : float, metres
        Cell size of the outline.
    """
    off = np.abs(plane.distances(points))
    there = points[(off > settings.threshold) & (off <= CROSSING_BAND * settings.threshold)]
    if not len(there):
        return 0.0
    axes = plane_axes(plane.normal)
    return float(np.count_nonzero(outline.is_covered(there @ axes.T, placed, cell)) / len(placed))
