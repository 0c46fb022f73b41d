"""Search for one plane in every line from one seed.

In the other lines the target stands up to a metre and more from the seed, and a few degrees askew.
Where the surroundings predict it, a plane with the reference's normal is searched for, and
compared with it by outline and tilt.
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
    MAX_CANDIDATES,
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

# Farthest a found plane may pass from where the translation puts it, metres.
OFFSET = 0.3
# A patch that reaches farther than this share of the radius goes on beyond it. Beside a seed that
# was not clicked it counts as so much farther off, metres: the wrong boresight lays the wall behind
# a target on the seed in one line and the target beside it in the next, and the target is meant.
UNCUT_SHARE, BACKDROP = 0.97, 1.0
# Flat patches larger than this, square metres, speak with less than their area.
LARGE = 0.25
# A patch cut out of a surface that crosses the plane goes on beyond the threshold: twice as many
# points lie between one and three thresholds from the plane as on it. The limit is for how much
# this ratio exceeds that of the reference, which the wrong boresight may smear as well.
BEYOND, CROSSING = 3.0, 0.8
# Least part of the reference's outline that the patch must cover, and the most it may be larger.
MIN_COVERED, MAX_AREA_RATIO = 0.3, 3.0


@dataclass(frozen=True, eq=False)
class _ReferenceSurface:
    """Reference surface that is searched for in the other lines."""

    seed: Array
    patch: PlanePatch
    patch_points: Array
    around: WeightedSurroundings
    cell: float
    beyond: float


def find_in_lines(
    clouds: Mapping[str, Array],
    seed: Array,
    settings: FinderSettings,
    *,
    first_line: str | None = None,
    indices: Mapping[str, PointGrid] | None = None,
    beside: Mapping[str, Array] | None = None,
    progress: Progress = no_progress,
) -> tuple[dict[str, PlanePatch], dict[str, Message]]:
    """Find the target under the seed in every line.

    Parameters
    ----------
    clouds : mapping of line name to ndarray of shape (n, 3), metres, one local frame
    seed : ndarray of shape (3,), metres, local frame
    settings : FinderSettings
    first_line : str, optional
        The line that was clicked. Without it, the line with a point at the seed; or else the
        line whose plane passes nearest to the seed, one that ends within the radius first; or,
        when that plane is missing in some lines, the one of the nearest three whose plane most
        lines share.
    indices : mapping of line name to PointGrid, optional
        Prepared cells; lines without are read through.
    beside : mapping of line name to ndarray of shape (m, 3), metres, optional
        Of lines that are sampled, all points close to the seed, as `find_plane` takes them.
    progress : Progress

    Returns
    -------
    found : dict of line name to PlanePatch
        Normals all face the same side.
    missing : dict of line name to Message
        Reason why the target was not found in a line.

    Raises
    ------
    PlaneNotFound
        The line clicked has no plane at the seed, or no line has.
    """
    seed = require_seed(seed)
    grids, close = indices or {}, beside or {}

    def follow(first_line: str, first: PlanePatch) -> Callable[[str], PlanePatch]:
        grid = grids.get(first_line)
        reference = _describe_reference(clouds[first_line], grid, first, seed, settings)
        return lambda name: _find_in_line(clouds[name], grids.get(name), reference, settings)

    shape = ShapeSearch(
        no_line="finder.no_line_for_plane",
        in_no_line="finder.no_plane_in_lines",
        error=PlaneNotFound,
        find=lambda name: find_plane(
            clouds[name], seed, settings, index=grids.get(name), beside=close.get(name)
        ),
        distance=lambda name, patch: _distance_to_seed(clouds[name], patch, seed, settings.radius),
        follow=follow,
    )
    return search_target_in_lines(clouds, grids, seed, shape, first_line, progress)


def _distance_to_seed(cloud: Array, patch: PlanePatch, seed: Array, radius: float) -> float:
    beside = (seed - patch.centre) @ plane_axes(patch.plane.normal).T
    outside = np.maximum(np.abs(beside) - 0.5 * patch.extent, 0.0)
    farthest = float(np.linalg.norm(cloud[patch.indices] - seed, axis=1).max())
    extends = farthest > UNCUT_SHARE * radius
    return (
        float(np.hypot(patch.plane.distances(seed), np.linalg.norm(outside))) + BACKDROP * extends
    )


def _describe_reference(
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
        around=surroundings_of_patch(cloud, grid, patch.indices, patch.centre, seed, settings),
        cell=cell,
        beyond=_ratio_beyond_threshold(about, patch.plane, placed, cell, settings),
    )


def _find_in_line(
    cloud: Array, grid: PointGrid | None, reference: _ReferenceSurface, settings: FinderSettings
) -> PlanePatch:
    def same(best: PlanePatch, other: PlanePatch) -> bool:
        return bool(np.isin(other.indices, best.indices, assume_unique=True).mean() >= 0.2)

    def contradiction(best: PlanePatch, other: PlanePatch) -> Message | None:
        # Two parts of one wide surface are no contradiction: either gives the same plane.
        off = abs(float(best.plane.distances(other.centre)))
        if same(best, other) or off <= settings.threshold:
            return None
        distance = float(np.linalg.norm(other.centre - best.centre))
        return error("finder.two_planes", distance=distance)

    shifts = find_shifts_into_line(cloud, grid, reference.around, reference.seed, settings)
    return best_match(
        shifts,
        lambda shift: _match_at_shift(cloud, grid, reference, shift, settings),
        contradiction,
        lambda: _shifts_onto_patches(cloud, grid, reference, settings),
        lambda rivals: _scores_without_wide_surfaces(cloud, grid, reference, rivals, settings),
        same,
    )


def _scores_without_wide_surfaces(
    cloud: Array,
    grid: PointGrid | None,
    reference: _ReferenceSurface,
    rivals: list[CloudShift],
    settings: FinderSettings,
) -> list[float]:
    """Scores of translations without wide surfaces, which hide all other points.

    Along a wall the wall itself shows nothing: its many points would outvote the window or the
    second board that do. A flat patch weighs by its side here instead of its area.
    """
    around_reference = reference.around
    flat = find_flat_patches(around_reference.points, settings.threshold)
    areas = np.array([patch.area for patch in flat.patches])
    weights = 1.0 / np.sqrt(np.maximum(np.append(areas, 0.0), LARGE))[flat.label]
    around = cloud[indices_near(cloud, grid, reference.seed, settings.radius + settings.max_shift)]
    vectors = np.array([shift.vector for shift in rivals])
    return [shift.score for shift in rate_shifts(flat.thinned, weights, around, vectors)]


def _shifts_onto_patches(
    cloud: Array, grid: PointGrid | None, reference: _ReferenceSurface, settings: FinderSettings
) -> list[CloudShift]:
    """Translations that lay the target onto flat patches of its size and tilt.

    Along a bare wall the surroundings leave open where on it the target is.
    """
    reach = settings.radius + settings.max_shift
    around = cloud[indices_near(cloud, grid, reference.seed, reach)]
    patch = reference.patch
    placed = reference.patch_points @ plane_axes(patch.plane.normal).T
    area = outline.filled_area(placed, reference.cell)
    vectors = [
        other.centre - patch.centre
        for other in find_flat_patches(around, settings.threshold).patches
        if MIN_COVERED * area <= other.area <= MAX_AREA_RATIO * area
        and other.plane.tilt_to(patch.plane) <= settings.max_tilt
    ]
    vectors = [v for v in vectors if np.linalg.norm(v) <= settings.max_shift]
    around_reference = reference.around
    shifts = rate_shifts(
        around_reference.points, around_reference.weights, around, np.reshape(vectors, (-1, 3))
    )
    return sorted(shifts, key=lambda shift: -shift.score)[:MAX_CANDIDATES]


def _match_at_shift(
    cloud: Array,
    grid: PointGrid | None,
    reference: _ReferenceSurface,
    shift: CloudShift,
    settings: FinderSettings,
) -> tuple[PlanePatch, float]:
    """The plane where the translation predicts it, and how well it matches the reference.

    Raises
    ------
    PlaneNotFound
        Where too little of the target is there, or far more than it.
    """
    moved = reference.patch_points + shift.vector
    seed = reference.seed + shift.vector
    there = neighbourhood_of(cloud, seed, settings, index=grid)
    points = cloud[there]
    normal = reference.patch.plane.normal
    axes = plane_axes(normal)
    offset = (points - reference.patch.centre - shift.vector) @ normal
    inside = outline.is_covered(points @ axes.T, moved @ axes.T, reference.cell)
    votes = np.where(inside & (np.abs(offset) <= OFFSET), 1.0 / (1.0 + (offset / 0.1) ** 2), 1e-6)
    if np.count_nonzero(inside & (np.abs(offset) <= OFFSET)) < settings.min_points:
        raise PlaneNotFound(error("finder.too_few_where_expected"))
    patch = extract_patch(points, there, votes, settings, seed, expected_normal=normal)
    placed = cloud[patch.indices] @ axes.T
    cell = max(reference.cell, outline.outline_cell_size(placed, np.ones(len(placed))))
    coverage = float(outline.is_covered(moved @ axes.T, placed, cell).mean())
    larger = outline.filled_area(placed, cell) / outline.filled_area(moved @ axes.T, cell)
    tilt = degrees(patch.plane.tilt_to(reference.patch.plane))
    if coverage < MIN_COVERED:
        raise PlaneNotFound(error("finder.small_part", share=coverage))
    if larger > MAX_AREA_RATIO:
        raise PlaneNotFound(error("finder.too_large", ratio=larger))
    own = cloud[patch.indices] @ plane_axes(patch.plane.normal).T
    beyond = _ratio_beyond_threshold(points, patch.plane, own, cell, settings)
    if beyond - reference.beyond > CROSSING:
        raise PlaneNotFound(error("finder.crossing"))
    likeness = coverage * min(1.0, 1.5 / larger) * np.cos(np.radians(2.0 * tilt))
    return patch, shift.score * float(likeness)


def _ratio_beyond_threshold(
    points: Array, plane: Plane, placed: Array, cell: float, settings: FinderSettings
) -> float:
    """Points beyond the threshold over those on a plane, within its outline.

    Parameters
    ----------
    points : ndarray of shape (n, 3), metres, local frame
        Of the neighbourhood.
    placed : ndarray of shape (m, 2), metres
        The patch in its plane.
    cell : float, metres
        Of the outline.
    """
    off = np.abs(plane.distances(points))
    there = points[(off > settings.threshold) & (off <= BEYOND * settings.threshold)]
    if not len(there):
        return 0.0
    axes = plane_axes(plane.normal)
    return float(np.count_nonzero(outline.is_covered(there @ axes.T, placed, cell)) / len(placed))
