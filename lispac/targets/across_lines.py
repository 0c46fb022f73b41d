"""One seed, every line: the same target where each line puts it.

The boresight is not yet known, so the target stands up to a metre and more from the seed in the
other lines, and a few degrees askew. A reference patch is found in one line; for each other line
the translation that lays the reference's surroundings onto that line's predicts where the target
is, and the plane is sought there, with the reference's normal, and compared with it.
"""

import os
from collections.abc import Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from math import degrees

import numpy as np
from numpy.typing import NDArray

from lispac.errors import PlaneNotFound
from lispac.geometry.neighbours import PointGrid, nearest_point, points_within
from lispac.geometry.planes import in_plane_axes
from lispac.progress import Progress, no_progress
from lispac.targets import outline
from lispac.targets.finder import (
    FinderSettings,
    PlanePatch,
    checked_seed,
    extract,
    find_plane,
    neighbourhood,
)
from lispac.targets.shift import Shift, find_shifts

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

# The patch has this share of the say in where the line has moved; its surroundings have the rest.
PATCH_SHARE = 0.5
# Farthest a found plane may pass from where the translation puts it, metres.
OFFSET = 0.3
# Least part of the reference's outline that the patch must cover, and the most it may be larger.
LEAST_COVERED, MOST_LARGER = 0.3, 3.0
# A seed this near to a point of a line, metres, was taken from that line: coordinates are often
# written with three decimals.
CLICK = 0.002
# Translations looked at, and how near in score a different patch makes the answer doubtful.
CANDIDATES, DOUBT = 6, 0.97


@dataclass(frozen=True, eq=False)
class _Reference:
    """What is looked for in the other lines."""

    seed: Array
    patch: PlanePatch
    patch_points: Array
    surroundings: Array
    weights: Array
    cell: float


@dataclass(frozen=True, eq=False)
class _Match:
    patch: PlanePatch
    score: float


def find_in_lines(
    clouds: Mapping[str, Array],
    seed: Array,
    settings: FinderSettings,
    *,
    first_line: str | None = None,
    indices: Mapping[str, PointGrid] | None = None,
    progress: Progress = no_progress,
) -> tuple[dict[str, PlanePatch], dict[str, str]]:
    """Find the target under the seed in every line.

    Parameters
    ----------
    clouds : mapping of line name to ndarray of shape (n, 3), metres, one local frame
    seed : ndarray of shape (3,), metres
    settings : FinderSettings
    first_line : str, optional
        The line that was clicked. Without it, the line with a point at the seed; or else the
        line whose plane passes nearest to the seed; or, when that plane is missing in some lines,
        the one of the nearest three whose plane most lines share.
    indices : mapping of line name to PointGrid, optional
        Prepared cells; lines without are read through.
    progress : Progress

    Returns
    -------
    found : dict of line name to PlanePatch
        Normals all face the same side.
    missing : dict of line name to str
        Why the target was not found in a line, in words.

    Raises
    ------
    PlaneNotFound
        The line clicked has no plane at the seed, or no line has.
    """
    seed = checked_seed(seed)
    grids = indices or {}
    if first_line is not None:
        if first_line not in clouds:
            raise PlaneNotFound(f"There is no line named {first_line}.")
        first = find_plane(clouds[first_line], seed, settings, index=grids.get(first_line))
        return _from_reference(clouds, grids, first_line, first, seed, settings, progress)
    patches: dict[str, PlanePatch] = {}
    reasons: dict[str, str] = {}

    def look(name: str) -> PlanePatch | str:
        try:
            return find_plane(clouds[name], seed, settings, index=grids.get(name))
        except PlaneNotFound as reason:
            return str(reason)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for name, answer in zip(clouds, pool.map(look, clouds), strict=True):
            if isinstance(answer, PlanePatch):
                patches[name] = answer
            else:
                reasons[name] = answer
    if not patches:
        # One sentence, of the line that comes nearest: a list of all of them helps nobody.
        nearest_line = min(clouds, key=lambda name: nearest_point(clouds[name], seed)[1])
        raise PlaneNotFound(
            f"No line has a plane at the seed ({nearest_line}: {reasons[nearest_line]}) "
            "Set the seed on the target, or enlarge the radius."
        )
    clicked = _clicked_line(clouds, grids, seed)
    if clicked in patches:
        nearest = [clicked]
    else:
        nearest = sorted(patches, key=lambda name: _distance_to_seed(patches[name], seed))
    best: tuple[dict[str, PlanePatch], dict[str, str]] | None = None
    for name in nearest[:3]:
        both = _from_reference(clouds, grids, name, patches[name], seed, settings, progress)
        if best is None or len(both[0]) > len(best[0]):
            best = both
        if not both[1]:
            break
    assert best is not None
    return best


def _clicked_line(
    clouds: Mapping[str, Array], grids: Mapping[str, PointGrid], seed: Array
) -> str | None:
    """The line with the point nearest to the seed, where that is as near as a click."""
    nearest: tuple[float, str] | None = None
    for name, cloud in clouds.items():
        at_seed = _near(cloud, grids.get(name), seed, CLICK)
        if len(at_seed):
            off = float(np.linalg.norm(cloud[at_seed] - seed, axis=1).min())
            nearest = min(nearest, (off, name)) if nearest else (off, name)
    return nearest[1] if nearest else None


def _distance_to_seed(patch: PlanePatch, seed: Array) -> float:
    beside = (seed - patch.centre) @ in_plane_axes(patch.plane.normal).T
    outside = np.maximum(np.abs(beside) - 0.5 * patch.extent, 0.0)
    return float(np.hypot(patch.plane.distances(seed), np.linalg.norm(outside)))


def _from_reference(
    clouds: Mapping[str, Array],
    grids: Mapping[str, PointGrid],
    first_line: str,
    first: PlanePatch,
    seed: Array,
    settings: FinderSettings,
    progress: Progress,
) -> tuple[dict[str, PlanePatch], dict[str, str]]:
    reference = _reference(clouds[first_line], grids.get(first_line), first, seed, settings)
    found: dict[str, PlanePatch] = {}
    missing: dict[str, str] = {}

    def look(name: str) -> PlanePatch | str:
        if name == first_line:
            return first
        try:
            return _find_in(clouds[name], grids.get(name), reference, settings)
        except PlaneNotFound as reason:
            return str(reason)

    pool = ThreadPoolExecutor(min(os.cpu_count() or 1, len(clouds)))
    try:
        answers = pool.map(look, clouds)
        for done, (name, answer) in enumerate(zip(clouds, answers, strict=True), start=1):
            if isinstance(answer, PlanePatch):
                found[name] = answer
            else:
                missing[name] = answer
            progress(done / len(clouds), f"Looked for the target in {name}")
    finally:  # cancelled from inside progress: what has not begun need not begin
        pool.shutdown(cancel_futures=True)
    return found, missing


def _reference(
    cloud: Array, grid: PointGrid | None, patch: PlanePatch, seed: Array, settings: FinderSettings
) -> _Reference:
    around = _near(cloud, grid, seed, settings.radius)
    on_patch = np.isin(around, patch.indices, assume_unique=True)
    # Near the patch the surroundings have moved as it has; farther off a little differently.
    distance = np.linalg.norm(cloud[around] - patch.centre, axis=1)
    weights = 1.0 / (1.0 + (distance / (0.5 * settings.radius)) ** 2)
    beside = ~on_patch
    if beside.any() and on_patch.any():
        # Shares by voxel, as the comparison counts them, or a dense patch would have all the say.
        ratio = _filled(cloud[around[on_patch]]) / max(1, _filled(cloud[around[beside]]))
        weights[beside] *= ratio * (1.0 - PATCH_SHARE) / PATCH_SHARE / weights[beside].mean()
        weights[on_patch] = 1.0
    patch_points = cloud[patch.indices]
    placed = patch_points @ in_plane_axes(patch.plane.normal).T
    return _Reference(
        seed=seed,
        patch=patch,
        patch_points=patch_points,
        surroundings=cloud[around],
        weights=weights,
        cell=outline.cell_size(placed, np.ones(len(placed))),
    )


def _filled(points: Array) -> int:
    return len(np.unique(np.floor(points / 0.1).astype(np.int64), axis=0))


def _near(cloud: Array, grid: PointGrid | None, centre: Array, radius: float) -> Indices:
    return points_within(cloud, centre, radius) if grid is None else grid.within(centre, radius)


def _find_in(
    cloud: Array, grid: PointGrid | None, reference: _Reference, settings: FinderSettings
) -> PlanePatch:
    reach = settings.radius + settings.max_shift
    around = cloud[_near(cloud, grid, reference.seed, reach)]
    if len(around) < settings.min_points:
        raise PlaneNotFound(
            f"The line has only {len(around)} points within {reach:g} m of the seed."
            if len(around)
            else f"The line has no points within {reach:g} m of the seed."
        )
    shifts = find_shifts(reference.surroundings, reference.weights, around, settings.max_shift)
    if not shifts:
        raise PlaneNotFound("Nothing in this line resembles the target and its surroundings.")
    matches: list[_Match] = []
    refused: list[str] = []
    for shift in shifts[:CANDIDATES]:
        if matches and shift.score < DOUBT * max(match.score for match in matches):
            break  # a match never scores above its translation: no better one can follow
        try:
            matches.append(_match(cloud, grid, reference, shift, settings))
        except PlaneNotFound as reason:
            refused.append(str(reason))
    if not matches:
        raise PlaneNotFound(refused[0])
    matches.sort(key=lambda match: -match.score)
    best = matches[0]
    for other in matches[1:]:
        shared = np.isin(other.patch.indices, best.patch.indices, assume_unique=True).mean()
        # Two parts of one wide surface are no contradiction: either gives the same plane.
        off = abs(float(best.patch.plane.distances(other.patch.centre)))
        if shared < 0.2 and off > settings.threshold and other.score > DOUBT * best.score:
            apart = float(np.linalg.norm(other.patch.centre - best.patch.centre))
            raise PlaneNotFound(
                f"Two planes {apart:.2f} m apart resemble the target equally; "
                "set a seed of its own for this line."
            )
    return best.patch


def _match(
    cloud: Array,
    grid: PointGrid | None,
    reference: _Reference,
    shift: Shift,
    settings: FinderSettings,
) -> _Match:
    """The plane where the translation predicts it, and how well it matches the reference."""
    moved = reference.patch_points + shift.vector
    near = neighbourhood(cloud, reference.seed + shift.vector, settings, index=grid)
    points = cloud[near]
    normal = reference.patch.plane.normal
    axes = in_plane_axes(normal)
    offset = (points - reference.patch.centre - shift.vector) @ normal
    inside = outline.covered(points @ axes.T, moved @ axes.T, reference.cell)
    votes = np.where(inside & (np.abs(offset) <= OFFSET), 1.0 / (1.0 + (offset / 0.1) ** 2), 1e-6)
    if np.count_nonzero(inside & (np.abs(offset) <= OFFSET)) < settings.min_points:
        raise PlaneNotFound("The line has too few points where the target should be.")
    where = "the place where the target should be"
    patch = extract(points, near, votes, settings, where, expected_normal=normal)
    placed = cloud[patch.indices] @ axes.T
    cell = max(reference.cell, outline.cell_size(placed, np.ones(len(placed))))
    coverage = float(outline.covered(moved @ axes.T, placed, cell).mean())
    larger = outline.area(placed, cell) / outline.area(moved @ axes.T, cell)
    tilt = degrees(patch.plane.tilt_to(reference.patch.plane))
    if coverage < LEAST_COVERED:
        raise PlaneNotFound(
            f"The plane found covers only {100.0 * coverage:.0f} % of the target's outline."
        )
    if larger > MOST_LARGER:
        raise PlaneNotFound(f"The plane found is {larger:.1f} times as large as the target.")
    likeness = coverage * min(1.0, 1.5 / larger) * np.cos(np.radians(2.0 * tilt))
    return _Match(patch, shift.score * float(likeness))
